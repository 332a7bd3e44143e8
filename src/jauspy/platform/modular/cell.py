"""Conveyor, part sensor, module power and car of a factory cell: the contract, their states and commands."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from jauspy.geometry.poses import AT_REST, ORIGIN, UNACCELERATED, Acceleration, Pose, Twist
from jauspy.platform.battery import BatteryState
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink


@dataclass(frozen=True, slots=True)
class ConveyorState:
    """Speed of the belt, in m/s, and how far it has travelled, in metres."""

    speed: float = 0.0
    position: float = 0.0


class Conveyor(OptionalPart):
    """A belt with a speed."""

    @property
    def id(self) -> PartId:
        """A cell has at most one."""
        return CONVEYOR

    @abstractmethod
    def state(self) -> ConveyorState:
        """Speed and travel of the belt."""

    @abstractmethod
    def set_speed(self, speed: float) -> None:
        """Run at this speed (m/s), clamped to its limit; negative is backward."""

    def stop(self) -> None:
        """Brake as hard as it can; a speed of zero is approached gently."""
        self.set_speed(0.0)

    def proxy(self, link: RobotLink) -> Conveyor:
        """The conveyor for other threads."""
        return _ConveyorProxy(link)


CONVEYOR: Final = PartId(Conveyor)


@dataclass(frozen=True, slots=True)
class ConveyorSpeed(Command):
    """Run the conveyor at a speed, in m/s; None stops it."""

    speed: float | None
    part: PartId = CONVEYOR

    def apply(self, robot: Robot) -> None:
        """Set the speed."""
        if (conveyor := Conveyor.of(robot)) is None:
            return
        if self.speed is None:
            conveyor.stop()
        else:
            conveyor.set_speed(self.speed)


class _ConveyorProxy(Conveyor):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> ConveyorState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, ConveyorState)
        return state

    def set_speed(self, speed: float) -> None:
        self._link.submit(ConveyorSpeed(speed))

    def stop(self) -> None:
        self._link.submit(ConveyorSpeed(None))


@dataclass(frozen=True, slots=True)
class ObservedPart:
    """An observed part: its name, type, and measured pose of its frame in the world."""

    name: str
    type: str
    pose: Pose


@dataclass(frozen=True, slots=True)
class Observation:
    """The last observation of the part sensor; `time` in seconds of the robot's time."""

    time: float = 0.0
    parts: tuple[ObservedPart, ...] = ()


class PartSensor(OptionalPart):
    """Measures the poses of parts."""

    @property
    def id(self) -> PartId:
        """A cell has at most one."""
        return PartId(PartSensor)

    @abstractmethod
    def state(self) -> Observation:
        """The last observation."""

    def proxy(self, link: RobotLink) -> PartSensor:
        """The sensor for other threads."""
        return _PartSensorProxy(link)


class _PartSensorProxy(PartSensor):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> Observation:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, Observation)
        return state


@dataclass(frozen=True, slots=True)
class Consumption:
    """Electric power that a module draws."""

    power: float = 0.0
    """Watts, averaged over the last period of measurement."""
    energy: float = 0.0
    """Joules since the start."""


@dataclass(frozen=True, slots=True)
class PowerState:
    """Switches, consumption and batteries, each by the name of the part."""

    switches: Mapping[str, bool] = field(default_factory=dict)
    """Modules that are switched on; initially all are."""
    consumption: Mapping[str, Consumption] = field(default_factory=dict)
    """Power and energy of each module that can be switched."""
    batteries: Mapping[str, BatteryState] = field(default_factory=dict)

    @property
    def energy(self) -> float:
        """Joules that all modules have drawn since the start."""
        return sum(module.energy for module in self.consumption.values())


class ModulePower(OptionalPart):
    """Switches and meters of the modules' supplies.

    A module has power if it is switched on and attached to a base that is supplied from the mains, or to a battery that
    is not empty, or is one of these.
    """

    @property
    def id(self) -> PartId:
        """A cell has at most one."""
        return PartId(ModulePower)

    @abstractmethod
    def state(self) -> PowerState:
        """Switches, consumption and batteries."""

    @abstractmethod
    def switch(self, name: str, on: bool) -> None:
        """Switch a module on or off; an unknown name has no effect."""

    def proxy(self, link: RobotLink) -> ModulePower:
        """The switches for other threads."""
        return _ModulePowerProxy(link)


@dataclass(frozen=True, slots=True)
class PowerCommand(Command):
    """Switch a module on or off."""

    name: str
    on: bool

    @property
    def part(self) -> PartId:
        """The switch of this module."""
        return PartId(ModulePower, self.name)

    def apply(self, robot: Robot) -> None:
        """Switch it."""
        if (power := ModulePower.of(robot)) is not None:
            power.switch(self.name, self.on)


class _ModulePowerProxy(ModulePower):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> PowerState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, PowerState)
        return state

    def switch(self, name: str, on: bool) -> None:
        self._link.submit(PowerCommand(name, on))


@dataclass(frozen=True, slots=True)
class CarState:
    """The car: whether it has all its wheels, and its motion."""

    assembled: bool = False
    pose: Pose = ORIGIN
    twist: Twist = AT_REST
    acceleration: Acceleration = UNACCELERATED


class Car(OptionalPart):
    """A base on wheels that servo modules turn: a `DriveBase` once it is assembled."""

    @property
    def id(self) -> PartId:
        """A cell has at most one."""
        return CAR

    @abstractmethod
    def state(self) -> CarState:
        """State of the assembly, and motion of the car."""

    @abstractmethod
    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Drive with fractions of the full effort, -1..1; positive z turns left. Without effect until assembled."""

    @abstractmethod
    def stop(self) -> None:
        """Brake to a standstill and hold it."""

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self.state().pose

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        return self.state().twist

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame."""
        return self.state().acceleration

    def proxy(self, link: RobotLink) -> Car:
        """The car for other threads."""
        return _CarProxy(link)


CAR: Final = PartId(Car)


@dataclass(frozen=True, slots=True)
class CarEffort(Command):
    """Drive the car with fractions of the full effort; None stops it."""

    effort: tuple[float, float] | None
    part: PartId = CAR

    def apply(self, robot: Robot) -> None:
        """Set the effort, or stop."""
        if (car := Car.of(robot)) is None:
            return
        if self.effort is None:
            car.stop()
        else:
            car.set_effort(*self.effort)


class _CarProxy(Car):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> CarState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, CarState)
        return state

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:  # noqa: ARG002 - never
        self._link.submit(CarEffort((linear_x, rotational_z)))

    def stop(self) -> None:
        self._link.submit(CarEffort(None))
