"""The guard of guarded teleoperation: scales the efforts of the chassis so that it stops before obstacles.

Several times a second it computes the way on which the chassis would come to rest if it followed its command and then
braked, and takes the greatest share of the command at which its outline, larger by the set distance ahead and behind,
and by `SIDE` at the sides, meets no obstacle. Needs numpy.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import numpy as np

from jauspy.errors import ConfigError
from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.contract import DriveBase, Robot
from jauspy.platform.description import GuardedTeleopSetup, RobotModel
from jauspy.platform.drives import SLIP_FACTOR, clamp
from jauspy.platform.guards import GuardState, ObstacleGuard
from jauspy.platform.obstacles import Obstacles

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array: TypeAlias = NDArray[np.floating[Any]]

PERIOD: Final = 0.02
"""Seconds between two checks."""
DELAY: Final = 0.15
"""Seconds from what a sensor saw until a changed command brakes: a scan's period, the check's, and the drives' lag."""
BRAKING: Final = 2.0
"""m/s^2 with which any chassis brakes at zero effort; tracks and wheels on firm ground do better."""
TURN_BRAKING: Final = 4.0
"""rad/s^2 of the same in a turn."""
SIDE: Final = 0.05
"""Metres that stay free at the sides, so that doors can be passed."""
POSES: Final = 16
"""Poses that are checked on the way to a stop."""
SLIGHT: Final = 1e-6
"""Metres by which an obstacle that is too near already may come nearer in rounding."""
TIGHT: Final = 0.5
"""Share of the margins in which a chassis that moves faster than it was told to is stopped at once."""
SLOWEST: Final = 0.03
"""m/s and rad/s of a command, about a metre, below which the chassis stands instead."""
LOOK_AHEAD: Final = 3.0
"""Metres around the robot in which points count."""
MAX_AGE: Final = 0.5
"""Seconds without a scan after which the robot is stopped; depth cameras are waited for only without lidars."""


class GuardedDrive:
    """A `DriveBase` whose efforts pass the guard."""

    def __init__(self, drive: DriveBase, guard: DriveGuard) -> None:
        self._drive = drive
        self._guard = guard
        self.wanted = (0.0, 0.0, 0.0)
        """The efforts that are wanted: forward, turning left, and to the left."""
        self.share = 1.0
        """Share of them that is set."""
        self.is_new = False
        """True for efforts that were not set yet."""

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Drive with fractions of the full effort; the guard sets them before the next step."""
        self.wanted = clamp(linear_x), clamp(rotational_z), clamp(linear_y)
        if self._guard.enabled and any(self.wanted):
            self.is_new = True
        else:
            self.is_new, self.share = False, 1.0
            self._drive.set_effort(linear_x, rotational_z, linear_y)

    def stop(self) -> None:
        """Brake to a standstill."""
        self.wanted, self.is_new, self.share = (0.0, 0.0, 0.0), False, 1.0
        self._drive.stop()

    def follow(self, share: float, *, steers: bool) -> None:
        """Set a share of the efforts that are wanted; the angle of a chassis that `steers` stays."""
        self.share, self.is_new = share, False
        if not share:
            self._drive.stop()
            return
        x, z, y = self.wanted
        self._drive.set_effort(share * x, z if steers else share * z, share * y)

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self._drive.pose()

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        return self._drive.twist()

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame."""
        return self._drive.acceleration()


