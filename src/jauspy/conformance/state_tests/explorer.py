"""Brings a component to a situation of its merged state machine; the stimuli that are sent in each situation."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.results import Failed, Silent, Skipped, StepOutcome
from jauspy.conformance.state_tests.behaviour import ComponentUnderTest, Decide, Prediction, Situation, TruthValue
from jauspy.conformance.state_tests.neutral_messages import neutral
from jauspy.conformance.steering import ACCESS_CONTROL, ObservedState, Path, StateGoal, Status, Steering
from jauspy.conformance.tester import CLIENTS, CONTROLLER, EMERGENCY_CLIENT, Tester
from jauspy.ids import JausID
from jauspy.schema import behavior

STATUS: Final[Mapping[str, Status]] = {
    "Init": Status.INITIALIZE,
    "Ready": Status.READY,
    "Standby": Status.STANDBY,
    "Shutdown": Status.SHUTDOWN,
    "Failure": Status.FAILURE,
    "Emergency": Status.EMERGENCY,
}
"""Status that Management reports, by the name of the state (AS5710)."""

STEERING_INPUTS: Final[Path] = (
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


class Explorer(Steering):
    """One component of the target, whose situations are those of its merged state machine."""

    def __init__(self, tester: Tester, subject: ComponentUnderTest) -> None:
        super().__init__(tester, subject.component, [definition.id for definition in subject.definitions])
        self._subject = subject
        self.start = subject.machine.start
        self.inputs = frozenset(message.code for definition in subject.definitions for message in definition.inputs)
        """The ids of all messages that the component takes."""
        self._start_failed = False
        self._unreachable_situations: set[Situation] = set()
        self.where: Situation | None = None
        """The situation after the last step, if it is known."""

    def steering(self, message: str) -> Message:
        """A message of the core services, or the neutral command of this name."""
        if message in {name for name, _ in STEERING_INPUTS}:
            return super().steering(message)
        return neutral(self._subject.kind(message))

    def reach(self, goal: Situation, path: Path) -> None:
        """Bring the component to a situation, along `path` from the start. Skips the step if that fails."""
        self._reach_start()
        try:
            self.measure()
            where, self.where = self.where, None
            seen = self.observe()
            if where != goal or not self.agrees(seen, goal):
                seen = self.travel(self._goal(self.start), path, self._goal(goal))
            if goal.controller == CONTROLLER and "Emergency" not in goal.state:
                self.steer("RequestControl", CONTROLLER)
        except StepOutcome as outcome:
            if not path:
                raise  # in its first state the component must at least report its state
            first = Silent if isinstance(outcome, Silent) else Failed
            raise self._unreachable(goal, str(outcome), first) from outcome
        if not self.agrees(seen, goal):
            raise self._unreachable(goal, f"it reports {seen}")
        self.tester.keep_pace()
        self.discard_received()

    def _reach_start(self) -> None:
        """Bring the component to the start before the first step. If that fails, the other steps are skipped."""
        if self.is_measured or ACCESS_CONTROL not in self.services:
            return
        again, self._start_failed = self._start_failed, True
        try:
            seen = self.return_to(self._goal(self.start))
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

    def agrees(self, seen: ObservedState, situation: Situation) -> bool:
        """True if the reported state fits a situation; initialization may have ended already."""
        wanted = status_of(situation)
        client = JausID.parse(CLIENTS[situation.controller]) if situation.controller else None
        fits = seen.status in (wanted, STATUS["Standby"]) if wanted == STATUS["Init"] else seen.status == wanted
        return (seen.status is None or wanted is None or fits) and (
            not seen.is_controller_known or seen.controller == client
        )

    def settle(self, *situations: Situation) -> ObservedState:
        """Same as `observe`, until the state fits one of the situations, at most for a timeout."""
        return self.settle_on(self._goal(*situations))

    def _goal(self, *situations: Situation) -> StateGoal:
        return StateGoal(situations, lambda seen: any(self.agrees(seen, situation) for situation in situations))

    def discard_received(self) -> None:
        """Discard pending messages and checks, which belong to earlier inputs."""
        for role in CLIENTS:
            self.client(role).pending.clear()
        self.tester.why.clear()
        self.tester.checks.clear()
        self.tester.expected.clear()


def explorer_of(subject: ComponentUnderTest, tester: Tester) -> Explorer:
    """The one explorer of this component in this run."""
    known: dict[JausID, Explorer] = tester.memory.setdefault("explorers", {})
    if subject.component not in known:
        known[subject.component] = Explorer(tester, subject)
    return known[subject.component]


def status_of(situation: Situation) -> Status | None:
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
    """Callback for the name of an internal event that the input has also caused."""


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
    may_send: tuple[str, ...] = ()
    """Messages that may come besides: outputs of the service that no action of its definition sends."""

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
