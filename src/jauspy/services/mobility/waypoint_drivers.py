"""LocalWaypointDriver and GlobalWaypointDriver: drive to one waypoint once a travel speed is set (AS6009)."""

from __future__ import annotations

from collections.abc import Callable, Collection
from enum import Enum
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.geometry.poses import PlanarPoint
from jauspy.messages.mobility import (
    ReportActiveElement,
    ReportGlobalWaypoint,
    ReportGlobalWaypointExt,
    ReportLocalWaypoint,
    ReportLocalWaypointExt,
    ReportTravelSpeed,
    ReportTravelSpeedExt,
    SetGlobalWaypoint,
    SetGlobalWaypointExt,
    SetLocalWaypoint,
    SetLocalWaypointExt,
)
from jauspy.services.core.list_manager import ListDriver
from jauspy.services.mobility.courses import DEFAULT_TOLERANCE, CourseGoal, WaypointCourse
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.field_ranges import speed_over_ground, unsigned_speed
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.waypoint_information import NOTHING, AddedInformation, WaypointInformation
from jauspy.services.mobility.waypoints import GlobalWaypoint, LocalWaypoint, Waypoint, global_waypoint, local_waypoint
from jauspy.services.state_machine import CommandCompletion


class WaypointFollower(Driver):
    """The base of all waypoint drivers: drives to a waypoint at the pilot's travel speed."""

    uses_travel_speed = True

    def drive_to(
        self,
        waypoint: Waypoint,
        speed: float,
        *,
        is_last: bool,
        information: WaypointInformation = NOTHING,
        before: Waypoint | None = None,
    ) -> None:
        """Start for a waypoint, at m/s, negative backward; the robot stops there if it is the last one.

        `information` may say which way round it drives, whatever the sign of the speed. The line on which it is to
        drive begins at the waypoint `before`, if that was passed, else where the robot is.
        """
        vehicle = self.vehicle
        course = WaypointCourse(
            lambda: goal_of(vehicle, waypoint, is_last=is_last),
            lambda: information.directed(vehicle.pilot.travel_speed),
            deceleration=vehicle.chassis.deceleration,
            max_turn_rate=vehicle.chassis.max_turn_rate,
            min_turn_radius=vehicle.chassis.min_turn_radius,
            start=None if before is None else lambda: _point_and_heading(vehicle, before)[0],
        )
        if vehicle.chassis.min_turn_radius and waypoint.attitude.yaw is not None:
            self.host.count("cannot_turn_on_the_spot", f"{waypoint}")
        vehicle.pilot.follow(self, course)
        vehicle.pilot.travel_speed = speed
        vehicle.waypoint = waypoint

    def report_travel_speed(self) -> ReportTravelSpeed:
        """Zero unless the platform drives to a waypoint; without direction, which only the wide form has."""
        return ReportTravelSpeed(speed=unsigned_speed(self.vehicle.pilot.travel_speed))

    def report_travel_speed_ext(self) -> ReportTravelSpeedExt:
        """Same as `report_travel_speed`, negative backward."""
        return ReportTravelSpeedExt(speed=speed_over_ground(self.vehicle.pilot.travel_speed))


def goal_of(vehicle: Vehicle, waypoint: Waypoint, *, is_last: bool) -> CourseGoal:
    """A waypoint in the world, by the present setting of its frame, and for a global one by the present estimate."""
    attitude = waypoint.attitude
    point, heading = _point_and_heading(vehicle, waypoint)
    tolerance = DEFAULT_TOLERANCE if attitude.tolerance is None else attitude.tolerance
    return CourseGoal(point, heading, tolerance, attitude.path_tolerance, is_last)


def _point_and_heading(vehicle: Vehicle, waypoint: Waypoint) -> tuple[PlanarPoint, float | None]:
    yaw = waypoint.attitude.yaw
    if isinstance(waypoint, LocalWaypoint):
        frame = vehicle.local_frame
        return frame.to_world(waypoint.x, waypoint.y), None if yaw is None else frame.heading_to_world(yaw)
    point = vehicle.point_on_globe(waypoint.latitude, waypoint.longitude)
    return point, None if yaw is None else vehicle.heading_on_globe(yaw)


