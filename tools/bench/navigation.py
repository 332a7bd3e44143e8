"""How well inc1 finds its way in simulated worlds: goals reached, contacts, length of the way driven.

python tools/bench/navigation.py [--world yard street house] [--goals 50] [--seed 1] [--moved] [--blind] [--json FILE]

The robot navigates with what its sensors measure, over JAUS, on virtual time in MuJoCo's physics: its localisation with
its errors, a lidar that scans one plane, and a depth camera (rays, with noise; not with `--blind`). The bench alone
knows the world: it draws goals that a search on the true heights reaches, and compares the length of the way driven
with the shortest one on a grid of these heights (8 neighbours, half the robot's width away from obstacles, no step that
the robot does not climb). Each drive begins where the last one ended; after a drive that failed the robot begins anew.
Contacts are all of the robot with movable things, and those with walls: where the normal of the contact is not
vertical, and it is no face of a step that the robot climbs. With `--moved` a thing of the world is put 1.6 m ahead of
each drive once it has begun; `new way` is the time until the robot was sent along another one. Exit status 1 if less
than 95 % were reached, or something was touched.
"""

from __future__ import annotations

import argparse
import asyncio
import dataclasses
import itertools
import json
import math
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

from jauspy.cloud.stream import Cloud
from jauspy.errors import JausError
from jauspy.geometry.poses import PlanarPose
from jauspy.ocu import OCU
from jauspy.planning.driving_map import DrivingMap, heights_of_clouds
from jauspy.planning.mobility import Mobility, mobility_of
from jauspy.planning.navigator import NavigationProgress, Navigator
from jauspy.planning.path_search import NoPath, PathPoint, find_path
from jauspy.planning.terrain_cost import TerrainCost
from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files
from jauspy.robot.robot_files import robot_model
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime
from jauspy_sim.models.groups import COLLISION, VISUAL
from jauspy_sim.robot import SimulatedRobot

SIDE, CELL = 22.0, 0.1
"""Metres of the true map, and of its cells."""
ABOVE = 4.0
"""Height, metres, from which rays look down."""
HEADROOM = 0.5
"""Metres above the ground from which on what hangs is no obstacle."""
STARTS = {"house": (2.7, 0.0)}
"""Places where the robot is put at the start, metres; elsewhere it stands where the world has it."""
THIN = 0.12
"""Metres of what may stand between the rays from above, such as doors and fences: level rays find it."""
RISE = 0.03
"""Metres above the highest step of the level rays."""
NEAR, FAR = 2.0, 12.0
"""Lengths of the shortest ways to goals, metres."""
ROOM = 0.6
"""Metres from a goal to obstacles."""
TRIES = 20
"""Goals that are tried for one that the robot can reach."""
CAMERA, FIELD, RAYS, REACH = "chassis_camera_link", math.radians(80.0), (100, 64), 6.0
"""Depth camera: its link, field of view, rays across and down, and range in metres."""
LOOK_INTERVAL = 0.25
"""Seconds between two of its clouds."""
LIMIT = 180.0
"""Seconds of a drive, simulated."""
MOVED = 0.05
"""Metres of the robot that count as a part of its way; less is what it sways."""
AT_GOAL = 0.5
"""Metres from the goal within which it is reached, by the true pose."""
LONGER = 1.2
"""Ratio of the way to the shortest one above which a way counts as too long."""
SHARE = 0.95
"""Part of the goals that are to be reached."""
ADDRESS = "bench:depth"
"""Name of the depth camera's clouds."""
MOVABLE = ("crate", "bin", "sofa", "waste_bin", "carton_1")
"""Things that are put into the way; the first that the world has."""


@dataclasses.dataclass(frozen=True)
class TrueHeights:
    """The true heights of a world."""

    origin: tuple[float, float]
    resolution: float
    heights: NDArray[np.float32]


