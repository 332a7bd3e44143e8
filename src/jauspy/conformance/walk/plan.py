"""Every step for the services that a target offers: each reachable state, each input, each sender that matters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

from jauspy.conformance.offers import Offers, ServiceKey
from jauspy.conformance.profile import Profile, Step
from jauspy.conformance.walk import sample_messages
from jauspy.conformance.walk.behaviour import Situation, Subject, subject_of
from jauspy.conformance.walk.explorer import CLIENTS, MEDIC, OBSERVER, PILOT, RIVAL, SENDER, SETTER, Stimulus
from jauspy.conformance.walk.recipes import RECIPES, SPONTANEOUS
from jauspy.conformance.walk.routes import Path, Routes
from jauspy.conformance.walk.sample_messages import neutral, presence_fields
from jauspy.conformance.walk.trial import Trial
from jauspy.conformance.walk.untried import skip, untried
from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.schema import guards

STANDARD: Final = "urn:jaus:jss:"
ROLES: Final = (
    f"{PILOT} is {CLIENTS[PILOT]}, who takes control; {RIVAL} {CLIENTS[RIVAL]}, who does not have it; "
    f"{MEDIC} {CLIENTS[MEDIC]}, who sets emergencies; {OBSERVER} {CLIENTS[OBSERVER]}, who only asks"
)
PREFIX: Final = ("Receiving", "Ready")
"""What every state is inside of; left out of names."""


def profile_of(name: str, title: str, set_name: str, version: str) -> Profile:
    """The profile for the services of one set, such as `core` 1.1."""

    def steps(offers: Offers) -> Sequence[Step]:
        wanted = _services(set_name, version)
        found = offers.with_any(wanted)
        if not found:
            there = sorted(f"{urn.removeprefix(STANDARD)} {v}" for urn, v in set().union(*offers.components.values()))
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

    return Profile(name, title, steps, (ROLES,))


def _services(set_name: str, version: str) -> frozenset[ServiceKey]:
    keys = {(each.service, each.version) for each in registry.entries}
    return frozenset((urn, v) for urn, v in keys if v == version and urn.startswith(f"urn:jaus:jss:{set_name}:"))


@dataclass(frozen=True)
class Planner:
    """Steps for one component; `services` are the ones whose inputs are tried."""

    subject: Subject
    services: frozenset[ServiceKey]

    def steps(self) -> list[Step]:
        """States that can be left again come first; what ends the component comes last."""
        routes = Routes(self.subject.machine)
        ways = routes.ways()
        ends = {situation for situation in ways if not routes.returns(situation)}
        lasting = [each for each in ways if each not in ends]
        trials = [trial for situation in lasting for trial in self._trials(situation, ways[situation])]
        fatal = [trial for trial in trials if any(each.after in ends for each in trial.predictions)]
        steps = [_step(trial) for trial in trials if trial not in fatal]
        steps += [_skipped(_step(trial), _step(fatal[-1])) for trial in fatal[:-1]]
        steps += [_step(trial) for trial in fatal[-1:]]
        if fatal:
            steps += [_step(trial) for end in sorted(ends, key=str) for trial in self._trials(end, ways[end])]
        return [*steps, *untried(self.subject, self.services, steps, ways)]

    def _trials(self, situation: Situation, path: Path) -> Iterator[Trial]:
        for stimulus in (*self._stimuli(), *self._spontaneous()):
            if stimulus.fits(situation) and (not stimulus.once or situation == self.subject.machine.start):
                for role in self._roles(stimulus, situation):
                    yield Trial(self.subject, situation, path, stimulus, role)

    def _stimuli(self) -> Iterator[Stimulus]:
        """Each input of the services, in all variants that matter."""
        mine = [each for each in self.subject.definitions if each.key in self.services]
        names = [message.name for definition in mine for message in definition.inputs]
        names += [rule.trigger for rule in self.subject.machine.rules if rule.is_input and rule.owner in mine]
        for name in dict.fromkeys(names):
            yield from self._variants(name)

    def _variants(self, name: str) -> Iterable[Stimulus]:
        kind = self.subject.kind(name)
        known = [each for each in RECIPES if each.message == name and kind.SERVICE.startswith(each.of)]
        if known:
            return known
        if not presence_fields(kind):
            return [Stimulus(name, lambda _: neutral(kind))]
        return sample_messages.variants(kind, self.subject.kind(name.replace("Query", "Report", 1)))

    def _spontaneous(self) -> Iterator[Stimulus]:
        """Internal events of these services that can be brought about."""
        awaited = {rule.trigger for rule in self.subject.machine.rules if rule.owner.key in self.services}
        yield from (each for each in SPONTANEOUS if each.message in awaited)

    def _roles(self, stimulus: Stimulus, situation: Situation) -> tuple[str, ...]:
        """The senders that the guards distinguish."""
        if stimulus.by_controller:
            return (PILOT,)
        if stimulus.make is None:
            return (RIVAL,)
        asked = {
            call.name.rpartition(".")[2]
            for rule in self.subject.machine.rules
            if rule.trigger == stimulus.message and rule.transition.guard.strip()
            for call in guards.calls(guards.parse(rule.transition.guard))
        }
        if asked & SETTER:
            return (MEDIC, PILOT)
        return (PILOT, RIVAL) if asked & SENDER and situation.controller else (RIVAL,)


def _step(trial: Trial) -> Step:
    state = ".".join(trial.situation.state[len(PREFIX) :]) or "Ready"
    stimulus = trial.stimulus
    variant = f", {stimulus.variant}" if stimulus.variant else ""
    parts = [state, stimulus.message, trial.role, stimulus.variant]
    id = "/".join(part.replace(" ", "-") for part in parts if part)
    title = f"{stimulus.message} from the {trial.role}{variant}"
    return Step(id, title, trial, moves=_moves(trial), transitions=trial.transitions)


def _moves(trial: Trial) -> bool:
    """A command in Ready may make something move, however harmless it is; those of the core services do not."""
    if not set(trial.situation.state[len(PREFIX) :]) >= {"Controlled", "Ready"}:
        return False
    if trial.stimulus.moves or trial.stimulus.make is None:
        return trial.stimulus.moves
    kind = trial.subject.kind(trial.stimulus.message)
    return kind.IS_COMMAND and ":core:" not in kind.SERVICE


def _skipped(step: Step, instead: Step) -> Step:
    return replace(step, run=skip(f"it would end the component; {instead.id} is tried, at the end"))
