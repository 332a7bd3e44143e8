"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_velocity_state_sensor as manipulator_v1_0_manipulator_end_effector_velocity_state_sensor

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor", "2.0")

@jd.derived(_SERVICE)
class ReportEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_sensor.ReportEndEffectorVelocityState): ...

@jd.derived(_SERVICE)
class QueryEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_sensor.QueryEndEffectorVelocityState):
    REPORT = ReportEndEffectorVelocityState
