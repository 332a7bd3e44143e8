"""Notices that a target has died in the midst of a run: its silence is no pass then, and nobody waits for it."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from jauspy.conformance.packets import PINGS
from jauspy.conformance.results import Result, Verdict
from jauspy.conformance.tester import Tester

PATIENCE: Final = 3
"""Steps in a row without a sign of life after which no more are tried."""
BYSTANDERS: Final = 64
"""Who asks, one after the other: what was asked long ago is not answered to the one who asks now."""


class Pulse:
    """Looks at each result of a run."""

    def __init__(self, tester: Tester) -> None:
        self._tester = tester
        self._asked = 0
        self._silent = 0

    @property
    def stopped(self) -> bool:
        """True when nothing more needs to be tried."""
        return self._silent >= PATIENCE

    @property
    def reason(self) -> str:
        """Why nobody waits for it."""
        return silent_since(self._tester.lost)

    def judged(self, result: Result) -> Result:
        """The result; a step that passed because nothing came is silent when nobody is there to say anything."""
        if self._lives(result):
            self._silent, self._tester.lost = 0, ""
            return result
        self._silent += 1
        self._tester.lost = self._tester.lost or result.id
        if result.verdict is Verdict.PASS or (self.stopped and result.verdict is Verdict.SKIPPED):
            return replace(result, verdict=Verdict.SILENT, reason=self.reason)
        return result

    def _lives(self, result: Result) -> bool:
        """The target was not spoken to, said something, had no reason to speak, or answers now.

        Once it was silent, only an answer to a new question counts: what it says then may be an old answer.
        """
        content = result.verdict is Verdict.PASS or self._tester.heard
        return not self._tester.spoke or (content and not self._tester.lost) or self._answers()

    def _answers(self) -> bool:
        tester = self._tester
        self._asked = self._asked % BYSTANDERS + 1
        asking = tester.client(f"42.9.{self._asked}")
        asking.pending.clear()
        for to in {tester.target, tester.memory.get("component", tester.target)}:
            for ping in PINGS:
                asking.send(ping, to=to)
        return tester.pump(
            tester.now + tester.timeout,
            lambda: any(tester.target.matches(heard.source) for heard in asking.pending),
        )


def silent_since(step: str) -> str:
    """What a report says of a target that died."""
    return f"the target is silent since step {step}"
