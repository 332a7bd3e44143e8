"""Every step for the services that a target offers: each reachable state, each input, each sender that matters."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.codec.base import Message, Struct
from jauspy.conformance.checks import Check, that
from jauspy.conformance.offers import Offers, ServiceKey
from jauspy.conformance.outcome import Skipped
from jauspy.conformance.profile import Profile, Step
from jauspy.conformance.tester import Tester
from jauspy.conformance.walk.machine import Machine, Situation
from jauspy.conformance.walk.neutral import neutral, presence_fields
from jauspy.conformance.walk.recipes import RECIPES, SPONTANEOUS
from jauspy.conformance.walk.stimulus import SENDER, SETTER, Stimulus
from jauspy.conformance.walk.trial import Subject, Trial
from jauspy.conformance.walk.walker import MEDIC, PILOT, RIVAL, STEERING
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.schema import guards, model
from jauspy.schema.needed import load_needed

TRANSPORT: Final = "urn:jaus:jss:core:Transport"
"""Has no messages, and so is not in the registry."""
PREFIX: Final = ("Receiving", "Ready")
"""What every state is inside of; left out of names."""
EVERYTHING: Final = -1

Path = tuple[tuple[str, str], ...]


def profile_of(name: str, title: str, set_name: str, version: str) -> Profile:
    """The profile for the services of one set, such as `core` 1.1."""

    def steps(offers: Offers) -> Sequence[Step]:
        wanted = _services(set_name, version)
        found = offers.with_any(wanted)
        if not found:
            there = sorted({f"{urn} {v}" for each in offers.components.values() for urn, v in each})
            raise ConfigError(
                f"the target offers no service of {set_name} {version}, so nothing was tested; "
                f"it offers {', '.join(there) or 'nothing'}"
            )
        prefix = len(found) > 1
        return [
            replace(step, id=f"{id}/{step.id}") if prefix else step
            for id, services in found.items()
            for step in Planner(subject_of(id, offers.components[id]), services).steps()
        ]

    return Profile(name, title, steps)


def _services(set_name: str, version: str) -> frozenset[ServiceKey]:
    keys = {(each.service, each.version) for each in registry.entries}
    return frozenset((urn, v) for urn, v in keys if v == version and urn.startswith(f"urn:jaus:jss:{set_name}:"))


def subject_of(id: JausID, offered: frozenset[ServiceKey]) -> Subject:
    """The component with everything known that it offers, most derived first."""
    known = {(each.service, each.version) for each in registry.entries} | {(TRANSPORT, "1.0"), (TRANSPORT, "1.1")}
    schema = load_needed(frozenset(offered & known))
    found: dict[str, tuple[int, model.Service]] = {}
    for urn, version in sorted(offered & known):
        line = list(_line(schema, schema.service(urn, version)))
        for depth, each in enumerate(reversed(line)):
            found.setdefault(each.id, (depth, each))
    ordered = tuple(each for _, each in sorted(found.values(), key=lambda pair: -pair[0]))
    return Subject(id, ordered, Machine(ordered), registry)


def _line(schema: model.Schema, definition: model.Service) -> Iterator[model.Service]:
    while True:
        yield definition
        if definition.inherits_from is None:
            return
        definition = schema.service(*definition.inherits_from.key)


@dataclass(frozen=True)
class Planner:
    """Steps for one component; `services` are the ones whose inputs are tried."""

    subject: Subject
    services: frozenset[ServiceKey]

    def steps(self) -> list[Step]:
        """States that can be left again come first; what ends the component comes last."""
        ways = self._ways()
        ends = {situation for situation in ways if not self._returns(situation)}
        lasting = [each for each in ways if each not in ends]
        trials = [trial for situation in lasting for trial in self._trials(situation, ways[situation])]
        fatal = [trial for trial in trials if any(each.after in ends for each in trial.predictions)]
        steps = [_step(trial) for trial in trials if trial not in fatal]
        steps += [_skipped(_step(trial), _step(fatal[-1])) for trial in fatal[:-1]]
        steps += [_step(trial) for trial in fatal[-1:]]
        if fatal:
            steps += [_step(trial) for end in sorted(ends, key=str) for trial in self._trials(end, ways[end])]
        return [*steps, *self._internal()]

    def _ways(self) -> dict[Situation, Path]:
        """One situation for each state that can be reached, and the inputs that lead there."""
        machine = self.subject.machine
        found: dict[Situation, Path] = {machine.start: ()}
        waiting: deque[tuple[Situation, Path]] = deque([(machine.start, ())])
        states = {machine.start.state}
        while waiting:
            situation, path = waiting.popleft()
            for after, step in self._moves(situation):
                if after.state not in states:
                    states.add(after.state)
                    found[after] = (*path, step)
                    waiting.append((after, (*path, step)))
        return found

    def _moves(self, situation: Situation) -> Iterator[tuple[Situation, tuple[str, str]]]:
        for message, role in STEERING:
            stimulus = _STEERED.get(message) or Stimulus(message, None)
            (first, *others) = self.subject.machine.predict(situation, message, role, stimulus.judge(role))
            after = self._settled(first.after)
            if not others and after != situation:
                yield after, (message, role)

    def _settled(self, situation: Situation) -> Situation:
        """Initialization is over by itself."""
        done = Stimulus("Initialized", None)
        (first, *_) = self.subject.machine.predict(situation, done.message, "", done.judge(""))
        return first.after

    def _returns(self, situation: Situation) -> bool:
        """True when inputs lead from there to the start."""
        seen, waiting = {situation}, [situation]
        while waiting:
            here = waiting.pop()
            if here == self.subject.machine.start:
                return True
            for after, _ in self._moves(here):
                if after not in seen:
                    seen.add(after)
                    waiting.append(after)
        return False

    def _trials(self, situation: Situation, path: Path) -> Iterator[Trial]:
        for stimulus in (*self._stimuli(), *self._spontaneous(situation)):
            if not stimulus.by_controller or situation.controller:
                for role in self._roles(stimulus, situation):
                    yield Trial(self.subject, situation, path, stimulus, role)

    def _stimuli(self) -> Iterator[Stimulus]:
        """Each input of the services, in all variants that matter."""
        done: set[str] = set()
        for definition in self.subject.definitions:
            if definition.key in self.services:
                for message in definition.inputs:
                    if message.name not in done:
                        done.add(message.name)
                        yield from self._variants(message.name)

    def _variants(self, name: str) -> Iterable[Stimulus]:
        known = [each for each in RECIPES if each.message == name]
        if known:
            return known
        kind = self.subject.kind(name)
        vectors = presence_fields(kind)
        if not vectors:
            return [Stimulus(name, lambda _: neutral(kind))]
        report = name.replace("Query", "Report", 1)
        return [
            Stimulus(name, lambda _, asked=asked: neutral(kind, asks_for=asked), variant, checks={report: checks})  # type: ignore[misc]  # a bound loop variable
            for variant, asked, checks in (("all fields", EVERYTHING, ()), ("no fields", 0, (no_fields(vectors),)))
        ]

    def _spontaneous(self, situation: Situation) -> Iterator[Stimulus]:
        """Internal events of these services that can be brought about; those of a minute only once."""
        for name in self._events():
            if name == "Timeout" and situation != self.subject.machine.start:
                continue
            if name in SPONTANEOUS and (name != "Timedout" or situation.controller):
                yield SPONTANEOUS[name]

    def _events(self) -> list[str]:
        """The internal events that the transitions of these services wait for."""
        names = [
            transition.trigger.rpartition(".")[2]
            for definition in self.subject.definitions
            if definition.key in self.services
            for transition in _transitions(definition)
        ]
        internal = dict.fromkeys(name for name in names if name not in ("Receive", *SENDING))
        return list(internal)

    def _internal(self) -> Iterator[Step]:
        """What only the inside of the component can bring about is listed, and not tried."""
        for name in self._events():
            if name not in SPONTANEOUS and name != "Initialized":
                reason = f"{name} comes from inside of the component, and cannot be brought about from outside"
                yield Step(f"internal/{name}", f"the internal event {name}", _skip(reason))

    def _roles(self, stimulus: Stimulus, situation: Situation) -> tuple[str, ...]:
        """The senders that the guards distinguish."""
        if stimulus.make is None:
            return (PILOT,) if stimulus.message == "Timedout" else (RIVAL,)
        asked = {
            call.name.rpartition(".")[2]
            for _, transition in self.subject.machine.rules()
            if transition.parameters and transition.parameters[0].type == stimulus.message and transition.guard.strip()
            for call in guards.calls(guards.parse(transition.guard))
        }
        if stimulus.by_controller:
            return (PILOT,)
        if asked & SETTER:
            return (MEDIC, PILOT)
        return (PILOT, RIVAL) if asked & SENDER and situation.controller else (RIVAL,)


SENDING: Final = ("Send", "BroadcastLocal", "BroadcastGlobal")
"""Events of the machine that sends, which every other step is about."""


def no_fields(vectors: Iterable[str]) -> Check:
    """Nothing in the parts of the report that these presence vectors of the query are about; all were zero."""
    names = [vector.removesuffix("presence_vector").rstrip("_") for vector in vectors]

    def is_bare(report: Message) -> bool:
        parts = [getattr(report, name, None) if name else report for name in names]
        return not any(
            getattr(part, slot.name) is not None
            for part in parts
            if isinstance(part, Struct)
            for slot in getattr(part.layout(), "slots", ())
            if slot.optional
        )

    return that("carries no field that was not asked for", is_bare)


_STEERED: Final = {
    each.message: each for each in RECIPES if (each.message, each.variant) == ("RequestControl", "the same authority")
}


def _transitions(definition: model.Service) -> Iterator[model.Transition]:
    waiting = [
        state for machine in (definition.behavior.machines if definition.behavior else ()) for state in machine.states
    ]
    while waiting:
        state = waiting.pop(0)
        waiting += state.states
        yield from (*state.transitions, *state.default_transitions)


def _step(trial: Trial) -> Step:
    state = ".".join(trial.situation.state[len(PREFIX) :]) or "Ready"
    stimulus = trial.stimulus
    variant = f", {stimulus.variant}" if stimulus.variant else ""
    parts = [state, stimulus.message, trial.role, stimulus.variant]
    id = "/".join(part.replace(" ", "-") for part in parts if part)
    return Step(id, f"{stimulus.message} from the {trial.role}{variant}", trial, moves=_moves(trial))


def _moves(trial: Trial) -> bool:
    """A command in Ready may make something move, however harmless it is; those of the core services do not."""
    if trial.stimulus.make is None or not set(trial.situation.state[len(PREFIX) :]) >= {"Controlled", "Ready"}:
        return False
    kind = trial.subject.kind(trial.stimulus.message)
    return kind.IS_COMMAND and ":core:" not in kind.SERVICE


def _skipped(step: Step, instead: Step) -> Step:
    return replace(step, run=_skip(f"it would end the component; {instead.id} is tried, at the end"))


def _skip(reason: str) -> Callable[[Tester], None]:
    def action(tester: Tester) -> None:  # noqa: ARG001 - nothing is tried
        raise Skipped(reason)

    return action
