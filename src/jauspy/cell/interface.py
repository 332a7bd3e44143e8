"""The interface of a cell for tasks. `CellClient` implements it over JAUS; tests have one that fails on purpose."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeVar

import pinocchio as pin

from jauspy.cell.frames import Array
from jauspy.cell.motion import Path
from jauspy.platform.modular.arm import ModularArmState, TrajectoryPoint
from jauspy.platform.modular.connector import ConnectorState

T = TypeVar("T")

GRIPPER = "gripper"
"""The name of the gripper among the connectors."""


@dataclass(frozen=True, slots=True)
class SeenPart:
    """A part as the sensor measured it: its type, and its frame in the world."""

    type: str
    pose: pin.SE3
    age: float = 0.0
    """Seconds from when it was last seen to the last observation: above zero while something hides it."""


class Cell(Protocol):
    """A cell that is under control of this client. Names of connectors are as in `servo_1/output`."""

    def now(self) -> float:
        """Seconds of the clock that the cell runs on."""
        ...

    async def sleep(self, seconds: float) -> None:
        """Wait for a number of seconds on that clock."""
        ...

    async def compute(self, function: Callable[[], T]) -> T:
        """The value of a function that may take seconds, and meanwhile keep control of the cell.

        The function may be called in another thread; it is over when this ends, also when this is cancelled.
        """
        ...

    async def posture(self) -> Array:
        """Positions of the UR10's joints as its URDF counts them, in radians."""
        ...

    async def follow(
        self, path: Path, *, speed: float = 1.0, tool_speed: float = math.inf, gentle: bool = False
    ) -> None:
        """Move the UR10 along a path with this fraction of its speed; raises `RequestError` if it does not arrive.

        `tool_speed` limits the speed of the tool, in m/s. `gentle` motions speed up slowly, so that what the arm
        carries does not bend.
        """
        ...

    async def touch(
        self, path: Path, connector: str, *, tool_speed: float, contact: float = math.inf
    ) -> ConnectorState:
        """Same as `follow`, but stop as soon as a connector that holds nothing has attached something.

        One that holds something already stops the motion when its force has changed by `contact`, in newtons. What the
        UR10 itself finds in its way ends the motion, too. Returns the connector's state.
        """
        ...

    async def blocked(self) -> str:
        """What was in the way of the UR10's last motion, as a sentence; empty if nothing was."""
        ...

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        """The parts that the sensor has seen, averaged over several observations; with `fresh` only over new ones.

        A part that is hidden now is where it was seen last; its `age` says how long ago.
        """
        ...

    async def connector(self, name: str) -> ConnectorState:
        """Measurements of a connector or the gripper."""
        ...

    async def enable(self, name: str, enabled: bool) -> None:
        """Start or stop the pump of a connector or of the gripper."""
        ...

    async def leave(self, part: str) -> None:
        """Release control of a part, which is about to lose its power."""
        ...

    async def arm(self, name: str = "") -> ModularArmState:
        """The joints and motion of a modular arm, of the first one without a name."""
        ...

    async def move_arm(self, positions: Sequence[float], duration: float = 0.0, *, name: str = "") -> None:
        """Move the modular arm, and wait until it is there; raises `RequestError` if it does not arrive."""
        ...

    async def follow_arm(self, joints: Sequence[str], points: Sequence[TrajectoryPoint], *, name: str = "") -> None:
        """Move joints of the modular arm through points, and wait; raises `RequestError` as `move_arm` does."""
        ...
