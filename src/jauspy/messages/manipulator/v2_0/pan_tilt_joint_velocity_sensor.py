"""urn:jaus:jss:manipulator:PanTiltJointVelocitySensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:manipulator:PanTiltJointVelocitySensor", "2.0")


@jd.message(_SERVICE, 0x4623)
class ReportPanTiltJointVelocity(jd.Message):
    """ReportPanTiltJointVelocity (0x4623): Tells the angular velocities.

    joint1_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the pan joint, in radians per second
    joint2_velocity: -31.4159265359..31.4159265359 radian per second. Angular velocity of the tilt joint, in radians per second
    """
    joint1_velocity: float = jd.field("Joint1Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))
    joint2_velocity: float = jd.field("Joint2Velocity", jd.real("I", -31.41592653589793, 31.41592653589793, "radian per second"))


@jd.message(_SERVICE, 0x2623, query=True)
class QueryPanTiltJointVelocity(jd.Message):
    """QueryPanTiltJointVelocity (0x2623): Asks for the angular velocities."""
    REPORT = ReportPanTiltJointVelocity
