"""A whole robot in MuJoCo's physics on virtual time, and the simulation itself, to measure what really happened."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

if TYPE_CHECKING:
    from jauspy_sim.robot import SimulatedRobot


class Simulation:
    """A backend that keeps the robot that it opened."""

    name = "sim"

    def __init__(self) -> None:
        self._robot: SimulatedRobot | None = None

    @property
    def robot(self) -> SimulatedRobot:
        assert self._robot is not None, "the robot is not open"
        return self._robot

    def open(self, robot: RobotModel, world: str) -> SimulatedRobot:
        from jauspy_sim.robot import SimulatedRobot

        self._robot = SimulatedRobot.open(robot, world)
        return self._robot


def simulated(network: VirtualNetwork, simulation: Simulation, name: str = "inc1", world: str = "empty") -> RobotRunner:
    """The robot, to be used with `async with`; without cameras, which need a process each."""
    config = robot_files.load(name)
    modules = tuple(each for each in config.modules if each.type != "CM-VIS")
    config = config.model_copy(update={"modules": modules, "cameras": ()})
    return RobotRunner(config, network.transport, backend=simulation, world=world, realtime=VirtualTime)
