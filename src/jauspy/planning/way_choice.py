"""When a robot leaves the way that it drives for another one: noise must not send it back and forth between two."""

from __future__ import annotations

from typing import Final

BETTER: Final = 0.85
"""Part of the cost of what is left of the present way below which another one is taken without need."""
DEARER: Final = 1.5
MORE: Final = 1.0
"""Factor, and metres of free ground, by which a way around what blocks the present one may be dearer, to be taken at
once. One that is still dearer leads through another door: it is taken when the present way stays blocked."""
CERTAIN: Final = 1.0
"""Seconds for which a way must have been blocked for longer than free, to be given up for a much dearer one."""


class WayChoice:
    """The choice between the present way and another one. Times are in seconds of one clock, costs as those of `Path`.

    Cells at the posts of a door are occupied in one scan and free in the next, so a door that the robot just passes
    opens and closes. Looks at the way count for as long as they lie apart, for and against it.
    """

    def __init__(self) -> None:
        self._blocked = 0.0
        """Seconds for which it was blocked, less those for which it was free since."""
        self._looked: float | None = None

    def begin(self) -> None:
        """Another way was taken; nothing is known against it."""
        self._blocked, self._looked = 0.0, None

    def look(self, *, is_free: bool, now: float) -> None:
        """Note whether the present way was free at a time."""
        passed = 0.0 if self._looked is None else now - self._looked
        self._looked = now
        self._blocked = max(0.0, self._blocked - passed) if is_free else self._blocked + passed

    @property
    def is_blocked(self) -> bool:
        """True if it is certain that the present way is blocked."""
        return self._blocked >= CERTAIN

    def takes_around(self, cost: float, left: float) -> bool:
        """True if a way around what blocks the present one is to be taken; `left`: what the present one still costs."""
        return self.is_blocked or cost <= DEARER * left + MORE

    def takes_better(self, cost: float, left: float) -> bool:
        """True if another way is to be taken though the present one is free."""
        return cost < BETTER * left
