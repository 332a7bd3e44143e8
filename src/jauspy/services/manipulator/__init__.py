"""Services of the manipulator set (AS6057)."""

from jauspy.services.manipulator.arm import Arm
from jauspy.services.manipulator.end_effector import (
    EndEffectorPoseDriver,
    EndEffectorPoseSensor,
    EndEffectorVelocityStateDriver,
    EndEffectorVelocityStateSensor,
    PrimitiveEndEffector,
)
from jauspy.services.manipulator.joints import (
    ActuatorForceTorqueDriver,
    JointForceTorqueSensor,
    JointPositionDriver,
    JointPositionSensor,
    JointVelocityDriver,
    JointVelocitySensor,
    PrimitiveManipulator,
)
from jauspy.services.manipulator.list_drivers import (
    EndEffectorPoseListDriver,
    JointPositionListDriver,
    ManipulatorListDriver,
)
from jauspy.services.manipulator.pan_tilt import (
    PanTilt,
    PanTiltJointPositionDriver,
    PanTiltJointPositionSensor,
    PanTiltJointVelocityDriver,
    PanTiltJointVelocitySensor,
    PanTiltMotionProfile,
    PanTiltSpecification,
    PrimitivePanTilt,
)
from jauspy.services.manipulator.specification import (
    JointDescription,
    JointMotionProfile,
    ManipulatorSpecification,
    ToolOffset,
)
from jauspy.services.manipulator.stability_guard import ArmStability

__all__ = [
    "ActuatorForceTorqueDriver",
    "Arm",
    "ArmStability",
    "EndEffectorPoseDriver",
    "EndEffectorPoseListDriver",
    "EndEffectorPoseSensor",
    "EndEffectorVelocityStateDriver",
    "EndEffectorVelocityStateSensor",
    "JointDescription",
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
