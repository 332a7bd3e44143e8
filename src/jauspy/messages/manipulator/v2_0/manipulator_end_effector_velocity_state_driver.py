"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_velocity_state_driver as manipulator_v1_0_manipulator_end_effector_velocity_state_driver


class SetEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_driver.SetEndEffectorVelocityState):
    """SetEndEffectorVelocityState (0x0612): Sets the velocity of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver"
    VERSION = "2.0"


class QueryCommandedEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_driver.QueryCommandedEndEffectorVelocityState):
    """QueryCommandedEndEffectorVelocityState (0x2612): Asks for the commanded velocity of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver"
    VERSION = "2.0"
    REPORT: ClassVar[type[ReportCommandedEndEffectorVelocityState]]


class ReportCommandedEndEffectorVelocityState(manipulator_v1_0_manipulator_end_effector_velocity_state_driver.ReportCommandedEndEffectorVelocityState):
    """ReportCommandedEndEffectorVelocityState (0x4612): Tells the commanded velocity of the tool point."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver"
    VERSION = "2.0"


QueryCommandedEndEffectorVelocityState.REPORT = ReportCommandedEndEffectorVelocityState
