"""urn:jaus:jss:iop:PresetPose 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:PresetPose", "1.1")


@jd.message(_SERVICE, 0xF0F2)
class ReportCurrentPose(jd.Message):
    """ReportCurrentPose (0xF0F2): Tells the pose held now, or the move under way.

    report_current_pose_var: Standing in a pose or moving between two
    """

    @jd.record()
    class CurrentPoseRec(jd.Struct):
        """current_state_id: Id of the pose held now; 255 = not known or not available"""
        current_state_id: int = jd.field("CurrentStateID", jd.Number("B"))

    @jd.record()
    class CurrentTransitionRec(jd.Struct):
        """start_state_id: Id of the pose the move began in
        end_state_id: Id of the pose the move goes to
        """
        start_state_id: int = jd.field("StartStateID", jd.Number("B"))
        end_state_id: int = jd.field("EndStateID", jd.Number("B"))

    report_current_pose_var: ReportCurrentPose.CurrentPoseRec | ReportCurrentPose.CurrentTransitionRec = jd.field("ReportCurrentPoseVar", lambda: jd.Union.of("B", current_pose_rec=ReportCurrentPose.CurrentPoseRec, current_transition_rec=ReportCurrentPose.CurrentTransitionRec))


@jd.message(_SERVICE, 0xF002, query=True)
class QueryCurrentPose(jd.Message):
    """QueryCurrentPose (0xF002): Asks which pose is held now, or which move is under way."""
    REPORT = ReportCurrentPose


@jd.message(_SERVICE, 0xF0F1)
class ReportPresetPoseCapabilities(jd.Message):
    """ReportPresetPoseCapabilities (0xF0F1): Lists the known poses and the moves allowed between them.

    pose_list: 0..255 items. Pose
    """

    @jd.record()
    class PresetPoseRec(jd.Struct):
        """Preset pose.

        pose_id: Number of the pose, used once in the list; 255 stands for an unknown pose and must not be used
        pose_name: up to 255 characters. Name of this pose
        """
        pose_id: int = jd.field("PoseID", jd.Number("B"))
        pose_name: str = jd.field("PoseName", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.bit_field("B")
    class TransitionProperties(jd.Struct):
        """Properties of the move; none is defined.

        reserved: bits 0..7. Sent as 0, ignored when received.
        """
        reserved: int = jd.bits(0, 0xFF, jd.Values(None, ((0, 255),)))

    @jd.record()
    class TransitionRec(jd.Struct):
        """start_pose_id: Id of the pose the move begins in
        end_pose_id: Id of the pose the move goes to
        transition_properties: Properties of the move; none is defined
        """
        start_pose_id: int = jd.field("StartPoseID", jd.Number("B"))
        end_pose_id: int = jd.field("EndPoseID", jd.Number("B"))
        transition_properties: ReportPresetPoseCapabilities.TransitionProperties = jd.field("TransitionProperties", lambda: ReportPresetPoseCapabilities.TransitionProperties.layout())

    @jd.record()
    class PoseSeq(jd.Struct):
        """preset_pose_rec: Preset pose
        transition_list: 0..65535 items. Transition
        """
        preset_pose_rec: ReportPresetPoseCapabilities.PresetPoseRec = jd.field("PresetPoseRec", lambda: ReportPresetPoseCapabilities.PresetPoseRec.layout())
        transition_list: list[ReportPresetPoseCapabilities.TransitionRec] = jd.field("TransitionList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportPresetPoseCapabilities.TransitionRec.layout()))

    pose_list: list[ReportPresetPoseCapabilities.PoseSeq] = jd.field("PoseList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPresetPoseCapabilities.PoseSeq.layout()))


@jd.message(_SERVICE, 0xF001, query=True)
class QueryPresetPoseCapabilities(jd.Message):
    """QueryPresetPoseCapabilities (0xF001): Asks for the known poses and the moves allowed between them."""
    REPORT = ReportPresetPoseCapabilities


@jd.message(_SERVICE, 0xF0F5)
class ReportPresetPoseSpecifications(jd.Message):
    """ReportPresetPoseSpecifications (0xF0F5): Gives the joint, tool, pan-tilt and stabilizer positions of every pose.

    preset_pose_specifications_list: 0..255 items. Preset pose specifications
    """
    JAUS_ID = environment_sensing_v1_0_types.JAUS_ID
    EndEffectorPoseRec = manipulator_v1_0_types.EndEffectorPoseRec
    PanTiltJointPositionRec = manipulator_v1_0_types.PanTiltJointPositionRec

    @jd.record()
    class PresetPoseRec(jd.Struct):
        """Preset pose.

        pose_id: Number of the pose, used once in the list; 255 stands for an unknown pose and must not be used
        pose_name: up to 255 characters. Name of this pose
        """
        pose_id: int = jd.field("PoseID", jd.Number("B"))
        pose_name: str = jd.field("PoseName", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class PresetPositionsRec(jd.Struct):
        """jaus_id: The component that the stream or file belongs to"""
        jaus_id: environment_sensing_v1_0_types.JAUS_ID = jd.field("JAUS_ID", lambda: environment_sensing_v1_0_types.JAUS_ID.layout())

    class JointPositionChoice(IntEnum):
        RADIAN = 1
        METER = 2

    @jd.variable(lambda cls: jd.Choice(cls, {1: jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), 2: jd.real("I", -10.0, 10.0, "meter")}, jd.Values(ReportPresetPoseSpecifications.JointPositionChoice)))
    class JointPosition(jd.Struct):
        """Position wanted of one joint, one entry for each joint; unit and scaling go by the kind of joint.

        1: radian, -25.1327412287..25.1327412287 radian
        2: meter, -10..10 meter
        """
        choice: ReportPresetPoseSpecifications.JointPositionChoice | int
        value: float

    @jd.record()
    class JointPositionRec(jd.Struct):
        """joint_position: Position wanted of one joint, one entry for each joint; unit and scaling go by the kind of joint"""
        joint_position: ReportPresetPoseSpecifications.JointPosition = jd.field("JointPosition", lambda: ReportPresetPoseSpecifications.JointPosition.layout())

    @jd.record()
    class JointPositionList(jd.Struct):
        """Joint position.

        joint_position_list: 0..255 items. Joint position
        """
        joint_position_list: list[ReportPresetPoseSpecifications.JointPositionRec] = jd.field("JointPositionList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPresetPoseSpecifications.JointPositionRec.layout()))

    @jd.record()
    class StabilizerPositionRec(jd.Struct):
        """stabilizer_id: Number of the stabilizer (flipper)
        position: -3.14159265359..3.14159265359 radian. Angle of that stabilizer
        """
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))
        position: float = jd.field("Position", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))

    @jd.record()
    class PresetPositionSeq(jd.Struct):
        """preset_positions_var: Position data, by kind of device"""
        preset_positions_rec: ReportPresetPoseSpecifications.PresetPositionsRec = jd.field("PresetPositionsRec", lambda: ReportPresetPoseSpecifications.PresetPositionsRec.layout())
        preset_positions_var: ReportPresetPoseSpecifications.JointPositionList | manipulator_v1_0_types.EndEffectorPoseRec | manipulator_v1_0_types.PanTiltJointPositionRec | ReportPresetPoseSpecifications.StabilizerPositionRec = jd.field("PresetPositionsVar", lambda: jd.Union.of("B", joint_position_list=ReportPresetPoseSpecifications.JointPositionList, end_effector_pose_rec=manipulator_v1_0_types.EndEffectorPoseRec, pan_tilt_joint_position_rec=manipulator_v1_0_types.PanTiltJointPositionRec, stabilizer_position_rec=ReportPresetPoseSpecifications.StabilizerPositionRec))

    @jd.record()
    class PresetPoseSpecificationSeq(jd.Struct):
        """preset_pose_rec: Preset pose
        preset_positions_list: 0..255 items. Preset positions
        """
        preset_pose_rec: ReportPresetPoseSpecifications.PresetPoseRec = jd.field("PresetPoseRec", lambda: ReportPresetPoseSpecifications.PresetPoseRec.layout())
        preset_positions_list: list[ReportPresetPoseSpecifications.PresetPositionSeq] = jd.field("PresetPositionsList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPresetPoseSpecifications.PresetPositionSeq.layout()))

    preset_pose_specifications_list: list[ReportPresetPoseSpecifications.PresetPoseSpecificationSeq] = jd.field("PresetPoseSpecificationsList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPresetPoseSpecifications.PresetPoseSpecificationSeq.layout()))


@jd.message(_SERVICE, 0xF005, query=True)
class QueryPresetPoseSpecifications(jd.Message):
    """QueryPresetPoseSpecifications (0xF005): Asks for the joint, tool, pan-tilt and stabilizer positions of every pose."""
    REPORT = ReportPresetPoseSpecifications


@jd.message(_SERVICE, 0xF003, command=True)
class SetCurrentPose(jd.Message):
    """SetCurrentPose (0xF003): Orders a move to another pose.

    request_id: Number picked by the client to match the later ReportTransitionCompleted
    pose_id: Id of the wanted pose
    """
    request_id: int = jd.field("RequestID", jd.Number("B"))
    pose_id: int = jd.field("PoseID", jd.Number("B"))


@jd.message(_SERVICE, 0xF0F4)
class ReportTransitionCompleted(jd.Message):
    """ReportTransitionCompleted (0xF0F4): Tells how a pose request ended: on arrival, or at once if it is refused.

    request_id: Number of the SetCurrentPose this answers
    transition_status: TransitionStatus. Outcome; with value 4 the device is back in the pose it started from
    """

    class TransitionStatus(IntEnum):
        TRANSITION_COMPLETED = 0
        INVALID_TRANSITION = 1
        UNRECOGNIZED_POSE = 2
        TRANSITION_FAILED = 3
        TRANSITION_FAILED_ORIGINAL_POSE_RESTORED = 4
        TRANSITION_TIMED_OUT = 5

    request_id: int = jd.field("RequestID", jd.Number("B"))
    transition_status: ReportTransitionCompleted.TransitionStatus | int = jd.field("TransitionStatus", lambda: jd.Number("B", jd.Values(ReportTransitionCompleted.TransitionStatus)))