class WaypointDriver(WaypointFollower):
    """The waypoint may be set before Ready. A new waypoint on the way keeps the speed; at the waypoint the drive ends.

    SetTravelSpeed starts that driver of a component whose waypoint was set last. The command that started the drive,
    or last changed it, is completed when the waypoint is reached.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._command = CommandCompletion()

    def waypoint_exists(self, msg: Any) -> bool:
        """Guard: for a command, this client has set a waypoint; for a query, any of this kind was set or driven to."""
        if msg.IS_COMMAND:
            return self.vehicle.goal is not None and self.accepts(self.vehicle.goal)
        return self.accepts(self.vehicle.waypoint)

    def accepts(self, waypoint: Waypoint | None) -> bool:
        """True for waypoints in this driver's frame."""
        raise NotImplementedError(f"{type(self).__name__}.is_mine")

    def set_target(self, waypoint: Waypoint) -> None:
        """Keep the waypoint; if this driver is driving, drive to it immediately."""
        self.vehicle.goal = self.vehicle.waypoint = waypoint
        if self.is_driving:
            self._start(waypoint, self.vehicle.pilot.travel_speed)

    def set_travel_speed(self, msg: Any) -> None:
        """Start for the waypoint, or change the speed; zero waits."""
        speed, goal = self.usable_speed(msg), self.vehicle.goal
        if speed is None or goal is None:
            return
        if not self.is_driving:
            self._start(goal, speed)
            return
        self.vehicle.pilot.travel_speed = speed
        if speed:
            self._begin_command()

    def set_travel_speed_ext(self, msg: Any) -> None:
        """Same as `set_travel_speed`; ignored, and counted, for a speed that is not one over ground."""
        self.set_travel_speed(msg)

    def on_arrival(self) -> None:
        """The command is completed."""
        self._command(True)
        super().on_arrival()

    def on_preempted(self) -> None:
        """The command has failed."""
        self._command(False)

    def resumption(self) -> Callable[[], None] | None:
        """Drive on to the waypoint."""
        waypoint, speed = self.vehicle.waypoint, self.vehicle.pilot.travel_speed
        if waypoint is None or not speed:
            return None
        return lambda: self._start(waypoint, speed)

    def _start(self, waypoint: Waypoint, speed: float) -> None:
        self.drive_to(waypoint, speed, is_last=True)
        self._begin_command()

    def _begin_command(self) -> None:
        """The command that is being handled replaces the one before, which has failed."""
        self._command(False)
        self._command = self.host.begin_command()

    def control_lost(self) -> None:
        """Forget the waypoint: the next client has to set its own."""
        super().control_lost()
        self.vehicle.goal = None


class LocalWaypointDriver(WaypointDriver, urn="urn:jaus:jss:mobility:LocalWaypointDriver"):
    """Along the straight line from the present position; if the local frame is set, the waypoint moves with it."""

    def accepts(self, waypoint: Waypoint | None) -> bool:
        """Local waypoints."""
        return isinstance(waypoint, LocalWaypoint)

    def set_waypoint(self, msg: SetLocalWaypoint) -> None:
        """Accepted from the controlling client, also in Standby."""
        self.set_target(local_waypoint(msg))

    def set_waypoint_ext(self, msg: SetLocalWaypointExt) -> None:
        """Same as `set_waypoint`; the height is only reported."""
        self.set_target(local_waypoint(msg))

    def report_local_waypoint(self) -> ReportLocalWaypoint | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.vehicle.waypoint
        return waypoint.report() if isinstance(waypoint, LocalWaypoint) else None

    def report_local_waypoint_ext(self) -> ReportLocalWaypointExt | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.vehicle.waypoint
        return waypoint.report_ext() if isinstance(waypoint, LocalWaypoint) else None


class GlobalWaypointDriver(WaypointDriver, urn="urn:jaus:jss:mobility:GlobalWaypointDriver"):
    """Waypoints are latitude, longitude and true heading. The vehicle needs an origin."""

    def attached(self) -> None:
        """Raises `ConfigError` without an origin."""
        super().attached()
        self.vehicle.global_frame()

    def accepts(self, waypoint: Waypoint | None) -> bool:
        """Global waypoints."""
        return isinstance(waypoint, GlobalWaypoint)

    def set_waypoint(self, msg: SetGlobalWaypoint) -> None:
        """Accepted from the controlling client, also in Standby."""
        self.set_target(global_waypoint(msg))

    def set_waypoint_ext(self, msg: SetGlobalWaypointExt) -> None:
        """Same as `set_waypoint`; the height is only reported."""
        self.set_target(global_waypoint(msg))

    def report_global_waypoint(self) -> ReportGlobalWaypoint | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.vehicle.waypoint
        return waypoint.report() if isinstance(waypoint, GlobalWaypoint) else None

    def report_global_waypoint_ext(self) -> ReportGlobalWaypointExt | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.vehicle.waypoint
        return waypoint.report_ext() if isinstance(waypoint, GlobalWaypoint) else None


