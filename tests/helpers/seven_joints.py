"""An arm of seven joints on a post, in the proportions of those with a ball-like shoulder, elbow and wrist."""

from __future__ import annotations

from jauspy.geometry.urdf import parse_urdf
from jauspy.platform.description import GroupSetup, RobotModel

JOINTS = (
    # height on the link before, axis, limit (rad), speed (rad/s), length and radius of the link that it moves
    (0.30, "0 0 1", 2.9, 1.7, 0.14, 0.060),
    (0.16, "0 1 0", 2.0, 1.7, 0.18, 0.060),
    (0.20, "0 0 1", 2.9, 1.7, 0.16, 0.055),
    (0.20, "0 -1 0", 2.0, 2.2, 0.16, 0.055),
    (0.18, "0 0 1", 2.9, 2.4, 0.18, 0.050),
    (0.20, "0 1 0", 2.0, 3.1, 0.06, 0.045),
    (0.09, "0 0 1", 3.0, 3.1, 0.06, 0.040),
)
START = (0.0, 0.4, 0.0, 1.2, 0.0, 0.8, 0.0)


def urdf() -> str:
    """The arm's URDF; links are rods upward when all joints are at zero."""
    parts = ['<robot name="seven"><link name="link_0">', _rod(0.28, 0.07), "</link>"]
    for number, (height, axis, limit, speed, length, radius) in enumerate(JOINTS, 1):
        parts.append(
            f'<link name="link_{number}">{_rod(length, radius)}</link>'
            f'<joint name="joint_{number}" type="revolute">'
            f'<parent link="link_{number - 1}"/><child link="link_{number}"/>'
            f'<origin xyz="0 0 {height}"/><axis xyz="{axis}"/>'
            f'<limit lower="-{limit}" upper="{limit}" effort="100" velocity="{speed}"/></joint>'
        )
    parts.append(
        '<link name="tool"/><joint name="flange" type="fixed"><parent link="link_7"/><child link="tool"/>'
        '<origin xyz="0 0 0.1"/></joint></robot>'
    )
    return "".join(parts)


def seven_joints() -> RobotModel:
    """The robot, whose group is `arm`."""
    names = tuple(f"joint_{number}" for number in range(1, 8))
    group = GroupSetup(names, {}, "link_0", "tool", 250.0, START)
    return RobotModel(parse_urdf(urdf()), None, {"arm": group})


def _rod(length: float, radius: float) -> str:
    return (
        f'<inertial><origin xyz="0 0 {length / 2}"/><mass value="2"/>'
        '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
        f'<collision><origin xyz="0 0 {length / 2}"/>'
        f'<geometry><cylinder radius="{radius}" length="{length}"/></geometry></collision>'
    )
