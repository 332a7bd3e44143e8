"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_velocity_state_sensor as manipulator_v1_0_manipulator_end_effector_velocity_state_sensor


class QueryEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_sensor.QueryEndEffectorVelocityState):
    """QueryEndEffectorVelocityState (0x2616): Asks for the velocity of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportEndEffectorVelocityState]]


class ReportEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_sensor.ReportEndEffectorVelocityState):
    """ReportEndEffectorVelocityState (0x4616): Tells the velocity of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor"
    VERSION = "2.0"


QueryEndEffectorVelocityState.REPORT = ReportEndEffectorVelocityState
