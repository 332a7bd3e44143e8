"""The contract of localisation: estimated poses with their errors; and the settings of the simulated sensors.

Two frames, as in REP-105. The **local** one is dead reckoning from where the robot started: it drifts, and never jumps.
The **global** one has GNSS: it jumps, and does not drift. For a robot without this part, the pose is exact.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass, replace
from typing import Annotated, Final, Literal, TypeAlias, final

from annotated_types import Interval

from jauspy.geometry.poses import ORIGIN, UNACCELERATED, Acceleration, Pose, Twist
from jauspy.platform.contract import Command, DriveBase, OptionalPart, PartId, Robot, RobotLink
from jauspy.platform.tables import Converted, Deviation, Fraction, Prepared, Seed, Table

MICRO_G: Final = 9.80665e-6
"""m/s^2, the unit of the data sheets of accelerometers."""


@dataclass(frozen=True, slots=True)
class OdometrySetup(Table):
    """Encoders of tracks or wheels in a simulation, which do not measure slip."""

    scale_error: Fraction = 0.01
    """Standard deviation of the calibration: measured over true distance, less 1."""
    noise: Deviation = 0.005
    """Standard deviation of the distance after one metre, in metres; it grows with the square root of the distance."""
    resolution: Annotated[float, Interval(gt=0.0, le=0.1)] = 1e-5
    """Metres of one count: 4096 counts for a turn of a motor, with a gear of 25:1 and a sprocket of 0.4 m, are 4 um."""


def _of_micro_g(value: float) -> float:
    return value * MICRO_G


_Degrees: TypeAlias = Annotated[float, Interval(ge=0.0, le=100.0), Converted(math.radians)]
_MicroG: TypeAlias = Annotated[float, Interval(ge=0.0, le=1e5), Converted(_of_micro_g)]


@dataclass(frozen=True, slots=True)
class ImuSetup(Table):
    """An inertial measurement unit at the origin of the base, in a simulation.

    The file has the units of data sheets: degrees and micro-g in place of radians and m/s^2. The defaults are those of
    a MEMS unit of the class of Bosch's BMI088, from its data sheet, after the calibration that every maker of robots
    does; one of the class of ADIS16465 has a tenth of the bias.
    """

    rate: Annotated[float, Interval(ge=20.0, le=250.0)] = 50.0
    """Measurements per second, each the mean since the one before, as units that integrate give them."""
    gyro_noise: _Degrees = math.radians(0.014)
    """Noise density of the rates, rad/s/sqrt(Hz)."""
    gyro_bias: _Degrees = math.radians(0.5)
    """Standard deviation of the rates' bias after switching on, rad/s; `alignment` seconds at rest measure it."""
    gyro_bias_walk: _Degrees = math.radians(0.0003)
    """Random walk of that bias, rad/s/sqrt(s): after ten minutes the stability in the data sheet over temperature."""
    gyro_scale_error: Fraction = 0.002
    """Standard deviation of the calibration, as a fraction of the rates."""
    acceleration_noise: _MicroG = 175.0 * MICRO_G
    """Noise density of the accelerations, m/s^2/sqrt(Hz)."""
    acceleration_bias: _MicroG = 3000.0 * MICRO_G
    """Standard deviation of the accelerations' bias, m/s^2: it tilts the attitude. 20 mg uncalibrated."""
    alignment: Annotated[float, Interval(gt=0.0, le=3600.0)] = 10.0
    """Seconds at rest in which the robot has measured the rates' bias before it is ready."""


@dataclass(frozen=True, slots=True)
class GnssSetup(Table):
    """A receiver of satellite navigation at the origin of the base, in a simulation.

    The defaults are those of a receiver without corrections, of the class of u-blox M9 and F9: half of its fixes are
    within 1.5 m (CEP), and most of that error stays for minutes. With `receiver = "rtk"` those of `RTK`.
    """

    rate: Annotated[float, Interval(gt=0.0, le=250.0)] = 5.0
    """Fixes per second."""
    noise: Deviation = 0.3
    """Standard deviation from fix to fix, along each horizontal axis, in metres."""
    drift: Deviation = 1.2
    """Standard deviation along each horizontal axis of the error that changes slowly (orbits, clocks, ionosphere,
    multipath), in metres."""
    drift_time: Annotated[float, Interval(gt=0.0, le=1e5)] = 120.0
    """Correlation time of that error, in seconds."""
    vertical: Annotated[float, Interval(ge=0.0, le=10.0)] = 1.5
    """Errors of the height, as a multiple of the horizontal ones."""
    heading_error: Annotated[float, Interval(ge=0.0, le=180.0), Converted(math.radians)] = math.radians(2.0)
    """Standard deviation of the heading at the start, in radians (degrees in the file): that of a compass."""
    receiver: Literal["standalone", "rtk"] = "standalone"
    """Kind of receiver, which determines the defaults."""


RTK: Final = GnssSetup(noise=0.006, drift=0.006, drift_time=60.0, receiver="rtk")
"""A receiver with corrections by radio (RTK), of the class of u-blox ZED-F9P: half of its fixes are within 1 cm."""


def _with_defaults(given: object) -> object:
    """The table with the defaults of an RTK receiver, if it names one."""
    if isinstance(given, dict) and given.get("receiver") == "rtk":
        return {"noise": RTK.noise, "drift": RTK.drift, "drift_time": RTK.drift_time} | given
    return given


