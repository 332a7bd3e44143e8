"""Retrotraverse: drives back along the path that the vehicle came by (IOP v3; docs/adr/0183-lost-links.md)."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Final, Self

from jauspy.geometry.poses import PlanarPoint, Pose, jaus_twist
from jauspy.logs import get_logger
from jauspy.messages.iop import ReportRetrotraverseStatus, StartRetrotraverse
from jauspy.messages.mobility.v1_0.types import GlobalWaypointRec
from jauspy.services.mobility.driven_path import DrivenPath, PathPoint
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.retrace import (
    MAX_DEVIATION,
    RetraceCourse,
    RetraceLeg,
    distance_abeam,
    distance_to_circle,
    length_of,
    shortened,
    way_back,
)
from jauspy.services.mobility.retraced_joints import OwnMotion, RetracedJoints
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.waypoints import GlobalWaypoint, WaypointAttitude
from jauspy.services.state_machine import CommandCompletion

_LOG: Final = get_logger("jauspy.mobility")

PERIOD: Final = 0.1
"""Seconds between two looks at where the vehicle is."""
SLOPE: Final = math.radians(8.0)
"""Tilt from which on a piece of the path is never driven back faster than it was driven."""
TURNING_RADIUS: Final = 0.2
"""Metres; a vehicle that drives a narrower curve turns on the spot, which adds nothing to the path."""
STALL_TIME: Final = 10.0
"""Seconds without progress after which a vehicle that should move is stopped."""
PROGRESS: Final = 0.1
"""Metres or radians that count as progress."""


class StallWatch:
    """Notices a vehicle that does not get on: something is in its way, or it slips."""

    def __init__(self) -> None:
        self._pose: Pose | None = None
        self._since = 0.0

    def is_stalled(self, pose: Pose, now: float) -> bool:
        """True once it has not moved for `STALL_TIME`."""
        before = self._pose
        if before is None or _moved(before, pose) > PROGRESS:
            self._pose, self._since = pose, now
        return now - self._since > STALL_TIME


def _moved(before: Pose, pose: Pose) -> float:
    turned = abs(math.remainder(pose.yaw - before.yaw, math.tau))
    return max(math.hypot(pose.x - before.x, pose.y - before.y), turned)


@dataclass(frozen=True, slots=True)
class RetraceRequest:
    """How far to drive back, and how: the fields of RetrotraverseActionRec and GlobalWaypointRec, in SI units.

    `distance` along the path; with a waypoint, to where the path comes nearest to it, and at most `distance` unless
    that is 0. `standoff` is kept from the destination.
    """

    distance: float
    max_speed: float = 0.0
    """m/s; 0: as on the way out."""
    nose_first: bool = False
    """True to turn about; False to drive with the headings of the way out."""
    standoff: float = 0.0
    waypoint: GlobalWaypointRec | None = None
    straight: bool = False
    """True for the other travel method, which is not known."""

    @classmethod
    def of(cls, action: Any, waypoint: GlobalWaypointRec | None) -> Self:
        """The request of a message's records."""
        return cls(
            distance=action.distance,
            max_speed=action.max_speed,
            nose_first=bool(action.parameters.direction),
            standoff=action.standoff_distance,
            waypoint=waypoint,
            straight=bool(action.parameters.travel_method),
        )

    def action(self, message: Any) -> Any:
        """The record of a class of messages that has one."""
        return message.RetrotraverseActionRec(
            distance=self.distance,
            max_speed=self.max_speed,
            parameters=message.Parameters(travel_method=int(self.straight), direction=int(self.nose_first)),
            standoff_distance=self.standoff,
        )


def waypoint_of(rec: GlobalWaypointRec) -> GlobalWaypoint:
    """The waypoint of a record."""
    attitude = WaypointAttitude(rec.roll, rec.pitch, rec.yaw, rec.waypoint_tolerance, rec.path_tolerance)
    return GlobalWaypoint(rec.latitude, rec.longitude, attitude, altitude=rec.altitude)


