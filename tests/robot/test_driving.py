"""Velocities, vectors and efforts on every backend, and how one driver takes over from another."""

from __future__ import annotations

import math

import pytest
from tests.helpers.sampling import sampled
from tests.robot.world import OTHER, World

from jauspy.messages.core import ClearEmergency, RequestControl, SetEmergency, Standby
from jauspy.messages.mobility import (
    ExecuteList,
    QueryAccelerationState,
    QueryGlobalVector,
    QueryLocalVector,
    QueryTravelSpeed,
    QueryVelocityCommand,
    QueryWrenchEffort,
    SetAccelerationLimit,
    SetGlobalVector,
    SetLocalPose,
    SetLocalVector,
    SetLocalVectorExt,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetVelocityCommand,
    SetWrenchEffort,
    Speed,
)

CURRENT, MAX, MIN, DEFAULT = SetVelocityCommand.CommandType
ALL = 0xFF


def drive(speed: float, yaw_rate: float = 0.0) -> SetVelocityCommand:
    return SetVelocityCommand(command_type=CURRENT, velocity_x=speed, yaw_rate=yaw_rate)


def current(world: World) -> SetVelocityCommand:
    return world.ask(QueryVelocityCommand(ALL, CURRENT))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("speed", "yaw_rate"),
    sampled([(0.5, 0.0), (-0.5, 0.0), (0.0, 0.5), (0.2, 0.0), (0.6, 0.4), (0.0, -0.3), (1.45, 0.0)], 3, several=True),
)
def test_velocities_are_reached_and_held(world: World, speed: float, yaw_rate: float) -> None:
    world.tell(drive(speed, yaw_rate))
    world.run(4.0)
    samples: list[tuple[float, float]] = []
    world.run(2.0, lambda: samples.append((world.velocity.velocity_x, world.velocity.yaw_rate)))
    assert sum(x for x, _ in samples) / len(samples) == pytest.approx(speed, abs=0.02)
    assert sum(w for _, w in samples) / len(samples) == pytest.approx(yaw_rate, abs=0.03)
    assert max(abs(w - yaw_rate) for _, w in samples) < 0.2, "tracks that slip shake a little"


@pytest.mark.slow
def test_acceleration_is_limited_and_measured(world: World) -> None:
    kinds = SetAccelerationLimit.CommandType
    world.tell(SetAccelerationLimit(command_type=kinds.MAX_ACCELERATION, acceleration_x=0.4), drive(1.2))
    world.run(1.0)
    assert world.velocity.velocity_x == pytest.approx(0.4, abs=0.08)
    measured: list[float] = []
    world.run(1.0, lambda: measured.append(world.ask(QueryAccelerationState(0xFFFF)).acceleration_x))
    assert sum(measured) / len(measured) == pytest.approx(0.4, abs=0.05)
    world.run(2.0)
    assert world.velocity.velocity_x == pytest.approx(1.2, abs=0.05)
    world.tell(SetAccelerationLimit(command_type=kinds.MAX_DECELERATION, acceleration_x=-0.5), drive(0.2))
    world.run(1.0)
    assert world.velocity.velocity_x == pytest.approx(0.7, abs=0.1)


@pytest.mark.slow
def test_turning_while_driving_causes_lateral_acceleration(world: World) -> None:
    world.tell(drive(1.0, 0.4))
    world.run(4.0)
    measured: list[float] = []
    world.run(1.0, lambda: measured.append(world.ask(QueryAccelerationState(0xFFFF)).acceleration_y))
    assert sum(measured) / len(measured) == pytest.approx(0.4, abs=0.1), "to the right, towards the centre"


@pytest.mark.slow
def test_vector_heading_is_reached_and_held(world: World) -> None:
    world.tell(SetLocalVector(speed=0.8, heading=math.pi / 2))
    world.run(0.5)
    assert math.hypot(world.pose.x, world.pose.y) < 0.1, "on the spot first"
    world.run(6.0)
    assert world.pose.yaw == pytest.approx(math.pi / 2, abs=0.05)
    assert world.velocity.velocity_x == pytest.approx(0.8, abs=0.05)
    assert abs(world.pose.x) < 0.4
    assert world.pose.y > 2.0
    report = world.ask(QueryLocalVector(ALL))
    assert (report.speed, report.heading, report.z) == (
        pytest.approx(0.8, abs=0.01),
        pytest.approx(math.pi / 2, abs=1e-3),
        None,
    )


@pytest.mark.slow
def test_vector_follows_a_change_of_its_frame(world: World) -> None:
    world.tell(SetLocalVector(speed=0.5, heading=0.0))
    world.run(2.0)
    world.tell(SetLocalPose(yaw=1.0))
    world.run(5.0)
    assert world.pose.yaw == pytest.approx(0.0, abs=0.05)
    assert world.vehicle.pose.yaw == pytest.approx(-1.0, abs=0.05)


