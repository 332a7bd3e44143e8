"""Moves arms and pan-tilt units: joints by name, the tool to a pose; names and signs of the description (URDF)."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the arm is

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncGenerator, AsyncIterator, Callable, Mapping, Sequence
from contextlib import asynccontextmanager, suppress
from datetime import UTC, datetime
from typing import Any, Final

from jauspy.arguments import check_number, described
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, EventRejected, JausError, RequestError
from jauspy.geometry.poses import JAUS_FROM_REP_103, Pose, Transform, rotation_vector
from jauspy.geometry.vectors import (
    Rotation,
    Vector,
    add,
    quaternion,
    rotation_about,
    rotation_from_quaternion,
    scaled,
    transposed,
)
from jauspy.joint_values import position_records
from jauspy.messages.description import QueryBlockedJoints, ReportBlockedJoints
from jauspy.messages.manipulator import (
    ManipulatorCoordinateSystemRec,
    QueryCommandedJointPositions,
    QueryCommandedPanTiltJointPositions,
    QueryEndEffectorPose,
    QueryJointMotionProfile,
    QueryManipulatorSpecifications,
    ReportCommandedJointPositions,
    ReportCommandedPanTiltJointPositions,
    ReportEndEffectorPose,
    ReportJointMotionProfile,
    ReportManipulatorSpecifications,
    SetEndEffectorPose,
    SetEndEffectorVelocityState,
    SetJointMotionProfile,
    SetJointPositions,
    SetPanTiltJointPositions,
)
from jauspy.ocu.commands import perform
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import check_ready, explain
from jauspy.ocu.joints import (
    DESCRIPTION,
    JointTable,
    joint_table,
    positions_in,
    positions_query,
    reported,
)
from jauspy.ocu.lists import Elements
from jauspy.ocu.motion_limits import (
    MotionLimits,
    limited_by,
    motion_limits,
    profile_record,
    speeds_for,
    straight_limits,
)
from jauspy.ocu.preset_poses import PRESET_POSE, held_pose, move_to_pose, pose_names
from jauspy.ocu.reach import reach_of
from jauspy.ocu.state import Joints, RobotPose
from jauspy.ocu.subscription import subscribe
from jauspy.ocu.subsystems import ComponentInfo

POSITION_DRIVER: Final = "ManipulatorJointPositionDriver"
PAN_TILT_DRIVER: Final = "PanTiltJointPositionDriver"
POSE_DRIVER: Final = "ManipulatorEndEffectorPoseDriver"
POSE_SENSOR: Final = "ManipulatorEndEffectorPoseSensor"
VELOCITY_DRIVER: Final = "ManipulatorEndEffectorVelocityStateDriver"
LIST_DRIVER: Final = "ManipulatorJointPositionListDriver"
PROFILE: Final = "ManipulatorJointMotionProfile"
SPECIFICATION: Final = "ManipulatorSpecificationService"
BASE_ONLY: Final = 0b1
"""Presence vector of a query for the specification with the pose of the base."""
JOINT_TOLERANCE: Final = 0.02
"""Radians or metres from a target within which a joint has reached it."""
TOOL_TOLERANCE: Final = 0.01
"""Metres from a target within which the tool has reached it."""
ATTITUDE_TOLERANCE: Final = math.radians(2.0)
STEP_TIME: Final = 0.25
"""Seconds of motion that one pose command contains, for an arm without a velocity driver."""
REST_INTERVAL: Final = 0.05
"""Seconds between two queries for the positions of joints that come to rest."""
REST_STEP: Final = 1e-3
"""Radians or metres between two queries up to which a joint is at rest."""
REST_QUERIES: Final = 4
"""Consecutive queries in which all joints must be at rest."""


class Arm:
    """An arm, or another group of joints such as flippers or a pan-tilt unit; radians or metres by name of the joint.

    Names and positions are those of the robot's description (URDF), when the robot has jauspy's service
    JointDescription, as jauspy's own robots have; else those of its specification (AS6057).
    """

    def __init__(self, connection: Connection, info: ComponentInfo) -> None:
        self.info: ComponentInfo = info
        """Id and services of the component."""
        self._connection = connection
        self._table: JointTable | None = None
        self._base: Transform | None = None
        self._step_goal: Transform | None = None
        self._step_end = 0.0
        """The last pose that `move_tool_at` commanded, and when the tool should reach it, in the event loop's time."""

    def __repr__(self) -> str:
        return f"<arm {self.info.id}>"

    async def joints(self) -> Joints:
        """The present positions by name, in radians or metres; raises `ResponseTimeout`."""
        table = await self._joint_table()
        return Joints(table.from_reported(await reported(self._connection, self.info)), datetime.now(UTC))

    async def watch(self, rate: float = 20.0, *, silence: float | None = None) -> AsyncGenerator[Joints, None]:
        """The positions by name at `rate` Hz, as in `async for joints in arm.watch()`, by a subscription.

        Raises `ResponseTimeout` when no report has arrived for `silence` seconds, by default ten periods, at least 2 s.
        """
        table, query = await self._joint_table(), positions_query(self.info)
        reports = subscribe(self._connection, self.info.id, query, query.REPORT, rate=rate, buffer=64, silence=silence)
        async with reports:
            async for report in reports:
                yield Joints(table.from_reported(positions_in(report)), datetime.now(UTC))

    async def limits(self) -> dict[str, tuple[float, float]]:
        """The least and the greatest position of each joint, in radians or metres."""
        return {joint.name: (joint.lower, joint.upper) for joint in (await self._joint_table()).joints}

    async def motion_limits(self) -> dict[str, MotionLimits]:
        """Limits of speed and acceleration of each joint, from its motion profile, or else from its description."""
        joints = (await self._joint_table()).joints
        if self.info.find(PROFILE) is None:
            return {joint.name: MotionLimits(joint.max_speed or math.inf) for joint in joints}
        report = await self._connection.query(self.info.id, QueryJointMotionProfile(), expects=ReportJointMotionProfile)
        assert isinstance(report, ReportJointMotionProfile)
        return {
            joint.name: motion_limits(record)
            for joint, record in zip(joints, report.joint_motion_profile_list, strict=True)
        }

    async def set_motion_limits(self, limits: Mapping[str, MotionLimits]) -> None:
        """Set speed and acceleration of these joints in the motion profile; the others keep theirs.

        The profile is that of the robot, for all clients: it applies to motions that begin later, and stays. A robot
        clamps it to what its joints can do.
        """
        self._need(PROFILE, "limit the speed of its joints")
        joints = (await self._joint_table()).joints
        known = [joint.name for joint in joints]
        for name, limit in limits.items():
            if name not in known:
                raise ConfigError(f"there is no joint {name!r}; there are {', '.join(known)}")
            limit.check()
        if len(limits) < len(joints):
            limits = await self.motion_limits() | dict(limits)
        records = [profile_record(limits[joint.name], is_revolute=joint.is_revolute) for joint in joints]
        await self._connection.send_checked(self.info.id, SetJointMotionProfile(records), ack=True)

    async def description(self) -> JointTable:
        """The joints from base to tip, with type, limits and greatest speed."""
        return await self._joint_table()

    async def joint_positions(self, **positions: float) -> SetJointPositions:
        """The message that moves these joints (radians or metres) and leaves the others where they are commanded to be.

        For `send`, `perform` and lists.
        """
        self._need(POSITION_DRIVER, "move its joints to positions")
        values = await self._values(positions)
        return SetJointPositions(position_records(values, (await self._joint_table()).joints))

    async def begin(self, joints: Mapping[str, float]) -> None:
        """Have joints begin to move, as in `{"elbow": 0.6}`; returns when the command is acknowledged.

        The others hold. A component that is not Ready ignores the command; `move` checks that, and waits for the end.
        """
        await self._send(await self._values(joints))

    async def move(
        self,
        joints: Mapping[str, float],
        *,
        speed: float | Mapping[str, float] | None = None,
        duration: float | None = None,
        tolerance: float | None = None,
        timeout: float = 60.0,
    ) -> Joints:
        """Move joints, as in `{"elbow": 0.6}`, and wait until they are there; the others hold. Returns the positions.

        `speed` limits every joint, in rad/s or m/s, or those that it names; without it the robot's motion profile
        applies. With `duration` all joints take that many seconds. With `tolerance` it waits until the joints rest
        within so many rad or m of their positions, by their reports, and that suffices. Raises `ConfigError` for
        unknown joints, positions out of range and a duration that is too short, `RequestError` when the arm does not
        arrive within `timeout` seconds (after `duration`). If the call is cancelled, the arm stops.
        """
        check_number(timeout, "timeout")
        check_number(tolerance, "tolerance", optional=True)
        values = await self._values(joints)
        await check_ready(self._connection, self.info.id)
        if duration is not None:
            if speed is not None:
                raise ConfigError("give `speed` or `duration`, not both")
            check_number(duration, "duration")
            present = await reported(self._connection, self.info)
            speed, timeout = speeds_for(await self.motion_limits(), present, values, duration), timeout + duration
        async with self._stopping(), self._limited(speed):
            try:
                await perform(self._connection, self.info.id, await self._message(values), timeout)
            except EventRejected:  # it does not report the end of a command
                await self._send(values)
                await self._arrive(values, tolerance or JOINT_TOLERANCE, timeout)
            except RequestError as error:
                lost = isinstance(error, ControlRejected)
                if lost or tolerance is None or await self._largest_error(values) > tolerance:
                    raise RequestError(await self._why(values, error)) from error
            else:
                if tolerance is not None:
                    await self._arrive(values, tolerance, timeout)
        return await self.joints()

    async def poses(self) -> tuple[str, ...]:
        """Names of the poses that the robot knows for these joints; empty for an arm without the service PresetPose."""
        if self.info.find(PRESET_POSE) is None:
            return ()
        return tuple((await pose_names(self._connection, self.info.id)).values())

    async def pose(self) -> str | None:
        """The name of the pose in which the joints are; None if they are in none."""
        self._need(PRESET_POSE, "tell its pose")
        return await held_pose(self._connection, self.info.id)

    async def move_to(self, name: str, *, timeout: float = 60.0) -> Joints:
        """Move to a pose that the robot knows, as in `arm.move_to("stow")`, and wait until the joints are there.

        The robot chooses a route on which its links touch neither each other nor the ground on which it stands.
        Raises `ConfigError` for an unknown pose, and `RequestError`, with the reason, when the pose is not reached
        within `timeout` seconds. If the call is cancelled, the arm stops.
        """
        self._need(PRESET_POSE, "move to named poses")
        async with self._stopping():
            await move_to_pose(self._connection, self.info.id, name, timeout, self.blocked)
        return await self.joints()

    async def move_tool_at(
        self,
        linear: Sequence[float] = (0.0, 0.0, 0.0),
        angular: Sequence[float] = (0.0, 0.0, 0.0),
        *,
        frame: str = "robot",
    ) -> None:
        """Move the tool at m/s along and rad/s about the axes of a frame; without velocities it stops.

        `frame`: "robot" (x forward, y left, z up), or "tool", that of the tool link. Repeat the command: the arm stops
        after the robot's `command_timeout`. An arm without a velocity driver receives poses instead; each command then
        moves it for a quarter of a second.
        """
        velocity, turn = _vector(linear, "linear"), _vector(angular, "angular")
        if frame not in ("robot", "tool"):
            raise ConfigError(f'frame={frame!r} is unknown; there are "robot" and "tool"')
        self._need(VELOCITY_DRIVER if self.info.find(VELOCITY_DRIVER) else POSE_DRIVER, "move its tool at a velocity")
        if self.info.find(VELOCITY_DRIVER) is None and not any((*velocity, *turn)):
            self._step_goal = None
            await self.stop()
            return
        base = await self._base_frame()
        if frame == "tool":
            tool = (await self._tool()).rotation
            velocity, turn = _rotated(tool, velocity), _rotated(tool, turn)
        if self.info.find(VELOCITY_DRIVER) is None:
            await self._step(velocity, turn)
            return
        inverse = transposed(base.rotation)
        (vx, vy, vz), (wx, wy, wz) = _rotated(inverse, velocity), _rotated(inverse, turn)
        command = SetEndEffectorVelocityState(
            angular_velocity_component_x=wx,
            angular_velocity_component_y=wy,
            angular_velocity_component_z=wz,
            linear_velocity_component_x=vx,
            linear_velocity_component_y=vy,
            linear_velocity_component_z=vz,
        )
        await self._connection.send_checked(self.info.id, command, ack=not any((*velocity, *turn)))

    async def follow(
        self,
        rows: Sequence[tuple[float, Mapping[str, float]]],
        *,
        straight: bool = False,
        progress: Callable[[int], None] | None = None,
        timeout: float = 60.0,
    ) -> Joints:
        """Move joints through several positions, and wait until they are at the last ones; returns the positions.

        A row consists of the duration of its motion in seconds and of positions by name, as in `(2.0, {"elbow": 0.6})`;
        a duration of 0 means as fast as the robot's motion profile allows. All rows are checked before anything moves.
        They are uploaded as a list if the component supports lists and each row moves a joint; otherwise they are sent
        one after another. With `straight` all joints keep the same part of their ways of a row behind them, as motions
        that were planned around something need; the rows are then sent one after another, since a list goes on before
        the arm rests. `progress` is called with the index of each row that begins. Raises `ConfigError` with the number
        of a row that is not possible, and `RequestError` when the arm stops before the end. If the call is cancelled,
        the arm stops.
        """
        if straight:
            self._need(PROFILE, "move all joints on a straight way")
        targets, profiles, moves = await self._planned(rows, straight=straight)
        await check_ready(self._connection, self.info.id)
        tell = progress or (lambda _: None)
        end = timeout + sum(seconds for seconds, _ in rows)
        async with self._stopping():
            if self.info.find(LIST_DRIVER) and all(moves) and not straight:
                try:
                    async with asyncio.timeout(end):
                        await self._follow_list(targets, profiles, tell)
                except TimeoutError:
                    raise RequestError(f"{self.info.id} is not at the last row after {end:g} s") from None
            else:
                begun = asyncio.get_running_loop().time()
                for number, (seconds, positions) in enumerate(rows):
                    tell(number)
                    async with self._profiled(profiles[number]):
                        await self.move(positions, timeout=end)
                    begun += seconds
                    await asyncio.sleep(max(0.0, begun - asyncio.get_running_loop().time()))
        return await self.joints()

    async def move_tool(
        self,
        position: Sequence[float],
        rpy: Sequence[float] | None = None,
        *,
        speed: float | None = None,
        timeout: float = 60.0,
    ) -> RobotPose:
        """Move the tool to a pose and wait until it is there.

        Metres and radians in the robot's frame: x forward, y left, z up.

        `rpy` is roll, pitch and yaw of the tool link; without it the arm keeps the present attitude as well as it can.
        `speed` limits every joint, in rad/s or m/s. Raises `RequestError` when the tool does not get there; before
        anything moves when the geometry that the arm reports shows that the pose is out of reach.
        """
        goal, attitude = _vector(position, "position"), None if rpy is None else _vector(rpy, "rpy")
        if attitude is not None and max(map(abs, attitude)) > math.tau:
            raise ConfigError(f"rpy={tuple(attitude)} is in radians; `math.radians(90)` converts degrees")
        check_number(timeout, "timeout")
        self._need(POSE_DRIVER, "move its tool to a pose")
        table, base = await self._joint_table(), await self._base_frame()
        present = await self._tool()
        turned = present if attitude is None else Transform.from_pose(Pose(*goal, *attitude))
        tool = Transform(turned.rotation, goal)
        local = base.inverse() @ tool @ Transform(transposed(table.tool))
        await check_ready(self._connection, self.info.id)
        if reach := await reach_of(self._connection, self.info, table):
            start, point = await reported(self._connection, self.info), base.inverse().apply(present.position)
            if reason := await reach.obstacle(local, start, point, exactly=rpy is not None):
                raise RequestError(f"{self.info.id}: {reason}")
        command = SetEndEffectorPose(*local.position, *quaternion(local.rotation))
        async with self._stopping(), self._limited(speed):
            try:
                await perform(self._connection, self.info.id, command, timeout)
            except RequestError as error:
                if not await self._is_at(tool, exactly=rpy is not None):
                    raise await self._not_reached(tool, command, error) from error
        return await self.tool()

    async def tool(self) -> RobotPose:
        """The present pose of the tool link in the robot's frame, in metres and radians."""
        pose = (await self._tool()).to_pose()
        return RobotPose(
            x=pose.x, y=pose.y, z=pose.z, roll=pose.roll, pitch=pose.pitch, yaw=pose.yaw, time=datetime.now(UTC)
        )

    async def stop(self) -> None:
        """Hold the present positions."""
        await self._send(await reported(self._connection, self.info))

    # --- inside ---------------------------------------------------------------------------------------------------

    def _need(self, service: str, what: str) -> None:
        if self.info.find(service) is None:
            raise ConfigError(f"{self.info.id} cannot {what}: it does not offer {service}")

    async def _joint_table(self) -> JointTable:
        if self._table is None:
            self._table = await joint_table(self._connection, self.info)
        return self._table

    @property
    def _pans_and_tilts(self) -> bool:
        return self.info.find(POSITION_DRIVER) is None and self.info.find(PAN_TILT_DRIVER) is not None

    async def _values(self, positions: Mapping[str, float]) -> list[float]:
        """The positions of all joints as in commands (AS6057); those that are not given stay as they are commanded."""
        if not self._pans_and_tilts:
            self._need(POSITION_DRIVER, "move its joints to positions")
        table = await self._joint_table()
        wanted = table.check(positions)
        if len(wanted) < len(table.joints):
            wanted = table.from_reported(await self._commanded()) | wanted
        return table.to_reported(wanted)

    async def _commanded(self) -> list[float]:
        id = self.info.id
        if self._pans_and_tilts:
            angles = await self._connection.query(
                id, QueryCommandedPanTiltJointPositions(), expects=ReportCommandedPanTiltJointPositions
            )
            assert isinstance(angles, ReportCommandedPanTiltJointPositions)
            return [angles.joint1_position, angles.joint2_position]
        query = QueryCommandedJointPositions()
        report = await self._connection.query(id, query, expects=ReportCommandedJointPositions)
        assert isinstance(report, ReportCommandedJointPositions)
        return [float(position.joint_position.value) for position in report.joint_position_list]

    async def _message(self, values: Sequence[float]) -> Message:
        """The command to these positions of all joints."""
        if self._pans_and_tilts:
            return SetPanTiltJointPositions(*values)
        return SetJointPositions(position_records(values, (await self._joint_table()).joints))

    async def _send(self, values: Sequence[float]) -> None:
        await self._connection.send_checked(self.info.id, await self._message(values), ack=True)

    @asynccontextmanager
    async def _stopping(self) -> AsyncIterator[None]:
        """Stop the arm when the block is cancelled or fails, if it is controlled and no later motion has begun."""
        may_stop = self._connection.begin_motion(self.info.id)
        try:
            yield
        except BaseException:
            if may_stop():
                with suppress(JausError):
                    await self.stop()
            raise

    @asynccontextmanager
    async def _limited(self, speed: float | Mapping[str, float] | None) -> AsyncIterator[None]:
        """Set this speed in the motion profile, and restore the profile at the end."""
        if speed is None:
            yield
            return
        names = [joint.name for joint in (await self._joint_table()).joints]
        speeds = speed if isinstance(speed, Mapping) else dict.fromkeys(names, speed)
        for value in speeds.values():
            check_number(value, "speed")
            if not value > 0:
                raise ConfigError(f"speed {value:g} must be above 0 rad/s or m/s")
        self._need(PROFILE, "limit the speed of its joints")
        async with self._profiled(limited_by(await self.motion_limits(), speeds)):
            yield

    @asynccontextmanager
    async def _profiled(self, limits: Mapping[str, MotionLimits]) -> AsyncIterator[None]:
        """Set these limits in the motion profile, and restore them at the end; none leave it as it is."""
        if not limits:
            yield
            return
        before = await self.motion_limits()
        await self.set_motion_limits(limits)
        try:
            yield
        finally:
            if self.info.id in self._connection.controls:
                with suppress(JausError):
                    await self.set_motion_limits(before)

    async def _planned(
        self, rows: Sequence[tuple[float, Mapping[str, float]]], *, straight: bool
    ) -> tuple[list[list[float]], list[dict[str, MotionLimits]], list[bool]]:
        """The positions of all joints and the limits of each row, none for full speed, and whether it moves a joint."""
        if not rows:
            raise ConfigError("`rows` is empty; give at least one row")
        table, limits = await self._joint_table(), await self.motion_limits()
        values = await reported(self._connection, self.info)
        targets, profiles, moves = list[list[float]](), list[dict[str, MotionLimits]](), list[bool]()
        for number, (seconds, positions) in enumerate(rows, 1):
            check_number(seconds, f"the time of row {number}")
            if seconds < 0:
                raise ConfigError(f"row {number}: its time is {seconds:g} s; use 0 for as fast as possible")
            try:
                after = table.to_reported(table.from_reported(values) | table.check(positions))
                if straight:
                    profiles.append(straight_limits(limits, values, after, seconds))
                else:
                    speeds = speeds_for(limits, values, after, seconds) if seconds else {}
                    profiles.append(limited_by(limits, speeds) if seconds else {})
            except ConfigError as error:
                raise ConfigError(f"row {number}: {error}") from None
            moves.append(any(abs(a - b) > JOINT_TOLERANCE for a, b in zip(values, after, strict=True)))
            targets.append(after)
            values = after
        if any(profiles):
            profiles = [profile or limits for profile in profiles]
        return targets, profiles, moves

    async def _follow_list(
        self, targets: list[list[float]], profiles: list[dict[str, MotionLimits]], tell: Callable[[int], None]
    ) -> None:
        """Execute the rows as a list of the component.

        The motion profile of a row is set during the motion of the row before.
        """
        info = self.info.find(LIST_DRIVER)
        assert info is not None
        elements = Elements(self._connection, self.info.id, info)
        await elements.upload([await self._message(values) for values in targets])
        async with self._profiled(profiles[0]):
            await elements.execute()
            async for number in elements.progress():
                tell(number)
                if number + 1 < len(targets) and profiles[number + 1]:
                    await self.set_motion_limits(profiles[number + 1])
        if await self._largest_error(targets[-1]) > JOINT_TOLERANCE:
            raise RequestError(await self._why(targets[-1], RequestError(f"{self.info.id} has not followed all rows")))

    async def _step(self, velocity: Vector, turn: Vector) -> None:
        """Command the pose that the tool reaches with these velocities until the next command, in the robot's frame."""
        table, base, now = await self._joint_table(), await self._base_frame(), asyncio.get_running_loop().time()
        if self._step_goal is None or now > self._step_end:
            self._step_goal, self._step_end = await self._tool(), now
        time = now + STEP_TIME - self._step_end
        before, angle = self._step_goal, math.hypot(*turn)
        turned = Transform(rotation_about(scaled(turn, 1.0 / angle), angle * time)) @ before if angle else before
        self._step_goal = Transform(turned.rotation, add(before.position, scaled(velocity, time)))
        self._step_end = now + STEP_TIME
        local = base.inverse() @ self._step_goal @ Transform(transposed(table.tool))
        command = SetEndEffectorPose(*local.position, *quaternion(local.rotation))
        await self._connection.send_checked(self.info.id, command, ack=False)

    async def _arrive(self, wanted: Sequence[float], tolerance: float, timeout: float) -> None:
        """Wait until the joints rest within `tolerance` of these positions, by their reports."""
        clock = asyncio.get_running_loop().time
        end, before, rests = clock() + timeout, await reported(self._connection, self.info), 0
        while True:
            await asyncio.sleep(REST_INTERVAL)
            now = await reported(self._connection, self.info)
            arrived = _largest(now, wanted) <= tolerance and _largest(now, before) <= REST_STEP
            rests, before = rests + 1 if arrived else 0, now
            if rests >= REST_QUERIES:
                return
            if clock() > end:
                late = RequestError(f"{self.info.id} has not reached its target after {timeout:g} s; it may be blocked")
                raise RequestError(await self._why(wanted, late, tolerance))

    async def _largest_error(self, wanted: Sequence[float]) -> float:
        return _largest(await reported(self._connection, self.info), wanted)

    async def _why(self, values: Sequence[float], error: RequestError, tolerance: float = JOINT_TOLERANCE) -> str:
        """Why the joints are not at these positions."""
        if blocked := await self.blocked():
            return blocked
        reason = await explain(self._connection, self.info.id, await self._message(values))
        if reason:
            return reason
        wanted = (await self._joint_table()).from_reported(values)
        now = (await self.joints()).positions
        off = {name: now[name] - wanted[name] for name in wanted if abs(now[name] - wanted[name]) > tolerance}
        where = ", ".join(f"{name} is {value:+.3f} off" for name, value in off.items())
        return f"{error}; {where}" if where else str(error)

    async def blocked(self) -> str:
        """What kept the last command from being carried out, as in "Blocked: elbow, 41 N m, 0.07 rad short; ...".

        Joints that met something, or stood still short of their positions, with effort and way left; empty without any.
        """
        if self.info.find(DESCRIPTION) is None:
            return ""
        report = await self._connection.query(self.info.id, QueryBlockedJoints(), expects=ReportBlockedJoints)
        assert isinstance(report, ReportBlockedJoints)
        turns = {joint.name: joint.is_revolute for joint in (await self._joint_table()).joints}
        parts = []
        for joint in report.blocked_joint_list:
            push, way = ("N m", "rad") if turns.get(joint.joint_name, True) else ("N", "m")
            short = f", {abs(joint.short):.2f} {way} short" if joint.short else ""
            parts.append(f"{joint.joint_name}, {abs(joint.effort):.0f} {push}{short}")
        return f"Blocked: {'; '.join(parts)}; {self.info.id} holds where it is" if parts else ""

    async def _base_frame(self) -> Transform:
        """The manipulator's coordinate system in the robot's frame, both with axes of REP-103."""
        if self._base is None:
            self._need(SPECIFICATION, "tell where it stands on the robot")
            query = QueryManipulatorSpecifications(BASE_ONLY)
            report = await self._connection.query(self.info.id, query, expects=ReportManipulatorSpecifications)
            assert isinstance(report, ReportManipulatorSpecifications)
            if report.manipulator_coordinate_system_rec is None:
                raise ConfigError(f"{self.info.id} does not report the pose of its base on the robot")
            self._base = JAUS_FROM_REP_103 @ _base_of(report.manipulator_coordinate_system_rec)
        return self._base

    async def _tool(self) -> Transform:
        self._need(POSE_SENSOR, "tell the pose of its tool")
        table, base = await self._joint_table(), await self._base_frame()
        report = await self._connection.query(self.info.id, QueryEndEffectorPose(), expects=ReportEndEffectorPose)
        assert isinstance(report, ReportEndEffectorPose)
        rotation = rotation_from_quaternion(*_quaternion(report))
        point = (report.tool_point_coordinate_x, report.tool_point_coordinate_y, report.tool_point_coordinate_z)
        return base @ Transform(rotation, point) @ Transform(table.tool)

    async def _is_at(self, goal: Transform, *, exactly: bool) -> bool:
        tool = await self._tool()
        turn = math.hypot(*rotation_vector(tool.rotation, goal.rotation))
        return math.dist(tool.position, goal.position) <= TOOL_TOLERANCE and (not exactly or turn <= ATTITUDE_TOLERANCE)

    async def _not_reached(self, goal: Transform, command: SetEndEffectorPose, error: RequestError) -> RequestError:
        if reason := await self.blocked() or await explain(self._connection, self.info.id, command):
            return RequestError(reason)
        tool = await self._tool()
        distance = math.dist(tool.position, goal.position)
        turn = math.degrees(math.hypot(*rotation_vector(tool.rotation, goal.rotation)))
        return RequestError(
            f"the tool of {self.info.id} is {distance:.3f} m and {turn:.0f}° from the pose: it is out of reach, or the "
            f"arm has too few joints for the attitude (leave out `rpy`, then the point counts); {error}"
        )


