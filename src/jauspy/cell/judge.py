"""The judge: true poses, for measurements only. No task uses it, and a cell elsewhere has none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import pinocchio as pin

from jauspy.cell.frames import offset_between, se3_of_pose, tilt_between
from jauspy.cell.layout import Layout
from jauspy.cell.scene import connector_frame
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.platform.camera import Camera
from jauspy.platform.contract import Backend, Robot
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.connector import VacuumConnector
from jauspy.platform.modular.servo import ServoModule


@runtime_checkable
class KnowsTruth(Protocol):
    """A robot of a simulation that tells where parts really are."""

    def true_pose(self, part: str) -> Pose:
        """The pose of a part's frame in the world. Raises `ConfigError` for an unknown name."""
        ...


@dataclass(frozen=True, slots=True)
class Placement:
    """How far a part is off the connector that holds it, as measured in the simulation."""

    part: str
    distance: float
    """Metres between the middles of the plates."""
    tilt: float
    """Radians between their normals."""
    turn: float
    """Radians about the normal, from the nearest quarter of a turn."""


class Judge:
    """Reads the simulation's true state."""

    def __init__(self, robot: Robot, layout: Layout) -> None:
        if not isinstance(robot, KnowsTruth):
            raise ConfigError("this backend does not tell where parts really are; use the backend `sim`")
        self._truth: KnowsTruth = robot
        self._robot = robot
        self._layout = layout

    @property
    def time(self) -> float:
        """Seconds of the robot's own time."""
        return self._robot.time

    def pose(self, part: str) -> pin.SE3:
        """The true frame of a part in the world."""
        return se3_of_pose(self._truth.true_pose(part))

    def attached(self) -> dict[str, str]:
        """Which part each connector holds."""
        found = {}
        for part in self._robot.optional_parts:
            if isinstance(part, VacuumConnector) and (held := part.state().attached_to):
                found[part.name] = held
        return found

    def placement(self, connector: str, part: str) -> Placement:
        """How far a part is off a connector, as in `servo_1/output`; the servo's position is taken into account."""
        owner, _, name = connector.partition("/")
        position = 0.0
        for each in self._robot.optional_parts:
            if isinstance(each, ServoModule) and each.name == owner:
                position = each.state().position
        frame = self.pose(owner) * connector_frame(self._layout.type_of(owner), name, position)
        there = self.pose(part)
        distance, angle = offset_between(frame, there)
        tilt = tilt_between(frame, there)
        turn = max(0.0, angle * angle - tilt * tilt) ** 0.5
        quarter = 1.5707963267948966
        return Placement(part, distance, tilt, abs(turn - quarter * round(turn / quarter)))

    def camera(self) -> Camera | None:
        """The first camera of the cell, for films."""
        return next(iter(self._robot.cameras.values()), None)


class WatchedBackend:
    """Opens robots with another backend, and remembers the last one for the judge."""

    def __init__(self, backend: Backend) -> None:
        self._backend = backend
        self.robot: Robot | None = None

    @property
    def name(self) -> str:
        """That of the other backend."""
        return self._backend.name

    def open(self, robot: RobotModel, world: str) -> Robot:
        """Open a robot."""
        self.robot = self._backend.open(robot, world)
        return self.robot
