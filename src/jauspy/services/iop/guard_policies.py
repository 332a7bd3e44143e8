"""The policies of the guards against collisions (IOP v3), and what the guards do.

SelfCollisionAvoidancePolicyManager and GuardedTeleopPolicyManager know one behaviour besides none: to stop on the path.
The robot has one state for all clients; it stays until it is set again.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final

from jauspy.messages.description import ReportMotionGuards
from jauspy.messages.iop import (
    ReportGuardedTeleopCapabilities,
    ReportGuardedTeleopConfiguration,
    ReportGuardedTeleopStatus,
    ReportSelfCollisionAvoidanceCapabilities,
    ReportSelfCollisionAvoidanceConfiguration,
    ReportSelfCollisionAvoidanceStatus,
    SetGuardedTeleopPolicy,
    SetGuardedTeleopPolicyResponse,
    SetSelfCollisionAvoidancePolicy,
    SetSelfCollisionAvoidancePolicyResponse,
)
from jauspy.platform.guards import Guard, GuardState, ObstacleGuard, SelfCollisionGuard
from jauspy.services.service import Service
from jauspy.services.units import sent_text

DO_NOTHING, STOP_ON_PATH = 0, 1
"""The behaviours that are known, of those of the profile."""
DISABLED, ENABLED, STOPS = 0, 1, 2
"""The states that are reported, of those of the profile."""
FIXED_PRIORITY: Final = 255
"""Priority of parts that do not give way to others: both stop."""
MAX_DISTANCE: Final = 1000.0
"""Metres that ReportMotionGuards can tell."""
MAX_TEXT: Final = 255
"""Characters of its sentences."""

_KINDS: Final[Mapping[str, ReportMotionGuards.Guard]] = {
    SelfCollisionGuard.label: ReportMotionGuards.Guard.SELF_COLLISION,
    ObstacleGuard.label: ReportMotionGuards.Guard.OBSTACLE,
}


def _status(state: GuardState) -> int:
    return STOPS if state.active else ENABLED if state.enabled else DISABLED


class SelfCollisionAvoidancePolicyManager(Service, urn="urn:jaus:jss:iop:SelfCollisionAvoidancePolicyManager"):
    """Switches the guard against self collision."""

    def __init__(self, guard: SelfCollisionGuard) -> None:
        self._guard = guard
        self._priority = FIXED_PRIORITY
        self._enabled: bool = guard.state().enabled

    def is_supported_command(self, msg: SetSelfCollisionAvoidancePolicy) -> bool:
        """True for the behaviours that the guard knows."""
        return int(msg.self_collision_avoidance_rec.self_collision_avoidance_state) in (DO_NOTHING, STOP_ON_PATH)

    def set_self_collision_avoidance_policy(self, msg: SetSelfCollisionAvoidancePolicy) -> None:
        """Switch the guard; the priority is kept and reported, and has no effect: all parts that would meet stop."""
        policy = msg.self_collision_avoidance_rec
        self._enabled = int(policy.self_collision_avoidance_state) == STOP_ON_PATH
        self._priority = policy.priority
        self._guard.enable(self._enabled)

    def send_set_self_collision_avoidance_policy_response_success(
        self, msg: SetSelfCollisionAvoidancePolicy
    ) -> SetSelfCollisionAvoidancePolicyResponse:
        """The policy was taken."""
        return _self_collision_response(msg, SetSelfCollisionAvoidancePolicyResponse.ResponseCode.SUCCESS)

    def send_set_self_collision_avoidance_policy_response_unsupported(
        self, msg: SetSelfCollisionAvoidancePolicy
    ) -> SetSelfCollisionAvoidancePolicyResponse:
        """The policy is unknown; nothing has changed."""
        return _self_collision_response(msg, SetSelfCollisionAvoidancePolicyResponse.ResponseCode.UNSUPPORTED_BEHAVIOR)

    def send_report_self_collision_avoidance_capabilities(self) -> ReportSelfCollisionAvoidanceCapabilities:
        """Stops."""
        bits = ReportSelfCollisionAvoidanceCapabilities.SupportedBehaviors(stop_on_obstacle=1, avoid_obstacle=0)
        return ReportSelfCollisionAvoidanceCapabilities(bits)

    def send_report_self_collision_avoidance_configuration(self) -> ReportSelfCollisionAvoidanceConfiguration:
        """The policy."""
        return ReportSelfCollisionAvoidanceConfiguration(STOP_ON_PATH if self._enabled else DO_NOTHING, self._priority)

    def send_report_self_collision_avoidance_status(self) -> ReportSelfCollisionAvoidanceStatus:
        """The state of the guard."""
        return ReportSelfCollisionAvoidanceStatus(_status(self._guard.state()))


def _self_collision_response(
    msg: SetSelfCollisionAvoidancePolicy, code: SetSelfCollisionAvoidancePolicyResponse.ResponseCode
) -> SetSelfCollisionAvoidancePolicyResponse:
    return SetSelfCollisionAvoidancePolicyResponse(msg.self_collision_avoidance_policy_rec.local_id, code)


class GuardedTeleopPolicyManager(Service, urn="urn:jaus:jss:iop:GuardedTeleopPolicyManager"):
    """Switches the guard against obstacles. Limits of tilt are those of the robot's file, and always apply."""

    def __init__(self, guard: ObstacleGuard) -> None:
        self._guard = guard
        self._tolerance: float | None = None
        self._enabled: bool = guard.state().enabled

    def is_supported_command(self, msg: SetGuardedTeleopPolicy) -> bool:
        """True for the behaviours that the guard knows."""
        state = msg.guarded_teleop_rec.state
        is_known = int(state.obstacle_avoidance_behavior) in (DO_NOTHING, STOP_ON_PATH)
        return is_known and not state.stop_on_pitchover_limit and not state.stop_on_rollover_limit

    def send_set_guarded_teleop_policy_response_success(
        self, msg: SetGuardedTeleopPolicy
    ) -> SetGuardedTeleopPolicyResponse:
        """Switch the guard, and answer; the tolerance is kept and reported, for nothing leaves its path."""
        policy = msg.guarded_teleop_rec
        self._enabled = int(policy.state.obstacle_avoidance_behavior) == STOP_ON_PATH
        self._tolerance = policy.path_tolerance
        self._guard.enable(self._enabled)
        return _teleop_response(msg, SetGuardedTeleopPolicyResponse.GuardedTeleopResult.SUCCESS)

    def send_set_guarded_teleop_policy_response_not_supported(
        self, msg: SetGuardedTeleopPolicy
    ) -> SetGuardedTeleopPolicyResponse:
        """The policy is unknown; nothing has changed."""
        return _teleop_response(msg, SetGuardedTeleopPolicyResponse.GuardedTeleopResult.NOT_SUPPORTED)

    def report_guarded_teleop_capabilities(self) -> ReportGuardedTeleopCapabilities:
        """Stops."""
        bits = ReportGuardedTeleopCapabilities.SupportedBehaviors(
            stop_on_obstacle=1, avoid_obstacle=0, pitchover_limit=0, rollover_limit=0
        )
        return ReportGuardedTeleopCapabilities(bits)

    def send_report_guarded_teleop_configuration(self) -> ReportGuardedTeleopConfiguration:
        """The policy."""
        state = ReportGuardedTeleopConfiguration.State(
            obstacle_avoidance_behavior=STOP_ON_PATH if self._enabled else DO_NOTHING,
            stop_on_pitchover_limit=0,
            stop_on_rollover_limit=0,
        )
        return ReportGuardedTeleopConfiguration(state, self._tolerance)

    def send_report_guarded_teleop_status(self) -> ReportGuardedTeleopStatus:
        """The state of the guard."""
        return ReportGuardedTeleopStatus(_status(self._guard.state()))


def _teleop_response(
    msg: SetGuardedTeleopPolicy, result: SetGuardedTeleopPolicyResponse.GuardedTeleopResult
) -> SetGuardedTeleopPolicyResponse:
    return SetGuardedTeleopPolicyResponse(msg.policy_rec.local_id, result)


class MotionGuards(Service, urn="urn:jauspy:description:MotionGuards"):
    """Reports the guards with distances and reasons, which the messages of the profile have no fields for."""

    def __init__(self, guards: Sequence[Guard]) -> None:
        self._guards = guards

    def report_motion_guards(self) -> ReportMotionGuards:
        """The present states."""
        return ReportMotionGuards([_record(guard) for guard in self._guards])


def _record(guard: Guard) -> ReportMotionGuards.MotionGuardRec:
    state = guard.state()
    distance = min(MAX_DISTANCE, max(0.0, state.distance)) if math.isfinite(state.distance) else None
    return ReportMotionGuards.MotionGuardRec(
        _KINDS[guard.label],
        ReportMotionGuards.State(_status(state)),
        distance,
        sent_text(state.problem)[:MAX_TEXT] or None,
    )
