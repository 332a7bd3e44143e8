"""What browsers get of a robot's world: what it looks like, its state, scans and the map."""

from __future__ import annotations

import asyncio
import json
import struct
import zlib
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace

import pytest

from jauspy.console.robot_geometry import RobotGeometry, described, reported
from jauspy.console.world import MAX_TRACK, SCAN, UNKNOWN, World
from jauspy.console.world_socket import Worlds
from jauspy.errors import ConfigError
from jauspy.geometry.urdf import parse_urdf
from jauspy.ids import JausID
from jauspy.messages.manipulator import ReportManipulatorSpecifications
from jauspy.messages.mobility import ReportLocalPose
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import SubsystemInfo
from jauspy.testing import VirtualNetwork

URDF = """<robot name="r">
  <material name="red"><color rgba="1 0 0 1"/></material>
  <link name="base">
    <visual><geometry><box size="1 2 3"/></geometry><material name="red"/></visual>
    <visual><geometry><mesh filename="/m/body.dae"/></geometry></visual>
    <collision><geometry><sphere radius="9"/></geometry></collision>
  </link>
  <link name="wheel"><collision><geometry><cylinder radius="0.1" length="0.2"/></geometry></collision></link>
  <link name="arm"><visual><geometry><mesh filename="/m/arm.STL" scale="2 2 2"/></geometry></visual></link>
  <joint name="j1" type="continuous">
    <parent link="base"/><child link="wheel"/><origin xyz="1 0 0" rpy="0 0 1.5707963"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="j2" type="fixed"><parent link="wheel"/><child link="arm"/></joint>
</robot>"""


def test_a_description_for_the_browser() -> None:
    geometry = described(parse_urdf(URDF), "r.urdf")
    model = json.loads(json.dumps(geometry.for_browser("/mesh/")))
    assert model["root"] == "base"
    assert [(each["name"], each["kind"]) for each in model["joints"]] == [("j1", "revolute"), ("j2", "fixed")]
    assert model["joints"][0]["origin"] == pytest.approx([1, 0, 0, 0, 0, 0.70711, 0.70711], abs=1e-4)
    assert geometry.moving == ["j1"]
    box, wheel, arm = model["shapes"]
    assert (box["link"], box["size"], box["colour"]) == ("base", [1, 2, 3], [1, 0, 0, 1])
    assert (wheel["link"], wheel["kind"]) == ("wheel", "cylinder"), "what collides is shown where nothing else is"
    assert (arm["url"], arm["format"], arm["scale"]) == ("/mesh/0", "stl", [2, 2, 2])
    assert geometry.left_out == ["body.dae"]


def test_the_frames_of_an_arm_that_its_specification_tells() -> None:
    first = ReportManipulatorSpecifications.RevoluteJoint1OffsetRec(0.3)
    second = ReportManipulatorSpecifications.RevoluteJointSpecificationRec(0.5, 1.5707963, 0.1)
    report = ReportManipulatorSpecifications(first_joint_parameters=first, joint_specification_list=[second])
    geometry = reported({JausID(7, 1, 4): report})
    one, two = geometry.joints
    assert one["origin"] == pytest.approx([0, 0, 0.3, 0, 0, 0, 1], abs=1e-3)
    assert two["origin"] == pytest.approx([0.5, -0.1, 0, 0.7071, 0, 0, 0.7071], abs=1e-3)
    assert (two["parent"], geometry.moving) == (one["child"], ["7.1.4 joint 1", "7.1.4 joint 2"])
    assert "7.1.4" in geometry.source
    assert reported({}).source == "its services report no shape"


@asynccontextmanager
async def watched(ocu: OCU, robot: Robot) -> AsyncIterator[tuple[World, RobotGeometry]]:
    world, watcher = World(ocu, lambda: robot), object()
    try:
        yield world, await world.watched_by(watcher)
    finally:
        world.unwatched_by(watcher)
        await world.close()


