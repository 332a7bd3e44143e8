"""Merges the JSIDL state machines of a component's services into one tree of states per machine.

States with the same path are one state: services that inherit from the same parent share its states
(AS5684). Lists keep the order of the definitions given, most derived service first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Generic, TypeVar

from jauspy.errors import ConfigError
from jauspy.schema.model import Action, Service, Start, State, StateMachine, Transition

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Owned(Generic[T]):
    """Something of a state machine, and the service definition it comes from."""

    owner: Service
    item: T


@dataclass(slots=True, eq=False)
class StateNode:
    """One merged state; the root (empty path) stands for the machine."""

    path: tuple[str, ...]
    parent: StateNode | None
    children: dict[str, StateNode] = field(default_factory=dict)
    initial: str | None = None
    entry: list[Owned[Action]] = field(default_factory=list)
    exit: list[Owned[Action]] = field(default_factory=list)
    transitions: list[Owned[Transition]] = field(default_factory=list)
    defaults: list[Owned[Transition]] = field(default_factory=list)

    def __str__(self) -> str:
        return ".".join(self.path)

    def upwards(self) -> Iterator[StateNode]:
        """The state itself, its parent, and so on; without the root."""
        node: StateNode | None = self
        while node is not None and node.path:
            yield node
            node = node.parent

    def all(self) -> Iterator[StateNode]:
        """The state and all below it."""
        yield self
        for child in self.children.values():
            yield from child.all()

    def find(self, path: str) -> StateNode | None:
        """The state at a dotted path below this one."""
        node: StateNode | None = self
        for name in path.split("."):
            node = node.children.get(name) if node else None
        return node

    def leaf(self) -> StateNode:
        """The state that is active when this one is entered: initial states, recursively."""
        node = self
        while node.initial is not None:
            node = node.children[node.initial]
        return node

    def contains(self, other: StateNode) -> bool:
        """True when `other` is this state or below it."""
        return other.path[: len(self.path)] == self.path


def machine_name(dotted: str) -> str:
    """`accessControl.events.transport.ReceiveFSM` extends, and is, `ReceiveFSM`."""
    return dotted.rpartition(".")[2]


def merge(definitions: Sequence[Service]) -> dict[str, StateNode]:
    """The root of each machine by its short name. `definitions`: most derived first, all ancestors included."""
    roots: dict[str, StateNode] = {}
    for owner in definitions:
        for machine in owner.behavior.machines if owner.behavior else ():
            root = roots.setdefault(machine_name(machine.name), StateNode((), None))
            root.defaults += (Owned(owner, transition) for transition in machine.default_transitions)
            _merge_machine(root, owner, machine)
    for root in roots.values():
        _check_initials(root)
    return roots


def start_of(root: StateNode, name: str, definitions: Sequence[Service]) -> StateNode:
    """The state a machine starts in: the deepest that a definition asks for; all others must lie on its path."""
    wanted = [
        (_first(owner.behavior.machines, start), owner.name)
        for owner in definitions
        if owner.behavior
        for start in owner.behavior.start
        if machine_name(start.machine) == name
    ]
    if not wanted:
        raise ConfigError(f"no service says in which state {name} starts")
    deepest, chooser = max(wanted, key=lambda want: want[0].count("."))
    for state, owner_name in wanted:
        if not f"{deepest}.".startswith(f"{state}."):
            raise ConfigError(
                f"{chooser} starts {name} in {deepest}, but {owner_name} in {state}: they cannot share it; nest the "
                "states of the one in those of the other, and have it inherit from that"
            )
    node = root.find(deepest)
    if node is None:
        raise ConfigError(f"{chooser} starts {name} in {deepest}, which is not a state")
    return node.leaf()


def _first(machines: Sequence[StateMachine], start: Start) -> str:
    """Where a definition starts a machine, down to its own innermost state."""
    states = [state for machine in machines if machine.name == start.machine for state in machine.states]
    path, node = start.state.split("."), None
    for name in path:
        node = next((state for state in (node.states if node else states) if state.name == name), None)
        if node is None:
            return start.state
    while node and (node := next((state for state in node.states if state.name == node.initial), None)):
        path.append(node.name)
    return ".".join(path)


def _merge_machine(root: StateNode, owner: Service, machine: StateMachine) -> None:
    for state in machine.states:
        _merge_state(root, owner, state)


def _merge_state(parent: StateNode, owner: Service, state: State) -> None:
    node = parent.children.setdefault(state.name, StateNode((*parent.path, state.name), parent))
    node.initial = node.initial or state.initial
    node.entry += (Owned(owner, action) for action in state.entry)
    node.exit += (Owned(owner, action) for action in state.exit)
    node.transitions += (Owned(owner, transition) for transition in state.transitions)
    node.defaults += (Owned(owner, transition) for transition in state.default_transitions)
    for child in state.states:
        _merge_state(node, owner, child)


def _check_initials(root: StateNode) -> None:
    """An initial state must exist (JSIDL 1.1 often names the state itself when it has no children)."""
    for node in root.all():
        if not node.children:
            node.initial = None
        elif node.initial is None and len(node.children) == 1:
            node.initial = next(iter(node.children))
        elif node.path and node.initial not in node.children:
            raise ConfigError(f"state {node} has no initial state among {', '.join(node.children)}")
