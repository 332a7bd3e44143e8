"""A campaign against a target: its plan, and the loop over cases, states and restarts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import Final

from jauspy.cluster import spread
from jauspy.fuzz.target.address import Address, free_port
from jauspy.fuzz.target.cases import EPISODE, Cases
from jauspy.fuzz.target.findings import TargetFinding, code_of, minimised
from jauspy.fuzz.target.process import TargetProcess
from jauspy.fuzz.target.session import CHECK_EVERY, MAX_UNCHECKED, Limits, Symptom, TargetSession
from jauspy.ids import JausID

CASES_PER_TASK: Final = 25 * EPISODE
"""Cases of one task on a cluster."""


@dataclass(frozen=True, slots=True)
class TargetPlan:
    """The settings of a campaign: `cases` from number `first`. `restart` is the command that starts the target.

    `{host}` and `{port}` in the command are replaced by the address.
    """

    address: Address
    cases: int
    seed: int = 0
    first: int = 0
    restart: str = ""
    pid: int | None = None
    component: JausID | None = None
    only: tuple[str, ...] = ()
    limits: Limits = field(default_factory=Limits)
    tries: int = 200
    """Starts of the target to minimise one finding."""

    @property
    def command(self) -> str:
        """The command that starts the target at its address."""
        host, port = self.address
        return self.restart.replace("{host}", host).replace("{port}", str(port))


@dataclass(slots=True)
class TargetResult:
    """The result so far."""

    component: str = ""
    messages: int = 0
    states: set[str] = field(default_factory=set)
    """The states that the target was brought to."""
    unreached: set[str] = field(default_factory=set)
    """The states that it could not be brought to."""
    cases: int = 0
    datagrams: int = 0
    findings: dict[str, TargetFinding] = field(default_factory=dict)
    is_stopped: bool = False
    """True if the target failed and cannot be started again, so that the rest of the cases was not sent."""

    def merge(self, other: TargetResult) -> None:
        """Add the result of another part of the campaign."""
        self.component, self.messages = other.component, other.messages
        self.states |= other.states
        self.unreached = (self.unreached | other.unreached) - self.states
        self.cases += other.cases
        self.datagrams += other.datagrams
        self.is_stopped |= other.is_stopped
        for cause, finding in other.findings.items():
            self.findings.setdefault(cause, finding)


Progress = Callable[[TargetResult], None]


def run(plan: TargetPlan, progress: Progress = lambda _: None) -> TargetResult:
    """Send all cases in this process. Raises `ConfigError` if the target does not answer at the start."""
    session = TargetSession(plan.address, TargetProcess(plan.command, plan.pid), plan.limits, plan.seed, plan.component)
    try:
        services = session.open()
        cases = Cases(session.component, services, plan.seed, plan.only)
        return _Campaign(plan, session, cases, progress).run()
    finally:
        session.close()


def run_on_cluster(plan: TargetPlan, cluster: str, progress: Progress = lambda _: None) -> TargetResult:
    """Send the cases from the workers of a Dask cluster, each to a target that it starts itself.

    A part whose worker is lost is done again by another one, with the same cases.
    """
    outcome = TargetResult()
    for part in spread(cluster, run_at_free_port, _parts(plan)):
        outcome.merge(part)
        progress(outcome)
    return outcome


def run_at_free_port(plan: TargetPlan) -> TargetResult:
    """Same as `run`, at a port that is free on this machine."""
    host, _ = plan.address
    return run(replace(plan, address=(host, free_port(host))))


def _parts(plan: TargetPlan) -> Iterator[TargetPlan]:
    end = plan.first + plan.cases
    for first in range(plan.first, end, CASES_PER_TASK):
        yield replace(plan, first=first, cases=min(CASES_PER_TASK, end - first))


class _Campaign:
    """The loop over the cases of a plan."""

    def __init__(self, plan: TargetPlan, session: TargetSession, cases: Cases, progress: Progress) -> None:
        self._plan = plan
        self._session = session
        self._cases = cases
        self._progress = progress
        self._left_out: set[int] = set()
        """Ids of messages that made the target fail, which later cases leave out to get behind that."""
        self._unchecked = self._unchecked_bytes = 0
        self._result = TargetResult(str(session.component), len(cases.messages))

    def run(self) -> TargetResult:
        """Send all cases, or those until a failure after which the target cannot be started again."""
        first, end = self._plan.first, self._plan.first + self._plan.cases
        for number in range(first, end):
            if number == first or number % EPISODE == 0:
                self._enter(number)
                self._progress(self._result)
            if self._result.is_stopped:
                break
            self._send(self._cases.datagrams(number), number, is_last=number == end - 1)
            self._result.cases += 1
        self._progress(self._result)
        return self._result

    def _enter(self, number: int) -> None:
        """Bring the target to the state of a case, if necessary after a restart."""
        stop = self._cases.stop(number)
        is_there = self._session.walk(stop, self._cases)
        if not is_there:
            self._check(number)
            if self._session.process.can_restart and self._session.restart():
                is_there = self._session.walk(stop, self._cases)
        (self._result.states if is_there else self._result.unreached).add(str(stop.situation))
        self._result.unreached -= self._result.states

    def _send(self, datagrams: Iterable[bytes], number: int, *, is_last: bool) -> None:
        for datagram in datagrams:
            if code_of(datagram) in self._left_out:
                break
            self._session.send(datagram)
            self._result.datagrams += 1
            self._unchecked += 1
            self._unchecked_bytes += len(datagram)
            if self._unchecked >= CHECK_EVERY or self._unchecked_bytes > MAX_UNCHECKED:
                self._check(number)
                if self._result.is_stopped:
                    return
        if is_last or (number + 1) % EPISODE == 0:
            self._check(number)

    def _check(self, number: int) -> None:
        """Query the target; minimise and keep what it suffers from."""
        self._unchecked = self._unchecked_bytes = 0
        symptom = self._session.symptom()
        if symptom is None:
            return
        finding = self._finding(symptom, number)
        self._result.findings.setdefault(finding.cause, finding)
        if finding.is_minimised and (code := code_of(finding.datagrams[-1])) is not None:
            self._left_out.add(code)
        self._progress(self._result)
        if not self._session.process.can_restart or not self._session.restart():
            self._result.is_stopped = True
            return
        self._session.walk(self._cases.stop(number), self._cases)

    def _finding(self, symptom: Symptom, number: int) -> TargetFinding:
        session = self._session
        source, history = session.link.own_address, tuple(session.link.history)
        found = minimised(session, history, symptom, self._plan.tries) if session.process.can_restart else None
        datagrams, seen = found or (history, symptom)
        return TargetFinding(
            symptom.failure,
            seen.seen,
            str(session.component),
            datagrams,
            is_minimised=found is not None,
            source=source,
            destination=session.address,
            seed=self._plan.seed,
            case=number,
        )
