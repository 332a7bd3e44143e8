"""Where lidars, cameras and other sensors are mounted on a robot."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.urdf import JointKind
from jauspy.ids import JausID
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup, joint_positions
from jauspy.services.environment_sensing import JointMount

from .kind import Module


def frame_of(tree: FrameTree, link: str, groups: Mapping[str, JointGroup]) -> Callable[[], Transform]:
    """Returns a link's present frame in the root link's frame (REP-103)."""
    if tree.is_fixed(link):
        fixed = tree.pose(link)
        return lambda: fixed
    return lambda: tree.pose(link, joint_positions(groups.values()))


def joint_of(modules: Mapping[JausID, Module], model: RobotModel, link: str) -> JointMount | None:
    """The last joint before a link, if a CM-MAN or a CM-VIS moves it; None for one that is fixed, or on a finger."""
    description = model.description
    moving = [joint for joint in description.chain(description.root(), link) if joint.kind is not JointKind.FIXED]
    for id, module in modules.items() if moving else ():
        group = model.groups.get(module.moves or "")
        if group is None or moving[-1].name not in group.joints:
            continue
        number = 1 + group.joints.index(moving[-1].name)
        frame = module.kind.joint_frame(description.chain(group.base, group.tip), number)
        if frame is not None:
            return JointMount(id, number, frame.inverse() @ _at_zero(model, group.base, link) @ JAUS_FROM_REP_103)
    return None


def _at_zero(model: RobotModel, base: str, link: str) -> Transform:
    """The frame of `link` in that of `base`, with all joints at zero."""
    tree = FrameTree(model.description)
    return tree.pose(base).inverse() @ tree.pose(link)
