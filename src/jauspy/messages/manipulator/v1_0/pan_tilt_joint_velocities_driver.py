"""urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointVelocitiesDriver", "1.0")

@jd.derived(_SERVICE)
class ReportPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltSpecifications): ...

@jd.derived(_SERVICE)
class QueryPanTiltSpecifications(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltSpecifications):
    REPORT = ReportPanTiltSpecifications


@jd.message(_SERVICE, 0x0623, command=True)
class SetPanTiltJointVelocities(jd.Message):
    """SetPanTiltJointVelocities (0x0623): Sets the angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """
    joint1_velocity: float = jd.field("Joint1Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))
    joint2_velocity: float = jd.field("Joint2Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))

@jd.derived(_SERVICE)
class SetPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.SetPanTiltMotionProfile): ...


@jd.message(_SERVICE, 0x4631)
class ReportCommandedPanTiltJointVelocities(jd.Message):
    """ReportCommandedPanTiltJointVelocities (0x4631): Tells the commanded angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """
    joint1_velocity: float = jd.field("Joint1Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))
    joint2_velocity: float = jd.field("Joint2Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))


@jd.message(_SERVICE, 0x2631, query=True)
class QueryCommandedPanTiltJointVelocities(jd.Message):
    """QueryCommandedPanTiltJointVelocities (0x2631): Asks for the commanded angular velocities."""
    REPORT = ReportCommandedPanTiltJointVelocities

@jd.derived(_SERVICE)
class ReportPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltMotionProfile): ...

@jd.derived(_SERVICE)
class QueryPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltMotionProfile):
    REPORT = ReportPanTiltMotionProfile
