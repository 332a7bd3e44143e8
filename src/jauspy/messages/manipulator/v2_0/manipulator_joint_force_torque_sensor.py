"""urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_joint_force_torque_sensor as manipulator_v1_0_manipulator_joint_force_torque_sensor


class QueryJointForceTorques(manipulator_v1_0_manipulator_joint_force_torque_sensor.QueryJointForceTorques):
    """QueryJointForceTorques (0x2605): Asks for the force or torque of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportJointForceTorques]]


class ReportJointForceTorques(manipulator_v1_0_manipulator_joint_force_torque_sensor.ReportJointForceTorques):
    """ReportJointForceTorques (0x4605): Tells the force or torque of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor"
    VERSION = "2.0"


QueryJointForceTorques.REPORT = ReportJointForceTorques
