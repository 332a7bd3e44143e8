"""urn:jaus:jss:iop:CommsLostPolicyManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:CommsLostPolicyManager", "1.1")


@jd.message(_SERVICE, 0xC412)
class ReportCommsLostCapabilities(jd.Message):
    """ReportCommsLostCapabilities (0xC412): Tells which reactions to a lost link exist.

    supported_behaviors: Reactions the platform can perform
    """

    @jd.bit_field("B")
    class SupportedBehaviors(jd.Struct):
        """Reactions the platform can perform.

        stop: bit 0. Stop.
        continue_mission: bit 1. Continue mission.
        move_to_pos: bit 2. Move to pos.
        retrotraverse: bit 3. Retrotraverse.
        """
        stop: int = jd.bits(0, 0x1)
        continue_mission: int = jd.bits(1, 0x1)
        move_to_pos: int = jd.bits(2, 0x1)
        retrotraverse: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    supported_behaviors: ReportCommsLostCapabilities.SupportedBehaviors = jd.field("SupportedBehaviors", lambda: ReportCommsLostCapabilities.SupportedBehaviors.layout())


@jd.message(_SERVICE, 0xC402, query=True)
class QueryCommsLostCapabilities(jd.Message):
    """QueryCommsLostCapabilities (0xC402): Asks which reactions to a lost link exist."""
    REPORT = ReportCommsLostCapabilities


@jd.message(_SERVICE, 0xC413)
class ReportCommsLostConfiguration(jd.Message):
    """ReportCommsLostConfiguration (0xC413): Tells the reaction now set.

    comms_lost_policy_var: What to do once the link is lost
    """
    GlobalWaypointRec = mobility_v1_0_types.GlobalWaypointRec

    @jd.record()
    class CommsLostDetectionRec(jd.Struct):
        """comms_lost_timeout: in second. Silence after which the link counts as lost"""
        comms_lost_timeout: int = jd.field("CommsLostTimeout", jd.Number("H", jd.ANY, "second"))

    @jd.record()
    class StopMotionVar(jd.Struct):
        """stop_motion: Always zero"""
        stop_motion: int = jd.field("StopMotion", jd.Number("B"))

    @jd.record()
    class ContinueMissionVar(jd.Struct):
        """continue_mission: Always zero"""
        continue_mission: int = jd.field("ContinueMission", jd.Number("B"))

    @jd.record()
    class TravelSpeedRec(jd.Struct):
        """speed: 0..327.67 meter per second. Speed on the way"""
        speed: float = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"))

    @jd.record()
    class MaxDistanceRec(jd.Struct):
        """max_distance: 0..1000000 meter. Longest way to go in search of the link, then halt; 0 is unlimited"""
        max_distance: float = jd.field("MaxDistance", jd.real("I", 0.0, 1000000.0, "meter"))

    @jd.record()
    class MoveToPosSeq(jd.Struct):
        """global_waypoint_rec: A waypoint on the globe; absent fields are free"""
        global_waypoint_rec: mobility_v1_0_types.GlobalWaypointRec = jd.field("GlobalWaypointRec", lambda: mobility_v1_0_types.GlobalWaypointRec.layout())
        travel_speed_rec: ReportCommsLostConfiguration.TravelSpeedRec = jd.field("TravelSpeedRec", lambda: ReportCommsLostConfiguration.TravelSpeedRec.layout())
        max_distance_rec: ReportCommsLostConfiguration.MaxDistanceRec = jd.field("MaxDistanceRec", lambda: ReportCommsLostConfiguration.MaxDistanceRec.layout())

    @jd.bit_field("B")
    class Parameters(jd.Struct):
        """How to drive back.

        travel_method: bit 0. Travel method.
        direction: bit 1. Direction.
        """
        travel_method: int = jd.bits(0, 0x1)
        direction: int = jd.bits(1, 0x1)
        reserved_bits: int = 0

    @jd.record()
    class RetrotraverseActionRec(jd.Struct):
        """Retrotraverse action.

        distance: 0..1000000 meter. Length of the track to drive back
        max_speed: 0..327.67 meter per second. Highest speed while driving back
        parameters: How to drive back
        standoff_distance: 0..100000 meter. Distance to keep from the end point
        """
        distance: float = jd.field("Distance", jd.real("I", 0.0, 1000000.0, "meter"))
        max_speed: float = jd.field("MaxSpeed", jd.real("H", 0.0, 327.67, "meter per second"))
        parameters: ReportCommsLostConfiguration.Parameters = jd.field("Parameters", lambda: ReportCommsLostConfiguration.Parameters.layout())
        standoff_distance: float = jd.field("StandoffDistance", jd.real("I", 0.0, 100000.0, "meter"))

    @jd.record("B")
    class RetrotraverseParameterSeq(jd.Struct):
        """retrotraverse_action_rec: Retrotraverse action
        global_waypoint_rec: optional. A waypoint on the globe; absent fields are free
        """
        retrotraverse_action_rec: ReportCommsLostConfiguration.RetrotraverseActionRec = jd.field("RetrotraverseActionRec", lambda: ReportCommsLostConfiguration.RetrotraverseActionRec.layout())
        global_waypoint_rec: mobility_v1_0_types.GlobalWaypointRec | None = jd.field("GlobalWaypointRec", lambda: mobility_v1_0_types.GlobalWaypointRec.layout(), default=None)
        reserved_presence: int = 0

    comms_lost_detection_rec: ReportCommsLostConfiguration.CommsLostDetectionRec = jd.field("CommsLostDetectionRec", lambda: ReportCommsLostConfiguration.CommsLostDetectionRec.layout())
    comms_lost_policy_var: ReportCommsLostConfiguration.StopMotionVar | ReportCommsLostConfiguration.ContinueMissionVar | ReportCommsLostConfiguration.MoveToPosSeq | ReportCommsLostConfiguration.RetrotraverseParameterSeq = jd.field("CommsLostPolicyVar", lambda: jd.Union.of("B", stop_motion_var=ReportCommsLostConfiguration.StopMotionVar, continue_mission_var=ReportCommsLostConfiguration.ContinueMissionVar, move_to_pos_seq=ReportCommsLostConfiguration.MoveToPosSeq, retrotraverse_parameter_seq=ReportCommsLostConfiguration.RetrotraverseParameterSeq))


@jd.message(_SERVICE, 0xC403, query=True)
class QueryCommsLostConfiguration(jd.Message):
    """QueryCommsLostConfiguration (0xC403): Asks for the reaction now set."""
    REPORT = ReportCommsLostConfiguration


@jd.message(_SERVICE, 0xC414)
class ReportCommsLostStatus(jd.Message):
    """ReportCommsLostStatus (0xC414): Tells whether the reaction is armed or running.

    comms_lost_status: CommsLostStatus. Disabled: nothing set; Enabled: armed; Active: being carried out
    """

    class CommsLostStatus(IntEnum):
        DISABLED = 0
        ENABLED = 1
        ACTIVE = 2

    comms_lost_status: ReportCommsLostStatus.CommsLostStatus | int = jd.field("CommsLostStatus", lambda: jd.Number("B", jd.Values(ReportCommsLostStatus.CommsLostStatus)))


@jd.message(_SERVICE, 0xC404, query=True)
class QueryCommsLostStatus(jd.Message):
    """QueryCommsLostStatus (0xC404): Asks whether the reaction is armed or running."""
    REPORT = ReportCommsLostStatus


@jd.message(_SERVICE, 0xC401, command=True)
class SetCommsLostPolicy(jd.Message):
    """SetCommsLostPolicy (0xC401): Sets the reactions to the loss and to the return of the link."""
    GlobalWaypointRec = mobility_v1_0_types.GlobalWaypointRec

    @jd.record()
    class PolicyRec(jd.Struct):
        """local_id: Number chosen by the client; comes back in the response"""
        local_id: int = jd.field("Local_ID", jd.Number("B"))

    @jd.record()
    class CommsLostDetectionRec(jd.Struct):
        """comms_lost_timeout: in second. Silence after which the link counts as lost"""
        comms_lost_timeout: int = jd.field("CommsLostTimeout", jd.Number("H", jd.ANY, "second"))

    @jd.record()
    class StopMotionVar(jd.Struct):
        """stop_motion: Always zero"""
        stop_motion: int = jd.field("StopMotion", jd.Number("B"))

    @jd.record()
    class ContinueMissionVar(jd.Struct):
        """continue_mission: Always zero"""
        continue_mission: int = jd.field("ContinueMission", jd.Number("B"))

    @jd.record()
    class TravelSpeedRec(jd.Struct):
        """speed: 0..327.67 meter per second. Speed on the way"""
        speed: float = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"))

    @jd.record()
    class MaxDistanceRec(jd.Struct):
        """max_distance: 0..1000000 meter. Longest way to go in search of the link, then halt; 0 is unlimited"""
        max_distance: float = jd.field("MaxDistance", jd.real("I", 0.0, 1000000.0, "meter"))

    @jd.record()
    class MoveToPosSeq(jd.Struct):
        """global_waypoint_rec: A waypoint on the globe; absent fields are free"""
        global_waypoint_rec: mobility_v1_0_types.GlobalWaypointRec = jd.field("GlobalWaypointRec", lambda: mobility_v1_0_types.GlobalWaypointRec.layout())
        travel_speed_rec: SetCommsLostPolicy.TravelSpeedRec = jd.field("TravelSpeedRec", lambda: SetCommsLostPolicy.TravelSpeedRec.layout())
        max_distance_rec: SetCommsLostPolicy.MaxDistanceRec = jd.field("MaxDistanceRec", lambda: SetCommsLostPolicy.MaxDistanceRec.layout())

    @jd.bit_field("B")
    class Parameters(jd.Struct):
        """How to drive back.

        travel_method: bit 0. Travel method.
        direction: bit 1. Direction.
        """
        travel_method: int = jd.bits(0, 0x1)
        direction: int = jd.bits(1, 0x1)
        reserved_bits: int = 0

    @jd.record()
    class RetrotraverseActionRec(jd.Struct):
        """Retrotraverse action.

        distance: 0..1000000 meter. Length of the track to drive back
        max_speed: 0..327.67 meter per second. Highest speed while driving back
        parameters: How to drive back
        standoff_distance: 0..100000 meter. Distance to keep from the end point
        """
        distance: float = jd.field("Distance", jd.real("I", 0.0, 1000000.0, "meter"))
        max_speed: float = jd.field("MaxSpeed", jd.real("H", 0.0, 327.67, "meter per second"))
        parameters: SetCommsLostPolicy.Parameters = jd.field("Parameters", lambda: SetCommsLostPolicy.Parameters.layout())
        standoff_distance: float = jd.field("StandoffDistance", jd.real("I", 0.0, 100000.0, "meter"))

    @jd.record("B")
    class RetrotraverseParameterSeq(jd.Struct):
        """retrotraverse_action_rec: Retrotraverse action
        global_waypoint_rec: optional. A waypoint on the globe; absent fields are free
        """
        retrotraverse_action_rec: SetCommsLostPolicy.RetrotraverseActionRec = jd.field("RetrotraverseActionRec", lambda: SetCommsLostPolicy.RetrotraverseActionRec.layout())
        global_waypoint_rec: mobility_v1_0_types.GlobalWaypointRec | None = jd.field("GlobalWaypointRec", lambda: mobility_v1_0_types.GlobalWaypointRec.layout(), default=None)
        reserved_presence: int = 0

    @jd.record()
    class CommsLostSeq(jd.Struct):
        """comms_lost_policy_var: What to do once the link is lost"""
        comms_lost_detection_rec: SetCommsLostPolicy.CommsLostDetectionRec = jd.field("CommsLostDetectionRec", lambda: SetCommsLostPolicy.CommsLostDetectionRec.layout())
        comms_lost_policy_var: SetCommsLostPolicy.StopMotionVar | SetCommsLostPolicy.ContinueMissionVar | SetCommsLostPolicy.MoveToPosSeq | SetCommsLostPolicy.RetrotraverseParameterSeq = jd.field("CommsLostPolicyVar", lambda: jd.Union.of("B", stop_motion_var=SetCommsLostPolicy.StopMotionVar, continue_mission_var=SetCommsLostPolicy.ContinueMissionVar, move_to_pos_seq=SetCommsLostPolicy.MoveToPosSeq, retrotraverse_parameter_seq=SetCommsLostPolicy.RetrotraverseParameterSeq))

    class CommsRegainedBehavior(IntEnum):
        DO_NOTHING = 0
        STOP_MOTION = 1

    @jd.record()
    class CommsRegainedRec(jd.Struct):
        """comms_regained_timeout: in second. Time of working contact with the former controlling client after which the link counts as back
        comms_regained_behavior: CommsRegainedBehavior. What to do once the link is back
        """
        comms_regained_timeout: int = jd.field("CommsRegainedTimeout", jd.Number("H", jd.ANY, "second"))
        comms_regained_behavior: SetCommsLostPolicy.CommsRegainedBehavior | int = jd.field("CommsRegainedBehavior", lambda: jd.Number("B", jd.Values(SetCommsLostPolicy.CommsRegainedBehavior)))

    @jd.record()
    class CommsRegainedSeq(jd.Struct):
        """CommsRegainedSeq."""
        comms_regained_rec: SetCommsLostPolicy.CommsRegainedRec = jd.field("CommsRegainedRec", lambda: SetCommsLostPolicy.CommsRegainedRec.layout())

    policy_rec: SetCommsLostPolicy.PolicyRec = jd.field("PolicyRec", lambda: SetCommsLostPolicy.PolicyRec.layout())
    comms_lost_seq: SetCommsLostPolicy.CommsLostSeq = jd.field("CommsLostSeq", lambda: SetCommsLostPolicy.CommsLostSeq.layout())
    comms_regained_seq: SetCommsLostPolicy.CommsRegainedSeq = jd.field("CommsRegainedSeq", lambda: SetCommsLostPolicy.CommsRegainedSeq.layout())


@jd.message(_SERVICE, 0xC411)
class SetCommsLostPolicyResponse(jd.Message):
    """SetCommsLostPolicyResponse (0xC411): Answers a set command.

    local_id: Number out of the command
    comms_lost_result: CommsLostResult. Whether the reaction was taken over
    """

    class CommsLostResult(IntEnum):
        SUCCESS = 0
        NOT_SUPPORTED = 1

    local_id: int = jd.field("Local_ID", jd.Number("B"))
    comms_lost_result: SetCommsLostPolicyResponse.CommsLostResult | int = jd.field("CommsLostResult", lambda: jd.Number("B", jd.Values(SetCommsLostPolicyResponse.CommsLostResult)))
