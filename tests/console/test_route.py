"""The waypoints of a robot: what it holds, how far it is, and commands."""

from __future__ import annotations

import asyncio
import math

import pytest

from jauspy.console.conventions import Conventions
from jauspy.console.panels.world import progress_of, state_of
from jauspy.console.route import MAX_WAYPOINTS, Route, Waypoint, waypoint_of
from jauspy.errors import ConfigError, JausError
from jauspy.messages.mobility import SetGlobalWaypoint, SetLocalWaypoint
from jauspy.ocu.robot import Robot
from jauspy.ocu.state import RobotPose
from jauspy.ocu.subsystems import SubsystemInfo
from jauspy.testing import VirtualNetwork


def test_a_waypoint_keeps_what_it_does_not_change() -> None:
    moved = waypoint_of(SetLocalWaypoint(x=1.0, y=-2.0, waypoint_tolerance=0.3, yaw=0.5)).moved(4.0, 5.0)
    message = moved.message()
    assert isinstance(message, SetLocalWaypoint)
    assert (message.x, message.y) == pytest.approx((4.0, -5.0), abs=1e-3)
    assert (message.waypoint_tolerance, message.yaw) == pytest.approx((0.3, 0.5), abs=1e-2)
    other = waypoint_of(SetGlobalWaypoint(latitude=1.0, longitude=2.0))
    assert (other.is_point, other.moved(1.0, 1.0), other.message()) == (False, other, other.element)
    assert waypoint_of(b"data").message() == b"data"


async def arrive(route: Route, index: int | None) -> None:
    while route.active != index:
        await asyncio.sleep(0.1)
        await route.look()


@pytest.mark.slow
async def test_a_list_is_sent_carried_out_paused_and_cleared(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        pose = RobotPose()
        route = Route(ocu, lambda: robot, lambda: pose)
        await route.look()
        assert (route.is_offered, route.waypoints, route.active, route.problem) == (True, (), None, "")
        with pytest.raises(JausError):
            await route.start([Waypoint(1.0, 0.0)], 0.5)
        async with robot.control():
            with pytest.raises(ConfigError, match="no waypoint"):
                await route.start(None, 0.5)
            await route.start([Waypoint(1.0, 0.2), Waypoint(2.0, 0.0)], 0.5)
            assert [(round(each.x, 2), round(each.y, 2)) for each in route.waypoints] == [(1.0, 0.2), (2.0, 0.0)]
            assert (route.active, route.speed, route.is_paused) == (0, pytest.approx(0.5, abs=0.01), False)
            assert state_of(0, route, is_draft=False) == "active"
            await route.set_speed(0.0)
            assert route.is_paused
            assert state_of(0, route, is_draft=False) == "waits"
            assert (
                progress_of(route, RobotPose(), Conventions())[0] == "waits on the way to waypoint 1 of 2: 1.0 m left"
            )
            await route.set_speed(0.8)
            await arrive(route, 1)
            text, part = progress_of(route, RobotPose(x=1.5, y=0.1), Conventions())
            assert (text, 0.5 < part < 1.0) == ("drives to waypoint 2 of 2: 0.5 m left", True)
            pose = RobotPose(x=2.0)
            await arrive(route, None)
            assert progress_of(route, None, Conventions()) == ("ended at waypoint 2 of 2", 1.0)
            assert state_of(1, route, is_draft=False) == "reached"
            assert math.dist(((end := await robot.pose()).x, end.y), (2.0, 0.0)) < 0.2
            await route.clear()
            assert (route.waypoints, route.ended_at) == ((), -1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("pose", "text"),
    [
        (RobotPose(x=2.0, y=0.09), "ended at waypoint 2 of 2"),  # the last leg was shorter than the time between looks
        (RobotPose(x=0.95, y=0.2), "ended at waypoint 1 of 2"),
        (RobotPose(x=0.2, y=0.1), "ended on the way to waypoint 1 of 2"),
        (None, "ended at waypoint 1 of 2"),
    ],
)
async def test_the_end_is_where_the_robot_stands(
    virtual_network: VirtualNetwork, pose: RobotPose | None, text: str
) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        route = Route(ocu, lambda: robot, lambda: pose)
        async with robot.control():
            await route.start([Waypoint(1.0, 0.2), Waypoint(2.0, 0.0)], 0.5)
            await robot.stop()
            await arrive(route, None)
            assert progress_of(route, pose, Conventions())[0] == text


@pytest.mark.slow
async def test_what_another_client_changes_is_seen_and_what_is_missing_said(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu, virtual_network.ocu("42.1.2") as other:
        robot = await ocu.discover(101)
        route = Route(ocu, lambda: robot)
        theirs = await other.discover(101)
        async with theirs.control():
            waypoints = theirs.service("mobility:LocalWaypointListDriver").waypoints
            await waypoints.upload([SetLocalWaypoint(x=3.0, y=1.0)])
            await route.look()
            assert [(each.x, round(each.y, 2)) for each in route.waypoints] == [(pytest.approx(3.0, abs=1e-3), -1.0)]
            await waypoints.replace(0, SetLocalWaypoint(x=4.0, y=1.0))
            await asyncio.sleep(6.0)
            await route.look()
            assert route.waypoints[0].x == pytest.approx(4.0, abs=1e-3)
            await asyncio.sleep(1.0)
            await waypoints.upload([SetLocalWaypoint(x=3.0, y=1.0)] * (MAX_WAYPOINTS + 1))
            await route.look()
            assert "can be shown" in route.problem
    bare = Route(ocu, lambda: Robot(ocu._connection, SubsystemInfo(7, "bare")))
    await bare.look()
    assert (bare.is_offered, bare.waypoints) == (False, ())
