"""PathReporter and CostMap2D (AS6091, IOP): what a navigator plans, for consoles and other clients."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Final, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import PlanarPose
from jauspy.messages.iop import (
    AddNoGoZoneResponse,
    QueryPath,
    ReportCostMap2D,
    ReportNoGoZones,
    ReportPath,
    ReportPathReporterCapabilities,
)
from jauspy.planning.driving_map import Corners
from jauspy.planning.path_search import Path
from jauspy.planning.terrain_cost import TerrainCost
from jauspy.services.service import Service

MAX_POINTS: Final = 1000
"""Points of a path in a report."""
MAX_CELLS: Final = 16_000
"""Cells of a reported map: a message of 16 kB; a larger area has larger cells."""
IMPASSABLE: Final = 254
"""Cost of a cell that the robot must not enter; 255 is unknown."""
UNKNOWN: Final = 255
MOST: Final = 6.0
"""Cost of a metre that is reported as 253; that of free, level ground is 1, reported as 0."""
MAX_ZONES: Final = 64


class Planned(Protocol):
    """What is reported: a navigator."""

    @property
    def path(self) -> Path | None:
        """The present way, in the map."""
        ...

    @property
    def terrain(self) -> TerrainCost | None:
        """The cost on which it was found."""
        ...

    @property
    def correction(self) -> PlanarPose:
        """The local frame in the map."""
        ...

    def set_zones(self, zones: Sequence[Corners]) -> None:
        """Keep out of these zones of the local frame from now on."""
        ...


class PathReporter(Service, urn="urn:jaus:jss:iop:PathReporter"):
    """Reports the planned way in the robot's local frame; empty while there is none."""

    def __init__(self, planned: Planned) -> None:
        self._planned = planned

    def is_supported(self, msg: QueryPath) -> bool:
        """Guard: only the planned path, in the local frame."""
        return msg.path_type == QueryPath.PathType.PLANNED_LOCAL_PATH

    def send_report_path_reporter_capabilities(self) -> ReportPathReporterCapabilities:
        """The one kind of path."""
        record = ReportPathReporterCapabilities.PathReporterCapabilitiesRec
        return ReportPathReporterCapabilities(
            [record(record.PathType.PLANNED_LOCAL_PATH, 0.0, 10000.0, maximum_points=MAX_POINTS)]
        )

    def send_report_path(self, msg: QueryPath) -> ReportPath:
        """The way, thinned out to the distance of points that was asked for, and cut to their number and its length."""
        path = self._planned.path
        points = [] if path is None else [(point.x, point.y) for point in path.points]
        wanted = min(MAX_POINTS, MAX_POINTS if msg.maximum_points is None else msg.maximum_points)
        far = math.inf if msg.maximum_distance is None else float(msg.maximum_distance)
        kept = _thinned(points, msg.target_resolution or 0.0, far)[:wanted]
        to_local = self._planned.correction.inverse()
        places = [to_local @ PlanarPose(x, y) for x, y in kept]
        poses = [ReportPath.LocalPoseRec(x=place.x, y=-place.y) for place in places]
        return ReportPath(ReportPath.PlannedLocalPath(poses))


def _thinned(points: Sequence[tuple[float, float]], distance: float, length: float) -> list[tuple[float, float]]:
    """The points of a way that are at least so far apart, with its end, up to a length."""
    found: list[tuple[float, float]] = []
    driven = 0.0
    for number, point in enumerate(points):
        if number:
            driven += math.dist(points[number - 1], point)
        if driven > length:
            break
        if not found or number == len(points) - 1 or math.dist(found[-1], point) >= distance:
            found.append(point)
    return found


