"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_velocity_state_driver as manipulator_v1_0_manipulator_end_effector_velocity_state_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver", "2.0")

@jd.derived(_SERVICE)
class SetEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_driver.SetEndEffectorVelocityState): ...

@jd.derived(_SERVICE)
class ReportCommandedEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_driver.ReportCommandedEndEffectorVelocityState): ...

@jd.derived(_SERVICE)
class QueryCommandedEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_driver.QueryCommandedEndEffectorVelocityState):
    REPORT = ReportCommandedEndEffectorVelocityState
