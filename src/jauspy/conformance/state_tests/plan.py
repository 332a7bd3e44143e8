"""Generates the steps for the services that a target offers: each reachable state, input and distinguished sender."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from itertools import groupby
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.checks import has
from jauspy.conformance.profile import ALL_SERVICES, Offers, Profile, ServiceKey, Step
from jauspy.conformance.results import Skipped, StepOutcome
from jauspy.conformance.state_tables import table_steps
from jauspy.conformance.state_tests import sample_messages
from jauspy.conformance.state_tests.access_control import ACCESS, SILENT_CLIENT
from jauspy.conformance.state_tests.arms import ARMS
from jauspy.conformance.state_tests.behaviour import (
    TRANSPORT,
    BehaviourModel,
    ComponentUnderTest,
    MergedTransition,
    Prediction,
    Situation,
    component_under_test,
)
from jauspy.conformance.state_tests.cell import CELL_COMMANDS
from jauspy.conformance.state_tests.driving import DRIVING
from jauspy.conformance.state_tests.effects import CLOCK_STIMULI, EFFECTS, LIMITS
from jauspy.conformance.state_tests.events import COMMANDS, DUE, EVENTS, EXPIRED, NOT_RENEWED
from jauspy.conformance.state_tests.explorer import (
    EMERGENCY_PREDICATES,
    SENDER_PREDICATES,
    STEERING_INPUTS,
    Stimulus,
)
from jauspy.conformance.state_tests.lists import LISTS
from jauspy.conformance.state_tests.neutral_messages import neutral, presence_fields
from jauspy.conformance.state_tests.profile_services import PROFILE_SERVICES
from jauspy.conformance.state_tests.sensors import SENSORS, STILL_IMAGES
from jauspy.conformance.state_tests.state_test import StateTest
from jauspy.conformance.steering import MANAGEMENT, STOP, Path
from jauspy.conformance.tester import CLIENTS, CONTROLLER, EMERGENCY_CLIENT, OBSERVER, OTHER_CLIENT, Tester
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ClearEmergency,
    QueryConfiguration,
    QueryIdentification,
    QueryStatus,
    ReportStatus,
    SetEmergency,
)
from jauspy.schema import behavior
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.loader import load_builtin


def untried(
    subject: ComponentUnderTest,
    services: Collection[ServiceKey],
    steps: Iterable[Step],
    situations: Collection[Situation],
) -> Iterator[Step]:
    """A skipped step for each trigger and state of the transitions of `services` that no step takes."""
    tried = {name for step in steps for name in step.transitions}
    left = [
        rule
        for rule in subject.machine.rules
        if rule.owner.key in services and subject.transition(rule.name) not in tried
    ]
    for id, rules in groupby(sorted(left, key=_id), key=_id):
        first, *others = rules
        names = tuple(subject.transition(rule.name) for rule in (first, *others))
        reason = _reason(subject.machine, first, situations)
        yield Step(id, f"the transition {first.name}", skip(reason), transitions=names)


def _id(rule: MergedTransition) -> str:
    return f"untried/{'.'.join(rule.node.path[2:]) or 'Ready'}/{rule.trigger}"


def _reason(machine: BehaviourModel, rule: MergedTransition, situations: Collection[Situation]) -> str:
    inside = [situation for situation in situations if situation.state[: len(rule.node.path)] == rule.node.path]
    if not inside:
        return f"no input leads to {rule.node}"
    if not any(rule.name == outcome.rule for place in inside for outcome in _outcomes(machine, place, rule.trigger)):
        return f"{rule.trigger} never reaches this transition: an inner state handles it first"
    if rule.is_input:
        return f"no {rule.trigger} is known of which this holds: {rule.transition.guard}"
    return f"{rule.trigger} is raised by the component itself and cannot be caused there from outside"


def _outcomes(machine: BehaviourModel, situation: Situation, trigger: str) -> Iterable[Prediction]:
    return machine.predict(situation, trigger, "", lambda *_: None)


def skip(reason: str) -> Callable[[Tester], None]:
    """An action that skips its step."""

    def action(tester: Tester) -> None:  # noqa: ARG001 - nothing is tried
        raise Skipped(reason)

    return action


_STEERED: Final = {
    row.message: row for row in ACCESS if (row.message, row.variant) == ("RequestControl", "the same authority")
}


@dataclass(frozen=True)
class Routes:
    """Paths through the state machine by `STEERING_INPUTS`, and by commands of services that are not built in."""

    machine: BehaviourModel
    commands: tuple[str, ...] = ()

    def paths(self) -> dict[Situation, Path]:
        """One situation for each state that can be reached, and the inputs that lead there."""
        machine = self.machine
        found: dict[Situation, Path] = {machine.start: ()}
        waiting: deque[tuple[Situation, Path]] = deque([(machine.start, ())])
        states = {machine.start.state}
        while waiting:
            situation, path = waiting.popleft()
            for after, step in self.moves(situation):
                if after.state not in states:
                    states.add(after.state)
                    found[after] = (*path, step)
                    waiting.append((after, (*path, step)))
        return found

    def moves(self, situation: Situation) -> Iterator[tuple[Situation, tuple[str, str]]]:
        """The situations after single inputs, with the inputs; inputs with several possible outcomes are omitted."""
        for message, role in (*STEERING_INPUTS, *((name, CONTROLLER) for name in self.commands)):
            stimulus = _STEERED.get(message) or Stimulus(message, None)
            (first, *others) = self.machine.predict(situation, message, role, stimulus.judge(role))
            after = self._settled(first.after)
            if not others and after != situation:
                yield after, (message, role)

    def _settled(self, situation: Situation) -> Situation:
        """The situation after initialization has ended."""
        done = Stimulus("Initialized", None)
        (first, *_) = self.machine.predict(situation, done.message, "", done.judge(""))
        return first.after

    def returns(self, situation: Situation) -> bool:
        """True if inputs lead from the situation to the start."""
        seen, waiting = {situation}, [situation]
        while waiting:
            place = waiting.pop()
            if place == self.machine.start:
                return True
            for after, _ in self.moves(place):
                if after not in seen:
                    seen.add(after)
                    waiting.append(after)
        return False


def _one(message: Message, variant: str = "", **fields: object) -> Stimulus:
    """A message with the given fields; `fields` are checked in its report."""
    checks = {message.NAME.replace("Query", "Report", 1): has(**fields)} if fields else {}
    return Stimulus(message.NAME, lambda _: message, variant, checks=checks)


STIMULI: Final[tuple[Stimulus, ...]] = (
    *ACCESS,
    *EVENTS,
    *COMMANDS,
    *LISTS,
    *EFFECTS,
    *DRIVING,
    *CELL_COMMANDS,
    *ARMS,
    *STILL_IMAGES,
    *PROFILE_SERVICES,
    *CLOCK_STIMULI,
    *SENSORS,
    *LIMITS,
    _one(SetEmergency(STOP)),
    _one(ClearEmergency(STOP)),
    *(_one(QueryIdentification(level), f"level {level}", query_type=level) for level in (1, 2, 3, 4)),
    *(_one(QueryConfiguration(level), f"level {level}") for level in (2, 3)),
    _one(ALL_SERVICES, "everything"),
)
"""Inputs with specific content. Other inputs are sent as neutral messages, queries with all and no presence bits."""

INTERNAL_EVENTS: Final[tuple[Stimulus, ...]] = (SILENT_CLIENT, NOT_RENEWED, DUE, EXPIRED)
"""Internal events that can be caused from outside."""
INTERNAL_EVENTS_1_0: Final = (replace(SILENT_CLIENT, message="Timeout"), DUE)
"""Internal events of version 1.0, where Timeout ends control, not an event."""
ACCESS_CONTROL_1_0: Final = ("urn:jaus:jss:core:AccessControl", "1.0")


ENDS_LATER: Final = "it would end the component, which the steps of the newer version do at the end"
TRANSPORT_1_0: Final = (TRANSPORT, "1.0")
STANDARD: Final = "urn:jaus:jss:"
OWN: Final = "urn:jauspy:"
"""Beginning of the ids of services that only jauspy defines."""
ROLE_NOTE: Final = (
    f"the controller is {CLIENTS[CONTROLLER]}, which takes control; the other client {CLIENTS[OTHER_CLIENT]}, which "
    f"does not have it; the emergency client {CLIENTS[EMERGENCY_CLIENT]}, which sets emergencies; and the observer "
    f"{CLIENTS[OBSERVER]}, which only sends queries"
)
PREFIX: Final = ("Receiving", "Ready")
"""States that contain all others; omitted in names."""


def profile_of(name: str, title: str, set_name: str, version: str) -> Profile:
    """The profile for the services of one set, such as `core` 1.1, and for older versions of them that a target has.

    Each service is tested by the definition of the offered version.
    """

    def steps(offers: Offers) -> Sequence[Step]:
        found = offers.with_any(_services(set_name, version))
        if not found:
            raise ConfigError(
                f"the target offers no service of {set_name} {version} or older, so nothing was tested; "
                f"it offers {_offered_text(offers)}"
            )
        return _planned(found, offers, registry)

    return Profile(name, title, steps, (ROLE_NOTE,), check=_check_start)


def service_profile(urn: str, messages: Registry) -> Profile:
    """The profile for one service, which may be one of the user's own definitions.

    Raises `ConfigError` if the service is not defined.
    """
    known_keys = {(entry.service, entry.version) for entry in messages.entries}
    known_keys |= {service.key for service in load_builtin().services}  # some have no messages
    keys = frozenset(key for key in known_keys if key[0] == urn)
    if not keys:
        urns = sorted({message.service for message in messages.own}) if messages.schema else []
        known = f"; the files define {', '.join(urns)}" if urns else "; `--schemas FILE` reads your own definitions"
        raise ConfigError(f"no definition of {urn} is known{known}")

    def steps(offers: Offers) -> Sequence[Step]:
        found = offers.with_any(keys)
        if not found:
            versions = " and ".join(sorted(version for _, version in keys))
            raise ConfigError(
                f"the target does not offer {urn} {versions}, so nothing was tested; it offers {_offered_text(offers)}"
            )
        return _planned(found, offers, messages)

    return Profile(urn, f"{urn}: every transition", steps, (ROLE_NOTE,), check=_check_start)


def _offered_text(offers: Offers) -> str:
    offered = sorted(
        f"{urn.removeprefix(STANDARD)} {version}" for urn, version in set().union(*offers.components.values())
    )
    return ", ".join(offered) or "nothing"


def _planned(found: Mapping[JausID, frozenset[ServiceKey]], offers: Offers, messages: Registry) -> list[Step]:
    """The steps for these services of each component."""
    planned: list[Step] = []
    for id, services in found.items():
        for label, offered in _generations(offers.components[id], messages).items():
            prefix = "/".join((str(id),) * (len(found) > 1) + (label,) * bool(label))
            tested = services & offered
            planner = Planner(component_under_test(id, offered, messages), tested, may_end=not label)
            steps = (*table_steps(id, offered, tested), *planner.steps())
            planned += (replace(step, id=f"{prefix}/{step.id}") if prefix else step for step in steps)
    return planned


def _check_start(tester: Tester, offers: Offers) -> None:
    """Raise `ConfigError` if a component was shut down, as at the end of an earlier test, which it cannot leave."""
    down = []
    for id, services in offers.components.items():
        if any(urn == MANAGEMENT for urn, _ in services) and tester.target.matches(id):
            with suppress(StepOutcome):  # the first step tells what is wrong
                report = tester.client(CLIENTS[OBSERVER]).ask(QueryStatus(), ReportStatus, to=id)
                down += [str(id)] if report.status == ReportStatus.Status.SHUTDOWN else []
    if down:
        raise ConfigError(
            f"{', '.join(down)} {'are' if len(down) > 1 else 'is'} shut down, as at the end of a test of core "
            "services: restart the robot before the next test"
        )


def _generations(offered: frozenset[ServiceKey], messages: Registry) -> dict[str, frozenset[ServiceKey]]:
    """The services of a component by the version of the core services that they inherit from.

    A component may offer version 1.0 of its services beside the newer ones: then each version is tested separately, the
    older one under the label `1.0`.
    """
    older = offered & _inheriting_from(TRANSPORT_1_0, messages)
    newer = offered - older
    if not older or (TRANSPORT, "1.1") not in newer:
        return {"": offered}
    return {"1.0": older, "": newer}


@cache
def _inheriting_from(root: ServiceKey, messages: Registry) -> frozenset[ServiceKey]:
    """The known services that inherit from a service, and the service itself."""
    services = (*load_builtin().services, *(messages.schema.services if messages.schema else ()))
    parent_of = parents_among(services)
    return frozenset(service.key for service in services if lineage(service, parent_of)[-1].key == root)


def _services(set_name: str, newest: str) -> frozenset[ServiceKey]:
    limit = _number(newest)
    names = tuple(f"{prefix}{set_name}:" for prefix in (STANDARD, OWN))
    return frozenset((urn, v) for urn, v in _built_in_keys() if urn.startswith(names) and _number(v) <= limit)


def _is_built_in(service: ServiceKey) -> bool:
    return service in _built_in_keys()


@cache
def _built_in_keys() -> frozenset[ServiceKey]:
    return frozenset((entry.service, entry.version) for entry in registry.entries)


def _number(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


@dataclass(frozen=True)
class Planner:
    """Steps for one component; `services` are those whose inputs are tested."""

    subject: ComponentUnderTest
    services: frozenset[ServiceKey]
    may_end: bool = True
    """False if steps that end the component are skipped, as other steps do that at the end."""

    def steps(self) -> list[Step]:
        """All steps: states that can be left come first, steps that end the component last."""
        routes = Routes(self.subject.machine, self._own_commands())
        paths = routes.paths()
        ends = {situation for situation in paths if not routes.returns(situation)}
        lasting = [path for path in paths if path not in ends]
        tests = [test for situation in lasting for test in self._state_tests(situation, paths[situation])]
        fatal = [test for test in tests if any(prediction.after in ends for prediction in test.predictions)]
        steps = [_step(test) for test in tests if test not in fatal]
        if not self.may_end:
            steps += [replace(_step(test), run=skip(ENDS_LATER)) for test in fatal]
            return [*steps, *untried(self.subject, self.services, steps, paths)]
        steps += [_skipped(_step(test), _step(fatal[-1])) for test in fatal[:-1]]
        steps += [_step(test) for test in fatal[-1:]]
        if fatal:
            steps += [_step(test) for end in sorted(ends, key=str) for test in self._state_tests(end, paths[end])]
        return [*steps, *untried(self.subject, self.services, steps, paths)]

    def _own_commands(self) -> tuple[str, ...]:
        """Commands of services that are not built in: only they lead to the states of these services."""
        definitions = [
            definition
            for definition in self.subject.definitions
            if definition.key in self.services and not _is_built_in(definition.key)
        ]
        names = [message.name for definition in definitions for message in definition.inputs]
        return tuple(name for name in names if self.subject.kind(name).IS_COMMAND)

    def _state_tests(self, situation: Situation, path: Path) -> Iterator[StateTest]:
        for stimulus in (*self._stimuli(), *self._spontaneous()):
            if stimulus.fits(situation) and (not stimulus.once or situation == self.subject.machine.start):
                for role in self._roles(stimulus, situation):
                    yield StateTest(self.subject, situation, path, stimulus, role)

    def _stimuli(self) -> Iterator[Stimulus]:
        """Each input of the services, in all its variants."""
        definitions = [definition for definition in self.subject.definitions if definition.key in self.services]
        names = [message.name for definition in definitions for message in definition.inputs]
        names += [rule.trigger for rule in self.subject.machine.rules if rule.is_input and rule.owner in definitions]
        for name in dict.fromkeys(names):
            yield from self._variants(name)

    def _variants(self, name: str) -> Iterable[Stimulus]:
        kind = self.subject.kind(name)
        known = [stimulus for stimulus in STIMULI if stimulus.message == name and kind.SERVICE.startswith(stimulus.of)]
        if known and _is_built_in((kind.SERVICE, kind.VERSION)):
            return known
        if not presence_fields(kind):
            return [Stimulus(name, lambda _: neutral(kind))]
        report: type[Message] | None = getattr(kind, "REPORT", None)
        return sample_messages.variants(kind, report) if report else [Stimulus(name, lambda _: neutral(kind))]

    def _spontaneous(self) -> Iterator[Stimulus]:
        """Internal events of these services that can be caused from outside."""
        awaited = {rule.trigger for rule in self.subject.machine.rules if rule.owner.key in self.services}
        events = INTERNAL_EVENTS_1_0 if ACCESS_CONTROL_1_0 in self.subject.keys else INTERNAL_EVENTS
        yield from (event for event in events if event.message in awaited)

    def _roles(self, stimulus: Stimulus, situation: Situation) -> tuple[str, ...]:
        """The roles of senders that the guards distinguish."""
        if stimulus.by_controller:
            return (CONTROLLER,)
        if stimulus.make is None:
            return (OTHER_CLIENT,)
        asked = {
            call.name.rpartition(".")[2]
            for rule in self.subject.machine.rules
            if rule.trigger == stimulus.message and rule.transition.guard.strip()
            for call in behavior.calls(behavior.parse(rule.transition.guard))
        }
        if asked & EMERGENCY_PREDICATES:
            return (EMERGENCY_CLIENT, CONTROLLER)
        return (CONTROLLER, OTHER_CLIENT) if asked & SENDER_PREDICATES and situation.controller else (OTHER_CLIENT,)


def _step(test: StateTest) -> Step:
    state = ".".join(test.situation.state[len(PREFIX) :]) or "Ready"
    stimulus = test.stimulus
    variant = f", {stimulus.variant}" if stimulus.variant else ""
    parts = [state, stimulus.message, test.role, stimulus.variant]
    id = "/".join(part.replace(" ", "-") for part in parts if part)
    title = f"{stimulus.message} from the {test.role}{variant}"
    return Step(id, title, test, moves=_moves(test), transitions=test.transitions)


def _moves(test: StateTest) -> bool:
    """True if the step may cause motion: in Ready, by any command that is not of a core service, also on the way."""
    if any(message not in STEERING_INPUTS for message in test.path):
        return True
    if not set(test.situation.state[len(PREFIX) :]) >= {"Controlled", "Ready"}:
        return False
    if test.stimulus.moves or test.stimulus.make is None:
        return test.stimulus.moves
    kind = test.subject.kind(test.stimulus.message)
    return kind.IS_COMMAND and ":core:" not in kind.SERVICE


def _skipped(step: Step, instead: Step) -> Step:
    return replace(step, run=skip(f"it would end the component; {instead.id} is run, at the end"))


CORE: Final = profile_of("core-1.1", "core services 1.1: every transition; shuts the target down", "core", "1.1")
MOBILITY: Final = profile_of("mobility-1.1", "mobility services 1.1: every transition", "mobility", "1.1")
MANIPULATOR: Final = profile_of("manipulator-2.0", "manipulator services 2.0: every transition", "manipulator", "2.0")
SENSING: Final = profile_of(
    "sensing-2.0", "environment sensing services 2.0: every transition", "environmentSensing", "2.0"
)
CELL: Final = profile_of("cell-1.0", "jauspy's own services of a factory cell: every transition", "cell", "1.0")
UGV: Final = profile_of("ugv-1.0", "UGV services 1.0: every transition", "ugv", "1.0")
