"""Brings a component from state to state, and observes where it is; the stimuli that are sent there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.results import Failed, Silent, Skipped, StepOutcome
from jauspy.conformance.state_tests.behaviour import ComponentUnderTest, Decide, Prediction, Situation, TruthValue
from jauspy.conformance.tester import CLIENTS, CONTROLLER, EMERGENCY_CLIENT, OBSERVER, Client, Tester
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
MIN_AUTHORITY: Final = 200
"""Authority of the controller, when the default authority of the component is less."""
STATUS: Final[Mapping[str, ReportStatus.Status]] = {
    "Init": ReportStatus.Status.INITIALIZE,
    "Ready": ReportStatus.Status.READY,
    "Standby": ReportStatus.Status.STANDBY,
    "Shutdown": ReportStatus.Status.SHUTDOWN,
    "Failure": ReportStatus.Status.FAILURE,
    "Emergency": ReportStatus.Status.EMERGENCY,
}
"""What Management reports in a state, by the state's name (AS5710)."""
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
    """What the component says of itself; None where it has no service that tells."""

    status: ReportStatus.Status | int | None
    controller: JausID | None

    def __str__(self) -> str:
        name = getattr(self.status, "name", self.status)
        return f"status {name}, " + (f"controlled by {self.controller}" if self.controller else "not controlled")


class Explorer:
    """One component of the target, with the tester's clients in their roles."""

    def __init__(self, tester: Tester, component: JausID, services: frozenset[str], start: Situation) -> None:
        self.tester = tester
        self.component = component
        self.start = start
        self.services = services
        self._measured = False
        self._start_missed = False
        self._lost: set[Situation] = set()
        self.where: Situation | None = None
        """Where the last step has left it."""
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
        """Be in this situation, by steering along `path` from the start; the step is skipped when that fails."""
        self._be_at_start()
        try:
            self._measure()
            where, self.where = self.where, None
            seen = self.observe()
            if where != goal or not self.agrees(seen, goal):
                seen = self._travel(path)
            if goal.controller == CONTROLLER and "Emergency" not in goal.state:
                self.steer("RequestControl", CONTROLLER)
        except StepOutcome as outcome:
            if not path:
                raise  # where the component begins it must at least say where it is
            first = Silent if isinstance(outcome, Silent) else Failed
            raise self._out_of_reach(goal, str(outcome), first) from outcome
        if not self.agrees(seen, goal):
            raise self._out_of_reach(goal, f"it reports {seen}")
        self.quiet()

    def _be_at_start(self) -> None:
        """Before the first step; as long as that fails nothing can be reached, which is one failure and no more."""
        if self._measured or ACCESS_CONTROL not in self.services:
            return
        again, self._start_missed = self._start_missed, True
        try:
            seen = self._go_home()
        except StepOutcome as outcome:
            raise Skipped(str(outcome)) if again else outcome from None
        self._start_missed = not self.agrees(seen, self.start)
        if self._start_missed:
            raise (Skipped if again else Failed)(self._away(seen))

    def _away(self, seen: ObservedState) -> str:
        if seen.status == STATUS["Shutdown"]:
            return f"{self.component} is shut down, and nothing leads out of that: start it again before a test"
        return f"{self.component} reports {seen}, and a test begins in {self.start}"

    def _out_of_reach(self, goal: Situation, why: str, first: type[StepOutcome] = Failed) -> StepOutcome:
        """Every situation can be reached, so the first step that wants it fails, and the others have their reason."""
        kind = Skipped if goal in self._lost else first
        self._lost.add(goal)
        return kind(f"the component cannot be brought to {goal}: {why}")

    def _travel(self, path: tuple[tuple[str, str], ...]) -> ObservedState:
        seen = self._go_home()
        if self.agrees(seen, self.start):
            for message, role in path:
                self.steer(message, role)
            return self.observe()
        return seen  # some states are never left, and may be the goal

    def steer(self, message: str, role: str) -> None:
        """One input on the way."""
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
        """Ask the component where it is; what it was told before, it has heard when it answers."""
        with self.tester.unreported():
            return self._ask()

    def _ask(self) -> ObservedState:
        observer = self.client(OBSERVER)
        status: ReportStatus.Status | int | None = None
        controller: JausID | None = None
        if MANAGEMENT in self.services:
            status = observer.ask(QueryStatus(), ReportStatus, to=self.component).status
        if ACCESS_CONTROL in self.services:
            report = observer.ask(QueryControl(), ReportControl, to=self.component)
            id = JausID(report.subsystem_id, report.node_id, report.component_id)
            controller = id if int(id) else None
        if not self.services & {MANAGEMENT, ACCESS_CONTROL}:
            observer.ask(QueryEvents(AllEventsRec(0)), ReportEvents, to=self.component)
        return ObservedState(status, controller)

    def agrees(self, seen: ObservedState, situation: Situation) -> bool:
        """True when what the component says fits a situation; initialization may be over at once."""
        wanted = status_of(situation)
        client = JausID.parse(CLIENTS[situation.controller]) if situation.controller else None
        fits = seen.status in (wanted, STATUS["Standby"]) if wanted == STATUS["Init"] else seen.status == wanted
        return (MANAGEMENT not in self.services or wanted is None or fits) and (
            ACCESS_CONTROL not in self.services or seen.controller == client
        )

    def settle(self, situation: Situation) -> ObservedState:
        """As `observe`, and wait while the component initializes."""
        end = self.tester.now + self.tester.timeout
        seen = self.observe()
        while seen.status == STATUS["Init"] and "Init" in situation.state and self.tester.now < end:
            self.tester.wait(0.05 * self.tester.timeout)
            seen = self.observe()
        return seen

    def quiet(self) -> None:
        """What has come so far belongs to the way here."""
        for role in CLIENTS:
            self.client(role).pending.clear()
        self.tester.why.clear()
        self.tester.checks.clear()
        self.tester.expected.clear()

    def _go_home(self) -> ObservedState:
        """Undo everything that the tester may have done."""
        if MANAGEMENT in self.services:
            for role in CLIENTS:
                self.client(role).send(ClearEmergency(STOP), to=self.component)
        if ACCESS_CONTROL in self.services:
            for role in CLIENTS:
                self.client(role).send(ReleaseControl(), to=self.component)
        return self.settle(self.start)

    def _measure(self) -> None:
        """Once, before anybody is in control: what only the component knows."""
        if self._measured or ACCESS_CONTROL not in self.services:
            return
        observer = self.client(OBSERVER)
        self.default_authority = observer.ask(QueryAuthority(), ReportAuthority, to=self.component).authority_code
        self.timeout = int(observer.ask(QueryTimeout(), ReportTimeout, to=self.component).timeout)
        self._measured = True