@pytest.mark.slow
async def test_a_known_robot_moves_as_measured(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        async with watched(ocu, robot) as (world, geometry):
            assert geometry.source == "description of inc1"
            assert len(geometry.meshes) > 50
            await asyncio.sleep(2.0)
            state = world.state(0)
            assert dict(zip(geometry.moving, state["joints"], strict=True)) == {
                name: pytest.approx(world.positions.get(name, 0.0), abs=0.03)
                for name in geometry.moving
                if name != "gripper_link_to_right_finger"
            } | {
                "gripper_link_to_right_finger": pytest.approx(world.positions["gripper_link_to_left_finger"], abs=1e-3)
            }
            assert world.positions["arm_link_1_to_arm_link_2"] == pytest.approx(2.7, abs=0.01)
            assert {"base_link_to_flippers", "base_link_to_pan_link"} <= world.positions.keys()
            assert state["pose"][:3] == pytest.approx([0, 0, 0], abs=0.02)
            async with robot.control():
                await robot.drive(0.5, seconds=2.0)
            moved = world.state(1)
            assert moved["pose"][0] > 0.7
            assert len(moved["track"]) == world.track_total - 1 > 10
            assert len(json.dumps(moved, separators=(",", ":"))) < 1000


@pytest.mark.slow
async def test_another_vendors_robot_shows_what_it_reports(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        found = await ocu.discover(101)
        info = replace(found.info, name="other")
        robot = Robot(found._connection, info)
        async with watched(ocu, robot) as (world, geometry):
            assert geometry.source.startswith("reported by 101.1.10")
            assert geometry.meshes == []
            await asyncio.sleep(1.0)
            assert any(world.state(0)["joints"])
        nothing = Robot(found._connection, SubsystemInfo(101, "bare"))
        async with watched(ocu, nothing) as (world, geometry):
            await asyncio.sleep(0.5)
            assert (geometry.joints, geometry.shapes) == ([], [])
            assert any("does not report its pose" in each for each in world.notes())
            assert any("no range sensor" in each for each in world.notes())


async def test_scans_and_the_map_as_bytes(virtual_network: VirtualNetwork) -> None:
    pytest.importorskip("numpy", reason="maps need the extra 'map'")
    from jauspy.geometry.poses import PlanarPose
    from jauspy.mapping.live import LiveMapping
    from jauspy.mapping.mapper import Mapper

    async with virtual_network.ocu() as ocu:
        robot = Robot(ocu._connection, SubsystemInfo(101, "bare"))
        world = World(ocu, lambda: robot)
        world.mapping = LiveMapping(robot, Mapper())
        assert (world.map_version, await world.map_message()) == (0, b"")
        world._take_scan(PlanarPose(0.5, 0.0, 0.0), [0.0, 1.5707963, 3.0], [2.0, 1.0, float("inf")])
        assert (world.scan[0], world.scans) == (SCAN, 1)
        assert struct.unpack("<4h", world.scan[8:]) == (250, 0, 50, 100)
        world.mapping.mapper.add(PlanarPose(), PlanarPose(), [0.0, 0.01], [2.0, 2.0])
        assert world.map_version == 1
        message = await world.map_message()
        kind, columns, rows, x, y, side = struct.unpack_from("<BxHHxxfff", message)
        cells = zlib.decompress(message[struct.calcsize("<BxHHxxfff") :])
        assert (kind, len(cells), side) == (1, columns * rows, pytest.approx(0.05))
        assert (x, y) == (pytest.approx(0.0, abs=0.051), pytest.approx(0.0, abs=0.051))
        assert columns * side == pytest.approx(2.05, abs=0.06)
        assert {each for each in cells if each != UNKNOWN and each > 65}, "an echo is occupied"
        assert UNKNOWN in cells or rows == 1
        assert len(message) < 100


async def test_the_track_is_bounded(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.ocu() as ocu:
        world = World(ocu, lambda: None)
        for number in range(MAX_TRACK + 10):
            world._take_pose(ReportLocalPose(x=0.06 * number, y=1.0, yaw=-0.5))
        assert (len(world.track), world.track_total) == (MAX_TRACK, MAX_TRACK + 10)
        assert world.pose is not None
        assert (world.pose.y, world.pose.yaw) == pytest.approx((-1.0, 0.5), abs=1e-3)
        with pytest.raises(ConfigError, match="has gone"):
            await world.watched_by(object())


@pytest.mark.slow
async def test_a_world_ends_with_the_last_page_that_looked(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        robot = await ocu.discover(101)
        worlds = Worlds(ocu, lambda: {101: robot})
        assert worlds.opened(7, "a") is None
        world = worlds.opened(101, "a")
        assert worlds.opened(101, "b") is world
        assert world is not None
        await world.watched_by("a")
        await worlds.forget("b")
        assert worlds.get(101) is world
        await worlds.forget("a")
        assert worlds.get(101) is None
        sent = ocu.stats.sent
        await asyncio.sleep(3.0)
        assert ocu.stats.sent - sent <= 2, "nothing is asked any more"
        await worlds.close()