class DepthCamera:
    """A depth camera of the robot: rays into its field of view, with noise, as clouds.

    It stands in for the camera's process, which needs real time and GL.
    """

    def __init__(self, robot: SimulatedRobot, seed: int) -> None:
        self._robot = robot
        self._rng = np.random.default_rng(seed)
        self._body = robot.model.body(f"{robot.name_prefix}{CAMERA}").id
        across, down = (np.linspace(-1.0, 1.0, count) for count in RAYS)
        y, z = np.meshgrid(math.tan(FIELD / 2.0) * across, math.tan(FIELD / 2.0) * down * RAYS[1] / RAYS[0])
        rays = np.stack([np.ones_like(y), y, z], axis=-1).reshape(-1, 3)
        self._rays = rays / np.linalg.norm(rays, axis=1)[:, None]
        shown = [n not in (VISUAL, COLLISION) for n in range(mujoco.mjNGROUP)]
        self._groups = np.array(shown, np.uint8)

    def look(self, now: float) -> Cloud:
        """What it sees at a time, seconds since 1970."""
        model, data, count = self._robot.model, self._robot.data, len(self._rays)
        turn, place = data.xmat[self._body].reshape(3, 3), data.xpos[self._body].copy()
        hit, far = np.zeros(count, np.int32), np.zeros(count)
        rays = np.ascontiguousarray(self._rays @ turn.T)
        mujoco.mj_multiRay(
            model, data, place, rays.reshape(-1), self._groups, 1, self._body, hit, far, None, count, REACH
        )
        bodies = np.where(hit >= 0, model.geom_bodyid[np.maximum(hit, 0)], 0)
        own = np.array([model.body(n).name.startswith(self._robot.name_prefix) for n in range(model.nbody)])
        seen = (hit >= 0) & (far > 0.2) & (far < REACH) & ~own[bodies]
        points = self._rays[seen] * (far[seen] + self._rng.normal(0.0, 0.005, int(seen.sum())))[:, None]
        return Cloud(points.astype("<f4").tobytes(), CAMERA, now)


class Watched:
    """A backend that keeps the robot that it opened, puts it to its start, and counts contacts."""

    name = "sim"

    def __init__(self, start: tuple[float, float] | None) -> None:
        self.start = start
        self.robot: SimulatedRobot | None = None
        self.contacts: Counter[str] = Counter()
        self.way = 0.0
        self.ground: tuple[TrueHeights, float] | None = None
        """The true heights, and the highest step, metres."""
        self._before: tuple[float, float] | None = None

    def open(self, robot: RobotModel, world: str) -> SimulatedRobot:
        """Open the robot."""
        opened = self.robot = SimulatedRobot.open(robot, world)
        if self.start is not None:
            joint = opened.model.body(f"{opened.name_prefix}base_link").jntadr[0]
            address = opened.model.jnt_qposadr[joint]
            opened.data.qpos[address : address + 2] = self.start
            mujoco.mj_forward(opened.model, opened.data)
        advance = opened.advance

        def watched(dt: float) -> None:
            advance(dt)
            self._watch()

        opened.advance = watched  # type: ignore[method-assign]
        return opened

    def _watch(self) -> None:
        robot = self.robot
        assert robot is not None
        pose = robot.drive.pose()
        if self._before is None:
            self._before = pose.x, pose.y
        if (step := math.dist(self._before, (pose.x, pose.y))) > MOVED:
            self.way += step
            self._before = pose.x, pose.y
        model, data = robot.model, robot.data
        contact = data.contact
        rows = zip(contact.geom, contact.frame, contact.dist, contact.pos, strict=False)
        for pair, frame, gap, place in itertools.islice(rows, data.ncon):
            if gap > 0.0:
                continue
            bodies = [model.body(model.geom_bodyid[geom]) for geom in pair]
            own = [body.name.startswith(robot.name_prefix) for body in bodies]
            if own[0] == own[1]:
                continue
            other = bodies[own.index(False)]
            if model.body_dofnum[model.body_rootid[other.id]] or (abs(frame[2]) < 0.7 and self._is_wall(place, pose.z)):
                self.contacts[other.name or "wall"] += 1

    def _is_wall(self, place: NDArray[np.float64], z: float) -> bool:
        """False for a contact with the face of a step that the robot climbs from where it is."""
        if self.ground is None:
            return True
        heights, step = self.ground
        column, row = (round((place[axis] - heights.origin[axis]) / heights.resolution) for axis in (0, 1))
        around = heights.heights[max(0, row - 2) : row + 2, max(0, column - 2) : column + 2]
        return around.size == 0 or float(np.nanmax(around, initial=0.0)) > z + step


def true_heights(robot: SimulatedRobot, step: float) -> TrueHeights:
    """The heights of the world without the robot, by rays from above, and level ones above its highest step."""
    groups = np.array([n not in (VISUAL, COLLISION) for n in range(mujoco.mjNGROUP)], np.uint8)
    count = round(SIDE / CELL)
    low = -SIDE / 2.0
    places = low + (np.arange(count) + 0.5) * CELL
    heights = np.full((count, count), np.nan, np.float32)
    own = {n for n in range(robot.model.nbody) if robot.model.body(n).name.startswith(robot.name_prefix)}
    for row, y in enumerate(places):
        for column, x in enumerate(places):
            heights[row, column] = _height(robot, x, y, own, groups)
    level = step + RISE
    for number, place in enumerate(places):
        for along, line in ((0, heights[number]), (1, heights[:, number])):
            for where in _thin(robot, (along, place, level), own, groups):
                cell = min(count - 1, max(0, math.floor((where - low) / CELL)))
                if line[cell] < RISE:
                    line[cell] = ABOVE
    return TrueHeights((low, low), CELL, heights)


