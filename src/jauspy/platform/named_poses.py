"""Named poses of a robot's joints: `stow`, `drive`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

MAX_POSES: Final = 32
"""Poses of one robot."""


@dataclass(frozen=True, slots=True)
class NamedPose:
    """A pose of one or more groups of joints."""

    number: int
    """From 1, in the order of the robot's file: its id in PresetPose, the same for all components."""
    name: str
    positions: Mapping[str, float]
    """Radians or metres by joint; all joints of a group, or none."""
