"""The state machines of services merged into one tree of states for each machine (AS5684).

States with the same path are one state: services that inherit from the same parent share its states. Trees are
immutable. Lists keep the order of the definitions, most derived first. `check_behavior` checks what behaviour refers
to: states, messages that trigger transitions, and guards.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Generic, TypeVar

from jauspy.errors import ConfigError, SchemaError
from jauspy.schema import behavior as guards
from jauspy.schema.document import suggestion
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.model import (
    ActionCall,
    Behavior,
    ServiceDefinition,
    SourceLocation,
    Start,
    State,
    StateMachine,
    Transition,
)

T_co = TypeVar("T_co", covariant=True)


def short_name(dotted: str) -> str:
    """The name without the path of the parent that it comes from: `ReceiveFSM` of `events.transport.ReceiveFSM`."""
    return dotted.rpartition(".")[2]


# --- one definition ---------------------------------------------------------------------------------------------------


def walk_states(states: Sequence[State], parent: str = "") -> Iterator[tuple[str, State]]:
    """States and all nested in them with their dotted paths, outer states first."""
    for state in states:
        path = f"{parent}.{state.name}" if parent else state.name
        yield path, state
        yield from walk_states(state.states, path)


def transitions_of(behavior: Behavior) -> Iterator[Transition]:
    """All transitions, including the default ones of states and machines."""
    for machine in behavior.machines:
        yield from machine.default_transitions
        for _, state in walk_states(machine.states):
            yield from state.transitions
            yield from state.default_transitions


# --- merged definitions -----------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Owned(Generic[T_co]):
    """A part of a state machine, and the service definition that it comes from."""

    owner: ServiceDefinition
    item: T_co


@dataclass(frozen=True, slots=True, eq=False)
class MergedState:
    """One state as all definitions together describe it; the root (empty path) stands for the machine."""

    path: tuple[str, ...]
    parent: MergedState | None
    children: Mapping[str, MergedState]
    parts: tuple[Owned[State], ...]
    """The states of the definitions that this state was merged from."""
    initial: str | None
    """The child that is entered with this state, as the most derived definition that names one has it.

    Definitions of JSIDL 1.1 often name the state itself when it has no children: see `leaf`.
    """

    def __str__(self) -> str:
        return ".".join(self.path)

    @property
    def entry(self) -> tuple[Owned[ActionCall], ...]:
        """Entry actions."""
        return tuple(Owned(part.owner, action) for part in self.parts for action in part.item.entry)

    @property
    def exit(self) -> tuple[Owned[ActionCall], ...]:
        """Exit actions."""
        return tuple(Owned(part.owner, action) for part in self.parts for action in part.item.exit)

    @property
    def transitions(self) -> tuple[Owned[Transition], ...]:
        """The state's own transitions."""
        return tuple(Owned(part.owner, transition) for part in self.parts for transition in part.item.transitions)

    @property
    def defaults(self) -> tuple[Owned[Transition], ...]:
        """Default transitions, which also apply to all states inside."""
        return tuple(
            Owned(part.owner, transition) for part in self.parts for transition in part.item.default_transitions
        )

    def upwards(self) -> Iterator[MergedState]:
        """The state itself, its parent, and so on; without the root."""
        state: MergedState | None = self
        while state is not None and state.path:
            yield state
            state = state.parent

    def all(self) -> Iterator[MergedState]:
        """The state and all below it."""
        yield self
        for child in self.children.values():
            yield from child.all()

    def find(self, path: str) -> MergedState | None:
        """The state at a dotted path below this one."""
        state: MergedState | None = self
        for name in path.split("."):
            state = state.children.get(name) if state else None
        return state

    def entered(self) -> MergedState | None:
        """The child that is entered with this state: the initial one, or the only one; None when it is undefined."""
        if self.initial is not None and self.initial in self.children:
            return self.children[self.initial]
        return next(iter(self.children.values())) if len(self.children) == 1 else None

    def leaf(self) -> MergedState:
        """The state that is active when this one is entered."""
        state = self
        while (child := state.entered()) is not None:
            state = child
        return state

    def contains(self, other: MergedState) -> bool:
        """True when `other` is this state or below it."""
        return other.path[: len(self.path)] == self.path


@dataclass(frozen=True, slots=True, eq=False)
class MergedMachine:
    """One state machine of a component: all states below `root`, and the start states that definitions name."""

    name: str
    root: MergedState
    starts: tuple[tuple[str, ServiceDefinition], ...]
    """The states in which definitions start the machine (path to their own innermost state), most derived first."""

    def start(self) -> MergedState:
        """The state in which the machine starts: the deepest that a definition names, down to its initial states.

        Raises `ConfigError` when no definition names one, or when definitions start in different branches.
        """
        if not self.starts:
            raise ConfigError(f"no service defines the state in which {self.name} starts")
        deepest, chooser = self._deepest()
        for state, owner in self.starts:
            if not f"{deepest}.".startswith(f"{state}."):
                raise ConfigError(
                    f"{chooser.name} starts {self.name} in {deepest}, but {owner.name} in {state}: they cannot share "
                    "it; nest the states of the one in those of the other, and have it inherit from that"
                )
        found = self.root.find(deepest)
        if found is None:
            raise ConfigError(f"{chooser.name} starts {self.name} in {deepest}, which is not a state")
        return found.leaf()

    def check_initials(self) -> None:
        """Raise `ConfigError` when the child that is entered with a state is undefined."""
        for state in self.root.all():
            named = state.initial is None or state.initial in state.children
            if state.path and state.children and not (named and state.entered()):
                raise ConfigError(f"state {state} has no initial state among {', '.join(state.children)}")

    def reachable(self) -> frozenset[str]:
        """Paths of all states that can be active when every guard holds; all states when the start is not known."""
        start = self.root.find(self._deepest()[0]) if self.starts else None
        if start is None:
            return frozenset(str(state) for state in self.root.all() if state.path)
        seen: dict[MergedState, None] = {}
        waiting = [start]
        while waiting:
            fresh = [state for state in waiting.pop().leaf().upwards() if state not in seen]
            seen.update(dict.fromkeys(fresh))
            for source in (*fresh, self.root):
                ends = [transition.item.end_state for transition in (*source.transitions, *source.defaults)]
                waiting += [end for path in ends if path and fresh and (end := self.root.find(path)) is not None]
        return frozenset(map(str, seen))

    def _deepest(self) -> tuple[str, ServiceDefinition]:
        return max(self.starts, key=lambda start: start[0].count("."))


