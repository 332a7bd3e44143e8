"""The way that a robot's navigator drives and the costs that it sees, for the map of the tab World."""

from __future__ import annotations

import asyncio
import base64
import math
from collections.abc import Callable
from typing import Any, Final

from jauspy.errors import JausError
from jauspy.messages.iop import QueryCostMap2D, QueryPath, ReportCostMap2D, ReportPath
from jauspy.ocu.robot import Robot

INTERVAL: Final = 1.0
"""Seconds between two queries."""
MAX_POINTS: Final = 1000
"""Points of a way that browsers get."""
PATH_REPORTER: Final = "iop:PathReporter"
COST_MAP: Final = "iop:CostMap2D"


class PlannedWay:
    """The planned path and the cost map of the robot's first component with PathReporter and CostMap2D."""

    def __init__(self, robot: Callable[[], Robot | None]) -> None:
        self.way: list[list[float]] = []
        """Points in the local frame, metres, y left."""
        self.costs: dict[str, Any] | None = None
        """The cost map as browsers get it; None without one that can be drawn."""
        self.version = 0
        """Changes with both."""
        self._robot = robot

    async def run(self) -> None:
        """Follow the navigator until cancelled."""
        while True:
            robot = self._robot()
            way: list[list[float]] = []
            costs = None
            try:
                if robot is not None:
                    way, costs = await _way(robot), await _costs(robot)
            except JausError:
                pass  # it does not answer: nothing is drawn
            if (way, costs) != (self.way, self.costs):
                self.way, self.costs, self.version = way, costs, self.version + 1
            await asyncio.sleep(INTERVAL)

    def message(self) -> dict[str, Any]:
        """The way and the costs for browsers."""
        return {"path": self.way, "costs": self.costs}


async def _way(robot: Robot) -> list[list[float]]:
    component = next(iter(robot.info.offering(PATH_REPORTER)), None)
    if component is None:
        return []
    query = QueryPath(QueryPath.PathType.PLANNED_LOCAL_PATH, maximum_points=MAX_POINTS)
    report = await robot.component(component.id).service(PATH_REPORTER).query(query, expects=ReportPath)
    found = report.path_var
    if not isinstance(found, ReportPath.PlannedLocalPath):
        return []
    points = [(point.x, point.y) for point in found.planned_local_path[:MAX_POINTS]]
    return [
        [round(x, 2), round(-y, 2)]
        for x, y in points
        if x is not None and y is not None and math.isfinite(x) and math.isfinite(y)
    ]


async def _costs(robot: Robot) -> dict[str, Any] | None:
    component = next(iter(robot.info.offering(COST_MAP)), None)
    if component is None:
        return None
    report = await robot.component(component.id).service(COST_MAP).query(QueryCostMap2D(), expects=ReportCostMap2D)
    return drawn_costs(report)


def drawn_costs(report: ReportCostMap2D) -> dict[str, Any] | None:
    """A cost map as browsers get it; None for one without cells, on the globe, or whose numbers do not fit together.

    Middle and sides in metres, yaw in radians, rows from the left of the map to its right, a byte a cell: 255 unknown.
    """
    size, place, data = report.cost_map2d_rec, report.cost_map2d_pose_var, report.cost_map2d_data_var
    if not isinstance(place, type(report).CostMap2DLocalPoseRec) or not isinstance(data, type(report).CostDataList):
        return None
    cells = data.cost_data_list
    rows, columns = size.number_of_rows, size.number_of_columns
    if not cells or rows * columns != len(cells) or not (size.map_width > 0.0 and size.map_height > 0.0):
        return None
    return {
        "rows": rows,
        "columns": columns,
        "width": round(size.map_width, 3),
        "height": round(size.map_height, 3),
        "x": round(place.map_center_x, 3),
        "y": round(-place.map_center_y, 3),
        "yaw": round(-place.map_rotation, 4),
        "cells": base64.b64encode(bytes(cell.cost for cell in cells)).decode(),
    }
