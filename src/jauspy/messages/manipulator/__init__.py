"""Messages of manipulator, newest versions; loaded on use. Generated from schemas/; do not edit."""

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
    from jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_driver import (
        QueryMotionProfile as QueryMotionProfile, ReportMotionProfile as ReportMotionProfile,
        SetMotionProfile as SetMotionProfile,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_velocities_driver import (
        QueryCommandedJointVelocities as QueryCommandedJointVelocities,
        ReportCommandedJointVelocities as ReportCommandedJointVelocities, SetJointVelocities as SetJointVelocities,
    )
    from jauspy.messages.manipulator.v1_0.manipulator_joint_velocity_sensor import (
        QueryJointVelocities as QueryJointVelocities, ReportJointVelocities as ReportJointVelocities,
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
    from jauspy.messages.manipulator.v2_0.manipulator_actuator_force_torque_driver import (
        QueryCommandedActuatorForceTorques as QueryCommandedActuatorForceTorques,
        ReportCommandedActuatorForceTorques as ReportCommandedActuatorForceTorques,
        SetActuatorForceTorques as SetActuatorForceTorques,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_end_effector_pose_driver import (
        QueryCommandedEndEffectorPose as QueryCommandedEndEffectorPose,
        ReportCommandedEndEffectorPose as ReportCommandedEndEffectorPose, SetEndEffectorPose as SetEndEffectorPose,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_end_effector_pose_sensor import (
        QueryEndEffectorPose as QueryEndEffectorPose, ReportEndEffectorPose as ReportEndEffectorPose,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_end_effector_velocity_state_driver import (
        QueryCommandedEndEffectorVelocityState as QueryCommandedEndEffectorVelocityState,
        ReportCommandedEndEffectorVelocityState as ReportCommandedEndEffectorVelocityState,
        SetEndEffectorVelocityState as SetEndEffectorVelocityState,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_end_effector_velocity_state_sensor import (
        QueryEndEffectorVelocityState as QueryEndEffectorVelocityState,
        ReportEndEffectorVelocityState as ReportEndEffectorVelocityState,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_joint_force_torque_sensor import (
        QueryJointForceTorques as QueryJointForceTorques, ReportJointForceTorques as ReportJointForceTorques,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_joint_motion_profile import (
        QueryJointMotionProfile as QueryJointMotionProfile, ReportJointMotionProfile as ReportJointMotionProfile,
        SetJointMotionProfile as SetJointMotionProfile,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_joint_position_driver import (
        QueryCommandedJointPositions as QueryCommandedJointPositions,
        ReportCommandedJointPositions as ReportCommandedJointPositions, SetJointPositions as SetJointPositions,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_joint_position_sensor import (
        QueryJointPositions as QueryJointPositions, ReportJointPositions as ReportJointPositions,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_joint_velocity_driver import (
        QueryCommandedJointVelocity as QueryCommandedJointVelocity,
        ReportCommandedJointVelocity as ReportCommandedJointVelocity, SetJointVelocity as SetJointVelocity,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_joint_velocity_sensor import (
        QueryJointVelocity as QueryJointVelocity, ReportJointVelocity as ReportJointVelocity,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_list_driver import (
        ExecuteList as ExecuteList, QueryActiveElement as QueryActiveElement,
        ReportActiveElement as ReportActiveElement,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_specification_service import (
        QueryManipulatorSpecifications as QueryManipulatorSpecifications,
        ReportManipulatorSpecifications as ReportManipulatorSpecifications,
    )
    from jauspy.messages.manipulator.v2_0.manipulator_tool_offset_service import (
        QueryToolOffset as QueryToolOffset, ReportToolOffset as ReportToolOffset, SetToolOffset as SetToolOffset,
    )
    from jauspy.messages.manipulator.v2_0.pan_tilt_joint_position_driver import (
        QueryCommandedPanTiltJointPositions as QueryCommandedPanTiltJointPositions,
        ReportCommandedPanTiltJointPositions as ReportCommandedPanTiltJointPositions,
        SetPanTiltJointPositions as SetPanTiltJointPositions,
    )
    from jauspy.messages.manipulator.v2_0.pan_tilt_joint_position_sensor import (
        QueryPanTiltJointPositions as QueryPanTiltJointPositions,
        ReportPanTiltJointPositions as ReportPanTiltJointPositions,
    )
    from jauspy.messages.manipulator.v2_0.pan_tilt_joint_velocity_driver import (
        QueryCommandedPanTiltJointVelocity as QueryCommandedPanTiltJointVelocity,
        ReportCommandedPanTiltJointVelocity as ReportCommandedPanTiltJointVelocity,
        SetPanTiltJointVelocity as SetPanTiltJointVelocity,
    )
    from jauspy.messages.manipulator.v2_0.pan_tilt_joint_velocity_sensor import (
        QueryPanTiltJointVelocity as QueryPanTiltJointVelocity,
        ReportPanTiltJointVelocity as ReportPanTiltJointVelocity,
    )
    from jauspy.messages.manipulator.v2_0.pan_tilt_motion_profile_service import (
        QueryPanTiltMotionProfile as QueryPanTiltMotionProfile,
        ReportPanTiltMotionProfile as ReportPanTiltMotionProfile,
        SetPanTiltMotionProfile as SetPanTiltMotionProfile,
    )
    from jauspy.messages.manipulator.v2_0.pan_tilt_specification_service import (
        QueryPanTiltSpecifications as QueryPanTiltSpecifications,
        ReportPanTiltSpecifications as ReportPanTiltSpecifications,
    )
    from jauspy.messages.manipulator.v2_0.primitive_end_effector import (
        QueryEndEffectorEffort as QueryEndEffectorEffort,
        QueryEndEffectorSpecification as QueryEndEffectorSpecification,
        ReportEndEffectorEffort as ReportEndEffectorEffort,
        ReportEndEffectorSpecification as ReportEndEffectorSpecification,
        SetEndEffectorEffort as SetEndEffectorEffort,
    )
    from jauspy.messages.manipulator.v2_0.primitive_manipulator import (
        QueryJointEffort as QueryJointEffort, ReportJointEffort as ReportJointEffort,
        SetJointEffort as SetJointEffort,
    )
    from jauspy.messages.manipulator.v2_0.primitive_pan_tilt import (
        QueryPanTiltJointEffort as QueryPanTiltJointEffort, ReportPanTiltJointEffort as ReportPanTiltJointEffort,
        SetPanTiltJointEffort as SetPanTiltJointEffort,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.manipulator.v1_0.list_manager": "ConfirmElementRequest DeleteElement QueryElement QueryElementCount QueryElementList RejectElementRequest ReportElement ReportElementCount ReportElementList SetElement",
    "jauspy.messages.manipulator.v1_0.manipulator_end_effector_pose_driver": "QueryMotionProfile ReportMotionProfile SetMotionProfile",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_velocities_driver": "QueryCommandedJointVelocities ReportCommandedJointVelocities SetJointVelocities",
    "jauspy.messages.manipulator.v1_0.manipulator_joint_velocity_sensor": "QueryJointVelocities ReportJointVelocities",
    "jauspy.messages.manipulator.v1_0.pan_tilt_joint_velocities_driver": "QueryCommandedPanTiltJointVelocities ReportCommandedPanTiltJointVelocities SetPanTiltJointVelocities",
    "jauspy.messages.manipulator.v1_0.pan_tilt_joint_velocity_sensor": "QueryPanTiltJointVelocities ReportPanTiltJointVelocities",
    "jauspy.messages.manipulator.v1_0.primitive_manipulator": "QueryJointEfforts ReportJointEfforts SetJointEfforts",
    "jauspy.messages.manipulator.v1_0.primitive_pan_tilt": "QueryPanTiltJointEfforts ReportPanTiltJointEfforts SetPanTiltJointEfforts",
    "jauspy.messages.manipulator.v1_0.types": "ActuatorForceTorqueRec EndEffectorPoseRec JointEffortRec JointPositionRec JointVelocityRec ManipulatorCoordinateSystemRec PanTiltJointPositionRec PrismaticJoint1AngleRec PrismaticJointSpecificationRec PrismaticMotionProfileRec RevoluteJoint1OffsetRec RevoluteJointSpecificationRec RevoluteMotionProfileRec",
    "jauspy.messages.manipulator.v2_0.manipulator_actuator_force_torque_driver": "QueryCommandedActuatorForceTorques ReportCommandedActuatorForceTorques SetActuatorForceTorques",
    "jauspy.messages.manipulator.v2_0.manipulator_end_effector_pose_driver": "QueryCommandedEndEffectorPose ReportCommandedEndEffectorPose SetEndEffectorPose",
    "jauspy.messages.manipulator.v2_0.manipulator_end_effector_pose_sensor": "QueryEndEffectorPose ReportEndEffectorPose",
    "jauspy.messages.manipulator.v2_0.manipulator_end_effector_velocity_state_driver": "QueryCommandedEndEffectorVelocityState ReportCommandedEndEffectorVelocityState SetEndEffectorVelocityState",
    "jauspy.messages.manipulator.v2_0.manipulator_end_effector_velocity_state_sensor": "QueryEndEffectorVelocityState ReportEndEffectorVelocityState",
    "jauspy.messages.manipulator.v2_0.manipulator_joint_force_torque_sensor": "QueryJointForceTorques ReportJointForceTorques",
    "jauspy.messages.manipulator.v2_0.manipulator_joint_motion_profile": "QueryJointMotionProfile ReportJointMotionProfile SetJointMotionProfile",
    "jauspy.messages.manipulator.v2_0.manipulator_joint_position_driver": "QueryCommandedJointPositions ReportCommandedJointPositions SetJointPositions",
    "jauspy.messages.manipulator.v2_0.manipulator_joint_position_sensor": "QueryJointPositions ReportJointPositions",
    "jauspy.messages.manipulator.v2_0.manipulator_joint_velocity_driver": "QueryCommandedJointVelocity ReportCommandedJointVelocity SetJointVelocity",
    "jauspy.messages.manipulator.v2_0.manipulator_joint_velocity_sensor": "QueryJointVelocity ReportJointVelocity",
    "jauspy.messages.manipulator.v2_0.manipulator_list_driver": "ExecuteList QueryActiveElement ReportActiveElement",
    "jauspy.messages.manipulator.v2_0.manipulator_specification_service": "QueryManipulatorSpecifications ReportManipulatorSpecifications",
    "jauspy.messages.manipulator.v2_0.manipulator_tool_offset_service": "QueryToolOffset ReportToolOffset SetToolOffset",
    "jauspy.messages.manipulator.v2_0.pan_tilt_joint_position_driver": "QueryCommandedPanTiltJointPositions ReportCommandedPanTiltJointPositions SetPanTiltJointPositions",
    "jauspy.messages.manipulator.v2_0.pan_tilt_joint_position_sensor": "QueryPanTiltJointPositions ReportPanTiltJointPositions",
    "jauspy.messages.manipulator.v2_0.pan_tilt_joint_velocity_driver": "QueryCommandedPanTiltJointVelocity ReportCommandedPanTiltJointVelocity SetPanTiltJointVelocity",
    "jauspy.messages.manipulator.v2_0.pan_tilt_joint_velocity_sensor": "QueryPanTiltJointVelocity ReportPanTiltJointVelocity",
    "jauspy.messages.manipulator.v2_0.pan_tilt_motion_profile_service": "QueryPanTiltMotionProfile ReportPanTiltMotionProfile SetPanTiltMotionProfile",
    "jauspy.messages.manipulator.v2_0.pan_tilt_specification_service": "QueryPanTiltSpecifications ReportPanTiltSpecifications",
    "jauspy.messages.manipulator.v2_0.primitive_end_effector": "QueryEndEffectorEffort QueryEndEffectorSpecification ReportEndEffectorEffort ReportEndEffectorSpecification SetEndEffectorEffort",
    "jauspy.messages.manipulator.v2_0.primitive_manipulator": "QueryJointEffort ReportJointEffort SetJointEffort",
    "jauspy.messages.manipulator.v2_0.primitive_pan_tilt": "QueryPanTiltJointEffort ReportPanTiltJointEffort SetPanTiltJointEffort",
})
