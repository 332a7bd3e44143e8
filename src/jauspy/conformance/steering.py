"""Brings a component from state to state by messages of the core services, and observes its state.

State tables and generated steps travel alike. Neither definitions nor the merged state machine are used.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Mapping
from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.results import Failed, StepOutcome
from jauspy.conformance.silences import silences_of
from jauspy.conformance.tester import CLIENTS, Client, Tester, pauses
from jauspy.ids import JausID
from jauspy.messages.core import (
    AllEventsRec,
    ClearEmergency,
    ConfirmControl,
    QueryAuthority,
    QueryControl,
    QueryEvents,
    QueryStatus,
    QueryTimeout,
    ReleaseControl,
    ReportAuthority,
    ReportControl,
    ReportEvents,
    ReportStatus,
    ReportTimeout,
    RequestControl,
    Reset,
    Resume,
    SetEmergency,
    Shutdown,
    Standby,
)

Status: TypeAlias = ReportStatus.Status
Path: TypeAlias = tuple[tuple[str, str], ...]
"""Inputs, each with the role that sends it."""

STOP: Final = SetEmergency.EmergencyCode.STOP
PACES: Final = (0.0, 1 / 8, 1 / 2)
"""Timeouts between a command and what is sent next. The services of a component may notify each other with delay: one
that confirms control may ignore Resume for a moment. The next pace is taken where the present one fails."""
RECHECK: Final = 1 / 8
"""Timeouts to wait for a state if the component once did not reach it."""
WAIT_FOR_NOTHING: Final = 0.1
"""Timeouts in which an answer would come, if no query is answered that would show it."""
MIN_AUTHORITY: Final = 200
"""Authority of the controller, if the default authority of the component is lower."""
MANAGEMENT, ACCESS_CONTROL = "urn:jaus:jss:core:Management", "urn:jaus:jss:core:AccessControl"


@dataclass(frozen=True, slots=True)
class ObservedState:
    """Status and controller as the component reports them; None without a service that reports them, or an answer."""

    status: Status | int | None
    controller: JausID | None
    """None also without a controller."""
    is_controller_known: bool = True

    def __str__(self) -> str:
        name = getattr(self.status, "name", self.status)
        controlled = f"controlled by {self.controller}" if self.controller else "not controlled"
        return f"status {name}, " + (controlled if self.is_controller_known else "its controller is not reported")


@dataclass(frozen=True, slots=True)
class StateGoal:
    """A state that is to be reached. `name` identifies it in a run; `fits` compares it with what was observed."""

    name: Hashable
    fits: Callable[[ObservedState], bool]


class Steering:
    """One component of the target, and the tester's clients in their roles. `services` are URNs that it offers."""

    def __init__(self, tester: Tester, component: JausID, services: Collection[str]) -> None:
        self.tester = tester
        self.component = component
        self.services = frozenset(services)
        self.silences = silences_of(component, tester)
        self.is_measured = False
        self.default_authority = 0
        self.timeout = 0
        """Seconds after which control ends; 0: never."""
        self._settled_wrong: dict[Hashable, ObservedState] = {}
        """States that the component still had after the timeout, where it should have reached others."""

    @property
    def authority(self) -> int:
        """Authority of the controller."""
        return min(254, max(MIN_AUTHORITY, self.default_authority + 2))

    def client(self, role: str) -> Client:
        """The client in this role."""
        return self.tester.client(CLIENTS[role])

    def measure(self) -> None:
        """Query default authority and timeout of the component, once, before a client takes control."""
        if self.is_measured or ACCESS_CONTROL not in self.services:
            return
        authority = self.silences.ask(QueryAuthority(), ReportAuthority)
        timeout = self.silences.ask(QueryTimeout(), ReportTimeout)
        self.default_authority = authority.authority_code if authority else 0
        self.timeout = int(timeout.timeout) if timeout else 0
        self.is_measured = True

    def travel(self, start: StateGoal, path: Path, goal: StateGoal) -> ObservedState:
        """Go to the start and along the path; if that fails, again at the next paces. Returns the last state."""
        was_reached = goal.name not in self._settled_wrong
        for pace in _paces(self.tester)[: None if was_reached else 1]:
            with self.tester.at_pace(pace):
                seen = self.return_to(start)
                if start.fits(seen):  # some states cannot be left, and may be the goal
                    self.measure()
                    for message, role in path:
                        self.steer(message, role)
                    seen = self.settle_on(goal)
            if goal.fits(seen):
                _adopt(self.tester, pace)
                break
        return seen

    def steer(self, message: str, role: str) -> None:
        """Send one steering input."""
        made = self.steering(message)
        client = self.client(role)
        if isinstance(made, RequestControl):
            with self.tester.unreported():
                client.ask(made, ConfirmControl, to=self.component)
        else:
            client.send(made, to=self.component)

    def steering(self, message: str) -> Message:
        """The message of this name, by which a component is steered."""
        made: Mapping[str, Message] = {
            "RequestControl": RequestControl(self.authority),
            "Resume": Resume(),
            "Standby": Standby(),
            "SetEmergency": SetEmergency(STOP),
            "ClearEmergency": ClearEmergency(STOP),
            "ReleaseControl": ReleaseControl(),
            "Reset": Reset(),
            "Shutdown": Shutdown(),
        }
        return made[message]

    def observe(self) -> ObservedState:
        """Query the state of the component; the answer also shows that it has handled all earlier messages."""
        with self.tester.unreported():
            return self._ask()

    def _ask(self) -> ObservedState:
        status = self.silences.ask(QueryStatus(), ReportStatus) if MANAGEMENT in self.services else None
        control = self.silences.ask(QueryControl(), ReportControl) if ACCESS_CONTROL in self.services else None
        if status is None and control is None:
            answer = self.silences.ask(QueryEvents(AllEventsRec(0)), ReportEvents)
            self.tester.wait(0.0 if answer else WAIT_FOR_NOTHING * self.tester.timeout)
        id = JausID(control.subsystem_id, control.node_id, control.component_id) if control else None
        return ObservedState(
            status.status if status else None, id if id and int(id) else None, is_controller_known=control is not None
        )

    def settle_on(self, goal: StateGoal) -> ObservedState:
        """Same as `observe`, until the state fits the goal, at most for a timeout.

        The services of a component may notify each other asynchronously, and initialization takes time.
        """
        seen = self.observe()
        waited, known_wrong = 0.0, self._settled_wrong.get(goal.name)
        for pause in pauses(self.tester.timeout):
            if (goal.fits(seen) and seen.status != Status.INITIALIZE) or seen.status == Status.SHUTDOWN:
                self._settled_wrong.pop(goal.name, None)
                return seen
            if seen == known_wrong and waited >= RECHECK * self.tester.timeout:
                return seen  # it stays so; waiting for the whole timeout in each step would take long
            self.tester.wait(pause)
            waited += pause
            seen = self.observe()
        self._settled_wrong[goal.name] = seen
        return seen

    def return_to(self, start: StateGoal) -> ObservedState:
        """Clear emergencies and release control, to return to the start."""
        if MANAGEMENT in self.services:
            self._send_from_all(ClearEmergency(STOP))
        if ACCESS_CONTROL in self.services:
            self._send_from_all(ReleaseControl())
        return self.settle_on(start)

    def _send_from_all(self, message: Message) -> None:
        """Send from every client, at once."""
        self.tester.keep_pace()
        with self.tester.at_pace(0.0):
            for role in CLIENTS:
                self.client(role).send(message, to=self.component)


