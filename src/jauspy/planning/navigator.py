"""Drives a robot to a point around what its sensors see: plans, drives a list of waypoints, and plans again."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the robot is

from __future__ import annotations

import asyncio
import itertools
import math
import time
from collections.abc import Callable, Coroutine, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Final, NamedTuple

from jauspy.arguments import check_number
from jauspy.errors import ConfigError, ControlRejected, JausError, RequestError
from jauspy.geometry.poses import PlanarPose
from jauspy.ocu.arm import POSITION_DRIVER
from jauspy.ocu.courses import ENHANCED_DRIVER, CoursePoint
from jauspy.ocu.robot import DEFAULT_SPEED, Robot
from jauspy.ocu.state import RobotPose
from jauspy.planning.driving_map import Corners, DrivingMap
from jauspy.planning.legs import PathPoint, is_leg_free, is_way_free, way_cost, way_length
from jauspy.planning.mobility import Mobility, flipper_joints, mobility_of, with_posture
from jauspy.planning.path_search import (
    GOAL_TOLERANCE,
    ROOMS,
    NoPath,
    NoStand,
    Path,
    find_path_with_margins,
    place_to_stand,
)
from jauspy.planning.stall import Stall
from jauspy.planning.terrain_cost import TerrainCost
from jauspy.planning.way_choice import WayChoice
from jauspy.planning.way_parts import Part, first_metres, nearest_on_leg, parts, without_short_start
from jauspy.platform.description import RobotModel

PERIOD: Final = 0.2
"""Seconds between two looks at the map and at the pose, without a new scan."""
LOOK_AHEAD: Final = 6.0
"""Metres of the way ahead that are checked each time."""
BLOCKING: Final = -0.03
"""Metres beside the footprint within which something blocks the way: noise and cells of the map must not do it in a
door, and the way was planned with more."""
STEP_LOOK: Final = 1.5
"""Metres of the way ahead in which a step is sought for which the flippers are not set."""
STOP_DISTANCE: Final = 1.0
"""Metres to an obstacle on the way within which the robot stops before it plans again."""
REVIEW_INTERVAL: Final = 3.0
"""Seconds after which a way is sought again, since the map knows more."""
ARRIVED: Final = 0.3
"""Metres from the goal within which the robot has arrived, once it stands."""
CERTAIN: Final = 2.0
"""Metres from the goal within which it is refused if the robot cannot stand there: what is seen of edges and walls from
farther away is not certain, so that the robot first drives to the nearest place where it can."""
CORNER_TOLERANCE: Final = 0.12
NARROW_TOLERANCE: Final = 0.04
"""Metres within which a corner of the way counts as reached, and one where the robot just fits."""
PART_TOLERANCE: Final = 0.25
"""Metres within which the end of a part before a step counts as reached: a robot that is past it need not turn back."""
PATH_TOLERANCE: Final = 0.3
NARROW_PATH_TOLERANCE: Final = 0.12
"""Metres beside a leg at whose end the robot need not turn back for it, and those where it just fits: jauspy's robots
turn onto such a leg before they drive."""
SEARCH_TIME: Final = 0.4
LONG_SEARCH_TIME: Final = 6.0
"""Seconds of processor time of a search, with that of the costs, while the robot may drive on, and of one for which it
stands: the first one, and those after a search that found no way in time."""
PATIENCE: Final = 6.0
"""Seconds for which the robot waits for a way when there is none: what stands in it may go."""
DRIFT: Final = 0.03
"""Metres or radians by which the map moves in the local frame before waypoints are sent again: tracks that slip in a
turn move it by decimetres within seconds, and doors leave less than that."""
NEXT: Final = 0.02
"""Metres from the end of a leg within which the next one is driven."""
LEAD: Final = 0.2
"""Metres that a robot drives at most while it gets a new list of waypoints."""
STEP_SPEED: Final = 0.3
TIGHT_SPEED: Final = 0.25
"""m/s at steps, and where the robot just turns: with 0.5 m/s it drives 15 cm past a corner."""
FLIPPER_TOLERANCE: Final = 0.05
"""Radians."""


@dataclass(frozen=True, slots=True)
class NavigationProgress:
    """Progress of a drive: remaining metres of the way, seconds since its start, and how often a new way was taken."""

    left: float
    elapsed: float
    pose: RobotPose
    plans: int
    replanned_in: float
    """Seconds from when the last new way was needed until the robot was sent along it; 0 before that."""


class Navigator:
    """Drives one robot; `surroundings` is entered. The robot must be controlled, with its flippers if it has them."""

    def __init__(
        self, robot: Robot, model: RobotModel, surroundings: DrivingMap, *, speed: float = DEFAULT_SPEED
    ) -> None:
        check_number(speed, "speed")
        if not 0.0 < speed <= 327.0:
            raise ConfigError(
                f"speed={speed:g} is outside 0..327 m/s; to drive backward is for the navigator to choose"
            )
        self.map = surroundings
        self.path: Path | None = None
        """The present way, in the map."""
        self.terrain: TerrainCost | None = None
        """The cost on which it was found."""
        self.planning_time = 0.0
        """Seconds of processor time of the last search, with those of the costs."""
        self._robot = robot
        self._model = model
        self._speed = speed
        self._has_flippers = bool(flipper_joints(model))
        self._backward = any(component.find(ENHANCED_DRIVER) for component in robot.components)
        self._mobility: Mobility | None = None
        self._posture: dict[str, float] = {}
        """Positions of the joints at the first plan."""
        self._flippers: float | None = None
        """Angle to which this navigator has set the flippers; None for where they were."""
        self._plans = 0
        self._replanned_in = 0.0
        self._driven: list[PathPoint] = []
        """Points of the part that is driven, in the map."""
        self._is_tight = False
        self._passed = 0
        """Number of the last of these points that the robot has passed."""
        self._rest: list[Part] = []
        self._course: asyncio.Task[Any] | None = None
        self._choice = WayChoice()
        self._held = False
        """True while the robot stands before something that may be noise, and keeps what is left of its way."""
        self._correction = PlanarPose()

    # --- planning -----------------------------------------------------------------------------------------------------

    async def plan(self, x: float, y: float, *, seconds: float = LONG_SEARCH_TIME) -> Path:
        """The way from where the robot is to a point of the map, in metres.

        Raises `NoPath`, after so many seconds of processor time.
        """
        for value, use in ((x, "x"), (y, "y")):
            check_number(value, use)
            if not math.isfinite(value):
                raise ConfigError(f"{use}={value:g} of the goal is no finite number; give metres")
        mobility = await self._known_mobility()
        pose = self.map.to_map(_planar(await self._robot.pose()))
        self.map.check()
        self.terrain, path = await self.map.compute(self._find, mobility, pose, (x, y), seconds)
        self.path = path
        return path

    def _find(
        self, mobility: Mobility, pose: PlanarPose, goal: tuple[float, float], seconds: float
    ) -> tuple[TerrainCost, Path]:
        began = time.thread_time()
        terrain = self.map.terrain(mobility, [(pose.x, pose.y), goal])
        find = partial(find_path_with_margins, terrain, pose, backward=self._backward)
        try:
            return terrain, find(goal, end=began + seconds)
        except NoStand:
            terrain.margin, terrain.is_exact = ROOMS[0]
            place = None if math.dist(pose[:2], goal) < CERTAIN else place_to_stand(terrain, goal)
            if place is None:
                raise
            return terrain, find(place, end=began + seconds)
        finally:
            self.planning_time = time.thread_time() - began

    async def _known_mobility(self) -> Mobility:
        if self._mobility is None:
            with suppress(JausError):  # a robot that reports no joints has the posture of its file
                self._posture = dict((await self._robot.joints()).positions)
            self._mobility = mobility_of(with_posture(self._model, self._posture))
        return self._mobility

    @property
    def correction(self) -> PlanarPose:
        """The local frame in the map."""
        return self.map.mapper.correction

    def set_zones(self, zones: Sequence[Corners]) -> None:
        """Keep out of these zones, corners in metres of the local frame, from now on."""
        self.map.zones = tuple(zones)

    # --- driving ------------------------------------------------------------------------------------------------------

    async def go_to(
        self,
        x: float,
        y: float,
        *,
        timeout: float = 600.0,
        progress: Callable[[NavigationProgress], None] | None = None,
    ) -> RobotPose:
        """Drive to a point of the map, in metres; returns the pose there, in the local frame.

        Both frames are the same at first; the map compensates for the drift of the other one.

        Raises `NoPath` when there is no way, `RequestError` when the robot does not get there within `timeout` seconds,
        and `ControlRejected` without control. Then, and if the call is cancelled, the robot stops.
        """
        check_number(timeout, "timeout")
        clock = asyncio.get_running_loop().time
        began, self._plans = clock(), 0
        try:
            async with asyncio.timeout(timeout) as limit:
                return await self._drive(x, y, began, progress)
        except TimeoutError:
            if not limit.expired():
                raise
            pose = await self._robot.pose()
            left = self._distance_to(pose, x, y)
            raise RequestError(
                f"the robot is {left:.2f} m from ({x:g}, {y:g}) after {timeout:g} s; allow more time"
            ) from None
        finally:
            await self._end_course()
            self.path = None

    async def _drive(
        self, x: float, y: float, began: float, progress: Callable[[NavigationProgress], None] | None
    ) -> RobotPose:
        clock = asyncio.get_running_loop().time
        await self._take_way(x, y, clock())
        watch, reviewed = Stall(clock()), clock()
        while True:
            if self._course is not None:
                await self.map.wait(self._course, PERIOD)
            elif self._held:
                await asyncio.sleep(PERIOD)
            pose = await self._robot.pose()
            self.map.check()
            now = clock()
            if progress is not None:
                progress(NavigationProgress(self._left(pose), now - began, pose, self._plans, self._replanned_in))
            if self._held:
                free = (await self._look_ahead(pose)).free
                self._choice.look(is_free=free >= LOOK_AHEAD, now=now)
                await (self._resend(pose) if free >= LOOK_AHEAD else self._avoid(x, y, pose, now))
            elif self._course is None or self._course.done():
                if not self._rest and self._has_arrived(pose, x, y):
                    if self._flippers is not None:
                        await self._set_flippers(None)
                    return pose
                if not await self._next_part():
                    watch.count(pose, self._distance_to(pose, x, y), (x, y))
                    await self._take_way(x, y, clock())
            elif watch.is_stalled(pose, now):
                watch.count(pose, self._distance_to(pose, x, y), (x, y))
                await self._take_way(x, y, clock())
            elif (ahead := await self._look_ahead(pose)).free < LOOK_AHEAD:
                self._choice.look(is_free=False, now=now)
                if ahead.free < STOP_DISTANCE:
                    await self._hold(pose)
                await self._avoid(x, y, pose, now)
                reviewed = clock()
            elif ahead.step is not None:
                self._rest = [*parts(self.ahead(pose), ahead.step, flippers=True), *self._rest]
                await self._next_part()
            else:
                self._choice.look(is_free=True, now=now)
                if now - reviewed > REVIEW_INTERVAL:
                    await self._review(x, y, pose)
                    reviewed = clock()
                else:
                    await self._keep_in_map()

    async def _take_way(self, x: float, y: float, needed: float) -> None:
        """Find a way and drive it. Without one the robot stops, and searches for longer, for `PATIENCE` seconds."""
        clock = asyncio.get_running_loop().time
        seconds = SEARCH_TIME if self._plans else LONG_SEARCH_TIME
        while True:
            try:
                path = await self.plan(x, y, seconds=seconds)
                break
            except NoPath:
                await self._end_course()
                if clock() - needed > PATIENCE or not self._plans:
                    raise
                seconds = LONG_SEARCH_TIME
                await asyncio.sleep(max(PERIOD, self.planning_time))
        await self._take(path, needed)

    async def _take(self, path: Path, needed: float) -> None:
        """Drive a way that was needed at this time."""
        await self._follow(path)
        if self._plans:
            self._replanned_in = asyncio.get_running_loop().time() - needed
        self._plans += 1

    async def _avoid(self, x: float, y: float, pose: RobotPose, needed: float) -> None:
        """Take a way around what blocks the present one; one that is much dearer only if that is certain."""
        if self._choice.is_blocked:
            await self._take_way(x, y, needed)
            return
        before = self.path
        with suppress(NoPath):
            path = await self.plan(x, y, seconds=SEARCH_TIME)
            if self._choice.takes_around(path.cost, self._cost_left(pose)):
                await self._take(path, needed)
                return
        self.path = before
        if not self._held:
            await self._keep_in_map()

    async def _review(self, x: float, y: float, pose: RobotPose) -> None:
        """Take another way if it is much better than what is left of the present one."""
        before = self.path
        with suppress(NoPath):
            path = await self.plan(x, y, seconds=SEARCH_TIME)
            if self._choice.takes_better(path.cost, self._cost_left(pose)):
                await self._follow(path)
                self._plans += 1
                return
        self.path = before
        await self._keep_in_map()

    async def _hold(self, pose: RobotPose) -> None:
        """Stop, and keep what is left of the way."""
        rest = self._left_parts(pose)
        await self._end_course()
        self._rest, self._held = rest, True

    async def _resend(self, pose: RobotPose) -> None:
        """Drive what is left of the present way, as the map is now."""
        self._rest, self._held = self._left_parts(pose), False
        self._correction = self.map.mapper.correction
        await self._next_part()

    def _left_parts(self, pose: RobotPose) -> list[Part]:
        """What is left of the present way."""
        if self._held:
            return self._rest
        return [Part(tuple(self.ahead(pose)), self._flippers, self._is_tight), *self._rest]

    async def _keep_in_map(self) -> None:
        """Send the waypoints again if the map has moved in the local frame, in which the robot drives them."""
        moved = self.map.mapper.correction.relative_to(self._correction)
        if math.hypot(moved.x, moved.y) > DRIFT or abs(moved.yaw) > DRIFT:
            await self._resend(await self._robot.pose())

    async def _follow(self, path: Path) -> None:
        assert self.terrain is not None
        self._correction = self.map.mapper.correction
        self._held = False
        self._choice.begin()
        self._rest = parts(path.points, self.terrain, flippers=self._has_flippers)
        await self._next_part()

    async def _next_part(self) -> bool:
        """Drive the next part of the way; false at its end, and if the robot did not drive the last part to its end.

        Raises what ended that, unless the robot refused it.
        """
        course = self._course
        failed = course is not None and course.done() and not course.cancelled()
        error = course.exception() if course is not None and failed else None
        if error is not None and (isinstance(error, ControlRejected) or not isinstance(error, RequestError)):
            raise error
        if error is not None:
            self._rest = []
        if not self._rest:
            return False
        part, *self._rest = without_short_start(self._rest)
        self._driven, self._is_tight, self._passed = list(part.points), part.is_tight, 0
        if course is not None and not course.done():
            self._skip_near_corners()
        speed = self._speed
        if part.flippers is not None:
            speed = min(speed, STEP_SPEED)
        if part.is_tight:
            speed = min(speed, TIGHT_SPEED)
        if part.flippers != self._flippers:
            await self._set_flippers(part.flippers)
        points = [
            self._course_point(start, end, may_turn=part.flippers is None)
            for start, end in itertools.pairwise(self._driven)
        ]
        if points and not self._rest:  # the goal need not be hit as a corner in a door: the robot would turn for it
            points[-1] = replace(points[-1], tolerance=CORNER_TOLERANCE, path_tolerance=CORNER_TOLERANCE)
        elif points:
            points[-1] = replace(points[-1], tolerance=self._tolerance(part.points[-1], PART_TOLERANCE))
        if points:
            await self._begin_course(self._robot.drive_course(points, speed=speed, timeout=3600.0))
        return True

    def _skip_near_corners(self) -> None:
        """Leave out corners that a driving robot may have passed before it has the list, for which it would turn back.

        They stay where the straight way past them is not free.
        """
        assert self.terrain is not None
        points = self._driven
        while (
            len(points) > 2
            and math.dist(points[0][:2], points[1][:2]) < LEAD
            and points[1].backward == points[2].backward
            and is_leg_free(self.terrain, points[0], points[2])
        ):
            del points[1]

    def _course_point(self, start: PathPoint, end: PathPoint, *, may_turn: bool) -> CoursePoint:
        """The end of a leg, at whose start the robot may turn on the spot before it drives: not at an edge."""
        x, y = self.map.to_local(end.x, end.y)
        reverse = end.backward if self._backward else None
        tolerance = self._tolerance(end)
        is_narrow = may_turn and min(tolerance, self._tolerance(start)) <= NARROW_TOLERANCE
        path_tolerance = NARROW_PATH_TOLERANCE if is_narrow else PATH_TOLERANCE
        return CoursePoint(x, y, reverse=reverse, tolerance=tolerance, path_tolerance=path_tolerance)

    def _tolerance(self, point: PathPoint, wide: float = CORNER_TOLERANCE) -> float:
        """Metres within which a point of the way counts as reached: `wide`, and less where there is little room."""
        assert self.terrain is not None
        return min(wide, max(NARROW_TOLERANCE, self.terrain.room(point.x, point.y)))

    async def _begin_course(self, drive: Coroutine[Any, Any, RobotPose]) -> None:
        """Begin a new list of waypoints; the earlier one ends without a stop."""
        before, self._course = self._course, asyncio.create_task(drive, name="navigation: waypoints")
        await asyncio.sleep(0)
        if before is not None:
            before.cancel()
            await asyncio.wait({before})

    async def _end_course(self) -> None:
        """Stop the robot if it drives a list of waypoints, and forget the rest of its way."""
        course, self._course = self._course, None
        self._rest, self._held = [], False
        if course is not None:
            course.cancel()
            await asyncio.wait({course})

    async def _set_flippers(self, angle: float | None) -> None:
        """Set the flippers, None for where they were at the start, while the robot stands."""
        rest, self._rest = self._rest, []
        await self._end_course()
        self._rest = rest
        names = flipper_joints(self._model)
        wanted = {name: self._posture.get(name, 0.0) if angle is None else angle for name in names}
        for component in self._robot.info.offering(POSITION_DRIVER):
            with suppress(ConfigError):  # it moves other joints
                arm = self._robot.manipulator(component.id)
                await arm.move(wanted, tolerance=FLIPPER_TOLERANCE, timeout=20.0)
                self._flippers = angle
                return
        raise ConfigError(f"the robot has no service that moves {', '.join(names)}, which the step needs")

    # --- watching -----------------------------------------------------------------------------------------------------

    def ahead(self, pose: RobotPose) -> list[PathPoint]:
        """Points of the part that is driven, in the map, from where the robot is."""
        here = self.map.to_map(_planar(pose))
        place = PathPoint(here.x, here.y)
        return [place, *self._driven[self._leg(place) :]]

    def _leg(self, place: PathPoint) -> int:
        """Number of the point to which the robot drives from this place; it does not drive back to an earlier one."""
        last = len(self._driven) - 1
        while self._passed < last - 1 and self._is_behind(place, *self._driven[self._passed : self._passed + 2]):
            self._passed += 1  # a robot that is sent along the rest of its way must not turn back for a corner
        return self._passed + 1 if last > 0 else len(self._driven)

    def _is_behind(self, place: PathPoint, start: PathPoint, end: PathPoint) -> bool:
        """True if the robot has reached the end of a leg, or is past it."""
        near = math.dist(place[:2], end[:2]) <= self._tolerance(end)
        return near or (place.x - end.x) * (end.x - start.x) + (place.y - end.y) * (end.y - start.y) >= 0.0

    def _has_arrived(self, pose: RobotPose, x: float, y: float) -> bool:
        """True at the goal, and where the way ends that comes as near to it as the robot can stand."""
        if self._distance_to(pose, x, y) <= ARRIVED:
            return True
        end = None if self.path is None else self.path.points[-1]
        return (
            end is not None
            and math.dist(end[:2], (x, y)) <= 2.0 * GOAL_TOLERANCE
            and self._distance_to(pose, *end[:2]) <= CORNER_TOLERANCE
        )

    def _distance_to(self, pose: RobotPose, x: float, y: float) -> float:
        """Metres from the robot to a point of the map."""
        return math.dist(self.map.to_map(_planar(pose))[:2], (x, y))

    def _left(self, pose: RobotPose) -> float:
        """Metres of the way that are left."""
        return sum(way_length(part.points) for part in self._left_parts(pose))

    def _cost_left(self, pose: RobotPose) -> float:
        """Cost of what is left of the way, on the newest map."""
        assert self.terrain is not None
        return sum(way_cost(self.terrain, part.points) for part in self._left_parts(pose))

    async def _look_ahead(self, pose: RobotPose) -> _Ahead:
        here = self.map.to_map(_planar(pose))
        nearest, *rest = self._way_ahead(PathPoint(here.x, here.y))
        if rest and math.dist(nearest[:2], rest[0][:2]) > NEXT:  # the heading of a shorter leg says nothing
            rest.insert(0, nearest)
        ahead = first_metres(rest, LOOK_AHEAD)
        return await self.map.compute(self._seen_ahead, ahead, here) if len(ahead) > 1 else _Ahead(LOOK_AHEAD)

    def _way_ahead(self, place: PathPoint) -> list[PathPoint]:
        """Points of the part that is driven, from the one nearest to the robot.

        A robot some centimetres beside its leg drives on along it: it does not head for the end, which is near, from
        where it is.
        """
        number = self._leg(place)
        rest = self._driven[number:]
        if not number or not rest:
            return [place, *rest]
        nearest = nearest_on_leg(place, self._driven[number - 1], rest[0])
        return [nearest if math.dist(nearest[:2], place[:2]) <= CORNER_TOLERANCE else place, *rest]

    def _seen_ahead(self, ahead: list[PathPoint], pose: PlanarPose) -> _Ahead:
        assert self._mobility is not None
        terrain = self.map.terrain(self._mobility, [point[:2] for point in ahead], margin=1.0)
        terrain.margin, terrain.is_exact = BLOCKING, self._is_tight
        terrain.start_at(pose)
        if not is_way_free(terrain, ahead):
            return _Ahead(STOP_DISTANCE if is_way_free(terrain, first_metres(ahead, STOP_DISTANCE)) else 0.0)
        has_step = (
            self._flippers is None
            and self._has_flippers
            and any(part.flippers is not None for part in parts(first_metres(ahead, STEP_LOOK), terrain, flippers=True))
        )
        return _Ahead(LOOK_AHEAD, terrain if has_step else None)


class _Ahead(NamedTuple):
    """Metres of the way ahead without an obstacle, at most `LOOK_AHEAD`.

    And the newest costs, if they have a step on the part that is driven, for which the flippers are not set: the way
    may be older than what is known of the step.
    """

    free: float
    step: TerrainCost | None = None


def _planar(pose: RobotPose) -> PlanarPose:
    return PlanarPose(pose.x, pose.y, pose.yaw)
