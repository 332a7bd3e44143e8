"""Predictions from the merged state machine of a component: the outputs of an input, and the next state.

The semantics are those of ADR 3. The tester cannot decide every predicate; if one is undecided, several outcomes are
right.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import Final, NamedTuple, TypeAlias

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.conformance.profile import ServiceKey
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.schema import behavior, model
from jauspy.schema.inheritance import most_derived_first, parents_among
from jauspy.schema.loader import load_needed
from jauspy.schema.state_tree import MergedState, Owned, merge_machines

RECEIVE_MACHINE: Final = "ReceiveFSM"
INITIALIZED: Final = "Initialized"
"""The internal event of Management that ends initialization."""
RECEIVE_TRIGGER: Final = "Receive"
"""The internal event of Transport for a received message."""

TruthValue: TypeAlias = bool | None
"""None: cannot be known from outside."""


@dataclass(frozen=True, slots=True)
class Situation:
    """The known state of the component, with the pushed states, the controller and the emergencies."""

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
    """A message that the JSIDL sends: its name, its code argument, and the role of the receiver."""

    message: str
    code: str
    to: str


@dataclass(frozen=True, slots=True)
class Prediction:
    """One right outcome; `rule` names the transition, and is empty for an input that is ignored."""

    outputs: tuple[Output, ...]
    after: Situation
    rule: str = ""
    acts: bool = False
    """True if the transition has actions; one without only ignores the input."""


class MergedTransition(NamedTuple):
    """A transition of the merged machine, as the definition of one service has it in one state."""

    name: str
    transition: model.Transition
    owner: model.ServiceDefinition
    node: MergedState

    @property
    def trigger(self) -> str:
        """The message or internal event that triggers it."""
        return trigger_of(self.transition)

    @property
    def is_input(self) -> bool:
        """True for a message; false for an internal event and for default transitions."""
        return _is_message(self.transition) and bool(self.transition.parameters)


Candidate: TypeAlias = tuple[MergedState, Owned[model.Transition]]
"""A transition and the state that has it."""
Decide: TypeAlias = Callable[[behavior.Call, Situation], TruthValue]
"""Decides a predicate for the present input."""


class BehaviourModel:
    """The merged machine of some definitions, most derived first."""

    def __init__(self, definitions: Sequence[model.ServiceDefinition]) -> None:
        merged = merge_machines(definitions)[RECEIVE_MACHINE]
        self.root = merged.root
        self._outputs = {message.name for definition in definitions for message in definition.outputs}
        self._names = _named(self.root)
        self.start = self._initialized(Situation(merged.start().path))
        """The situation after initialization, in which a component of version 1.0 starts."""
        self.rules = tuple(self._rules())
        """Names of all transitions; those of several services that cannot be distinguished share a name."""
        self.ignoring = next((rule.name for rule in self.rules if rule.trigger == RECEIVE_TRIGGER), "")
        """Name of the default transition of Transport, which ignores inputs."""

    def _initialized(self, situation: Situation) -> Situation:
        (first, *_) = self.predict(situation, INITIALIZED, "", lambda *_: None)
        return first.after

    def _rules(self) -> Iterator[MergedTransition]:
        for node in self.root.all():
            for owned in (*node.transitions, *node.defaults):
                yield MergedTransition(self._name(owned, node), owned.item, owned.owner, node)

    def _name(self, owned: Owned[model.Transition], node: MergedState) -> str:
        return self._names[_description(owned.item, node)]

    def predict(self, situation: Situation, trigger: str, role: str, judge: Decide) -> tuple[Prediction, ...]:
        """All right outcomes of an input, given by the name of a message or internal event.

        There is one for each combination of values of the undecided predicates.
        """
        ways = [way for way in self._in_order(situation) if trigger_of(way[1].item) == trigger]
        evaluators = _evaluators([owned.item.guard for _, owned in ways], situation, judge)
        outcomes = (self._outcome(ways, holds, situation, role) for holds in evaluators)
        return tuple(
            dict.fromkeys(reading for outcome in outcomes for reading in _readings(outcome, situation.controller))
        )

    def _outcome(
        self, ways: Iterable[Candidate], holds: Callable[[str], bool], before: Situation, role: str
    ) -> Prediction:
        for node, owned in ways:
            if holds(owned.item.guard):
                return self._apply(owned, node, before, role)
        return Prediction((), before)

    def _in_order(self, situation: Situation) -> Iterator[Candidate]:
        active = self._node(situation.state)
        for node in active.upwards():
            first, second = node.transitions, node.defaults
            for owned in (*first, *second) if node is active else (*second, *first):
                yield node, owned

    def _node(self, path: Iterable[str]) -> MergedState:
        node = self.root
        for name in path:
            node = node.children[name]
        return node

    def _apply(self, owned: Owned[model.Transition], node: MergedState, before: Situation, role: str) -> Prediction:
        outputs: list[Output] = []
        after = before
        for action in owned.item.actions:
            sent = self._sent(action, role, after.controller if _is_message(owned.item) else role)
            if sent is not None:
                outputs.append(sent)
            after = _effect(action.name, after, role)
        moved = self._moved(owned.item, after)
        return Prediction(tuple(outputs), moved, self._name(owned, node), bool(owned.item.actions))

    def _sent(self, action: model.ActionCall, role: str, controller: str | None) -> Output | None:
        """The output of `Send('Message', 'CODE', transportData)`, or of an action called `sendMessage`."""
        arguments = [argument.strip("'\" ") for argument in action.arguments]
        recipient = role if "transportData" in arguments else controller or role
        name = action.name.rpartition(".")[2]
        if name == "Send":
            literals = [text.strip("'\" ") for text in action.arguments if text.strip()[:1] in ("'", '"')]
            message, *codes = [text for text in literals if text != "transportData"]
            return Output(message, codes[0] if codes else "", recipient)
        if name.startswith("send"):
            known = [output for output in self._outputs if name[4:].startswith(output)]
            return Output(max(known, key=len), "", recipient) if known else None
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
        """The situation after a state was entered, with the effects of the entry actions that were run."""
        inside = situation.state
        common = next((n for n, (a, b) in enumerate(zip(inside, path, strict=False)) if a != b), len(path))
        for depth in range(common, len(path)):
            for owned in self._node(path[: depth + 1]).entry:
                situation = _effect(owned.item.name, situation, "")
        return replace(situation, state=path)


def _readings(outcome: Prediction, before: str | None) -> Iterator[Prediction]:
    """The outcome, and further right ones where the definition contradicts itself.

    In version 1.0 the notice of a lost control goes to the client that takes it; components notify that or the other.
    """
    yield outcome
    if before is not None and outcome.after.controller not in (None, before):
        outputs = tuple(
            replace(output, to=before) if output.message == "RejectControl" else output for output in outcome.outputs
        )
        if outputs != outcome.outputs:
            yield replace(outcome, outputs=outputs)


def _description(transition: model.Transition, node: MergedState) -> str:
    """State, trigger and guard of a transition, as in `Receiving.Ready: SetEmergency [guard]`."""
    guard = " ".join(re.sub(r"(\w+\.)+", "", transition.guard).split())
    return f"{node}: {trigger_of(transition)}" + (f" [{guard}]" if guard else "")


def _named(root: MergedState) -> dict[str, str]:
    """Names of transitions by their description, each with all services that have such a transition."""
    owners: dict[str, dict[str, None]] = {}
    for node in root.all():
        for owned in (*node.transitions, *node.defaults):
            owners.setdefault(_description(owned.item, node), {})[owned.owner.name] = None
    return {description: f"{'/'.join(names)}, {description}" for description, names in owners.items()}


def trigger_of(transition: model.Transition) -> str:
    """The message or internal event that triggers a transition."""
    return transition.parameters[0].type if _is_message(transition) and transition.parameters else _event(transition)


def _is_message(transition: model.Transition) -> bool:
    return _event(transition) == RECEIVE_TRIGGER


def _event(transition: model.Transition) -> str:
    return transition.trigger.rpartition(".")[2]


def _short(call: behavior.Call) -> str:
    """The name of a predicate without the services that it is inherited from."""
    return call.name.rpartition(".")[2]


def _evaluators(texts: Iterable[str], situation: Situation, judge: Decide) -> Iterator[Callable[[str], bool]]:
    """Functions that evaluate guards: one for each combination of values of the undecided predicates."""
    calls = [call for text in texts if text.strip() for call in behavior.calls(behavior.parse(text))]
    unknown = list(dict.fromkeys(_short(call) for call in calls if judge(call, situation) is None))
    for values in product((True, False), repeat=len(unknown)):
        guess = dict(zip(unknown, values, strict=True))

        def decide(call: behavior.Call, guess: Mapping[str, bool] = guess) -> bool:
            known = judge(call, situation)
            return guess[_short(call)] if known is None else known

        yield partial(_holds, decide)


def _holds(decide: Callable[[behavior.Call], bool], text: str) -> bool:
    return _evaluate(behavior.parse(text), decide) if text.strip() else True


def _evaluate(guard: behavior.Guard, decide: Callable[[behavior.Call], bool]) -> bool:
    match guard:
        case behavior.Call():
            return decide(guard)
        case behavior.Not(operand):
            return not _evaluate(operand, decide)
        case behavior.And(operands):
            return all(_evaluate(operand, decide) for operand in operands)
        case behavior.Or(operands):
            return any(_evaluate(operand, decide) for operand in operands)


def _effect(action: str, situation: Situation, role: str) -> Situation:
    """The situation after the actions of core services, as far as the tester can derive it."""
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


TRANSPORT: Final = "urn:jaus:jss:core:Transport"
"""URN of the service Transport, which has no messages, so the registry lacks it."""


SENDS_HEARTBEATS: Final = frozenset({"urn:jaus:jss:iop:UnsolicitedHeartbeat", "urn:jaus:jss:iop:Communicator"})
"""Services that send heartbeats without a query: by their definition, or to measure a link."""


@dataclass(frozen=True)
class ComponentUnderTest:
    """The component under test as its definitions describe it."""

    component: JausID
    definitions: tuple[model.ServiceDefinition, ...]
    machine: BehaviourModel
    registry: Registry

    @property
    def keys(self) -> frozenset[ServiceKey]:
        """The services, with versions."""
        return frozenset(definition.key for definition in self.definitions)

    @property
    def unsolicited(self) -> frozenset[int]:
        """The ids of messages that may come at any time."""
        offered = {definition.id for definition in self.definitions}
        return frozenset({ReportHeartbeatPulse.CODE}) if offered & SENDS_HEARTBEATS else frozenset()

    def transition(self, rule: str) -> str:
        """The name of a transition of this component in reports."""
        return f"{self.component} {rule}"

    def kind(self, name: str) -> type[Message]:
        """The message class of an output, of the service version that the component offers."""
        for definition in self.definitions:
            for message in (*definition.outputs, *definition.inputs):
                if message.name == name:
                    for kind in self.registry.by_code(message.code):
                        if definition.key == (kind.SERVICE, kind.VERSION):
                            return kind
        return self.registry.by_name(name)


def component_under_test(
    id: JausID, offered: frozenset[ServiceKey], messages: Registry = registry
) -> ComponentUnderTest:
    """The component with all offered services whose definitions are known, most derived first.

    `messages` may be those of the user's own definitions, which are preferred to built-in ones.
    """
    built_in = {(entry.service, entry.version) for entry in registry.entries} | {(TRANSPORT, "1.0"), (TRANSPORT, "1.1")}
    definitions = {service.key: service for service in messages.schema.services} if messages.schema else {}
    parents = {service.inherits_from.key for service in definitions.values() if service.inherits_from}
    schema = load_needed(frozenset((offered | parents) & built_in))
    known = {service.key: service for service in schema.services} | definitions
    services = [known[key] for key in sorted(offered & known.keys())]
    ordered = most_derived_first(services, parents_among(known.values()))
    return ComponentUnderTest(id, ordered, BehaviourModel(ordered), messages)
