"""Estimates the pose of a simulated robot from its simulated sensors, as the computer of a real one does.

The local pose is dead reckoning: distance from encoders, attitude from the inertial measurement unit. At rest the bias
of the gyroscope is measured. A Kalman filter follows the errors; a second one corrects the global pose by GNSS. See
docs/adr/0111-localisation.md.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, NamedTuple, Protocol, TypeAlias

from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.geometry.vectors import GRAVITY, Quaternion, Vector, add, difference, dot, scaled
from jauspy.platform.localization import (
    GnssSetup,
    ImuSetup,
    Localization,
    LocalizationSetup,
    LocalizationState,
    PoseEstimate,
)
from jauspy.platform.motion_sensors import (
    Encoders,
    GnssReceiver,
    InertialSensor,
    PlanarSpeeds,
    Travel,
    generator,
)
from jauspy.platform.ranging import Sampling

FILTER_PERIOD: Final = 0.2
"""Seconds between two steps of the filters; dead reckoning has the rate of the inertial measurement unit."""
RATE: Final = 50.0
"""Hertz of dead reckoning without one."""

SLIP: Final = 0.01
"""Metres after one metre, along each axis, that tracks slip; grows with the square root of the way."""
SLIP_TIME: Final = 0.1
"""Seconds over which it is averaged how much faster tracks turn than the robot: encoders count in steps."""
TURN_ERROR: Final = 0.15
"""Standard deviation of a turn by odometry alone, as a part of it: tracks skid, more or less by the ground."""
TILT_ERROR: Final = math.radians(0.2)
"""Standard deviation of roll and pitch besides what the accelerometer's bias causes: shocks, accelerations."""

REST_TIME: Final = 0.5
"""Seconds without a count after which the robot is at rest."""
MAX_REST_RATE: Final = math.radians(1.0)
"""rad/s above which it is not at rest: it is turned from outside."""
FIRST_FIX_DEVIATION: Final = 1000.0
"""Standard deviation of the position before the first fix, in metres."""


MAX_INNOVATION: Final = 6.0
"""Standard deviations between fix and dead reckoning above which the fix is trusted: the robot slid, or was carried."""


class MeasuredDrive(Protocol):
    """A simulated chassis."""

    def pose(self) -> Pose:
        """The true pose in the world."""
        ...

    def twist(self) -> Twist:
        """The true velocity in the frame of the base."""
        ...

    def odometry(self) -> PlanarSpeeds:
        """The velocity at which tracks or wheels turn, as if nothing slipped."""
        ...


@dataclass(frozen=True, slots=True)
class Turning:
    """Turning behaviour of a chassis, as its odometry assumes."""

    point: float = 0.0
    """Metres ahead of the base, of the point that does not move sideways."""
    slip: float = 0.02
    """Metres after one radian, along each axis, that a turn on the spot shifts the robot besides."""


