"""urn:jaus:jss:iop:SelfCollisionAvoidancePolicyManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:SelfCollisionAvoidancePolicyManager", "1.1")


@jd.message(_SERVICE, 0xC526)
class ReportSelfCollisionAvoidanceCapabilities(jd.Message):
    """ReportSelfCollisionAvoidanceCapabilities (0xC526): Tells which ways of avoidance the platform knows.

    supported_behaviors: Bit set = this way is supported
    """

    @jd.bit_field("B")
    class SupportedBehaviors(jd.Struct):
        """Bit set = this way is supported.

        stop_on_obstacle: bit 0. Stop on obstacle.
        avoid_obstacle: bit 1. Avoid obstacle.
        """
        stop_on_obstacle: int = jd.bits(0, 0x1)
        avoid_obstacle: int = jd.bits(1, 0x1)
        reserved_bits: int = 0

    supported_behaviors: ReportSelfCollisionAvoidanceCapabilities.SupportedBehaviors = jd.field("SupportedBehaviors", lambda: ReportSelfCollisionAvoidanceCapabilities.SupportedBehaviors.layout())


@jd.message(_SERVICE, 0xC522, query=True)
class QuerySelfCollisionAvoidanceCapabilities(jd.Message):
    """QuerySelfCollisionAvoidanceCapabilities (0xC522): Asks which ways of avoidance the platform knows."""
    REPORT = ReportSelfCollisionAvoidanceCapabilities


@jd.message(_SERVICE, 0xC527)
class ReportSelfCollisionAvoidanceConfiguration(jd.Message):
    """ReportSelfCollisionAvoidanceConfiguration (0xC527): Tells the way of avoidance chosen now.

    self_collision_avoidance_state: SelfCollisionAvoidanceState. What is done when a hit is ahead
    priority: Right of way among moving parts: the lower number gives way; 255 is taken for fixed parts and parts without avoidance; a tie has no defined result
    """

    class SelfCollisionAvoidanceState(IntEnum):
        DO_NOTHING = 0
        STOP_ON_PATH = 1
        DEVIATE_FROM_PATH_TO_AVOID_COLLISIONS = 2

    self_collision_avoidance_state: ReportSelfCollisionAvoidanceConfiguration.SelfCollisionAvoidanceState | int = jd.field("SelfCollisionAvoidanceState", lambda: jd.Number("B", jd.Values(ReportSelfCollisionAvoidanceConfiguration.SelfCollisionAvoidanceState)))
    priority: int = jd.field("Priority", jd.Number("B"))


@jd.message(_SERVICE, 0xC523, query=True)
class QuerySelfCollisionAvoidanceConfiguration(jd.Message):
    """QuerySelfCollisionAvoidanceConfiguration (0xC523): Asks for the way of avoidance chosen now."""
    REPORT = ReportSelfCollisionAvoidanceConfiguration


@jd.message(_SERVICE, 0xC528)
class ReportSelfCollisionAvoidanceStatus(jd.Message):
    """ReportSelfCollisionAvoidanceStatus (0xC528): Tells whether avoidance is on and acting.

    self_collision_avoidance_status: SelfCollisionAvoidanceStatus. Off, on, or acting now and how
    """

    class SelfCollisionAvoidanceStatus(IntEnum):
        DISABLED = 0
        ENABLED = 1
        ACTIVE_STOP_ON_OBSTACLE = 2
        ACTIVE_AVOID_OBSTACLE = 3

    self_collision_avoidance_status: ReportSelfCollisionAvoidanceStatus.SelfCollisionAvoidanceStatus | int = jd.field("SelfCollisionAvoidanceStatus", lambda: jd.Number("B", jd.Values(ReportSelfCollisionAvoidanceStatus.SelfCollisionAvoidanceStatus)))


@jd.message(_SERVICE, 0xC524, query=True)
class QuerySelfCollisionAvoidanceStatus(jd.Message):
    """QuerySelfCollisionAvoidanceStatus (0xC524): Asks whether avoidance is on and acting."""
    REPORT = ReportSelfCollisionAvoidanceStatus


@jd.message(_SERVICE, 0xC521, command=True)
class SetSelfCollisionAvoidancePolicy(jd.Message):
    """SetSelfCollisionAvoidancePolicy (0xC521): Chooses how an operator's moves that would damage the platform are held off."""

    @jd.record()
    class SelfCollisionAvoidancePolicyRec(jd.Struct):
        """local_id: Number picked by the client, handed back in the response"""
        local_id: int = jd.field("Local_ID", jd.Number("B"))

    class SelfCollisionAvoidanceState(IntEnum):
        DO_NOTHING = 0
        STOP_ON_PATH = 1
        DEVIATE_FROM_PATH_TO_AVOID_COLLISIONS = 2

    @jd.record()
    class SelfCollisionAvoidanceRec(jd.Struct):
        """self_collision_avoidance_state: SelfCollisionAvoidanceState. What is to be done when a hit is ahead
        priority: Right of way among moving parts: the lower number gives way; 255 is taken for fixed parts and parts without avoidance; a tie has no defined result
        """
        self_collision_avoidance_state: SetSelfCollisionAvoidancePolicy.SelfCollisionAvoidanceState | int = jd.field("SelfCollisionAvoidanceState", lambda: jd.Number("B", jd.Values(SetSelfCollisionAvoidancePolicy.SelfCollisionAvoidanceState)))
        priority: int = jd.field("Priority", jd.Number("B"))

    self_collision_avoidance_policy_rec: SetSelfCollisionAvoidancePolicy.SelfCollisionAvoidancePolicyRec = jd.field("SelfCollisionAvoidancePolicyRec", lambda: SetSelfCollisionAvoidancePolicy.SelfCollisionAvoidancePolicyRec.layout())
    self_collision_avoidance_rec: SetSelfCollisionAvoidancePolicy.SelfCollisionAvoidanceRec = jd.field("SelfCollisionAvoidanceRec", lambda: SetSelfCollisionAvoidancePolicy.SelfCollisionAvoidanceRec.layout())


@jd.message(_SERVICE, 0xC525)
class SetSelfCollisionAvoidancePolicyResponse(jd.Message):
    """SetSelfCollisionAvoidancePolicyResponse (0xC525): Answers a SetSelfCollisionAvoidancePolicy.

    local_id: Number of the request this answers
    response_code: ResponseCode. Whether the policy was taken over
    """

    class ResponseCode(IntEnum):
        SUCCESS = 0
        UNSUPPORTED_BEHAVIOR = 1

    local_id: int = jd.field("Local_ID", jd.Number("B"))
    response_code: SetSelfCollisionAvoidancePolicyResponse.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(SetSelfCollisionAvoidancePolicyResponse.ResponseCode)))
