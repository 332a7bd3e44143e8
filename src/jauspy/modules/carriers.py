"""Which joint a sensor moves with, as JAUS names joints: the component that moves them, and a number."""

from __future__ import annotations

from functools import reduce
from operator import matmul

from jauspy.geometry.denavit_hartenberg import manipulator_geometry, pan_tilt_frame
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.urdf import JointKind
from jauspy.modules.config import ModuleConfig, RobotConfig
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.services.environment_sensing import OnJoint


def carrier_of(config: RobotConfig, model: RobotModel, link: str) -> OnJoint | None:
    """The last joint before a link, if a CM-MAN or a CM-VIS moves it; None for one that is fixed, or on a finger."""
    description = model.description
    moving = [each for each in description.chain(description.root(), link) if each.kind is not JointKind.FIXED]
    for module in config.modules if moving else ():
        group = model.groups.get(module.moves or "")
        if module.type in {"CM-MAN", "CM-VIS"} and group is not None and moving[-1].name in group.joints:
            number = 1 + group.joints.index(moving[-1].name)
            frame = _joint_frame(module, model, group, number).inverse() @ _at_zero(model, group.base, link)
            return OnJoint(config.id_of(module), number, frame @ JAUS_FROM_REP_103)
    return None


def _joint_frame(module: ModuleConfig, model: RobotModel, group: GroupSetup, number: int) -> Transform:
    """In the group's base link, with all joints at zero: as the specification of the arm or the unit has it."""
    chain = model.description.chain(group.base, group.tip)
    if module.type == "CM-VIS":
        return pan_tilt_frame(chain)
    found = manipulator_geometry(chain)
    return reduce(matmul, (link.frame(link.zero_position) for link in found.links[:number]), found.base)


def _at_zero(model: RobotModel, base: str, link: str) -> Transform:
    tree = FrameTree(model.description)
    return tree.pose(base).inverse() @ tree.pose(link)