class Localizer(Localization):
    """The localisation of a simulated chassis; `step` is to be called after each step of the simulation.

    The robot is at rest when it is made, and its time is zero.
    """

    def __init__(self, setup: LocalizationSetup, drive: MeasuredDrive, turning: Turning = Turning()) -> None:
        self._drive, self._turning = drive, turning
        self._imu_setup = setup.imu or _NO_IMU
        pose, twist = drive.pose(), drive.twist()
        self._encoders = Encoders(setup.odometry, generator(setup.seed, "encoders"))
        self._imu = None
        self._bias: Vector = (0.0, 0.0, 0.0)
        force: Vector = (0.0, 0.0, GRAVITY)
        if setup.imu is not None:
            self._imu = InertialSensor(setup.imu, generator(setup.seed, "imu"), pose, twist)
            self._bias, force = self._imu.align()
        self._attitude = AttitudeFilter(force, pose.yaw)
        self._angles = self._attitude.angles()
        self._x, self._y, self._z = pose.x, pose.y, pose.z
        self._rates: Vector = (0.0, 0.0, 0.0)
        self._speed = 0.0
        self._turn_slip = 0.0
        self._rest = 0.0
        self._sampling = Sampling(self._imu_setup.rate)
        self._counted_at = self._read_at = self._moved_at = 0.0
        self._moved = _Moved(self._angles[2])
        odometry = setup.odometry
        self._position_noise = odometry.noise**2 + SLIP**2
        self._scale_error = math.hypot(odometry.scale_error, SLIP)
        self._resolution = odometry.resolution
        self._tilt_rms = math.hypot(self._imu_setup.acceleration_bias / GRAVITY, TILT_ERROR)
        aligned = self._imu_setup.gyro_noise / math.sqrt(self._imu_setup.alignment)
        errors = (odometry.scale_error, aligned, self._imu_setup.gyro_scale_error)
        self._local = PoseFilter(pose.x, pose.y, pose.yaw, (0.0, 0.0, 0.0, *errors, 0.0, 0.0))
        self._height_rms = 0.0
        self._globe = (
            _Globe(setup.gnss, setup.seed, drive, pose.yaw, errors) if isinstance(setup.gnss, GnssSetup) else None
        )
        self._sampling.is_due(0.0)
        self._state: LocalizationState | None = None
        still: Vector = (0.0, 0.0, 0.0)
        self._last = _Measured(Travel(*still), still, still, 1.0 / self._imu_setup.rate)

    def state(self) -> LocalizationState:
        """The estimate after the last measurement."""
        if self._state is None:
            self._state = self._estimate(self._last)
        return self._state

    def declare(self, position_rms: float | None, heading_rms: float | None) -> None:
        """Same as `Localization.declare`."""
        self._move_filters(self._read_at)
        if position_rms is not None:
            self._local.reset_variance((X, Y), position_rms / math.sqrt(3.0))
            self._height_rms = position_rms / math.sqrt(3.0)
        if heading_rms is not None:
            self._local.reset_variance((YAW,), heading_rms)
        self._state = None

    def step(self, now: float) -> None:
        """The robot's time is `now`, in seconds; never earlier than in the call before."""
        self._encoders.count(self._drive.odometry(), now - self._counted_at)
        self._counted_at = now
        if self._sampling.is_due(now) and now > self._read_at:
            dt, self._read_at = now - self._read_at, now
            self._update(dt)
            if now - self._moved_at >= FILTER_PERIOD:
                self._move_filters(now)
            if self._globe is not None and self._globe.is_due(now):
                self._move_filters(now)
                self._globe.fix(now, self._z)

    # --- dead reckoning

    def _update(self, dt: float) -> None:
        """Take the measurements of the last `dt` seconds."""
        travel = self._encoders.read()
        speed = travel.forward / dt
        if self._imu is not None:
            measured, force = self._imu.measure(self._drive.pose(), self._drive.twist(), dt)
        else:
            measured, force = (0.0, 0.0, travel.turn / dt), (0.0, 0.0, GRAVITY)
        rates = difference(measured, self._bias)
        self._rest = self._rest + dt if self._stands(travel, rates) else 0.0
        up, before = self._attitude.up(), self._attitude.forward()
        # accelerations: of the base without gravity, and of its turn
        linear = difference(force, scaled(up, GRAVITY))
        angular = scaled(difference(rates, self._rates), 1.0 / dt)
        at_rest = self._rest > REST_TIME
        self._rates = rates
        self._turn_slip += (travel.turn / dt - rates[2] - self._turn_slip) * min(1.0, dt / SLIP_TIME)
        # at rest a turn about the vertical is bias and noise: the heading stays
        turned = difference(rates, scaled(up, dot(rates, up))) if at_rest else rates
        # what the accelerometer measures of a curve and of speeding up, which is not gravity: dv/dt + w x v
        curving = ((speed - self._speed) / dt, rates[2] * speed, -rates[1] * speed)
        self._speed = speed
        if self._imu is None:
            curving = (0.0, 0.0, 0.0)
        self._attitude.turn(turned, difference(force, curving), dt)
        if not at_rest:
            left = travel.left - self._turning.point * rates[2] * dt
            travel = Travel(travel.forward, left, travel.turn)
        self._advance(travel, before)
        self._moved.add(self._angles[2], travel, measured if at_rest else None, dt)
        self._last = _Measured(travel, linear, angular, dt)
        self._state = None  # it is estimated when somebody wants it

    def _stands(self, travel: Travel, rates: Vector) -> bool:
        counts = max(abs(travel.forward), abs(travel.left)) / self._resolution
        return max(counts, abs(travel.turn) / self._resolution) < 1.5 and max(map(abs, rates)) < MAX_REST_RATE

    def _advance(self, travel: Travel, before: Vector) -> None:
        """Move along the mean of the directions before and after a turn."""
        after, self._angles = self._attitude.forward(), self._attitude.angles()
        dx, dy, dz = scaled(add(before, after), travel.forward / 2.0)
        if travel.left:
            yaw = self._angles[2]
            dx, dy = dx - math.sin(yaw) * travel.left, dy + math.cos(yaw) * travel.left
        self._x, self._y, self._z = self._x + dx, self._y + dy, self._z + dz
        self._moved.shift(dx, dy)

    # --- errors

    def _move_filters(self, now: float) -> None:
        """Move both filters by what happened since the last call; at rest, correct the bias of the gyroscope."""
        moved, dt = self._moved, now - self._moved_at
        if dt <= 0.0:
            return
        setup = self._imu_setup
        motion = moved.motion(dt, self._position_noise, self._turning.slip, setup)
        self._local.move(motion)
        self._height_rms += self._tilt_rms * moved.way
        if self._globe is not None:
            self._globe.move(motion, moved.start, self._tilt_rms * moved.way)
        if moved.at_rest > 0.0 and self._imu is not None:
            self._correct_bias(moved)
        self._moved, self._moved_at = _Moved(self._angles[2]), now

    def _correct_bias(self, moved: _Moved) -> None:
        """Correct the bias of the gyroscope by its mean at rest: a Kalman filter of one state for each axis."""
        noise = self._imu_setup.gyro_noise / math.sqrt(moved.at_rest)
        variance = self._local.covariance[GYRO_BIAS][GYRO_BIAS]
        gain = variance / (variance + noise**2)
        mean = scaled(moved.rates, 1.0 / moved.at_rest)
        step = scaled(difference(mean, self._bias), gain)
        if self._globe is not None:
            self._globe.correct_bias(mean[2] - self._bias[2], noise, step[2])
        x, y, z = self._bias
        self._bias = (x + step[0], y + step[1], z + step[2])
        self._local.reset_variance((GYRO_BIAS,), math.sqrt(variance * (1.0 - gain)))

    def _errors(self, local: PoseFilter) -> tuple[float, float, float]:
        return local.horizontal_rms, self._height_rms, math.hypot(self._tilt_rms, self._tilt_rms, local.yaw_rms)

    def _estimate(self, measured: _Measured) -> LocalizationState:
        travel, linear, angular, dt = measured
        roll, pitch, yaw = self._angles
        setup, local = self._imu_setup, self._local
        pose = Pose(self._x, self._y, self._z, roll, pitch, yaw=yaw)
        local_estimate = PoseEstimate(pose, *self._errors(local))
        gyro_noise = setup.gyro_noise / math.sqrt(dt)
        bias_rms = math.sqrt(local.covariance[GYRO_BIAS][GYRO_BIAS])
        force_noise = setup.acceleration_noise / math.sqrt(dt)
        return LocalizationState(
            local=local_estimate,
            globe=local_estimate if self._globe is None else self._globe.estimate(pose, self._moved, self._tilt_rms),
            twist=Twist(travel.forward / dt, travel.left / dt, 0.0, *self._rates),
            velocity_rms=math.hypot(self._scale_error * self._speed, self._resolution / dt),
            rate_rms=math.sqrt(3.0) * math.hypot(gyro_noise, bias_rms),
            acceleration=Acceleration(*linear, *angular),
            acceleration_rms=math.sqrt(3.0)
            * math.hypot(force_noise, setup.acceleration_bias, GRAVITY * self._tilt_rms),
            angular_acceleration_rms=math.sqrt(6.0) * gyro_noise / dt,
            turn_slip=self._turn_slip,
        )


