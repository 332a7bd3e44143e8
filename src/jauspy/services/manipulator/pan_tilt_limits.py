"""PanTiltMotionProfileService and PanTiltSpecificationService: what a unit may do, and what it can (AS6057)."""

from __future__ import annotations

from jauspy.geometry.vectors import quaternion
from jauspy.messages.manipulator import (
    ReportPanTiltMotionProfile,
    ReportPanTiltSpecifications,
    SetPanTiltMotionProfile,
)
from jauspy.services.manipulator.arm import Profile
from jauspy.services.manipulator.motion_profile import within
from jauspy.services.manipulator.pan_tilt import PanTilt
from jauspy.services.service import Service


class PanTiltMotionProfile(Service, urn="urn:jaus:jss:manipulator:PanTiltMotionProfileService"):
    """rad/s and rad/s^2. Never beyond what the joints allow; they count from the next command on."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def pan_tilt_motion_profile_exists(self) -> bool:
        """There always is one: the joints' own limits, until a client sets others."""
        return True

    def set_pan_tilt_motion_profile(self, msg: SetPanTiltMotionProfile) -> None:
        """From the next command on."""
        pan = Profile(msg.joint1_max_speed, msg.joint1_max_acceleration_rate, msg.joint1_max_deceleration_rate)
        tilt = Profile(msg.joint2_max_speed, msg.joint2_max_acceleration_rate, msg.joint2_max_deceleration_rate)
        rows = zip((pan, tilt), self._unit.joints.joints, strict=True)
        self._unit.profiles = tuple(within(profile, Profile.of(joint)) for profile, joint in rows)

    def report_pan_tilt_motion_profile(self) -> ReportPanTiltMotionProfile:
        """What counts now."""
        pan, tilt = ((each.speed, each.acceleration, each.deceleration) for each in self._unit.profiles)
        return ReportPanTiltMotionProfile(*pan, *tilt)


class PanTiltSpecification(Service, urn="urn:jaus:jss:manipulator:PanTiltSpecificationService"):
    """Metres, radians and rad/s; the coordinate system as `PanTilt` has it."""

    def __init__(self, unit: PanTilt) -> None:
        self._unit = unit

    def report_pan_tilt_specifications(self) -> ReportPanTiltSpecifications:
        """Where it is on the vehicle now, and its limits."""
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
            joint1_min_value=pan.lower,
            joint1_max_value=pan.upper,
            joint1_max_speed=pan.velocity,
            joint2_min_value=tilt.lower,
            joint2_max_value=tilt.upper,
            joint2_max_speed=tilt.velocity,
        )
