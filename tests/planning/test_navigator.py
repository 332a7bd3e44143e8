"""The navigator on virtual time: a kinematic inc1 whose lidar sees walls that the test puts up."""

from __future__ import annotations

import asyncio
import math
import time
from collections.abc import Sequence
from types import SimpleNamespace

import pytest
from tests.helpers.robot import described

pytest.importorskip("scipy", reason="planning needs scipy")

import numpy as np

from jauspy.backends import kinematic
from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError, RequestError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid, transformed
from jauspy.messages.iop import AddNoGoZone, QueryCostMap2D, QueryNoGoZones, QueryPath, RemoveNoGoZone
from jauspy.ocu import Robot
from jauspy.ocu.state import RobotPose
from jauspy.planning import navigator
from jauspy.planning.driving_map import DrivingMap
from jauspy.planning.ground import Ground
from jauspy.planning.legs import PathPoint, is_leg_free
from jauspy.planning.mobility import flipper_joints, mobility_of
from jauspy.planning.navigator import Navigator
from jauspy.planning.path_search import NoPath, Path, find_path_with_margins
from jauspy.planning.path_services import IMPASSABLE, navigation_services
from jauspy.planning.terrain_cost import TerrainCost
from jauspy.planning.way_parts import Part
from jauspy.platform.ranging import Scanner

MODEL = described("inc1")[1]
ROOM = ((-3.0, -4.0, 7.0, -4.0), (7.0, -4.0, 7.0, 4.0), (7.0, 4.0, -3.0, 4.0), (-3.0, 4.0, -3.0, -4.0))
"""Walls as lines of x, y, x, y in metres."""
BEHIND = -0.33
"""Place of the lidar on the robot, metres."""


def hit(x: float, y: float, angle: float, wall: tuple[float, float, float, float]) -> float:
    """Metres along a ray to a wall; inf if it misses."""
    c, s = math.cos(angle), math.sin(angle)
    dx, dy = wall[2] - wall[0], wall[3] - wall[1]
    across = c * dy - s * dx
    if abs(across) < 1e-9:
        return math.inf
    far = ((wall[0] - x) * dy - (wall[1] - y) * dx) / across
    part = ((wall[0] - x) * s - (wall[1] - y) * c) / across
    return far if far > 0.0 and 0.0 <= part <= 1.0 else math.inf


@pytest.fixture
def walls(monkeypatch: pytest.MonkeyPatch) -> list[tuple[float, float, float, float]]:
    """What lidars of kinematic robots see; tests add to it."""
    found = list(ROOM)
    build = KinematicRobot.__init__

    def init(self: KinematicRobot, model: object) -> None:
        build(self, model)  # type: ignore[arg-type]

        def measure(angles: Sequence[float]) -> list[float]:
            pose = self.drive.pose()
            x, y = pose.x + BEHIND * math.cos(pose.yaw), pose.y + BEHIND * math.sin(pose.yaw)
            return [min(hit(x, y, angle + pose.yaw, wall) for wall in found) for angle in angles]

        self.lidars = {name: Scanner(lidar.setup, measure) for name, lidar in self.lidars.items()}
        self._measure()

    monkeypatch.setattr(kinematic.KinematicRobot, "__init__", init)
    return found


@pytest.fixture
async def inc1(walls, robot, ocu) -> Robot:
    return await ocu.robot(101)


def surroundings(inc1: Robot, **options) -> DrivingMap:
    return DrivingMap(inc1, size=20.0, resolution=0.1, threaded=False, **options)


@pytest.mark.slow
async def test_a_goal_behind_a_wall_is_reached_around_it(inc1, walls, robot):
    walls.append((2.0, -4.0, 2.0, 1.0))
    left = []
    async with inc1.control("drive"), surroundings(inc1) as around:
        navigator = Navigator(inc1, MODEL, around, speed=0.8)
        pose = await navigator.go_to(4.0, 0.0, progress=lambda progress: left.append(progress.left))
    assert math.dist((pose.x, pose.y), (4.0, 0.0)) < 0.35
    assert max(left) > 4.8, "around the wall"
    assert min(left) < 0.4


