"""urn:jaus:jss:iop:GuardedTeleopPolicyManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:GuardedTeleopPolicyManager", "1.1")


@jd.message(_SERVICE, 0xC512)
class ReportGuardedTeleopCapabilities(jd.Message):
    """ReportGuardedTeleopCapabilities (0xC512): Protections the platform has.

    supported_behaviors: Bit set: the protection is available
    """

    @jd.bit_field("B")
    class SupportedBehaviors(jd.Struct):
        """Bit set: the protection is available.

        stop_on_obstacle: bit 0. Stop on obstacle.
        avoid_obstacle: bit 1. Avoid obstacle.
        pitchover_limit: bit 2. Pitchover limit.
        rollover_limit: bit 3. Rollover limit.
        """
        stop_on_obstacle: int = jd.bits(0, 0x1)
        avoid_obstacle: int = jd.bits(1, 0x1)
        pitchover_limit: int = jd.bits(2, 0x1)
        rollover_limit: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    supported_behaviors: ReportGuardedTeleopCapabilities.SupportedBehaviors = jd.field("SupportedBehaviors", lambda: ReportGuardedTeleopCapabilities.SupportedBehaviors.layout())


@jd.message(_SERVICE, 0xC502, query=True)
class QueryGuardedTeleopCapabilities(jd.Message):
    """QueryGuardedTeleopCapabilities (0xC502): Asks which protections exist."""
    REPORT = ReportGuardedTeleopCapabilities


@jd.message(_SERVICE, 0xC513, presence="B")
class ReportGuardedTeleopConfiguration(jd.Message):
    """ReportGuardedTeleopConfiguration (0xC513): Protections set now.

    state: Chosen reactions
    path_tolerance: 0..100000 meter, optional. How far the vehicle may leave its path to go round an obstacle; 0 means without limit
    """

    class ObstacleAvoidanceBehavior(IntEnum):
        DO_NOTHING = 0
        STOP_ON_PATH = 1
        DEVIATE_FROM_PATH_TO_AVOID_OBSTACLE = 2

    @jd.bit_field("B")
    class State(jd.Struct):
        """Chosen reactions.

        obstacle_avoidance_behavior: bits 0..1. Obstacle avoidance behavior.
        stop_on_pitchover_limit: bit 2. Stop on pitchover limit.
        stop_on_rollover_limit: bit 3. Stop on rollover limit.
        """
        obstacle_avoidance_behavior: ReportGuardedTeleopConfiguration.ObstacleAvoidanceBehavior | int = jd.bits(0, 0x3, lambda: jd.Values(ReportGuardedTeleopConfiguration.ObstacleAvoidanceBehavior))
        stop_on_pitchover_limit: int = jd.bits(2, 0x1)
        stop_on_rollover_limit: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    state: ReportGuardedTeleopConfiguration.State = jd.field("State", lambda: ReportGuardedTeleopConfiguration.State.layout())
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xC503, query=True)
class QueryGuardedTeleopConfiguration(jd.Message):
    """QueryGuardedTeleopConfiguration (0xC503): Asks which protections are set."""
    REPORT = ReportGuardedTeleopConfiguration


@jd.message(_SERVICE, 0xC514)
class ReportGuardedTeleopStatus(jd.Message):
    """ReportGuardedTeleopStatus (0xC514): What the protection is doing now.

    guarded_teleop_status: GuardedTeleopStatus. Present state of the protection
    """

    class GuardedTeleopStatus(IntEnum):
        DISABLED = 0
        ENABLED = 1
        ACTIVE_STOP_ON_OBSTACLE = 2
        ACTIVE_AVOID_OBSTACLE = 3
        PITCHOVER_LIMIT = 4
        ROLLOVER_LIMIT = 5

    guarded_teleop_status: ReportGuardedTeleopStatus.GuardedTeleopStatus | int = jd.field("GuardedTeleopStatus", lambda: jd.Number("B", jd.Values(ReportGuardedTeleopStatus.GuardedTeleopStatus)))


@jd.message(_SERVICE, 0xC504, query=True)
class QueryGuardedTeleopStatus(jd.Message):
    """QueryGuardedTeleopStatus (0xC504): Asks whether a protection is acting now."""
    REPORT = ReportGuardedTeleopStatus


@jd.message(_SERVICE, 0xC501, command=True)
class SetGuardedTeleopPolicy(jd.Message):
    """SetGuardedTeleopPolicy (0xC501): Chooses the protections that restrain harmful operator commands."""

    @jd.record()
    class PolicyRec(jd.Struct):
        """local_id: Number chosen by the client; comes back in the response"""
        local_id: int = jd.field("Local_ID", jd.Number("B"))

    class ObstacleAvoidanceBehavior(IntEnum):
        DO_NOTHING = 0
        STOP_ON_PATH = 1
        DEVIATE_FROM_PATH_TO_AVOID_OBSTACLE = 2

    @jd.bit_field("B")
    class State(jd.Struct):
        """Chosen reactions.

        obstacle_avoidance_behavior: bits 0..1. Obstacle avoidance behavior.
        stop_on_pitchover_limit: bit 2. Stop on pitchover limit.
        stop_on_rollover_limit: bit 3. Stop on rollover limit.
        """
        obstacle_avoidance_behavior: SetGuardedTeleopPolicy.ObstacleAvoidanceBehavior | int = jd.bits(0, 0x3, lambda: jd.Values(SetGuardedTeleopPolicy.ObstacleAvoidanceBehavior))
        stop_on_pitchover_limit: int = jd.bits(2, 0x1)
        stop_on_rollover_limit: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    @jd.record("B")
    class GuardedTeleopRec(jd.Struct):
        """state: Chosen reactions
        path_tolerance: 0..100000 meter, optional. How far the vehicle may leave its path to go round an obstacle; 0 means without limit
        """
        state: SetGuardedTeleopPolicy.State = jd.field("State", lambda: SetGuardedTeleopPolicy.State.layout())
        path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
        reserved_presence: int = 0

    policy_rec: SetGuardedTeleopPolicy.PolicyRec = jd.field("PolicyRec", lambda: SetGuardedTeleopPolicy.PolicyRec.layout())
    guarded_teleop_rec: SetGuardedTeleopPolicy.GuardedTeleopRec = jd.field("GuardedTeleopRec", lambda: SetGuardedTeleopPolicy.GuardedTeleopRec.layout())


@jd.message(_SERVICE, 0xC511)
class SetGuardedTeleopPolicyResponse(jd.Message):
    """SetGuardedTeleopPolicyResponse (0xC511): Result of SetGuardedTeleopPolicy.

    local_id: Number from the set message
    guarded_teleop_result: GuardedTeleopResult. Whether the policy was taken
    """

    class GuardedTeleopResult(IntEnum):
        SUCCESS = 0
        NOT_SUPPORTED = 1

    local_id: int = jd.field("Local_ID", jd.Number("B"))
    guarded_teleop_result: SetGuardedTeleopPolicyResponse.GuardedTeleopResult | int = jd.field("GuardedTeleopResult", lambda: jd.Number("B", jd.Values(SetGuardedTeleopPolicyResponse.GuardedTeleopResult)))
