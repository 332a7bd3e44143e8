"""urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_list_driver as manipulator_v1_0_manipulator_end_effector_pose_list_driver
from jauspy.messages.manipulator.v1_0 import manipulator_joint_position_driver as manipulator_v1_0_manipulator_joint_position_driver


class ExecuteList(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ExecuteList):
    """ExecuteList (0x061E): Starts the list at an element, at a speed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"


class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile):
    """SetMotionProfile (0x0607): Sets limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"


class QueryActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.QueryActiveElement):
    """QueryActiveElement (0x261E): Asks which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportActiveElement]]


class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportManipulatorSpecifications]]


class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    """QueryMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportMotionProfile]]


class QueryCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.QueryCommandedJointPositions):
    """QueryCommandedJointPositions (0x2608): Asks for the commanded position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"
    REPORT: ClassVar[type[ReportCommandedJointPositions]]


class ReportActiveElement(manipulator_v1_0_manipulator_end_effector_pose_list_driver.ReportActiveElement):
    """ReportActiveElement (0x461E): Tells which element of the list is being carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"


class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"


class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile):
    """ReportMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"


class ReportCommandedJointPositions(manipulator_v1_0_manipulator_joint_position_driver.ReportCommandedJointPositions):
    """ReportCommandedJointPositions (0x4608): Tells the commanded position of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointPositionsListDriver"
    VERSION = "1.0"


QueryActiveElement.REPORT = ReportActiveElement
QueryManipulatorSpecifications.REPORT = ReportManipulatorSpecifications
QueryMotionProfile.REPORT = ReportMotionProfile
QueryCommandedJointPositions.REPORT = ReportCommandedJointPositions