IN_MAP = PlanarPose(2.5, -1.0, 0.5)
"""Where the robot started, in a map that was made before."""


def drawn(walls: Sequence[tuple[float, float, float, float]]) -> OccupancyGrid:
    """A map of walls, free elsewhere in the room."""
    grid = OccupancyGrid(30.0, 0.05)
    xs, ys = np.meshgrid(np.arange(-3.0, 7.0, 0.03), np.arange(-4.0, 4.0, 0.03))
    lines = [np.linspace(wall[:2], wall[2:], 400) for wall in walls]
    for points, odds in ((np.column_stack([xs.ravel(), ys.ravel()]), -2.0), (np.concatenate(lines), 2.0)):
        cells = np.rint(grid.cell_coordinates(transformed(IN_MAP, points))).astype(int)
        grid.log_odds[cells[:, 1], cells[:, 0]] = odds
    return grid


@pytest.mark.slow
async def test_a_known_map_leads_past_a_dead_end_that_the_robot_does_not_see(inc1, walls):
    walls += [(2.0, -4.0, 2.0, 1.0), (3.6, -1.2, 3.6, 4.0)]
    goal = IN_MAP @ PlanarPose(5.5, 0.0)
    start = IN_MAP @ PlanarPose(0.3, -0.2, math.radians(8.0))
    async with surroundings(inc1) as around:
        seen = await Navigator(inc1, MODEL, around).plan(5.5, 0.0)
    async with inc1.control("drive"), surroundings(inc1, known=drawn(walls), start=start) as around:
        found = around.to_map(PlanarPose())
        navigator = Navigator(inc1, MODEL, around, speed=0.8)
        way = await navigator.plan(goal.x, goal.y)
        pose = await navigator.go_to(goal.x, goal.y)
    assert tuple(found) == pytest.approx(tuple(IN_MAP), abs=0.05)
    assert way.length > seen.length + 1.0
    assert math.dist((pose.x, pose.y), (5.5, 0.0)) < 0.35


async def test_a_map_of_another_place_is_told(inc1, walls):
    room = drawn([(-3.0, -2.0, 7.0, -2.5), (-1.0, -4.0, -1.2, 4.0), (1.5, 1.0, 7.0, 3.0)])
    with pytest.raises(
        ConfigError, match=r"does not fit the map near \(2\.5, -1\) and 28\.6 degrees: .*% of the echoes"
    ):
        async with surroundings(inc1, known=room, start=IN_MAP):
            pass


@pytest.mark.slow
async def test_what_appears_on_the_way_gives_a_new_way_at_once(inc1, walls, robot):
    async with inc1.control("drive"), surroundings(inc1) as around:
        navigator = Navigator(inc1, MODEL, around, speed=0.5)
        reports = []
        drive = asyncio.create_task(navigator.go_to(5.0, 0.0, progress=reports.append))
        await asyncio.sleep(2.0)
        way, clock = navigator.path, asyncio.get_running_loop().time
        at, put = robot.snapshot.pose.x + 2.0, clock()
        walls.append((at, -0.6, at, 0.6))
        while navigator.path is way or is_leg_free(navigator.terrain, *way.points[:2]):
            await asyncio.sleep(0.01)
            assert robot.snapshot.pose.x < at - 1.0
        new_way_after = clock() - put + navigator.planning_time
        nearest = math.inf
        while not drive.done():
            await asyncio.sleep(0.1)
            pose = robot.snapshot.pose
            nearest = min(nearest, math.hypot(pose.x - at, max(0.0, abs(pose.y) - 0.6)))
        pose = await drive
    assert new_way_after < 0.5, "virtual seconds until it was sent, and those of the costs and the search"
    assert nearest > 0.33, "half of its width"
    assert math.dist((pose.x, pose.y), (5.0, 0.0)) < 0.35


