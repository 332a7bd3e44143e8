"""What the pan-tilt services of a component share: the two joints, and how they count."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from jauspy.platform.description import Joint, JointKind
from jauspy.platform.joints import JointGroup
from jauspy.platform.transforms import joint_frame
from jauspy.platform.vectors import Transform, Vector, Y, Z, cross, dot, transposed
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.denavit_hartenberg import geometry
from jauspy.services.manipulator.turned_joints import TurnedJoints, turned_joint
from jauspy.services.units import JAUS_FROM_REP_103


class PanTilt(Arm):
    """A unit of two revolute joints that are at right angles; the first pans, the second tilts.

    Angles are zero where the description has its zero, and grow about the axes that JAUS gives what is carried: pan
    about z, which is down, so to the right; tilt about y, which is right, so upwards. `mount` tells where the group's
    base link is on the vehicle now, both as in REP-103.
    """

    def __init__(self, joints: JointGroup, mount: Callable[[], Transform]) -> None:
        super().__init__(TurnedJoints(joints, turned(joints.chain)))
        self._frame = frame_at_zero(joints.chain)
        self._mount = mount

    @property
    def coordinate_system(self) -> Transform:
        """In the vehicle's frame (JAUS's axes): z along pan, y along tilt, x ahead; where the two axes are closest."""
        return JAUS_FROM_REP_103 @ self._mount() @ self._frame


def frame_at_zero(chain: Sequence[Joint]) -> Transform:
    """The unit's coordinate system in its base link, and, at zero, the frames of both joints, which turn with them."""
    turns = iter(turned(chain))
    joints = [joint if joint.kind is JointKind.FIXED or not next(turns) else turned_joint(joint) for joint in chain]
    found = geometry(joints)
    pan = found.base @ found.links[0].frame(0.0)
    y, z = (pan @ found.links[1].frame(0.0)).turn(Z), pan.turn(Z)
    return Transform(transposed((cross(y, z), y, z)), pan.position)


def turned(chain: Sequence[Joint]) -> tuple[bool, bool]:
    """Whether pan and tilt count the other way round than the description does: down and right is as they should be."""
    frame, axes = Transform(), list[Vector]()
    for joint in chain:
        if joint.kind is not JointKind.FIXED:
            axes.append((frame @ Transform.of(joint.origin)).turn(joint.axis))
        frame = frame @ joint_frame(joint, 0.0)
    pan, tilt = axes
    return dot(pan, frame.turn(Z)) > 0.0, dot(tilt, frame.turn(Y)) > 0.0
