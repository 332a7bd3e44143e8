"""The cell over JAUS: the UR10 by the public manipulator services, all else by the services of `urn:jauspy:cell`."""

from __future__ import annotations

import asyncio
import math
from collections import defaultdict, deque
from collections.abc import Callable, Mapping, Sequence
from contextlib import AsyncExitStack
from itertools import pairwise
from typing import Any, Final, Self

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, averaged, offset_between
from jauspy.cell.interface import GRIPPER, SeenPart, T
from jauspy.cell.motion import Path, profile
from jauspy.cell.scene import Layout
from jauspy.errors import ConfigError, JausError, RequestError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages.cell.v1_0 import (
    MoveModularArm,
    QueryConnectorState,
    QueryConveyorState,
    QueryModularArmState,
    QueryPartObservations,
    QueryServoState,
    ReportConnectorState,
    ReportModularArmState,
    ReportPartObservations,
    ReportServoState,
    SetConnector,
    SetConveyorSpeed,
    SetModularArmController,
    SetModulePower,
)
from jauspy.messages.manipulator import QueryJointPositions, SetJointMotionProfile, SetJointPositions
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.ocu.service import ServiceClient
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.arm import ArmController, ModularArmState
from jauspy.platform.modular.cell import ConveyorState
from jauspy.platform.modular.connector import ConnectorState
from jauspy.robot.config import RobotConfig
from jauspy.services.manipulator.joints import position_records

AUTHORITY: Final = 100
ALL_FIELDS: Final = 0xFFFFFFFF
GENTLE: Final = 0.05
"""Fraction of the joints' acceleration in motions that speed up slowly."""
POLL: Final = 0.02
"""Seconds between two queries of the joints at the end of a motion."""
ARRIVED: Final = 0.0015
"""Radians from the goal within which a joint has arrived, and radians between two queries within which it stands."""
LATE: Final = 0.8
"""Seconds after which a motion that is not quite there counts as ended."""
BLOCKED: Final = 0.03
"""Radians off the goal, that late, which count as blocked."""
SAMPLES: Final = 6
"""Observations of a part that are averaged."""
WATCH_PERIOD: Final = 0.1
"""Seconds between two queries for a new observation."""
MOVED: Final = 0.008
"""Metres, or a tenth of a radian, between two observations, from which on the part has moved."""
APPEAR_TIME: Final = 5.0
"""Seconds in which a module that has got power must answer discovery."""


class MotionFailed(RequestError):
    """A motion did not arrive; the message contains the distance."""


