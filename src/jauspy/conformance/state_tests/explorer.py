"""Brings a component from state to state and observes its state; the stimuli that are sent in each state."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.results import Failed, Silent, Skipped, StepOutcome
from jauspy.conformance.silences import silences_of
from jauspy.conformance.state_tests.behaviour import ComponentUnderTest, Decide, Prediction, Situation, TruthValue
from jauspy.conformance.tester import CLIENTS, CONTROLLER, EMERGENCY_CLIENT, Client, Tester, pauses
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
from jauspy.schema import behavior

STOP: Final = SetEmergency.EmergencyCode.STOP
SLOW_PAUSE: Final = 1 / 8
"""Timeouts between two inputs if the component did not follow them immediately."""
WAIT_FOR_NOTHING: Final = 0.1
"""Timeouts in which an answer would come, if no query is answered that would show it."""
MIN_AUTHORITY: Final = 200
"""Authority of the controller, if the default authority of the component is lower."""
STATUS: Final[Mapping[str, ReportStatus.Status]] = {
    "Init": ReportStatus.Status.INITIALIZE,
    "Ready": ReportStatus.Status.READY,
    "Standby": ReportStatus.Status.STANDBY,
    "Shutdown": ReportStatus.Status.SHUTDOWN,
    "Failure": ReportStatus.Status.FAILURE,
    "Emergency": ReportStatus.Status.EMERGENCY,
}
"""Status that Management reports, by the name of the state (AS5710)."""
MANAGEMENT, ACCESS_CONTROL = "urn:jaus:jss:core:Management", "urn:jaus:jss:core:AccessControl"

STEERING_INPUTS: Final[tuple[tuple[str, str], ...]] = (
    ("RequestControl", CONTROLLER),
    ("Resume", CONTROLLER),
    ("Standby", CONTROLLER),
    ("SetEmergency", EMERGENCY_CLIENT),
    ("ClearEmergency", EMERGENCY_CLIENT),
    ("ReleaseControl", CONTROLLER),
    ("Reset", CONTROLLER),
    ("Shutdown", CONTROLLER),
)
"""The inputs that lead from state to state."""


@dataclass(frozen=True, slots=True)
class ObservedState:
    """Status and controller as the component reports them; None without a service that reports them, or an answer."""

    status: ReportStatus.Status | int | None
    controller: JausID | None
    """None also without a controller."""
    is_controller_known: bool = True

    def __str__(self) -> str:
        name = getattr(self.status, "name", self.status)
        controlled = f"controlled by {self.controller}" if self.controller else "not controlled"
        return f"status {name}, " + (controlled if self.is_controller_known else "its controller is not reported")


class Explorer:
    """One component of the target, with the tester's clients in their roles."""

    def __init__(self, tester: Tester, subject: ComponentUnderTest) -> None:
        self.tester = tester
        self.component = component = subject.component
        self.start = subject.machine.start
        self.services = frozenset(each.id for each in subject.definitions)
        self.inputs = frozenset(message.code for each in subject.definitions for message in each.inputs)
        """The ids of all messages that the component takes."""
        self.silences = silences_of(component, tester)
        self._measured = False
        self._start_failed = False
        self._settled_wrong: dict[tuple[Situation, ...], ObservedState] = {}
        """States that the component still had after the timeout, where it should have been in these situations."""
        self._unreachable_situations: set[Situation] = set()
        self.where: Situation | None = None
        """The situation after the last step, if it is known."""
        self.default_authority = 0
        self.timeout = 0
        """Seconds after which control ends; 0: never."""

    @property
    def authority(self) -> int:
        """Authority of the controller."""
        return min(254, max(MIN_AUTHORITY, self.default_authority + 2))

    def client(self, role: str) -> Client:
        """The client in this role."""
        return self.tester.client(CLIENTS[role])

    def reach(self, goal: Situation, path: tuple[tuple[str, str], ...]) -> None:
        """Bring the component to a situation, along `path` from the start. Skips the step if that fails."""
        self._reach_start()
        try:
            self._measure()
            where, self.where = self.where, None
            seen = self.observe()
            if where != goal or not self.agrees(seen, goal):
                seen = self._travel(goal, path)
            if goal.controller == CONTROLLER and "Emergency" not in goal.state:
                self.steer("RequestControl", CONTROLLER)
        except StepOutcome as outcome:
            if not path:
                raise  # in its first state the component must at least report its state
            first = Silent if isinstance(outcome, Silent) else Failed
            raise self._unreachable(goal, str(outcome), first) from outcome
        if not self.agrees(seen, goal):
            raise self._unreachable(goal, f"it reports {seen}")
        self.discard_received()

    def _reach_start(self) -> None:
        """Bring the component to the start before the first step. If that fails, the other steps are skipped."""
        if self._measured or ACCESS_CONTROL not in self.services:
            return
        again, self._start_failed = self._start_failed, True
        try:
            seen = self._return_to(self.start)
        except StepOutcome as outcome:
            raise Skipped(str(outcome)) if again else outcome from None
        self._start_failed = not self.agrees(seen, self.start)
        if self._start_failed:
            raise (Skipped if again else Failed)(self._not_at_start(seen))

    def _not_at_start(self, seen: ObservedState) -> str:
        if seen.status == STATUS["Shutdown"]:
            return f"{self.component} is shut down, which it cannot leave: restart it before a test"
        return f"{self.component} reports {seen}, and a test begins in {self.start}"

    def _unreachable(self, goal: Situation, why: str, first: type[StepOutcome] = Failed) -> StepOutcome:
        """The outcome if a situation cannot be reached: the first step that needs it fails, the others are skipped."""
        kind = Skipped if goal in self._unreachable_situations else first
        self._unreachable_situations.add(goal)
        return kind(f"the component cannot be brought to {goal}: {why}")

    def _travel(self, goal: Situation, path: tuple[tuple[str, str], ...]) -> ObservedState:
        """Go to the start and along the path; if that fails, once more with a pause after each input."""
        for pause in (0.0, SLOW_PAUSE * self.tester.timeout):
            seen = self._return_to(self.start)
            if not self.agrees(seen, self.start):
                return seen  # some states cannot be left, and may be the goal
            for message, role in path:
                self.steer(message, role)
                self.tester.wait(pause)
            seen = self.settle(goal)
            if self.agrees(seen, goal):
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
        """The message for `STEERING_INPUTS`."""
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

    def agrees(self, seen: ObservedState, situation: Situation) -> bool:
        """True if the reported state fits a situation; initialization may have ended already."""
        wanted = status_of(situation)
        client = JausID.parse(CLIENTS[situation.controller]) if situation.controller else None
        fits = seen.status in (wanted, STATUS["Standby"]) if wanted == STATUS["Init"] else seen.status == wanted
        return (seen.status is None or wanted is None or fits) and (
            not seen.is_controller_known or seen.controller == client
        )

    def settle(self, *situations: Situation) -> ObservedState:
        """As `observe`, until the state fits one of the situations, at most for a timeout.

        The services of a component may notify each other asynchronously, and initialization takes time.
        """
        seen = self.observe()
        if self._settled_wrong.get(situations) == seen:
            return seen  # it stays so; waiting in each step would take long
        for pause in pauses(self.tester.timeout):
            fits = any(self.agrees(seen, each) for each in situations)
            if (fits and seen.status != STATUS["Init"]) or seen.status == STATUS["Shutdown"]:
                return seen
            self.tester.wait(pause)
            seen = self.observe()
        self._settled_wrong[situations] = seen
        return seen

    def discard_received(self) -> None:
        """Discard pending messages and checks, which belong to earlier inputs."""
        for role in CLIENTS:
            self.client(role).pending.clear()
        self.tester.why.clear()
        self.tester.checks.clear()
        self.tester.expected.clear()

    def _return_to(self, start: Situation) -> ObservedState:
        """Clear emergencies and release control, to return to the start."""
        if MANAGEMENT in self.services:
            for role in CLIENTS:
                self.client(role).send(ClearEmergency(STOP), to=self.component)
        if ACCESS_CONTROL in self.services:
            for role in CLIENTS:
                self.client(role).send(ReleaseControl(), to=self.component)
        return self.settle(start)

    def _measure(self) -> None:
        """Query default authority and timeout of the component, once, before a client takes control."""
        if self._measured or ACCESS_CONTROL not in self.services:
            return
        authority = self.silences.ask(QueryAuthority(), ReportAuthority)
        timeout = self.silences.ask(QueryTimeout(), ReportTimeout)
        self.default_authority = authority.authority_code if authority else 0
        self.timeout = int(timeout.timeout) if timeout else 0
        self._measured = True


