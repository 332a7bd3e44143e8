"""urn:jaus:jss:manipulator:ManipulatorJointPositionSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_joint_position_sensor as manipulator_v1_0_manipulator_joint_position_sensor


class QueryJointPositions(manipulator_v1_0_manipulator_joint_position_sensor.QueryJointPositions):
    """QueryJointPositions (0x2602): Asks for the position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportJointPositions]]


class ReportJointPositions(manipulator_v1_0_manipulator_joint_position_sensor.ReportJointPositions):
    """ReportJointPositions (0x4602): Tells the position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionSensor"
    VERSION = "2.0"


QueryJointPositions.REPORT = ReportJointPositions
