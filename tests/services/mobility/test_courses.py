"""The pure parts of guidance: ramps, control, headings and legs."""

from __future__ import annotations

import math

import pytest

from jauspy.geometry.poses import PlanarPoint, Pose
from jauspy.platform.chassis import Chassis
from jauspy.services.mobility.courses import (
    MAX_DRIVING_ERROR,
    STOP_TOLERANCE,
    CourseGoal,
    Leg,
    VectorCourse,
    VelocityCourse,
    WaypointCourse,
    heading_error,
    is_reached,
    look_ahead,
    steer_to_heading,
)
from jauspy.services.mobility.velocity_control import (
    SPEED_GAINS,
    STANDSTILL,
    AccelerationLimits,
    AxisControl,
    Efforts,
    PlanarVelocity,
    VelocityControl,
    ramped,
)

LIMITS = AccelerationLimits(acceleration=1.0, deceleration=2.0, turn_acceleration=3.0, turn_deceleration=4.0)


@pytest.mark.parametrize(
    ("now", "wanted", "after"),
    [
        ((0.0, 0.0), (1.0, 0.0), (0.1, 0.0)),
        ((0.95, 0.0), (1.0, 0.0), (1.0, 0.0)),
        ((1.0, 0.0), (0.0, 0.0), (0.8, 0.0)),
        ((-1.0, 0.0), (0.0, 0.0), (-0.8, 0.0)),
        ((-0.5, 0.0), (-1.0, 0.0), (-0.6, 0.0)),
        ((0.15, 0.0), (-1.0, 0.0), (0.0, 0.0)),
        ((0.0, 0.0), (0.0, -1.0), (0.0, -0.3)),
        ((0.0, 1.0), (0.0, 0.0), (0.0, 0.6)),
    ],
)
def test_velocity_changes_within_its_limits(now, wanted, after) -> None:
    found = ramped(PlanarVelocity(*now), PlanarVelocity(*wanted), LIMITS, 0.1)
    assert (found.speed, found.turn_rate) == pytest.approx(after)


def test_the_integral_compensates_a_resistance_until_it_is_reset() -> None:
    control = AxisControl(SPEED_GAINS)
    first = control.effort(0.5, 0.4, 0.02)
    efforts = [control.effort(0.5, 0.4, 0.02) for _ in range(50)]
    assert efforts == sorted(efforts)
    assert efforts[-1] > first + 0.05
    control.reset()
    assert control.effort(0.5, 0.4, 0.02) == first


def test_control_does_not_wind_up() -> None:
    control = AxisControl(SPEED_GAINS)
    for _ in range(2000):
        assert control.effort(1.5, 0.0, 0.02) <= 1.0
    assert control.effort(0.0, 0.0, 0.02) < 1.0
    assert control.effort(-0.5, 0.0, 0.02) < 0.6


def test_control_recovers_from_saturation() -> None:
    control = AxisControl(SPEED_GAINS)
    for _ in range(100):
        control.effort(1.0, 0.7, 0.02)
    assert control.effort(1.5, 1.5, 0.02) == 1.0
    too_fast = [control.effort(1.5, 1.55, 0.02) for _ in range(1000)]
    assert too_fast[-1] < too_fast[0] - 0.1


def test_what_turned_the_robot_is_forgotten_while_it_drives_straight_on() -> None:
    """With one track on an edge it does not turn, whatever the effort: there is no error that would take it back."""
    control = VelocityControl(Chassis())
    turning, straight = PlanarVelocity(0.3, 0.4), PlanarVelocity(0.3, 0.0)
    for _ in range(200):
        control.efforts(turning, PlanarVelocity(0.3, 0.1), 0.02)
    first = control.efforts(straight, straight, 0.02).right_turn
    for _ in range(150):
        control.efforts(straight, straight, 0.02)
    assert first > 0.2
    assert control.efforts(straight, straight, 0.02).right_turn < 0.2 * first
    for _ in range(2000):  # a side slope that turns the robot is held
        control.efforts(straight, PlanarVelocity(0.3, -0.05), 0.02)
    assert control.efforts(straight, straight, 0.02).right_turn > 0.02


