"""Settings of the protection against tipping over: the table `[stability]` of a robot's TOML file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from annotated_types import Interval

from jauspy.platform.tables import Converted, Table


@dataclass(frozen=True, slots=True)
class StabilitySetup(Table):
    """Margins of tipping at which motions are limited; radians, degrees in the file."""

    slow: Annotated[float, Interval(gt=0.0, le=60.0), Converted(math.radians)] = math.radians(12.0)
    """The margin below which tracks, wheels and joints move more slowly."""
    stop: Annotated[float, Interval(gt=0.0, le=60.0), Converted(math.radians)] = math.radians(6.0)
    """The margin at which motions stop that would make it less."""
    creep: Annotated[float, Interval(gt=0.0, le=1.0)] = 0.25
    """The fraction of the speed at the margin `stop`."""
    overhang: Annotated[float, Interval(ge=0.0, le=1.0)] = 0.0
    """Metres by which tracks may reach beyond the edges of stairs that carry them: half a step, along the slope.

    On a slope like that of stairs (`STAIRS`), joints move only as far as the robot would stand on such edges, too.
    """
    payload: Annotated[float, Interval(ge=0.0, le=200.0)] = 0.0
    """Kilograms in the gripper, of a robot without a sensor of force behind it."""
    on: bool = True
    """True if motions are limited from the start; a client may switch it."""

    def __post_init__(self) -> None:
        if self.stop >= self.slow:
            raise ValueError("stop: must be below slow, the margin at which motions become slower")