def explorer_of(subject: ComponentUnderTest, tester: Tester) -> Explorer:
    """The one explorer of this component in this run."""
    known: dict[JausID, Explorer] = tester.memory.setdefault("explorers", {})
    if subject.component not in known:
        services = frozenset(each.id for each in subject.definitions)
        known[subject.component] = Explorer(tester, subject.component, services, subject.machine.start)
    return known[subject.component]


def status_of(situation: Situation) -> ReportStatus.Status | None:
    """What Management reports: the innermost state that it names, below `Receiving.Ready`, which everything has."""
    return next((STATUS[name] for name in reversed(situation.state[2:]) if name in STATUS), None)


Make: TypeAlias = Callable[[Explorer], Message]
Prepare: TypeAlias = Callable[[Explorer, str], None]
"""Takes the role of the sender, too."""

SENDER_PREDICATES: Final = frozenset({"isControllingClient"})
EMERGENCY_PREDICATES: Final = frozenset({"isIDStored"})
"""Predicates about who sends."""


MAX_TIMER_WAIT: Final = 70.0
"""Seconds that a step may wait for a timer of the component: the default of events is a minute."""
MIN_TIMER_FRACTION: Final = 0.8
"""Of a timer: the part of its time that must have passed."""


def no_preparation(explorer: Explorer, role: str) -> None:
    """The usual preparation."""


@dataclass(frozen=True, slots=True)
class StimulusResult:
    """What is known when an input has been answered: who sent it, where that was, and the outcome that fits."""

    explorer: Explorer
    role: str
    before: Situation
    outcome: Prediction
    took: Callable[[str], None]
    """To be called when the input has brought about an internal event as well, by its name."""


@dataclass(frozen=True, slots=True)
class Stimulus:
    """One kind of input. `message` is its name in the JSIDL, `make` None for an event that comes by itself."""

    message: str
    make: Make | None
    variant: str = ""
    truths: Mapping[str, TruthValue] = field(default_factory=dict)
    """What is known of predicates, by name."""
    before: Prepare = no_preparation
    after: Prepare = no_preparation
    checks: Mapping[str, tuple[Check, ...]] = field(default_factory=dict)
    """What to look at in outputs, by message name."""
    verify: Callable[[StimulusResult], None] | None = None
    """Looks at the effect."""
    by_controller: bool = False
    """Can only be prepared by the client in control."""
    only_in: str = ""
    """The name of the state, below Receiving.Ready, in which alone it shows anything."""
    moves: bool = False
    """Something may move in Ready, whatever the message says."""
    of: str = ""
    """How the URN of the service begins that is meant, when messages of others have the same name."""
    also: tuple[str, ...] = ()
    """Internal events that it may bring about as well."""
    seconds: Callable[[Explorer], float] | None = None
    """How long to wait: for an event that comes by itself, or an answer that takes its time."""
    earliest: float = 0.0
    """The part of that time before which it must not come."""
    once: bool = False
    """Tried in the first state alone: the others would show nothing more."""

    def fits(self, situation: Situation) -> bool:
        """True where it can be prepared and shows something."""
        controlled = situation.controller is not None or not self.by_controller
        return controlled and (not self.only_in or self.only_in in situation.state[2:])

    def judge(self, role: str) -> Decide:
        """Decides predicates for this input from this sender."""

        def decide(call: behavior.Call, situation: Situation) -> TruthValue:
            name = call.name.rpartition(".")[2]
            if name in SENDER_PREDICATES:
                return situation.controller == role
            if name in EMERGENCY_PREDICATES:
                return role in situation.emergencies
            return self.truths.get(name)

        return decide
