"""The tables of a robot's TOML file about lamps."""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

from pydantic import Field

from jauspy.modules.config_base import StrictConfig, UrdfName
from jauspy.platform.lights import LampSetup, Switch

Coordinate: TypeAlias = Annotated[float, Field(ge=-10.0, le=10.0)]


class LightConfig(StrictConfig):
    """A lamp that shines along the x axis of a link, in a round cone."""

    name: UrdfName
    link: UrdfName
    switch: Switch
    """The light of JAUS's IlluminationService that switches it."""
    cone: Annotated[float, Field(ge=5.0, le=150.0)] = 60.0
    """From one side of the cone to the other, in degrees."""
    brightness: Annotated[float, Field(gt=0.0, le=1e6)] = 2000.0
    """In lumens."""
    position: tuple[Coordinate, Coordinate, Coordinate] = (0.0, 0.0, 0.0)
    """In the frame of the link, in metres."""
    tilt: Annotated[float, Field(ge=-90.0, le=90.0)] = 0.0
    """Degrees below the x axis."""
    on: bool = False
    """Whether it is on at the start."""

    def setup(self) -> LampSetup:
        """Return the setup for the backend."""
        return LampSetup(
            self.name,
            self.link,
            self.switch,
            math.radians(self.cone),
            self.brightness,
            self.position,
            math.radians(self.tilt),
            self.on,
        )