_NO_IMU: Final = ImuSetup(
    rate=RATE, gyro_noise=0.0, gyro_scale_error=TURN_ERROR, acceleration_bias=GRAVITY * math.radians(3.0)
)
"""Stand-in for a missing IMU: the errors of an attitude that only wheels or tracks tell."""


class _Measured(NamedTuple):
    """The last measurements, of `dt` seconds."""

    travel: Travel
    linear: Vector
    """Acceleration, m/s^2."""
    angular: Vector
    """rad/s^2."""
    dt: float


class _Moved:
    """Dead reckoning since the last step of the filters; it began with the heading `start`."""

    def __init__(self, start: float) -> None:
        self.start = start
        self.x = self.y = self.yaw = self.way = self.turned = self.at_rest = 0.0
        self.rates: Vector = (0.0, 0.0, 0.0)
        """Integral at rest, radians."""
        self._heading = start

    def shift(self, dx: float, dy: float) -> None:
        """Metres in the local frame."""
        self.x += dx
        self.y += dy

    def add(self, heading: float, travel: Travel, rates: Vector | None, dt: float) -> None:
        """The heading after the travel; `rates` as measured if the robot is at rest."""
        turn = math.remainder(heading - self._heading, math.tau)
        self._heading = heading
        self.yaw += turn
        self.turned += abs(turn)
        self.way += math.hypot(travel.forward, travel.left)
        if rates is not None:
            self.at_rest += dt
            x, y, z = self.rates
            self.rates = (x + rates[0] * dt, y + rates[1] * dt, z + rates[2] * dt)

    def motion(self, dt: float, position_noise: float, turn_slip: float, imu: ImuSetup) -> DeadReckonedMotion:
        """Motion for the prediction of the filters, in the local frame. At rest the heading does not change."""
        moving = max(0.0, dt - self.at_rest)
        return DeadReckonedMotion(
            x=self.x,
            y=self.y,
            yaw=self.yaw,
            dt=moving,
            position_variance=position_noise * self.way + turn_slip**2 * self.turned,
            yaw_variance=imu.gyro_noise**2 * moving,
            bias_variance=imu.gyro_bias_walk**2 * dt,
        )


