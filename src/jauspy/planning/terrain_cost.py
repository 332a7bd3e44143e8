"""Cost of driving for one robot in a map: where its footprint fits, and which ground its tracks and flippers climb.

Inputs are a 2-D occupancy map and the ground, in one frame (metres, x and y of the map, z up). Where heights are
known they decide, since a lidar that scans one plane takes a ramp for a wall; elsewhere the occupancy does.
"""

from __future__ import annotations

import math
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from jauspy.geometry.poses import PlanarPose
from jauspy.planning.footprint import Footprint
from jauspy.planning.ground import Array, Cells, Ground
from jauspy.planning.mobility import Mobility

Points: TypeAlias = NDArray[np.float64]

OCCUPIED: Final = 0.5
"""Log odds above which a cell of an occupancy grid counts as an obstacle."""
MARGIN: Final = 0.02
"""Metres that stay free beside the footprint; with the sizes of cells, a door of 0.9 m is 0.75 m wide to the search."""
COMFORTABLE: Final = 0.12
"""Metres beside the footprint below which a way costs more: a robot is 4 cm and 5 degrees off its leg at times, and a
door of 0.95 m leaves inc1 as much only where it drives straight through the middle."""
TURN_ROOM: Final = 0.05
"""Metres that stay free beside the exact footprint of a robot that turns, in addition: tracks slip, and a robot turns
some centimetres before or behind the corner of its way."""
PREFERRED: Final = 0.4
"""Metres beside the footprint from which on distance costs nothing more."""
NEAR_COST: Final = 2.0
SLOPE_COST: Final = 2.0
STEP_COST: Final = 4.0
UNKNOWN_COST: Final = 0.5
LOW_COST: Final = 2.5
"""Added to the cost of a metre: beside an obstacle, on the steepest slope, at a step for flippers, where nothing is
known, over low things."""
LOW: Final = 0.04
"""Metres of a step from which on it may be a thing that lies there: the tracks pass it, but rather beside it."""
THING_COST: Final = 6.0
"""Added to the cost of a metre over what lies on the ground and can be driven around: straps, bases of cones."""
EDGE: Final = 0.15
"""Metres beside a step that needs flippers in which nothing is told from it."""
THING_ROOM: Final = 0.08
"""Metres that stay free beside what lies on the ground, in addition: not all of it is seen."""
STEP_HEADING: Final = math.radians(25.0)
"""Greatest angle between the heading and the way up a step that needs flippers, radians."""
SCAN_ERROR: Final = 0.15
"""Metres below the plane of the scans from which on ground is taken for what the scans saw."""
SHADOW: Final = 0.4
SEEN_SINCE: Final = 1.0
SHADOW_COST: Final = 6.0
"""Metres beside what is lower than the plane of the scans in which ground may be a part of it that was not seen, or so
many seconds before that: cameras see the side of a crate that faces them. And what is added to the cost of a metre over
such ground."""
PLANE_ERROR: Final = 0.05
"""Metres above the plane of the scans up to which they may pass above something."""
STEP_ERROR: Final = 0.005
"""Metres by which an edge that is partly in a cell looks lower than it is."""
SURROUNDED: Final = 0.9
"""Part of the cells around one whose heights must be known for ground to be told from a wall."""
LEVEL: Final = 0.01
"""Slope, as a tangent, below which ground has no way up."""
START_RADIUS: Final = 0.8
"""Metres around the start within which the robot may be as close to an obstacle as it is."""


