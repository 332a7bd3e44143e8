"""urn:jaus:jss:manipulator:ManipulatorJointVelocitiesDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import manipulator_actuator_force_torque_driver as manipulator_v1_0_manipulator_actuator_force_torque_driver
from jauspy.messages.manipulator.v1_0 import manipulator_end_effector_pose_driver as manipulator_v1_0_manipulator_end_effector_pose_driver
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointVelocitiesDriver", "1.0")

@jd.derived(_SERVICE)
class ReportManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.ReportManipulatorSpecifications): ...

@jd.derived(_SERVICE)
class QueryManipulatorSpecifications(manipulator_v1_0_manipulator_actuator_force_torque_driver.QueryManipulatorSpecifications):
    REPORT = ReportManipulatorSpecifications


@jd.message(_SERVICE, 0x0603, command=True)
class SetJointVelocities(jd.Message):
    """SetJointVelocities (0x0603): Sets the velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """
    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec
    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec] = jd.field("JointVelocityList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout()))

@jd.derived(_SERVICE)
class SetMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.SetMotionProfile): ...


@jd.message(_SERVICE, 0x4611)
class ReportCommandedJointVelocities(jd.Message):
    """ReportCommandedJointVelocities (0x4611): Tells the commanded velocity of each joint.

    joint_velocity_list: 0..255 items. The joints, from the base
    """
    JointVelocityRec = manipulator_v1_0_types.JointVelocityRec
    joint_velocity_list: list[manipulator_v1_0_types.JointVelocityRec] = jd.field("JointVelocityList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.JointVelocityRec.layout()))


@jd.message(_SERVICE, 0x2611, query=True)
class QueryCommandedJointVelocities(jd.Message):
    """QueryCommandedJointVelocities (0x2611): Asks for the commanded velocity of each joint."""
    REPORT = ReportCommandedJointVelocities

@jd.derived(_SERVICE)
class ReportMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.ReportMotionProfile): ...

@jd.derived(_SERVICE)
class QueryMotionProfile(manipulator_v1_0_manipulator_end_effector_pose_driver.QueryMotionProfile):
    REPORT = ReportMotionProfile
