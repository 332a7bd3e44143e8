"""Localisation from the robot's file to what JAUS reports, and waypoints driven by the estimated pose."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest
from tests.helpers.robot import described
from tests.robot.world import ORIGIN, World

from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError
from jauspy.messages.mobility import (
    QueryAccelerationState,
    QueryGlobalPoseExt,
    QueryLocalPoseExt,
    SetGlobalWaypoint,
    SetLocalPose,
    SetLocalWaypoint,
    SetTravelSpeed,
)
from jauspy.platform.localization import RTK, GnssSetup, Localization, LocalizationSetup
from jauspy.robot.kinds.mobility import vehicle_of
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.mobility.reference_frames import GlobalFrame


def world_with(setup: LocalizationSetup) -> World:
    config, model = described("inc1")
    robot = KinematicRobot(replace(model, localization=setup))
    vehicle = vehicle_of(config.name, None, model, robot)
    world = World("kinematic", robot=robot, localization=vehicle.localization)
    world.take_control()
    return world


def true_place(world: World) -> tuple[float, float]:
    """Where the robot is, in JAUS axes."""
    pose = world.robot.drive.pose()
    return pose.x, -pose.y


def test_reports_carry_the_errors_of_the_estimate() -> None:
    world = world_with(LocalizationSetup(source="sensors", gnss=GnssSetup()))
    world.tell(SetLocalWaypoint(x=5.0, y=0.0), SetTravelSpeed(1.0))
    world.run(4.0)
    pose, place, velocity = world.pose, world.place, world.velocity
    assert 0.01 < pose.position_rms < 0.3
    assert 0.002 < pose.attitude_rms < 0.1
    assert 0.5 < place.position_rms < 5.0
    assert 0.0 < velocity.velocity_rms < 0.1
    assert 0.0 < velocity.rate_rms < 0.1
    wide, globe = world.ask(QueryLocalPoseExt(0xFFFF)), world.ask(QueryGlobalPoseExt(0xFFFF))
    assert math.hypot(wide.xy_position_rms, wide.z_position_rms) == pytest.approx(pose.position_rms, abs=1e-4)
    assert globe.xy_position_rms > wide.xy_position_rms
    assert world.ask(QueryAccelerationState(0xFFFF)).acceleration_rms > 0.0


def test_exact_poses_have_no_errors() -> None:
    world = world_with(LocalizationSetup())
    assert world.pose.position_rms is None
    assert world.place.attitude_rms is None
    assert world.velocity.velocity_rms is None


def test_setting_the_local_pose_moves_the_frame_and_counts_errors_from_there() -> None:
    world = world_with(LocalizationSetup(source="sensors"))
    world.tell(SetLocalWaypoint(x=5.0, y=0.0), SetTravelSpeed(1.0))
    world.run(5.0)
    grown = world.pose.position_rms
    world.tell(SetLocalPose(x=100.0, y=50.0, z=0.0, yaw=1.0, position_rms=0.005))
    world.run(0.01)
    pose = world.pose
    assert (pose.x, pose.y, pose.yaw) == pytest.approx((100.0, 50.0, 1.0), abs=0.03)
    assert pose.position_rms < grown / 2.0


def test_waypoints_are_reached_by_the_estimated_pose() -> None:
    world = world_with(LocalizationSetup(source="sensors", seed=3))
    world.tell(SetLocalWaypoint(x=6.0, y=-4.0), SetTravelSpeed(1.2))
    world.run_until(world.stands, 3.0)
    world.run(12.0)
    assert world.distance(6.0, -4.0) < 0.15, "as the robot believes"
    away = math.dist(true_place(world), (6.0, -4.0))
    assert 0.005 < away < 0.5, "as it is"


@pytest.mark.slow
def test_a_global_waypoint_follows_what_gnss_tells() -> None:
    """The heading at the start is off by degrees: by dead reckoning alone the robot would miss by a metre."""
    world = world_with(LocalizationSetup(source="sensors", seed=2, gnss=replace(RTK, heading_error=math.radians(10.0))))
    frame = GlobalFrame(ORIGIN)
    goal = frame.from_world(replace(world.vehicle.pose, x=15.0, y=5.0))
    world.tell(SetGlobalWaypoint(latitude=goal.latitude, longitude=goal.longitude), SetTravelSpeed(1.5))
    world.run(25.0)
    assert math.dist(true_place(world), (15.0, 5.0)) < 0.2
    assert world.distance(15.0, 5.0) > 0.0


def file(tmp_path: Path, table: str, origin: bool = True) -> Path:
    path = tmp_path / "robot.toml"
    text = 'extends = "inc1"\n' + table
    if not origin:
        source = Path(load.__code__.co_filename).parent.parent / "robots" / "inc1.toml"
        kept = source.read_text().split("[origin]")
        text = kept[0] + table + "\n[[modules]]" + kept[1].split("[[modules]]", 1)[1]
        text = text.replace("urdf/", f"{source.parent}/urdf/")
    path.write_text(text)
    return path


def test_keys_of_the_file(tmp_path: Path) -> None:
    table = (
        "[localization]\nsource = 'sensors'\nseed = 9\nodometry = { noise = 0.02 }\nimu = 'none'\n"
        "gnss = { receiver = 'rtk', rate = 8.0 }\n"
    )
    found = robot_model(load(file(tmp_path, table))).localization
    assert (found.source, found.seed, found.imu) == ("sensors", 9, None)
    assert found.odometry.noise == 0.02
    assert found.gnss == replace(RTK, rate=8.0)


def test_inc1_has_the_sensors_of_a_usual_robot() -> None:
    found = robot_model(load("inc1")).localization
    assert found.gnss == GnssSetup()
    assert found.imu is not None
    assert found.imu.gyro_noise == pytest.approx(math.radians(0.014)), "the data sheet of a BMI088"
    assert not found.is_exact(default=False)
    assert found.is_exact(default=True), "the kinematic backend"


@pytest.mark.parametrize(
    ("table", "origin", "sentence"),
    [
        ("[localization]\nsource = 'magic'\n", True, "localization.source"),
        ("[localization]\ngnss = { receiver = 'dgps' }\n", True, "localization.gnss"),
        ("[localization]\nimu = { gyro_noise = -1.0 }\n", True, "gyro_noise"),
        ("[localization]\ngnss = { receiver = 'rtk' }\n", False, "localization.gnss: needs"),
    ],
)
def test_wrong_keys_are_one_sentence(tmp_path: Path, table: str, origin: bool, sentence: str) -> None:
    with pytest.raises(ConfigError, match=sentence):
        load(file(tmp_path, table, origin))


def test_part_is_found_by_its_type() -> None:
    _, model = described("inc1")
    robot = KinematicRobot(replace(model, localization=LocalizationSetup(source="sensors")))
    assert Localization.of(robot) is not None
