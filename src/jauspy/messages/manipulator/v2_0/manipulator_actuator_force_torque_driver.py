"""urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver


class QueryCommandedActuatorForceTorques(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryCommandedActuatorForceTorques):
    """QueryCommandedActuatorForceTorques (0x2613): Asks for the commanded force or torque of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportCommandedActuatorForceTorques]]


class SetActuatorForceTorques(manipulator_v1_0_manipulator_actuator_force_torque_driver.SetActuatorForceTorques):
    """SetActuatorForceTorques (0x0613): Sets the force or torque of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "2.0"


class ReportCommandedActuatorForceTorques(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportCommandedActuatorForceTorques):
    """ReportCommandedActuatorForceTorques (0x4613): Tells the commanded force or torque of each joint."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver"
    VERSION = "2.0"


QueryCommandedActuatorForceTorques.REPORT = ReportCommandedActuatorForceTorques
