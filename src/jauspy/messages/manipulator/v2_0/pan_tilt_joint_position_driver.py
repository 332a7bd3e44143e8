"""urn:jaus:jss:manipulator:PanTiltJointPositionDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_driver as manipulator_v1_0_pan_tilt_joint_position_driver


class QueryCommandedPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_driver.QueryCommandedPanTiltJointPositions):
    """QueryCommandedPanTiltJointPositions (0x2628): Asks for the commanded angles."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportCommandedPanTiltJointPositions]]


class SetPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_driver.SetPanTiltJointPositions):
    """SetPanTiltJointPositions (0x0622): Sets the angles."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "2.0"


class ReportCommandedPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_driver.ReportCommandedPanTiltJointPositions):
    """ReportCommandedPanTiltJointPositions (0x4628): Tells the commanded angles."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionDriver"
    VERSION = "2.0"


QueryCommandedPanTiltJointPositions.REPORT = ReportCommandedPanTiltJointPositions
