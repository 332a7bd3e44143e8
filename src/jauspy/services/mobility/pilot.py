"""The pilot steers the chassis for the driver services of a component; the newest command preempts the others.

See docs/adr/0037-guidance.md. A robot that may tip over is stopped (`TiltGuard`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Final, Protocol

from jauspy.geometry.poses import jaus_pose, jaus_twist
from jauspy.logs import get_logger
from jauspy.platform.chassis import Chassis
from jauspy.platform.contract import DriveBase
from jauspy.platform.guards import ObstacleGuard
from jauspy.platform.localization import Localization
from jauspy.platform.stability import StabilityMonitor
from jauspy.services.mobility import tilt_guard
from jauspy.services.mobility.courses import Course, Halt, VectorCourse, VelocityCourse
from jauspy.services.mobility.tilt_guard import TiltGuard
from jauspy.services.mobility.velocity_control import (
    STANDSTILL,
    AccelerationLimits,
    PlanarVelocity,
    VelocityControl,
    ramped,
)
from jauspy.services.service import ServiceHost

PERIOD: Final = 0.02
"""Seconds between two steps of the control loop."""
MAX_TIME_STEP: Final = 0.1
"""Seconds that one step counts at most, so that the velocity does not jump after a stall."""
MIN_SPEED: Final = 0.05
"""m/s above which a robot is to drive on, and not to turn on the spot, where tracks slip anyway."""
SLIP: Final = 0.2
SLIP_SHARE: Final = 0.25
"""rad/s, and share of what the tracks turn, by which they may turn faster than the robot on the ground."""
_TIMER: Final = "pilot"
_TILT_TIMER: Final = "tilt guard"

_LOG: Final = get_logger("jauspy.mobility")


class DriveOwner(Protocol):
    """A service that can command the chassis."""

    @property
    def uses_travel_speed(self) -> bool:
        """True if the pilot's travel speed stays while this service drives."""
        ...

    def on_arrival(self) -> None:
        """Called at the end of the course; the platform slows down until the next command."""
        ...

    def on_preempted(self) -> None:
        """Called when another service's command, or a stop, ends this service's motion."""
        ...

    def on_endless_motion(self) -> None:
        """Called with each effort, velocity or vector of this service, which would last until its next command."""
        ...


@dataclass(frozen=True, slots=True)
class SpeedOverride:
    """A share of the commanded speed, 0..1, and a bound in m/s, for whatever drives; turns are slowed alike."""

    share: float = 1.0
    bound: float = math.inf

    def factor(self, speed: float) -> float:
        """The factor for a speed in m/s."""
        wanted = abs(speed) * self.share
        return self.share if wanted <= self.bound else self.share * self.bound / wanted


NO_OVERRIDE: Final = SpeedOverride()


