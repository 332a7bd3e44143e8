"""Received frames: those that somebody expects are passed on, all others are counted and ignored."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Final

import can

REASONS: Final = ("error_frame", "remote", "extended", "fd", "unknown", "length", "value")
"""Reasons to ignore frames, as in the counters `ignored.length`."""


def deviation(message: can.Message) -> str:
    """One of `REASONS` if a frame is not a data frame of CANopen; else empty."""
    if message.is_error_frame:
        return "error_frame"
    if message.is_remote_frame:
        return "remote"
    if message.is_extended_id:
        return "extended"
    return "fd" if message.is_fd else ""


class FrameInbox:
    """Takes each received frame. Nothing that a frame contains raises, or is kept."""

    def __init__(self) -> None:
        self.counters: Counter[str] = Counter(
            {"taken": 0, "ignored": 0, **{f"ignored.{reason}": 0 for reason in REASONS}}
        )
        self._expected: dict[int, tuple[int, Callable[[bytes], bool]]] = {}

    def expect(self, cob_id: int, length: int, take: Callable[[bytes], bool]) -> None:
        """Pass frames with this identifier and length to `take`, which returns False for values that are not valid."""
        self._expected[cob_id] = length, take

    def receive(self, message: can.Message) -> None:
        """Pass a frame on, or ignore it."""
        reason = deviation(message)
        if not reason:
            expected = self._expected.get(message.arbitration_id)
            if expected is None:
                reason = "unknown"
            elif len(message.data) != expected[0]:
                reason = "length"
            elif expected[1](bytes(message.data)):
                self.counters["taken"] += 1
                return
            else:
                reason = "value"
        self.counters["ignored"] += 1
        self.counters[f"ignored.{reason}"] += 1
