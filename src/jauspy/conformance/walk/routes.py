"""Ways through a machine: which inputs lead to which state, and from which states there is a way back."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.conformance.walk.access import ACCESS
from jauspy.conformance.walk.behaviour import Machine, Situation
from jauspy.conformance.walk.explorer import STEERING, Stimulus

Path: TypeAlias = tuple[tuple[str, str], ...]
"""Inputs, each with the role that sends it."""

_STEERED: Final = {
    each.message: each for each in ACCESS if (each.message, each.variant) == ("RequestControl", "the same authority")
}


@dataclass(frozen=True)
class Routes:
    """By the inputs of `STEERING` alone."""

    machine: Machine

    def ways(self) -> dict[Situation, Path]:
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
        """Where single inputs lead, and which; those whose outcome is not known are left out."""
        for message, role in STEERING:
            stimulus = _STEERED.get(message) or Stimulus(message, None)
            (first, *others) = self.machine.predict(situation, message, role, stimulus.judge(role))
            after = self._settled(first.after)
            if not others and after != situation:
                yield after, (message, role)

    def _settled(self, situation: Situation) -> Situation:
        """Initialization is over by itself."""
        done = Stimulus("Initialized", None)
        (first, *_) = self.machine.predict(situation, done.message, "", done.judge(""))
        return first.after

    def returns(self, situation: Situation) -> bool:
        """True when inputs lead from there to the start."""
        seen, waiting = {situation}, [situation]
        while waiting:
            here = waiting.pop()
            if here == self.machine.start:
                return True
            for after, _ in self.moves(here):
                if after not in seen:
                    seen.add(after)
                    waiting.append(after)
        return False