class CellClient:
    """`async with CellClient(ocu, config, model) as cell:`. Takes control of what it commands, and releases it.

    With `threads` it computes in another thread, so that planning never delays the renewal of control.
    """

    def __init__(
        self, ocu: OCU, config: RobotConfig, model: RobotModel, layout: Layout, *, threads: bool = False
    ) -> None:
        self.layout = layout
        self._threads = threads
        self._ocu = ocu
        self._config = config
        self._geometry = manipulator_geometry(model.description.chain(layout.group.base, layout.group.tip))
        self._stack = AsyncExitStack()
        self._robot: Robot | None = None
        self._services: dict[tuple[JausID, str], ServiceClient] = {}
        self._controlled: dict[JausID, ServiceClient] = {}
        self._locks: defaultdict[JausID, asyncio.Lock] = defaultdict(asyncio.Lock)
        self._seen: dict[str, deque[pin.SE3]] = {}
        self._observed = asyncio.Event()
        self._last_seen: Mapping[str, str] = {}
        self._latest: dict[str, tuple[float, pin.SE3]] = {}
        self._offset = math.inf
        """Seconds that the robot's clock is behind this one, by the observation that came fastest."""
        self.counts: dict[str, int] = defaultdict(int)

    async def __aenter__(self) -> Self:
        self._robot = await self._ocu.discover(self._config.subsystem)
        watching = asyncio.create_task(self._watch(), name="part sensor")
        self._stack.push_async_callback(_cancel, watching)
        try:
            await self._control(self._module("CM-MAN"), "ManipulatorJointPositionDriver")
        except BaseException:
            await self._stack.aclose()
            raise
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._stack.aclose()

    # --- time -----------------------------------------------------------------------------------------------------

    def now(self) -> float:
        """Seconds of the event loop's clock."""
        return asyncio.get_running_loop().time()

    async def sleep(self, seconds: float) -> None:
        """Wait for a number of seconds."""
        await asyncio.sleep(seconds)

    async def compute(self, function: Callable[[], T]) -> T:
        """The value of a function that may take seconds; on virtual time no time passes meanwhile."""
        if not self._threads:
            return function()
        computing = asyncio.ensure_future(asyncio.to_thread(function))
        try:
            return await asyncio.shield(computing)
        finally:
            await asyncio.wait({computing})

    # --- the UR10 -------------------------------------------------------------------------------------------------

    async def posture(self) -> Array:
        """Positions of the UR10's joints as its URDF counts them, in radians."""
        sensor = await self._service(self._module("CM-MAN"), "ManipulatorJointPositionSensor")
        report = await sensor.query(QueryJointPositions())
        found = [record.joint_position.value for record in report.joint_position_list]
        return np.array(self._geometry.to_urdf(found))

    async def follow(self, path: Path, *, speed: float = 1.0, gentle: bool = False) -> None:
        """Move the UR10 along a path; each straight piece is one command, in which all joints arrive together.

        `gentle` motions speed up slowly. Raises `MotionFailed` when it is blocked.
        """
        for start, goal in pairwise(path.points):
            await self._move(start, goal, speed, GENTLE if gentle else 1.0)

    async def touch(self, path: Path, connector: str, *, speed: float) -> ConnectorState:
        """As `follow`, but stop as soon as a connector has attached something; returns the connector's state.

        The arm then holds where it is: pressing on would load the joint.
        """
        for start, goal in pairwise(path.points):
            motion = asyncio.create_task(self._move(start, goal, speed))
            try:
                while not motion.done():
                    state = await self.connector(connector)
                    if state.attached_to:
                        await self._send(await self.posture())
                        return state
                    await asyncio.sleep(POLL)
                motion.result()
            finally:
                await _cancel(motion)
        return await self.connector(connector)

    async def _move(self, start: Array, goal: Array, speed: float, acceleration: float = 1.0) -> None:
        arm = self._module("CM-MAN")
        await self._control(arm, "ManipulatorJointPositionDriver")
        limits = await self._service(arm, "ManipulatorJointMotionProfile")
        found = profile(start, goal, self.layout.speeds * speed, self.layout.accelerations * acceleration)
        if not found.duration:
            return
        kind = SetJointMotionProfile.RevoluteJointMotionProfileRec
        rows = zip(found.speeds, found.accelerations, strict=True)
        await limits.send(SetJointMotionProfile([kind(float(v), float(a), float(a)) for v, a in rows]), ack=True)
        await self._send(goal)
        await asyncio.sleep(max(0.0, found.duration - POLL))
        before, until = await self.posture(), self.now() + LATE
        least = float(np.max(np.abs(before - goal)))
        while True:
            await asyncio.sleep(POLL)
            at = await self.posture()
            off, moved = float(np.max(np.abs(at - goal))), float(np.max(np.abs(at - before)))
            if moved < ARRIVED / 3.0 and off < ARRIVED:
                return
            if self.now() > until:
                if off <= BLOCKED:
                    return
                if off > least - BLOCKED:
                    joint = self.layout.group.joints[int(np.argmax(np.abs(at - goal)))]
                    raise MotionFailed(f"{joint} of the UR10 is {off:.3f} rad off after {LATE:g} s; is it blocked?")
                least, until = off, self.now() + LATE  # it comes nearer: the robot's time is slower than this clock
            before = at

    async def _send(self, goal: Array) -> None:
        driver = await self._control(self._module("CM-MAN"), "ManipulatorJointPositionDriver")
        values = self._geometry.from_urdf([float(each) for each in goal])
        await driver.send(SetJointPositions(position_records(values, self._geometry.links)), ack=True)

    # --- parts and connectors -------------------------------------------------------------------------------------

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        """The parts that the sensor sees, each averaged since it last moved; with `fresh` over new observations."""
        if fresh:
            self._seen.clear()
        while True:
            known = self._last_seen
            if known and all(len(self._seen.get(name, ())) >= SAMPLES - 2 for name in known):
                return {name: SeenPart(type, averaged(list(self._seen[name]))) for name, type in known.items()}
            self._observed.clear()
            await asyncio.wait_for(self._observed.wait(), 5.0)

    def latest(self, part: str) -> tuple[float, pin.SE3]:
        """The last single observation of a part: when, on this client's clock, and where. Raises `RequestError`."""
        if part not in self._latest:
            raise RequestError(f"the part sensor does not see {part}")
        time, pose = self._latest[part]
        return time + self._offset, pose

    async def connector(self, name: str) -> ConnectorState:
        """Measurements of a connector or the gripper. One whose module has no power reports nothing."""
        id, number = self._connector(name)
        service = await self._service(id, "VacuumConnector")
        report: ReportConnectorState = await service.query(QueryConnectorState(ALL_FIELDS, number))
        offset = Pose(*(value or 0.0 for value in _offset(report)))
        return ConnectorState(
            powered=True,
            enabled=bool(report.enabled),
            attached_to=report.attached_to or "",
            offset=Transform.from_pose(offset),
            force=report.force or 0.0,
            moment=report.moment or 0.0,
            broken_off=report.broken_off or 0,
            last_error=report.error_text or "",
        )

    async def enable(self, name: str, enabled: bool) -> None:
        """Start or stop the pump of a connector or of the gripper."""
        id, number = self._connector(name)
        service = await self._control(id, "VacuumConnector")
        await service.send(SetConnector(number, int(enabled)), ack=True)

    async def switch(self, names: Sequence[str], on: bool) -> None:
        """Switch modules on or off."""
        service = await self._control(self._module("CM-PRT"), "ModulePower")
        record = SetModulePower.ModulePowerRec
        await service.send(SetModulePower([record(name, int(on)) for name in names]), ack=True)

    async def servo(self, name: str) -> ReportServoState:
        """Measurements of a servo module."""
        service = await self._service(self._module("CM-SRV", name), "ServoModule")
        report: ReportServoState = await service.query(QueryServoState(ALL_FIELDS))
        return report

    # --- conveyor -------------------------------------------------------------------------------------------------

    async def run_conveyor(self, speed: float) -> None:
        """Run the belt at a speed, in m/s."""
        service = await self._control(self._module("CM-CNV"), "Conveyor")
        await service.send(SetConveyorSpeed(speed), ack=True)

    async def conveyor(self) -> ConveyorState:
        """Speed and travel of the belt."""
        service = await self._service(self._module("CM-CNV"), "Conveyor")
        report = await service.query(QueryConveyorState(0xFF))
        return ConveyorState(report.speed or 0.0, report.position or 0.0)

    # --- the modular arm ------------------------------------------------------------------------------------------

    async def arm(self) -> ModularArmState:
        """The modular arm's joints and motion."""
        service = await self._service(self._module("CM-ARM"), "ModularArm")
        report: ReportModularArmState = await service.query(QueryModularArmState())
        motion, joints = report.modular_arm_motion_rec, report.joint_list
        quaternion = (
            motion.tip_orientation_w,
            motion.tip_orientation_x,
            motion.tip_orientation_y,
            motion.tip_orientation_z,
        )
        tip = Transform(rotation_from_quaternion(*quaternion), (motion.tip_x, motion.tip_y, motion.tip_z))
        return ModularArmState(
            joints=tuple(each.name for each in joints),
            positions=tuple(each.position for each in joints),
            velocities=tuple(each.velocity for each in joints),
            efforts=tuple(each.effort for each in joints),
            targets=tuple(each.target for each in joints),
            moving=bool(motion.moving),
            controller=ArmController.MODEL if motion.controller else ArmController.PID,
            payload=motion.payload,
            tip_pose=tip.to_pose(),
            error=motion.error,
        )

    async def command_arm(self, positions: Sequence[float], duration: float = 0.0) -> None:
        """Have the modular arm begin a motion; NaN leaves a joint as it is, 0 seconds is as fast as limits allow."""
        service = await self._control(self._module("CM-ARM"), "ModularArm")
        if any(map(math.isnan, positions)):
            targets = (await self.arm()).targets
            positions = [b if math.isnan(a) else a for a, b in zip(positions, targets, strict=True)]
        rows = [MoveModularArm.JointPositionRec(float(each)) for each in positions]
        await service.send(MoveModularArm(MoveModularArm.MotionDurationRec(duration), rows), ack=True)

    async def move_arm(self, positions: Sequence[float], duration: float = 0.0) -> None:
        """Move the modular arm, and wait until it is there; raises `MotionFailed` if it does not arrive."""
        await self.command_arm(positions, duration)
        until = self.now() + max(duration, 1.0) * 3.0 + 5.0
        await asyncio.sleep(max(0.1, duration))
        while True:
            state = await self.arm()
            if state.error:
                raise MotionFailed(f"the modular arm refused to move: {state.error}")
            if not state.moving:
                return
            if self.now() > until:
                off = max(abs(a - b) for a, b in zip(state.targets, state.positions, strict=True))
                raise MotionFailed(f"the modular arm still moves, {off:.3f} rad off its target; is it blocked?")
            await asyncio.sleep(0.05)

    async def choose_controller(self, controller: ArmController) -> None:
        """Choose how the joints of the modular arm follow."""
        service = await self._control(self._module("CM-ARM"), "ModularArm")
        kinds = SetModularArmController.Controller
        kind = kinds.INVERSE_DYNAMICS if controller is ArmController.MODEL else kinds.INDEPENDENT_PID
        await service.send(SetModularArmController(kind), ack=True)

    # --- components -----------------------------------------------------------------------------------------------

    async def control_module(self, type: str, part: str, service: str) -> ServiceClient:
        """A service of a module of the cell, under control and Ready; waits until the module has appeared."""
        return await self._control(self._module(type, part), service)

    def _module(self, type: str, part: str | None = None) -> JausID:
        for module in self._config.modules:
            if module.type == type and module.part in (part, module.part if part is None else part):
                return self._config.id_of(module)
        raise ConfigError(f"{self._config.name} has no {type}{f' of {part}' if part else ''}")

    def _connector(self, name: str) -> tuple[JausID, int]:
        """Component and number of a connector."""
        if name == GRIPPER:
            return self._module("CM-CON", GRIPPER), 1
        part, _, connector = name.partition("/")
        type = self.layout.type_of(part)
        if connector not in type.connectors:
            raise ConfigError(f"{part} has no connector {connector!r}; it has: {', '.join(type.connectors) or 'none'}")
        kind = "CM-SRV" if type.servo is not None else "CM-CON"
        return self._module(kind, part), 1 + list(type.connectors).index(connector)

    async def _service(self, id: JausID, name: str) -> ServiceClient:
        """The client of a service; waits until its component has appeared."""
        if (found := self._services.get((id, name))) is not None:
            return found
        until = self.now() + APPEAR_TIME
        while True:
            assert self._robot is not None
            if any(each.id == id for each in self._robot.components):
                service = self._robot.component(str(id)).service(name)
                self._services[id, name] = service
                return service
            if self.now() > until:
                raise RequestError(f"component {id} has not appeared within {APPEAR_TIME:g} s; has it power?")
            self._robot = await self._ocu.discover(self._config.subsystem)

    async def _control(self, id: JausID, name: str) -> ServiceClient:
        """As `_service`; the component is under control of this client, and Ready."""
        service = await self._service(id, name)
        async with self._locks[id]:
            if id not in self._controlled:
                await self._stack.enter_async_context(service.control(AUTHORITY))
                await service.resume()
                self._controlled[id] = service
        return service

    # --- watching -------------------------------------------------------------------------------------------------

    async def _watch(self) -> None:
        """Keep the last observations of each part since it last moved."""
        sensor = await self._service(self._module("CM-PRT"), "PartSensor")
        last = -math.inf
        while True:
            try:
                report: ReportPartObservations = await sensor.query(QueryPartObservations())
            except JausError:
                self.counts["observations_lost"] += 1
            else:
                time = report.observation_time_rec.time
                if time > last:
                    last = time
                    self._offset = min(self._offset, self.now() - time)
                    self._add(report.part_list, time)
            await asyncio.sleep(WATCH_PERIOD)

    def _add(self, rows: Sequence[Any], time: float) -> None:
        for row in rows:
            quaternion = (row.orientation_w, row.orientation_x, row.orientation_y, row.orientation_z)
            rotation = np.array(rotation_from_quaternion(*quaternion))
            pose = pin.SE3(rotation, np.array([row.x, row.y, row.z]))
            self._latest[row.name] = time, pose
            seen = self._seen.setdefault(row.name, deque(maxlen=SAMPLES))
            if seen:
                distance, angle = offset_between(seen[-1], pose)
                if distance > MOVED or angle > 10.0 * MOVED:
                    seen.clear()
            seen.append(pose)
        self._last_seen = {row.name: row.type for row in rows}
        for name in set(self._seen) - set(self._last_seen):
            del self._seen[name]
        self._observed.set()


def _offset(report: ReportConnectorState) -> tuple[float | None, ...]:
    return (
        report.offset_x,
        report.offset_y,
        report.offset_z,
        report.offset_roll,
        report.offset_pitch,
        report.offset_yaw,
    )


async def _cancel(task: asyncio.Task[None]) -> None:
    task.cancel()
    await asyncio.wait({task})
