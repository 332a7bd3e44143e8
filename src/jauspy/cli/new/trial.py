"""A trial of a robot on wheels in the simulation: how fast it drives and turns."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from jauspy import backends
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel

TRIAL_TIME: Final = 2.0
"""Simulated seconds of each trial; the last quarter counts."""
STANDING_TIME: Final = 1.0
"""Simulated seconds to stand still between two trials."""
LEAST_SPEED: Final = 0.05
"""M/s below which a robot does not drive."""
LEAST_TURN_RATE: Final = 0.1
"""Rad/s below which a robot does not turn."""


@dataclass(frozen=True, slots=True)
class Trial:
    """Motion of a robot at full effort on level ground."""

    speed: float
    """M/s, straight ahead."""
    turn_rate: float
    """Rad/s to the left: on the spot, or in the narrowest curve of a robot that steers."""

    @property
    def cannot(self) -> str:
        """The verb for what the robot cannot do; empty if it drives and turns."""
        failed = {"drive": self.speed < LEAST_SPEED, "turn": self.turn_rate < LEAST_TURN_RATE}
        return " or ".join(verb for verb, is_missing in failed.items() if is_missing)


def try_wheels(model: RobotModel) -> Trial:
    """Drive and turn a robot on the simulation's empty ground.

    Raises `ConfigError` if the simulation is not installed, or cannot simulate the robot.
    """
    robot = backends.find("sim").open(model, "empty")
    try:
        steers = model.wheels is not None and bool(model.wheels.steering)
        start = robot.drive.pose()
        speed = _driven(robot, 1.0, 0.0)[0]
        end = robot.drive.pose()
        robot.drive.stop()
        robot.advance(STANDING_TIME)
        turn_rate = _driven(robot, 1.0 if steers else 0.0, 1.0)[1]
    finally:
        robot.close()
    went_ahead = (end.x - start.x) * math.cos(start.yaw) + (end.y - start.y) * math.sin(start.yaw) > 0.0
    return Trial(speed if went_ahead else 0.0, turn_rate)


def _driven(robot: Robot, linear_x: float, rotational_z: float) -> tuple[float, float]:
    """Mean speed and turn rate (m/s, rad/s) at an effort, in the last quarter of a trial."""
    robot.drive.set_effort(linear_x, rotational_z)
    robot.advance(0.75 * TRIAL_TIME)
    before = robot.drive.pose()
    robot.advance(0.25 * TRIAL_TIME)
    after, seconds = robot.drive.pose(), 0.25 * TRIAL_TIME
    way = math.hypot(after.x - before.x, after.y - before.y)
    return way / seconds, math.remainder(after.yaw - before.yaw, math.tau) / seconds
