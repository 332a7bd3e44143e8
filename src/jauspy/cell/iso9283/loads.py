"""Test loads: known masses that are bolted to the UR10's gripper, or put on the tip of the modular arm.

The UR10 knows its load, as one whose payload is set; the modular arm estimates what it carries.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import parse_urdf
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import PartKind, PartSolid, PartType, PlacedPart, Shape

GRIPPER_MASS: Final = 0.6
"""Kilograms of the UR10's gripper, which are part of its load."""
UR10_RATED: Final = 10.0
"""Kilograms: the payload of the UR10's data sheet, gripper included."""
ARM_RATED: Final = 0.5
"""Kilograms at the tip of the modular arm: an assumption, more than the box of 0.3 kg that its tasks lift."""
DENSITY: Final = 7850.0
"""kg/m^3 of steel."""
RADIUS: Final = 0.03
"""Metres of the UR10's load, a cylinder of steel."""
BLOCK: Final = (0.12, 0.12, 0.03)
"""Metres of the modular arm's load, whose density follows from its mass."""
LOAD: Final = "test_load"
"""Name of the part, its type, and the link."""
ASIDE: Final = Pose(-1.6, 1.6, 0.001)
"""Where the part lies before it is put on the tip."""


def with_bolted_load(model: RobotModel, mass: float) -> RobotModel:
    """The cell whose UR10 carries this mass, gripper included, in front of its gripper: kilograms.

    Raises `ConfigError` for less than the gripper's own mass.
    """
    if (added := mass - GRIPPER_MASS) <= 0.0:
        raise ConfigError(f"the UR10's load includes its gripper of {GRIPPER_MASS:g} kg; {mass:g} kg is less")
    length = added / (DENSITY * math.pi * RADIUS**2)
    across, along = added * (3.0 * RADIUS**2 + length**2) / 12.0, added * RADIUS**2 / 2.0
    elements = (
        f'<link name="{LOAD}"><inertial><origin xyz="0 0 {length / 2.0}"/><mass value="{added}"/>'
        f'<inertia ixx="{across}" iyy="{across}" izz="{along}" ixy="0" ixz="0" iyz="0"/></inertial></link>'
        f'<joint name="gripper_to_{LOAD}" type="fixed"><parent link="gripper"/><child link="{LOAD}"/></joint>'
    )
    head, end, tail = model.description.urdf.rpartition("</robot>")
    return replace(model, description=parse_urdf(f"{head}{elements}{end}{tail}"))


def with_load_part(model: RobotModel, mass: float) -> RobotModel:
    """The cell with one more part, `LOAD`, of this mass in kilograms."""
    cell = model.cell
    if cell is None:
        raise ConfigError(f"{model.description.name} has no [cell]")
    solid = PartSolid(Shape.CUBOID, BLOCK, mass, Transform(position=(0.0, 0.0, BLOCK[2] / 2.0)))
    kind = PartType(LOAD, PartKind.BOX, (solid,))
    parts = (*cell.parts, PlacedPart(LOAD, LOAD, ASIDE))
    return replace(model, cell=replace(cell, types={**cell.types, LOAD: kind}, parts=parts))