def _null_if_none(given: object) -> object:
    return None if given == "none" else given


@dataclass(frozen=True, slots=True)
class LocalizationSetup(Table):
    """Measurement of a robot's pose, by sensors with errors or exactly: the table `[localization]`."""

    source: Literal["sensors", "exact"] | None = None
    """None: `sensors` on the backend `sim`, `exact` on `kinematic`; on a bus of servo drives their encoders."""
    seed: Seed = 0
    """Seed of all errors: the same seed gives the same errors."""
    odometry: OdometrySetup = OdometrySetup()
    imu: Annotated[ImuSetup | None, Prepared(_null_if_none)] = ImuSetup()
    """None ("none" in the file): the heading is by odometry, and the ground is taken as level."""
    gnss: Annotated[GnssSetup, Prepared(_with_defaults)] | Literal["none"] | None = None
    """None: that of `GnssSetup` for a robot with an `[origin]`. "none": the global pose is the local one, from a start
    that is known."""

    def is_exact(self, default: bool) -> bool:
        """True if the pose is exact; `default` is what the backend does unless the file says otherwise."""
        return default if self.source is None else self.source == "exact"

    def with_receiver(self, *, has_origin: bool) -> LocalizationSetup:
        """The setup with its receiver determined: an instance of `GnssSetup`, or "none"."""
        return replace(self, gnss=(self.gnss or GnssSetup()) if has_origin else "none")


EXACT: Final = LocalizationSetup(source="exact")


@final
@dataclass(frozen=True, slots=True)
class PoseEstimate:
    """A pose (REP-103) and the root mean squares of its errors: metres and radians."""

    pose: Pose
    horizontal_rms: float
    vertical_rms: float
    attitude_rms: float

    @property
    def position_rms(self) -> float:
        """Error of the position in three dimensions, metres."""
        return math.hypot(self.horizontal_rms, self.vertical_rms)


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class LocalizationState:
    """The estimate of a robot's motion. Both poses are in the estimated frame of the world."""

    local: PoseEstimate
    """Pose by dead reckoning; its errors are counted since the start, or since the pose was declared."""
    globe: PoseEstimate
    """Pose by GNSS and dead reckoning."""
    twist: Twist
    """Velocity in the frame of the base."""
    velocity_rms: float
    rate_rms: float
    acceleration: Acceleration
    """Acceleration in the frame of the base, without gravity."""
    acceleration_rms: float
    angular_acceleration_rms: float
    turn_slip: float = 0.0
    """rad/s by which tracks or wheels turn to the left faster than the robot does."""


AT_ORIGIN: Final = PoseEstimate(ORIGIN, 0.0, 0.0, 0.0)
UNMOVED: Final = LocalizationState(
    local=AT_ORIGIN,
    globe=AT_ORIGIN,
    twist=Twist(),
    velocity_rms=0.0,
    rate_rms=0.0,
    acceleration=UNACCELERATED,
    acceleration_rms=0.0,
    angular_acceleration_rms=0.0,
)


class Localization(OptionalPart):
    """Estimates the pose of the base from sensors."""

    @property
    def id(self) -> PartId:
        """The part id; a robot has at most one localisation."""
        return PartId(Localization)

    @abstractmethod
    def state(self) -> LocalizationState:
        """The present estimate."""

    @abstractmethod
    def declare(self, position_rms: float | None, heading_rms: float | None) -> None:
        """Restart the error estimate when a client has set the local pose, with these errors (None: not given)."""

    def proxy(self, link: RobotLink) -> Localization:
        """The localisation for other threads."""
        return _LocalizationProxy(link)


@dataclass(frozen=True, slots=True)
class DeclareLocalPose(Command):
    """Restart the error estimate of the local pose."""

    position_rms: float | None
    heading_rms: float | None

    @property
    def part(self) -> PartId:
        """The localisation."""
        return PartId(Localization)

    def apply(self, robot: Robot) -> None:
        """Declare it."""
        if (found := Localization.of(robot)) is not None:
            found.declare(self.position_rms, self.heading_rms)

    def merged(self, pending: Command) -> DeclareLocalPose:
        """Merge with a pending declaration, whose other values are kept."""
        if not isinstance(pending, DeclareLocalPose):
            return self
        position, heading = self.position_rms, self.heading_rms
        return DeclareLocalPose(
            pending.position_rms if position is None else position, pending.heading_rms if heading is None else heading
        )


class _LocalizationProxy(Localization):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> LocalizationState:
        found = self._link.snapshot.parts.get(self.id)
        return found if isinstance(found, LocalizationState) else UNMOVED

    def declare(self, position_rms: float | None, heading_rms: float | None) -> None:
        self._link.submit(DeclareLocalPose(position_rms, heading_rms))


class LocalizedDrive:
    """A chassis whose pose and motion are those that its localisation estimates."""

    def __init__(self, drive: DriveBase, localization: Localization) -> None:
        self.set_effort = drive.set_effort
        self.stop = drive.stop
        self._state = localization.state

    def pose(self) -> Pose:
        """The local pose."""
        return self._state().local.pose

    def twist(self) -> Twist:
        """Velocity by odometry and gyroscope."""
        return self._state().twist

    def acceleration(self) -> Acceleration:
        """Acceleration by the accelerometer, without gravity."""
        return self._state().acceleration