@pytest.mark.slow
async def test_a_robot_stands_for_a_search_that_takes_long(inc1, walls, monkeypatch):
    budgets = []

    def find(terrain, pose, goal, *, backward, end):
        budgets.append(end - time.thread_time())
        if budgets[-1] < 1.0:
            raise NoPath("no way was found in time")
        return find_path_with_margins(terrain, pose, goal, backward=backward, end=end)

    monkeypatch.setattr(navigator, "find_path_with_margins", find)
    async with inc1.control("drive"), surroundings(inc1) as around:
        drive = asyncio.create_task(Navigator(inc1, MODEL, around, speed=0.8).go_to(4.0, 0.0))
        await asyncio.sleep(1.0)
        walls.append((2.5, -0.6, 2.5, 0.6))
        pose = await drive
    assert math.dist((pose.x, pose.y), (4.0, 0.0)) < 0.35
    assert budgets[0] > 5.0, "before it drives"
    assert 0.0 < max(budgets[1:3]) < 0.5, "so that a new way comes soon"
    assert max(budgets[2:]) > 5.0, "once it stands"


@pytest.mark.slow
async def test_without_a_way_the_robot_stands_and_the_reason_is_one_sentence(inc1, walls, robot):
    walls.append((2.0, -4.0, 2.0, 4.0))
    async with inc1.control("drive"), surroundings(inc1, allow_unknown=False) as around:
        with pytest.raises(NoPath, match="choose") as error:
            await Navigator(inc1, MODEL, around).go_to(4.0, 0.0)
    assert "\n" not in str(error.value)
    assert abs(robot.snapshot.twist.vx) < 0.01


@pytest.mark.slow
async def test_a_way_that_closes_stops_the_robot(inc1, walls, robot):
    async with inc1.control("drive"), surroundings(inc1, allow_unknown=False) as around:
        drive = asyncio.create_task(Navigator(inc1, MODEL, around).go_to(5.0, 0.0))
        await asyncio.sleep(2.0)
        walls.append((3.0, -4.0, 3.0, 4.0))
        with pytest.raises(NoPath):
            await drive
    assert robot.snapshot.pose.x < 2.6


@pytest.mark.slow
async def test_a_goal_beside_a_wall_need_not_be_hit_as_a_corner_beside_it(inc1, walls, monkeypatch):
    """A robot in physics turned about a goal to which it had come within 3 cm until its time was over."""
    courses, drive_course = [], inc1.drive_course

    def driven(points, **options):
        courses.append(points)
        return drive_course(points, **options)

    monkeypatch.setattr(inc1, "drive_course", driven)
    walls.extend([(0.6, 0.43, 4.0, 0.43), (0.6, -0.43, 4.0, -0.43)])
    async with inc1.control("drive"), surroundings(inc1) as around:
        await asyncio.sleep(3.0)  # until the walls are in the map
        pose = await Navigator(inc1, MODEL, around).go_to(2.5, 0.0)
    assert math.dist((pose.x, pose.y), (2.5, 0.0)) < 0.3
    assert {points[-1].tolerance for points in courses} == {navigator.CORNER_TOLERANCE}


@pytest.mark.slow
async def test_a_cancelled_drive_stops(inc1, robot):
    async with inc1.control("drive"), surroundings(inc1) as around:
        with pytest.raises(TimeoutError):
            async with asyncio.timeout(2.0):
                await Navigator(inc1, MODEL, around).go_to(5.0, 0.0)
        await asyncio.sleep(1.0)
        assert abs(robot.snapshot.twist.vx) < 0.01


@pytest.mark.slow
async def test_flippers_that_were_set_for_a_step_are_put_back_at_the_goal(inc1, monkeypatch):
    (joint,) = flipper_joints(MODEL)
    monkeypatch.setattr(navigator, "parts", lambda points, terrain, flippers: [Part(tuple(points), 0.5)])
    before, during = (await inc1.joints()).positions[joint], []
    async with inc1.control(), surroundings(inc1) as around:
        drive = asyncio.create_task(Navigator(inc1, MODEL, around).go_to(1.5, 0.0))
        while not drive.done():
            during.append((await inc1.joints()).positions[joint])
            await asyncio.sleep(0.5)
        await drive
    assert min(during) == pytest.approx(0.5, abs=0.06), "they are folded at 2.2"
    assert (await inc1.joints()).positions[joint] == pytest.approx(before, abs=0.06)


