"""Two robots in one world of MuJoCo: they touch, they see each other, and each has its own commands and time."""

from __future__ import annotations

import math
from collections.abc import Iterator

import pytest

pytest.importorskip("mujoco")

import mujoco
import numpy as np

from jauspy.backends import find
from jauspy.backends.shared_world import SharedWorld
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.platform.backend import PlacedRobot
from jauspy.platform.commands import DriveEffort
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot import robot_files
from jauspy.robot.realtime import RealTime
from jauspy_sim.models.track_visuals import SIDES
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_files.robot_model(robot_files.load("inc1"))
STEP = 0.01


def opened(*starts: Pose, world: str = "empty") -> tuple[SimulatedRobot, ...]:
    shared = SharedWorld(find("sim"), [PlacedRobot(INC1, start) for start in starts])
    return tuple(backend.open(INC1, world) for backend in shared.backends)


@pytest.fixture
def pair() -> Iterator[tuple[SimulatedRobot, SimulatedRobot]]:
    """The second one 2.5 m behind the first."""
    first, second = opened(Pose(), Pose(x=-2.5))
    yield first, second
    first.close()
    second.close()


def run(robots: tuple[SimulatedRobot, ...], seconds: float) -> None:
    for _ in range(round(seconds / STEP)):
        for robot in robots:
            robot.advance(STEP)


def touching(robot: SimulatedRobot) -> int:
    """Contacts between the two robots."""
    owners = [robot.model.body(body).name.partition("/")[0] for body in robot.model.geom_bodyid]
    return sum({owners[contact.geom1], owners[contact.geom2]} == {"inc1", "inc1_2"} for contact in robot.data.contact)


