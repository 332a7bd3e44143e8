"""Drives at velocities and to points, in metres and radians, with the axes of REP-103."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the robot is

from __future__ import annotations

import asyncio
import math
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, EventRejected, RequestError, ResponseTimeout
from jauspy.geometry.poses import PlanarPose, wrap_angle
from jauspy.ids import JausID
from jauspy.messages.mobility import (
    QueryLocalPose,
    ReportLocalPose,
    ReportVelocityCommand,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetVelocityCommand,
    SetWrenchEffort,
)
from jauspy.messages.ugv import QueryPlatformSpecifications, ReportPlatformSpecifications
from jauspy.ocu.commands import CommandStream, perform
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import NOT_CONTROLLED, check_ready
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.state import RobotPose, pose_of

RATE: Final = 10.0
"""Hz at which a velocity is repeated."""
VELOCITY, WRENCH = "mobility:VelocityStateDriver", "mobility:PrimitiveDriver"
X_AND_YAW: Final = 0b100001
"""Presence vector of a velocity: forward and about z."""
VELOCITY_TOLERANCE: Final = 1e-3
"""m/s and rad/s by which a velocity may exceed the limit that the robot reports."""
PROGRESS_INTERVAL: Final = 0.2
"""Seconds between two queries for the pose on the way to a point."""
TOLERANCE: Final = 0.1
"""Metres from a point within which it is reached."""
MAX_STEP: Final = 0.01
"""Metres between two poses below which a robot counts as stopped."""

FRAMES: Final = ("local", "robot")


@dataclass(frozen=True, slots=True)
class Progress:
    """Progress on the way to a point: remaining distance in metres, pose, and seconds since the start."""

    distance: float
    pose: RobotPose
    elapsed: float

    def __str__(self) -> str:
        return f"{self.distance:.2f} m left after {self.elapsed:.1f} s"


@dataclass(frozen=True, slots=True)
class VelocityLimits:
    """m/s forward and rad/s."""

    linear: float
    angular: float

    def check(self, linear: float, angular: float) -> None:
        """Raise `ConfigError` for velocities beyond these."""
        for name, value, limit, unit in (
            ("linear", linear, self.linear, "m/s"),
            ("angular", angular, self.angular, "rad/s"),
        ):
            if abs(value) > limit + VELOCITY_TOLERANCE:
                raise ConfigError(f"{name}={value:g} is more than the {limit:.4g} {unit} that this robot can drive")


Offering = Callable[..., ServiceClient | None]
"""The client of the first of these services that the robot offers."""


class Driving:
    """Drives one robot; `offering` finds its services."""

    def __init__(self, connection: Connection, offering: Offering) -> None:
        self._connection = connection
        self._offering = offering
        self._stream: CommandStream | None = None
        self._streams_to: JausID | None = None
        self._limits: VelocityLimits | None = None

    def driver(self) -> ServiceClient:
        """The service that takes velocities, or else efforts; `ConfigError` when the robot offers neither."""
        found = self._offering(VELOCITY, WRENCH)
        if found is None:
            raise ConfigError(f"this robot cannot be driven: it offers neither {VELOCITY} nor {WRENCH}")
        return found

    async def drive(self, linear: float, angular: float, seconds: float | None) -> None:
        """See `Robot.drive`."""
        for value, use in ((linear, "linear"), (angular, "angular")):
            check_number(value, use)
        check_number(seconds, "seconds", optional=True)
        driver = self.driver()
        limits = await self._known_limits()
        if limits is not None:
            limits.check(linear, angular)
        await self._stream_to(driver, self._command(driver, linear, angular), seconds)

    async def drive_effort(self, linear: float, angular: float, seconds: float | None) -> None:
        """See `Robot.drive_effort`."""
        for value, use in ((linear, "linear"), (angular, "angular")):
            check_number(value, use)
            if not -100 <= value <= 100:
                raise ConfigError(f"{use}={value:g} is outside -100..100 percent")
        check_number(seconds, "seconds", optional=True)
        driver = self._offering(WRENCH)
        if driver is None:
            raise ConfigError(f"this robot takes no efforts: it does not offer {WRENCH}")
        effort = SetWrenchEffort(propulsive_linear_effort_x=linear, propulsive_rotational_effort_z=-angular)
        await self._stream_to(driver, effort, seconds)

    async def _stream_to(self, driver: ServiceClient, command: Message, seconds: float | None) -> None:
        """Send this command repeatedly, until the next one or for a number of seconds."""
        stream = await self._opened(driver)
        if not stream.active:
            await check_ready(self._connection, driver.id)
        may_stop = self._connection.begin_motion(driver.id)
        await stream.send(command)
        if seconds is not None:
            try:
                await self._while_active(stream, driver, seconds)
            finally:
                if may_stop():
                    await self.stop()

    async def speed_limits(self) -> tuple[float, float]:
        """See `Robot.speed_limits`."""
        limits = await self._known_limits()
        return (math.inf, math.inf) if limits is None else (limits.linear, limits.angular)

    async def _known_limits(self) -> VelocityLimits | None:
        if self._limits is None:
            self._limits = await self._read_limits(self.driver())
        return self._limits

    async def stop(self) -> None:
        """Stop the robot."""
        if self._stream is not None and self._stream.active:
            await self._stream.stop()
            return
        driver = self.driver()
        await self._connection.send_checked(driver.id, self._command(driver, 0.0, 0.0), ack=True)

    async def close(self) -> None:
        """End the repetition of the last command."""
        stream, self._stream = self._stream, None
        if stream is not None:
            await stream.__aexit__(None, None, None)

    async def pose(self) -> RobotPose:
        """See `Robot.pose`."""
        sensor = self._offering("mobility:LocalPoseSensor")
        if sensor is None:
            raise ConfigError("this robot does not report its pose: it does not offer mobility:LocalPoseSensor")
        report = await sensor.query(QueryLocalPose(), expects=ReportLocalPose)
        return pose_of(report, datetime.now(UTC))

    async def go_to(
        self,
        x: float,
        y: float,
        yaw: float | None,
        frame: str,
        *,
        speed: float,
        tolerance: float,
        accept: float | None,
        timeout: float,
        progress: Callable[[Progress], None] | None,
    ) -> RobotPose:
        """See `Robot.go_to`."""
        check_number(accept, "accept", optional=True)
        for value, use in ((x, "x"), (y, "y"), (speed, "speed"), (tolerance, "tolerance"), (timeout, "timeout")):
            check_number(value, use)
        check_number(yaw, "yaw", optional=True)
        if frame not in FRAMES:
            raise ConfigError(f"there is no frame {frame!r}; frames are {', '.join(FRAMES)}")
        driver = self._offering("mobility:LocalWaypointDriver")
        if driver is None:
            raise ConfigError("this robot cannot drive to a point: it does not offer mobility:LocalWaypointDriver")
        await self.close()
        await check_ready(self._connection, driver.id)
        goal = PlanarPose(x, y, yaw or 0.0)
        if frame == "robot":
            pose = await self.pose()
            goal = PlanarPose(pose.x, pose.y, pose.yaw) @ goal
        waypoint = SetLocalWaypoint(
            x=goal.x,
            y=-goal.y,
            yaw=None if yaw is None else wrap_angle(-goal.yaw),
            waypoint_tolerance=tolerance,
        )
        may_stop = self._connection.begin_motion(driver.id)
        await self._connection.send_checked(driver.id, waypoint, ack=True)
        way = _Way(self, goal, tolerance if accept is None else accept, progress)
        try:
            return await way.follow(lambda: self._travel(driver, speed, timeout), timeout)
        except BaseException as error:
            if isinstance(error, RequestError):
                self._connection.controls.check(driver.id, waypoint)  # a lost control explains it
            if may_stop():
                await self._connection.deliver(driver.id, self._command(self.driver(), 0.0, 0.0))
            raise

    async def _travel(self, driver: ServiceClient, speed: float, timeout: float) -> None:
        """Returns when the robot reports that it has arrived, or, if it cannot, when its pose shows it."""
        try:
            await perform(self._connection, driver.id, SetTravelSpeed(speed), timeout)
        except EventRejected:  # no command events (Events 1.0)
            await self._connection.send_checked(driver.id, SetTravelSpeed(speed), ack=True)

    async def _opened(self, driver: ServiceClient) -> CommandStream:
        if driver.id not in self._connection.controls:
            raise ControlRejected(NOT_CONTROLLED.format(driver.id))
        if self._stream is None or self._streams_to != driver.id:
            await self.close()
            self._stream, self._streams_to = await driver.streaming(RATE).__aenter__(), driver.id
        return self._stream

    async def _while_active(self, stream: CommandStream, driver: ServiceClient, seconds: float) -> None:
        clock = asyncio.get_running_loop().time
        end = clock() + seconds
        while (left := end - clock()) > 0:
            await asyncio.sleep(min(left, 1.0 / RATE))
            if not stream.active:
                self._connection.controls.check(driver.id, _STOP)
                raise RequestError(f"{driver.id} was stopped while it drove; the log has the reason")

    def _command(self, driver: ServiceClient, linear: float, angular: float) -> Message:
        """The velocity, or the efforts that are this share of the full speed."""
        if driver.info.is_called(VELOCITY):
            return SetVelocityCommand(
                SetVelocityCommand.CommandType.SET_CURRENT_COMMAND, velocity_x=linear, yaw_rate=-angular
            )
        full = self._limits or VelocityLimits(1.0, 1.0)
        return SetWrenchEffort(
            propulsive_linear_effort_x=_percent(linear, full.linear),
            propulsive_rotational_effort_z=_percent(-angular, full.angular),
        )

    async def _read_limits(self, driver: ServiceClient) -> VelocityLimits | None:
        if driver.info.is_called(VELOCITY):
            query = driver.message("QueryVelocityCommand")(X_AND_YAW, ReportVelocityCommand.CommandType(1))
            try:
                report: Any = await driver.query(query)
            except ResponseTimeout:
                return None
            if not report.velocity_x or not report.yaw_rate:
                return None
            return VelocityLimits(abs(report.velocity_x), abs(report.yaw_rate))
        found = await self._specified_limits()
        if found is None:
            raise ConfigError(
                "this robot takes efforts (percent) only and does not report its greatest speeds, so m/s cannot be "
                "converted; send SetWrenchEffort to mobility:PrimitiveDriver"
            )
        return found

    async def _specified_limits(self) -> VelocityLimits | None:
        service = self._offering("ugv:PlatformSpecifications")
        if service is None:
            return None
        report = await service.query(QueryPlatformSpecifications(), expects=ReportPlatformSpecifications)
        speeds = _platform_speeds(report)
        return VelocityLimits(*speeds) if all(speeds) else None


_STOP: Final = SetTravelSpeed(0.0)


def _percent(value: float, full: float) -> float:
    return max(-100.0, min(100.0, 100.0 * value / full))


MAX_TILT: Final = math.radians(30.0)
"""Radians of tilt from which on an error names the tilt of a robot that stopped, since it may be the reason."""


class _Way:
    """The way to one point."""

    def __init__(
        self, driving: Driving, goal: PlanarPose, tolerance: float, progress: Callable[[Progress], None] | None
    ) -> None:
        self._driving, self._goal, self._tolerance, self._progress = driving, goal, tolerance, progress

    async def follow(self, travel: Callable[[], Awaitable[None]], timeout: float) -> RobotPose:
        """Start, and wait until the robot stands at the point; returns its pose there."""
        clock = asyncio.get_running_loop().time
        began, before = clock(), None
        task = asyncio.ensure_future(travel())
        try:
            while True:
                done, _ = await asyncio.wait({task}, timeout=PROGRESS_INTERVAL)
                pose = await self._driving.pose()
                left = math.dist((pose.x, pose.y), (self._goal.x, self._goal.y))
                if self._progress is not None:
                    self._progress(Progress(left, pose, clock() - began))
                stands = before is not None and math.dist((pose.x, pose.y), before) < MAX_STEP
                if done and task.exception() is not None:
                    raise self._stopped(task.exception(), left, pose)
                if done and left <= self._tolerance and stands:
                    return pose
                before = (pose.x, pose.y)
                if done:
                    await asyncio.sleep(PROGRESS_INTERVAL)
                if clock() - began > timeout:
                    raise RequestError(
                        f"the robot is {left:.2f} m from ({self._goal.x:g}, {self._goal.y:g}) after "
                        f"{timeout:g} s; it may be blocked"
                    )
        finally:
            task.cancel()
            await asyncio.wait({task})

    def _stopped(self, error: BaseException | None, left: float, pose: RobotPose) -> BaseException:
        if error is not None and type(error) is RequestError:
            where = f"{left:.2f} m from ({self._goal.x:g}, {self._goal.y:g})"
            tilted = ""
            if max(abs(pose.pitch), abs(pose.roll)) > MAX_TILT:
                angles = f"pitch {math.degrees(pose.pitch):.0f}, roll {math.degrees(pose.roll):.0f} degrees"
                tilted = f"; it is tilted: {angles}, so it may have stopped itself"
            return RequestError(f"the robot stopped {where}: {error}{tilted}")
        assert error is not None
        return error


def _platform_speeds(report: ReportPlatformSpecifications) -> tuple[float, float]:
    """m/s forward and rad/s that a platform reports; zero for what it leaves out."""
    inertial = report.platform_inertial
    return inertial.maximum_forward_speed or 0.0, inertial.maximum_rotational_speed or 0.0
