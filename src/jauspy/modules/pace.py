"""Keeps fixed steps in time with a clock: catches up when late, and gives up what is too late."""

from __future__ import annotations

from collections import Counter


class Pace:
    """When the next of many steps of `step` seconds is due.

    A step that starts more than one `step` after its time is counted as `late`. When the delay exceeds `patience`
    seconds, the steps that were missed are left out and counted as `skipped`: time then stands still for a moment,
    instead of rushing.
    """

    def __init__(self, step: float, patience: float, *, start: float) -> None:
        self.step = step
        self.patience = patience
        self.counters: Counter[str] = Counter(steps=0, late=0, skipped=0, abandoned=0)
        self._due = start + step

    def wait(self, now: float) -> float:
        """Seconds until the next step is due; 0 when it is, or should have been."""
        return max(0.0, self._due - now)

    def begin(self, now: float) -> None:
        """A step starts now."""
        delay = now - self._due
        if delay > self.step:
            self.counters["late"] += 1
        if delay > self.patience:
            missed = int(delay / self.step)
            self.counters["skipped"] += missed
            self._due += missed * self.step
        self.counters["steps"] += 1
        self._due += self.step
