"""Who drives: the driver services of a component share one chassis, and the newest command has it.

See docs/adr/0037-guidance.md.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from jauspy.geometry.poses import jaus_pose, jaus_twist
from jauspy.platform.chassis import Chassis
from jauspy.platform.contract import DriveBase
from jauspy.services.mobility.guidance.course import Course, Halt
from jauspy.services.mobility.guidance.motion import STANDSTILL, Limits, Motion, approach
from jauspy.services.mobility.guidance.velocity_control import VelocityControl, limit

if TYPE_CHECKING:
    from jauspy.services.host import Host
    from jauspy.services.mobility.driver import Driver

PERIOD: Final = 0.02
"""Seconds between two looks at where the platform is."""
LONGEST: Final = 0.1
"""Seconds of which guidance knows at most at once: after a stall it does not jump."""
_TIMER: Final = "pilot"


class Pilot:
    """Steers the chassis along the course of the driver service that commanded last."""

    def __init__(self, drive: DriveBase, chassis: Chassis) -> None:
        self._drive = drive
        self._chassis = chassis
        self.limits = Limits(
            chassis.acceleration, chassis.deceleration, chassis.turn_acceleration, chassis.turn_acceleration
        )
        self._control = VelocityControl()
        self._host: Host | None = None
        self._course: Course | None = None
        self._motion = STANDSTILL
        self._last = 0.0
        self.driver: Driver | None = None
        """Whose command the platform follows; None while it just stands."""
        self.travel_speed = 0.0
        """Of the waypoint drivers, m/s, negative backward; zero while another driver or none has the chassis."""

    def attach(self, host: Host) -> None:
        """Keep time with this component; each of its drivers calls this."""
        self._host = host

    def push(self, driver: Driver, forward: float, right: float) -> None:
        """Open loop: fractions of the full effort, at once."""
        self._hand_to(driver)
        self._end_course()
        self._drive.set_effort(linear_x=forward, rotational_z=-right)

    def follow(self, driver: Driver, course: Course) -> None:
        """Closed loop: go over from the motion that the platform has to that of the course."""
        self._hand_to(driver)
        if self._course is None:
            self._control.reset()
            self._motion = self._measured()
            self._start(self._clock)
        self._course = course

    def release(self, driver: Driver) -> None:
        """That driver is done; stops at once, unless another one has the chassis."""
        if self.driver is driver:
            self.stop()

    def stop(self) -> None:
        """Stop at once, whoever drives. Twice is fine."""
        self._end_course()
        self._drive.stop()
        self._hand_to(None)

    def _hand_to(self, driver: Driver | None) -> None:
        before, self.driver = self.driver, driver
        if driver is None or not driver.travels:
            self.travel_speed = 0.0
        if before is not None and before is not driver:
            before.taken_over()

    @property
    def _clock(self) -> Host:
        if self._host is None:
            raise RuntimeError("no driver service has attached the pilot to its component")
        return self._host

    def _start(self, host: Host) -> None:
        self._last = host.now
        host.set_timer(_TIMER, host.now, self._steer)

    def _end_course(self) -> None:
        self._course = None
        if self._host is not None:
            self._host.cancel_timer(_TIMER)

    def _steer(self) -> None:
        host, course = self._clock, self._course
        if course is None:
            return
        dt, self._last = min(LONGEST, host.now - self._last), host.now
        host.set_timer(_TIMER, host.now + PERIOD, self._steer)
        wanted = course.steer(jaus_pose(self._drive.pose()))
        if wanted is None:
            self._arrive()
        else:
            self._move(self._possible(wanted), course.limits or self.limits, dt)

    def _arrive(self) -> None:
        """The driver says what comes next; until it does, the platform slows down."""
        self._course = Halt()
        if self.driver is not None:
            self.driver.arrived()

    def _move(self, wanted: Motion, limits: Limits, dt: float) -> None:
        self._motion = approach(self._motion, wanted, limits, dt)
        if self._motion == wanted == STANDSTILL:
            self._control.reset()
            self._drive.stop()
            return
        forward, right = self._control.efforts(self._motion, self._measured(), dt)
        self._drive.set_effort(linear_x=forward, rotational_z=-right)

    def _possible(self, wanted: Motion) -> Motion:
        chassis = self._chassis
        return Motion(limit(wanted.speed, chassis.max_speed), limit(wanted.turn_rate, chassis.max_turn_rate))

    def _measured(self) -> Motion:
        twist = jaus_twist(self._drive.twist())
        return Motion(twist.vx, twist.wz)
