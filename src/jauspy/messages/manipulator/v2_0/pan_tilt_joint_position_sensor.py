"""urn:jaus:jss:manipulator:PanTiltJointPositionSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import pan_tilt_joint_position_sensor as manipulator_v1_0_pan_tilt_joint_position_sensor


class QueryPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_sensor.QueryPanTiltJointPositions):
    """QueryPanTiltJointPositions (0x2622): Asks for the angles."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportPanTiltJointPositions]]


class ReportPanTiltJointPositions(manipulator_v1_0_pan_tilt_joint_position_sensor.ReportPanTiltJointPositions):
    """ReportPanTiltJointPositions (0x4622): Tells the angles."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:PanTiltJointPositionSensor"
    VERSION = "2.0"


QueryPanTiltJointPositions.REPORT = ReportPanTiltJointPositions