class _Globe:
    """The global pose: its horizontal part by a filter, its height by an offset to that of dead reckoning."""

    def __init__(self, setup: GnssSetup, seed: int, drive: MeasuredDrive, yaw: float, errors: Iterable[float]) -> None:
        self._setup = setup
        self._drive = drive
        self._receiver = GnssReceiver(setup, generator(seed, "gnss"))
        self._sampling = Sampling(setup.rate)
        x, y, z = self._receiver.fix(drive.pose(), 0.0)
        far, drift = FIRST_FIX_DEVIATION, setup.drift
        self._filter = PoseFilter(
            x, y, yaw + self._receiver.heading_error, (far, far, setup.heading_error, *errors, drift, drift)
        )
        self._observe(x, y)
        self._sampling.is_due(0.0)
        self._height_noise = setup.vertical * math.hypot(setup.noise, setup.drift)
        self._offset = z - drive.pose().z
        self._offset_variance = self._height_noise**2
        self._fixed_at = 0.0

    def is_due(self, now: float) -> bool:
        """True when a fix is due."""
        return self._sampling.is_due(now)

    def fix(self, now: float, height: float) -> None:
        """Correct by a fix; `height` is that of dead reckoning, metres."""
        x, y, z = self._receiver.fix(self._drive.pose(), now)
        self._filter.decay_fix_errors(math.exp((self._fixed_at - now) / self._setup.drift_time), self._setup.drift)
        self._fixed_at = now
        self._observe(x, y)
        gain = self._offset_variance / (self._offset_variance + self._height_noise**2)
        self._offset += gain * (z - height - self._offset)
        self._offset_variance *= 1.0 - gain

    def move(self, motion: DeadReckonedMotion, heading: float, climbed: float) -> None:
        """Move by dead reckoning, which began with `heading` in the local frame; `climbed` is an error in metres."""
        c, s = self._rotation(heading)
        self._filter.move(
            DeadReckonedMotion(
                x=c * motion.x - s * motion.y,
                y=s * motion.x + c * motion.y,
                yaw=motion.yaw,
                dt=motion.dt,
                position_variance=motion.position_variance,
                yaw_variance=motion.yaw_variance,
                bias_variance=motion.bias_variance,
            )
        )
        self._offset_variance += climbed**2

    def correct_bias(self, residual: float, noise: float, step: float) -> None:
        """The residual bias that was measured, rad/s; dead reckoning uses `step` of it from now on."""
        self._filter.observe((GYRO_BIAS,), residual, noise)
        self._filter.state[GYRO_BIAS] -= step

    def estimate(self, pose: Pose, moved: _Moved, tilt_rms: float) -> PoseEstimate:
        """The pose, where `moved` is what the filter does not know yet."""
        c, s = self._rotation(moved.start)
        state = self._filter.state
        x, y = state[X] + c * moved.x - s * moved.y, state[Y] + s * moved.x + c * moved.y
        yaw = math.remainder(state[YAW] + moved.yaw, math.tau)
        height_rms = math.hypot(math.sqrt(self._offset_variance), self._setup.vertical * self._setup.drift)
        attitude_rms = math.hypot(tilt_rms, tilt_rms, self._filter.yaw_rms)
        antenna = Pose(x, y, pose.z + self._offset, pose.roll, pose.pitch, yaw=yaw)
        return PoseEstimate(antenna, self._filter.horizontal_rms, height_rms, attitude_rms)

    def _rotation(self, heading: float) -> tuple[float, float]:
        turn = self._filter.state[YAW] - heading
        return math.cos(turn), math.sin(turn)

    def _observe(self, x: float, y: float) -> None:
        # a fix far from dead reckoning means that this is wrong: forget the position, so that the fix replaces it
        lost = max(
            self._filter.normalised_innovation((X, DRIFT_X), x, self._setup.noise),
            self._filter.normalised_innovation((Y, DRIFT_Y), y, self._setup.noise),
        )
        if lost > MAX_INNOVATION:
            self._filter.reset_variance((X, Y), FIRST_FIX_DEVIATION)
        self._filter.observe((X, DRIFT_X), x, self._setup.noise)
        self._filter.observe((Y, DRIFT_Y), y, self._setup.noise)


