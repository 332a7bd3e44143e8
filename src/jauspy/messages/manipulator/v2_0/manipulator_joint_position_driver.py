"""urn:jaus:jss:manipulator:ManipulatorJointPositionDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_joint_position_driver as manipulator_v1_0_manipulator_joint_position_driver


class QueryCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.QueryCommandedJointPositions):
    """QueryCommandedJointPositions (0x2608): Asks for the commanded position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportCommandedJointPositions]]


class SetJointPositions(manipulator_v1_0_manipulator_joint_position_driver.SetJointPositions):
    """SetJointPositions (0x0602): Sets the position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "2.0"


class ReportCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.ReportCommandedJointPositions):
    """ReportCommandedJointPositions (0x4608): Tells the commanded position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionDriver"
    VERSION = "2.0"


QueryCommandedJointPositions.REPORT = ReportCommandedJointPositions
