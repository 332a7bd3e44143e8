"""A robot whose link is cut around a corner, on the virtual network: it comes back to where the link was good."""

from __future__ import annotations

import asyncio
import math

import pytest

from jauspy.errors import ConfigError, ControlRejected, RequestError
from jauspy.messages.core import QueryHeartbeatPulse, SetEmergency
from jauspy.ocu import OCU, Robot, WayBack
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork, until

ROBOT = "101.1.102"
CORNER = 3.0
"""Metres; behind it the link is bad."""


def x(robot: RobotRunner) -> float:
    assert robot.snapshot is not None
    return robot.snapshot.pose.x


def y(robot: RobotRunner) -> float:
    assert robot.snapshot is not None
    return robot.snapshot.pose.y


def stands(robot: RobotRunner) -> bool:
    assert robot.snapshot is not None
    twist = robot.snapshot.twist
    return max(abs(twist.vx), abs(twist.wz)) < 0.02


async def around_the_corner(inc1: Robot) -> None:
    """Drive along x, turn to the left, and on along y."""
    await inc1.drive(linear=0.5, seconds=6.0)
    await inc1.drive(angular=0.6, seconds=2.6)
    await inc1.drive(linear=0.5)


@pytest.fixture
async def network(virtual_network: VirtualNetwork) -> VirtualNetwork:
    return virtual_network


@pytest.mark.slow
async def test_it_drives_back_to_where_the_link_is_good(network: VirtualNetwork) -> None:
    """The link works again as soon as the robot is back at the corner, where it stops."""
    async with network.robot() as robot, network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive") as control:
            await inc1.comms_lost.set("retrotraverse", timeout=8, distance=50.0)
            await around_the_corner(inc1)
            await until(lambda: y(robot) > 2.0, within=20)
            network.disconnect(ocu.id)
            cut_at = x(robot), y(robot)
            await control.until_lost()
            await until(lambda: stands(robot), within=5)
            farthest = math.dist(cut_at, (x(robot), y(robot)))
            assert farthest < 3.0
            await until(lambda: y(robot) < 0.2, within=40)
            network.reconnect(ocu.id)
            await ocu.query(ROBOT, QueryHeartbeatPulse())
            here = x(robot), y(robot)
            await until(lambda: stands(robot), within=1)
            assert math.dist(here, (x(robot), y(robot))) < 0.15
            assert x(robot) > CORNER - 0.8
        stopped = x(robot)
        await asyncio.sleep(30.0)
        assert x(robot) == pytest.approx(stopped, abs=0.02)


@pytest.mark.slow
async def test_it_stops_after_the_distance_and_control_returns(network: VirtualNetwork) -> None:
    async with network.robot() as robot, network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive") as control:
            await inc1.comms_lost.set("retrotraverse", timeout=6, distance=1.0)
            await around_the_corner(inc1)
            await until(lambda: y(robot) > 2.0, within=20)
            network.disconnect(ocu.id)
            await control.until_lost()
            await until(lambda: robot_silent(robot), within=10)
            await until(lambda: stands(robot), within=3)
            lost_at = y(robot)
            await asyncio.sleep(20.0)
            assert stands(robot)
            assert lost_at - y(robot) == pytest.approx(1.0, abs=0.2)
            network.reconnect(ocu.id)
        async with inc1.control("drive"):
            assert await inc1.comms_lost.status() == "enabled"
            assert (await inc1.comms_lost.read()).reaction == "retrotraverse"
            before = y(robot)
            await inc1.retrotraverse(1.0)
            assert before - y(robot) == pytest.approx(1.0, abs=0.2)


def robot_silent(robot: RobotRunner) -> bool:
    host = next(component.host for component in robot.components if str(component.id) == ROBOT)
    return host.controller is None


@pytest.mark.slow
async def test_control_taken_by_another_ocu_stops_the_way_back(network: VirtualNetwork) -> None:
    async with network.robot() as robot, network.ocu() as ocu, network.ocu("43.1.1") as other:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive") as control:
            await inc1.comms_lost.set("retrotraverse", timeout=6, distance=50.0, regained="continue")
            await inc1.drive(linear=0.5, seconds=6.0)
            network.disconnect(ocu.id)
            await control.until_lost()
            await until(lambda: x(robot) < 2.3, within=20)
            assert not stands(robot)
            again = await other.robot(101)
            async with again.control("drive"):
                await until(lambda: stands(robot), within=1)
                stopped = x(robot)
                await asyncio.sleep(3.0)
                assert x(robot) == pytest.approx(stopped, abs=0.02)
                assert (await again.comms_lost.read()).reaction == "stop"
                await again.drive(linear=0.3, seconds=2.0)
                assert x(robot) > stopped + 0.2
            network.reconnect(ocu.id)


@pytest.mark.slow
async def test_bad_link_is_no_lost_link(network: VirtualNetwork) -> None:
    async with network.robot() as robot, network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive"):
            await inc1.comms_lost.set("retrotraverse", timeout=8, distance=50.0)
            await inc1.drive(linear=0.5, seconds=4.0)
            network.loss = 0.2
            await until(lambda: stands(robot), within=2)
            stopped = x(robot)
            await asyncio.sleep(25.0)
            assert x(robot) == pytest.approx(stopped, abs=0.02)
            network.loss = 0.0


