"""Localisation on MuJoCo's chassis, whose tracks slip."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from tests.helpers.robot import described

from jauspy.platform.localization import EXACT, Localization, LocalizationState
from jauspy_sim.robot import SimulatedRobot

INC1 = replace(described("inc1")[1], lidars=(), cameras=())
EFFORTS = ((0.5, 0.0), (0.0, 0.4), (0.4, 0.1))


def drive(seed: int, seconds: float, step: float) -> tuple[SimulatedRobot, LocalizationState]:
    setup = replace(INC1.localization, seed=seed)
    robot = SimulatedRobot.open(replace(INC1, localization=setup), "empty")
    for effort in EFFORTS:
        robot.drive.set_effort(*effort)
        for _ in range(round(seconds / len(EFFORTS) / step)):
            robot.advance(step)
    found = Localization.of(robot)
    assert found is not None
    state = found.state()
    assert isinstance(state, LocalizationState)
    return robot, state


@pytest.mark.slow
def test_drifts_within_what_it_reports() -> None:
    robot, state = drive(3, 9.0, 0.1)
    true, local, globe = robot.drive.pose(), state.local.pose, state.globe.pose
    error = math.dist((true.x, true.y), (local.x, local.y))
    assert 1e-3 < error < 2.0 * state.local.horizontal_rms
    assert abs(math.remainder(true.yaw - local.yaw, math.tau)) < 4.0 * state.local.attitude_rms
    assert 0.05 < math.dist((true.x, true.y), (globe.x, globe.y)) < 4.0 * state.globe.horizontal_rms
    assert state.twist.vx == pytest.approx(robot.drive.twist().vx, abs=0.1)


def test_is_the_same_however_time_is_divided() -> None:
    (first, one), (again, other) = drive(3, 1.2, 0.1), drive(3, 1.2, 0.004)
    assert one == other
    assert first.drive.pose() == again.drive.pose()


@pytest.mark.slow
def test_odometry_assumes_the_point_about_which_tracks_turn() -> None:
    """It is ahead of the middle of the tracks: the front carries more, and skids less."""
    exact = replace(INC1, localization=EXACT)
    robot = SimulatedRobot.open(exact, "empty")
    ahead = []
    for effort in ((0.0, 0.4), (0.0, -0.4), (0.4, 0.1)):
        robot.drive.set_effort(*effort)
        robot.advance(1.0)
        for _ in range(20):
            robot.advance(0.05)
            ahead.append(-robot.drive.twist().vy / robot.drive.twist().wz)
    assert INC1.tracks is not None
    assert sum(ahead) / len(ahead) == pytest.approx(INC1.tracks.turning_point, abs=0.02)


def test_exact_when_the_file_says_so() -> None:
    robot = SimulatedRobot.open(replace(INC1, localization=EXACT), "empty")
    assert Localization.of(robot) is None