class Pilot:
    """Follows the course, or sets the effort, of the service that commanded last."""

    def __init__(
        self,
        drive: DriveBase,
        chassis: Chassis,
        *,
        localization: Localization | None = None,
        stability: StabilityMonitor | None = None,
        obstacle_guard: ObstacleGuard | None = None,
    ) -> None:
        self._drive = drive
        self._localization = localization
        self._obstacle_guard = obstacle_guard
        self._chassis = chassis
        self.limits = AccelerationLimits(
            chassis.acceleration, chassis.deceleration, chassis.turn_acceleration, chassis.turn_acceleration
        )
        self._control = VelocityControl(chassis)
        self._host: ServiceHost | None = None
        self._course: Course | None = None
        self._velocity = STANDSTILL
        self._last = 0.0
        self._guard = TiltGuard(chassis.tilt_guard, stability) if chassis.tilt_guard or stability else None
        self._override = NO_OVERRIDE
        self._effort: tuple[float, float, float] | None = None
        """Of a driver without a course: forward, turning right, to the right."""
        self.driver: DriveOwner | None = None
        """The service whose command is carried out; None while the platform stands."""
        self.tilt_problem = ""
        """Why the tilt guard stopped the robot, until it is commanded again."""
        self.travel_speed = 0.0
        """m/s, negative backward, of the waypoint drivers; zero while another service, or none, drives."""

    def attach(self, host: ServiceHost) -> None:
        """Use the clock and the timers of this component; each of its drivers calls this."""
        self._host = host

    def set_effort(self, driver: DriveOwner, forward: float, right: float, sideways: float = 0.0) -> None:
        """Open loop: set fractions of the full effort, -1..1, immediately: forward, turning right, and to the right."""
        if self._refuses(driver, stops=not (forward or right or sideways)):
            return
        self._set_driver(driver)
        self._end_course()
        self._effort = forward, right, sideways
        self._set_slowed_effort()
        driver.on_endless_motion()

    @property
    def override(self) -> SpeedOverride:
        """Slows down whatever drives, as a vehicle that follows this one may ask."""
        return self._override

    @override.setter
    def override(self, override: SpeedOverride) -> None:
        self._override = override
        if self._effort is not None and self.driver is not None:
            self._set_slowed_effort()

    def _set_slowed_effort(self) -> None:
        forward, right, sideways = self._effort or (0.0, 0.0, 0.0)
        factor = self._guard_factor
        factor *= self._override.factor(factor * max(abs(forward), abs(sideways)) * self._chassis.max_speed)
        turn = right if self._chassis.min_turn_radius else factor * right  # the angle of a chassis that steers
        self._set_efforts(factor * forward, turn, factor * sideways)

    def follow(self, driver: DriveOwner, course: Course) -> None:
        """Closed loop: change from the measured velocity to that of the course."""
        stops = isinstance(course, VelocityCourse) and course.velocity == STANDSTILL
        if isinstance(course, VelocityCourse | VectorCourse):
            if self._refuses(driver, stops=stops):
                return
        elif self._guard is not None:
            self._guard.let_go()  # a command with an end is given on purpose
        self._set_driver(driver)
        self._effort = None
        if self._course is None:
            self._control.reset()
            self._velocity = self._measured()
            self._start_steering(self._clock)
        self._course = course
        if isinstance(course, VelocityCourse | VectorCourse):
            driver.on_endless_motion()

    def release(self, driver: DriveOwner) -> None:
        """Stop immediately if this service drives."""
        if self.driver is driver:
            self.stop()

    def stop(self) -> None:
        """Stop immediately, whichever service drives. May be called twice."""
        if self._guard is not None:
            self._guard.let_go()
        self._halt()

    def _halt(self) -> None:
        self._end_course()
        self._drive.stop()
        self._set_driver(None)

    def _refuses(self, driver: DriveOwner, *, stops: bool) -> bool:
        """True, after `on_preempted`, while the tilt guard holds the robot. `stops`: the command lets go."""
        guard = self._guard
        if guard is None:
            return False
        if stops:
            guard.let_go()
        if guard.allows(self._clock.now):
            return False
        driver.on_preempted()
        return True

    def _watch_tilt(self) -> None:
        """Stop a robot that is tilted too far, for as long as a service drives it."""
        guard, host = self._guard, self._clock
        if guard is None or self.driver is None:
            return
        before = guard.factor
        if problem := guard.problem(self._drive.pose()):
            host.count("tilt", problem)
            _LOG.warning("%s: %s", host.id, problem)
            self.tilt_problem = problem
            self._halt()
        else:
            if self._effort is not None and guard.factor != before:
                self._set_slowed_effort()
            host.set_timer(_TILT_TIMER, host.now + tilt_guard.PERIOD, self._watch_tilt)

    def _set_driver(self, driver: DriveOwner | None) -> None:
        before, self.driver = self.driver, driver
        if driver is not None and before is None and self._guard is not None:
            self.tilt_problem = ""
            self._clock.set_timer(_TILT_TIMER, self._clock.now, self._watch_tilt)
        if driver is None or not driver.uses_travel_speed:
            self.travel_speed = 0.0
        if before is not None and before is not driver:
            before.on_preempted()

    @property
    def _clock(self) -> ServiceHost:
        if self._host is None:
            raise RuntimeError("no driver service has attached the pilot to its component")
        return self._host

    def _start_steering(self, host: ServiceHost) -> None:
        self._last = host.now
        host.set_timer(_TIMER, host.now, self._steer)

    def _end_course(self) -> None:
        self._course = self._effort = None
        if self._host is not None:
            self._host.cancel_timer(_TIMER)

    def _steer(self) -> None:
        host, course = self._clock, self._course
        if course is None:
            return
        dt, self._last = min(MAX_TIME_STEP, host.now - self._last), host.now
        host.set_timer(_TIMER, host.now + PERIOD, self._steer)
        wanted = course.steer(jaus_pose(self._drive.pose()))
        if wanted is None:
            self._end_of_course()
        else:
            factor = self._guard_factor
            wanted = wanted.clamped(self._chassis.max_speed * factor, self._chassis.max_turn_rate * factor)
            self._move(self._slowed(wanted).feasible(self._chassis), course.limits or self.limits, dt)

    @property
    def _guard_factor(self) -> float:
        """The part of its speed that a robot near to tipping over may have."""
        return 1.0 if self._guard is None else self._guard.factor

    def _slowed(self, wanted: PlanarVelocity) -> PlanarVelocity:
        if self._override is NO_OVERRIDE:
            return wanted
        factor = self._override.factor(math.hypot(wanted.speed, wanted.sideways))
        return PlanarVelocity(factor * wanted.speed, factor * wanted.turn_rate, factor * wanted.sideways)

    def _end_of_course(self) -> None:
        """End the course; the driver may command another one."""
        self._course = Halt()
        if self.driver is not None:
            self.driver.on_arrival()

    def _move(self, wanted: PlanarVelocity, limits: AccelerationLimits, dt: float) -> None:
        if self._obstacle_guard is not None and self._obstacle_guard.state().active:
            self._control.reset()  # what the guard keeps it from is no error to integrate
            self._velocity = self._measured()
        self._velocity = ramped(self._velocity, wanted, limits, dt)
        if self._velocity == wanted == STANDSTILL:
            self._control.reset()
            self._drive.stop()
            return
        measured = self._measured()
        if abs(self._velocity.speed) > MIN_SPEED:
            measured = replace(measured, turn_rate=measured.turn_rate - self._turn_slip())
        efforts = self._control.efforts(self._velocity, measured, dt)
        self._set_efforts(efforts.forward, efforts.right_turn, efforts.sideways)

    def _turn_slip(self) -> float:
        """rad/s to the left by which tracks or wheels turn much faster than the robot, of which less is not slip.

        With one track on an edge the robot does not turn, while the other one slips: by the speed of the robot, and by
        the mean of the tracks, all would be as it is to be.
        """
        if self._localization is None:
            return 0.0
        state = self._localization.state()
        usual = SLIP + SLIP_SHARE * abs(state.turn_slip + state.twist.wz)
        return math.copysign(max(0.0, abs(state.turn_slip) - usual), state.turn_slip)

    def _set_efforts(self, forward: float, right: float, sideways: float) -> None:
        if self._chassis.moves_sideways:
            self._drive.set_effort(linear_x=forward, rotational_z=-right, linear_y=-sideways)
        else:
            self._drive.set_effort(linear_x=forward, rotational_z=-right)

    def _measured(self) -> PlanarVelocity:
        twist = jaus_twist(self._drive.twist())
        return PlanarVelocity(twist.vx, twist.wz, twist.vy if self._chassis.moves_sideways else 0.0)
