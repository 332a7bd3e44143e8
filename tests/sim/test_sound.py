"""What the microphone of inc1 hears in the physics simulation."""

from __future__ import annotations

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

from tests.audio.signals import joined, level
from tests.helpers.robot import described

from jauspy.audio.hearing import Hearing
from jauspy.backends import find
from jauspy.platform.contract import Snapshot
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.sound_scene import MachineState, SoundScene

STEP = 0.02


@pytest.fixture
def sim():
    _, model = described("inc1")
    robot = find("sim").open(model, "empty")
    yield robot, model, Hearing(SoundScene.of(model, model.microphones[0]))
    robot.close()


def heard(sim, seconds):
    """Level of what is heard while the robot runs, and its mean speed."""
    robot, model, hearing = sim
    sounds, speeds = [], []
    for _ in range(round(seconds / STEP)):
        robot.advance(STEP)
        state = MachineState.of(model, Snapshot.of(robot))
        hearing.update(state)
        sounds.append(hearing.frame())
        speeds.append((abs(state.left) + abs(state.right)) / 2.0)
    return level(joined(sounds)), sum(speeds) / len(speeds)


@pytest.mark.slow
def test_level_rises_with_the_speed_of_the_tracks(sim):
    robot, *_ = sim
    quiet, _ = heard(sim, 1.0)
    found = []
    for effort in (0.25, 0.8):
        robot.drive.set_effort(effort, 0.0)
        heard(sim, 1.5)
        found.append(heard(sim, 1.0))
    (slow, slow_speed), (fast, fast_speed) = found
    assert fast_speed > 1.5 * slow_speed > 0.05
    assert slow > quiet + 6.0
    assert fast > slow + 4.0
    robot.drive.stop()
    heard(sim, 1.5)
    stopped, _ = heard(sim, 1.0)
    assert stopped == pytest.approx(quiet, abs=1.5)


@pytest.mark.slow
def test_turning_on_the_spot_and_the_arm_are_heard(sim):
    robot, *_ = sim
    quiet, _ = heard(sim, 1.0)
    robot.drive.set_effort(0.0, 0.6)
    heard(sim, 1.0)
    turning, _ = heard(sim, 1.0)
    robot.drive.stop()
    heard(sim, 1.5)
    arm = robot.groups["arm"]
    arm.command([Target(ControlMode.VELOCITY, 0.5)] + [Target(ControlMode.VELOCITY, 0.0)] * (len(arm.joints) - 1))
    heard(sim, 0.3)
    moving, _ = heard(sim, 1.0)
    assert turning > quiet + 6.0
    assert moving > quiet + 3.0
