"""The modules of a factory cell (`urn:jauspy:cell`): modular arms, vacuum connectors, servos, the belt, parts."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the arm is

from __future__ import annotations

import asyncio
import math
import secrets
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from jauspy.arguments import check_number
from jauspy.errors import ConfigError, RequestError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import rotation_from_quaternion
from jauspy.messages.cell.v1_0 import (
    HoldModularArm,
    QueryConnectorState,
    QueryConveyorState,
    QueryModularArmMotionResult,
    QueryModularArmState,
    QueryModuleEnergy,
    QueryModulePower,
    QueryPartObservations,
    QueryServoState,
    ReportModularArmMotionResult,
    ReportModulePower,
    ReportServoState,
    ScheduleConnector,
    SetConnector,
    SetConveyorSpeed,
    SetModularArmController,
    SetModulePower,
)
from jauspy.ocu.service import ServiceClient
from jauspy.platform.battery import BatteryState
from jauspy.platform.modular.arm import ArmController, ModularArmState, MotionResult, TrajectoryPoint
from jauspy.platform.modular.cell import Consumption, ConveyorState, PowerState
from jauspy.platform.modular.connector import ConnectorError, ConnectorState
from jauspy.services.cell.modular_arm import trajectory_command
from jauspy.services.cell.vacuum_connector import LONGEST_DELAY

ALL_FIELDS: Final = 0xFFFFFFFF
POLL_INTERVAL: Final = 0.05
"""Seconds between two queries for the result of a motion that is about to end."""
MOTION_INTERVAL: Final = 0.25
"""Seconds between two of them before, and so the longest after which a motion that has ended early is known."""
MAX_NUMBER: Final = 0xFFFF_FFFF
"""The largest number of a motion that fits the message."""
SLACK: Final = (3.0, 5.0)
"""Factor of the duration and seconds on top of it in which a motion must end, unless another time-out is given."""

_ERRORS: Final = dict(enumerate(ConnectorError))
"""Reasons by their number in the message, whose order is the same."""

_ENDINGS: Final[Mapping[MotionResult, str]] = {
    MotionResult.REFUSED: "the modular arm refused to move",
    MotionResult.STOPPED: "the modular arm was stopped",
    MotionResult.REPLACED: "the modular arm was moved elsewhere",
    MotionResult.FAILED: "the modular arm did not complete the motion",
}


class MotionRefused(RequestError):
    """A motion that an arm has not begun; the message has the reason."""


class ModularArm:
    """An arm of any number of servo modules, which the robot finds by what is attached. Radians, base to tip."""

    def __init__(self, service: ServiceClient) -> None:
        self._service = service

    def __repr__(self) -> str:
        return f"<modular arm {self._service.id}>"

    async def state(self) -> ModularArmState:
        """Joints and motion; without `base`, `tip` and `parts`, which are in its specification."""
        report = await self._service.query(QueryModularArmState())
        motion, joints = report.modular_arm_motion_rec, report.joint_list
        orientation = (
            motion.tip_orientation_w,
            motion.tip_orientation_x,
            motion.tip_orientation_y,
            motion.tip_orientation_z,
        )
        tip = Transform(rotation_from_quaternion(*orientation), (motion.tip_x, motion.tip_y, motion.tip_z))
        return ModularArmState(
            joints=tuple(joint.name for joint in joints),
            positions=tuple(joint.position for joint in joints),
            velocities=tuple(joint.velocity for joint in joints),
            efforts=tuple(joint.effort for joint in joints),
            targets=tuple(joint.target for joint in joints),
            moving=bool(motion.moving),
            controller=ArmController.MODEL if motion.controller else ArmController.PID,
            payload=motion.payload,
            tip_pose=tip.to_pose(),
            error=motion.error,
        )

    async def begin(self, positions: Sequence[float], duration: float = 0.0) -> int:
        """Begin a motion to these positions that takes `duration` seconds; NaN leaves a joint where it is told to be.

        With 0 seconds it is as fast as the joints' limits allow. Returns the number of the motion, by which `result()`
        tells how it ended.
        """
        check_number(duration, "duration")
        for number, position in enumerate(positions, 1):
            check_number(position, f"joint {number}")
        if not any(map(math.isnan, positions)):
            return await self._send((), [TrajectoryPoint(float(duration), tuple(map(float, positions)))])
        joints = (await self.state()).joints
        if len(joints) != len(positions):
            raise RequestError(f"{len(positions)} positions for {len(joints)} joints ({', '.join(joints)})")
        named = {name: float(at) for name, at in zip(joints, positions, strict=True) if not math.isnan(at)}
        return await self._send(tuple(named), [TrajectoryPoint(float(duration), tuple(named.values()))])

    async def move(
        self, positions: Sequence[float], duration: float = 0.0, *, timeout: float | None = None
    ) -> ModularArmState:
        """Begin a motion as `begin` does, and wait until the joints have arrived; returns the state.

        Raises `RequestError` with the arm's reason when it refuses the motion or ends it early, or when it has not
        ended it after `timeout` seconds: by default three times the duration, and at least 8 s.
        """
        check_number(timeout, "timeout", optional=True)
        return await self._arrive(await self.begin(positions, duration), duration, timeout)

    async def follow(
        self, joints: Sequence[str], points: Sequence[TrajectoryPoint], *, timeout: float | None = None
    ) -> ModularArmState:
        """Move joints, by names, through points at given times, to rest at the last one; the others stay.

        Waits, and raises `RequestError`, as `move` does: a motion that exceeds a limit is refused with joint, time and
        figure before it begins. Velocities that are left out are those with which the acceleration is continuous.
        """
        check_number(timeout, "timeout", optional=True)
        for number, point in enumerate(points, 1):
            check_number(point.time, f"time of point {number}")
            for values in (
                point.positions,
                point.velocities or point.positions,
                point.accelerations or point.positions,
            ):
                if len(values) != len(joints):
                    raise ConfigError(f"point {number} has {len(values)} values for {len(joints)} joints")
        duration = points[-1].time if points else 0.0
        return await self._arrive(await self._send(joints, points), duration, timeout)

    async def result(self, number: int = 0) -> tuple[MotionResult, str]:
        """How a motion ended, and the reason if it was refused or ended early; 0 is the last motion of any client."""
        check_number(number, "number", whole=True)
        report = await self._service.query(QueryModularArmMotionResult(number))
        try:
            return MotionResult[ReportModularArmMotionResult.Result(report.result).name], report.reason
        except ValueError:
            return MotionResult.UNKNOWN, f"the arm reports the result {report.result}, which this version does not know"

    async def _send(self, joints: Sequence[str], points: Sequence[TrajectoryPoint]) -> int:
        """Send a trajectory with a number of its own, which differs from those of other programs by chance."""
        number = secrets.randbelow(MAX_NUMBER) + 1
        await self._service.send(trajectory_command(joints, points, number), ack=True)
        return number

    async def _arrive(self, number: int, duration: float, timeout: float | None) -> ModularArmState:
        """Wait until a motion has ended; returns the state."""
        clock = asyncio.get_running_loop().time
        begun = clock()
        end = begun + (max(duration, 1.0) * SLACK[0] + SLACK[1] if timeout is None else timeout)
        wait = 2.0 * POLL_INTERVAL
        while True:
            await asyncio.sleep(wait)
            result, reason = await self.result(number)
            if result is MotionResult.REACHED:
                return await self.state()
            if result is not MotionResult.IN_PROGRESS:
                if result is MotionResult.BLOCKED:
                    raise RequestError(reason)  # says so
                kind = MotionRefused if result is MotionResult.REFUSED else RequestError
                raise kind(f"{_ENDINGS.get(result, 'the modular arm did not take the motion')}: {reason}")
            if clock() > end:
                state = await self.state()
                off = max((abs(a - b) for a, b in zip(state.targets, state.positions, strict=True)), default=0.0)
                raise RequestError(f"the modular arm still moves, {off:.3f} rad off its target")
            wait = min(MOTION_INTERVAL, max(POLL_INTERVAL, begun + duration - clock()))

    async def stop(self) -> None:
        """Brake along the present path, and hold."""
        await self._service.send(HoldModularArm(), ack=True)

    async def set_controller(self, controller: ArmController) -> None:
        """Select how the joints follow: a PID controller each, or the model of the arm as it is assembled."""
        kinds = SetModularArmController.Controller
        kind = kinds.INVERSE_DYNAMICS if controller is ArmController.MODEL else kinds.INDEPENDENT_PID
        await self._service.send(SetModularArmController(kind), ack=True)


class Connector:
    """A vacuum connector of a part, or a vacuum gripper."""

    def __init__(self, service: ServiceClient, number: int) -> None:
        self.number: int = number
        """Number of the connector among those of the part, from 1."""
        self._service = service

    def __repr__(self) -> str:
        return f"<connector {self.number} of {self._service.id}>"

    async def state(self) -> ConnectorState:
        """The part that it holds, and the force; `last_error` says why it holds nothing."""
        report = await self._service.query(QueryConnectorState(ALL_FIELDS, self.number))
        offset = (
            report.offset_x,
            report.offset_y,
            report.offset_z,
            report.offset_roll,
            report.offset_pitch,
            report.offset_yaw,
        )
        return ConnectorState(
            powered=True,  # one whose module has no power reports nothing
            enabled=bool(report.enabled),
            attached_to=report.attached_to or "",
            offset=Transform.from_pose(Pose(*(value or 0.0 for value in offset))),
            force=report.force or 0.0,
            moment=report.moment or 0.0,
            mass=report.load_mass or 0.0,
            mass_deviation=math.inf if report.load_mass_deviation is None else report.load_mass_deviation,
            utilisation=report.utilisation or 0.0,
            vacuum=report.vacuum or 0.0,
            latched=bool(report.latched),
            broken_off=report.broken_off or 0,
            error=_ERRORS.get(report.error or 0, ConnectorError.OTHER),
            last_error=report.error_text or "",
        )

    async def enable(self, *, after: float = 0.0) -> None:
        """Start the pump: it attaches what touches it; after so many seconds (0..60) by the robot's clock.

        The next command takes the place of one that still waits. The robot cancels it when its client loses control.
        """
        await self._set(SetConnector.Enabled.ENABLED, after)

    async def disable(self, *, after: float = 0.0) -> None:
        """Let air in: it releases what it holds; after so many seconds, as `enable`.

        Sent together with a motion, the release is as exact as the robot's control cycle, whatever the network does.
        """
        await self._set(SetConnector.Enabled.DISABLED, after)

    async def _set(self, enabled: SetConnector.Enabled, after: float) -> None:
        check_number(after, "after")
        if not 0.0 <= after <= LONGEST_DELAY:
            raise ConfigError(f"after={after:g} is outside 0..{LONGEST_DELAY:g} s")
        command = SetConnector(self.number, enabled)
        later = ScheduleConnector(self.number, ScheduleConnector.Enabled(enabled), after)
        await self._service.send(later if after else command, ack=True)


class ServoModule:
    """A servo module, which moves a joint of a modular arm, or a wheel."""

    def __init__(self, service: ServiceClient) -> None:
        self._service = service

    def __repr__(self) -> str:
        return f"<servo {self._service.id}>"

    async def state(self) -> ReportServoState:
        """All that it measures: position, velocity, torque, temperature, orientation and rates of its housing."""
        return await self._service.query(QueryServoState(ALL_FIELDS), expects=ReportServoState)


class Conveyor:
    """A belt."""

    def __init__(self, service: ServiceClient) -> None:
        self._service = service

    def __repr__(self) -> str:
        return f"<conveyor {self._service.id}>"

    async def state(self) -> ConveyorState:
        """Speed in m/s, and the distance travelled in metres."""
        report = await self._service.query(QueryConveyorState(0xFF))
        return ConveyorState(report.speed or 0.0, report.position or 0.0)

    async def run(self, speed: float) -> None:
        """Run at this speed, in m/s; negative is backward, and zero brakes gently."""
        check_number(speed, "speed")
        await self._service.send(SetConveyorSpeed(float(speed)), ack=True)


@dataclass(frozen=True, slots=True)
class PartObservation:
    """The parts that the sensor has seen; `time` in seconds of the robot's time."""

    time: float
    types: Mapping[str, str]
    """The type of each part, by name."""
    poses: Mapping[str, Transform]
    """The frame of each part in the world."""


