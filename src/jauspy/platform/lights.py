"""The light in a robot's world, and the lamps that a robot has."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Final, TypeAlias

from annotated_types import Interval

from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink, RobotParts
from jauspy.platform.tables import Converted, Table, UrdfName

DAYLIGHT: Final = 20_000.0
"""Illuminance, in lux, that pictures show as 1."""


class TimeOfDay(Enum):
    """Light of the sky; by night there is that of a lit street far away."""

    DAY = "day"
    DUSK = "dusk"
    NIGHT = "night"

    @property
    def sky(self) -> float:
        """The light of the sky as a fraction of daylight: 400 lux at dusk, 4 lux by night."""
        return {TimeOfDay.DAY: 1.0, TimeOfDay.DUSK: 2e-2, TimeOfDay.NIGHT: 2e-4}[self]


class Switch(Enum):
    """The lights that JAUS can switch (AS6091); variable ones have sixteen levels."""

    HEADLIGHTS = "headlights"
    HIGH_BEAMS = "high_beams"
    FOG_LIGHTS = "fog_lights"
    BACKUP_LIGHTS = "backup_lights"
    VISIBLE_LIGHT_SOURCE = "visible_light_source"
    VARIABLE_LIGHT_1 = "variable_light1"
    VARIABLE_LIGHT_2 = "variable_light2"
    VARIABLE_LIGHT_3 = "variable_light3"
    VARIABLE_LIGHT_4 = "variable_light4"

    @property
    def is_variable(self) -> bool:
        """True if it has levels between off and full."""
        return self.value.startswith("variable")


_Coordinate: TypeAlias = Annotated[float, Interval(ge=-10.0, le=10.0)]


@dataclass(frozen=True, slots=True)
class LampSetup(Table):
    """A lamp that shines along the x axis of its link, turned down by `tilt`, in a round cone."""

    name: UrdfName
    link: UrdfName
    switch: Switch
    """The light of JAUS's IlluminationService that switches it."""
    cone: Annotated[float, Interval(ge=5.0, le=150.0), Converted(math.radians)] = math.radians(60.0)
    """Angle from one side of the cone to the other, in radians (degrees in the file)."""
    brightness: Annotated[float, Interval(gt=0.0, le=1e6)] = 2000.0
    """Luminous flux, in lumens."""
    position: tuple[_Coordinate, _Coordinate, _Coordinate] = (0.0, 0.0, 0.0)
    """Position in the frame of the link, in metres."""
    tilt: Annotated[float, Interval(ge=-90.0, le=90.0), Converted(math.radians)] = 0.0
    """Radians (degrees in the file) below the x axis."""
    on: bool = False
    """True if the lamp is on at the start."""

    @property
    def intensity(self) -> float:
        """Luminous intensity in its cone, in candela."""
        return self.brightness / (math.tau * (1.0 - math.cos(self.cone / 2.0)))


class Lamp(OptionalPart):
    """A lamp of the robot."""

    def __init__(self, setup: LampSetup) -> None:
        self.setup = setup

    @property
    def id(self) -> PartId:
        """The part id; lamps have names."""
        return PartId(Lamp, self.setup.name)

    @property
    @abstractmethod
    def level(self) -> float:
        """Brightness, from 0 (off) to 1."""

    @abstractmethod
    def set(self, level: float) -> None:
        """Switch to this brightness, from 0 (off) to 1."""

    def state(self) -> object:
        """The level."""
        return self.level

    def proxy(self, link: RobotLink) -> Lamp:
        """The lamp for other threads."""
        return _LampProxy(self.setup, link)


def lamps_of(robot: RobotParts) -> tuple[Lamp, ...]:
    """The robot's lamps, in the order of its description."""
    return tuple(part for part in robot.optional_parts if isinstance(part, Lamp))


class SwitchedLamp(Lamp):
    """A `Lamp` of a simulated robot."""

    def __init__(self, setup: LampSetup) -> None:
        super().__init__(setup)
        self._level = float(setup.on)

    @property
    def level(self) -> float:
        """The last one that was set."""
        return self._level

    def set(self, level: float) -> None:
        """Same as `Lamp.set`."""
        self._level = min(max(level, 0.0), 1.0)


def switched_lamps(setups: Sequence[LampSetup]) -> tuple[SwitchedLamp, ...]:
    """The lamps of a simulated robot."""
    return tuple(SwitchedLamp(setup) for setup in setups)


@dataclass(frozen=True, slots=True)
class LampCommand(Command):
    """Switch a lamp."""

    name: str
    level: float

    @property
    def part(self) -> PartId:
        """The lamp."""
        return PartId(Lamp, self.name)

    def apply(self, robot: Robot) -> None:
        """Set its level."""
        for lamp in lamps_of(robot):
            if lamp.setup.name == self.name:
                lamp.set(self.level)


class _LampProxy(Lamp):
    def __init__(self, setup: LampSetup, link: RobotLink) -> None:
        super().__init__(setup)
        self._link = link

    @property
    def level(self) -> float:
        found = self._link.snapshot.parts[self.id]
        assert isinstance(found, float)
        return found

    def set(self, level: float) -> None:
        self._link.submit(LampCommand(self.setup.name, level))
