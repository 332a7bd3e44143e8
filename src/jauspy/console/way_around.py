"""Waypoints around what a robot's map shows, for the tab World: from where it is to points that were clicked."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Sequence
from importlib.util import find_spec
from typing import TYPE_CHECKING

from jauspy.console.languages import sentence
from jauspy.console.mission import Area
from jauspy.console.route import MAX_WAYPOINTS, Waypoint
from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from jauspy.console.world import World
    from jauspy.mapping.mapper import Mapper
    from jauspy.platform.description import RobotModel


async def way_around(world: World, goals: Sequence[Waypoint], areas: Sequence[Area] = ()) -> list[Waypoint]:
    """Waypoints of the local frame from the robot to each of these points in turn, outside the no-go areas.

    Raises `NoPath` when there is no way, and `ConfigError` when map, pose or shape of the robot are not known.
    """
    if find_spec("numpy") is None or find_spec("scipy") is None:
        raise ConfigError(sentence("a way around obstacles needs numpy and scipy: pip install 'jauspy[planning]'"))
    if world.mapping is None or not world.mapping.mapper.path or world.pose is None:
        raise ConfigError(sentence("there is no map of what is around the robot yet; wait for its first scan"))
    if world.model is None:
        raise ConfigError(
            sentence("the shape of this robot is not known here; give its file, as in `jauspy console --file`")
        )
    pose = PlanarPose(world.pose.x, world.pose.y, world.pose.yaw)
    points = [(goal.x, goal.y) for goal in goals if goal.is_point]
    found = await asyncio.to_thread(_planned, world.mapping.mapper, world.model, pose, points, areas)
    if len(found) > MAX_WAYPOINTS:
        raise ConfigError(
            sentence(
                "the way has {count} corners; {most} are possible, so choose a nearer point",
                count=len(found),
                most=MAX_WAYPOINTS,
            )
        )
    return found


def _inside(mapper: Mapper, areas: Sequence[Area]) -> NDArray[np.bool_]:
    """The cells of the map whose middle is in one of the areas."""
    import numpy as np  # noqa: PLC0415 - comes with the extra `map`

    grid = mapper.grid
    middles = grid.low + grid.resolution * (np.arange(len(grid.log_odds)) + 0.5)
    x, y = np.meshgrid(middles, middles)
    found = np.zeros(grid.log_odds.shape, bool)
    for area in areas:
        corners = [mapper.correction @ PlanarPose(*corner) for corner in area.corners]
        inside = np.zeros_like(found)
        for begin, end in zip(corners, (*corners[1:], corners[0]), strict=True):
            if begin.y != end.y:
                edge = begin.x + (end.x - begin.x) * (y - begin.y) / (end.y - begin.y)
                inside ^= ((begin.y > y) != (end.y > y)) & (x < edge)
        found |= inside
    return found


def _planned(
    mapper: Mapper,
    model: RobotModel,
    pose: PlanarPose,
    points: Sequence[tuple[float, float]],
    areas: Sequence[Area],
) -> list[Waypoint]:
    from jauspy.planning.mobility import mobility_of  # noqa: PLC0415 - needs numpy
    from jauspy.planning.path_search import find_path  # noqa: PLC0415 - needs scipy
    from jauspy.planning.terrain_cost import OCCUPIED, TerrainCost  # noqa: PLC0415 - needs scipy

    grid, odds = mapper.grid, mapper.grid.log_odds.copy()
    closed = _inside(mapper, areas)
    terrain = TerrainCost(
        mobility_of(model), (odds > OCCUPIED) | closed, closed | (odds != 0.0), (grid.low, grid.low), grid.resolution
    )
    to_local = mapper.correction.inverse()
    here, found = mapper.correction @ pose, list[Waypoint]()
    for x, y in points:
        goal = mapper.correction @ PlanarPose(x, y)
        path = find_path(terrain, here, (goal.x, goal.y), backward=False)
        for point in path.points[1:]:
            place = to_local @ PlanarPose(point.x, point.y)
            found.append(Waypoint(round(place.x, 2), round(place.y, 2)))
        last = path.points[-1]
        if len(path.points) > 1:
            before = path.points[-2]
            here = PlanarPose(last.x, last.y, math.atan2(last.y - before.y, last.x - before.x))
    return found
