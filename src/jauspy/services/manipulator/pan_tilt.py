"""Pan-tilt units: drivers, sensors, motion profile and specification (AS6057).

Angles are radians, zero where the URDF has its zero; pan is positive to the right, tilt upwards.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from jauspy.geometry.denavit_hartenberg import pan_tilt_frame, reversed_axes, reversed_joint
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.vectors import quaternion
from jauspy.messages.manipulator import (
    ReportCommandedPanTiltJointPositions,
    ReportCommandedPanTiltJointVelocity,
    ReportPanTiltJointEffort,
    ReportPanTiltJointPositions,
    ReportPanTiltJointVelocity,
    ReportPanTiltMotionProfile,
    ReportPanTiltSpecifications,
    SetPanTiltJointEffort,
    SetPanTiltJointPositions,
    SetPanTiltJointVelocity,
    SetPanTiltMotionProfile,
)
from jauspy.platform.joints import JointGroup, JointState, Target
from jauspy.services.manipulator.arm import REPORTED_ANGLES, Arm, MotionProfile
from jauspy.services.manipulator.joints import EffortDriver, JointDriver, PositionDriver
from jauspy.services.manipulator.specification import limited_profile
from jauspy.services.service import Service

MAX_ANGLE: Final = REPORTED_ANGLES / 2.0


class ReversedJoints:
    """A `JointGroup` with the axes of some joints reversed. `reverse`: for each joint that moves, whether to do so."""

    def __init__(self, group: JointGroup, reverse: Sequence[bool]) -> None:
        self._group = group
        self._signs = tuple(-1.0 if is_reversed else 1.0 for is_reversed in reverse)
        names = {joint.name for joint, is_reversed in zip(group.joints, reverse, strict=True) if is_reversed}
        self.joints = tuple(reversed_joint(joint) if joint.name in names else joint for joint in group.joints)
        """The joints that move, base to tip."""
        self.chain = tuple(reversed_joint(joint) if joint.name in names else joint for joint in group.chain)
        """All joints from base to tip, fixed ones included."""

    def command(self, targets: Sequence[Target | None]) -> None:
        """Command each joint, base to tip; None leaves a joint as it is."""
        rows = zip(targets, self._signs, strict=True)
        self._group.command([target and replace(target, value=sign * target.value) for target, sign in rows])

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        self._group.hold()

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        state = self._group.state()
        positions, velocities, efforts = map(self._signed, (state.positions, state.velocities, state.efforts))
        return replace(state, positions=positions, velocities=velocities, efforts=efforts)

    def _signed(self, values: tuple[float, ...]) -> tuple[float, ...]:
        return tuple(sign * value for sign, value in zip(self._signs, values, strict=True))


class PanTilt(Arm):
    """Two revolute joints at right angles: the first pans about z (down), the second tilts about y (right).

    `mount` returns the present pose of the group's base link on the vehicle, both as in REP-103.
    """

    def __init__(self, joints: JointGroup, mount: Callable[[], Transform]) -> None:
        super().__init__(ReversedJoints(joints, reversed_axes(joints.chain)))
        self._frame = pan_tilt_frame(joints.chain)
        self._mount = mount

    @property
    def coordinate_system(self) -> Transform:
        """Frame in the vehicle's (JAUS's axes): z along pan, y along tilt, x ahead; where the axes are closest."""
        return JAUS_FROM_REP_103 @ self._mount() @ self._frame


class PanTiltJointPositionDriver(PositionDriver, urn="urn:jaus:jss:manipulator:PanTiltJointPositionDriver"):
    """Angles beyond a joint's limits are limited."""

    def pan_tilt_motion_profile_exists(self) -> bool:
        """Always True: without a command the limits of the joints apply."""
        return self.motion_profile_exists()

    def set_pan_tilt_joint_efforts(self, msg: SetPanTiltJointPositions) -> None:
        """Move to the angles. The action's name is that of the standard's JSIDL."""
        self.go([msg.joint1_position, msg.joint2_position])

    def report_commanded_pan_tilt_joint_positions(self) -> ReportCommandedPanTiltJointPositions:
        """The command, while it is carried out; else the present angles."""
        return ReportCommandedPanTiltJointPositions(*(self.commanded or self.arm.state().positions))