def explorer_of(subject: ComponentUnderTest, tester: Tester) -> Explorer:
    """The one explorer of this component in this run."""
    known: dict[JausID, Explorer] = tester.memory.setdefault("explorers", {})
    if subject.component not in known:
        known[subject.component] = Explorer(tester, subject)
    return known[subject.component]


def status_of(situation: Situation) -> ReportStatus.Status | None:
    """The status that Management reports: the innermost state with a status, below `Receiving.Ready`."""
    return next((STATUS[name] for name in reversed(situation.state[2:]) if name in STATUS), None)


Make: TypeAlias = Callable[[Explorer], Message]
Prepare: TypeAlias = Callable[[Explorer, str], None]
"""The second parameter is the role of the sender."""

SENDER_PREDICATES: Final = frozenset({"isControllingClient"})
EMERGENCY_PREDICATES: Final = frozenset({"isIDStored"})
"""Predicates about the sender."""
CONTROL_PREDICATES: Final = frozenset({"isControlAvailable"})
"""Predicates about the state of Management, in version 1.0."""
UNAVAILABLE_STATES: Final = frozenset({"Init", "Failure", "Shutdown", "Emergency"})


MAX_TIMER_WAIT: Final = 70.0
"""Seconds that a step may wait for a timer of the component: the default of events is a minute."""
MIN_TIMER_FRACTION: Final = 0.8
"""Part of a timer's time that must have passed."""


