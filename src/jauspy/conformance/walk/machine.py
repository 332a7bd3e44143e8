"""What the JSIDL says that a component does: a merged state machine, and predictions from it.

The semantics are those of ADR 3. Predicates that only the component can know are undecided, and then several outcomes
are right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, TypeAlias

from jauspy.schema import guards, model
from jauspy.services.tree import Owned, StateNode, merge, start_of

MACHINE: Final = "ReceiveFSM"

Truth: TypeAlias = bool | None
"""None: not known from outside."""


@dataclass(frozen=True, slots=True)
class Situation:
    """What the tester knows about the component: its state, what waits to be popped, and who did what."""

    state: tuple[str, ...]
    pushed: tuple[tuple[str, ...], ...] = ()
    controller: str | None = None
    """The role of the client in control."""
    emergencies: frozenset[str] = frozenset()
    """The roles that have set an emergency."""

    def __str__(self) -> str:
        return ".".join(self.state)


@dataclass(frozen=True, slots=True)
class Output:
    """A message that the JSIDL sends: its name, the code it is given, and the role it goes to."""

    message: str
    code: str
    to: str


@dataclass(frozen=True, slots=True)
class Prediction:
    """One right outcome; `rule` says which transition, empty for an input that is ignored."""

    outputs: tuple[Output, ...]
    after: Situation
    rule: str = ""
    acts: bool = False
    """The transition has actions: it does more than swallow the input."""


Judge: TypeAlias = Callable[[guards.Call, Situation], Truth]
"""Decides a predicate for the input that is looked at."""


class Machine:
    """The merged machine of some definitions, most derived first."""

    def __init__(self, definitions: Sequence[model.Service]) -> None:
        self.root = merge(list(definitions))[MACHINE]
        self._outputs = {message.name for each in definitions for message in each.outputs}
        self.start = Situation(start_of(self.root, MACHINE, list(definitions)).path)

    def rules(self) -> Iterator[tuple[str, model.Transition]]:
        """Every transition with its name."""
        for node in self.root.all():
            for owned in (*node.transitions, *node.defaults):
                yield rule_name(owned, node), owned.item

    def predict(self, situation: Situation, trigger: str, role: str, judge: Judge) -> tuple[Prediction, ...]:
        """All right outcomes of an input: a message name or that of an internal event."""
        found: list[Prediction] = []
        for node, owned in self._in_order(situation):
            if not _fits(owned.item, trigger):
                continue
            truth = _truth(owned.item.guard, situation, judge)
            if truth is False:
                continue
            found.append(self._apply(owned, node, situation, role))
            if truth:
                return tuple(found)
        return (*found, Prediction((), situation))

    def _in_order(self, situation: Situation) -> Iterator[tuple[StateNode, Owned[model.Transition]]]:
        active = self._node(situation.state)
        for node in active.upwards():
            first, second = node.transitions, node.defaults
            for owned in (*first, *second) if node is active else (*second, *first):
                yield node, owned

    def _node(self, path: Iterable[str]) -> StateNode:
        node = self.root
        for name in path:
            node = node.children[name]
        return node

    def _apply(self, owned: Owned[model.Transition], node: StateNode, before: Situation, role: str) -> Prediction:
        outputs: list[Output] = []
        after = before
        for action in owned.item.actions:
            sent = self._sent(action, role, after.controller if _is_message(owned.item) else role)
            if sent is not None:
                outputs.append(sent)
            after = _effect(action.name, after, role)
        moved = self._moved(owned.item, after)
        return Prediction(tuple(outputs), moved, rule_name(owned, node), bool(owned.item.actions))

    def _sent(self, action: model.Action, role: str, controller: str | None) -> Output | None:
        """`Send('Message', 'CODE', transportData)`, or an action that is called `sendMessage`."""
        arguments = [argument.strip("'\" ") for argument in action.arguments]
        to = role if "transportData" in arguments else controller or role
        name = action.name.rpartition(".")[2]
        if name == "Send":
            literals = [text.strip("'\" ") for text in action.arguments if text.strip()[:1] in ("'", '"')]
            message, *codes = [text for text in literals if text != "transportData"]
            return Output(message, codes[0] if codes else "", to)
        if name.startswith("send"):
            known = [each for each in self._outputs if name[4:].startswith(each)]
            return Output(max(known, key=len), "", to) if known else None
        return None

    def _moved(self, transition: model.Transition, situation: Situation) -> Situation:
        if transition.kind == "pop":
            if situation.emergencies or not situation.pushed:
                return situation
            *rest, target = situation.pushed
            return self._entered(replace(situation, pushed=tuple(rest)), target)
        end = self.root.find(transition.end_state) if transition.end_state else None
        if transition.kind == "internal" or end is None:
            return situation
        if transition.kind == "push":
            if end.contains(self._node(situation.state)):
                return situation
            situation = replace(situation, pushed=(*situation.pushed, situation.state))
        return self._entered(situation, end.leaf().path)

    def _entered(self, situation: Situation, path: tuple[str, ...]) -> Situation:
        """In a state that was entered; entry actions of what was outside of it before take effect."""
        inside = situation.state
        common = next((n for n, (a, b) in enumerate(zip(inside, path, strict=False)) if a != b), len(path))
        for depth in range(common, len(path)):
            for owned in self._node(path[: depth + 1]).entry:
                situation = _effect(owned.item.name, situation, "")
        return replace(situation, state=path)


def rule_name(owned: Owned[model.Transition], node: StateNode) -> str:
    """`Management, Receiving.Ready: SetEmergency [guard]`."""
    transition = owned.item
    what = transition.parameters[0].type if transition.parameters else transition.trigger.rpartition(".")[2]
    guard = f" [{transition.guard}]" if transition.guard.strip() else ""
    return f"{owned.owner.name}, {node}: {what}{guard}"


def _fits(transition: model.Transition, trigger: str) -> bool:
    event = transition.trigger.rpartition(".")[2]
    if event == "Receive" and transition.parameters:
        return transition.parameters[0].type == trigger
    return event == trigger


def _is_message(transition: model.Transition) -> bool:
    return transition.trigger.rpartition(".")[2] == "Receive"


def _truth(text: str, situation: Situation, judge: Judge) -> Truth:
    return _evaluate(guards.parse(text), situation, judge) if text.strip() else True


def _evaluate(guard: guards.Guard, situation: Situation, judge: Judge) -> Truth:
    match guard:
        case guards.Call():
            return judge(guard, situation)
        case guards.Not(operand):
            inner = _evaluate(operand, situation, judge)
            return None if inner is None else not inner
        case guards.And(operands):
            parts = [_evaluate(each, situation, judge) for each in operands]
            return False if False in parts else None if None in parts else True
        case guards.Or(operands):
            parts = [_evaluate(each, situation, judge) for each in operands]
            return True if True in parts else None if None in parts else False


def _effect(action: str, situation: Situation, role: str) -> Situation:
    """What the actions of the core services change that the tester can know."""
    match action.rpartition(".")[2].lower():
        case "storeaddress":
            return replace(situation, controller=role)
        case "init":
            return replace(situation, controller=None)
        case "storeid":
            return replace(situation, emergencies=situation.emergencies | {role})
        case "deleteid":
            return replace(situation, emergencies=situation.emergencies - {role})
        case _:
            return situation
