"""Lists of waypoints with the real drivers: the robot goes where it is sent, one after the other."""

from __future__ import annotations

import asyncio
import math

import pytest

from jauspy.messages.manipulator import JointPositionRec, QueryJointPositions, SetJointPositions
from jauspy.messages.mobility import QueryGlobalPose, SetGlobalWaypoint, SetLocalWaypoint

SQUARE = ((4.0, 0.0), (4.0, 3.0), (1.0, 4.0), (0.0, 1.0))


async def drive(robot, driver) -> list[tuple[float, float]]:
    """Where the robot was when each element but the first began, and when the list was over: JAUS's x and y."""

    def place() -> tuple[float, float]:
        return (robot.snapshot.pose.x, -robot.snapshot.pose.y)

    async with asyncio.timeout(600):
        await driver.waypoints.execute(speed=1.0)
        reached = [place() async for _ in driver.waypoints.progress()]
    return [*reached[1:], place()]


@pytest.mark.slow
@pytest.mark.parametrize("loss", [0.0, pytest.param(0.1, marks=pytest.mark.slow)])
async def test_four_local_waypoints_in_order(virtual_network, robot, ocu, loss):
    virtual_network.loss = loss
    virtual_network.delay = 0.05
    driver = (await ocu.discover(101)).service("LocalWaypointListDriver")
    async with driver.control():
        await driver.resume()
        await driver.waypoints.upload(SetLocalWaypoint(x=x, y=y, waypoint_tolerance=0.3) for x, y in SQUARE)
        reached = await drive(robot, driver)
    assert len(reached) == len(SQUARE)
    assert all(math.dist(*pair) < 0.5 for pair in zip(reached, SQUARE, strict=True)), reached


@pytest.mark.parametrize("begun", [0.02, 0.1, 0.14, 0.2, 0.3, 0.5])
async def test_a_course_that_replaces_another_one_at_once_is_driven(virtual_network, robot, ocu, begun):
    """The first one may be on its way to the robot still, and is cancelled once the second one has begun."""
    virtual_network.delay = 0.02
    found = await ocu.robot(101)
    async with found.control("drive"):
        first = asyncio.create_task(found.drive_course([(3.0, 0.0), (3.0, 3.0)]))
        await asyncio.sleep(begun)
        second = asyncio.create_task(found.drive_course([(0.5, 0.0), (1.0, 0.0)]))
        await asyncio.sleep(0)
        first.cancel()
        pose = await second
        assert first.cancelled()
    assert math.dist((pose.x, pose.y), (1.0, 0.0)) < 0.3


@pytest.mark.slow
async def test_four_global_waypoints_in_order(virtual_network, robot, ocu):
    found = await ocu.discover(101)
    driver = found.service("GlobalWaypointListDriver")
    here = await found.service("GlobalPoseSensor").query(QueryGlobalPose(0x3))
    metre = 180.0 / math.pi / 6_371_000.0

    def waypoint(x: float, y: float) -> SetGlobalWaypoint:
        east = y * metre / math.cos(math.radians(here.latitude))
        return SetGlobalWaypoint(here.latitude + x * metre, here.longitude + east, waypoint_tolerance=0.3)

    async with driver.control():
        await driver.resume()
        await driver.waypoints.upload(waypoint(x, y) for x, y in SQUARE)
        reached = await drive(robot, driver)
    assert all(math.dist(*pair) < 0.5 for pair in zip(reached, SQUARE, strict=True)), reached


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ManipulatorJointPositionListDriver", "ManipulatorListDriver"])
async def test_joint_positions_in_order(virtual_network, robot, ocu, name):
    arm = (await ocu.discover(101)).component(104)
    sensor, driver = arm.service("ManipulatorJointPositionSensor"), arm.service(name)
    start = await sensor.query(QueryJointPositions())

    def moved(by: float) -> SetJointPositions:
        make, radian = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice.RADIAN
        values = [each.joint_position.value + by for each in start.joint_position_list]
        return SetJointPositions([JointPositionRec(make(radian, value)) for value in values])

    async with driver.control():
        await driver.resume()
        await driver.elements.upload(map(moved, (0.3, 0.2, 0.1)))
        await driver.elements.execute()
        assert [index async for index in driver.elements.progress()] == [0, 1, 2]
    end = await sensor.query(QueryJointPositions())
    for before, after in zip(start.joint_position_list, end.joint_position_list, strict=True):
        assert after.joint_position.value == pytest.approx(before.joint_position.value + 0.1, abs=0.03)


@pytest.mark.slow
async def test_lists_work_on_a_node_manager(node_manager, robot, ocu):
    driver = (await ocu.discover(101)).service("LocalWaypointListDriver")
    async with driver.control():
        await driver.resume()
        await driver.waypoints.upload(SetLocalWaypoint(x=x, y=0.0, waypoint_tolerance=0.2) for x in (0.4, 0.8))
        (_, end) = await drive(robot, driver)
    assert end[0] == pytest.approx(0.8, abs=0.3)
