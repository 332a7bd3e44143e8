"""Feeds a scene from a robot: its clouds over nanomsg; its lidars, its joints and its pose over JAUS."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from jauspy.geometry.poses import Transform
from jauspy.mapping.sensor_feed import Measurement, Positions, SensorFeed
from jauspy.ocu.robot import Robot
from jauspy.planning.scene import Scene, Sweep
from jauspy.platform.description import RobotModel


class Perception(SensorFeed):
    """Fills a scene with what a robot's sensors see; arguments are those of `SensorFeed`."""

    def __init__(
        self,
        robot: Robot,
        scene: Scene,
        model: RobotModel,
        *,
        clouds: Iterable[str] = (),
        lidars: bool = True,
        movers: Mapping[int, str] = MappingProxyType({}),
        threaded: bool = True,
    ) -> None:
        super().__init__(robot, model, clouds=clouds, lidars=lidars, movers=movers, threaded=threaded)
        self.scene = scene

    def use(self, measured: Measurement) -> bool:
        """Add a measurement to the scene."""
        empty = None if measured.empty is None else measured.empty * self.scene.setup.reach
        return self.scene.add(
            Sweep(
                measured.sensor,
                measured.points,
                measured.mount,
                measured.base,
                measured.time,
                measured.postures,
                empty,
            )
        )

    def moved(self, base: Transform, moment: float, positions: Positions) -> None:
        """Move the scene with the robot."""
        self.scene.move(base, moment, positions)