@pytest.mark.slow
def test_vector_without_heading_keeps_the_present_heading(world: World) -> None:
    world.tell(SetLocalVector(speed=0.0, heading=0.7))
    world.run(4.0)
    assert world.stands()
    world.tell(SetLocalVector(speed=0.5))
    world.run(3.0)
    assert world.pose.yaw == pytest.approx(0.7, abs=0.06)
    assert world.velocity.velocity_x == pytest.approx(0.5, abs=0.05)


@pytest.mark.slow
def test_vector_with_negative_speed_drives_backward(world: World) -> None:
    world.tell(SetLocalVectorExt(speed=Speed(Speed.Choice.SPEED_OVER_GROUND, -0.5), course=0.3))
    world.run(4.0)
    assert world.pose.yaw == pytest.approx(0.3, abs=0.05)
    assert world.velocity.velocity_x == pytest.approx(-0.5, abs=0.05)


@pytest.mark.slow
def test_global_vector_refers_to_true_north(world: World) -> None:
    world.tell(SetGlobalVector(speed=0.5, heading=0.0))
    world.run(6.0)
    assert world.place.yaw == pytest.approx(0.0, abs=0.05)
    assert world.place.latitude > 38.593 + 1e-5
    assert world.ask(QueryGlobalVector(ALL)).heading == pytest.approx(0.0, abs=1e-3)


# --- one driver after another -----------------------------------------------------------------------------------------


@pytest.mark.slow
def test_newest_command_preempts_earlier_ones(world: World) -> None:
    world.set_list([SetLocalWaypoint(x=30.0, y=0.0)])
    world.tell(ExecuteList(speed=1.0, element_uid=1))
    world.run(3.0)
    world.tell(drive(0.6))
    assert (world.active, world.ask(QueryTravelSpeed()).speed) == (0, 0.0)
    slowest: list[float] = []
    world.run(2.0, lambda: slowest.append(world.velocity.velocity_x))
    assert min(slowest) > 0.5, "it goes over to the new speed without a stop"
    world.tell(SetLocalVector(speed=0.4, heading=0.0))
    assert current(world).velocity_x == pytest.approx(0.0, abs=1e-3)
    world.run(2.0)
    assert world.velocity.velocity_x == pytest.approx(0.4, abs=0.05)
    world.tell(SetWrenchEffort(propulsive_linear_effort_x=60.0))
    assert world.ask(QueryLocalVector(ALL)).speed == 0.0
    world.run(2.0)
    assert world.velocity.velocity_x > 0.8
    world.tell(SetLocalWaypoint(x=20.0, y=0.0))
    assert world.ask(QueryWrenchEffort(ALL)).propulsive_linear_effort_x == pytest.approx(60.0, abs=0.01)
    world.tell(SetTravelSpeed(speed=0.5))
    assert world.ask(QueryWrenchEffort(ALL)).propulsive_linear_effort_x == pytest.approx(0.0, abs=0.01)
    world.run(2.0)
    assert world.velocity.velocity_x == pytest.approx(0.5, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize(
    "command",
    [drive(1.0), SetLocalVector(speed=1.0, heading=0.0), SetWrenchEffort(propulsive_linear_effort_x=60.0)],
    ids=lambda each: type(each).__name__,
)
def test_emergency_stops_and_motion_does_not_resume(world: World, command) -> None:
    world.tell(command)
    world.run(3.0)
    x = world.pose.x
    world.tell(SetEmergency(1), client=OTHER)
    world.run(0.8)
    assert world.stands()
    assert world.pose.x - x < 0.4
    world.tell(ClearEmergency(1), client=OTHER)
    world.run(1.0)
    assert world.stands()
    world.tell(drive(0.5))
    world.run(2.0)
    assert world.velocity.velocity_x == pytest.approx(0.5, abs=0.05)


@pytest.mark.slow
def test_next_client_inherits_no_motion(world: World) -> None:
    world.tell(
        SetVelocityCommand(command_type=MAX, velocity_x=0.3), SetVelocityCommand(command_type=DEFAULT, velocity_x=0.2)
    )
    world.tell(RequestControl(255), client=OTHER)
    assert world.ask(QueryVelocityCommand(ALL, MAX)).velocity_x == pytest.approx(0.95 * 1.9, abs=1e-3)
    assert world.ask(QueryVelocityCommand(ALL, DEFAULT)).velocity_x == pytest.approx(0.0, abs=1e-3)


def test_default_velocity_causes_no_motion(world: World) -> None:
    world.tell(SetVelocityCommand(command_type=DEFAULT, velocity_x=0.4), drive(0.8))
    world.run(1.0)
    world.tell(Standby())
    world.run(1.0)
    assert world.stands()
    assert current(world).velocity_x == pytest.approx(0.4, abs=1e-3)


@pytest.mark.slow
def test_the_same_commands_give_the_same_trajectory_bit_for_bit(world: World) -> None:
    def trajectory() -> list[object]:
        fresh = World(world.backend)
        fresh.take_control()
        fresh.tell(SetLocalWaypoint(x=2.0, y=1.0), SetTravelSpeed(speed=1.0))
        poses: list[object] = []
        fresh.run(3.0, lambda: poses.append(fresh.robot.drive.pose()))
        return poses

    assert trajectory() == trajectory()