def test_robots_start_where_they_are_placed_and_rest(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    run(pair, 1.0)
    for robot, x in zip(pair, (0.0, -2.5), strict=True):
        pose = robot.drive.pose()
        assert (pose.x, pose.y, pose.yaw) == pytest.approx((x, 0.0, 0.0), abs=1e-3)


def test_each_takes_its_own_commands(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    first.drive.set_effort(0.5, 0.0)
    second.drive.set_effort(0.0, 0.5)
    run(pair, 1.5)
    assert first.drive.pose().x > 0.5
    assert abs(first.drive.pose().yaw) < 0.05
    assert second.drive.pose().x == pytest.approx(-2.5, abs=0.1)
    assert second.drive.pose().yaw > 0.3
    assert abs(second.drive.acceleration().ax) < 20.0


@pytest.mark.slow
def test_they_collide(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    assert not touching(first)
    second.drive.set_effort(0.4, 0.0)
    seen = 0
    for _ in range(60):
        run(pair, 0.05)
        seen = max(seen, touching(first))
    assert seen > 0
    assert second.drive.pose().x < -0.3, "it does not drive through the other"


@pytest.mark.slow
def test_contacts_name_the_other_robot(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    second.groups["flippers"].command([Target(ControlMode.POSITION, 0.0)])
    second.drive.set_effort(0.4, 0.0)
    run(pair, 4.0)
    bodies = {
        body for counts in (*first._contacts.state().values(), *second._contacts.state().values()) for body in counts
    }
    assert any(body.startswith(("inc1/", "inc1_2/")) for body in bodies)


def test_lidars_see_the_other_robot_and_not_their_own(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    run(pair, 0.3)
    groups = pair[0].model.geom_group.copy()
    for robot, towards in zip(pair, (math.pi, 0.0), strict=True):
        scan = robot.lidars["lidar"].scan
        assert scan is not None
        ranges = {
            round(math.degrees(angle)): distance for angle, distance in zip(scan.angles, scan.ranges, strict=True)
        }
        ahead = [
            distance
            for angle, distance in ranges.items()
            if abs(math.remainder(math.radians(angle) - towards, math.tau)) < math.radians(8.0)
        ]
        assert 1.0 < min(ahead) < 2.8
        assert sum(math.isfinite(distance) for distance in ranges.values()) < 60, "nothing else is in the world"
    run(pair, 0.1)
    assert (pair[0].model.geom_group == groups).all()


@pytest.mark.slow
def test_cameras_have_both_robots_in_their_model(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    for robot, name in ((first, "inc1"), (second, "inc1_2")):
        camera = robot.cameras["outside"]
        drawn = camera.drawn
        assert drawn is not None
        model = drawn.build()
        assert (model.nq, model.nv, model.nuserdata) == (robot.model.nq, robot.model.nv, 2 * SIDES)
        assert model.camera(f"{name}/outside").id == camera.number
        for each in ("inc1", "inc1_2"):
            assert model.body(f"{each}/base_link").id == robot.model.body(f"{each}/base_link").id


@pytest.mark.slow
def test_the_second_appears_in_a_picture_of_the_first() -> None:
    """The same view of the ground, with and without a robot 2.5 m ahead, by rays: no GL is needed."""
    from jauspy_sim.rendering.rays import RayRenderer

    pictures = []
    for ahead in (2.5, 60.0):
        robots = opened(Pose(), Pose(x=ahead))
        camera = robots[0].cameras["chassis"]
        renderer = RayRenderer(robots[0].model, camera.number, camera.setup.fov)
        mujoco.mj_camlight(robots[0].model, robots[0].data)
        pictures.append(renderer.paint(robots[0].data, 64, 48).copy())
        for robot in robots:
            robot.close()
    near, far = pictures
    assert (np.abs(near.astype(int) - far.astype(int)).max(axis=2) > 25).sum() > 50


def test_belts_of_each_run_on_their_own(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    second.drive.set_effort(-0.4, 0.0)
    run(pair, 1.0)
    left, right, other_left, other_right = first.data.userdata.tolist()
    assert max(abs(left), abs(right)) < 0.01
    assert other_left < -0.2
    assert other_right < -0.2


@pytest.mark.slow
def test_same_commands_give_the_same_motion_however_the_calls_are_divided() -> None:
    ends = []
    for order in ((0, 1), (1, 0)):
        robots = opened(Pose(), Pose(x=-2.5))
        robots[0].drive.set_effort(0.5, 0.2)
        for _ in range(50):
            for number in order:
                robots[number].advance(STEP)
        ends.append((robots[0].time, robots[0].drive.pose()))
        for robot in robots:
            robot.close()
    assert ends[0] == ends[1]


def test_the_world_goes_on_for_one_that_is_advanced_alone_and_waits_for_none(
    pair: tuple[SimulatedRobot, SimulatedRobot],
) -> None:
    first, second = pair
    for _ in range(100):
        first.advance(STEP)
    assert first.time == pytest.approx(1.0)
    for _ in range(30):
        second.advance(STEP)
    assert first.time == pytest.approx(1.2), "0.1 s of the lead count, the rest is lost to the second"


def test_threads_of_two_robots_share_the_world(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = (RealTime(robot, step=STEP) for robot in pair)
    second.submit(DriveEffort(-0.5, 0.0))
    with first, second:
        for _ in range(4000):
            first.alive()
            second.alive()
            if second.snapshot.pose.x < -2.7:
                break
            first._closing.wait(0.005)
    assert second.snapshot.pose.x < -2.7
    assert not first.faults
    assert not second.faults
    assert abs(first.snapshot.time - second.snapshot.time) < 0.5


def test_one_that_ends_leaves_the_other_running(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    run(pair, 0.2)
    first.close()
    before = second.time
    second.drive.set_effort(0.3, 0.0)
    run((second,), 1.0)
    assert second.time - before == pytest.approx(1.0, abs=0.11)
    assert second.drive.pose().x > -2.4


@pytest.mark.parametrize(
    ("start", "world", "message"),
    [
        (Pose(x=-0.3), "empty", "starts inside of inc1"),
        (Pose(x=5.4, y=0.0), "street", "starts inside of"),
    ],
)
def test_robots_inside_of_something_are_refused(start: Pose, world: str, message: str) -> None:
    with pytest.raises(ConfigError, match=message):
        opened(Pose(), start, world=world)


def test_a_cell_has_its_world_for_itself() -> None:
    cell = robot_files.robot_model(robot_files.load("cell"))
    with pytest.raises(ConfigError, match="for itself"):
        find("sim").open_several([PlacedRobot(INC1), PlacedRobot(cell)], "cell")


def test_other_backends_say_that_they_have_one_robot() -> None:
    with pytest.raises(ConfigError, match="has one robot in a world"):
        SharedWorld(find("can"), [PlacedRobot(INC1), PlacedRobot(INC1)])


def test_lamps_of_both_are_in_the_pictures_of_each(pair: tuple[SimulatedRobot, SimulatedRobot]) -> None:
    first, second = pair
    owners = [[owner for owner, _ in robot.cameras["chassis"].lamps] for robot in (first, second)]
    assert owners == [["inc1/"] * 2 + ["inc1_2/"] * 2, ["inc1_2/"] * 2 + ["inc1/"] * 2]