def _thin(
    robot: SimulatedRobot, line: tuple[int, float, float], own: set[int], groups: NDArray[np.uint8]
) -> list[float]:
    """Where a level ray passes through thin things; `line`: along x (0) or y (1), its other coordinate, its height."""
    along, place, level = line
    way, found = np.zeros(3), np.zeros(1, np.int32)
    way[along] = 1.0
    at = np.array([place, place, level])
    at[along] = -SIDE / 2.0
    before: tuple[int, float] | None = None
    thin = []
    while (far := mujoco.mj_ray(robot.model, robot.data, at, way, groups, 1, -1, found)) >= 0.0:
        at[along] += far
        geom, where = int(found[0]), float(at[along])
        if robot.model.geom_bodyid[geom] not in own:
            if before is not None and before[0] == geom and where - before[1] < THIN:
                thin.append((where + before[1]) / 2.0)
            before = geom, where
        at[along] += 1e-3
    return thin


def _height(robot: SimulatedRobot, x: float, y: float, own: set[int], groups: NDArray[np.uint8]) -> float:
    """The height of the highest thing at a point that does not hang above the robot; NaN without any."""
    down, found = np.array([0.0, 0.0, -1.0]), np.zeros(1, np.int32)
    z, solid = ABOVE, dict[int, float]()
    while (far := mujoco.mj_ray(robot.model, robot.data, np.array([x, y, z]), down, groups, 1, -1, found)) >= 0.0:
        z -= far
        geom = int(found[0])
        if robot.model.geom_bodyid[geom] not in own:
            if z <= HEADROOM:
                return float(max([top for top in solid.values() if top > HEADROOM], default=z))
            if geom in solid:  # its lower side
                del solid[geom]
            else:
                solid[geom] = z
        z -= 1e-3
    return math.nan


def true_terrain(heights: TrueHeights, mobility: Mobility) -> TerrainCost:
    """The cost of the true map."""
    known = ~np.isnan(heights.heights)
    return TerrainCost(
        mobility, ~known, known, heights.origin, heights.resolution, elevation=heights, allow_unknown=False
    )


def shortest(terrain: TerrainCost, heights: TrueHeights, start: PlanarPose) -> NDArray[np.float64]:
    """Metres of the shortest way from a place to each cell, half the robot's width away from obstacles."""
    free = terrain.distance >= terrain.mobility.half_width
    begin = terrain.cell(start.x, start.y)
    assert begin is not None
    free[begin] = True
    count = free.size
    cells = np.arange(count).reshape(free.shape)
    rows, columns, lengths = [], [], []
    for down, right in ((0, 1), (1, 0), (1, 1), (1, -1)):
        left = slice(max(0, -right), free.shape[1] - max(0, right))
        there = slice(max(0, right), free.shape[1] + min(0, right))
        one, other = np.s_[: free.shape[0] - down, left], np.s_[down:, there]
        up = heights.heights[other] - heights.heights[one]
        both = free[one] & free[other]
        for first, last, climb in ((one, other, up), (other, one, -up)):
            ok = both & (climb >= -terrain.mobility.step) & (climb <= terrain.mobility.flipper_step)
            rows.append(cells[first][ok])
            columns.append(cells[last][ok])
            lengths.append(np.full(np.count_nonzero(ok), terrain.resolution * math.hypot(down, right)))
    edges = np.concatenate(rows), np.concatenate(columns)
    graph = sparse.csr_matrix((np.concatenate(lengths), edges), shape=(count, count))
    found = csgraph.dijkstra(graph, indices=int(cells[begin]))
    return np.asarray(found, np.float64).reshape(free.shape)


