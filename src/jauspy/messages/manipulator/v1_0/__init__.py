"""Messages of manipulator, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.manipulator.v1_0.list_manager import (
        ConfirmElementRequest as ConfirmElementRequest, DeleteElement as DeleteElement,
        QueryElement as QueryElement, QueryElementCount as QueryElementCount, QueryElementList as QueryElementList,
        RejectElementRequest as RejectElementRequest, ReportElement as ReportElement,
        ReportElementCount as ReportElementCount, ReportElementList as ReportElementList, SetElement as SetElement,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_actuator_force_torque_driver import (
        QueryCommandedActuatorForceTorques as QueryCommandedActuatorForceTorques,
        QueryManipulatorSpecifications as QueryManipulatorSpecifications,
        ReportCommandedActuatorForceTorques as ReportCommandedActuatorForceTorques,
        ReportManipulatorSpecifications as ReportManipulatorSpecifications,
        SetActuatorForceTorques as SetActuatorForceTorques,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_driver import (
        QueryCommandedEndEffectorPose as QueryCommandedEndEffectorPose, QueryMotionProfile as QueryMotionProfile,
        QueryToolOffset as QueryToolOffset, ReportCommandedEndEffectorPose as ReportCommandedEndEffectorPose,
        ReportMotionProfile as ReportMotionProfile, ReportToolOffset as ReportToolOffset,
        SetEndEffectorPose as SetEndEffectorPose, SetMotionProfile as SetMotionProfile,
        SetToolOffset as SetToolOffset,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_list_driver import (
        ExecuteList as ExecuteList, QueryActiveElement as QueryActiveElement,
        ReportActiveElement as ReportActiveElement,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_sensor import (
        QueryEndEffectorPose as QueryEndEffectorPose, ReportEndEffectorPose as ReportEndEffectorPose,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_end_effector_velocity_state_driver import (
        QueryCommandedEndEffectorVelocityState as QueryCommandedEndEffectorVelocityState,
        ReportCommandedEndEffectorVelocityState as ReportCommandedEndEffectorVelocityState,
        SetEndEffectorVelocityState as SetEndEffectorVelocityState,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_end_effector_velocity_state_sensor import (
        QueryEndEffectorVelocityState as QueryEndEffectorVelocityState,
        ReportEndEffectorVelocityState as ReportEndEffectorVelocityState,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_force_torque_sensor import (
        QueryJointForceTorques as QueryJointForceTorques, ReportJointForceTorques as ReportJointForceTorques,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_position_driver import (
        QueryCommandedJointPositions as QueryCommandedJointPositions,
        ReportCommandedJointPositions as ReportCommandedJointPositions, SetJointPositions as SetJointPositions,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_position_sensor import (
        QueryJointPositions as QueryJointPositions, ReportJointPositions as ReportJointPositions,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_velocities_driver import (
        QueryCommandedJointVelocities as QueryCommandedJointVelocities,
        ReportCommandedJointVelocities as ReportCommandedJointVelocities, SetJointVelocities as SetJointVelocities,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_velocity_sensor import (
        QueryJointVelocities as QueryJointVelocities, ReportJointVelocities as ReportJointVelocities,
    )
    from jauspy.messages.manipulator.v1_0.pan_tilt_joint_position_driver import (
        QueryCommandedPanTiltJointPositions as QueryCommandedPanTiltJointPositions,
        QueryPanTiltMotionProfile as QueryPanTiltMotionProfile,
        QueryPanTiltSpecifications as QueryPanTiltSpecifications,
        ReportCommandedPanTiltJointPositions as ReportCommandedPanTiltJointPositions,
        ReportPanTiltMotionProfile as ReportPanTiltMotionProfile,
        ReportPanTiltSpecifications as ReportPanTiltSpecifications,
        SetPanTiltJointPositions as SetPanTiltJointPositions, SetPanTiltMotionProfile as SetPanTiltMotionProfile,
    )
    from jauspy.messages.manipulator.v1_0.pan_tilt_joint_position_sensor import (
        QueryPanTiltJointPositions as QueryPanTiltJointPositions,
        ReportPanTiltJointPositions as ReportPanTiltJointPositions,
    )
    from jauspy.messages.manipulator.v1_0.pan_tilt_joint_velocities_driver import (
        QueryCommandedPanTiltJointVelocities as QueryCommandedPanTiltJointVelocities,
        ReportCommandedPanTiltJointVelocities as ReportCommandedPanTiltJointVelocities,
        SetPanTiltJointVelocities as SetPanTiltJointVelocities,
    )
    from jauspy.messages.manipulator.v1_0.pan_tilt_joint_velocity_sensor import (
        QueryPanTiltJointVelocities as QueryPanTiltJointVelocities,
        ReportPanTiltJointVelocities as ReportPanTiltJointVelocities,
    )
    from jauspy.messages.manipulator.v1_0.primitive_end_effector import (
        QueryEndEffectorEffort as QueryEndEffectorEffort,
        QueryEndEffectorSpecification as QueryEndEffectorSpecification,
        ReportEndEffectorEffort as ReportEndEffectorEffort,
        ReportEndEffectorSpecification as ReportEndEffectorSpecification,
        SetEndEffectorEffort as SetEndEffectorEffort,
    )
    from jauspy.messages.manipulator.v1_0.primitive_manipulator import (
        QueryJointEfforts as QueryJointEfforts, ReportJointEfforts as ReportJointEfforts,
        SetJointEfforts as SetJointEfforts,
    )
    from jauspy.messages.manipulator.v1_0.primitive_pan_tilt import (
        QueryPanTiltJointEfforts as QueryPanTiltJointEfforts,
        ReportPanTiltJointEfforts as ReportPanTiltJointEfforts, SetPanTiltJointEfforts as SetPanTiltJointEfforts,
    )
    from jauspy.messages.manipulator.v1_0.types import (
        ActuatorForceTorqueRec as ActuatorForceTorqueRec, EndEffectorPoseRec as EndEffectorPoseRec,
        JointEffortRec as JointEffortRec, JointPositionRec as JointPositionRec,
        JointVelocityRec as JointVelocityRec, ManipulatorCoordinateSystemRec as ManipulatorCoordinateSystemRec,
        PanTiltJointPositionRec as PanTiltJointPositionRec, PrismaticJoint1AngleRec as PrismaticJoint1AngleRec,
        PrismaticJointSpecificationRec as PrismaticJointSpecificationRec,
        PrismaticMotionProfileRec as PrismaticMotionProfileRec, RevoluteJoint1OffsetRec as RevoluteJoint1OffsetRec,
        RevoluteJointSpecificationRec as RevoluteJointSpecificationRec,
        RevoluteMotionProfileRec as RevoluteMotionProfileRec,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.manipulator.v1_0.list_manager": "ConfirmElementRequest DeleteElement QueryElement QueryElementCount QueryElementList RejectElementRequest ReportElement ReportElementCount ReportElementList SetElement",
    "jauspy.messages.manipulator.v1_0.manipulator_actuator_force_torque_driver": "QueryCommandedActuatorForceTorques QueryManipulatorSpecifications ReportCommandedActuatorForceTorques ReportManipulatorSpecifications SetActuatorForceTorques",
    "jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_driver": "QueryCommandedEndEffectorPose QueryMotionProfile QueryToolOffset ReportCommandedEndEffectorPose ReportMotionProfile ReportToolOffset SetEndEffectorPose SetMotionProfile SetToolOffset",
    "jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_list_driver": "ExecuteList QueryActiveElement ReportActiveElement",
    "jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_sensor": "QueryEndEffectorPose ReportEndEffectorPose",
    "jauspy.messages.manipulator.v1_0.manipulator_end_effector_velocity_state_driver": "QueryCommandedEndEffectorVelocityState ReportCommandedEndEffectorVelocityState SetEndEffectorVelocityState",
    "jauspy.messages.manipulator.v1_0.manipulator_end_effector_velocity_state_sensor": "QueryEndEffectorVelocityState ReportEndEffectorVelocityState",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_force_torque_sensor": "QueryJointForceTorques ReportJointForceTorques",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_position_driver": "QueryCommandedJointPositions ReportCommandedJointPositions SetJointPositions",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_position_sensor": "QueryJointPositions ReportJointPositions",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_velocities_driver": "QueryCommandedJointVelocities ReportCommandedJointVelocities SetJointVelocities",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_velocity_sensor": "QueryJointVelocities ReportJointVelocities",
    "jauspy.messages.manipulator.v1_0.pan_tilt_joint_position_driver": "QueryCommandedPanTiltJointPositions QueryPanTiltMotionProfile QueryPanTiltSpecifications ReportCommandedPanTiltJointPositions ReportPanTiltMotionProfile ReportPanTiltSpecifications SetPanTiltJointPositions SetPanTiltMotionProfile",
    "jauspy.messages.manipulator.v1_0.pan_tilt_joint_position_sensor": "QueryPanTiltJointPositions ReportPanTiltJointPositions",
    "jauspy.messages.manipulator.v1_0.pan_tilt_joint_velocities_driver": "QueryCommandedPanTiltJointVelocities ReportCommandedPanTiltJointVelocities SetPanTiltJointVelocities",
    "jauspy.messages.manipulator.v1_0.pan_tilt_joint_velocity_sensor": "QueryPanTiltJointVelocities ReportPanTiltJointVelocities",
    "jauspy.messages.manipulator.v1_0.primitive_end_effector": "QueryEndEffectorEffort QueryEndEffectorSpecification ReportEndEffectorEffort ReportEndEffectorSpecification SetEndEffectorEffort",
    "jauspy.messages.manipulator.v1_0.primitive_manipulator": "QueryJointEfforts ReportJointEfforts SetJointEfforts",
    "jauspy.messages.manipulator.v1_0.primitive_pan_tilt": "QueryPanTiltJointEfforts ReportPanTiltJointEfforts SetPanTiltJointEfforts",
    "jauspy.messages.manipulator.v1_0.types": "ActuatorForceTorqueRec EndEffectorPoseRec JointEffortRec JointPositionRec JointVelocityRec ManipulatorCoordinateSystemRec PanTiltJointPositionRec PrismaticJoint1AngleRec PrismaticJointSpecificationRec PrismaticMotionProfileRec RevoluteJoint1OffsetRec RevoluteJointSpecificationRec RevoluteMotionProfileRec",
})
