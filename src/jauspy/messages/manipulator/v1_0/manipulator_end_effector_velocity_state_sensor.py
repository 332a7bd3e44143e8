"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateSensor", "1.0")

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications

@jd.derived(_SERVICE)
class ReportToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportToolOffset): ...

@jd.derived(_SERVICE)
class QueryToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryToolOffset):
    REPORT = ReportToolOffset

@jd.derived(_SERVICE)
class SetToolOffset(manipulator_v1_0_manipulator_end_effector_pose_driver.SetToolOffset): ...


@jd.message(_SERVICE, 0x4616)
class ReportEndEffectorVelocityState(jd.Message):
    """ReportEndEffectorVelocityState (0x4616): Tells the velocity of the tool point.

    angular_velocity_component_x: -62.8318530718..62.8318530718 radian per second. Angular velocity about X, in radians per second
    angular_velocity_component_y: -62.8318530718..62.8318530718 radian per second. Angular velocity about Y, in radians per second
    angular_velocity_component_z: -62.8318530718..62.8318530718 radian per second. Angular velocity about Z, in radians per second
    linear_velocity_component_x: -10..10 meter per second. Velocity along X, in metres per second
    linear_velocity_component_y: -10..10 meter per second. Velocity along Y, in metres per second
    linear_velocity_component_z: -10..10 meter per second. Velocity along Z, in metres per second
    """
    angular_velocity_component_x: float = jd.field("AngularVelocityComponentX", jd.real("I", -62.83185307179586, 62.83185307179586, "radian per second"))
    angular_velocity_component_y: float = jd.field("AngularVelocityComponentY", jd.real("I", -62.83185307179586, 62.83185307179586, "radian per second"))
    angular_velocity_component_z: float = jd.field("AngularVelocityComponentZ", jd.real("I", -62.83185307179586, 62.83185307179586, "radian per second"))
    linear_velocity_component_x: float = jd.field("LinearVelocityComponentX", jd.real("I", -10.0, 10.0, "meter per second"))
    linear_velocity_component_y: float = jd.field("LinearVelocityComponentY", jd.real("I", -10.0, 10.0, "meter per second"))
    linear_velocity_component_z: float = jd.field("LinearVelocityComponentZ", jd.real("I", -10.0, 10.0, "meter per second"))


@jd.message(_SERVICE, 0x2616, query=True)
class QueryEndEffectorVelocityState(jd.Message):
    """QueryEndEffectorVelocityState (0x2616): Asks for the velocity of the tool point."""
    REPORT = ReportEndEffectorVelocityState