def no_preparation(explorer: Explorer, role: str) -> None:
    """The default preparation."""


@dataclass(frozen=True, slots=True)
class StimulusResult:
    """The result of an input: its sender, the situation before, and the outcome that fits."""

    explorer: Explorer
    role: str
    before: Situation
    outcome: Prediction
    took: Callable[[str], None]
    """To be called with the name of an internal event that the input has also caused."""


@dataclass(frozen=True, slots=True)
class Stimulus:
    """One kind of input. `message` is its name in the JSIDL; `make` is None for an internal event."""

    message: str
    make: Make | None
    variant: str = ""
    truths: Mapping[str, TruthValue] = field(default_factory=dict)
    """Known values of predicates, by name."""
    before: Prepare = no_preparation
    after: Prepare = no_preparation
    checks: Mapping[str, tuple[Check, ...]] = field(default_factory=dict)
    """Checks of the outputs, by message name."""
    verify: Callable[[StimulusResult], None] | None = None
    """Checks the effect."""
    by_controller: bool = False
    """True if only the client in control can prepare it."""
    only_in: str = ""
    """The only state, below Receiving.Ready, in which it has a visible effect."""
    moves: bool = False
    """True if it may cause motion in Ready, whatever its values."""
    of: str = ""
    """Beginning of the service's URN, if other services have messages of the same name."""
    also: tuple[str, ...] = ()
    """Internal events that it may also cause."""
    seconds: Callable[[Explorer], float] | None = None
    """Seconds to wait for an internal event or a slow answer."""
    earliest: float = 0.0
    """Part of that time within which no answer may arrive."""
    once: bool = False
    """True if it is tested in the first state only."""

    def fits(self, situation: Situation) -> bool:
        """True if it can be prepared in this situation and has a visible effect."""
        controlled = situation.controller is not None or not self.by_controller
        return controlled and (not self.only_in or self.only_in in situation.state[2:])

    def judge(self, role: str) -> Decide:
        """Return the function that decides predicates for this input from this sender."""

        def decide(call: behavior.Call, situation: Situation) -> TruthValue:
            name = call.name.rpartition(".")[2]
            if name in SENDER_PREDICATES:
                return situation.controller == role
            if name in EMERGENCY_PREDICATES:
                return role in situation.emergencies
            if name in CONTROL_PREDICATES:
                return not UNAVAILABLE_STATES & set(situation.state)
            return self.truths.get(name)

        return decide
