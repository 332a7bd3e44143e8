"""The modules of a factory cell (`urn:jauspy:cell`): modular arms, vacuum connectors, servos, the belt, parts."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the arm is

from __future__ import annotations

import asyncio
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from jauspy.arguments import check_number
from jauspy.errors import RequestError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import rotation_from_quaternion
from jauspy.messages.cell.v1_0 import (
    HoldModularArm,
    MoveModularArm,
    QueryConnectorState,
    QueryConveyorState,
    QueryModularArmState,
    QueryModuleEnergy,
    QueryModulePower,
    QueryPartObservations,
    QueryServoState,
    ReportModulePower,
    ReportServoState,
    SetConnector,
    SetConveyorSpeed,
    SetModularArmController,
    SetModulePower,
)
from jauspy.ocu.service import ServiceClient
from jauspy.platform.modular.arm import ArmController, ModularArmState
from jauspy.platform.modular.cell import BatteryState, Consumption, ConveyorState, PowerState
from jauspy.platform.modular.connector import ConnectorState

ALL_FIELDS: Final = 0xFFFFFFFF
POLL_INTERVAL: Final = 0.05
"""Seconds between two queries for the state of an arm that moves."""
ELSEWHERE: Final = 0.02
"""Radians off its goal at which a joint with another target has not arrived."""
SLACK: Final = (3.0, 5.0)
"""Factor of the duration and seconds on top of it in which a motion must end, unless another time-out is given."""


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

    async def begin(self, positions: Sequence[float], duration: float = 0.0) -> None:
        """Begin a motion to these positions that takes `duration` seconds; NaN leaves a joint where it is told to be.

        With 0 seconds it is as fast as the joints' limits allow. `state().error` says why the robot refused it.
        """
        check_number(duration, "duration")
        for number, position in enumerate(positions, 1):
            check_number(position, f"joint {number}")
        rows = [
            MoveModularArm.JointPositionRec(None if math.isnan(position) else float(position)) for position in positions
        ]
        await self._service.send(MoveModularArm(MoveModularArm.MotionDurationRec(float(duration)), rows), ack=True)

    async def move(
        self, positions: Sequence[float], duration: float = 0.0, *, timeout: float | None = None
    ) -> ModularArmState:
        """Begin a motion as `begin` does, and wait until the joints have arrived; returns the state.

        Raises `RequestError` when the robot refuses the motion, when the arm was stopped or told to move elsewhere, or
        when it has not ended the motion after `timeout` seconds: by default
        three times the duration, and at least 8 s.
        """
        check_number(timeout, "timeout", optional=True)
        clock = asyncio.get_running_loop().time
        await self.begin(positions, duration)
        end = clock() + (max(duration, 1.0) * SLACK[0] + SLACK[1] if timeout is None else timeout)
        await asyncio.sleep(max(2.0 * POLL_INTERVAL, duration))
        while True:
            state = await self.state()
            if state.error:
                raise RequestError(f"the modular arm refused to move: {state.error}")
            if not state.moving:
                check_arrived(state, positions)
                return state
            if clock() > end:
                off = max(abs(a - b) for a, b in zip(state.targets, state.positions, strict=True))
                raise RequestError(f"the modular arm still moves, {off:.3f} rad off its target; is it blocked?")
            await asyncio.sleep(POLL_INTERVAL)

    async def stop(self) -> None:
        """Brake along the present path, and hold."""
        await self._service.send(HoldModularArm(), ack=True)

    async def set_controller(self, controller: ArmController) -> None:
        """Select how the joints follow: a PID controller each, or the model of the arm as it is assembled."""
        kinds = SetModularArmController.Controller
        kind = kinds.INVERSE_DYNAMICS if controller is ArmController.MODEL else kinds.INDEPENDENT_PID
        await self._service.send(SetModularArmController(kind), ack=True)


def check_arrived(state: ModularArmState, positions: Sequence[float]) -> None:
    """Raise `RequestError` if an arm at rest has other targets than these positions, and is not at them either."""
    if len(state.targets) != len(positions):
        raise RequestError(f"the modular arm has {len(state.targets)} joints now, the motion was for {len(positions)}")
    for name, goal, target, at in zip(state.joints, positions, state.targets, state.positions, strict=True):
        if not math.isnan(goal) and target != goal and abs(at - goal) > ELSEWHERE:
            raise RequestError(
                f"the modular arm was stopped or moved elsewhere: {name} was told to be at {target:.3f} rad after "
                f"it was told to move to {goal:.3f} rad"
            )


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
            broken_off=report.broken_off or 0,
            last_error=report.error_text or "",
        )

    async def enable(self) -> None:
        """Start the pump: it attaches what touches it."""
        await self._service.send(SetConnector(self.number, SetConnector.Enabled.ENABLED), ack=True)

    async def disable(self) -> None:
        """Let air in: it releases what it holds."""
        await self._service.send(SetConnector(self.number, SetConnector.Enabled.DISABLED), ack=True)


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
