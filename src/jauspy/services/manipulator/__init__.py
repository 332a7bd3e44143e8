"""Services of the manipulator set (AS6057)."""

from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.end_effector import (
    EndEffectorPoseDriver,
    EndEffectorPoseSensor,
    EndEffectorVelocityStateDriver,
    EndEffectorVelocityStateSensor,
    PrimitiveEndEffector,
)
from jauspy.services.manipulator.end_effector_pose_list_driver import EndEffectorPoseListDriver
from jauspy.services.manipulator.joint_position_list_driver import JointPositionListDriver
from jauspy.services.manipulator.joints import (
    ActuatorForceTorqueDriver,
    JointForceTorqueSensor,
    JointPositionDriver,
    JointPositionSensor,
    JointVelocityDriver,
    JointVelocitySensor,
    PrimitiveManipulator,
)
from jauspy.services.manipulator.list_driver import ManipulatorListDriver
from jauspy.services.manipulator.pan_tilt import PanTilt
from jauspy.services.manipulator.pan_tilt_drivers import PanTiltJointPositionDriver, PanTiltJointVelocityDriver
from jauspy.services.manipulator.pan_tilt_limits import PanTiltMotionProfile, PanTiltSpecification
from jauspy.services.manipulator.pan_tilt_sensors import PanTiltJointPositionSensor, PanTiltJointVelocitySensor
from jauspy.services.manipulator.primitive_pan_tilt import PrimitivePanTilt
from jauspy.services.manipulator.specification import JointMotionProfile, ManipulatorSpecification, ToolOffset

__all__ = [
    "ActuatorForceTorqueDriver",
    "Arm",
    "EndEffectorPoseDriver",
    "EndEffectorPoseListDriver",
    "EndEffectorPoseSensor",
    "EndEffectorVelocityStateDriver",
    "EndEffectorVelocityStateSensor",
    "JointForceTorqueSensor",
    "JointMotionProfile",
    "JointPositionDriver",
    "JointPositionListDriver",
    "JointPositionSensor",
    "JointVelocityDriver",
    "JointVelocitySensor",
    "ManipulatorListDriver",
    "ManipulatorSpecification",
    "PanTilt",
    "PanTiltJointPositionDriver",
    "PanTiltJointPositionSensor",
    "PanTiltJointVelocityDriver",
    "PanTiltJointVelocitySensor",
    "PanTiltMotionProfile",
    "PanTiltSpecification",
    "PrimitiveEndEffector",
    "PrimitiveManipulator",
    "PrimitivePanTilt",
    "ToolOffset",
]
