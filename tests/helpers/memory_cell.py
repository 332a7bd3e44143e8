"""A factory cell without physics: servo modules reach their targets at once, connectors attach what the test says."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from jauspy.backends.kinematic import KinematicJoints
from jauspy.geometry.poses import ORIGIN, Pose, Twist
from jauspy.platform.battery import BatteryState
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import FixedBase
from jauspy.platform.joints import ControlMode, Gains, Target
from jauspy.platform.modular.arm import (
    CHANGED,
    ArmController,
    ArmMotion,
    ModularArm,
    ModularArmState,
    MotionResult,
)
from jauspy.platform.modular.cell import (
    Car,
    CarState,
    Consumption,
    Conveyor,
    ConveyorState,
    ModulePower,
    Observation,
    ObservedPart,
    PartSensor,
    PowerState,
)
from jauspy.platform.modular.connector import ConnectorError, ConnectorState, VacuumConnector
from jauspy.platform.modular.graph import attachments, find_chain
from jauspy.platform.modular.parts import CellSetup, PartKind, PartType
from jauspy.platform.modular.servo import ServoModule, ServoState


@dataclass
class MemoryServo(ServoModule):
    """Turns at most at its largest speed."""

    name: str
    type: PartType
    current: ServoState = field(default_factory=ServoState)
    target: Target | None = None
    feed_forward: float = 0.0
    holds: int = 0

    def __post_init__(self) -> None:
        self._gains = self.type.servo.position_gains, self.type.servo.velocity_gains

    def state(self) -> ServoState:
        return self.current

    def command(self, target: Target, feed_forward: float = 0.0) -> None:
        self.target, self.feed_forward = target, feed_forward

    def hold(self) -> None:
        self.holds += 1
        self.target = None

    def set_gains(self, position: Gains, velocity: Gains) -> None:
        self._gains = position, velocity

    def gains(self) -> tuple[Gains, Gains]:
        return self._gains

    def step(self, dt: float) -> None:
        fastest = self.type.servo.max_speed
        speed = torque = 0.0
        if self.current.powered and self.target is not None:
            match self.target.mode:
                case ControlMode.POSITION:
                    speed = min(fastest, max(-fastest, (self.target.value - self.current.position) / dt))
                case ControlMode.VELOCITY:
                    speed = min(fastest, max(-fastest, self.target.value))
                case ControlMode.EFFORT:
                    torque = self.target.value
        self.current = replace(
            self.current, position=self.current.position + speed * dt, velocity=speed, torque=torque + self.feed_forward
        )


@dataclass
class MemoryConnector(VacuumConnector):
    """Attaches what touches it as soon as it is enabled."""

    name: str
    current: ConnectorState = field(default_factory=ConnectorState)
    touches: str = ""
    scheduled: tuple[bool, float] | None = None

    def state(self) -> ConnectorState:
        return self.current

    def set(self, enabled: bool) -> None:
        self.scheduled = None
        holds = self.touches if enabled else ""
        error = ConnectorError.NO_CONTACT if enabled and not holds else ConnectorError.NONE
        text = "nothing touches the plate" if enabled and not holds else ""
        self.current = replace(self.current, enabled=enabled, attached_to=holds, error=error, last_error=text)

    def schedule(self, enabled: bool, delay: float) -> None:
        self.scheduled = enabled, delay

    def cancel(self) -> None:
        self.scheduled = None

    def break_off(self) -> None:
        self.current = replace(
            self.current,
            attached_to="",
            broken_off=self.current.broken_off + 1,
            error=ConnectorError.OVERLOADED,
            last_error="26 N m, and it holds 25",
        )


class MemoryConveyor(Conveyor):
    current = ConveyorState()

    def state(self) -> ConveyorState:
        return self.current

    def set_speed(self, speed: float) -> None:
        self.current = replace(self.current, speed=speed)

    def step(self, dt: float) -> None:
        self.current = replace(self.current, position=self.current.position + self.current.speed * dt)


class MemorySensor(PartSensor):
    def __init__(self, cell: CellSetup) -> None:
        self.seen = tuple(ObservedPart(part.name, part.type, part.pose) for part in cell.parts)
        self.time = 0.0

    def state(self) -> Observation:
        return Observation(self.time, self.seen)


class MemoryPower(ModulePower):
    def __init__(self, names: Sequence[str]) -> None:
        self.switches = dict.fromkeys(names, True)

    def state(self) -> PowerState:
        drawn = {name: Consumption(2.5, 10.0) for name in self.switches}
        return PowerState(dict(self.switches), drawn, {"car": BatteryState(0.5, 1000.0, 36.0, 1.25)})

    def switch(self, name: str, on: bool) -> None:
        if name in self.switches:
            self.switches[name] = on


class MemoryCar(Car):
    def __init__(self) -> None:
        self.current = CarState()
        self.effort = (0.0, 0.0)
        self.stops = 0

    def state(self) -> CarState:
        return self.current

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        self.effort = (linear_x, rotational_z) if self.current.assembled else (0.0, 0.0)

    def stop(self) -> None:
        self.stops += 1
        self.effort = (0.0, 0.0)

    def step(self, dt: float) -> None:
        pose = self.current.pose
        moved = Pose(pose.x + self.effort[0] * dt, pose.y, pose.z, yaw=pose.yaw + self.effort[1] * dt)
        self.current = replace(self.current, pose=moved, twist=Twist(vx=self.effort[0], wz=self.effort[1]))


class MemoryArm(ModularArm):
    """Moves in a straight line in the time that it is given, one second without."""

    def __init__(self, robot: MemoryCell) -> None:
        self.name = "arm"
        self._robot = robot
        self._controller = ArmController.MODEL
        self._order: tuple[str, ...] = ()
        self._error = ""
        self._targets: dict[str, float] = {}
        self._left = 0.0
        self._motion = 0
        self._result = MotionResult.UNKNOWN
        self.holds = 0

    def _joints(self) -> list[str]:
        chain = find_chain(self._robot.cell, self._robot.attached())
        self._chain = chain
        return [name for name in self._order if name in chain.joints] or list(chain.joints)

    def state(self) -> ModularArmState:
        joints = self._joints()
        states = [self._robot.servos[name].current for name in joints]
        return ModularArmState(
            base=self._chain.base,
            tip=self._chain.tip,
            joints=tuple(joints),
            parts=self._chain.parts,
            positions=tuple(each.position for each in states),
            velocities=tuple(each.velocity for each in states),
            efforts=tuple(each.torque for each in states),
            targets=tuple(self._targets.get(name, each.position) for name, each in zip(joints, states, strict=True)),
            moving=self._left > 0.0,
            controller=self._controller,
            tip_pose=ORIGIN,
            motion=self._motion,
            result=self._result,
            error=self._error,
        )

    def begin(self, motion: ArmMotion) -> None:
        self._motion = motion.number
        present = self._joints()
        joints = present if motion.joints is None else list(motion.joints)
        points = motion.points or ()
        if motion.known is not None and list(motion.known) != present:
            self._refuse(CHANGED)
        elif unknown := [name for name in joints if name not in present]:
            self._refuse(f"no joint {unknown[0]}")
        elif not points or any(
            len(point.positions) != len(joints)
            or any(map(math.isinf, point.positions))
            or not 0.0 <= point.time < math.inf
            for point in points
        ):
            self._refuse(f"{[len(point.positions) for point in points]} positions for {len(joints)} joints")
        else:
            self._error, self._result = "", MotionResult.IN_PROGRESS
            rows = zip(joints, points[-1].positions, strict=True)
            self._targets = {name: value for name, value in rows if not math.isnan(value)}
            self._left = points[-1].time or 1.0

    def block(self, reason: str) -> None:
        """Meet something."""
        self._left, self._targets = 0.0, {}
        self._error, self._result = reason, MotionResult.BLOCKED

    def _refuse(self, reason: str) -> None:
        self._left, self._targets = 0.0, {}
        self._error, self._result = f"motion refused: {reason}", MotionResult.REFUSED

    def hold(self) -> None:
        self.holds += 1
        self._left = 0.0
        self._targets = {}
        if self._result is MotionResult.IN_PROGRESS:
            self._result = MotionResult.STOPPED

    def set_controller(self, controller: ArmController) -> None:
        self._controller = controller

    def set_order(self, joints: Sequence[str]) -> None:
        unknown = [name for name in joints if name not in self._robot.servos]
        self._error = f"no servo module {unknown[0]!r}" if unknown else ""
        if not unknown:
            self._order = tuple(joints)

    def step(self, dt: float) -> None:
        joints = self._joints()
        for name, servo in self._robot.servos.items():
            servo.current = replace(servo.current, claimed_by=self.name if name in joints else "")
        if self._left <= 0.0:
            return
        silent = [name for name in self._targets if not self._robot.servos[name].current.powered]
        if silent:
            self._left, self._error = 0.0, f"the motion ended early: no report of {silent[0]}"
            self._result = MotionResult.FAILED
            return
        for name, target in self._targets.items():
            servo = self._robot.servos[name]
            speed = (target - servo.current.position) / max(self._left, dt)
            servo.current = replace(servo.current, position=servo.current.position + speed * dt, velocity=speed)
        self._left -= dt
        if self._left <= 0.0:
            self._result = MotionResult.REACHED


class MemoryCell:
    """A `Robot`. `touch` says what a connector would attach, and `attach` attaches it."""

    def __init__(self, model: RobotModel) -> None:
        assert model.cell is not None
        self.cell = cell = model.cell
        self.drive = FixedBase()
        self.groups = {name: KinematicJoints(model.description, setup) for name, setup in model.groups.items()}
        self.lidars = {}
        self.force_torque = {}
        self.cameras = {}
        self.time = 0.0
        types = {part.name: cell.types[part.type] for part in cell.parts}
        self.servos = {name: MemoryServo(name, type) for name, type in types.items() if type.servo}
        names = [f"{name}/{own}" for name, type in types.items() for own in type.connectors]
        self.connectors = {name: MemoryConnector(name) for name in (*names, *["gripper"] * bool(cell.gripper))}
        self.conveyor, self.sensor, self.car = MemoryConveyor(), MemorySensor(cell), MemoryCar()
        self.power = MemoryPower([name for name, type in types.items() if type.servo or type.connectors])
        self.arm = MemoryArm(self)
        self.bases = [name for name, type in types.items() if type.kind is PartKind.BASE]
        self._follow_power()

    @property
    def optional_parts(self) -> list[OptionalPart]:
        others = [self.conveyor, self.sensor, self.power, self.car, self.arm]
        return [*self.servos.values(), *self.connectors.values(), *others]

    def attached(self):
        return attachments((name, each.current) for name, each in self.connectors.items())

    def attach(self, connector: str, part: str) -> None:
        """Enable a connector that touches this part."""
        self.connectors[connector].touches = part
        self.connectors[connector].set(True)
        self._follow_power()

    def assemble(self, *parts: str, base: str = "platform_1/top") -> None:
        """Attach these parts to each other, and the first to the base."""
        for part in parts:
            self.attach(base, part)
            base = next((name for name in self.connectors if name.startswith(f"{part}/")), "")

    def powered(self) -> set[str]:
        found = {name for name in self.bases if self.power.switches[name]}
        new = list(found)
        while new:
            holder = new.pop()
            for name, connector in self.connectors.items():
                part = connector.current.attached_to
                if name.startswith(f"{holder}/") and part and part not in found:
                    found.add(part)
                    new.append(part)
        return {name for name in found if self.power.switches.get(name, True)}

    def _follow_power(self) -> None:
        powered = self.powered()
        for name, servo in self.servos.items():
            servo.current = replace(servo.current, powered=name in powered, voltage=36.0 * (name in powered))
        for name, connector in self.connectors.items():
            has = name == "gripper" or name.partition("/")[0] in powered
            connector.current = replace(connector.current, powered=has)

    def advance(self, dt: float) -> None:
        self.time += dt
        self.sensor.time = self.time
        self._follow_power()
        for group in self.groups.values():
            group.step(dt)
        for each in (*self.servos.values(), self.conveyor, self.car, self.arm):
            each.step(dt)

    def close(self) -> None:
        self.conveyor.set_speed(0.0)


class MemoryBackend:
    """Remembers the robot that it opened last."""

    name = "memory"

    def __init__(self) -> None:
        self.robot: MemoryCell | None = None

    def open(self, robot: RobotModel, world: str) -> MemoryCell:
        self.robot = MemoryCell(robot)
        return self.robot
