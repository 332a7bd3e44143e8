"""What is known at this moment, for who watches the demo, and what was known at which time, for the plot."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final, Protocol

from jauspy.cli.demo.report import Finding
from jauspy.ocu import SubsystemInfo

if TYPE_CHECKING:
    from jauspy.cli.demo.film import Film

SAMPLES: Final = 6000
"""Positions of the joints that are remembered."""


@dataclass(slots=True)
class Scene:
    """Metres, radians and kilograms; in the local frame as REP-103 has it."""

    began: float = field(default_factory=time.monotonic)
    pose: tuple[float, float, float] | None = None
    speed: float = 0.0
    joints: Sequence[float] = ()
    finger: float | None = None
    films: dict[str, Film] = field(default_factory=dict)
    scans: int = 0
    controlled: bool = False
    positions: deque[tuple[float, Sequence[float]]] = field(default_factory=lambda: deque(maxlen=SAMPLES))
    commands: deque[tuple[float, Sequence[float]]] = field(default_factory=lambda: deque(maxlen=SAMPLES))
    phases: list[tuple[float, str]] = field(default_factory=list)

    @property
    def elapsed(self) -> float:
        """Seconds since the demo began."""
        return time.monotonic() - self.began

    def moved(self, positions: Sequence[float]) -> None:
        """The arm's joints are there now."""
        self.joints = positions
        self.positions.append((self.elapsed, positions))

    def commanded(self, positions: Sequence[float]) -> None:
        """The arm's joints are to go there."""
        self.commands.append((self.elapsed, positions))


class Watcher(Protocol):
    """Is told how it goes on."""

    scene: Scene

    def step(self, text: str) -> None:
        """The next thing is being done."""

    def discovered(self, robot: SubsystemInfo) -> None:
        """It was found, and this is what it is."""

    def found(self, finding: Finding) -> None:
        """A goal was reached, or not."""