class DriveGuard(ObstacleGuard):
    """The guard of one robot's chassis; `drive` is to be used in place of the robot's."""

    def __init__(self, robot: RobotModel, chassis: Chassis, inner: Robot) -> None:
        self._setup: GuardedTeleopSetup = robot.guarded_teleop
        self.enabled = self._setup.enabled
        """True while it checks commands."""
        self.drive = GuardedDrive(inner.drive, self)
        """The chassis, whose commands pass this guard."""
        self._chassis = chassis
        self._inner = inner
        names = [joint.name for group in inner.groups.values() for joint in group.joints]
        self._boxes = LinkBoxes(robot.description, names)
        belts = (*robot.tracks.left, *robot.tracks.right) if robot.tracks else ()
        self._bodies = {0, *(self._boxes.body_of(robot.description.joint(name).child) for name in belts)}
        self._obstacles = Obstacles(self._setup, self._boxes, tuple(inner.lidars) or robot.depth_cameras)
        self._due = 0.0
        self._state = GuardState(self.enabled)

    def state(self) -> GuardState:
        """The state after the last check."""
        return self._state

    def enable(self, enabled: bool) -> None:
        """Switch it on or off; off, the present command is followed as it was given."""
        if enabled == self.enabled:
            return
        self.enabled = enabled
        self._state = GuardState(enabled)
        self._obstacles.clear(self._inner.time)
        if not enabled and any(self.drive.wanted):
            self._follow(1.0)

    def see(self, camera: str, frame: str, points: bytes, age: float) -> None:
        """Take points that a depth camera saw `age` seconds ago: float32 rows of x, y and z in the frame of a link."""
        if self.enabled:
            seen = np.frombuffer(points, "<f4").reshape(-1, 3).astype(float)
            self._obstacles.add_points(camera, frame, seen, self._inner.time - age)

    def step(self, now: float) -> None:
        """Check the command, if a check is due; `now` is the robot's time, in seconds."""
        if not self.enabled or (now < self._due and not self.drive.is_new):
            return
        self._due = now + PERIOD
        posture = [p for group in self._inner.groups.values() for p in group.state().positions]
        pose = self.drive.pose()
        self._obstacles.update(now, pose, posture, self._inner.lidars)
        low, high = self._boxes.extent(posture, self._bodies)
        points = self._obstacles.around(pose, LOOK_AHEAD)
        outline = low[:2], high[:2]
        distance = float(_distances(points, *outline).min(initial=math.inf))
        share, problem = 1.0, ""
        what, age = self._obstacles.oldest(now)
        if any(self.drive.wanted):
            if age > MAX_AGE:
                share, problem = 0.0, f"{what} has measured nothing for {age:.1f} s: guarded teleop stops the chassis"
            else:
                share = self._share(points, outline, self.drive.twist())
            if not share and not problem:
                problem = _sentence(points, outline, distance)
            if self.drive.is_new or share != self.drive.share:
                self._follow(share)
        elif distance <= self._setup.distance + SIDE:
            problem = self._state.problem
        self._state = GuardState(True, share < 1.0, distance, problem)

    def _follow(self, share: float) -> None:
        self.drive.follow(share, steers=self._chassis.min_turn_radius > 0.0)

    def _share(self, points: Array, outline: tuple[Array, Array], twist: Twist) -> float:
        """The greatest share of the command at which the chassis stays clear of all points."""
        x, z, y = self.drive.wanted
        speed, sideways, turn = self._velocities(x, z, y)
        if not len(points):
            return 1.0
        margin = np.array((self._setup.distance, SIDE))
        brakes = max(math.hypot(twist.vx, twist.vy) / BRAKING, abs(twist.wz) / TURN_BRAKING) / 2.0
        moving = abs(twist.vx) + abs(twist.vy) + abs(twist.wz) > SLOWEST
        if moving and self._reached(points, outline, TIGHT * margin, (twist.vx, twist.vy, twist.wz), brakes) < 1.0:
            return 0.0
        brakes = max(math.hypot(speed, sideways) / BRAKING, abs(turn) / TURN_BRAKING) / 2.0
        way = self._reached(points, outline, margin, (speed, sideways, turn), DELAY + brakes)
        if way >= 1.0:
            return 1.0
        # a share s of the velocity comes to rest after s (DELAY + s brakes) of the unit of time
        whole = way * (DELAY + brakes)
        share = 2.0 * whole / (DELAY + math.sqrt(DELAY * DELAY + 4.0 * brakes * whole)) if whole else 0.0
        return share if share * max(math.hypot(speed, sideways), abs(turn)) > SLOWEST else 0.0

    def _velocities(self, x: float, z: float, y: float) -> tuple[float, float, float]:
        """The velocities that efforts lead to on firm ground, at most: m/s forward and to the left, rad/s."""
        chassis = self._chassis
        if chassis.min_turn_radius:
            angle = z * chassis.steering_angle
            return x * chassis.max_speed, 0.0, x * chassis.max_speed * math.tan(angle) / (chassis.wheel_base or 1.0)
        slip = 1.0 if chassis.wheel_radius else SLIP_FACTOR
        turn = 2.0 * chassis.max_speed / (slip * chassis.track_separation) if chassis.track_separation else 0.0
        return x * chassis.max_speed, y * chassis.max_speed, z * turn

    def _reached(
        self,
        points: Array,
        outline: tuple[Array, Array],
        margin: Array,
        velocity: tuple[float, float, float],
        seconds: float,
    ) -> float:
        """The part of the way that the outline moves, at a velocity for `seconds`, before a point is in its margin."""
        low, high = outline[0] - margin, outline[1] + margin
        corner = float(np.hypot(*np.maximum(np.abs(low), np.abs(high))))
        reach = seconds * (math.hypot(velocity[0], velocity[1]) + abs(velocity[2]) * corner)
        points = points[_distances(points, low, high) <= reach]
        if not len(points):
            return 1.0
        parts = np.linspace(0.0, 1.0, POSES + 1)
        xs, ys, turns = _arc(velocity, seconds * parts)
        offsets = points[None] - np.stack((xs, ys), axis=-1)[:, None]
        cosines, sines = np.cos(turns)[:, None], np.sin(turns)[:, None]
        seen = np.stack(
            (
                cosines * offsets[..., 0] + sines * offsets[..., 1],
                cosines * offsets[..., 1] - sines * offsets[..., 0],
            ),
            axis=-1,
        )
        found = _distances(seen, low, high)
        least = np.minimum(0.0, found[0]) - SLIGHT
        kept = found >= least
        if not kept.all() and (found[0] < 0.0).any():  # what is in the margin already may also go away from the chassis
            bare = _distances(seen, *outline)
            kept |= (found[0] < 0.0) & (bare >= bare[0] - SLIGHT)
        clear = np.logical_and.accumulate(kept.all(axis=1))
        last = int(clear.sum()) - 1
        if last == POSES:
            return 1.0
        before, after = found[last] - least, found[last + 1] - least
        worst = ~kept[last + 1]
        part = float((before[worst] / np.maximum(before[worst] - after[worst], 1e-9)).min())
        return (last + min(1.0, max(0.0, part))) / POSES


