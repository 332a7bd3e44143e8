"""urn:jaus:jss:manipulator:PanTiltJointVelocityDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointVelocityDriver", "2.0")


@jd.message(_SERVICE, 0x0623, command=True)
class SetPanTiltJointVelocity(jd.Message):
    """SetPanTiltJointVelocity (0x0623): Sets the angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """
    joint1_velocity: float = jd.field("Joint1Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))
    joint2_velocity: float = jd.field("Joint2Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))


@jd.message(_SERVICE, 0x4631)
class ReportCommandedPanTiltJointVelocity(jd.Message):
    """ReportCommandedPanTiltJointVelocity (0x4631): Tells the commanded angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """
    joint1_velocity: float = jd.field("Joint1Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))
    joint2_velocity: float = jd.field("Joint2Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))


@jd.message(_SERVICE, 0x2631, query=True)
class QueryCommandedPanTiltJointVelocity(jd.Message):
    """QueryCommandedPanTiltJointVelocity (0x2631): Asks for the commanded angular velocities."""
    REPORT = ReportCommandedPanTiltJointVelocity
