"""Joints that carry tracks, such as flippers, whose positions belong to a driven path."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from jauspy.platform.description import RobotModel
from jauspy.platform.joints import ControlMode, JointGroup, Target

REACHED: Final = 0.1
"""Radians or metres from a position within which a joint has reached it."""


class OwnMotion:
    """Names of the parts that a robot moves by itself, without a client in control, and of those that clients control.

    The modules of a robot share one: their watchdogs enter what clients control, and do not stop `parts`.
    """

    def __init__(self) -> None:
        self.parts: frozenset[str] = frozenset()
        self.controlled: set[str] = set()


class RetracedJoints:
    """Moves joints back to the positions that they had."""

    def __init__(self, name: str, group: JointGroup) -> None:
        self.part = f"group {name!r}"
        """Its name in `OwnMotion`."""
        self._group = group
        self._commanded: tuple[float, ...] | None = None

    def positions(self) -> tuple[float, ...]:
        """Present positions, base to tip, rad or m."""
        return self._group.state().positions

    def move(self, positions: Sequence[float]) -> bool:
        """Command these positions, unless they are commanded already; returns whether the joints have reached them."""
        wanted = tuple(positions)
        if wanted != self._commanded:
            self._commanded = wanted
            self._group.command([Target(ControlMode.POSITION, position) for position in wanted])
        return all(abs(a - b) <= REACHED for a, b in zip(wanted, self.positions(), strict=True))

    def stop(self) -> None:
        """Hold the present positions if these joints were commanded."""
        if self._commanded is not None:
            self._commanded = None
            self._group.hold()


def joints_with_tracks(model: RobotModel, groups: Mapping[str, JointGroup]) -> RetracedJoints | None:
    """The group of joints at whose tip a track runs; None if the robot has none."""
    if model.tracks is None:
        return None
    carriers = {model.description.joint(name).parent for name in (*model.tracks.left, *model.tracks.right)}
    for name, setup in model.groups.items():
        group = groups.get(name) if setup.tip in carriers else None
        if group is not None:
            return RetracedJoints(name, group)
    return None
