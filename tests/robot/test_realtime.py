"""A robot in its thread, and those who talk to it from another."""

import threading

import pytest
from tests.helpers.robot import FakeJoints

from jauspy.backends.kinematic import KinematicBackend
from jauspy.errors import ConfigError
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.ranging import LidarSetup, Scanner, ScanSettings
from jauspy.robot.realtime import WHOLE_ROBOT, RealTime
from jauspy.robot.robot_files import load, robot_model


@pytest.fixture
def inc1():
    robot = KinematicBackend().open(robot_model(load("inc1")), "empty")
    yield robot
    robot.close()


def test_robot_does_not_move_before_open(fake_robot):
    runner = RealTime(fake_robot)
    assert runner.snapshot.time == 0.0
    runner.close()
    assert fake_robot.steps == 0


def test_advances_the_robot_in_one_other_thread(fake_robot):
    with RealTime(fake_robot, step=0.002) as runner:
        fake_robot.wait_for_steps(5)
    assert len(fake_robot.threads) == 1
    assert threading.get_ident() not in fake_robot.threads
    assert runner.counters["steps"] == fake_robot.steps
    assert runner.snapshot.time == pytest.approx(fake_robot.steps * 0.002)


def test_latest_command_takes_effect_with_the_next_step(fake_robot):
    with RealTime(fake_robot, step=0.002) as runner:
        runner.drive.set_effort(0.1, 0.0)
        runner.drive.set_effort(0.4, -0.2)
        fake_robot.wait_for_steps(2)
        assert fake_robot.drive.effort == (0.4, -0.2)
        runner.drive.stop()
        fake_robot.wait_for_steps(2)
        assert fake_robot.drive.effort == (0.0, 0.0)


def test_state_is_the_snapshot_after_the_last_step(inc1):
    runner = RealTime(inc1, step=0.002)
    before = runner.snapshot
    with runner:
        runner.drive.set_effort(1.0, 0.0)
        while runner.drive.pose().x <= 0.0:
            runner.drive.twist()
    after = runner.snapshot
    assert before.pose.x == 0.0
    assert (after.pose, after.time) == (inc1.drive.pose(), pytest.approx(inc1.time))
    assert after.twist.vx > 0.0


def test_stops_the_drive_when_closed(fake_robot):
    with RealTime(fake_robot, step=0.002) as runner:
        runner.drive.set_effort(1.0, 0.0)
        fake_robot.wait_for_steps(2)
    assert fake_robot.drive.effort == (0.0, 0.0)
    assert runner.ended.done()
    steps = fake_robot.steps
    runner.close()
    assert fake_robot.steps == steps


def test_command_just_before_close_does_not_drive(fake_robot):
    runner = RealTime(fake_robot, step=0.002)
    runner.open()
    runner.drive.set_effort(1.0, 0.0)
    runner.close()
    runner.drive.set_effort(1.0, 0.0)
    assert fake_robot.drive.effort == (0.0, 0.0)


def test_open_twice_has_no_effect(fake_robot):
    with RealTime(fake_robot, step=0.002) as runner:
        runner.open()
        fake_robot.wait_for_steps(2)
    assert len(fake_robot.threads) == 1


class Clock:
    def __init__(self) -> None:
        self.now = 50.0

    def __call__(self) -> float:
        self.now += 0.001
        return self.now


def test_missing_heartbeat_stops_the_robot(fake_robot):
    clock = Clock()
    with RealTime(fake_robot, step=0.002, heartbeat_timeout=1.0, clock=clock) as runner:
        runner.drive.set_effort(1.0, 0.0)
        fake_robot.wait_for_steps(3)
        assert (1.0, 0.0) in fake_robot.drive.efforts
        clock.now += 2.0
        fake_robot.wait_for_steps(3)
        assert fake_robot.drive.effort == (0.0, 0.0)
        assert runner.counters["abandoned"] > 0
        runner.alive()
        runner.drive.set_effort(0.5, 0.0)
        fake_robot.wait_for_steps(3)
        assert (0.5, 0.0) in fake_robot.drive.efforts


def test_commands_to_a_joint_group_named_drive_do_not_replace_the_stop_of_the_chassis(fake_robot):
    fake_robot.groups["drive"] = FakeJoints()
    fake_robot.drive.set_effort(1.0, 0.0)
    runner = RealTime(fake_robot, step=0.002)
    runner.drive.stop()
    runner.groups["drive"].command([Target(ControlMode.VELOCITY, 0.1)])
    with runner:
        fake_robot.wait_for_steps(1)
        assert fake_robot.drive.efforts[:2] == [(1.0, 0.0), (0.0, 0.0)]
        assert fake_robot.groups["drive"].targets == [(Target(ControlMode.VELOCITY, 0.1),)]


def test_commands_to_a_joint_group_named_like_a_lidar_do_not_replace_its_settings(fake_robot):
    setup = LidarSetup("front", "base_link")
    fake_robot.lidars["front"] = Scanner(setup)
    fake_robot.groups["lidar front"] = fake_robot.groups["front"] = FakeJoints()
    runner = RealTime(fake_robot, step=0.002)
    runner.lidars["front"].configure(ScanSettings(rate=2.0))
    runner.groups["lidar front"].hold()
    runner.groups["front"].hold()
    with runner:
        fake_robot.wait_for_steps(1)
    assert fake_robot.lidars["front"].settings.rate == 2.0


def test_motors_are_enabled_by_the_robots_thread_before_its_next_step(fake_robot):
    enabled = []
    with RealTime(fake_robot, step=0.002) as runner:
        runner.enable(lambda: enabled.append(threading.get_ident())).result(5.0)
        fake_robot.wait_for_steps(2)
    assert set(enabled) == fake_robot.threads
    assert not runner.faults


def test_motors_are_not_enabled_if_the_start_was_cancelled(fake_robot):
    enabled = []
    runner = RealTime(fake_robot, step=0.002)
    assert runner.enable(lambda: enabled.append(1)).cancel()
    with runner:
        fake_robot.wait_for_steps(2)
    assert not enabled


def test_motors_that_cannot_be_enabled(fake_robot, caplog):
    def refuse():
        raise ConfigError("no drive answers")

    def fail():
        raise OSError("the bus is busy")

    with RealTime(fake_robot, step=0.002) as runner:
        with pytest.raises(ConfigError, match="no drive answers"):
            runner.enable(refuse).result(5.0)
        assert not caplog.messages
        runner.retry(WHOLE_ROBOT)
        runner.enable(fail).result(5.0)
        assert runner.faults == {WHOLE_ROBOT: "OSError: the bus is busy"}
    assert "the robot failed: OSError: the bus is busy" in caplog.text
