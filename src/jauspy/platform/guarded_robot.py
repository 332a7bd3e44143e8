"""A robot whose commands pass guards before they reach its joints and its chassis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from typing import TYPE_CHECKING

from jauspy.platform.camera import CameraSource
from jauspy.platform.contract import DriveBase, OptionalPart, Robot
from jauspy.platform.description import RobotModel
from jauspy.platform.force_torque import ForceTorqueSensor
from jauspy.platform.joints import JointGroup
from jauspy.platform.ranging import RangeFinder

if TYPE_CHECKING:
    from jauspy.platform.drive_guard import DriveGuard
    from jauspy.platform.joint_guard import JointGuard


class GuardedRobot:
    """A `Robot` with the guards that it can have: against self collision, and against obstacles.

    All commands to joints and chassis pass them, whichever service or program gives them. `inner` is the robot itself.
    """

    def __init__(self, inner: Robot, model: RobotModel) -> None:
        self.inner = inner
        """The robot itself, without guards."""
        self.groups: Mapping[str, JointGroup] = inner.groups
        """Joints besides the chassis, whose commands pass the guard."""
        self.drive: DriveBase = inner.drive
        """The chassis, whose commands pass the guard."""
        self._joint_guard: JointGuard | None = None
        self._drive_guard: DriveGuard | None = None
        if find_spec("numpy") is not None:  # only robots with a simulation or sensors have it for sure
            self._add_guards(model)

    def _add_guards(self, model: RobotModel) -> None:
        from jauspy.platform.drive_guard import drive_guard  # noqa: PLC0415 - they need numpy
        from jauspy.platform.joint_guard import JointGuard  # noqa: PLC0415

        joint_guard = JointGuard(model, model.self_collision, self.inner.groups)
        if joint_guard.can_guard:
            self._joint_guard, self.groups = joint_guard, joint_guard.groups
        if (guard := drive_guard(model, self.inner)) is not None:
            self._drive_guard, self.drive = guard, guard.drive

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """Lidars by name."""
        return self.inner.lidars

    @property
    def force_torque(self) -> Mapping[str, ForceTorqueSensor]:
        """Sensors of force and torque by name."""
        return self.inner.force_torque

    @property
    def cameras(self) -> Mapping[str, CameraSource]:
        """Cameras by name."""
        return self.inner.cameras

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """The parts of the robot itself, and its guards."""
        guards = (self._joint_guard, self._drive_guard)
        return (*self.inner.optional_parts, *(guard for guard in guards if guard is not None))

    @property
    def time(self) -> float:
        """Seconds of the robot's own time since it was opened."""
        return self.inner.time

    def advance(self, dt: float) -> None:
        """Check the commands, and advance by `dt` seconds."""
        if self._joint_guard is not None:
            self._joint_guard.step(self.inner.time)
        if self._drive_guard is not None:
            self._drive_guard.step(self.inner.time)
        self.inner.advance(dt)

    def close(self) -> None:
        """Stop, and release all resources. May be called twice."""
        self.inner.close()