def test_standstill_needs_no_effort() -> None:
    assert VelocityControl(Chassis()).efforts(STANDSTILL, STANDSTILL, 0.02) == Efforts(0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("here", "there", "turn"),
    [
        (0.0, 1.0, 1.0),
        (1.0, 0.0, -1.0),
        (3.0, -3.0, math.tau - 6.0),
        (-3.0, 3.0, 6.0 - math.tau),
        (0.0, 7.0, 7.0 - math.tau),
    ],
)
def test_heading_error_takes_the_shorter_direction(here, there, turn) -> None:
    assert heading_error(here, there) == pytest.approx(turn)


def test_a_large_heading_error_turns_on_the_spot() -> None:
    assert steer_to_heading(MAX_DRIVING_ERROR + 0.01, 1.0, 1.2).speed == 0.0
    assert steer_to_heading(3.0, 1.0, 1.2).turn_rate == 1.2
    assert steer_to_heading(-3.0, 1.0, 1.2).turn_rate == -1.2
    assert steer_to_heading(0.0, -0.7, 1.2) == PlanarVelocity(-0.7, 0.0)
    assert 0.0 < steer_to_heading(0.4, 1.0, 1.2).speed < 1.0


def test_look_ahead_point_stays_on_the_leg() -> None:
    leg = Leg(PlanarPoint(0.0, 0.0), PlanarPoint(10.0, 0.0))
    assert leg.ahead(PlanarPoint(2.0, 3.0), 1.0) == PlanarPoint(pytest.approx(3.0), pytest.approx(0.0))
    assert leg.ahead(PlanarPoint(9.5, 0.1), 1.0) == PlanarPoint(pytest.approx(10.0), pytest.approx(0.0))
    assert leg.ahead(PlanarPoint(-5.0, 1.0), 1.0) == PlanarPoint(pytest.approx(1.0), pytest.approx(0.0))
    assert not leg.passed(PlanarPoint(9.9, 0.0))
    assert leg.passed(PlanarPoint(10.1, 4.0))
    nowhere = Leg(PlanarPoint(1.0, 1.0), PlanarPoint(1.0, 1.0))
    assert nowhere.ahead(PlanarPoint(0.0, 0.0), 1.0) == PlanarPoint(1.0, 1.0)


@pytest.mark.parametrize(
    ("speed", "path", "ahead"),
    [(0.1, None, 0.6), (2.0, None, 1.4), (-2.0, None, 1.4), (2.0, 0.5, 0.5), (2.0, 0.0, 0.35), (0.1, 50.0, 0.6)],
)
def test_look_ahead_depends_on_the_speed(speed, path, ahead) -> None:
    assert look_ahead(speed, path) == pytest.approx(ahead)


LEG = Leg(PlanarPoint(0.0, 0.0), PlanarPoint(10.0, 0.0))


@pytest.mark.parametrize(
    ("x", "y", "is_last", "reached"),
    [
        (9.65, 0.0, False, False),
        (9.75, 0.0, False, True),
        (9.75, 0.0, True, False),
        (10.0 - STOP_TOLERANCE + 0.01, 0.0, True, True),
        (10.01, 0.25, True, True),
        (10.01, 0.35, True, False),
        (11.0, 0.0, False, False),
    ],
)
def test_waypoint_is_reached_within_its_tolerance(x, y, is_last, reached) -> None:
    assert is_reached(CourseGoal(PlanarPoint(10.0, 0.0), is_last=is_last), LEG, PlanarPoint(x, y)) == reached


@pytest.mark.parametrize(("y", "is_last"), [(0.25, False), (-0.25, True)])
def test_a_waypoint_that_was_passed_within_the_tolerance_of_the_path_is_not_turned_back_for(y, is_last) -> None:
    goal = CourseGoal(PlanarPoint(10.0, 0.0), tolerance=0.04, path_tolerance=0.3, is_last=is_last)
    assert not is_reached(goal, LEG, PlanarPoint(9.95, y))
    assert is_reached(goal, LEG, PlanarPoint(10.05, y))
    assert not is_reached(goal, LEG, PlanarPoint(10.05, 0.4))


def course(goal: CourseGoal, speed: float = 1.0) -> WaypointCourse:
    return WaypointCourse(lambda: goal, lambda: speed, deceleration=1.5, max_turn_rate=1.2)


