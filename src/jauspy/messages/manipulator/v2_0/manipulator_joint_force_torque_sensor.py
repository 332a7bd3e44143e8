"""urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_joint_force_torque_sensor as manipulator_v1_0_manipulator_joint_force_torque_sensor

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointForceTorqueSensor", "2.0")

@jd.derived(_SERVICE)
class ReportJointForceTorques(manipulator_v1_0_manipulator_joint_force_torque_sensor.ReportJointForceTorques): ...

@jd.derived(_SERVICE)
class QueryJointForceTorques(manipulator_v1_0_manipulator_joint_force_torque_sensor.QueryJointForceTorques):
    REPORT = ReportJointForceTorques