class Retrotraverse(Driver, urn="urn:jaus:jss:iop:Retrotraverse"):
    """Keeps the path of the vehicle, and drives it back, by the position that the vehicle estimates itself.

    The part that was driven back is removed from the path. `joints`: flippers, which get the positions that they had.
    `own_motion`: which parts a client controls: the flippers are moved if the client of this command has them, too, or
    if nobody does and the robot moves by itself.
    """

    def __init__(
        self, vehicle: Vehicle, *, joints: RetracedJoints | None = None, own_motion: OwnMotion | None = None
    ) -> None:
        super().__init__(vehicle)
        self.path = DrivenPath()
        self.joints = joints
        self._own_motion = own_motion or OwnMotion()
        self._request = RetraceRequest(0.0)
        self._course: RetraceCourse | None = None
        self._stall = StallWatch()
        self._command = CommandCompletion()

    def attached(self) -> None:
        """Begin to keep the path."""
        super().attached()
        self.host.repeat(self._observe, PERIOD, self._observe)

    # --- the path

    def _observe(self) -> None:
        """Add to the path, or watch the way back."""
        if self._course is None:
            twist = jaus_twist(self.vehicle.drive.twist())
            if abs(twist.vx) >= TURNING_RADIUS * abs(twist.wz):
                self.path.record(self._here(abs(twist.vx), backward=twist.vx < 0.0))
        elif self._stall.is_stalled(self.vehicle.pose, self.host.now):
            self._give_up(f"it has not moved for {STALL_TIME:g} s")

    def _here(self, speed: float = 0.0, *, backward: bool = False) -> PathPoint:
        pose = self.vehicle.pose
        return PathPoint(
            PlanarPoint(pose.x, pose.y),
            backward=backward,
            speed=speed,
            tilted=max(abs(pose.pitch), abs(pose.roll)) > SLOPE,
            joints=self.joints.positions() if self.joints else (),
        )

    # --- driving back

    def supports(self, request: RetraceRequest) -> bool:
        """True if it can be carried out, apart from the length of the path."""
        has_target = request.waypoint is None or self.vehicle.has_origin
        return not request.straight and has_target and not (request.nose_first and self.vehicle.chassis.min_turn_radius)

    def begin(self, request: RetraceRequest, *, by_itself: bool = False) -> bool:
        """Drive back; returns False, and counts why, if there is nothing to drive. `by_itself`: without a client."""
        if not self.supports(request):
            self.host.count("retrotraverse_unsupported", f"{request}")
            return False
        self._end()
        here = self._here()
        if points := self.path.points:
            here = replace(here, backward=points[-1].backward, speed=points[-1].speed)
        self.path.end_at(here)
        way = self._way(request)
        legs = way
        if way and request.standoff:
            legs = shortened(way, distance_to_circle(way, way[-1].line.end, request.standoff))
        if not legs:
            self.host.count("retrotraverse_nothing_to_do", f"{request}, path of {len(self.path)} points")
            return False
        self.vehicle.pilot.stop()
        tolerance = request.waypoint.path_tolerance if request.waypoint is not None else None
        self._request, self._stall = replace(request, distance=length_of(way)), StallWatch()
        course = RetraceCourse(
            legs,
            self.vehicle.chassis,
            max_speed=request.max_speed,
            path_tolerance=min(tolerance or MAX_DEVIATION, MAX_DEVIATION),
            move_joints=self._joints_mover(by_itself=by_itself),
        )
        self.vehicle.pilot.follow(self, course)
        self._course = course
        return True

    def _way(self, request: RetraceRequest) -> list[RetraceLeg]:
        legs = way_back(self.path.points, nose_first=request.nose_first)
        distance = request.distance
        if request.waypoint is not None:
            point = self.vehicle.point_on_globe(request.waypoint.latitude, request.waypoint.longitude)
            abeam = distance_abeam(legs, point)
            distance = min(abeam, distance or abeam)
        return shortened(legs, distance)

    def _joints_mover(self, *, by_itself: bool) -> Callable[[tuple[float, ...]], bool]:
        joints = self.joints
        if joints is None or (joints.part in self._own_motion.controlled) == by_itself:
            return lambda _: True
        return joints.move

    def _give_up(self, why: str) -> None:
        self.host.count("retrotraverse_ended", why)
        _LOG.warning("%s: drives back no further: %s", self.host.id, why)
        self.vehicle.pilot.release(self)

    def _end(self, *, success: bool = False) -> None:
        """Keep the part of the path that was not driven back."""
        course, self._course = self._course, None
        if course is not None:
            self.path.cut(course.kept, self._here())
            if self.joints is not None:
                self.joints.stop()
        self._command(success)

    # --- as a driver

    def on_arrival(self) -> None:
        """Stop: the end is reached, or the path is lost."""
        course = self._course
        if course is not None and course.lost:
            self._give_up("it has left its path")
            return
        self._end(success=True)
        super().on_arrival()

    def on_preempted(self) -> None:
        """Another command, or a stop, ends it."""
        self._end()

    def resumption(self) -> Callable[[], None] | None:
        """Drive back what is left."""
        if self._course is None:
            return None
        request = replace(self._request, distance=self._course.distance_left, waypoint=None, standoff=0.0)
        return lambda: self._resume(request)

    def _resume(self, request: RetraceRequest) -> None:
        self.begin(request, by_itself=True)

    # --- actions

    def start_retrotraverse(self, msg: StartRetrotraverse) -> None:
        """Drive back; a request that is under way is replaced."""
        completion = self.host.begin_command()
        if self.begin(RetraceRequest.of(msg.retrotraverse_action_rec, msg.global_waypoint_rec)):
            self._command = completion
        else:
            completion(False)

    def cancel_retrotraverse(self) -> None:
        """Stop driving back."""
        self.vehicle.pilot.release(self)

    def send_report_retrotraverse_status(self) -> ReportRetrotraverseStatus:
        """State, and the request that is, or was last, carried out, with the metres that the path has for it."""
        course, request, states = self._course, self._request, ReportRetrotraverseStatus.RetrotraverseStatus
        state, percent = states.RETROTRAVERSE_INACTIVE, None
        if course is not None:
            state = states.REORIENTING_FOR_RETROTRAVERSE if course.reorients else states.RETROTRAVERSE_ACTIVE
            percent = 100.0 * course.completed
        return ReportRetrotraverseStatus(
            retrotraverse_action_rec=request.action(ReportRetrotraverseStatus),
            global_waypoint_rec=request.waypoint,
            retrotraverse_status_rec=ReportRetrotraverseStatus.RetrotraverseStatusRec(state, percent),
        )
