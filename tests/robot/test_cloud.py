"""The scans of a robot as clouds."""

from __future__ import annotations

import asyncio
import math
import struct
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import pytest

from jauspy.backends.kinematic import KinematicRobot
from jauspy.cloud.stream import CloudSubscriber
from jauspy.errors import ConfigError
from jauspy.platform.ranging import LidarSetup, RangeScan, Scanner
from jauspy.robot import robot_files
from jauspy.robot.cloud import Clouds, points, stream
from jauspy.robot.robot_files import robot_model

SETUP = LidarSetup("lidar", "lidar_link", rays=4)


class Published:
    def __init__(self) -> None:
        self.clouds: list[tuple[bytes, str, float]] = []

    def publish(self, found: bytes, frame: str, at: float) -> None:
        self.clouds.append((found, frame, at))


def test_points_are_the_ends_of_rays_with_an_echo() -> None:
    scan = RangeScan(0.0, "lidar_link", (0.0, math.pi / 2, math.pi), (2.0, math.inf, 3.0))
    assert struct.unpack("<6f", points(scan)) == pytest.approx((2.0, 0.0, 0.0, -3.0, 0.0, 0.0), abs=1e-6)


async def test_every_scan_is_published_once() -> None:
    lidar, published = Scanner(SETUP, lambda angles: [1.0] * len(angles)), Published()
    task = asyncio.create_task(stream({"lidar": lidar}, published))  # type: ignore[arg-type]
    for scans in (1, 2, 3):
        lidar.step(scans * 1.0)
        async with asyncio.timeout(20):
            while len(published.clouds) < scans:
                await asyncio.sleep(0.01)
        await asyncio.sleep(0.1)
        assert len(published.clouds) == scans
    task.cancel()
    assert {(len(found), frame) for found, frame, _ in published.clouds} == {(48, "lidar_link")}


@pytest.mark.parametrize(
    ("wanted", "said"),
    [
        (
            ["nose=tcp://127.0.0.1:1"],
            r"'nose' is no lidar \(lidar\) and no camera with `depth` \(arm, chassis\)",
        ),
        (["outside=tcp://127.0.0.1:1"], "'outside' is no lidar"),
        (["lidar=ipc:///a", "lidar=ipc:///b"], "lidar would be published twice"),
        (["ipc:///a", "chassis=ipc:///a"], "ipc:///a is there twice"),
        (["ipc:///a", "ipc:///b"], "the lidars would be published twice"),
        (["chassis=ipc:///a", "chassis=ipc:///b"], "chassis would be published twice"),
    ],
)
def test_invalid_cloud_addresses_are_rejected_before_the_start(wanted: list[str], said: str) -> None:
    with pytest.raises(ConfigError, match=said):
        Clouds(robot_files.load("inc1"), wanted)


@pytest.mark.slow
@pytest.mark.skipif(not (find_spec("pynng") and find_spec("numpy")), reason="the extra 'cloud' is not installed")
async def test_scans_and_depth_are_published_each_at_its_address(tmp_path: Path) -> None:
    class Running(KinematicRobot):
        config = robot_files.load("inc1")

    robot = Running(robot_model(Running.config))
    scans, depth = f"ipc://{tmp_path}/a=b", f"ipc://{tmp_path}/depth"
    clouds = Clouds(Running.config, [scans, f"chassis={depth}"])
    with CloudSubscriber(scans) as lidar, CloudSubscriber(depth) as camera:
        async with clouds.published(robot):
            seen = await asyncio.to_thread(camera.receive, 20.0)
            scan = None
            async with asyncio.timeout(20.0):
                while scan is None:
                    robot.advance(0.1)
                    scan = await asyncio.to_thread(lidar.receive, 0.1)
        assert seen is not None
        assert (seen.frame, seen.values) == ("chassis_camera_link", 6)
        assert 10_000 < len(seen) < 50_000, "the lower half of the picture is the floor"
        assert (scan.frame, scan.values, len(scan)) == ("lidar_link", 3, 0)
    assert clouds.counters["cloud.chassis.started"] == 1
    robot.close()


def with_layers(lidar: LidarSetup) -> Scanner:
    return Scanner(replace(lidar, layers=3, vertical=(-0.5, 0.5)), lambda angles: [2.0] * len(angles))


@pytest.mark.skipif(not find_spec("numpy"), reason="numpy is not installed")
def test_points_of_several_layers_are_on_a_sphere() -> None:
    lidar = with_layers(SETUP)
    lidar.step(0.0)
    assert lidar.scan is not None
    found = list(struct.iter_unpack("<3f", points(lidar.scan)))
    assert len(found) == 12
    assert {round(math.dist((0.0, 0.0, 0.0), each), 5) for each in found} == {2.0}
    assert {round(z, 5) for _, _, z in found} == {round(2.0 * math.sin(up), 5) for up in (-0.5, 0.0, 0.5)}


def test_clouds_of_the_file_are_published_and_replaced_by_the_command(tmp_path: Path) -> None:
    file = tmp_path / "robot.toml"
    file.write_text('extends = "inc1"\n[[clouds]]\nsource = "lidar"\naddress = "tcp://127.0.0.1:5565"\n')
    assert Clouds(robot_files.load(file), []).addresses == {"lidar": "tcp://127.0.0.1:5565"}
    assert Clouds(robot_files.load(file), ["lidar=ipc:///b"]).addresses == {"lidar": "ipc:///b"}
    assert Clouds(robot_files.load(file), ["chassis=ipc:///b"]).addresses == {
        "chassis": "ipc:///b",
        "lidar": "tcp://127.0.0.1:5565",
    }
    with pytest.raises(ConfigError, match=r"tcp://127\.0\.0\.1:5565 is there twice"):
        Clouds(robot_files.load(file), ["chassis=tcp://127.0.0.1:5565"])


def test_a_wrong_address_in_the_file_is_named_with_its_key(tmp_path: Path) -> None:
    file = tmp_path / "robot.toml"
    file.write_text('extends = "inc1"\n[[clouds]]\nsource = "lidar"\naddress = "ipc:///b"\n')
    with pytest.raises(ConfigError, match=r"line 4: clouds\[0\]\.address = 'ipc:///b': .* is not tcp://HOST:PORT"):
        robot_files.load(file)
