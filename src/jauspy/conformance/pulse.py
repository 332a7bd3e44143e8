"""Notices that a target has died in the midst of a run: its silence is no pass then, and nobody waits for it."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from jauspy.conformance.packets import PINGS
from jauspy.conformance.results import Result, Verdict
from jauspy.conformance.tester import Tester
from jauspy.conformance.trace import Direction, Entry

PATIENCE: Final = 3
"""Steps in a row without a sign of life after which no more are tried."""
BYSTANDER: Final = "42.9.9"
"""Who asks; no step has anything to do with it."""


class Pulse:
    """Looks at each result of a run. `lost` is the step since which the target is silent; empty while it lives."""

    def __init__(self, tester: Tester) -> None:
        self._tester = tester
        self._silent = 0
        self.lost = ""

    @property
    def stopped(self) -> bool:
        """True when nothing more needs to be tried."""
        return self._silent >= PATIENCE

    def judged(self, result: Result) -> Result:
        """The result; a step that passed because nothing came is silent when nobody is there to say anything."""
        if self._lives(result):
            self._silent, self.lost = 0, ""
            return result
        self._silent += 1
        self.lost = self.lost or result.id
        if result.verdict is Verdict.PASS or (self.stopped and result.verdict is Verdict.SKIPPED):
            return replace(result, verdict=Verdict.SILENT, reason=f"the target is silent since step {self.lost}")
        return result

    def _lives(self, result: Result) -> bool:
        """The target said something, was not spoken to, had no reason to speak, or answers now."""
        heard = any(self._is_said(entry) for entry in result.entries)
        spoken = any(entry.direction is Direction.SENT for entry in result.entries)
        content = result.verdict is Verdict.PASS and not self.lost
        return heard or not spoken or content or self._answers()

    def _answers(self) -> bool:
        tester = self._tester
        first = len(tester.entries)
        for ping in PINGS:
            tester.client(BYSTANDER).send(ping, to=tester.memory.get("component"))
        return tester.pump(tester.now + tester.timeout, lambda: any(map(self._is_said, tester.entries[first:])))

    def _is_said(self, entry: Entry) -> bool:
        return entry.direction is Direction.RECEIVED and any(
            self._tester.target.matches(packet.source) for packet in entry.packets
        )
