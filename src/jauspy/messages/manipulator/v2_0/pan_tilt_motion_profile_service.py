"""urn:jaus:jss:manipulator:PanTiltMotionProfileService 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver


class QueryPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.QueryPanTiltMotionProfile):
    """QueryPanTiltMotionProfile (0x2627): Asks for the limits of speed and acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltMotionProfileService"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportPanTiltMotionProfile]]


class SetPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.SetPanTiltMotionProfile):
    """SetPanTiltMotionProfile (0x0627): Sets limits of speed and acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltMotionProfileService"
    VERSION = "2.0"


class ReportPanTiltMotionProfile(manipulator_v1_0_pan_tilt_joint_position_driver.ReportPanTiltMotionProfile):
    """ReportPanTiltMotionProfile (0x4627): Tells the limits of speed and acceleration."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltMotionProfileService"
    VERSION = "2.0"


QueryPanTiltMotionProfile.REPORT = ReportPanTiltMotionProfile