def merge_machines(definitions: Iterable[ServiceDefinition]) -> dict[str, MergedMachine]:
    """Merge the machines; the keys are their short names. `definitions`: most derived first, with all ancestors."""
    parts: dict[str, list[Owned[State]]] = {}
    starts: dict[str, list[tuple[str, ServiceDefinition]]] = {}
    for owner in definitions:
        for machine in owner.behavior.machines if owner.behavior else ():
            whole = State(name="", states=machine.states, default_transitions=machine.default_transitions)
            parts.setdefault(short_name(machine.name), []).append(Owned(owner, whole))
        for start in owner.behavior.start if owner.behavior else ():
            path = _innermost(owner.behavior.machines, start) if owner.behavior else start.state
            starts.setdefault(short_name(start.machine), []).append((path, owner))
    return {
        name: MergedMachine(name, _merged((), None, states), tuple(starts.get(name, ())))
        for name, states in parts.items()
    }


def _merged(path: tuple[str, ...], parent: MergedState | None, parts: Sequence[Owned[State]]) -> MergedState:
    initial = next((part.item.initial for part in parts if part.item.initial), None)
    children: dict[str, MergedState] = {}
    state = MergedState(path, parent, MappingProxyType(children), tuple(parts), initial)
    inside: dict[str, list[Owned[State]]] = {}
    for part in parts:
        for child in part.item.states:
            inside.setdefault(child.name, []).append(Owned(part.owner, child))
    for name, its_parts in inside.items():
        children[name] = _merged((*path, name), state, its_parts)
    return state


def _innermost(machines: Sequence[StateMachine], start: Start) -> str:
    """The state in which one definition starts a machine, down to its own innermost state."""
    states = [state for machine in machines if machine.name == start.machine for state in machine.states]
    path, found = start.state.split("."), None
    for name in path:
        found = next((state for state in (found.states if found else states) if state.name == name), None)
        if found is None:
            return start.state
    while found and (found := next((state for state in found.states if state.name == found.initial), None)):
        path.append(found.name)
    return ".".join(path)


# --- references -------------------------------------------------------------------------------------------------------


def check_behavior(services: Sequence[ServiceDefinition], known: Sequence[ServiceDefinition]) -> None:
    """Check states, triggers and guards of `services`, whose parents are among them or `known`.

    Raises `SchemaError` with file and line.
    """
    parent_of = parents_among((*known, *services))
    for service in services:
        if service.behavior is not None:
            line = lineage(service, parent_of)
            _check_states(service.behavior, merge_machines(line))
            messages = {message.name for ancestor in line for message in ancestor.messages}
            for transition in transitions_of(service.behavior):
                _check_trigger(transition, messages)
                _check_guard(transition)


def _check_states(behavior: Behavior, merged: Mapping[str, MergedMachine]) -> None:
    for start in behavior.start:
        _check_path(merged[short_name(start.machine)].root, start.state, "start state", start.where)
    for machine in behavior.machines:
        root = merged[short_name(machine.name)].root
        for path, state in walk_states(machine.states):
            if state.initial is not None:
                _check_path(root, f"{path}.{state.initial}", "initial state", state.where)
        for transition in transitions_of(Behavior(machines=(machine,))):
            if transition.end_state is not None:
                _check_path(root, transition.end_state, "end state", transition.where)


def _check_path(root: MergedState, path: str, what: str, where: SourceLocation | None) -> None:
    state = root
    for name in path.split("."):
        if name not in state.children:
            raise _error(f"{what} '{path}': no state '{name}'{suggestion(name, state.children)}", where)
        state = state.children[name]


def _check_trigger(transition: Transition, messages: Collection[str]) -> None:
    """Check that a received message is defined by the service or one of its ancestors."""
    if short_name(transition.trigger) == "Receive" and transition.parameters:
        received = transition.parameters[0].type
        if received not in messages and "." not in received:
            reason = f"a transition receives '{received}', which is not a message here{suggestion(received, messages)}"
            raise _error(reason, transition.where)


def _check_guard(transition: Transition) -> None:
    if transition.guard:
        try:
            guards.parse(transition.guard)
        except SchemaError as error:
            raise _error(error.reason, transition.where) from None


def _error(reason: str, where: SourceLocation | None) -> SchemaError:
    return SchemaError(reason, file=where.file if where else None, line=where.line if where else None)
