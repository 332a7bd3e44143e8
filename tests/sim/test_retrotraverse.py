"""Driving back on slopes and stairs, by the estimated position; where the robot is, the simulation says."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from tests.helpers.robot import described
from tests.robot.test_retrotraverse import is_done, start, velocity
from tests.robot.world import World
from tests.sim.physics.test_tracks import FLIPPERS_OUT, FOOT, LANDING, RISER, STEPS, TREAD, put, stairs, tilt

from jauspy.backends import find
from jauspy.messages.mobility import SetLocalWaypoint, SetTravelSpeed
from jauspy.platform.contract import Robot
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.localization import Localization

FLIPPERS = "group 'flippers'"
UP = 2.2
"""Radians: the flippers stand up, and do not touch the ground."""


class Climb:
    """A robot under control, and where it was on the way out."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.world = World("sim", robot=robot, localization=Localization.of(robot))
        self.world.take_control()
        self.world.own_motion.controlled.add(FLIPPERS)
        self.out: list[tuple[float, float, float]] = []
        self.deviation = self.tilt = self.highest = self.fastest = 0.0
        """Metres, radians, metres, and m/s on the slope."""

    def note(self) -> None:
        pose = self.robot.drive.pose()
        self.out.append((pose.x, pose.y, pose.z))
        self.highest = max(self.highest, pose.z)

    def compare(self) -> None:
        pose = self.robot.drive.pose()
        self.deviation = max(self.deviation, min(math.dist((pose.x, pose.y, pose.z), passed) for passed in self.out))
        self.tilt = max(self.tilt, tilt(pose))
        if tilt(pose) > math.radians(11.0):
            self.fastest = max(self.fastest, abs(self.robot.drive.twist().vx))

    def turn_flippers(self, position: float) -> None:
        self.robot.groups["flippers"].command([Target(ControlMode.POSITION, position)])
        self.world.run(4.0)

    def drive_back(self, seconds: float) -> None:
        self.world.tell(start(100.0, 1.0))
        self.world.run_until(lambda: is_done(self.world), seconds, self.compare)


@pytest.mark.slow
def test_ramp_is_driven_down_as_it_was_driven_up() -> None:
    """A ramp of 12 degrees, and a turn on the deck above it."""
    model = replace(described("inc1")[1], lidars=(), cameras=())
    climb = Climb(find("sim").open(model, "yard"))
    climb.world.tell(SetLocalWaypoint(x=6.0, y=0.0), SetTravelSpeed(0.4))
    climb.world.run_until(lambda: climb.robot.drive.pose().x > 5.4, 30, climb.note)
    climb.world.tell(velocity(0.0, 0.5))
    climb.world.run(1.0, climb.note)
    climb.world.tell(velocity(0.0))
    climb.world.run(1.0, climb.note)
    assert climb.highest > 0.35
    climb.drive_back(60)
    pose = climb.robot.drive.pose()
    assert math.hypot(pose.x, pose.y) < 0.3
    assert pose.z < 0.05
    assert climb.deviation < 0.15
    assert climb.tilt < math.radians(25.0)
    assert 0.2 < climb.fastest < 0.7  # as on the way out, on the slope; 1 m/s is the limit


@pytest.mark.slow
def test_stairs_are_driven_down_with_the_flippers_out() -> None:
    """Up six steps of 18 cm with the flippers out, which are raised on the landing, and out again before the stairs."""
    climb = Climb(put(stairs(), x=0.1))
    climb.turn_flippers(FLIPPERS_OUT)
    top = FOOT + STEPS * TREAD
    climb.world.tell(velocity(0.3))
    climb.world.run_until(lambda: climb.robot.drive.pose().x > top + 0.7, 60, climb.note)
    climb.world.tell(velocity(0.0))
    climb.world.run(1.0, climb.note)
    assert climb.highest == pytest.approx(STEPS * RISER, abs=0.1)
    climb.turn_flippers(UP)
    climb.world.tell(velocity(0.3))
    climb.world.run_until(lambda: climb.robot.drive.pose().x > top + LANDING - 0.7, 30, climb.note)
    climb.world.tell(velocity(0.0))
    climb.world.run(1.0, climb.note)
    flippers = climb.robot.groups["flippers"]
    assert flippers.state().positions[0] == pytest.approx(UP, abs=0.1)
    climb.drive_back(90)
    pose = climb.robot.drive.pose()
    assert flippers.state().positions[0] == pytest.approx(FLIPPERS_OUT, abs=0.15)
    assert abs(pose.x - 0.1) < 1.0  # tracks slip on stairs, which the odometry does not see
    assert abs(pose.y) < 0.2
    assert pose.z < 0.05
    assert climb.tilt < math.radians(50.0)
