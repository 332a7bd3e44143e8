"""What a run found: steps with their verdicts, what was sent and received, and the sum."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import StrEnum

from jauspy.conformance.trace import Entry


class Verdict(StrEnum):
    """How one step ended."""

    PASS = "pass"  # noqa: S105 - a verdict
    FAIL = "fail"
    """An answer that is not the right one, or one that should not have come."""
    SILENT = "silent"
    """No answer at all."""
    LATE = "late"
    """The right answer after the deadline."""
    MALFORMED = "malformed"
    """The right message id on bytes that its definition does not allow."""
    SKIPPED = "skipped"
    """Not tried; the reason says why."""


@dataclass(frozen=True, slots=True)
class Looked:
    """One thing that a step looked at: what should hold, and what was wrong with it (empty: nothing)."""

    name: str
    problem: str = ""


@dataclass(frozen=True, slots=True)
class Result:
    """One step of a run. Times are seconds since the run began."""

    id: str
    title: str
    verdict: Verdict
    reason: str = ""
    why: str = ""
    """Which service, message and state the expectation comes from."""
    expected: tuple[str, ...] = ()
    looked: tuple[Looked, ...] = ()
    entries: tuple[Entry, ...] = ()
    began: float = 0.0
    ended: float = 0.0
    points: float = 0.0
    """What the step is worth."""

    @property
    def earned(self) -> float:
        """The points of a step that passed."""
        return self.points if self.verdict is Verdict.PASS else 0.0

    @property
    def elapsed(self) -> float:
        """Seconds."""
        return self.ended - self.began


@dataclass(frozen=True, slots=True)
class Report:
    """A whole run. `began` is in seconds since 1970; `problem` says why the run could not go on, if it could not."""

    profile: str
    title: str
    target: str
    began: float
    seconds: float = 0.0
    results: tuple[Result, ...] = ()
    entries: tuple[Entry, ...] = ()
    """Everything that was heard and sent, also between steps."""
    problem: str = ""
    notes: tuple[str, ...] = field(default=())

    @property
    def counts(self) -> Counter[Verdict]:
        """Steps by verdict."""
        return Counter(result.verdict for result in self.results)

    @property
    def points(self) -> tuple[float, float]:
        """Earned, and what all steps are worth."""
        return sum(each.earned for each in self.results), sum(each.points for each in self.results)

    @property
    def failures(self) -> tuple[Result, ...]:
        """The steps that neither passed nor were skipped."""
        return tuple(each for each in self.results if each.verdict not in (Verdict.PASS, Verdict.SKIPPED))

    @property
    def status(self) -> int:
        """For CI: 0 all passed, 1 some failed, 2 could not run. A run in which nothing was tried is no success."""
        if self.problem:
            return 2
        if self.failures:
            return 1
        return 0 if self.counts[Verdict.PASS] else 2


def worst(reports: Iterable[Report]) -> int:
    """The status of several runs together: a failure counts more than a run that was not possible."""
    statuses = {report.status for report in reports}
    return 1 if 1 in statuses else max(statuses, default=2)