def _vector(values: Sequence[float], name: str) -> Vector:
    numbers = list(values) if not isinstance(values, int | float | str) else []
    if len(numbers) != 3:
        raise TypeError(f"{name} is three numbers, as in (0.6, 0.0, 0.3), not {described(values)}")
    for number in numbers:
        check_number(number, name)
    x, y, z = map(float, numbers)
    if not all(map(math.isfinite, (x, y, z))):
        raise ConfigError(f"{name} is three finite numbers, as in (0.6, 0.0, 0.3), not {(x, y, z)}")
    return x, y, z


def _rotated(rotation: Rotation, vector: Vector) -> Vector:
    return Transform(rotation).rotate(vector)


def _quaternion(record: Any) -> tuple[float, float, float, float]:
    return (
        record.d_component_of_unit_quaternion_q,
        record.a_component_of_unit_quaternion_q,
        record.b_component_of_unit_quaternion_q,
        record.c_component_of_unit_quaternion_q,
    )


def _base_of(record: ManipulatorCoordinateSystemRec) -> Transform:
    point = (
        record.manipulator_coordinate_sys_x,
        record.manipulator_coordinate_sys_y,
        record.manipulator_coordinate_sys_z,
    )
    return Transform(rotation_from_quaternion(*_quaternion(record)), point)


def _largest(these: Sequence[float], those: Sequence[float]) -> float:
    """The largest difference of two joints."""
    return max(abs(a - b) for a, b in zip(these, those, strict=True))
