"""A robot whose description is known to a recorder."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from jauspy.platform.description import RobotModel


@dataclass(frozen=True, slots=True)
class DescribedRobot:
    """Its subsystem, its description, and which component moves which joints."""

    subsystem: int
    model: RobotModel
    movers: Mapping[int, str] = field(default_factory=dict)
    """The groups of joints, by the numbers of the components that move them."""