@pytest.mark.parametrize("speed", [0.0, -1.0, math.nan])
async def test_a_speed_is_above_zero(inc1, speed):
    with pytest.raises(ConfigError, match="speed"):
        Navigator(inc1, MODEL, surroundings(inc1), speed=speed)


@pytest.mark.slow
async def test_way_and_cost_are_reported_and_zones_kept(virtual_network, inc1, walls, ocu):
    walls.append((2.0, -4.0, 2.0, 1.0))
    kind = QueryPath.PathType.PLANNED_LOCAL_PATH
    async with surroundings(inc1) as around:
        await asyncio.sleep(1.5)  # until the scans show the wall
        navigator = Navigator(inc1, MODEL, around)
        async with virtual_network.component("101.1.190", navigation_services(navigator)) as component:
            assert not (await ocu.query(component.id, QueryPath(kind))).path_var.planned_local_path
            path = await navigator.plan(4.0, 0.0)
            reported = (await ocu.query(component.id, QueryPath(kind))).path_var.planned_local_path
            assert [(point.x, -point.y) for point in reported] == [
                (pytest.approx(point.x, abs=1e-3), pytest.approx(point.y, abs=1e-3)) for point in path.points
            ]
            report = await ocu.query(component.id, QueryCostMap2D())
            size, middle = report.cost_map2d_rec, report.cost_map2d_pose_var
            costs = [cell.cost for cell in report.cost_map2d_data_var.cost_data_list]
            assert len(costs) == size.number_of_rows * size.number_of_columns <= 16_000

            def cost_at(x: float, y: float) -> int:
                side = size.map_width / size.number_of_columns
                column = math.floor((x - middle.map_center_x + size.map_width / 2.0) / side)
                row = math.floor((-y - middle.map_center_y + size.map_height / 2.0) / side)
                return costs[row * size.number_of_columns + column]

            assert cost_at(2.0, 0.5) == IMPASSABLE
            assert cost_at(0.5, 0.5) < 60
            costs_of = ocu.service(component.id, "CostMap2D")
            async with costs_of.control():
                zone = AddNoGoZone.LocalVertexList(
                    [AddNoGoZone.LocalVertexRec(x, -y) for x, y in ((0.8, 0.0), (5.0, 0.0), (5.0, 3.9), (0.8, 3.9))]
                )
                await costs_of.send(AddNoGoZone(AddNoGoZone.RequestIDRec(7), zone), ack=True)
                zones = (await ocu.query(component.id, QueryNoGoZones(0))).no_go_zones_list
                assert zones[0].zone_id_rec.zone_id == 1
                assert len(zones[0].vertex_var.local_vertex_list) == 4
                with pytest.raises(NoPath):
                    await navigator.plan(4.0, -2.0)
                await costs_of.send(RemoveNoGoZone(1), ack=True)
                await navigator.plan(4.0, -2.0)


@pytest.mark.slow
def test_a_zone_covers_what_is_inside(inc1):
    around = DrivingMap(inc1, size=10.0, resolution=0.1, threaded=False)
    around.zones = [((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))]
    cells = around._zone_cells((30, 30), (-1.0, -1.0))
    assert cells[12, 12]
    assert not cells[18, 18], "beyond the long side"
    assert not cells[12, 5]
    assert PlanarPose() == around.mapper.correction


def test_a_goal_where_the_robot_cannot_stand_is_refused_when_it_is_near():
    """From afar the robot drives to the nearest place where it can stand, and looks again."""
    cells = np.zeros((200, 200), bool)
    cells[98:103, 160:165] = True
    mobility = mobility_of(MODEL)
    around = SimpleNamespace(terrain=lambda *_: TerrainCost(mobility, cells, np.ones_like(cells), (-5.0, -5.0), 0.05))
    driver = Navigator(SimpleNamespace(components=()), MODEL, around)  # type: ignore[arg-type]
    _, path = driver._find(mobility, PlanarPose(-1.0, 0.0, 0.0), (3.1, 0.0), 5.0)
    end = path.points[-1]
    assert 0.3 < math.dist(end[:2], (3.1, 0.0)) < 1.2
    with pytest.raises(NoPath, match="choose a goal"):
        driver._find(mobility, PlanarPose(end.x, end.y, 0.0), (3.1, 0.0), 5.0)


