"""Waypoint lists with directions and waits (IOP): the pose of the robot says how it drove, on every backend."""

from __future__ import annotations

import math

import pytest
from tests.robot.world import CLIENT, OTHER, World

from jauspy.messages.core import DeleteElement, QueryElementList, SetEmergency
from jauspy.messages.iop import (
    QueryEnhancedGlobalWaypointInformation,
    QueryEnhancedLocalWaypointInformation,
    QueryGlobalWaypointStatus,
    QueryLocalWaypointStatus,
    ReportLocalWaypointStatus,
    SetEnhancedGlobalWaypointInformation,
    SetEnhancedLocalWaypointInformation,
)
from jauspy.messages.mobility import ExecuteList, SetGlobalWaypoint, SetLocalWaypoint

Status = ReportLocalWaypointStatus.WaypointStatus
Record = SetEnhancedLocalWaypointInformation.WaypointInformationRec
BOTH = 0b11


def status(world: World) -> Status:
    return Status(world.ask(QueryLocalWaypointStatus()).waypoint_status)


def add(world: World, *entries: tuple) -> None:
    world.tell(SetEnhancedLocalWaypointInformation([Record(*entry) for entry in entries]))


def waypoints(world: World, *points: tuple[float, float]) -> None:
    world.set_list(SetLocalWaypoint(x=x, y=y) for x, y in points)


@pytest.mark.slow
def test_it_drives_there_forward_and_back_in_reverse(world: World) -> None:
    waypoints(world, (2.0, 0.0), (0.0, 0.0))
    add(world, (1, 0), (2, 1))
    headings: list[float] = []
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    world.run_until(lambda: world.active == 2, 20.0)
    assert world.distance(2.0, 0.0) < 0.2
    world.run_until(lambda: world.active == 0, 20.0, lambda: headings.append(world.pose.yaw))
    assert world.distance(0.0, 0.0) < 0.2
    assert max(map(abs, headings)) < 0.5, "it never turns round"
    assert status(world) is Status.COMPLETE


@pytest.mark.slow
def test_without_a_direction_it_turns_round(world: World) -> None:
    waypoints(world, (2.0, 0.0), (0.0, 0.0))
    headings: list[float] = []
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    world.run_until(lambda: world.active == 0, 30.0, lambda: headings.append(world.pose.yaw))
    assert max(map(abs, headings)) > 2.5


@pytest.mark.slow
def test_it_waits_and_tells_for_how_long(world: World) -> None:
    waypoints(world, (1.0, 0.0), (2.0, 0.0))
    add(world, (1, None, 5.0))
    assert status(world) is Status.PLAN_LOADED
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    assert status(world) is Status.EXECUTING
    world.run_until(lambda: status(world) is Status.TIMED_WAIT, 20.0)
    world.run(3.0)
    assert world.active == 1
    assert world.stands()
    assert world.distance(1.0, 0.0) < 0.2
    assert world.ask(QueryLocalWaypointStatus()).suspended_time in (2, 3)
    world.run_until(lambda: world.active == 2, 3.0)
    assert world.ask(QueryLocalWaypointStatus()).suspended_time == 0
    world.run_until(lambda: world.active == 0, 20.0)
    assert status(world) is Status.COMPLETE


@pytest.mark.slow
def test_it_waits_for_the_next_execute_command(world: World) -> None:
    waypoints(world, (1.0, 0.0), (2.0, 0.0))
    add(world, (1, None, 0.0), (2, None, 0.0))
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    world.run_until(lambda: status(world) is Status.PAUSED, 20.0)
    world.run(10.0)
    assert (world.active, world.stands()) == (1, True)
    world.tell(ExecuteList(speed=0.8))
    world.run_until(lambda: world.active == 2 and status(world) is Status.PAUSED, 20.0)
    assert world.distance(2.0, 0.0) < 0.2
    world.tell(ExecuteList(speed=0.8, element_uid=2))
    world.run_until(lambda: world.active == 0, 5.0)
    assert status(world) is Status.COMPLETE