GRAVITY_TIME: Final = 3.0
"""Seconds in which gravity corrects roll and pitch to a part of 1/e."""


class AttitudeFilter:
    """The attitude of the base in a frame with z up. Starts with roll and pitch by the force at rest, and a yaw.

    A complementary filter on quaternions, after Mahony, Hamel and Pflimlin (2008): the gyroscope is integrated, gravity
    corrects roll and pitch.
    """

    def __init__(self, force: Vector, yaw: float) -> None:
        x, y, z = force
        self.quaternion = _from_angles(math.atan2(y, z), math.atan2(-x, math.hypot(y, z)), yaw)

    def up(self) -> Vector:
        """The vertical, in the frame of the base."""
        w, x, y, z = self.quaternion
        return 2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)

    def forward(self) -> Vector:
        """The x axis of the base, in the outer frame."""
        w, x, y, z = self.quaternion
        return 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)

    def angles(self) -> tuple[float, float, float]:
        """Roll, pitch and yaw, radians."""
        w, x, y, z = self.quaternion
        roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
        pitch = math.asin(min(1.0, max(-1.0, 2.0 * (w * y - z * x))))
        return roll, pitch, math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))

    def turn(self, rates: Vector, force: Vector, dt: float) -> None:
        """Turn at `rates` (rad/s) for `dt` seconds; `force` (m/s^2) is what holds against gravity alone."""
        wx, wy, wz = rates
        fx, fy, fz = force
        # turn the estimated vertical towards the measured one: their cross product is axis and sine of the error. It
        # is linear in the force: what a shock does, its rebound undoes, but not if the larger of both were left out
        ux, uy, uz = self.up()
        gain = 1.0 / (GRAVITY_TIME * GRAVITY)
        wx += gain * (fy * uz - fz * uy)
        wy += gain * (fz * ux - fx * uz)
        wz += gain * (fx * uy - fy * ux)
        self.quaternion = _turned(self.quaternion, (wx * dt, wy * dt, wz * dt))