def test_the_rest_of_a_way_does_not_lead_back_to_a_corner_that_is_behind():
    cells = np.zeros((200, 200), bool)
    terrain = TerrainCost(mobility_of(MODEL), cells, ~cells, (-5.0, -5.0), 0.05)
    around = SimpleNamespace(to_map=lambda pose: pose)
    driver = Navigator(SimpleNamespace(components=()), MODEL, around)  # type: ignore[arg-type]
    driver.terrain, driver._driven = terrain, [PathPoint(0.0, 0.0), PathPoint(1.0, 0.0), PathPoint(1.0, 2.0)]
    for x, y, corners in (
        (0.5, 0.0, 2),
        (0.95, 0.02, 1),
        (1.2, 0.05, 1),
        (0.8, -0.1, 1),
        (1.02, 0.6, 1),
        (1.0, 2.1, 1),
    ):
        place, *rest = driver.ahead(RobotPose(x, y, 0.0, 0.0, 0.0, 0.0))
        assert place[:2] == (x, y)
        assert len(rest) == corners, (x, y)
        assert rest[-1] == (1.0, 2.0, False)


@pytest.mark.parametrize(
    ("x", "end", "has_arrived"),
    [(1.75, 2.0, True), (1.66, 1.76, True), (1.4, 1.51, True), (1.4, 1.55, False), (1.48, 1.4, False)],
)
def test_a_robot_has_arrived_where_its_way_ends_as_near_to_the_goal_as_it_can_stand(x, end, has_arrived):
    driver = Navigator(SimpleNamespace(components=()), MODEL, SimpleNamespace(to_map=lambda pose: pose))  # type: ignore[arg-type]
    driver.path = Path((PathPoint(0.0, 0.0), PathPoint(end, 0.0)), end, 1, 0.0)
    assert driver._has_arrived(RobotPose(x, 0.0, 0.0, 0.0, 0.0, 0.0), 2.0, 0.0) is has_arrived


class Kerb:
    """0.12 m high, at x = 2."""

    origin = (-5.0, -5.0)
    resolution = 0.1
    heights = np.where(np.arange(100) >= 70, 0.12, 0.0).astype(np.float32) * np.ones((100, 1), np.float32)


@pytest.mark.parametrize(("x", "angle", "is_told"), [(1.0, None, True), (-0.5, None, False), (1.0, 0.05, False)])
def test_a_step_that_was_not_known_when_the_way_was_planned_is_told_in_time(x, angle, is_told):
    """A robot that met it with its flippers up pressed against it for seconds."""
    cells = np.zeros((200, 200), bool)
    mobility = mobility_of(MODEL)
    terrain = TerrainCost(mobility, cells, ~cells, (-5.0, -5.0), 0.05, ground=Ground.of(Kerb(), mobility))
    around = SimpleNamespace(to_map=lambda pose: pose, terrain=lambda *_, **__: terrain)
    driver = Navigator(SimpleNamespace(components=()), MODEL, around)  # type: ignore[arg-type]
    driver._mobility, driver._flippers = mobility_of(MODEL), angle
    ahead = driver._seen_ahead([PathPoint(x, 0.0), PathPoint(4.0, 0.0)], PlanarPose(x, 0.0, 0.0))
    assert ahead.free == navigator.LOOK_AHEAD
    assert (ahead.step is terrain) is is_told


async def test_a_part_that_the_robot_refused_is_not_taken_for_driven(inc1):
    """The next one would begin somewhere else, with the flippers for another place."""

    async def refused() -> RobotPose:
        raise RequestError("refused")

    driver = Navigator(inc1, MODEL, SimpleNamespace())  # type: ignore[arg-type]
    driver._rest = [Part((PathPoint(1.0, 0.0), PathPoint(2.0, 0.0)), None)]
    driver._course = asyncio.create_task(refused())
    await asyncio.wait({driver._course})
    assert await driver._next_part() is False
    assert driver._rest == []