class ListProgress(Enum):
    """How far a list has come."""

    EMPTY = "empty"
    LOADED = "loaded"
    """It has waypoints, and is not executed."""
    EXECUTING = "executing"
    PAUSED = "paused"
    """The speed is zero, or the robot waits at a waypoint for the next execute command."""
    TIMED_WAIT = "timed wait"
    COMPLETE = "complete"
    FAULT = "fault"
    """The robot was stopped because it may tip over."""


_WAIT: Final = "wait at a waypoint"


class WaypointListDriver(WaypointFollower, ListDriver):
    """Executes the list at the speed of ExecuteList; the robot stops at the last waypoint.

    A component has one list. With both drivers it may hold waypoints of both kinds; each driver executes its own.
    `information` has the direction and the waits that clients add to waypoints by the services of IOP. The robot stops
    at a waypoint where it waits, or changes its direction.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self.information = AddedInformation()
        self._waits_since: float | None = None
        self._passed: Waypoint | None = None
        """The waypoint that the robot has just passed."""

    @property
    def waited(self) -> float:
        """Seconds that the robot has waited at the present waypoint; 0 while it drives."""
        return 0.0 if self._waits_since is None else self.host.now - self._waits_since

    @property
    def progress(self) -> ListProgress:
        """How far the waypoints of this kind have come."""
        elements, pilot = self.elements, self.vehicle.pilot
        if not any(isinstance(elements.message(uid), self.element_types) for uid in elements.list.order):
            return ListProgress.EMPTY
        if elements.active:
            if self._waits_since is not None:
                return ListProgress.TIMED_WAIT if self.information.of(elements.active).wait else ListProgress.PAUSED
            return ListProgress.EXECUTING if pilot.travel_speed else ListProgress.PAUSED
        if elements.is_complete:
            return ListProgress.COMPLETE
        return ListProgress.FAULT if pilot.tilt_problem else ListProgress.LOADED

    def waypoint_of(self, message: Message) -> Waypoint:
        """The waypoint of an element's message."""
        raise NotImplementedError(f"{type(self).__name__}.waypoint_of")

    def waypoint(self) -> Waypoint | None:
        """Waypoint to report: the active element, else the one last set or driven to, else the first of the list."""
        if not self.elements.active and self.vehicle.waypoint is not None:
            return self.vehicle.waypoint
        message = self.elements.message(self.elements.active or next(iter(self.elements.list.order), 0))
        return self.waypoint_of(message) if isinstance(message, self.element_types) else None

    # --- actions

    def execute_waypoint_list(self, msg: Any) -> None:
        """Start, or restart, at the given element."""
        speed = self.usable_speed(msg)
        if speed is None:
            return
        if self._waits_for_command and msg.element_uid == self.elements.active:
            self._continue(speed)
        else:
            self._start(msg.element_uid, speed)

    @property
    def _waits_for_command(self) -> bool:
        return self._waits_since is not None and self.information.of(self.elements.active).wait == 0.0

    def _continue(self, speed: float) -> None:
        """Leave the waypoint where the robot waits for an execute command."""
        self.vehicle.pilot.travel_speed = speed
        self._end_wait()
        self.elements.done()

    def _end_wait(self) -> None:
        self._waits_since = None
        self.host.cancel_timer(_WAIT)

    def _start(self, uid: int, speed: float) -> None:
        self._passed = None
        self.elements.execute(uid)
        self.vehicle.pilot.travel_speed = speed

    def resumption(self) -> Callable[[], None] | None:
        """Go on with the active element."""
        uid, speed = self.elements.active, self.vehicle.pilot.travel_speed
        return (lambda: self._start(uid, speed)) if uid and speed else None

    def modify_travel_speed(self, msg: Any) -> None:
        """Change the speed; zero waits. Ignored while no list is executed."""
        speed = self.usable_speed(msg)
        if speed is None or not self.elements.active:
            return
        if speed and self._waits_for_command:
            self._continue(speed)
        self.vehicle.pilot.travel_speed = speed

    def begin_element(self, uid: int, message: Message) -> None:
        """Drive to the waypoint."""
        self._end_wait()
        passed, self._passed = self._passed, None
        self.drive_to(
            self.waypoint_of(message),
            self.vehicle.pilot.travel_speed,
            is_last=self._stops_at(uid),
            information=self.information.of(uid),
            before=passed,
        )

    def _stops_at(self, uid: int) -> bool:
        following, here = self.elements.list.next(uid), self.information.of(uid)
        return not following or here.wait is not None or self.information.of(following).is_reverse != here.is_reverse

    def end_elements(self) -> None:
        """Stop, unless the list continues with an element of another driver."""
        self._end_wait()
        if not self.elements.active:
            self.vehicle.pilot.release(self)

    def on_arrival(self) -> None:
        """Continue with the next element, after the wait at this one."""
        wait = self.information.of(self.elements.active).wait
        if wait is None:
            self._passed = self.waypoint()
            self.elements.done()
            return
        self._waits_since = self.host.now
        if wait:
            self.host.set_timer(_WAIT, self.host.now + wait, self._after_wait)

    def _after_wait(self) -> None:
        self._end_wait()
        self.elements.done()

    def on_deleted(self, uids: Collection[int]) -> None:
        """Forget what was added to the elements: another one may get the number."""
        self.information.forget(uids)

    def on_preempted(self) -> None:
        """Stop the list, unless its next element belongs to another list driver."""
        self._passed = None
        if self.elements.active and not isinstance(self.vehicle.pilot.driver, WaypointListDriver):
            self.elements.stop()

    # --- reports

    def report_active_element(self) -> ReportActiveElement:
        """The active element, 0 for none."""
        return ReportActiveElement(element_uid=self.elements.active)


