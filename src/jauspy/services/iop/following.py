"""How a vehicle follows a leader: the speed that keeps the gap, and the steering along the leader's path."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.poses import PlanarPoint, Pose
from jauspy.ids import JausID
from jauspy.platform.chassis import Chassis
from jauspy.services.iop.leader_path import LeaderPath, PathPlace
from jauspy.services.mobility.courses import heading_error, look_ahead, steer_to_heading
from jauspy.services.mobility.velocity_control import STANDSTILL, PlanarVelocity

DEFAULT_GAP: Final = 3.0
"""Metres between the poses of leader and follower, for a follower that is told neither a distance nor a time."""
DEFAULT_MAXIMUM: Final = 30.0
"""Metres beyond which a follower ends that is not told its greatest distance."""
CLEARANCE: Final = 0.3
"""Metres between the two vehicles, taken as alike, at which the follower stands whatever it is told."""
CERTAINTY: Final = 2.0
"""Standard deviations of the distance, by the errors that both report, that are added to the least distance."""
GAIN: Final = 0.8
"""1/s: speed for each metre by which the gap is too long."""
SPEED_TIME: Final = 0.2
"""Seconds over which the speed of the place to be at is measured."""
PREDICTION: Final = 0.3
"""Seconds for which the leader is taken to drive on as in its last report."""
STALE: Final = 0.6
"""Seconds without a pose of the leader after which the follower stops."""
MIN_SPEED: Final = 0.04
"""m/s below which it stands: errors of the poses do not make it creep."""


@dataclass(frozen=True, slots=True)
class FollowerSettings:
    """What `SetFollowerConfiguration` sets, in metres and seconds. Offsets are positive to the right of the path."""

    leader: JausID | None = None
    """None: the vehicle that the convoy names."""
    stop_leader: bool = False
    """Asks the leader to stop when a bound is passed."""
    slow_leader: bool = False
    """Asks the leader to drive slower before the greatest distance is reached."""
    lag: float = 0.0
    """Seconds behind the leader; 0 for a distance alone."""
    minimum: float = DEFAULT_GAP
    maximum: float = DEFAULT_MAXIMUM
    lateral_offset: float = 0.0
    max_lateral_error: float = math.inf

    @property
    def problem(self) -> str:
        """Why a vehicle cannot follow like this; empty if it can."""
        if self.maximum <= self.minimum:
            return f"the greatest distance {self.maximum:g} m is not above the least one, {self.minimum:g} m"
        if abs(self.lateral_offset) > self.maximum:
            return f"the offset {self.lateral_offset:g} m is more than the greatest distance, {self.maximum:g} m"
        return ""


@dataclass(frozen=True, slots=True)
class Gap:
    """The distance to a leader."""

    along: float
    """Metres along the path, between the poses of both."""
    straight: float
    """Metres in a straight line."""
    lateral_error: float
    """Metres beside the place to be at, positive to the right."""


@dataclass(slots=True)
class LeaderTrack:
    """The leader's path, and how well both positions are known."""

    path: LeaderPath
    rms: float = 0.0
    """Metres, of the leader's position."""

    def age(self, now: float) -> float:
        """Seconds since the leader's last pose."""
        return now - self.path.leader.time


class FollowCourse:
    """A course along the path of a leader. It never drives backward, and stands while the leader's pose is stale.

    `track` is None until the leader is known; `own` is the vehicle's pose in the frame of the path, with the error of
    its position (metres); `now` is the clock.
    """

    limits: None = None

    def __init__(
        self,
        settings: Callable[[], FollowerSettings],
        track: Callable[[], LeaderTrack | None],
        own: Callable[[], tuple[Pose, float]],
        now: Callable[[], float],
        chassis: Chassis,
    ) -> None:
        self._settings, self._track, self._own, self._now, self._chassis = settings, track, own, now, chassis
        self.gap: Gap | None = None
        """The gap when it steered last."""

    @property
    def contact(self) -> float:
        """Metres between the poses at which it stands: the vehicles would nearly touch."""
        return self._chassis.front + self._chassis.back + CLEARANCE

    def steer(self, _: Pose) -> PlanarVelocity:
        """The velocity wanted now; never None."""
        track = self._track()
        if track is None:
            return STANDSTILL
        path, now, settings = track.path, self._now(), self._settings()
        pose, own_rms = self._own()
        place = self._measure(path, PlanarPoint(pose.x, pose.y), settings)
        if track.age(now) > STALE or self.gap is None:
            return STANDSTILL
        margin = CERTAINTY * math.hypot(own_rms, track.rms)
        keep = max(settings.minimum, self.contact + margin)
        wanted = self._place(path, now, settings.lag, keep)
        speed = (wanted - self._place(path, now - SPEED_TIME, settings.lag, keep)) / SPEED_TIME
        speed = max(0.0, speed) + GAIN * (wanted - place.along)
        speed = min(speed, self._chassis.max_speed, self._braking_speed(margin))
        if speed < MIN_SPEED:
            return STANDSTILL
        return self._along(path, pose, place, speed, settings)

    def _measure(self, path: LeaderPath, position: PlanarPoint, settings: FollowerSettings) -> PathPlace:
        place = path.follower(position)
        straight, _ = position.to(path.leader.position)
        self.gap = Gap(path.leader.along - place.along, straight, place.aside - settings.lateral_offset)
        return place

    def _place(self, path: LeaderPath, time: float, lag: float, keep: float) -> float:
        """Metres along the path to be at, at that time."""
        distance_kept = self._leader_at(path, time) - keep
        return min(distance_kept, path.passed(time - lag)) if lag else distance_kept

    def _leader_at(self, path: LeaderPath, time: float) -> float:
        """Metres along the path where the leader was, or is by now."""
        last = path.leader
        if time <= last.time:
            return path.passed(time)
        speed = (last.along - path.passed(last.time - SPEED_TIME)) / SPEED_TIME
        return last.along + max(0.0, speed) * min(time - last.time, PREDICTION)

    def _braking_speed(self, margin: float) -> float:
        """The speed from which half of the deceleration suffices to stop before a leader that stands still."""
        if self.gap is None:
            return 0.0
        free = min(self.gap.along, self.gap.straight) - self.contact - margin
        return math.sqrt(self._chassis.deceleration * free) if free > 0.0 else 0.0

    def _along(
        self, path: LeaderPath, pose: Pose, place: PathPlace, speed: float, settings: FollowerSettings
    ) -> PlanarVelocity:
        chassis = self._chassis
        point, direction = path.point(place.along + look_ahead(speed, None))
        side = settings.lateral_offset
        goal = PlanarPoint(point.x - side * math.sin(direction), point.y + side * math.cos(direction))
        _, bearing = PlanarPoint(pose.x, pose.y).to(goal)
        return steer_to_heading(heading_error(pose.yaw, bearing), speed, chassis.max_turn_rate, chassis.min_turn_radius)
