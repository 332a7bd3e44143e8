"""What every backend's robot promises; the same tests over all of them."""

import math
from collections.abc import Callable

import pytest

from jauspy.backends import find
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Twist
from jauspy.platform.contract import Robot
from jauspy.robot.robot_files import load, robot_model


@pytest.fixture(params=["inc1", pytest.param("rover", marks=pytest.mark.slow)])
def robot_name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def speed(twist: Twist) -> float:
    return math.hypot(twist.vx, twist.vy, twist.vz)


def turning(before: Pose, after: Pose) -> float:
    return math.remainder(after.yaw - before.yaw, math.tau)


def assert_at_rest(twist: Twist) -> None:
    assert speed(twist) < 1e-3
    assert abs(twist.wz) < 1e-3


def test_starts_at_rest_at_the_origin(robot: Robot) -> None:
    pose = robot.drive.pose()
    assert robot.time == 0.0
    assert math.hypot(pose.x, pose.y, pose.z) < 1e-3
    assert max(abs(pose.roll), abs(pose.pitch), abs(pose.yaw)) < 1e-3
    assert_at_rest(robot.drive.twist())


def test_stays_at_rest_without_commands(robot: Robot) -> None:
    robot.advance(2.0)
    pose = robot.drive.pose()
    assert math.hypot(pose.x, pose.y) < 1e-3
    assert_at_rest(robot.drive.twist())


def test_forward_effort_moves_forward(robot: Robot) -> None:
    robot.drive.set_effort(0.4, 0.0)
    robot.advance(2.0)
    assert robot.drive.pose().x > 0.8
    assert 0.4 < robot.drive.twist().vx < 0.8


def test_backward_effort_moves_backward(robot: Robot) -> None:
    robot.drive.set_effort(-0.4, 0.0)
    robot.advance(2.0)
    assert robot.drive.pose().x < -0.8
    assert -0.8 < robot.drive.twist().vx < -0.4


def test_full_effort_reaches_the_top_speed(robot: Robot, robot_name: str) -> None:
    robot.drive.set_effort(1.0, 0.0)
    robot.advance(3.0)
    assert robot.drive.twist().vx == pytest.approx({"inc1": 1.9, "rover": 1.5}[robot_name], abs=0.1)


@pytest.mark.parametrize("effort", [0.3, 0.4, 1.0])
def test_positive_rotational_effort_turns_left_in_place(robot: Robot, effort: float) -> None:
    robot.drive.set_effort(0.0, effort)
    robot.advance(0.8)
    pose, twist = robot.drive.pose(), robot.drive.twist()
    assert 0.1 < pose.yaw < math.pi
    assert twist.wz > 0.3
    assert math.hypot(pose.x, pose.y) < 0.08


def test_turns_right_as_much_as_left(open_robot: Callable[[], Robot]) -> None:
    left, right = open_robot(), open_robot()
    left.drive.set_effort(0.0, 0.4)
    right.drive.set_effort(0.0, -0.4)
    left.advance(1.0)
    right.advance(1.0)
    assert right.drive.pose().yaw == pytest.approx(-left.drive.pose().yaw, abs=0.05)


def test_both_efforts_drive_a_left_curve(robot: Robot) -> None:
    robot.drive.set_effort(0.4, 0.2)
    robot.advance(1.5)
    pose = robot.drive.pose()
    assert pose.x > 0.3
    assert pose.y > 0.05
    assert pose.yaw > 0.2


@pytest.mark.slow
@pytest.mark.parametrize("efforts", [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.6, -0.3)])
def test_stop_stops_within_a_second(robot: Robot, efforts: tuple[float, float]) -> None:
    robot.drive.set_effort(*efforts)
    robot.advance(2.0)
    before = robot.drive.pose()
    robot.drive.stop()
    robot.advance(1.0)
    after = robot.drive.pose()
    assert_at_rest(robot.drive.twist())
    assert math.hypot(after.x - before.x, after.y - before.y) < 0.6
    assert abs(turning(before, after)) < 0.8


def test_zero_effort_is_a_stop(open_robot: Callable[[], Robot]) -> None:
    zeroed, stopped = open_robot(), open_robot()
    for robot in (zeroed, stopped):
        robot.drive.set_effort(1.0, 0.2)
        robot.advance(1.0)
    zeroed.drive.set_effort(0.0, 0.0)
    stopped.drive.stop()
    for robot in (zeroed, stopped):
        robot.advance(1.0)
        assert_at_rest(robot.drive.twist())
    assert zeroed.drive.pose() == stopped.drive.pose()


def test_drives_again_after_a_stop(robot: Robot) -> None:
    robot.drive.stop()
    robot.advance(0.5)
    robot.drive.set_effort(0.4, 0.0)
    robot.advance(2.0)
    assert robot.drive.pose().x > 0.8