def a_goal(
    terrain: TerrainCost, heights: TrueHeights, here: PlanarPose, rng: np.random.Generator
) -> tuple[tuple[float, float], float] | None:
    """A goal that the robot can reach by the true map, and the metres of the shortest way."""
    ways = shortest(terrain, heights, here)
    rows, columns = np.nonzero(np.isfinite(ways) & (ways > NEAR) & (ways < FAR) & (terrain.distance > ROOM))
    for number in rng.permutation(len(rows))[:TRIES].tolist():
        place = (np.array([columns[number], rows[number]]) + 0.5) * terrain.resolution + terrain.origin
        goal = float(place[0]), float(place[1])
        try:
            find_path(terrain, here, goal, seconds=3.0)
        except NoPath:
            continue
        return goal, float(ways[rows[number], columns[number]])
    return None


async def drive_all(world: str, seed: int, rows: list[dict[str, Any]], options: argparse.Namespace) -> None:
    """Add rows for goals, until one is not reached or there are enough."""
    config = robot_files.load("inc1")
    modules = tuple(module for module in config.modules if module.type not in ("CM-VIS", "CM-AUD"))
    config = config.model_copy(update={"modules": modules, "cameras": (), "microphones": (), "loudspeakers": ()})
    model = robot_model(config)
    watched = Watched(STARTS.get(world))
    rng = np.random.default_rng((seed, len(rows)))
    async with (
        VirtualNetwork() as network,
        RobotRunner(
            config, network.transport, backend=watched, world=world, realtime=VirtualTime, utc_now=network.utc_now
        ),
        OCU("42.1.1", transport=network.transport("42.1.1")) as ocu,
    ):
        robot = await ocu.robot(101)
        simulated = watched.robot
        assert simulated is not None
        at_first, measured = simulated.drive.pose(), await robot.pose()
        true = PlanarPose(at_first.x, at_first.y, at_first.yaw)
        to_local = PlanarPose(measured.x, measured.y, measured.yaw) @ true.inverse()
        mobility = mobility_of(model)
        heights = true_heights(simulated, mobility.flipper_step)
        watched.ground = heights, mobility.flipper_step
        terrain = true_terrain(heights, mobility)
        clouds = None if options.blind else heights_of_clouds(robot, config, model, [], threaded=False)
        surroundings = DrivingMap(robot, threaded=False, heights=clouds)
        looking = asyncio.create_task(look(DepthCamera(simulated, seed), surroundings))
        async with robot.control(), surroundings:
            while len(rows) < options.goals:
                pose = simulated.drive.pose()
                terrain.start_at(PlanarPose(pose.x, pose.y, pose.yaw))
                found = a_goal(terrain, heights, PlanarPose(pose.x, pose.y, pose.yaw), rng)
                if found is None:
                    raise SystemExit(f"{world}: no goal can be reached from ({pose.x:.2f}, {pose.y:.2f})")
                row = await drive_to(robot, surroundings, config, watched, (*found, to_local), moved=options.moved)
                rows.append({"world": world, "seed": seed, "number": len(rows), **row})
                print(json.dumps(rows[-1]), file=sys.stderr, flush=True)
                if not row["reached"]:
                    break
            looking.cancel()


async def look(camera: DepthCamera, surroundings: DrivingMap) -> None:
    """Look with the camera for ever."""
    while (heights := surroundings.heights) is not None:
        heights.offer(ADDRESS, camera.look(heights.now))
        await asyncio.sleep(LOOK_INTERVAL)


async def drive_to(
    robot: Any, surroundings: DrivingMap, config: Any, watched: Watched, found: Any, *, moved: bool
) -> dict[str, Any]:
    """Drive to one goal; the row about it."""
    goal, best, to_local = found
    wanted = to_local @ PlanarPose(*goal)
    navigator = Navigator(robot, robot_model(config), surroundings)
    watched.contacts.clear()
    watched.way, wall = 0.0, time.perf_counter()
    seen: list[NavigationProgress] = []
    searches: list[float] = []
    put, put_at, plans_at_put = False, 0.0, 0
    new_ways: list[float] = []

    def on_progress(progress: NavigationProgress) -> None:
        nonlocal put, put_at, plans_at_put
        seen.append(progress)
        if navigator.path is not None:
            searches.append(navigator.path.search_time)
        if put and progress.plans > plans_at_put:
            new_ways.append(progress.elapsed - put_at)
        if moved and not put and progress.elapsed > 2.0 and progress.left > 2.5:
            put = put_crate(watched, navigator, progress)
            put_at, plans_at_put = progress.elapsed, progress.plans

    simulated = watched.robot
    assert simulated is not None
    first = simulated.drive.pose()
    begun = [round(value, 2) for value in (first.x, first.y, first.yaw)]
    error = ""
    try:
        await navigator.go_to(wanted.x, wanted.y, timeout=LIMIT, progress=on_progress)
    except JausError as problem:
        error = str(problem)
    pose = simulated.drive.pose()
    off = math.dist((pose.x, pose.y), goal)
    if not error and off >= AT_GOAL:
        error = f"the robot ended {off:.2f} m from the goal, and took that for the goal"
    return {
        "start": begun,
        "goal": [round(value, 2) for value in goal],
        "end": [round(value, 2) for value in (pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw)],
        "reached": not error,
        "error": error,
        "way": round(watched.way, 2),
        "best": round(best, 2),
        "contacts": dict(watched.contacts),
        "plans": seen[-1].plans if seen else 0,
        "put": put,
        "new_way": round(new_ways[0], 2) if new_ways else None,
        "seconds": round(seen[-1].elapsed, 1) if seen else 0.0,
        "search_max": round(max(searches, default=0.0), 3),
        "wall": round(time.perf_counter() - wall, 1),
    }