def _arc(velocity: tuple[float, float, float], times: Array) -> tuple[Array, Array, Array]:
    """Position and heading after some seconds at a constant velocity in the frame that moves."""
    vx, vy, turn = velocity
    turns = turn * times
    straight = np.sinc(turns / math.pi) * times
    bent = np.where(np.abs(turns) > 1e-6, (1.0 - np.cos(turns)) / (turn or 1.0), 0.5 * turns * times)
    return vx * straight - vy * bent, vx * bent + vy * straight, turns


def _distances(points: Array, low: Array, high: Array) -> Array:
    """Distances of points (..., 2) to a rectangle; negative by the depth inside it."""
    beyond = np.maximum(low - points, points - high)
    outside = np.hypot(np.maximum(beyond[..., 0], 0.0), np.maximum(beyond[..., 1], 0.0))
    found: Array = outside + np.minimum(beyond.max(axis=-1), 0.0)
    return found


def _sentence(points: Array, outline: tuple[Array, Array], distance: float) -> str:
    """Why the chassis stands."""
    x, y = points[int(np.argmin(_distances(points, *outline)))].tolist()
    (back, right), (front, left) = (side.tolist() for side in outline)
    beyond = {"ahead": x - front, "behind": back - x, "to the left": y - left, "to the right": right - y}
    where = max(beyond, key=lambda name: beyond[name])
    return f"obstacle {max(0.0, distance):.2f} m {where}: guarded teleop stops the chassis; drive another way"


def drive_guard(model: RobotModel, inner: Robot) -> DriveGuard | None:
    """The guard of a robot with a chassis, and with a lidar or a depth camera; None for another one."""
    if not (inner.lidars or model.depth_cameras):
        return None
    try:
        chassis = chassis_of(model)
    except ConfigError:  # a base that is fixed
        return None
    return DriveGuard(model, chassis, inner)
