"""The guards of a robot against self collision and obstacles: what they do, and switching them."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Mapping
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Final

from jauspy.errors import ConfigError, RequestError
from jauspy.messages.description import QueryMotionGuards, ReportMotionGuards
from jauspy.messages.iop import (
    SetGuardedTeleopPolicy,
    SetGuardedTeleopPolicyResponse,
    SetSelfCollisionAvoidancePolicy,
    SetSelfCollisionAvoidancePolicyResponse,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.control import DEFAULT_AUTHORITY, Control
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subsystems import ComponentInfo

REPORT: Final = "description:MotionGuards"
SELF_COLLISION_POLICY: Final = "iop:SelfCollisionAvoidancePolicyManager"
TELEOP_POLICY: Final = "iop:GuardedTeleopPolicyManager"
PRIORITY: Final = 255
"""Priority of a robot that gives way to nothing."""
REPORT_PERIOD: Final = 0.05
"""Seconds between two queries whether a guard is switched."""
REPORT_QUERIES: Final = 40
"""Such queries, at most."""
_NAMES: Final[Mapping[int, str]] = {
    ReportMotionGuards.Guard.SELF_COLLISION: "self_collision",
    ReportMotionGuards.Guard.OBSTACLE: "obstacle",
}


@dataclass(frozen=True, slots=True)
class Guard:
    """One guard at one moment."""

    name: str
    """Kind of contact that it prevents: "self_collision" or "obstacle"."""
    enabled: bool
    active: bool
    """True while it slows a command down, or has stopped it."""
    distance: float
    """Metres between the nearest links, or from the chassis to the nearest obstacle; infinite while nothing is near."""
    problem: str
    """Why it stopped the robot, as a sentence; empty if it has not."""


class Guards:
    """The guards of one robot; `components` are all of its components."""

    def __init__(self, connection: Connection, components: tuple[ComponentInfo, ...]) -> None:
        self._connection = connection
        self._components = components

    def __repr__(self) -> str:
        return "<guards against self collision and obstacles>"

    async def observe(self) -> list[Guard]:
        """The present states. Raises `ConfigError` for a robot that reports none."""
        report = await self._service(REPORT).query(QueryMotionGuards(), expects=ReportMotionGuards)
        return [
            Guard(
                name=_NAMES.get(record.guard, str(int(record.guard))),
                enabled=record.state != ReportMotionGuards.State.DISABLED,
                active=record.state == ReportMotionGuards.State.ACTIVE,
                distance=math.inf if record.distance is None else record.distance,
                problem=record.problem or "",
            )
            for record in report.motion_guard_list
        ]

    async def switch(
        self,
        *,
        self_collision: bool | None = None,
        obstacle: bool | None = None,
        authority: int = DEFAULT_AUTHORITY,
    ) -> None:
        """Switch guards on or off, and wait until they are; None leaves one as it is.

        A policy stays until it is set again. Takes control of the component with the policies for this call, unless
        this OCU controls it. Raises `ControlRejected` when another client does, and `RequestError` when the robot
        refuses, or reports the former state for 2 s.
        """
        if self_collision is not None:
            await self._set(SELF_COLLISION_POLICY, _self_collision_policy(enabled=self_collision), authority)
        if obstacle is not None:
            await self._set(TELEOP_POLICY, _teleop_policy(enabled=obstacle), authority)
        given = {"self_collision": self_collision, "obstacle": obstacle}
        await self._until({name: enabled for name, enabled in given.items() if enabled is not None})

    async def _until(self, wanted: Mapping[str, bool]) -> None:
        """Wait until guards are on or off as wanted: a robot switches them with its next step, after its answer."""
        if not wanted or not any(component.find(REPORT) for component in self._components):
            return
        for _ in range(REPORT_QUERIES):
            found = {guard.name: guard.enabled for guard in await self.observe()}
            late = [name for name, enabled in wanted.items() if found.get(name, enabled) != enabled]
            if not late:
                return
            await asyncio.sleep(REPORT_PERIOD)
        raise RequestError(f"the robot took the policy, and has not switched the guard {', '.join(late)}")

    async def _set(
        self, name: str, message: SetSelfCollisionAvoidancePolicy | SetGuardedTeleopPolicy, authority: int
    ) -> None:
        service = self._service(name)
        controls = self._connection.controls
        control = Control(self._connection, service.id, authority, self._connection.retry)
        async with nullcontext() if service.id in controls else control:
            if isinstance(message, SetGuardedTeleopPolicy):
                teleop = await service.query(message, expects=SetGuardedTeleopPolicyResponse)
                is_taken = teleop.guarded_teleop_result == teleop.GuardedTeleopResult.SUCCESS
            else:
                answer = await service.query(message, expects=SetSelfCollisionAvoidancePolicyResponse)
                is_taken = answer.response_code == answer.ResponseCode.SUCCESS
        if not is_taken:
            raise RequestError(f"{service.id} does not support this policy of {name}")

    def _service(self, name: str) -> ServiceClient:
        for component in self._components:
            if (found := component.find(name)) is not None:
                return ServiceClient(self._connection, component.id, found)
        raise ConfigError(f"no component of the robot offers {name}: it has no such guard")


def _self_collision_policy(*, enabled: bool) -> SetSelfCollisionAvoidancePolicy:
    kind = SetSelfCollisionAvoidancePolicy
    state = kind.SelfCollisionAvoidanceState
    policy = kind.SelfCollisionAvoidanceRec(state.STOP_ON_PATH if enabled else state.DO_NOTHING, PRIORITY)
    return kind(kind.SelfCollisionAvoidancePolicyRec(1), policy)


def _teleop_policy(*, enabled: bool) -> SetGuardedTeleopPolicy:
    kind = SetGuardedTeleopPolicy
    behavior = kind.ObstacleAvoidanceBehavior
    state = kind.State(
        obstacle_avoidance_behavior=behavior.STOP_ON_PATH if enabled else behavior.DO_NOTHING,
        stop_on_pitchover_limit=0,
        stop_on_rollover_limit=0,
    )
    return kind(kind.PolicyRec(1), kind.GuardedTeleopRec(state))