def _turned(quaternion: Quaternion, turn: Vector) -> Quaternion:
    """The attitude after a turn in its own frame; of unit length."""
    w, x, y, z = quaternion
    a, b, c = turn
    angle = math.sqrt(a * a + b * b + c * c)
    factor = math.sin(angle / 2.0) / angle if angle > 1e-12 else 0.5
    d, a, b, c = math.cos(angle / 2.0), a * factor, b * factor, c * factor
    w, x, y, z = (
        w * d - x * a - y * b - z * c,
        w * a + x * d + y * c - z * b,
        w * b - x * c + y * d + z * a,
        w * c + x * b - y * a + z * d,
    )
    scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
    return w * scale, x * scale, y * scale, z * scale


def _from_angles(roll: float, pitch: float, yaw: float) -> Quaternion:
    cr, sr = math.cos(roll / 2.0), math.sin(roll / 2.0)
    cp, sp = math.cos(pitch / 2.0), math.sin(pitch / 2.0)
    cy, sy = math.cos(yaw / 2.0), math.sin(yaw / 2.0)
    return (
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    )


Row: TypeAlias = list[float]

X, Y, YAW, SCALE, GYRO_BIAS, GYRO_SCALE, DRIFT_X, DRIFT_Y = range(8)
STATES: Final = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class DeadReckonedMotion:
    """A motion by dead reckoning: metres and radians in the frame of the filter, and its duration in seconds."""

    x: float
    y: float
    yaw: float
    dt: float
    position_variance: float
    """m^2, that this motion adds along each axis."""
    yaw_variance: float
    bias_variance: float