def put_crate(watched: Watched, navigator: Navigator, progress: NavigationProgress) -> bool:
    """Put a movable thing of the world 1.6 m ahead on the way."""
    simulated = watched.robot
    assert simulated is not None
    model, data = simulated.model, simulated.data
    body = next(model.body(name) for name in MOVABLE if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name) >= 0)
    ahead = _at_distance(navigator.ahead(progress.pose), 1.6)
    if ahead is None:
        return False
    local, true = progress.pose, simulated.drive.pose()
    here = navigator.map.to_map(PlanarPose(local.x, local.y, local.yaw))
    place = PlanarPose(true.x, true.y, true.yaw) @ here.inverse() @ PlanarPose(*ahead)
    address = model.jnt_qposadr[body.jntadr[0]]
    data.qpos[address : address + 2] = place[:2]
    speeds = model.jnt_dofadr[body.jntadr[0]]
    data.qvel[speeds : speeds + 6] = 0.0
    mujoco.mj_forward(model, data)
    return True


def _at_distance(points: list[PathPoint], metres: float) -> tuple[float, float] | None:
    for a, b in itertools.pairwise(points):
        length = math.dist(a[:2], b[:2])
        if length >= metres:
            part = metres / length
            return a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)
        metres -= length
    return None


def table(rows: list[dict[str, Any]]) -> list[str]:
    """A line for each world, and one for each failure."""
    columns = (("goals", 5), ("reached", 7), ("touched", 7), ("way / shortest, median", 22), ("p95", 5), ("most", 5))
    heads = (*columns, (f"> {LONGER}", 5), ("longest search, s", 17))
    lines = [" ".join((f"{'world':<8}", *(f"{name:>{width}}" for name, width in heads)))]
    for world, group in itertools.groupby(rows, key=lambda row: row["world"]):
        drives = list(group)
        ratios = np.array([row["way"] / row["best"] for row in drives if row["reached"]] or [math.nan])
        reached, touched = (sum(bool(row[name]) for row in drives) for name in ("reached", "contacts"))
        lines.append(
            f"{world:<8} {len(drives):>5} {reached:>7} {touched:>7} {np.median(ratios):>22.2f} "
            f"{np.percentile(ratios, 95):>5.2f} {ratios.max():>5.2f} {int((ratios > LONGER).sum()):>5} "
            f"{max(row['search_max'] for row in drives):>17.2f}"
        )
        lines += [
            f"  {row['number']:>3}: {row['start']} to {row['goal']}: "
            + "; ".join([*([row["error"]] if row["error"] else []), *(f"touched {name}" for name in row["contacts"])])
            for row in drives
            if row["error"] or row["contacts"]
        ]
        times = sorted(row["new_way"] for row in drives if row["new_way"] is not None)
        if times:
            lines.append(f"  new way after a thing was put: median {np.median(times):.2f} s, most {times[-1]:.2f} s")
    return lines


def main() -> None:
    """Print a table of the worlds, with what failed and why."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--world", nargs="+", default=["yard", "street", "house"])
    parser.add_argument("--goals", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--moved", action="store_true")
    parser.add_argument("--blind", action="store_true")
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    everything: list[dict[str, Any]] = []
    for world in options.world:
        rows: list[dict[str, Any]] = []
        while len(rows) < options.goals:
            asyncio.run(drive_all(world, options.seed, rows, options))
        everything += rows
        if options.json is not None:
            options.json.write_text(json.dumps(everything, indent=1))
    print("\n".join(table(everything)))
    reached = sum(row["reached"] for row in everything)
    sys.exit(reached < SHARE * len(everything) or any(row["contacts"] for row in everything))


if __name__ == "__main__":
    main()
