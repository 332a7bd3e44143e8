"""The reaction of a robot to a lost link to its OCU, and driving back along its path (IOP v3)."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the robot is

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any, Final

from jauspy.arguments import check_number, described
from jauspy.errors import ConfigError, ControlRejected, RequestError
from jauspy.messages.iop import (
    CancelRetrotraverse,
    QueryCommsLostCapabilities,
    QueryCommsLostConfiguration,
    QueryCommsLostStatus,
    QueryRetrotraverseStatus,
    ReportCommsLostCapabilities,
    ReportCommsLostConfiguration,
    ReportCommsLostStatus,
    ReportRetrotraverseStatus,
    SetCommsLostPolicy,
    SetCommsLostPolicyResponse,
    StartRetrotraverse,
)
from jauspy.messages.mobility.v1_0.types import GlobalWaypointRec
from jauspy.ocu.commands import perform
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import NOT_CONTROLLED, check_ready
from jauspy.ocu.service import ServiceClient
from jauspy.services.iop.comms_lost import SHORTEST_TIMEOUT, TOO_SHORT

RETROTRAVERSE: Final = "iop:Retrotraverse"
POLICY_MANAGER: Final = "iop:CommsLostPolicyManager"
REACTIONS: Final = ("stop", "continue", "move_to", "retrotraverse")
"""Reactions to a lost link, in the order of the fields that name them."""
DISTANCE_TOLERANCE: Final = 0.01
"""Metres by which a way may be shorter than it was asked to be."""
PROGRESS_INTERVAL: Final = 0.5
"""Seconds between two queries for the status on the way back."""


@dataclass(frozen=True, slots=True)
class CommsLostSettings:
    """The reaction of a robot to a lost link."""

    reaction: str
    """"stop", "continue", "move_to" or "retrotraverse"."""
    timeout: int
    """Seconds of silence before it; 0: when control has ended."""
    distance: float | None = None
    """Metres that it drives at most, of "move_to" and "retrotraverse"; 0 is unlimited for a point."""
    speed: float | None = None
    """m/s; 0: as on the way out."""
    point: tuple[float, float] | None = None
    """Latitude and longitude in degrees, of "move_to", and of "retrotraverse" if it ends abeam of a point."""


class CommsLost:
    """The reaction of one robot to a lost link to its client in control.

    The robot stops in any case when control ends by silence, and stops again when a client takes control. What is set
    holds for this OCU only, until it sets something else.
    """

    def __init__(self, connection: Connection, service: ServiceClient) -> None:
        self._connection = connection
        self._service = service
        self._ids = count(1)

    def __repr__(self) -> str:
        return f"<reaction of {self._service.id} to a lost link>"

    async def supported(self) -> tuple[str, ...]:
        """Reactions that the robot has."""
        report = await self._service.query(QueryCommsLostCapabilities(), expects=ReportCommsLostCapabilities)
        found = report.supported_behaviors
        flags = (found.stop, found.continue_mission, found.move_to_pos, found.retrotraverse)
        return tuple(name for name, flag in zip(REACTIONS, flags, strict=True) if flag)

    async def set(
        self,
        reaction: str,
        *,
        timeout: int = 0,
        distance: float | None = None,
        speed: float | None = None,
        point: tuple[float, float] | None = None,
        regained: str = "stop",
        regained_timeout: int = 0,
    ) -> None:
        """Set the reaction to a lost link; needs control, and holds for this OCU.

        "stop" stays where the robot has stopped, "continue" goes on to its waypoint or along its list, "move_to" drives
        straight to a `point` (latitude and longitude in degrees) at `speed` m/s and halts after `distance` metres
        (0: unlimited), "retrotraverse" drives `distance` metres back along its path, or to where the path comes nearest
        to a `point`; without `speed` as fast as it came. The reaction begins after `timeout` seconds of silence, 0: as
        soon as control has ended. When the robot has heard this OCU for `regained_timeout` seconds again, it stops, or
        goes on (`regained="continue"`) until a client takes control. Raises `RequestError` when the robot refuses.
        """
        variant = _variant(reaction, distance, speed, point)
        if self._service.id not in self._connection.controls:
            raise ControlRejected(NOT_CONTROLLED.format(self._service.id))
        self._check_times(timeout, regained_timeout)
        if regained not in ("stop", "continue"):
            raise ConfigError(f'regained={regained!r} is neither "stop" nor "continue"')
        message = SetCommsLostPolicy(
            SetCommsLostPolicy.PolicyRec(local_id := next(self._ids) % 256),
            SetCommsLostPolicy.CommsLostSeq(SetCommsLostPolicy.CommsLostDetectionRec(timeout), variant),
            SetCommsLostPolicy.CommsRegainedSeq(
                SetCommsLostPolicy.CommsRegainedRec(
                    regained_timeout,
                    SetCommsLostPolicy.CommsRegainedBehavior.STOP_MOTION
                    if regained == "stop"
                    else SetCommsLostPolicy.CommsRegainedBehavior.DO_NOTHING,
                )
            ),
        )
        self._connection.controls.check(self._service.id, message)
        answer = await self._connection.request(
            self._service.id,
            message,
            SetCommsLostPolicyResponse,
            accept=lambda found: isinstance(found, SetCommsLostPolicyResponse) and found.local_id == local_id,
        )
        assert isinstance(answer, SetCommsLostPolicyResponse)
        if answer.comms_lost_result != SetCommsLostPolicyResponse.CommsLostResult.SUCCESS:
            supported = ", ".join(await self.supported())
            raise RequestError(
                f"{self._service.id} refuses the reaction {reaction!r} with these values; it supports: {supported}"
            )

    @staticmethod
    def _check_times(timeout: int, regained_timeout: int) -> None:
        for name, value in (("timeout", timeout), ("regained_timeout", regained_timeout)):
            check_number(value, name, whole=True)
            if not 0 <= value <= 65535:
                raise ConfigError(f"{name}={value} is outside 0..65535 seconds")
        if 0 < timeout < SHORTEST_TIMEOUT:
            raise ConfigError(f"timeout={timeout} is {TOO_SHORT}")

    async def read(self) -> CommsLostSettings:
        """The present setting."""
        report = await self._service.query(QueryCommsLostConfiguration(), expects=ReportCommsLostConfiguration)
        timeout, variant = report.comms_lost_detection_rec.comms_lost_timeout, report.comms_lost_policy_var
        if isinstance(variant, ReportCommsLostConfiguration.RetrotraverseParameterSeq):
            action = variant.retrotraverse_action_rec
            point = _point(variant.global_waypoint_rec)
            return CommsLostSettings("retrotraverse", timeout, action.distance, action.max_speed, point)
        if isinstance(variant, ReportCommsLostConfiguration.MoveToPosSeq):
            distance, speed = variant.max_distance_rec.max_distance, variant.travel_speed_rec.speed
            return CommsLostSettings("move_to", timeout, distance, speed, _point(variant.global_waypoint_rec))
        is_stop = isinstance(variant, ReportCommsLostConfiguration.StopMotionVar)
        return CommsLostSettings("stop" if is_stop else "continue", timeout)

    async def status(self) -> str:
        """Whether the robot watches a client ("enabled"), reacts to a lost link ("active"), or neither ("disabled")."""
        report = await self._service.query(QueryCommsLostStatus(), expects=ReportCommsLostStatus)
        status = report.comms_lost_status
        return status.name.lower() if isinstance(status, ReportCommsLostStatus.CommsLostStatus) else str(status)


def _point(waypoint: GlobalWaypointRec | None) -> tuple[float, float] | None:
    return None if waypoint is None else (waypoint.latitude, waypoint.longitude)


def _waypoint(point: tuple[float, float] | None) -> GlobalWaypointRec | None:
    if point is None:
        return None
    given: object = point
    if not isinstance(given, Sequence) or isinstance(given, str) or len(given) != 2:
        raise TypeError(f"point is latitude and longitude in degrees, as in (52.0, 13.0), not {described(point)}")
    latitude, longitude = point
    for value, name, limit in ((latitude, "latitude", 90.0), (longitude, "longitude", 180.0)):
        check_number(value, name)
        if abs(value) > limit:
            raise ConfigError(f"{name} {value:g} is outside -{limit:g}..{limit:g} degrees")
    return GlobalWaypointRec(latitude, longitude)


def _variant(reaction: str, distance: float | None, speed: float | None, point: tuple[float, float] | None) -> Any:
    if reaction not in REACTIONS:
        raise ConfigError(f"there is no reaction {reaction!r}; reactions are {', '.join(REACTIONS)}")
    _check_way(distance, speed)
    waypoint = _waypoint(point)
    if reaction == "retrotraverse":
        if not distance and waypoint is None:
            raise ConfigError('"retrotraverse" needs a distance above 0 m, or a point')
        action = _action(SetCommsLostPolicy, distance or 0.0, speed or 0.0)
        return SetCommsLostPolicy.RetrotraverseParameterSeq(action, waypoint)
    if reaction == "move_to":
        if waypoint is None or not speed:
            raise ConfigError('"move_to" needs a point, latitude and longitude in degrees, and a speed above 0 m/s')
        return SetCommsLostPolicy.MoveToPosSeq(
            waypoint, SetCommsLostPolicy.TravelSpeedRec(speed), SetCommsLostPolicy.MaxDistanceRec(distance or 0.0)
        )
    if any(value is not None for value in (distance, speed, point)):
        raise ConfigError(f"{reaction!r} has no distance, speed or point; leave them out")
    if reaction == "continue":
        return SetCommsLostPolicy.ContinueMissionVar(0)
    return SetCommsLostPolicy.StopMotionVar(0)


def _check_way(distance: float | None, speed: float | None) -> None:
    for value, name, limit in ((distance, "distance", 1e6), (speed, "speed", 327.67)):
        check_number(value, name, optional=True)
        if value is not None and not 0.0 <= value <= limit:
            raise ConfigError(f"{name}={value:g} is outside 0..{limit:g}")


def _action(message: Any, distance: float, speed: float, *, nose_first: bool = False, standoff: float = 0.0) -> Any:
    return message.RetrotraverseActionRec(
        distance=distance,
        max_speed=speed,
        parameters=message.Parameters(travel_method=0, direction=int(nose_first)),
        standoff_distance=standoff,
    )


@dataclass(frozen=True, slots=True)
class WayBack:
    """A way that a robot has driven back, and why it ended there."""

    distance: float
    """Metres along its path, as the robot reports them; with a standoff, up to the point that it kept away from."""
    ended_by: str
    """`"distance"`: as far as asked; `"point"`: abeam of the point; `"path"`: where the path that it keeps begins."""


async def drive_back(
    connection: Connection,
    service: ServiceClient,
    *,
    distance: float | None,
    speed: float | None,
    point: tuple[float, float] | None,
    nose_first: bool,
    standoff: float,
    timeout: float,
    progress: Callable[[float], None] | None,
) -> WayBack:
    """See `Robot.retrotraverse`."""
    _check_way(distance, speed)
    check_number(timeout, "timeout")
    check_number(standoff, "standoff")
    if not 0.0 <= standoff <= 1e5:
        raise ConfigError(f"standoff={standoff:g} is outside 0..100000 metres")
    waypoint = _waypoint(point)
    if not distance and waypoint is None:
        raise ConfigError("retrotraverse() needs a distance above 0 m, or a point")
    await check_ready(connection, service.id)
    action = _action(StartRetrotraverse, distance or 0.0, speed or 0.0, nose_first=nose_first, standoff=standoff)
    command = StartRetrotraverse(retrotraverse_action_rec=action, global_waypoint_rec=waypoint)
    may_stop = connection.begin_motion(service.id)
    started = asyncio.ensure_future(perform(connection, service.id, command, timeout))
    driven: float | None = None
    try:
        while not started.done():
            await asyncio.wait({started}, timeout=PROGRESS_INTERVAL)
            way, completed = await _status(service)
            if completed is not None:
                driven = way * completed
                if progress is not None:
                    progress(completed)
        started.result()
    except BaseException as error:
        started.cancel()
        await asyncio.wait({started})
        if may_stop():
            await connection.deliver(service.id, CancelRetrotraverse())
        if driven is not None and type(error) is RequestError:
            raise RequestError(f"{error}; it had driven {driven:.1f} m back") from error
        raise
    way, _ = await _status(service)
    if distance and way >= distance - DISTANCE_TOLERANCE:
        return WayBack(way, "distance")
    return WayBack(way, "path" if point is None else "point")


async def _status(service: ServiceClient) -> tuple[float, float | None]:
    """Metres of the present way, or of the last one, and the share that is driven, 0..1; None when it has ended."""
    report = await service.query(QueryRetrotraverseStatus(), expects=ReportRetrotraverseStatus)
    percent = report.retrotraverse_status_rec.percent_complete
    return report.retrotraverse_action_rec.distance, None if percent is None else percent / 100.0