def test_speed_zero_pauses_and_an_emergency_ends_a_wait(world: World) -> None:
    waypoints(world, (3.0, 0.0))
    add(world, (1, None, 100.0))
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    world.run(1.0)
    world.tell(ExecuteList(speed=0.0))
    assert status(world) is Status.PAUSED
    world.tell(ExecuteList(speed=0.8))
    world.run_until(lambda: status(world) is Status.TIMED_WAIT, 20.0)
    world.tell(SetEmergency(1))
    assert status(world) is Status.PLAN_LOADED
    assert world.ask(QueryLocalWaypointStatus()).suspended_time == 0


def test_information_is_reported_masked_and_forgotten_with_its_element(world: World) -> None:
    add(world, (2, 1, 7.0))
    waypoints(world, (1.0, 0.0), (2.0, 0.0))
    add(world, (1, 0))
    (first, second) = world.ask(QueryEnhancedLocalWaypointInformation(BOTH)).waypoint_information_list
    assert (first.element_uid, first.direction_of_travel, first.wait_time) == (1, 0, None)
    assert (second.element_uid, second.direction_of_travel, second.wait_time) == (2, 1, pytest.approx(7.0, abs=0.06))
    (_, second) = world.ask(QueryEnhancedLocalWaypointInformation(0b10)).waypoint_information_list
    assert second.direction_of_travel is None
    world.tell(DeleteElement(DeleteElement.RequestIDRec(1), [DeleteElement.DeleteElementRec(2)]))
    world.set_list([SetLocalWaypoint(x=1.0, y=0.0), SetLocalWaypoint(x=5.0, y=0.0)])
    listed = world.ask(QueryEnhancedLocalWaypointInformation(BOTH)).waypoint_information_list
    assert [record.element_uid for record in listed] == [1]


def test_hostile_information_is_bounded_and_counted(world: World) -> None:
    waypoints(world, (1.0, 0.0))
    world.tell(SetEnhancedLocalWaypointInformation([Record(1, 1)]), client=OTHER)
    add(world, (0, 1), (65535, 1))
    undefined = SetEnhancedLocalWaypointInformation([Record(1, 1)]).encode()[:-1] + bytes([77])
    world.host.receive(undefined, CLIENT, world.now)
    assert world.ask(QueryEnhancedLocalWaypointInformation(BOTH)).waypoint_information_list == []
    for start in range(2, 3000, 200):
        add(world, *((uid, 1) for uid in range(start, start + 200)))
    add(world, (60_000, 1))
    assert world.host.counters["waypoint_information_refused"] == 2 + 3000 - 1024 + 1
    assert [element.element_uid for element in world.ask(QueryElementList()).element_list] == [1]
    assert CLIENT != OTHER


@pytest.mark.slow
def test_global_waypoints_have_their_own_messages(world: World) -> None:
    east = 38.593, -77.179
    world.set_list([SetGlobalWaypoint(latitude=east[0] + 2 * 9e-6, longitude=east[1])])
    assert status(world) is Status.NO_PLAN
    world.tell(
        SetEnhancedGlobalWaypointInformation([SetEnhancedGlobalWaypointInformation.WaypointInformationRec(1, 1)])
    )
    (record,) = world.ask(QueryEnhancedGlobalWaypointInformation(BOTH)).waypoint_information_list
    assert record.direction_of_travel == 1
    world.tell(ExecuteList(speed=0.8, element_uid=1))
    assert world.ask(QueryGlobalWaypointStatus()).waypoint_status == Status.EXECUTING
    world.run_until(lambda: world.active == 0, 30.0)
    assert world.ask(QueryGlobalWaypointStatus()).waypoint_status == Status.COMPLETE
    assert abs(math.remainder(world.pose.yaw - math.pi, math.tau)) < 0.5, "it went north with its rear ahead"
