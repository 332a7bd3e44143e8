"""urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor", "1.0")


@jd.message(_SERVICE, 0x4605)
class ReportJointForceTorques(jd.Message):
    """ReportJointForceTorques (0x4605): Tells the force or torque of each joint.

    actuator_force_torque_list: 0..255 items. The joints, from the base
    """
    ActuatorForceTorqueRec = manipulator_v1_0_types.ActuatorForceTorqueRec
    actuator_force_torque_list: list[manipulator_v1_0_types.ActuatorForceTorqueRec] = jd.field("ActuatorForceTorqueList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.ActuatorForceTorqueRec.layout()))


@jd.message(_SERVICE, 0x2605, query=True)
class QueryJointForceTorques(jd.Message):
    """QueryJointForceTorques (0x2605): Asks for the force or torque of each joint."""
    REPORT = ReportJointForceTorques

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications
