"""What stands in the cell, as the robot's file describes it: the planning scene, and the library of parts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import coal
import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, se3, se3_of_pose, shifted
from jauspy.cell.kinematics import ArmKinematics
from jauspy.cell.scene import Piece, PlanningScene, links_of_urdf, pieces_of, pieces_of_part
from jauspy.errors import ConfigError
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.platform.modular.parts import CellSetup, PartType

FLOOR_SIZE: Final = 8.0
BELT_THICKNESS: Final = 0.1
ACCELERATION_TIME: Final = 0.35
"""Seconds in which a joint reaches full speed; more than the joints need, so that parts are carried without a jerk."""


def cell_of(model: RobotModel) -> CellSetup:
    """The cell around a robot. Raises `ConfigError` for a robot without one."""
    if model.cell is None:
        raise ConfigError("this robot's file has no [cell]; `jauspy cell` needs a factory cell, such as cell.toml")
    return model.cell


def arm_group(model: RobotModel) -> GroupSetup:
    """The joints of the arm with the gripper. Raises `ConfigError` if there is none."""
    cell = cell_of(model)
    for group in model.groups.values():
        if group.tip == cell.gripper:
            return group
    raise ConfigError(f"no group of joints ends at the gripper {cell.gripper!r}")


class Layout:
    """The cell's types of parts, its bases, and the arm that handles parts."""

    def __init__(self, model: RobotModel) -> None:
        self.setup = cell_of(model)
        self.group = arm_group(model)
        self.urdf = model.description.urdf
        self.kinematics = ArmKinematics(self.urdf, self.group.joints, self.group.tip)
        self.home: Array = np.array(self.group.start)
        self.speeds: Array = self.kinematics.speeds
        """rad/s."""
        self.accelerations: Array = self.speeds / ACCELERATION_TIME
        """rad/s^2."""
        self._types: Mapping[str, str] = {each.name: each.type for each in self.setup.parts}

    def type_of(self, part: str) -> PartType:
        """The type of a part. Raises `ConfigError` for an unknown name."""
        return self.setup.type_of(part)

    def of_types(self, types: tuple[str, ...]) -> list[str]:
        """The names of the parts of these types: those of the first type first."""
        return [name for type in types for name, each in self._types.items() if each == type]

    def scene(self) -> PlanningScene:
        """A scene with all that is fixed, and the parts where the file has them."""
        scene = PlanningScene(self.kinematics, links_of_urdf(self.urdf, self.group.joints))
        scene.put("floor", [Piece(coal.Box(FLOOR_SIZE, FLOOR_SIZE, 0.1), shifted(z=-0.05))], pin.SE3.Identity())
        for bin in self.setup.bins:
            scene.put(bin.name, pieces_of(bin.solids()), se3_of_pose(bin.pose))
        for fixture in self.setup.fixtures:
            scene.put(fixture.name, pieces_of(fixture.solids), se3_of_pose(fixture.pose))
        if (belt := self.setup.conveyor) is not None:
            box = coal.Box(belt.length, belt.width, BELT_THICKNESS)
            scene.put("conveyor", [Piece(box, shifted(z=-BELT_THICKNESS / 2.0))], se3_of_pose(belt.pose))
        for part in self.setup.parts:
            scene.put(part.name, pieces_of_part(self.type_of(part.name)), se3_of_pose(part.pose))
        return scene

    def grasp(self, part: str) -> pin.SE3:
        """Where the gripper is in the part's frame when it holds the part."""
        return se3(self.type_of(part).grasp)