class CostMap2D(Service, urn="urn:jaus:jss:iop:CostMap2D"):
    """Reports the cost of driving, and keeps zones that the navigator does not enter, in the robot's local frame."""

    def __init__(self, planned: Planned) -> None:
        self._planned = planned
        self._zones: dict[int, Corners] = {}
        self._next = 1
        self._added = 0

    def is_supported(self, msg: Any) -> bool:
        """Guard: corners in the local frame, of which at least three make a zone."""
        return isinstance(msg.vertex_var, type(msg).LocalVertexList) and len(msg.vertex_var.local_vertex_list) >= 3

    def zone_exists(self, msg: Any) -> bool:
        """Guard: a zone of this number is kept."""
        return msg.zone_id in self._zones

    def add_no_go_zone(self, msg: Any) -> None:
        """Keep a zone; the oldest of too many is forgotten."""
        self._zones[self._next] = tuple((corner.x, -corner.y) for corner in msg.vertex_var.local_vertex_list)
        self._added, self._next = self._next, self._next % 65535 + 1
        if len(self._zones) > MAX_ZONES:
            del self._zones[next(iter(self._zones))]
        self._planned.set_zones(tuple(self._zones.values()))

    def remove_no_go_zone(self, msg: Any) -> None:
        """Forget a zone."""
        del self._zones[msg.zone_id]
        self._planned.set_zones(tuple(self._zones.values()))

    def send_add_no_go_zone_response(self, msg: Any) -> AddNoGoZoneResponse:
        """The number of the zone, or why there is none."""
        code = AddNoGoZoneResponse.ResponseCode
        if self.is_supported(msg):
            return AddNoGoZoneResponse(msg.request_id_rec.request_id, code.SUCCESS, self._added)
        is_local = isinstance(msg.vertex_var, type(msg).LocalVertexList)
        refused = code.LOCAL_VERTICES_NOT_SUPPORTED if is_local else code.GLOBAL_VERTICES_NOT_SUPPORTED
        return AddNoGoZoneResponse(msg.request_id_rec.request_id, refused, 0)

    def send_report_no_go_zones(self, msg: Any) -> ReportNoGoZones:
        """The zone of this number, all for 0."""
        report = ReportNoGoZones
        return report(
            [
                report.NoGoZoneSeq(
                    report.ZoneIDRec(number),
                    report.LocalVertexList([report.LocalVertexRec(x, -y) for x, y in corners]),
                )
                for number, corners in self._zones.items()
                if msg.zone_id in (0, number)
            ]
        )

    def send_report_cost_map2d(self, msg: Any) -> ReportCostMap2D:
        """The cost around the middle that was asked for; an empty map before the first way."""
        terrain = self._planned.terrain
        report = ReportCostMap2D
        if terrain is None:
            return report(
                report.CostMap2DRec(0, 0, 0.0, 0.0),
                report.CostMap2DLocalPoseRec(0.0, 0.0, 0.0),
                report.CostDataList([]),
            )
        costs, (left, low), side = reported_costs(terrain, _window(msg, self._planned.correction))
        rows, columns = costs.shape
        middle = self._planned.correction.inverse() @ PlanarPose(left + columns * side / 2.0, low + rows * side / 2.0)
        # rows of the message follow JAUS's y, which is to the right
        cells = [report.CostDataRec(cost) for cost in costs[::-1].reshape(-1).tolist()]
        return report(
            report.CostMap2DRec(rows, columns, columns * side, rows * side),
            report.CostMap2DLocalPoseRec(middle.x, -middle.y, -middle.yaw),
            report.CostDataList(cells),
        )


_Window: TypeAlias = tuple[tuple[float, float] | None, float, float]
"""The middle in the map, None for that of the map, and the greatest width and height, metres."""


def _window(msg: Any, correction: PlanarPose) -> _Window:
    size, middle = msg.query_cost_map2d_rec, msg.query_cost_map2d_center_var
    width, height = (math.inf, math.inf) if size is None else (size.max_width or math.inf, size.max_height or math.inf)
    if not isinstance(middle, type(msg).CostMap2DLocalPoseRec):
        return None, width, height
    place = correction @ PlanarPose(middle.map_center_x, -middle.map_center_y)
    return (place.x, place.y), width, height


def reported_costs(
    terrain: TerrainCost, window: _Window = (None, math.inf, math.inf)
) -> tuple[NDArray[np.uint8], tuple[float, float], float]:
    """Costs 0..255 of a window of a map, rows along y; its corner, and the side of a cell, in metres."""
    middle, width, height = window
    side, (rows, columns) = terrain.resolution, terrain.shape
    centre = middle or (terrain.origin[0] + columns * side / 2.0, terrain.origin[1] + rows * side / 2.0)
    spans = []
    for axis, (size, count) in enumerate(((width, columns), (height, rows))):
        first, last = (
            (centre[axis] + sign * min(size, 2.0 * count * side) / 2.0 - terrain.origin[axis]) / side
            for sign in (-1.0, 1.0)
        )
        spans.append((min(count - 1, max(0, round(first))), max(1, min(count, round(last)))))
    (left, right), (low, high) = ((first, max(first + 1, last)) for first, last in spans)
    part = np.s_[low:high, left:right]
    scaled = np.clip((terrain.cost[part] - 1.0) / (MOST - 1.0) * (IMPASSABLE - 1), 0.0, IMPASSABLE - 1)
    costs = scaled.astype(np.uint8)
    costs[~terrain.known[part]] = UNKNOWN
    costs[terrain.distance[part] < terrain.mobility.half_width] = IMPASSABLE
    factor = max(1, math.ceil(math.sqrt(costs.size / MAX_CELLS)))
    corner = (terrain.origin[0] + left * side, terrain.origin[1] + low * side)
    return _coarser(costs, factor), corner, side * factor


def _coarser(costs: NDArray[np.uint8], factor: int) -> NDArray[np.uint8]:
    """Blocks of cells as one: the highest cost of what is known in it."""
    if factor == 1:
        return costs
    rows, columns = (-(-count // factor) * factor for count in costs.shape)
    padded = np.full((rows, columns), UNKNOWN, np.uint8)
    padded[: costs.shape[0], : costs.shape[1]] = costs
    blocks = padded.reshape(rows // factor, factor, columns // factor, factor)
    known: NDArray[np.uint8] = np.where(blocks == UNKNOWN, 0, blocks).max(axis=(1, 3)).astype(np.uint8)
    known[(blocks == UNKNOWN).all(axis=(1, 3))] = UNKNOWN
    return known


def navigation_services(planned: Planned) -> list[Service]:
    """The services of a navigator's component, besides the core ones."""
    return [PathReporter(planned), CostMap2D(planned)]
