"""A state machine as a service and its ancestors make it together, and which of its states can be active."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from jauspy.schema.model import Behavior, State, Transition


@dataclass(slots=True)
class MergedState:
    """What all definitions together say of one state."""

    initial: str | None = None
    ends: list[str] = field(default_factory=list)


@dataclass(slots=True)
class Machine:
    """States by dotted path, and where the machine starts."""

    states: dict[str, MergedState] = field(default_factory=dict)
    starts: list[str] = field(default_factory=list)
    ends: list[str] = field(default_factory=list)

    def children(self, path: str) -> list[str]:
        """The states directly inside one."""
        return [other for other in self.states if other.rpartition(".")[0] == path]

    def reachable(self) -> set[str]:
        """Every state that can be active; guards are taken to hold. All of them when there is no start."""
        waiting = [path for path in self.starts if path in self.states]
        if not waiting:
            return set(self.states)
        seen: set[str] = set()
        while waiting:
            leaf = self._leaf(waiting.pop())
            fresh = [path for path in _upwards(leaf) if path not in seen]
            seen.update(fresh)
            ends = [end for path in fresh for end in self.states[path].ends] + (self.ends if fresh else [])
            waiting += [end for end in ends if end in self.states]
        return seen

    def _leaf(self, path: str) -> str:
        """The innermost state that is active when this one is entered."""
        while True:
            inside = self.children(path)
            initial = self.states[path].initial
            if initial is not None and f"{path}.{initial}" in inside:
                path = f"{path}.{initial}"
            elif len(inside) == 1:
                path = inside[0]
            else:
                return path


def _upwards(path: str) -> Iterator[str]:
    while path:
        yield path
        path = path.rpartition(".")[0]


def merged(behaviors: Sequence[Behavior]) -> dict[str, Machine]:
    """The machines by their short names; `behaviors` has the most derived first."""
    machines: dict[str, Machine] = {}
    for behavior in behaviors:
        for machine in behavior.machines:
            found = machines.setdefault(_short(machine.name), Machine())
            found.ends += _ends(machine.default_transitions)
            for state in machine.states:
                _merge(found, state, state.name)
    for behavior in behaviors:
        for start in behavior.start:
            if _short(start.machine) in machines:
                machines[_short(start.machine)].starts.append(start.state)
    for found in machines.values():
        found.starts = sorted(found.starts, key=lambda path: -path.count("."))[:1]  # the deepest is where it starts
    return machines


def _merge(machine: Machine, state: State, path: str) -> None:
    node = machine.states.setdefault(path, MergedState())
    node.initial = node.initial or state.initial
    node.ends += _ends((*state.transitions, *state.default_transitions))
    for child in state.states:
        _merge(machine, child, f"{path}.{child.name}")


def _ends(transitions: Sequence[Transition]) -> list[str]:
    return [transition.end_state for transition in transitions if transition.end_state is not None]


def _short(dotted: str) -> str:
    return dotted.rpartition(".")[2]
