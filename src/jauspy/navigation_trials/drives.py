"""One drive to a goal over JAUS, and what the judge measured of it."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from jauspy.errors import JausError
from jauspy.geometry.poses import PlanarPose
from jauspy.navigation_trials.goals import Goal
from jauspy.navigation_trials.judge import DrivingTruth
from jauspy.navigation_trials.results import MAX_TEXT, Drive
from jauspy.planning.legs import way_length
from jauspy.planning.navigator import NavigationProgress, Navigator
from jauspy.planning.way_parts import first_metres

LIMIT: Final = 180.0
"""Seconds of a drive, of the robot's time."""
AT_GOAL: Final = 0.5
"""Metres from the goal within which it is reached, by the true pose."""
AHEAD: Final = 1.6
"""Metres ahead of the robot where a thing is put."""
PUT_AFTER: Final = 2.0
"""Seconds of a drive after which that is done."""
PUT_LEFT: Final = 2.5
"""Metres of the way that are left then."""


@dataclass(frozen=True)
class Place:
    """Where a drive belongs: its world, group, and number in that."""

    world: str
    group: int
    number: int
    known: bool = False
    """True if the robot began with a map."""


async def drive_to(
    navigator: Navigator,
    truth: DrivingTruth,
    goal: Goal,
    to_local: PlanarPose,
    place: Place,
    *,
    has_way: Callable[[], bool] | None = None,
) -> Drive:
    """Drive to a goal of the world, of which `to_local` is the pose in the robot's local frame.

    With `has_way`, which tells whether the true map has a way to the goal now, a thing of the world is put into the
    way, once the drive has begun.
    """
    wanted = to_local @ PlanarPose(goal.x, goal.y)
    watch = _DriveWatch(navigator, truth, has_way)
    truth.begin()
    first, began, error = truth.pose(), time.process_time(), ""
    try:
        await navigator.go_to(wanted.x, wanted.y, timeout=LIMIT, progress=watch.see)
    except JausError as problem:
        error = str(problem)[:MAX_TEXT] or type(problem).__name__
    pose = truth.pose()
    off = math.dist((pose.x, pose.y), (goal.x, goal.y))
    if not error and off >= AT_GOAL:
        error = f"the robot ended {off:.2f} m from the goal, and took that for the goal"
    return Drive(
        place.world,
        place.group,
        place.number,
        start=(round(first.x, 2), round(first.y, 2), round(first.yaw, 2)),
        goal=(round(goal.x, 2), round(goal.y, 2)),
        end=(
            *(round(value, 2) for value in (pose.x, pose.y, pose.z)),  # type: ignore[arg-type]
            *(round(value, 2) for value in (pose.roll, pose.pitch, pose.yaw)),
        ),
        error=error,
        way=round(truth.way, 2),
        shortest=round(goal.shortest, 2),
        contacts=dict(truth.contacts),
        plans=watch.plans,
        thing=watch.thing,
        new_way=watch.new_way,
        new_way_planning=watch.new_way_planning,
        seconds=round(watch.elapsed, 1),
        planning=round(watch.planning, 3),
        cpu=round(time.process_time() - began, 1),
        known=place.known,
        blocked=watch.blocked,
        planned=None if goal.planned is None else round(goal.planned, 2),
    )


class _DriveWatch:
    """Sees the progress of a drive, and puts a thing into its way."""

    def __init__(self, navigator: Navigator, truth: DrivingTruth, has_way: Callable[[], bool] | None) -> None:
        self._navigator, self._truth, self._has_way = navigator, truth, has_way
        self.plans = 0
        self.elapsed = self.planning = 0.0
        self.thing = ""
        self.blocked = False
        self.new_way: float | None = None
        self.new_way_planning: float | None = None
        self._put_at = (0.0, 0)
        """Seconds, and ways taken, when a thing was put."""

    def see(self, progress: NavigationProgress) -> None:
        """Take notice of the progress."""
        navigator = self._navigator
        self.plans, self.elapsed = progress.plans, progress.elapsed
        self.planning = max(self.planning, navigator.planning_time)
        put_at, plans = self._put_at
        if self.thing and self.new_way is None and progress.plans > plans:
            self.new_way = round(progress.elapsed - put_at, 2)
            self.new_way_planning = round(navigator.planning_time, 3)
        if self._has_way is not None and not self.thing and progress.elapsed > PUT_AFTER and progress.left > PUT_LEFT:
            self._put(progress)
            self.blocked = bool(self.thing) and not self._has_way()

    def _put(self, progress: NavigationProgress) -> None:
        """Put a thing ahead on the way, unless the part that is driven is too short for it."""
        ahead = self._navigator.ahead(progress.pose)
        if way_length(ahead) < AHEAD:
            return
        x, y, _ = first_metres(ahead, AHEAD)[-1]
        local, true = progress.pose, self._truth.pose()
        here = self._navigator.map.to_map(PlanarPose(local.x, local.y, local.yaw))
        in_world = PlanarPose(true.x, true.y, true.yaw) @ here.inverse() @ PlanarPose(x, y)
        self.thing = self._truth.put_thing(in_world.x, in_world.y)
        self._put_at = progress.elapsed, progress.plans