@pytest.mark.slow
async def test_verbs_say_what_is_wrong(network: VirtualNetwork) -> None:
    async with network.robot(), network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        assert await inc1.comms_lost.supported() == ("stop", "continue", "move_to", "retrotraverse")
        assert await inc1.comms_lost.status() == "disabled"
        with pytest.raises(ControlRejected, match="take control first"):
            await inc1.comms_lost.set("stop")
        for point in (5, "5", (1.0, 2.0, 3.0)):
            with pytest.raises(TypeError, match="point is latitude and longitude"):
                await inc1.comms_lost.set("move_to", speed=1.0, point=point)  # type: ignore[arg-type]
        async with inc1.control("drive"):
            for arguments, text in (
                ({"reaction": "dance"}, "reactions are stop, continue, move_to, retrotraverse"),
                ({"reaction": "stop", "distance": 1.0}, "has no distance"),
                ({"reaction": "retrotraverse"}, "needs a distance"),
                ({"reaction": "move_to", "speed": 1.0}, "needs a point"),
                ({"reaction": "move_to", "speed": 1.0, "point": (91.0, 0.0)}, "latitude 91"),
                ({"reaction": "stop", "timeout": 2}, "too short"),
                ({"reaction": "stop", "timeout": 70000}, r"0\.\.65535"),
                ({"reaction": "retrotraverse", "distance": -1.0}, "distance=-1"),
                ({"reaction": "stop", "regained": "x"}, "neither"),
            ):
                with pytest.raises(ConfigError, match=text):
                    await inc1.comms_lost.set(**arguments)  # type: ignore[arg-type]
            with pytest.raises(RequestError, match="refuses the reaction 'move_to'"):
                await inc1.comms_lost.set("move_to", point=(-38.0, 100.0), speed=1.0)
            await inc1.comms_lost.set("move_to", point=(38.593, -77.179), speed=0.5, distance=20.0)
            found = await inc1.comms_lost.read()
            assert (found.reaction, found.timeout) == ("move_to", 0)
            assert found.point == pytest.approx((38.593, -77.179), abs=1e-5)
            with pytest.raises(ConfigError, match="needs a distance"):
                await inc1.retrotraverse()
            with pytest.raises(RequestError, match="perhaps it has no path"):
                await inc1.retrotraverse(5.0)  # it has not driven yet
            for reaction in ("continue", "stop"):
                await inc1.comms_lost.set(reaction)
                assert (await inc1.comms_lost.read()).reaction == reaction


@pytest.mark.slow
async def test_retrotraverse_shows_its_progress_and_stops_when_cancelled(network: VirtualNetwork) -> None:
    async with network.robot() as robot, network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive"):
            await inc1.drive(linear=0.5, seconds=8.0)
            seen: list[float] = []
            task = asyncio.create_task(inc1.retrotraverse(50.0, speed=0.4, progress=seen.append))
            await until(lambda: x(robot) < 2.5, within=20)
            task.cancel()
            await asyncio.wait({task})
            await until(lambda: stands(robot), within=2)
            assert x(robot) > 1.5
            assert seen == sorted(seen)
            assert seen
            left = x(robot)
            way = await inc1.retrotraverse(50.0, nose_first=True)
            assert abs(x(robot)) < 0.2
            assert way == WayBack(pytest.approx(left, abs=0.2), "path")  # of 50 m it has kept so much


@pytest.mark.slow
async def test_retrotraverse_tells_how_far_it_drove_and_why_it_ended(network: VirtualNetwork) -> None:
    async with network.robot(), network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive"):
            await inc1.drive(linear=0.5, seconds=8.0)
            assert await inc1.retrotraverse(1.0) == WayBack(pytest.approx(1.0, abs=0.01), "distance")
            way = await inc1.retrotraverse(50.0, standoff=1.0)
            assert way.ended_by == "path"
            assert way.distance < 3.5
            await inc1.drive(linear=0.5, seconds=4.0)
            task = asyncio.create_task(inc1.retrotraverse(1.5, speed=0.3))
            await asyncio.sleep(2.0)
            await ocu.send(ROBOT, SetEmergency(1), ack=True)
            with pytest.raises(RequestError, match=r"it had driven 0\.\d m back"):
                await task


@pytest.mark.slow
async def test_another_retrotraverse_replaces_the_first(network: VirtualNetwork) -> None:
    async with network.robot() as robot, network.ocu() as ocu:
        inc1 = await ocu.robot(101)
        async with inc1.control("drive"):
            await inc1.drive(linear=0.5, seconds=8.0)
            first = asyncio.create_task(inc1.retrotraverse(50.0, speed=0.1))
            await until(lambda: x(robot) < 3.5, within=20)
            await inc1.retrotraverse(50.0, speed=0.4)
            with pytest.raises(RequestError, match="did not carry out StartRetrotraverse"):
                await first
            assert abs(x(robot)) < 0.2


@pytest.mark.slow
async def test_offline_ocu_is_told(network: VirtualNetwork) -> None:
    """The reaction is in the log of the robot, and in the status that any client reads."""
    async with network.robot(), network.ocu() as ocu, OCU("44.1.1", transport=network.transport("44.1.1")) as watcher:
        inc1, seen = await ocu.robot(101), await watcher.robot(101)
        async with inc1.control("drive") as control:
            network.disconnect(ocu.id)
            await control.until_lost()
            await asyncio.sleep(2.0)
            assert await seen.comms_lost.status() == "active"
            network.reconnect(ocu.id)
