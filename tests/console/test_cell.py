"""A factory cell in the console: parts are drawn as their sensor sees them, and a car is operated while it is there."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, replace

import pytest
from tests.helpers.memory_cell import MemoryBackend, MemoryCell

from jauspy.console.operation import Operation
from jauspy.console.robot_geometry import FREE
from jauspy.console.world import World, is_cell
from jauspy.console.world_socket import Worlds
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import rotation_about, rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages.core import QueryControl
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.cell import CarState
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

CAR = JausID(201, 1, 20)


@dataclass
class Cell:
    network: VirtualNetwork
    backend: MemoryBackend
    ocu: OCU

    @property
    def robot(self) -> MemoryCell:
        assert self.backend.robot is not None
        return self.backend.robot


@asynccontextmanager
async def running() -> AsyncIterator[Cell]:
    backend = MemoryBackend()
    async with VirtualNetwork() as network:
        runner = RobotRunner(robot_files.load("cell"), network.transport, backend=backend, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            yield Cell(network, backend, ocu)


def places(world: World) -> dict[str, object]:
    """What the browser is told of each joint."""
    assert world._geometry is not None
    return dict(zip(world._geometry.moving, world.state(0)["joints"], strict=True))


@pytest.mark.slow
async def test_parts_are_drawn_where_their_sensor_sees_them() -> None:
    async with running() as cell:
        found = await cell.ocu.discover(201)
        worlds = Worlds(cell.ocu, lambda: {201: found})
        world = worlds.opened(201, "page")
        assert world is not None
        geometry = await world.watched_by("page")
        assert is_cell(found)
        parts = {each["name"] for each in geometry.joints if each["kind"] == FREE}
        assert {"part servo_1", "part box_1", "part wheel_4", "part platform_1"} <= parts
        drawn = [each["link"] for each in geometry.shapes]
        assert {"servo_1", "servo_1 output", "tube_2", "box_3"} <= set(drawn)
        assert drawn.count(geometry.root) > 25, "bins, conveyor, stand, ramp and target stand around the robot"

        one, *others = cell.robot.sensor.seen
        nearly = replace(one, pose=replace(one.pose, x=one.pose.x + 0.001))
        before = places(world)
        cell.robot.sensor.seen = (nearly, *others)
        await asyncio.sleep(0.5)
        assert places(world) == before, "the noise of the sensor moves nothing"
        cell.robot.sensor.seen = (replace(one, pose=Pose(1.0, 2.0, 3.0)), *others[:-1])
        await asyncio.sleep(0.5)
        now = places(world)
        assert now[f"part {one.name}"] == [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0]
        assert now[f"part {others[-1].name}"] is None, "what is not seen is not drawn"

        new = replace(one, name="gear_1", type="gear of somebody")
        cell.robot.sensor.seen = (new, *others)
        await asyncio.sleep(0.5)
        geometry = await world.geometry()
        (shape,) = (each for each in geometry.shapes if each["link"] == "gear_1")
        assert (shape["kind"], shape["label"]) == ("box", "gear_1"), "nobody has described this type"
        await worlds.close()


@pytest.mark.slow
async def test_the_assembled_arm_moves_as_it_reports() -> None:
    async with running() as cell:
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.2)
        found = await cell.ocu.discover(201)
        world = World(cell.ocu, lambda: found)
        await world.watched_by("page")
        assert places(world)["output of servo_1"] == 0.0
        cell.robot.arm.move([0.5, -0.25], 0.2)
        await asyncio.sleep(1.0)
        now = places(world)
        assert (now["output of servo_1"], now["output of servo_2"]) == pytest.approx((0.5, -0.25), abs=1e-3)
        assert world.notes() == [], "a cell has no map and no pose, and nothing is missing"
        await world.close()


def frame(place: object) -> Transform:
    """The frame of a pose that the browser is told."""
    assert isinstance(place, list)
    x, y, z, a, b, c, d = place
    return Transform(rotation_from_quaternion(d, a, b, c), (x, y, z))


def gripper(cell: Cell) -> Transform:
    """Where the gripper is, by the joints of the robot itself."""
    group = cell.robot.groups["ur10"]
    description = robot_files.robot_model(robot_files.load("cell")).description
    rows = zip(group.joints, group.state().positions, strict=True)
    return FrameTree(description).pose("gripper", {joint.name: position for joint, position in rows})


HELD = Transform(rotation_about((0.0, 0.0, 1.0), 0.4), (0.01, -0.02, 0.0))


@pytest.mark.slow
async def test_what_is_held_is_drawn_where_its_holder_is() -> None:
    async with running() as cell:
        cell.robot.assemble("servo_1", "tube_1")
        cell.robot.attach("gripper", "box_1")
        connector = cell.robot.connectors["gripper"]
        connector.current = replace(connector.current, offset=HELD)
        cell.robot.sensor.seen = tuple(part for part in cell.robot.sensor.seen if part.name != "tube_1")
        await asyncio.sleep(0.2)
        found = await cell.ocu.discover(201)
        world = World(cell.ocu, lambda: found)
        await world.watched_by("page")
        for joint in (0.3, -0.4):
            cell.robot.groups["ur10"].command([Target(ControlMode.POSITION, joint)] * 6)
            cell.robot.arm.move([joint], 0.2)
            await asyncio.sleep(6.0)
            at, wanted = frame(places(world)["part box_1"]), gripper(cell) @ HELD
            assert at.position == pytest.approx(wanted.position, abs=2e-3)
            assert at.rotate((1.0, 0.0, 0.0)) == pytest.approx(wanted.rotate((1.0, 0.0, 0.0)), abs=2e-3)
            lowest = frame(places(world)["part servo_1"])
            assert lowest.position == pytest.approx((0.6, 0.22, 0.2), abs=1e-3), "on its platform"
        assert "part tube_1" not in places(world), "what was never seen is not drawn"

        connector.current = replace(connector.current, attached_to="")
        await asyncio.sleep(1.0)
        assert frame(places(world)["part box_1"]).position == pytest.approx((1.05, -0.95, 0.22), abs=1e-3)
        assert world.notes() == []
        world.unwatched_by("page")
        await world.close()


async def holder(ocu: OCU, id: JausID) -> bool:
    """True if this client controls the component."""
    report = await ocu.query(id, QueryControl())
    return (report.subsystem_id, report.node_id, report.component_id) == (
        ocu.id.subsystem,
        ocu.id.node,
        ocu.id.component,
    )


async def until(what: Callable[[], bool]) -> None:
    async with asyncio.timeout(20.0):
        while not what():
            await asyncio.sleep(0.1)


async def follow(cell: Cell, operation: Operation) -> Robot:
    """Another discovery, and what the operation makes of it."""
    robot = await cell.ocu.discover(201)
    operation.follow(robot)
    await asyncio.sleep(1.0)
    return robot


@pytest.mark.slow
async def test_a_car_that_appears_is_operated_and_one_that_goes_is_not() -> None:
    async with running() as cell:
        events: list[str] = []
        operation = Operation(await cell.ocu.discover(201), events.append)
        assert await operation.take("page", 127) == ""
        before = operation._control
        assert before is not None
        assert CAR not in before.ids

        cell.robot.car.current = CarState(assembled=True)
        await asyncio.sleep(0.5)
        await follow(cell, operation)
        assert operation._control is before, "the others stay controlled all the time"
        assert CAR in before.ids
        assert await holder(cell.ocu, CAR)
        assert events[-1] == f"{CAR} has appeared, and is operated by {operation.user.name} too"
        operation.drive("page", 1.0, 0.0)
        await asyncio.sleep(0.15)
        assert cell.robot.car.effort[0] > 0.0, "it is driven without taking control again"
        operation.drive("page", 0.0, 0.0)
        await until(lambda: cell.robot.car.effort == (0.0, 0.0))

        cell.robot.car.current = CarState()
        await asyncio.sleep(0.5)
        await follow(cell, operation)
        assert CAR in before.ids, "one discovery alone may have missed it"
        await follow(cell, operation)
        await asyncio.sleep(5.0)
        assert CAR not in before.ids
        assert events[-1] == f"{CAR} has gone, and is not operated any more"
        assert operation.is_controlled
        assert operation.refusal("page") == ""
        await operation.release()
        assert not await holder(cell.ocu, JausID(201, 1, 10))


@pytest.mark.slow
async def test_a_car_of_another_client_is_left_to_it() -> None:
    async with running() as cell:
        events: list[str] = []
        operation = Operation(await cell.ocu.discover(201), events.append)
        await operation.take("page", 100)
        cell.robot.car.current = CarState(assembled=True)
        await asyncio.sleep(0.5)
        async with (
            cell.network.ocu("42.1.9") as other,
            (await other.discover(201)).control(str(CAR), authority=200),
        ):
            await follow(cell, operation)
            await follow(cell, operation)
            refused = [each for each in events if "is not operated" in each]
            assert len(refused) == 1, "it is asked for once"
            assert "42.1.9" in refused[0]
            assert operation.is_controlled
        await operation.release()
