"""Batteries: their data, how they discharge, and the battery that supplies a whole robot.

See docs/adr/0186-batteries-health-and-stability.md.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Final

from annotated_types import Interval

from jauspy.platform.contract import OptionalPart, PartId, RobotLink
from jauspy.platform.ranging import Sampling
from jauspy.platform.tables import Table

JOULES: Final = 3600.0
"""Joules of a watt hour."""
RATE: Final = 50.0
"""Hertz at which the power that a simulated robot takes is measured."""


@dataclass(frozen=True, slots=True)
class BatteryData(Table):
    """A battery, whose open-circuit voltage falls in a straight line with its charge."""

    capacity: Annotated[float, Interval(gt=0.0, le=1e6)]
    """Watt hours of a full battery."""
    full_voltage: Annotated[float, Interval(gt=0.0, le=1000.0)]
    """Volts without load, fully charged."""
    empty_voltage: Annotated[float, Interval(gt=0.0, le=1000.0)]
    """Volts at which its protection cuts the load off."""
    resistance: Annotated[float, Interval(ge=0.0, le=10.0)] = 0.0
    """Ohms inside; its losses are taken from the charge."""
    charge: Annotated[float, Interval(ge=0.0, le=1.0)] = 1.0
    """Fraction of the capacity at the start."""

    def __post_init__(self) -> None:
        if self.empty_voltage > self.full_voltage:
            raise ValueError("empty_voltage: must not be above full_voltage")

    @property
    def energy(self) -> float:
        """Joules of a full battery."""
        return self.capacity * JOULES

    @property
    def nominal_voltage(self) -> float:
        """Volts without load at half of the charge."""
        return (self.full_voltage + self.empty_voltage) / 2.0


@dataclass(frozen=True, slots=True)
class BatterySetup(BatteryData):
    """The battery of a robot, and what takes power from it besides its motors: the table `[battery]`."""

    base_load: Annotated[float, Interval(ge=0.0, le=1e5)] = 0.0
    """Watts of computers, radio and sensors, as long as the robot is on."""
    camera_load: Annotated[float, Interval(ge=0.0, le=1e4)] = 0.0
    """Watts of each camera on the robot."""
    lamp_efficacy: Annotated[float, Interval(ge=1.0, le=683.0)] = 100.0
    """Lumens that lamps give for a watt: about 100 of LEDs."""
    efficiency: Annotated[float, Interval(ge=0.05, le=1.0)] = 0.7
    """Efficiency of a motor with its drive and gear, at its greatest effort and speed (`MotorModel`)."""
    warning: Annotated[float, Interval(ge=0.0, le=1.0)] = 0.2
    """Fraction of the capacity below which the operator is warned."""
    reserve: Annotated[float, Interval(ge=0.0, le=1.0)] = 0.05
    """Fraction of the capacity that is kept for computers and radio: below, the motors get no power."""

    def __post_init__(self) -> None:
        super(BatterySetup, self).__post_init__()  # with slots, super() would mean the class before it had them
        if self.reserve > self.warning:
            raise ValueError("reserve: must not be above warning, which is to come first")


@dataclass(frozen=True, slots=True)
class BatteryState:
    """A battery at one moment."""

    charge: float = 1.0
    """Fraction of its capacity."""
    energy: float = 0.0
    """Joules that are left."""
    voltage: float = 0.0
    """Volts at its terminals."""
    current: float = 0.0
    """Amperes that it delivers."""

    @property
    def power(self) -> float:
        """Watts that it delivers."""
        return self.voltage * self.current


class BatteryCharge:
    """The charge of one battery; `power` in watts at its terminals."""

    def __init__(self, data: BatteryData) -> None:
        self.data = data
        self.energy = data.energy * data.charge
        """Joules that are left."""
        self._power = 0.0

    @property
    def empty(self) -> bool:
        """True if its protection has cut it off."""
        return self.energy <= 0.0

    def drain(self, power: float, dt: float) -> None:
        """Deliver a power for some seconds; the loss of its resistance is taken from the charge, too."""
        current = self._current(power)
        self.energy = max(0.0, self.energy - (power + self.data.resistance * current * current) * dt)
        self._power = power

    def state(self) -> BatteryState:
        """Charge, and voltage and current at the last power."""
        if self.empty:
            return BatteryState(0.0, 0.0, 0.0, 0.0)
        current = self._current(self._power)
        voltage = max(0.0, self._open_voltage() - self.data.resistance * current)
        return BatteryState(self.energy / self.data.energy, self.energy, voltage, current)

    def _open_voltage(self) -> float:
        data = self.data
        return data.empty_voltage + (data.full_voltage - data.empty_voltage) * self.energy / data.energy

    def _current(self, power: float) -> float:
        """Amperes at a power, by the voltage without load: the resistance drops a few percent of it at most."""
        return power / self._open_voltage()


class Battery(OptionalPart):
    """The battery that supplies a robot."""

    def __init__(self, setup: BatterySetup) -> None:
        self.setup = setup

    @property
    def id(self) -> PartId:
        """The part id; a robot has at most one such battery."""
        return PartId(Battery)

    @abstractmethod
    def state(self) -> BatteryState:
        """Charge, voltage and current."""

    @property
    def is_low(self) -> bool:
        """True if the operator should drive home."""
        return self.state().charge < self.setup.warning

    @property
    def cuts_motors(self) -> bool:
        """True if only the reserve is left: the motors get no power."""
        state = self.state()
        return state.charge < self.setup.reserve or state.energy <= 0.0

    @property
    def time_left(self) -> float:
        """Seconds until the motors get no power, at the present power; infinite while it delivers none."""
        state = self.state()
        left = max(0.0, state.energy - self.setup.reserve * self.setup.energy)
        return left / state.power if state.power > 0.0 else math.inf

    @property
    def problem(self) -> str:
        """Why the operator should act, as a sentence; empty if there is no need."""
        reserve = f"{100.0 * self.setup.reserve:.0f} %"
        if self.cuts_motors:
            return (
                f"the battery keeps its last {reserve} for computers and radio: the motors get no power; charge it or "
                "change it"
            )
        if not self.is_low:
            return ""
        left, charge = self.time_left, f"the battery has {100.0 * self.state().charge:.0f} % of its charge left"
        minutes = f", {left / 60.0:.0f} min at the present power" if math.isfinite(left) else ""
        return f"{charge}{minutes}; at {reserve} the motors stop: bring the robot back"

    def proxy(self, link: RobotLink) -> Battery:
        """The battery for other threads."""
        return _BatteryProxy(self.setup, link)


class _BatteryProxy(Battery):
    def __init__(self, setup: BatterySetup, link: RobotLink) -> None:
        super().__init__(setup)
        self._link = link

    def state(self) -> BatteryState:
        found = self._link.snapshot.parts[self.id]
        assert isinstance(found, BatteryState)
        return found


class SimulatedBattery(Battery):
    """The battery of a simulated robot; motors are only counted while it supplies them.

    `loads` and `motors`: watts that lamps and cameras, and that the motors take now. `cut` is called when the motors
    get no power any more.
    """

    def __init__(
        self,
        setup: BatterySetup,
        *,
        loads: Callable[[], float],
        motors: Callable[[], float],
        cut: Callable[[], None],
        rate: float = RATE,
    ) -> None:
        super().__init__(setup)
        self._charge = BatteryCharge(setup)
        self._loads, self._motors, self._cut = loads, motors, cut
        self._sampling = Sampling(rate)
        self._measured_at: float | None = None
        self._has_cut = False
        self._state = self._charge.state()

    def state(self) -> BatteryState:
        """Charge, and voltage and current as last measured."""
        return self._state

    def step(self, now: float) -> None:
        """Discharge by what was taken since the last measurement; `now` in seconds of the robot's time."""
        if not self._sampling.is_due(now):
            return
        before, self._measured_at = self._measured_at, now
        supplied = not self.cuts_motors
        if supplied:
            self._has_cut = False
        elif not self._has_cut:
            self._has_cut = True
            self._cut()
        power = self.setup.base_load + self._loads() + (self._motors() if supplied else 0.0)
        self._charge.drain(power, 0.0 if before is None else now - before)
        self._state = self._charge.state()
