"""urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorEndEffectorVelocityStateDriver", "1.0")

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


@jd.message(_SERVICE, 0x0612, command=True)
class SetEndEffectorVelocityState(jd.Message):
    """SetEndEffectorVelocityState (0x0612): Sets the velocity of the tool point.

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

@jd.derived(_SERVICE)
class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile): ...


@jd.message(_SERVICE, 0x4612)
class ReportCommandedEndEffectorVelocityState(jd.Message):
    """ReportCommandedEndEffectorVelocityState (0x4612): Tells the commanded velocity of the tool point.

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


@jd.message(_SERVICE, 0x2612, query=True)
class QueryCommandedEndEffectorVelocityState(jd.Message):
    """QueryCommandedEndEffectorVelocityState (0x2612): Asks for the commanded velocity of the tool point."""
    REPORT = ReportCommandedEndEffectorVelocityState

@jd.derived(_SERVICE)
class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile): ...

@jd.derived(_SERVICE)
class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    REPORT = ReportMotionProfile
