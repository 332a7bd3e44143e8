"""urn:jaus:jss:manipulator:ManipulatorListDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_list_driver as manipulator_v1_0_manipulator_end_effector_pose_list_driver


class ExecuteList(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ExecuteList):
    """ExecuteList (0x061E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorListDriver"
    VERSION = "2.0"


class QueryActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.QueryActiveElement):
    """QueryActiveElement (0x261E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorListDriver"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportActiveElement]]


class ReportActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ReportActiveElement):
    """ReportActiveElement (0x461E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorListDriver"
    VERSION = "2.0"


QueryActiveElement.REPORT = ReportActiveElement