@pytest.mark.parametrize(("beyond", "limit"), [((7.0, 0.0), (1.0, 0.0)), ((0.0, -9.0), (0.0, -1.0))])
def test_efforts_beyond_one_are_clamped(
    open_robot: Callable[[], Robot], beyond: tuple[float, float], limit: tuple[float, float]
) -> None:
    wild, tame = open_robot(), open_robot()
    wild.drive.set_effort(*beyond)
    tame.drive.set_effort(*limit)
    wild.advance(1.0)
    tame.advance(1.0)
    assert wild.drive.pose() == tame.drive.pose()


def test_effort_that_is_not_a_number_does_not_drive(robot: Robot) -> None:
    robot.drive.set_effort(math.nan, math.nan)
    robot.advance(0.5)
    assert abs(robot.drive.pose().x) < 1e-3
    assert_at_rest(robot.drive.twist())


def test_same_commands_give_the_same_trajectory_bit_for_bit(open_robot: Callable[[], Robot]) -> None:
    def trajectory() -> list[tuple[float, Pose, Twist]]:
        robot = open_robot()
        states = []
        for efforts, dt in [((0.5, 0.1), 0.3), ((1.0, -0.7), 0.037), ((0.0, 0.9), 0.41), ((0.0, 0.0), 0.2)]:
            robot.drive.set_effort(*efforts)
            robot.advance(dt)
            states.append((robot.time, robot.drive.pose(), robot.drive.twist()))
        return states

    assert trajectory() == trajectory()


def test_uneven_steps_equal_one_long_step(open_robot: Callable[[], Robot]) -> None:
    odd, long = open_robot(), open_robot()
    for robot in (odd, long):
        robot.drive.set_effort(0.4, 0.0)
    for _ in range(1000):
        odd.advance(0.00137)
    long.advance(1.37)
    assert odd.time == pytest.approx(1.37, abs=0.0021)
    assert long.time == pytest.approx(1.37, abs=0.0021)
    assert odd.drive.pose().x == pytest.approx(long.drive.pose().x, abs=0.003)


def test_advancing_by_zero_has_no_effect(robot: Robot) -> None:
    robot.drive.set_effort(1.0, 0.0)
    before = robot.drive.pose()
    robot.advance(0.0)
    assert (robot.time, robot.drive.pose()) == (0.0, before)


@pytest.mark.parametrize("dt", [-0.1, math.nan, math.inf])
def test_time_only_goes_forward(robot: Robot, dt: float) -> None:
    with pytest.raises(ValueError, match="only goes forward"):
        robot.advance(dt)


def test_equal_efforts_drive_straight(robot: Robot) -> None:
    robot.drive.set_effort(0.6, 0.0)
    robot.advance(5.0)
    pose = robot.drive.pose()
    assert pose.x > 3.0
    assert abs(pose.y) < 0.01
    assert abs(pose.yaw) < 0.005


def test_twist_is_in_the_body_frame(robot: Robot) -> None:
    robot.drive.set_effort(0.0, 0.4)
    while robot.drive.pose().yaw < math.pi / 2:
        robot.advance(0.02)
    robot.drive.stop()
    robot.advance(1.0)
    robot.drive.set_effort(0.4, 0.0)
    robot.advance(1.0)
    twist = robot.drive.twist()
    assert twist.vx > 0.4
    assert abs(twist.vy) < 0.02


def test_a_closed_loop_drives_two_metres_and_turns_left(robot: Robot) -> None:
    while (remaining := 2.0 - robot.drive.pose().x) > 0.02:
        robot.drive.set_effort(min(0.4, max(0.08, remaining)), 0.0)
        robot.advance(0.1)
        assert robot.time < 20.0
    while (remaining := math.pi / 2 - robot.drive.pose().yaw) > 0.03:
        robot.drive.set_effort(0.0, min(0.4, max(0.15, 0.5 * remaining)))
        robot.advance(0.1)
        assert robot.time < 40.0
    robot.drive.stop()
    robot.advance(1.0)
    pose = robot.drive.pose()
    assert pose.x == pytest.approx(2.0, abs=0.08)
    assert pose.yaw == pytest.approx(math.pi / 2, abs=math.radians(3))


def test_close_may_be_called_twice(robot: Robot) -> None:
    robot.close()
    robot.close()


def test_unknown_world_lists_the_known_ones(backend_name: str) -> None:
    with pytest.raises(ConfigError, match=r"'moon'.*empty.*yard"):
        find(backend_name).open(robot_model(load("inc1")), "moon")


def test_backend_has_its_name(backend_name: str) -> None:
    assert find(backend_name).name == backend_name


def test_a_robot_on_wheels_drives_and_turns(backend_name: str) -> None:
    if backend_name == "can":
        pytest.skip("the backend can has no wheels")
    rover = find(backend_name).open(robot_model(load("rover")), "empty")
    rover.drive.set_effort(0.5, 0.3)
    rover.advance(1.0)
    pose = rover.drive.pose()
    assert pose.x > 0.2
    assert pose.yaw > 0.1
    rover.drive.stop()
    rover.advance(1.0)
    assert_at_rest(rover.drive.twist())
    rover.close()
