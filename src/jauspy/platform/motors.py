"""Electric motors of joints and tracks: the power and the current that they take, and what they report."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from jauspy.geometry.urdf import Joint
from jauspy.platform.battery import BatterySetup, BatteryState
from jauspy.platform.contract import OptionalPart, PartId, RobotLink


@dataclass(frozen=True, slots=True)
class MotorReading:
    """Electrical data of one motor; None for what is not measured."""

    temperature: float | None = None
    """Degrees Celsius."""
    voltage: float | None = None
    """Volts of its supply."""
    current: float | None = None
    """Amperes from its supply."""
    phase_current: float | None = None
    """Amperes in its windings."""


class Motors(OptionalPart):
    """The electrical data of a robot's motors."""

    @property
    def id(self) -> PartId:
        """The part id; one part has the data of all motors."""
        return PartId(Motors)

    @abstractmethod
    def state(self) -> Mapping[str, MotorReading]:
        """The last readings, by the name of the joint that the motor moves."""

    def proxy(self, link: RobotLink) -> Motors:
        """The readings for other threads."""
        return _MotorsProxy(link)


class _MotorsProxy(Motors):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> Mapping[str, MotorReading]:
        found = self._link.snapshot.parts[self.id]
        assert isinstance(found, Mapping)
        return found


class MotorLoad(NamedTuple):
    """Effort and speed of a motor now: N m and rad/s, or N and m/s, at the joint."""

    joint: str
    effort: float
    velocity: float


class MotorModel:
    """A motor with permanent magnets, whose current is proportional to its effort.

    At the greatest effort and speed of the joint its efficiency is that of the setup. What it loses there are losses
    of its windings, which grow with the square of the current, so that holding a load takes power, too. A motor that
    brakes gives nothing back. It reaches the greatest speed at the nominal voltage of the battery.
    """

    def __init__(self, joint: Joint, setup: BatterySetup) -> None:
        greatest = joint.effort * joint.velocity
        self._loss = greatest * (1.0 / setup.efficiency - 1.0) / joint.effort**2 if joint.effort > 0.0 else 0.0
        self._current = joint.velocity / setup.nominal_voltage

    def power(self, effort: float, velocity: float) -> float:
        """Watts that it takes."""
        return max(0.0, effort * velocity + self._loss * effort * effort)

    def phase_current(self, effort: float) -> float:
        """Amperes in its windings."""
        return abs(effort) * self._current


class SimulatedMotors(Motors):
    """Readings of simulated motors by `MotorModel`; their temperature is not known."""

    def __init__(
        self,
        joints: Iterable[Joint],
        setup: BatterySetup,
        loads: Callable[[], Iterable[MotorLoad]],
        battery: Callable[[], BatteryState],
    ) -> None:
        self._models = {joint.name: MotorModel(joint, setup) for joint in joints}
        self._loads = loads
        self._battery = battery
        self._readings: Mapping[str, MotorReading] = {}

    def state(self) -> Mapping[str, MotorReading]:
        """The readings of the last measurement."""
        return self._readings

    def measure(self) -> float:
        """Measure all motors; returns the watts that they take together."""
        voltage, total, readings = self._battery().voltage, 0.0, {}
        for load in self._loads():
            model = self._models[load.joint]
            power = model.power(load.effort, load.velocity)
            total += power
            current = power / voltage if voltage else 0.0
            readings[load.joint] = MotorReading(None, voltage, current, model.phase_current(load.effort))
        self._readings = readings
        return total

    def switch_off(self) -> None:
        """Report motors without supply."""
        self._readings = {name: MotorReading(None, 0.0, 0.0, 0.0) for name in self._models}