def judged_at_pace(tester: Tester, prepare: Callable[[], object], attempt: Callable[[], object]) -> None:
    """Prepare a step and attempt it; one that fails is tried again at the next pace, which is kept if it passes then.

    A right component may fail at the first pace, because one of its services does not know yet what another one does.
    """
    prepare()
    taken = list(tester.taken)
    try:
        attempt()
    except Failed as outcome:
        failed, notes, taken_then = outcome, tester.notes_of_step(), list(tester.taken)
        slower = next(iter(_paces(tester)[1:]), None)
        if slower is None:
            raise
    else:
        return
    tester.taken = taken
    with tester.at_pace(slower):
        try:
            prepare()
        except StepOutcome:  # the first attempt has ended the component, or left it where it cannot be steered
            tester.restore_notes(notes)
            tester.taken = taken_then
            raise failed from None
        attempt()
    _adopt(tester, slower)


def _paces(tester: Tester) -> list[float]:
    """The present pace and the slower ones, in seconds."""
    return [tester.pace, *(part * tester.timeout for part in PACES if part * tester.timeout > tester.pace)]


def _adopt(tester: Tester, pace: float) -> None:
    """Keep a pace, and note it in the report if it is slower than before."""
    if pace > tester.pace:
        tester.pace = pace
        tester.notes.append(
            "the services of the target notify each other with delay: a state was not reached, or a step failed, until "
            f"{pace:.2g} s passed after each command; the following steps keep this pace"
        )