class PartStation:
    """The sensor of parts, and the switches and meters of modules' power."""

    def __init__(self, sensor: ServiceClient, power: ServiceClient) -> None:
        self._sensor = sensor
        self._power = power

    def __repr__(self) -> str:
        return f"<part station {self._sensor.id}>"

    async def observe(self) -> PartObservation:
        """The last observation."""
        report = await self._sensor.query(QueryPartObservations())
        rows = report.part_list
        types, poses = {row.name: row.type for row in rows}, {row.name: _frame(row) for row in rows}
        return PartObservation(report.observation_time_rec.time, types, poses)

    async def switch(self, modules: Sequence[str], *, on: bool) -> None:
        """Switch the power of modules on or off, by their names."""
        record = SetModulePower.ModulePowerRec
        await self._power.send(SetModulePower([record(name, int(on)) for name in modules]), ack=True)

    async def energy(self) -> PowerState:
        """What each module draws and has drawn since the start, what batteries have left, and what is switched on."""
        switches = await self._power.query(QueryModulePower())
        report = await self._power.query(QueryModuleEnergy())
        return PowerState(
            {row.name: row.power == ReportModulePower.Power.SWITCHED_ON for row in switches.module_list},
            {row.name: Consumption(row.power, row.energy) for row in report.module_list},
            {
                row.name: BatteryState(row.charge / 100.0, row.energy, row.voltage, row.current)
                for row in report.battery_list
            },
        )


def _frame(row: Any) -> Transform:
    orientation = row.orientation_w, row.orientation_x, row.orientation_y, row.orientation_z
    return Transform(rotation_from_quaternion(*orientation), (row.x, row.y, row.z))
