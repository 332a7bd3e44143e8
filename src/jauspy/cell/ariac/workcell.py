"""The cell of a trial: the factory cell with two trays in place of the car, and a place for quality control.

The belt is shorter than the cell's, so that boxes which nobody takes fall off its end before the first tray.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import pinocchio as pin

from jauspy.cell.ariac.trial_file import Trial, check
from jauspy.cell.frames import se3, shifted
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Z, rotation_about
from jauspy.platform.modular.parts import (
    HALF_TURN,
    CellSetup,
    Fixture,
    PartKind,
    PartSolid,
    PartType,
    PlacedPart,
    Shape,
)
from jauspy.robot.config import RobotConfig

QUALITY_CONTROL: Final = "platform_2"
"""The base where parts are tested and turned over."""
HELPER: Final = "platform_1"
"""The base of the modular arm, in trials with two arms."""
POST: Final = PartType(
    "quality_post",
    PartKind.BASE,
    (
        PartSolid(Shape.CUBOID, (0.18, 0.18, 0.06), 20.0, Transform(position=(0.0, 0.0, 0.03))),
        PartSolid(Shape.CUBOID, (0.07, 0.07, 0.20), 5.0, Transform(position=(0.0, 0.0, 0.16))),
    ),
    {"top": Transform(position=(0.0, 0.0, 0.26))},
    grasp=Transform(position=(0.0, 0.0, 0.26)) @ HALF_TURN,
    latch=True,
)
"""The type of that base: no wider than a part, so that the gripper can hold all parts on it from the sides."""
TRAY_SIZE: Final = (0.44, 0.60, 0.22)
"""Metres along x and y of the world, and the height of the tray's surface."""
BELT_END: Final = -0.05
"""y of the end of the belt, metres."""
BELT_X: Final = 0.97
"""x of the middle of the boxes on the belt, metres."""
WAITING_BOXES: Final = (-0.25, -0.5, -0.75)
"""y of boxes on a belt that stands still."""
COMING_BOXES: Final = (-0.75, -0.92, -1.09)
"""y of boxes on a belt that will move: out of reach."""
QUARTER: Final = 1.5707963267948966


@dataclass(frozen=True, slots=True)
class TrayPlace:
    """A tray: the middle of its surface, in the world; its axes are those of the world."""

    number: int
    x: float
    y: float

    @property
    def name(self) -> str:
        """Name of the table in the cell."""
        return f"tray_{self.number}"

    @property
    def frame(self) -> pin.SE3:
        """Frame in the world: metres."""
        return shifted(self.x, self.y, TRAY_SIZE[2])

    def quadrant(self, number: int) -> tuple[float, float]:
        """The middle of a quadrant, metres in the world: 1 and 2 have the larger y, 1 and 3 the smaller x."""
        across = -1.0 if number in (1, 3) else 1.0
        along = 1.0 if number in (1, 2) else -1.0
        return self.x + across * TRAY_SIZE[0] / 4.0, self.y + along * TRAY_SIZE[1] / 4.0

    def quadrant_of(self, x: float, y: float) -> int | None:
        """The quadrant that a point of the world is in; None beside the tray."""
        dx, dy = x - self.x, y - self.y
        if abs(dx) > TRAY_SIZE[0] / 2.0 or abs(dy) > TRAY_SIZE[1] / 2.0:
            return None
        return 1 + (dx > 0.0) + 2 * (dy < 0.0)


PLACES: Final = {1: TrayPlace(1, 0.92, 0.50), 2: TrayPlace(2, -0.68, -0.20)}
"""The trays by number."""


def changed(config: RobotConfig, trial: Trial) -> RobotConfig:
    """The cell of a trial, of that in the robot's file. Raises `ConfigError` for a trial that it cannot have."""
    cell = config.cell
    if cell is None or cell.conveyor is None:
        raise ConfigError("a trial needs a cell with a conveyor")
    check(trial, cell)
    belt = cell.conveyor
    start = belt.pose.y - belt.length / 2.0
    middle = (start + BELT_END) / 2.0
    gone = {cell.car, *trial.missing_parts}
    boxes = iter(COMING_BOXES if trial.belt_speeds else WAITING_BOXES)
    parts = []
    for part in cell.parts:
        if part.name in gone:
            continue
        if cell.types[part.type].kind is PartKind.BOX:
            place = replace(part, pose=Pose(BELT_X, next(boxes), belt.pose.z, 0.0, 0.0, QUARTER))
        else:
            place = upside_down(part, cell) if part.name in trial.flipped_parts else part
            if part.name == QUALITY_CONTROL:
                place = replace(part, type=POST.name)
        parts.append(place)
    tables = [_table(place) for place in PLACES.values()]
    fixtures = tuple(fixture for fixture in cell.fixtures if fixture.name not in ("stand", "ramp"))
    new = replace(
        cell,
        types={**cell.types, POST.name: POST},
        car="",
        target=None,
        conveyor=replace(belt, pose=replace(belt.pose, y=middle), length=BELT_END - start),
        fixtures=(*fixtures, *tables),
        parts=tuple(parts),
    )
    modules = tuple(module for module in config.modules if module.part not in gone)
    return config.model_copy(update={"cell": new, "modules": modules})


def upside_down(part: PlacedPart, cell: CellSetup) -> PlacedPart:
    """A part that is turned by half a turn about its own z axis, through the middle of its housing."""
    middle = Transform(position=cell.types[part.type].solids[0].pose.position)
    turn = Transform(rotation_about(Z, 2.0 * QUARTER))
    frame = Transform.from_pose(part.pose) @ middle @ turn @ middle.inverse()
    return replace(part, pose=frame.to_pose())


def _table(place: TrayPlace) -> Fixture:
    x, y, height = TRAY_SIZE
    solid = PartSolid(Shape.CUBOID, (x, y, height), 0.0, Transform(position=(place.x, place.y, height / 2.0)))
    return Fixture(place.name, (solid,))


def is_flipped(frame: pin.SE3, grasp: Transform) -> bool:
    """True if a part's grasp looks down: it lies upside down."""
    return bool((frame * se3(grasp)).rotation[2, 2] > 0.0)
