"""urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver", "2.0")

@jd.derived(_SERVICE)
class ReportCommandedActuatorForceTorques(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportCommandedActuatorForceTorques): ...

@jd.derived(_SERVICE)
class QueryCommandedActuatorForceTorques(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryCommandedActuatorForceTorques):
    REPORT = ReportCommandedActuatorForceTorques

@jd.derived(_SERVICE)
class SetActuatorForceTorques(manipulator_v1_0_manipulator_actuator_force_torque_driver.SetActuatorForceTorques): ...