class LocalWaypointListDriver(WaypointListDriver, urn="urn:jaus:jss:mobility:LocalWaypointListDriver"):
    """Drives along lists of SetLocalWaypoint and SetLocalWaypointExt messages."""

    element_types = (SetLocalWaypoint, SetLocalWaypointExt)

    def waypoint_of(self, message: Message) -> LocalWaypoint:
        """The waypoint of an element's message."""
        assert isinstance(message, SetLocalWaypoint | SetLocalWaypointExt)
        return local_waypoint(message)

    def waypoint_exists(self) -> bool:
        """True if there is a local waypoint to report."""
        return isinstance(self.waypoint(), LocalWaypoint)

    def report_local_waypoint(self) -> ReportLocalWaypoint | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report() if isinstance(waypoint, LocalWaypoint) else None

    def report_local_waypoint_ext(self) -> ReportLocalWaypointExt | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report_ext() if isinstance(waypoint, LocalWaypoint) else None


class GlobalWaypointListDriver(WaypointListDriver, urn="urn:jaus:jss:mobility:GlobalWaypointListDriver"):
    """Drives along lists of SetGlobalWaypoint and SetGlobalWaypointExt messages. The vehicle needs an origin."""

    element_types = (SetGlobalWaypoint, SetGlobalWaypointExt)

    def attached(self) -> None:
        """Raises `ConfigError` without an origin."""
        super().attached()
        self.vehicle.global_frame()

    def waypoint_of(self, message: Message) -> GlobalWaypoint:
        """The waypoint of an element's message."""
        assert isinstance(message, SetGlobalWaypoint | SetGlobalWaypointExt)
        return global_waypoint(message)

    def waypoint_exists(self) -> bool:
        """True if there is a global waypoint to report."""
        return isinstance(self.waypoint(), GlobalWaypoint)

    def report_global_waypoint(self) -> ReportGlobalWaypoint | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report() if isinstance(waypoint, GlobalWaypoint) else None

    def report_global_waypoint_ext(self) -> ReportGlobalWaypointExt | None:
        """The waypoint; None if there is none of this kind."""
        waypoint = self.waypoint()
        return waypoint.report_ext() if isinstance(waypoint, GlobalWaypoint) else None