class PoseFilter:
    """An extended Kalman filter of a pose on the ground: dead reckoning lets errors grow, fixes reduce them.

    Prediction and correction as in Thrun, Burgard and Fox, Probabilistic Robotics (2005), table 3.3.

    The state: x, y (m), yaw (rad), the errors of the encoders' scale, of the gyroscope's bias (rad/s) and of its scale,
    and the slow errors of the fixes in x and y (m). `deviations` are those of the state at the start.
    """

    def __init__(self, x: float, y: float, yaw: float, deviations: Iterable[float]) -> None:
        self.state = [x, y, yaw, 0.0, 0.0, 0.0, 0.0, 0.0]
        self.covariance = [
            [deviation**2 if row == column else 0.0 for column in range(STATES)]
            for row, deviation in enumerate(deviations)
        ]

    def move(self, motion: DeadReckonedMotion) -> None:
        """Move by a motion of dead reckoning."""
        state = self.state
        # the mean: the motion, less the estimated errors of encoders and gyroscope
        x, y = motion.x * (1.0 + state[SCALE]), motion.y * (1.0 + state[SCALE])
        state[X] += x
        state[Y] += y
        state[YAW] += motion.yaw * (1.0 + state[GYRO_SCALE]) - motion.dt * state[GYRO_BIAS]
        # the covariance: F P F' + Q, where F, the derivative by the state, differs from 1 in three rows only
        rows = self.covariance
        self._mix(rows, motion, x, y)
        for row in rows:  # of F P, multiply the columns by F', too
            yaw, scale = row[YAW], row[SCALE]
            row[X] += motion.x * scale - y * yaw
            row[Y] += motion.y * scale + x * yaw
            row[YAW] = yaw - motion.dt * row[GYRO_BIAS] + motion.yaw * row[GYRO_SCALE]
        rows[X][X] += motion.position_variance
        rows[Y][Y] += motion.position_variance
        rows[YAW][YAW] += motion.yaw_variance
        rows[GYRO_BIAS][GYRO_BIAS] += motion.bias_variance

    @staticmethod
    def _mix(rows: list[Row], motion: DeadReckonedMotion, x: float, y: float) -> None:
        """Multiply the rows by F. A turn moves the way by (-y, x), an error of the scale lengthens it."""
        yaw, scale, bias, gyro_scale = rows[YAW], rows[SCALE], rows[GYRO_BIAS], rows[GYRO_SCALE]
        rows[X] = [a - y * b + motion.x * c for a, b, c in zip(rows[X], yaw, scale, strict=True)]
        rows[Y] = [a + x * b + motion.y * c for a, b, c in zip(rows[Y], yaw, scale, strict=True)]
        rows[YAW] = [a - motion.dt * b + motion.yaw * c for a, b, c in zip(yaw, bias, gyro_scale, strict=True)]

    def decay_fix_errors(self, kept: float, deviation: float) -> None:
        """Let the slow errors of the fixes decay by the factor `kept`, towards this stationary deviation.

        They are first-order Gauss-Markov processes: x <- k x, and the variance becomes k^2 P + (1 - k^2) deviation^2.
        """
        rows = self.covariance
        for index in (DRIFT_X, DRIFT_Y):
            self.state[index] *= kept
            rows[index] = [kept * value for value in rows[index]]
            for row in rows:
                row[index] *= kept
            rows[index][index] += (1.0 - kept * kept) * deviation**2

    def observe(self, indices: tuple[int, ...], measured: float, deviation: float) -> None:
        """Correct by a measurement of the sum of some states, whose error has this standard deviation."""
        rows = self.covariance
        # H has a one for each of these states: P H' is a sum of columns, S = H P H' + r^2 a sum of its elements
        cross_covariance = [sum(row[index] for index in indices) for row in rows]
        innovation_variance = sum(cross_covariance[index] for index in indices) + deviation**2
        if innovation_variance <= 0.0:
            return
        # gain K = P H' / S, then x + K (z - H x) and P - K H P
        innovation = measured - sum(self.state[index] for index in indices)
        gains = [covariance / innovation_variance for covariance in cross_covariance]
        self.state = [value + gain * innovation for value, gain in zip(self.state, gains, strict=True)]
        self.covariance = [
            [value - gain * other for value, other in zip(row, cross_covariance, strict=True)]
            for row, gain in zip(rows, gains, strict=True)
        ]

    def normalised_innovation(self, indices: tuple[int, ...], measured: float, deviation: float) -> float:
        """Innovation of such a measurement, in standard deviations: |z - H x| / sqrt(H P H' + r^2)."""
        innovation_variance = sum(self.covariance[a][b] for a in indices for b in indices) + deviation**2
        innovation = abs(measured - sum(self.state[index] for index in indices))
        return innovation / math.sqrt(innovation_variance) if innovation_variance > 0.0 else 0.0

    def reset_variance(self, indices: Iterable[int], deviation: float) -> None:
        """Set the deviation of states, independent of previous knowledge."""
        for index in indices:
            for row in self.covariance:
                row[index] = 0.0
            self.covariance[index] = [0.0] * STATES
            self.covariance[index][index] = deviation**2

    @property
    def horizontal_rms(self) -> float:
        """Root mean square of the error of x and y together, metres."""
        return math.sqrt(max(0.0, self.covariance[X][X] + self.covariance[Y][Y]))

    @property
    def yaw_rms(self) -> float:
        """Root mean square of the error of the yaw, radians."""
        return math.sqrt(max(0.0, self.covariance[YAW][YAW]))
