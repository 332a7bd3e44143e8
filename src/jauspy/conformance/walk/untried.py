"""Transitions that no step brings about: each is listed, and skipped with the reason."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from itertools import groupby

from jauspy.conformance.offers import ServiceKey
from jauspy.conformance.profile import Step
from jauspy.conformance.results import Skipped
from jauspy.conformance.tester import Tester
from jauspy.conformance.walk.behaviour import Machine, Prediction, Rule, Situation, Subject


def untried(
    subject: Subject, services: Collection[ServiceKey], steps: Iterable[Step], situations: Collection[Situation]
) -> Iterator[Step]:
    """A step for each trigger and state; `services` are those whose transitions are of interest."""
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


def _id(rule: Rule) -> str:
    return f"untried/{'.'.join(rule.node.path[2:]) or 'Ready'}/{rule.trigger}"


def _reason(machine: Machine, rule: Rule, situations: Collection[Situation]) -> str:
    inside = [each for each in situations if each.state[: len(rule.node.path)] == rule.node.path]
    if not inside:
        return f"no input leads to {rule.node}"
    if not any(rule.name == each.rule for here in inside for each in _outcomes(machine, here, rule.trigger)):
        return f"{rule.trigger} never gets that far: an inner state takes it first"
    if rule.is_input:
        return f"no {rule.trigger} is known of which this holds: {rule.transition.guard}"
    return f"{rule.trigger} comes from inside of the component, and cannot be brought about there from outside"


def _outcomes(machine: Machine, situation: Situation, trigger: str) -> Iterable[Prediction]:
    return machine.predict(situation, trigger, "", lambda *_: None)


def skip(reason: str) -> Callable[[Tester], None]:
    """An action that is not tried."""

    def action(tester: Tester) -> None:  # noqa: ARG001 - nothing is tried
        raise Skipped(reason)

    return action
