"""What the pan-tilt services of a component share: the two joints, and how they count."""

from __future__ import annotations

from collections.abc import Callable

from jauspy.geometry.denavit_hartenberg import pan_tilt_frame, reversed_axes
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.platform.joints import JointGroup
from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.turned_joints import TurnedJoints


class PanTilt(Arm):
    """A unit of two revolute joints that are at right angles; the first pans, the second tilts.

    Angles are zero where the description has its zero, and grow about the axes that JAUS gives what is carried: pan
    about z, which is down, so to the right; tilt about y, which is right, so upwards. `mount` tells where the group's
    base link is on the vehicle now, both as in REP-103.
    """

    def __init__(self, joints: JointGroup, mount: Callable[[], Transform]) -> None:
        super().__init__(TurnedJoints(joints, reversed_axes(joints.chain)))
        self._frame = pan_tilt_frame(joints.chain)
        self._mount = mount

    @property
    def coordinate_system(self) -> Transform:
        """In the vehicle's frame (JAUS's axes): z along pan, y along tilt, x ahead; where the two axes are closest."""
        return JAUS_FROM_REP_103 @ self._mount() @ self._frame
