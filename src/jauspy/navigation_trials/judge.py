"""The judge: what the simulation knows of a robot that drives. The robot and its navigator know none of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from jauspy import backends
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.planning.ground import Heights
from jauspy.platform.backend import OpensSeveral, PlacedRobot
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel


class DepthCamera(Protocol):
    """A depth camera that the simulation computes at once."""

    def look(self) -> NDArray[np.float32]:
        """Points in the frame of its link, metres, shape (n, 3)."""
        ...


class DrivingTruth(Protocol):
    """The true state of a robot and its world."""

    @property
    def heights(self) -> Heights:
        """The heights of the world without the robot."""
        ...

    @property
    def way(self) -> float:
        """Metres driven since `begin`."""
        ...

    @property
    def contacts(self) -> Mapping[str, int]:
        """Samples of the physics since `begin` with a contact that is not with the ground, by body of the world."""
        ...

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        ...

    def measure_heights(self) -> None:
        """Measure the heights again, after things were moved."""
        ...

    def begin(self) -> None:
        """Measure contacts and way from now on."""
        ...

    def depth_camera(self, link: str, seed: int) -> DepthCamera:
        """A depth camera at a link."""
        ...

    def put_thing(self, x: float, y: float) -> str:
        """Put a movable thing of the world to a place, at rest; returns its name. Raises `ConfigError` without any."""
        ...


@runtime_checkable
class KnowsDriving(Protocol):
    """A robot of a simulation."""

    def driving_truth(self, step: float) -> DrivingTruth:
        """The truth from now on; `step` metres is the highest step that the robot climbs."""
        ...


class PlacingBackend:
    """Opens a robot with the backend `sim` at a pose of the world, and remembers it for the judge."""

    name = "sim"

    def __init__(self, start: Pose) -> None:
        self._start = start
        self._robot: Robot | None = None

    def open(self, robot: RobotModel, world: str) -> Robot:
        """Open the robot. Raises `ConfigError` without MuJoCo, and for an unknown world."""
        backend = backends.find(self.name)
        if not isinstance(backend, OpensSeveral):
            raise ConfigError(f"the backend {self.name!r} cannot place a robot in a world; install jauspy[sim] again")
        self._robot = backend.open_several([PlacedRobot(robot, self._start)], world)[0]
        return self._robot

    @property
    def robot(self) -> Robot:
        """The robot, once it is open."""
        if self._robot is None:
            raise ConfigError("the robot is not open yet")
        return self._robot

    def truth(self, step: float) -> DrivingTruth:
        """The truth about the robot that was opened; `step` metres is the highest that it climbs."""
        robot: object = self.robot
        if not isinstance(robot, KnowsDriving):
            raise ConfigError(f"the backend {self.name!r} does not know the truth of drives; install jauspy[sim] again")
        return robot.driving_truth(step)