class TerrainCost:
    """Cells of `resolution` metres from `origin`, the corner of the first one, in x and y; rows along y.

    `occupied` and `known` have the shape of the map. With `allow_unknown`, unknown cells cost more; else they are
    obstacles. Further obstacles, such as echoes of the last scan, are `points`, shape (n, 2). `scan_height` is the
    height of the plane of the scans in the frame of the ground, metres: ground that rises to it is no wall.
    """

    def __init__(
        self,
        mobility: Mobility,
        occupied: Cells,
        known: Cells,
        origin: tuple[float, float],
        resolution: float,
        *,
        ground: Ground | None = None,
        points: Points | None = None,
        allow_unknown: bool = True,
        scan_height: float = math.inf,
    ) -> None:
        self.mobility = mobility
        self.origin = origin
        self.resolution = resolution
        self.shape = occupied.shape
        blocked = occupied.copy()
        if points is not None and len(points):
            rows, columns, inside = self.cells(points)
            blocked[rows[inside], columns[inside]] = True
        self._gradient: tuple[Array, Array] | None = None
        """Slope of the ground along x and y; None where it is not known."""
        self._steps: Cells | None = None
        """Cells with a step that needs flippers; None without any."""
        self._to_step: tuple[Array, NDArray[np.intp]] | None = None
        """Metres from each cell to the nearest of them, and its row and column."""
        self._things: Cells | None = None
        """Cells with something that lies on the ground; None without any."""
        slope_cost = np.zeros(self.shape, np.float32)
        if ground is not None:
            slope_cost, known = self._add_ground(ground, blocked, known, scan_height)
        self.known = known
        self.blocked = blocked if allow_unknown else blocked | ~known
        self.centres, self.radius = mobility.circles
        self.margin = MARGIN
        """Metres that stay free beside the footprint."""
        self.is_exact = False
        """True to pass with the exact footprint, false with one that is some decimetres longer at both ends."""
        self.distance = self._to_blocked = self._distances(self.blocked)
        """Metres from the centre of each cell to the nearest blocked one."""
        self._footprint = self._footprint_in(self.distance)
        self.cost = self._costs(slope_cost)
        """Cost of a metre in each cell, 1 on free and level ground."""
        self._start: PlanarPose | None = None
        self._start_clearance = math.inf
        self._starts_at_step = False

    @property
    def has_things(self) -> bool:
        """True if something lies on the ground that the robot could drive over."""
        return self._things is not None

    def keep_off_things(self, keep_off: bool) -> None:
        """Take such things for obstacles, or again for ground that costs more."""
        distance = self._to_blocked
        if keep_off and self._things is not None:
            distance = np.minimum(self._to_blocked, self._distances(self._things) - np.float32(THING_ROOM))
        if distance is not self.distance:
            self.distance, self._footprint = distance, self._footprint_in(distance)

    def _footprint_in(self, distance: NDArray[np.float32]) -> Footprint:
        return Footprint(self.mobility, distance, self.origin, self.resolution)

    # --- cells ------------------------------------------------------------------------------------------------------

    def cells(self, points: Points) -> tuple[NDArray[np.intp], NDArray[np.intp], Cells]:
        """Rows and columns of points, shape (n, 2), and which of them are in the map."""
        place = np.floor((points - self.origin) / self.resolution).astype(np.intp)
        columns, rows = place[..., 0], place[..., 1]
        inside = (columns >= 0) & (rows >= 0) & (columns < self.shape[1]) & (rows < self.shape[0])
        return rows, columns, inside

    def cell(self, x: float, y: float) -> tuple[int, int] | None:
        """Row and column of a point; None outside of the map."""
        column = math.floor((x - self.origin[0]) / self.resolution)
        row = math.floor((y - self.origin[1]) / self.resolution)
        inside = 0 <= row < self.shape[0] and 0 <= column < self.shape[1]
        return (row, column) if inside else None

    def _distances(self, blocked: Cells) -> Array:
        if not blocked.any():
            return np.full(self.shape, np.float32(1e3))
        found = np.asarray(ndimage.distance_transform_edt(~blocked), np.float64)
        return np.asarray(found * self.resolution, np.float32)

    def _costs(self, slope_cost: Array) -> Array:
        width = self.mobility.half_width + self.margin
        near = np.clip(1.0 - (self.distance - width) / PREFERRED, 0.0, 1.0)
        cost = 1.0 + NEAR_COST * near**2 + slope_cost + UNKNOWN_COST * ~self.known
        if self._steps is not None:
            cost = cost + STEP_COST * self._steps
        return np.asarray(cost, np.float32)

    # --- ground -----------------------------------------------------------------------------------------------------

    def _add_ground(self, ground: Ground, blocked: Cells, known: Cells, scan_height: float) -> tuple[Array, Cells]:
        """Block what the robot cannot climb; returns the cost of slopes, and the known cells."""
        mobility = self.mobility
        side = ground.resolution
        ground = ground.resampled(self.origin, self.resolution, self.shape)
        walls, steps, slope_x, slope_y = ground.walls, ground.steps, ground.slope_x, ground.slope_y
        seen = ~np.isnan(ground.heights)
        steep = np.hypot(slope_x, slope_y) > math.tan(max(mobility.up, mobility.down, mobility.side))
        wall = seen & (walls > mobility.flipper_step)
        tall = ground.heights >= scan_height - SCAN_ERROR
        reach = 2 * max(1, round(side / self.resolution)) + 1
        scanned = ndimage.maximum_filter(blocked, reach)
        surrounded = ndimage.uniform_filter(seen.astype(np.float32), 3) > SURROUNDED
        # a wall to the lidar that is a slope to the robot
        blocked &= ~(seen & ~wall & tall & ~steep & surrounded)
        # a wall that reaches the plane of the scans is where they saw it, in smaller cells, or where they will see it
        crossed = ground.heights > scan_height + PLANE_ERROR
        blocked |= wall & ~(tall & scanned) & ~(crossed & (ground.old > 0.0))
        shadow = self._shadow(wall & ~crossed & ~scanned, ground)
        # what is seen of a wall from the ground up looks like a step; none is climbed so close to one
        beside_wall = ndimage.maximum_filter(blocked, 2 * round(mobility.half_width / self.resolution) - 1)
        blocked |= seen & steep
        high = seen & (steps > mobility.step - STEP_ERROR) & ~blocked & ~beside_wall
        if high.any():
            self._steps = high
            far, nearest = ndimage.distance_transform_edt(~high, return_indices=True)
            self._to_step = np.asarray(far * self.resolution, np.float32), nearest
        self._gradient = slope_x, slope_y
        grade = np.arctan(np.hypot(slope_x, slope_y)) / max(mobility.up, 1e-6)
        things = ground.things
        if high.any():  # a part of an edge
            things[ndimage.maximum_filter(high, 2 * round(EDGE / self.resolution) + 1)] = 0.0
        if things.any():
            self._things = things > 0.0
        low = np.maximum(THING_COST * things, LOW_COST * (seen & (steps > LOW) & ~beside_wall))
        low = np.maximum(low, SHADOW_COST * shadow)
        under_tracks = ndimage.maximum_filter(low, 2 * round(mobility.half_width / self.resolution) + 1)
        cost = SLOPE_COST * np.minimum(1.0, grade) ** 2 + under_tracks
        return cost.astype(np.float32), known | seen

    def _shadow(self, low: Cells, ground: Ground) -> Cells:
        """Ground beside low things that may be a part of them: it was not seen, or not since the thing was."""
        if not low.any():
            return np.zeros(self.shape, np.bool_)
        far, nearest = ndimage.distance_transform_edt(~low, return_indices=True)
        before = ground.age > ground.age[nearest[0], nearest[1]] + SEEN_SINCE
        return np.asarray((far * self.resolution <= SHADOW) & ~low & (before | (ground.hidden > 0.0)))

    def slope_at(self, x: float, y: float) -> tuple[float, float]:
        """Slope of the ground along x and y, as tangents; 0 where it is not known."""
        cell = self.cell(x, y)
        if self._gradient is None or cell is None:
            return 0.0, 0.0
        slope_x, slope_y = self._gradient
        return float(slope_x[cell]), float(slope_y[cell])

    def needs_flippers(self, x: float, y: float) -> bool:
        """True at a step that only flippers climb."""
        cell = self.cell(x, y)
        return cell is not None and self._steps is not None and bool(self._steps[cell])

    def ways_up(self) -> tuple[Array, Array] | None:
        """Unit vectors, x and y, up the step at which a robot with its centre in a cell is, NaN in other cells.

        None without any step that needs flippers.
        """
        if self._to_step is None or self._gradient is None:
            return None
        far, nearest = self._to_step
        up_x, up_y = (slope[nearest[0], nearest[1]] for slope in self._gradient)
        length = np.hypot(up_x, up_y)
        away = far >= self.mobility.half_width
        if self._starts_at_step and self._start is not None:
            ys, xs = np.indices(self.shape) * self.resolution + self.resolution / 2.0
            away |= np.hypot(xs + self.origin[0] - self._start.x, ys + self.origin[1] - self._start.y) < START_RADIUS
        length[away | (length < LEVEL)] = np.nan
        return up_x / length, up_y / length

    def _can_climb(self, x: float, y: float, heading: float, *, backward: bool = False) -> bool:
        """True if the ground at a point can be driven on with this heading."""
        if self._gradient is None:
            return True
        slope_x, slope_y = self.slope_at(x, y)
        c, s = math.cos(heading), math.sin(heading)
        ahead, across = slope_x * c + slope_y * s, slope_y * c - slope_x * s
        if self.needs_flippers(x, y):
            return not backward and _is_straight_up(ahead, across)
        mobility = self.mobility
        return -math.tan(mobility.down) <= ahead <= math.tan(mobility.up) and abs(across) <= math.tan(mobility.side)

    def is_astride(self, x: float, y: float, heading: float) -> bool:
        """True if a part of the robot is at a step that needs flippers: it passes there, and does not stop."""
        return self._step_below(x, y, heading) is not None

    def _step_below(self, x: float, y: float, heading: float) -> NDArray[np.intp] | None:
        """Row and column of the nearest step that needs flippers and is below the robot; None without one."""
        if self._to_step is None:
            return None
        far, nearest = self._to_step
        c, s = math.cos(heading), math.sin(heading)
        cells = [self.cell(x + centre * c, y + centre * s) for centre in self.centres]
        inside = [cell for cell in cells if cell is not None]
        closest = min(inside, key=lambda cell: far.item(*cell), default=None)
        if closest is None or far.item(*closest) >= self.radius:
            return None
        return np.asarray(nearest[:, closest[0], closest[1]])

    def _passes_steps(self, x: float, y: float, heading: float) -> bool:
        """True if no part of the robot is at a step that needs flippers, or the robot heads straight up it."""
        step = self._step_below(x, y, heading)
        if step is None:
            return True
        assert self._gradient is not None
        slope_x, slope_y = (float(slope[step[0], step[1]]) for slope in self._gradient)
        c, s = math.cos(heading), math.sin(heading)
        return _is_straight_up(slope_x * c + slope_y * s, slope_y * c - slope_x * s)

    # --- poses ------------------------------------------------------------------------------------------------------

    def start_at(self, pose: PlanarPose) -> None:
        """Let the robot be as close to obstacles around this pose as it is there."""
        self._start = pose
        self._start_clearance = self.clearance(*pose)
        self._starts_at_step = not self._passes_steps(*pose)

    def clearance(self, x: float, y: float, heading: float, *, enough: float = COMFORTABLE) -> float:
        """Metres between the footprint and the nearest blocked cell; below 0 inside of it, -inf outside of the map.

        From `enough` on it may be more.
        """
        return self._footprint.clearance(x, y, heading, enough, is_exact=self.is_exact)

    def clearances(self, xs: Points, ys: Points, heading: float) -> Array:
        """Clearances at points, shape (n,), with one heading."""
        return self._footprint.clearances(xs, ys, heading, is_exact=self.is_exact)

    def room(self, x: float, y: float) -> float:
        """Metres by which a robot may be off a point and still turn there; below 0 without any."""
        cell = self.cell(x, y)
        return -math.inf if cell is None else self.distance.item(*cell) - self._footprint.reach

    def is_free(self, x: float, y: float, heading: float, *, backward: bool = False, turns: bool = False) -> bool:
        """True if the robot fits there and can drive on, or backward, with this heading (radians).

        Beside the footprint the `margin` stays free, and `TURN_ROOM` more beside the exact one of a robot that turns.
        """
        enough = self.margin + TURN_ROOM
        return not math.isinf(self.free_clearance(x, y, heading, backward=backward, turns=turns, enough=enough))

    def free_clearance(
        self,
        x: float,
        y: float,
        heading: float,
        *,
        backward: bool = False,
        turns: bool = False,
        enough: float = COMFORTABLE,
    ) -> float:
        """The clearance where `is_free` is true, else -inf; from `enough` on it may be more."""
        wanted, relaxed, start = self.margin, False, self._start
        if turns and self.is_exact:
            wanted += TURN_ROOM
        if start is not None and math.hypot(x - start.x, y - start.y) < START_RADIUS:
            wanted, relaxed = min(wanted, self._start_clearance), self._starts_at_step
        clearance = self.clearance(x, y, heading, enough=enough)
        is_free = (
            clearance >= wanted
            and self._can_climb(x, y, heading, backward=backward)
            and (relaxed or self._passes_steps(x, y, heading))
        )
        return clearance if is_free else -math.inf

    def all_free(self, xs: Points, ys: Points, heading: float, *, backward: bool = False) -> bool:
        """True if the robot is free at all of these points, shape (n,), with one heading, as by `is_free`."""
        near = np.zeros(len(xs), np.bool_)
        if self._start is not None:
            near = np.hypot(xs - self._start.x, ys - self._start.y) < START_RADIUS
        wanted = np.where(near, min(self.margin, self._start_clearance), self.margin)
        if (self.clearances(xs, ys, heading) < wanted).any():
            return False
        if self._gradient is None:
            return True
        relaxed = near & self._starts_at_step
        return all(
            self._can_climb(x, y, heading, backward=backward) and (ignored or self._passes_steps(x, y, heading))
            for x, y, ignored in zip(xs.tolist(), ys.tolist(), relaxed.tolist(), strict=True)
        )

    def costs_at(self, xs: Points, ys: Points) -> Array:
        """Cost of a metre at points, shape (n,); inf outside of the map."""
        rows, columns, inside = self.cells(np.column_stack([xs, ys]))
        found = np.full(len(xs), np.inf)
        found[inside] = self.cost[rows[inside], columns[inside]]
        return found

    def cost_at(self, x: float, y: float) -> float:
        """Cost of a metre at a point; inf outside of the map."""
        cell = self.cell(x, y)
        return math.inf if cell is None else self.cost.item(*cell)


def _is_straight_up(ahead: float, across: float) -> bool:
    """True for slopes ahead and across of a robot that heads up: flippers climb steps so, and never down."""
    return ahead > 0.0 and abs(math.atan2(across, ahead)) <= STEP_HEADING
