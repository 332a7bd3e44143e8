"""Places of an arm, the tip to which the next part is joined, and what is measured of a task that joins parts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final

import pinocchio as pin

from jauspy.cell.frames import turned
from jauspy.cell.scene import Clearance, Layout
from jauspy.cell.schedule import Timeline
from jauspy.geometry.vectors import Z
from jauspy.platform.modular.parts import PartKind, PartType

QUARTERS: Final = (0.0, math.pi, math.pi / 2.0, -math.pi / 2.0)
WHEEL_TURNS: Final = 12
"""Angles about its axis at which a wheel may be joined."""
STRAIGHT: Final = 0.999
"""Cosine of the angle from which on two axes count as parallel."""


@dataclass(frozen=True, slots=True)
class Slot:
    """A place in the arm: what it is called in the results, and the types that fit, the best first."""

    name: str
    types: tuple[str, ...]
    connector: str = "output"
    """The connector of the part in this place to which the next one is attached."""
    turns: tuple[float, ...] = ()
    """Radians about the connector's normal from where the part is square to the one before: as it is wanted, and then
    others with which it does as well. Empty: by its type."""


FIVE_JOINTS: Final = (
    Slot("joint 1", ("x5_9_inline", "x5_4_inline")),
    Slot("bracket", ("bracket_straight",)),
    Slot("joint 2", ("x8_16_elbow", "x8_9_elbow")),
    Slot("upper arm", ("tube_long",)),
    Slot("joint 3", ("x8_9_elbow", "x5_9_elbow")),
    Slot("forearm", ("tube_short",)),
    Slot("joint 4", ("x8_9_elbow", "x5_9_elbow")),
    Slot("joint 5", ("x5_4_inline", "x5_1_inline")),
)
"""The arm with five joints, base to tip."""


@dataclass(slots=True)
class PartResult:
    """Measurements of one part."""

    slot: str
    part: str = ""
    fetch_time: float = 0.0
    join_time: float = 0.0
    attempts: list[str] = field(default_factory=list)
    """Texts of the failed attempts."""
    grasp_force: float = 0.0
    """Newtons that the gripper measured while the part hung still."""
    mass: float = 0.0
    """Kilograms by the UR10's motors, and their standard deviation; zero while they are not known."""
    mass_deviation: float = 0.0
    joint_force: float = 0.0
    joint_moment: float = 0.0
    shift: float = 0.0
    """Metres off the connector, and radians, by the connector's own report."""
    tilt: float = 0.0


@dataclass(slots=True)
class AssemblyResult:
    """Measurements of the whole task."""

    base: str
    parts: list[PartResult] = field(default_factory=list)
    clearance: Clearance = field(default_factory=lambda: Clearance(1.0))
    """The smallest distance along all motions, without those that end in contact."""
    duration: float = 0.0
    timeline: Timeline = field(default_factory=Timeline)
    failure: str = ""
    """Why it ended early; empty after a success."""

    @property
    def retries(self) -> int:
        """Attempts that failed."""
        return sum(len(part.attempts) for part in self.parts)


class Tip:
    """The connector to which the next part is joined."""

    def __init__(self, connector: str, part: str, frame: pin.SE3) -> None:
        self.connector = connector
        self.part = part
        self.frame = frame
        """Frame of the part in the world."""
        self.square = pin.SE3.Identity()
        """The turn about the connector's axis after which a part is square to the base."""

    def advance(self, part: str, connector: str, frame: pin.SE3, output: pin.SE3, turn: float = 0.0) -> None:
        """The next part is joined to this one, whose frame is `frame`, and was to be turned by `turn` radians."""
        wanted = self.frame * self.square * turned("z", turn) * output
        self.connector, self.part, self.frame = f"{part}/{connector}", part, frame * output
        x = self.frame.rotation.T @ wanted.rotation[:, 0]
        self.square = turned("z", math.atan2(x[1], x[0]))


def slot_goals(layout: Layout, slot: Slot, tip: Tip) -> list[pin.SE3]:
    """The frames in the world that a part in a place may have: on the connector, square to the base."""
    type = layout.setup.types[slot.types[0]]
    turns: Sequence[float] = QUARTERS if is_straight(type) else QUARTERS[:1]
    if type.kind is PartKind.WHEEL:
        turns = [math.tau * number / WHEEL_TURNS for number in range(WHEEL_TURNS)]
    return [tip.frame * tip.square * turned("z", turn) for turn in slot.turns or turns]


def is_straight(type: PartType) -> bool:
    """True if a part has all its axes along its own z: turned about it, it carries the next part as well."""
    axes = [frame.rotate(Z) for frame in type.connectors.values()]
    axes += [type.servo.axis] if type.servo is not None else []
    return all(axis[2] > STRAIGHT for axis in axes)
