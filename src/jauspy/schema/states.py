"""What behaviour refers to: states, messages that trigger transitions, and guards that can be read."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from jauspy.errors import SchemaError
from jauspy.schema import guards
from jauspy.schema.library import Key
from jauspy.schema.model import Behavior, Location, Service, State, StateMachine, Transition
from jauspy.schema.reading import suggestion


class _Tree(dict[str, "_Tree"]):
    """Nested state names of one machine, merged over a service and its ancestors."""

    def add(self, states: Sequence[State]) -> None:
        for state in states:
            self.setdefault(state.name, _Tree()).add(state.states)

    def check(self, path: str, what: str, where: Location | None) -> None:
        """Raise `SchemaError` when there is no such (dotted) path."""
        tree = self
        for name in path.split("."):
            if name not in tree:
                raise _error(f"{what} '{path}': no state '{name}'{suggestion(name, tree)}", where)
            tree = tree[name]


def check_states(services: Sequence[Service], known: Sequence[Service]) -> None:
    """Check states, triggers and guards of services; their parents are resolved, some of them `known` before."""
    by_key = {service.key: service for service in (*services, *known)}
    for service in services:
        if service.behavior is not None:
            _check_behavior(service.behavior, _trees(service, by_key))
            messages = {message.name for member in _lineage(service, by_key) for message in member.messages}
            for transition in _transitions(service.behavior):
                _check_trigger(transition, messages)
                _check_guard(transition)


def _trees(service: Service, by_key: Mapping[Key, Service]) -> dict[str, _Tree]:
    trees: dict[str, _Tree] = {}
    for member in _lineage(service, by_key):
        for machine in member.behavior.machines if member.behavior else ():
            trees.setdefault(_base_name(machine.name), _Tree()).add(machine.states)
    return trees


def _lineage(service: Service, by_key: Mapping[Key, Service]) -> Iterator[Service]:
    current: Service | None = service
    while current is not None:
        yield current
        parent = current.inherits_from
        current = None if parent is None else by_key[parent.key]


def _base_name(machine: str) -> str:
    """`ReceiveFSM` of `events.transport.ReceiveFSM`: children name their parents' machines by a path."""
    return machine.rpartition(".")[2]


def _check_behavior(behavior: Behavior, trees: Mapping[str, _Tree]) -> None:
    for start in behavior.start:
        trees[_base_name(start.machine)].check(start.state, "start state", start.where)
    for machine in behavior.machines:
        _check_machine(machine, trees[_base_name(machine.name)])


def _check_machine(machine: StateMachine, tree: _Tree) -> None:
    _check_ends(machine.default_transitions, tree)
    for path, state in _walk(machine.states, ""):
        if state.initial is not None:
            tree.check(f"{path}.{state.initial}", "initial state", state.where)
        _check_ends((*state.transitions, *state.default_transitions), tree)


def _check_ends(transitions: Sequence[Transition], tree: _Tree) -> None:
    for transition in transitions:
        if transition.end_state is not None:
            tree.check(transition.end_state, "end state", transition.where)


def _transitions(behavior: Behavior) -> Iterator[Transition]:
    for machine in behavior.machines:
        yield from machine.default_transitions
        for _, state in _walk(machine.states, ""):
            yield from state.transitions
            yield from state.default_transitions


def _check_trigger(transition: Transition, messages: Collection[str]) -> None:
    """What is received is a message of the service or of one that it inherits from."""
    if transition.trigger.rpartition(".")[2] == "Receive" and transition.parameters:
        received = transition.parameters[0].type
        if received not in messages and "." not in received:
            reason = f"a transition receives '{received}', which is no message here{suggestion(received, messages)}"
            raise _error(reason, transition.where)


def _check_guard(transition: Transition) -> None:
    if transition.guard:
        try:
            guards.parse(transition.guard)
        except SchemaError as error:
            raise _error(error.reason, transition.where) from None


def _error(reason: str, where: Location | None) -> SchemaError:
    return SchemaError(reason, file=where.file if where else None, line=where.line if where else None)


def _walk(states: Sequence[State], parent: str) -> Iterator[tuple[str, State]]:
    for state in states:
        path = f"{parent}.{state.name}" if parent else state.name
        yield path, state
        yield from _walk(state.states, path)
