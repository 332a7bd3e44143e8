"""Results of a run: steps with their verdicts and traffic, and the totals."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import islice
from typing import Final

from jauspy.conformance.trace import Direction, TraceEntry
from jauspy.errors import JausError


class Verdict(StrEnum):
    """Outcome of one step."""

    PASS = "pass"  # noqa: S105 # nosec B105 # a verdict
    FAIL = "fail"
    """A wrong answer, or an answer where none is allowed."""
    SILENT = "silent"
    """No answer at all."""
    LATE = "late"
    """The right answer after the deadline."""
    MALFORMED = "malformed"
    """The right message id with bytes that its definition does not allow."""
    SKIPPED = "skipped"
    """Skipped step, for the given reason."""


MAX_CAME: Final = 3
"""Messages that a failed step names; its traffic has all."""
DEPENDS_ON_TARGET: Final = (
    "it depends on internal state of the target: another transition was taken, or it is not known which"
)
"""Reason why a transition was not seen although its input was sent."""


@dataclass(frozen=True, slots=True)
class CheckResult:
    """One check of a step. `problem` is empty if it holds."""

    name: str
    problem: str = ""


@dataclass(frozen=True, slots=True)
class TransitionResult:
    """A transition of a state machine of the target: the first step in which it was taken, or why none was."""

    name: str
    step: str = ""
    reason: str = ""


@dataclass(frozen=True, slots=True)
class Result:
    """One step of a run. Times are seconds since the run began."""

    id: str
    title: str
    verdict: Verdict
    reason: str = ""
    why: str = ""
    """Service, message and state from which the expectation follows."""
    expected: tuple[str, ...] = ()
    checks: tuple[CheckResult, ...] = ()
    entries: tuple[TraceEntry, ...] = ()
    omitted: int = 0
    """Number of further datagrams, which are not kept."""
    began: float = 0.0
    ended: float = 0.0
    points: float = 0.0
    """Points for passing the step."""
    transitions: tuple[str, ...] = ()
    """Transitions of state machines that may be taken in this step."""
    taken: tuple[str, ...] = ()
    """Transitions that were taken, or had to be, and were checked."""
    known: str = ""
    """The known deviation of the target's implementation that explains the failure, as in `known of JTS: ...`."""

    @property
    def earned(self) -> float:
        """The points of a step that passed."""
        return self.points if self.verdict is Verdict.PASS else 0.0

    @property
    def failed_checks(self) -> tuple[CheckResult, ...]:
        """The checks that do not hold."""
        return tuple(check for check in self.checks if check.problem)

    @property
    def came(self) -> tuple[str, ...]:
        """The last messages that came in a step that did not pass, decoded, the last one first."""
        if self.verdict in (Verdict.PASS, Verdict.SKIPPED):
            return ()
        received = (entry for entry in reversed(self.entries) if entry.direction is Direction.RECEIVED)
        return tuple(islice((line for message in received for line in message.lines), MAX_CAME)) or ("nothing",)

    @property
    def rest(self) -> str:
        """A sentence on omitted datagrams of this step; empty if none is omitted."""
        return f"{self.omitted} datagrams of this step were too many to keep" if self.omitted else ""

    @property
    def elapsed(self) -> float:
        """Seconds."""
        return self.ended - self.began


@dataclass(frozen=True, slots=True)
class Report:
    """A whole run. `began` is in seconds since 1970; `problem` is the reason if the run ended early."""

    profile: str
    title: str
    target: str
    began: float
    seconds: float = 0.0
    results: tuple[Result, ...] = ()
    entries: tuple[TraceEntry, ...] = ()
    """All kept datagrams, including those between steps."""
    problem: str = ""
    notes: tuple[str, ...] = field(default=())

    @property
    def counts(self) -> Counter[Verdict]:
        """Steps by verdict."""
        return Counter(result.verdict for result in self.results)

    @property
    def points(self) -> tuple[float, float]:
        """Points earned, and points of all steps."""
        return sum(result.earned for result in self.results), sum(result.points for result in self.results)

    @property
    def transitions(self) -> tuple[TransitionResult, ...]:
        """All transitions of state machines that the steps may take."""
        found: dict[str, TransitionResult] = {}
        for result in self.results:
            for name in result.taken:
                if name not in found or not found[name].step:
                    found[name] = TransitionResult(name, result.id)
            tried = result.verdict is not Verdict.SKIPPED
            reason = DEPENDS_ON_TARGET if result.verdict is Verdict.PASS else result.reason
            for name in result.transitions:
                if name not in found or (tried and not found[name].step):
                    found[name] = TransitionResult(name, reason=reason)
        return tuple(found.values())

    @property
    def failures(self) -> tuple[Result, ...]:
        """The steps that neither passed nor were skipped."""
        return tuple(result for result in self.results if result.verdict not in (Verdict.PASS, Verdict.SKIPPED))

    @property
    def status(self) -> int:
        """Exit status: 0 all passed, 1 some failed, 2 the run was not possible or no step was run."""
        if self.problem:
            return 2
        if self.failures:
            return 1
        return 0 if self.counts[Verdict.PASS] else 2


def transitions_summary(report: Report) -> str:
    """Such as `218 of 230 transitions were taken and judged`; empty for a profile without state machines."""
    found = report.transitions
    taken = sum(1 for transition in found if transition.step)
    return f"{taken} of {len(found)} state machine transitions in these steps were taken and judged" if found else ""


def worst(reports: Iterable[Report]) -> int:
    """The exit status of several runs together; a failure precedes a run that was not possible."""
    statuses = {report.status for report in reports}
    return 1 if 1 in statuses else max(statuses, default=2)


class StepOutcome(JausError):
    """Ends a step with a verdict; the text is the reason."""

    verdict = Verdict.FAIL


class Failed(StepOutcome):
    """A wrong answer, or an answer where none is allowed."""


class Silent(StepOutcome):
    """No answer arrived."""

    verdict = Verdict.SILENT


class Late(StepOutcome):
    """The right answer arrived after the deadline."""

    verdict = Verdict.LATE


class Malformed(StepOutcome):
    """The bytes of an answer do not follow its definition."""

    verdict = Verdict.MALFORMED


class Skipped(StepOutcome):
    """The step cannot be run; the text is the reason."""

    verdict = Verdict.SKIPPED