def test_the_last_metres_are_driven_slower() -> None:
    last, passing = (
        course(CourseGoal(PlanarPoint(10.0, 0.0))),
        course(CourseGoal(PlanarPoint(10.0, 0.0), is_last=False)),
    )
    for each in (last, passing):
        assert each.steer(Pose()) == PlanarVelocity(1.0, 0.0)
    assert last.steer(Pose(x=9.8)).speed < passing.steer(Pose(x=9.6)).speed < 1.0


def test_a_waypoint_with_a_narrow_tolerance_is_passed_slower() -> None:
    narrow, usual = (
        course(CourseGoal(PlanarPoint(10.0, 0.0), tolerance=tolerance, is_last=False)) for tolerance in (0.04, 0.2)
    )
    for each in (narrow, usual):
        each.steer(Pose())
    assert narrow.steer(Pose(x=9.9)).speed < 0.7 * usual.steer(Pose(x=9.7)).speed


def test_a_robot_beside_the_end_of_its_leg_does_not_turn_towards_it_when_it_drives_on() -> None:
    turns = []
    for path_tolerance in (None, 0.3):
        goal = CourseGoal(PlanarPoint(10.0, 0.0), tolerance=0.04, path_tolerance=path_tolerance, is_last=False)
        each = course(goal)
        each.steer(Pose())
        turns.append(abs(each.steer(Pose(x=9.9, y=0.12)).turn_rate))
    assert turns[0] > 1.0
    assert turns[1] < 0.7


def test_a_leg_begins_at_the_waypoint_before() -> None:
    goal = CourseGoal(PlanarPoint(10.0, 0.0), path_tolerance=0.3)
    along, straight = (
        WaypointCourse(lambda: goal, lambda: 1.0, deceleration=1.5, max_turn_rate=1.2, start=start)
        for start in (lambda: PlanarPoint(0.0, 0.0), None)
    )
    beside = Pose(x=0.0, y=0.2)
    assert abs(along.steer(beside).turn_rate) > 5.0 * abs(straight.steer(beside).turn_rate), "back to the line"


def test_with_a_narrow_path_tolerance_a_robot_turns_onto_its_leg_before_it_drives() -> None:
    aside = {}
    for path_tolerance in (0.12, 0.3):
        goal = CourseGoal(PlanarPoint(0.0, 5.0), path_tolerance=path_tolerance)
        drive = course(goal, speed=0.5)
        pose, farthest = Pose(), 0.0
        for _ in range(300):
            wanted = drive.steer(pose)
            assert wanted is not None
            yaw = pose.yaw + 0.02 * wanted.turn_rate
            x, y = (pose.x + 0.02 * wanted.speed * math.cos(yaw), pose.y + 0.02 * wanted.speed * math.sin(yaw))
            pose, farthest = Pose(x=x, y=y, yaw=yaw), max(farthest, x)
        aside[path_tolerance] = farthest
        assert pose.y > 1.5
    assert aside[0.12] < 0.03
    assert aside[0.3] > 0.06, "it drives on in a curve"


def test_zero_speed_waits_even_at_the_goal() -> None:
    assert course(CourseGoal(PlanarPoint(0.0, 0.0)), speed=0.0).steer(Pose()) == STANDSTILL


def test_reached_waypoint_controls_the_heading_only() -> None:
    there = course(CourseGoal(PlanarPoint(0.0, 0.0), heading=1.0))
    assert there.steer(Pose()) == PlanarVelocity(0.0, 1.2)
    assert there.steer(Pose(x=0.5, yaw=0.9)).speed == 0.0, "turning on the spot drifts; it does not go back for that"
    assert there.steer(Pose(yaw=0.99)) is None


def test_driving_backward_steers_the_rear_to_the_goal() -> None:
    back = course(CourseGoal(PlanarPoint(-5.0, 0.0)), speed=-0.5)
    assert back.steer(Pose()) == PlanarVelocity(-0.5, pytest.approx(0.0, abs=1e-9))


def test_a_vector_stops_turning_at_its_heading_and_a_velocity_is_constant() -> None:
    stand = VectorCourse(lambda: 1.0, 0.0, 1.2)
    assert stand.steer(Pose(yaw=0.5)).turn_rate > 0.5
    assert stand.steer(Pose(yaw=0.99)) == STANDSTILL
    assert VelocityCourse(PlanarVelocity(0.3, 0.1), LIMITS).steer(Pose(yaw=9.0)) == PlanarVelocity(0.3, 0.1)