class PanTiltJointVelocityDriver(JointDriver, urn="urn:jaus:jss:manipulator:PanTiltJointVelocityDriver"):
    """rad/s; a joint stops at its limit."""

    def pan_tilt_motion_profile_exists(self) -> bool:
        """Always True: without a command the limits of the joints apply."""
        return self.motion_profile_exists()

    def set_pan_tilt_joint_velocity(self, msg: SetPanTiltJointVelocity) -> None:
        """Move at these velocities until the next command."""
        found = [msg.joint1_velocity, msg.joint2_velocity]
        self.arm.at_velocities(self, found)
        self.commanded = found
        self.on_endless_motion()

    def report_commanded_pan_tilt_joint_velocity(self) -> ReportCommandedPanTiltJointVelocity:
        """The command, while it is carried out; else zero."""
        return ReportCommandedPanTiltJointVelocity(*(self.commanded or (0.0, 0.0)))


class PanTiltMotionProfile(Service, urn="urn:jaus:jss:manipulator:PanTiltMotionProfileService"):
    """rad/s and rad/s^2, at most those of the joints; in force from the next command on."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def pan_tilt_motion_profile_exists(self) -> bool:
        """Always True: without a command the limits of the joints apply."""
        return True

    def set_pan_tilt_motion_profile(self, msg: SetPanTiltMotionProfile) -> None:
        """Set the profiles of pan and tilt."""
        pan = MotionProfile(msg.joint1_max_speed, msg.joint1_max_acceleration_rate, msg.joint1_max_deceleration_rate)
        tilt = MotionProfile(msg.joint2_max_speed, msg.joint2_max_acceleration_rate, msg.joint2_max_deceleration_rate)
        rows = zip((pan, tilt), self._unit.joints.joints, strict=True)
        self._unit.profiles = tuple(limited_profile(profile, MotionProfile.of(joint)) for profile, joint in rows)

    def report_pan_tilt_motion_profile(self) -> ReportPanTiltMotionProfile:
        """The profiles in force."""
        pan, tilt = ((profile.speed, profile.acceleration, profile.deceleration) for profile in self._unit.profiles)
        return ReportPanTiltMotionProfile(*pan, *tilt)


class PanTiltSpecification(Service, urn="urn:jaus:jss:manipulator:PanTiltSpecificationService"):
    """Coordinate system (`PanTilt.coordinate_system`) and limits; metres, radians and rad/s."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def report_pan_tilt_specifications(self) -> ReportPanTiltSpecifications:
        """The present coordinate system, and the limits: those of the field for a joint that turns without end."""
        system, (pan, tilt) = self._unit.coordinate_system, self._unit.joints.joints
        x, y, z = system.position
        d, a, b, c = quaternion(system.rotation)
        return ReportPanTiltSpecifications(
            pan_tilt_coordinate_sys_x=x,
            pan_tilt_coordinate_sys_y=y,
            pan_tilt_coordinate_sys_z=z,
            d_component_of_unit_quaternion_q=d,
            a_component_of_unit_quaternion_q=a,
            b_component_of_unit_quaternion_q=b,
            c_component_of_unit_quaternion_q=c,
            joint1_min_value=max(-MAX_ANGLE, pan.lower),
            joint1_max_value=min(MAX_ANGLE, pan.upper),
            joint1_max_speed=pan.velocity,
            joint2_min_value=max(-MAX_ANGLE, tilt.lower),
            joint2_max_value=min(MAX_ANGLE, tilt.upper),
            joint2_max_speed=tilt.velocity,
        )


class PanTiltJointPositionSensor(Service, urn="urn:jaus:jss:manipulator:PanTiltJointPositionSensor"):
    """Angles of pan and tilt."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def report_pan_tilt_joint_positions(self) -> ReportPanTiltJointPositions:
        """The angles after the last step."""
        return ReportPanTiltJointPositions(*self._unit.state().positions)


class PanTiltJointVelocitySensor(Service, urn="urn:jaus:jss:manipulator:PanTiltJointVelocitySensor"):
    """Angular velocities of pan and tilt, rad/s."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def report_pan_tilt_joint_velocity(self) -> ReportPanTiltJointVelocity:
        """The velocities after the last step."""
        return ReportPanTiltJointVelocity(*self._unit.state().velocities)


class PrimitivePanTilt(EffortDriver, urn="urn:jaus:jss:manipulator:PrimitivePanTilt"):
    """Open-loop efforts, in percent of what each joint can do; a joint with zero effort holds."""

    def set_pan_tilt_joint_effort(self, msg: SetPanTiltJointEffort) -> None:
        """Apply these until the next command."""
        self.apply([msg.joint1_effort, msg.joint2_effort])

    def report_pan_tilt_joint_effort(self) -> ReportPanTiltJointEffort:
        """The commanded efforts, in percent; zeros after a stop, and while another service moves the joints."""
        return ReportPanTiltJointEffort(*self.efforts)
