"""The contract of localisation: estimated poses with their errors; and the settings of the simulated sensors.

Two frames, as in REP-105. The **local** one is dead reckoning from where the robot started: it drifts, and never jumps.
The **global** one has GNSS: it jumps, and does not drift. For a robot without this part, the pose is exact.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass
from typing import Final, final

from jauspy.geometry.poses import ORIGIN, UNACCELERATED, Acceleration, Pose, Twist
from jauspy.platform.contract import Command, DriveBase, OptionalPart, PartId, Robot, RobotLink

MICRO_G: Final = 9.80665e-6
"""m/s^2, the unit of the data sheets of accelerometers."""


@dataclass(frozen=True, slots=True)
class OdometrySetup:
    """Encoders of tracks or wheels, which do not measure slip."""

    scale_error: float = 0.01
    """Standard deviation of the calibration: measured over true distance, less 1."""
    noise: float = 0.005
    """Standard deviation of the distance after one metre, in metres; it grows with the square root of the distance."""
    resolution: float = 1e-5
    """Metres of one count: 4096 counts for a turn of a motor, with a gear of 25:1 and a sprocket of 0.4 m, are 4 um."""


@dataclass(frozen=True, slots=True)
class ImuSetup:
    """An inertial measurement unit at the origin of the base.

    The defaults are those of a MEMS unit of the class of Bosch's BMI088, from its data sheet, after the calibration
    that every maker of robots does; one of the class of ADIS16465 has a tenth of the bias.
    """

    rate: float = 50.0
    """Measurements per second, each the mean since the one before, as units that integrate give them."""
    gyro_noise: float = math.radians(0.014)
    """rad/s/sqrt(Hz)."""
    gyro_bias: float = math.radians(0.5)
    """rad/s, standard deviation after switching on; `alignment` seconds at rest measure it."""
    gyro_bias_walk: float = math.radians(0.0003)
    """rad/s/sqrt(s): after ten minutes as much as the stability in the data sheet with changes of temperature."""
    gyro_scale_error: float = 0.002
    """Standard deviation of the calibration."""
    acceleration_noise: float = 175.0 * MICRO_G
    """m/s^2/sqrt(Hz)."""
    acceleration_bias: float = 3000.0 * MICRO_G
    """m/s^2, standard deviation: it tilts the attitude. 20 mg in the data sheet, before calibration."""
    alignment: float = 10.0
    """Seconds that the robot has stood at rest before its time begins."""


@dataclass(frozen=True, slots=True)
class GnssSetup:
    """A receiver of satellite navigation at the origin of the base; standard deviations along each horizontal axis.

    The defaults are those of a receiver without corrections, of the class of u-blox M9 and F9: half of its fixes are
    within 1.5 m (CEP), and most of that error stays for minutes.
    """

    rate: float = 5.0
    """Fixes per second."""
    noise: float = 0.3
    """Metres, independent from fix to fix."""
    drift: float = 1.2
    """Metres of the error that changes slowly: satellites' orbits and clocks, ionosphere, multipath."""
    drift_time: float = 120.0
    """Correlation time of that error, in seconds."""
    vertical: float = 1.5
    """Errors of the height, as a multiple of the horizontal ones."""
    heading_error: float = math.radians(2.0)
    """Standard deviation of the heading at the start, in radians: that of a compass."""


RTK: Final = GnssSetup(noise=0.006, drift=0.006, drift_time=60.0)
"""A receiver with corrections by radio (RTK), of the class of u-blox ZED-F9P: half of its fixes are within 1 cm."""


@dataclass(frozen=True, slots=True)
class LocalizationSetup:
    """How a robot measures its pose."""

    exact: bool | None = None
    """True: the pose is exact; None: the default of the backend."""
    seed: int = 0
    """Of all errors: the same seed, the same errors."""
    odometry: OdometrySetup = OdometrySetup()
    imu: ImuSetup | None = ImuSetup()
    """None: the heading is by odometry, and the ground is taken as level."""
    gnss: GnssSetup | None = None
    """None: the global pose is the local one, from a start that is known."""

    def is_exact(self, default: bool) -> bool:
        """Whether the pose is exact, on a backend that does so by default, or not."""
        return default if self.exact is None else self.exact


EXACT: Final = LocalizationSetup(exact=True)


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
        """In three dimensions."""
        return math.hypot(self.horizontal_rms, self.vertical_rms)


@final
@dataclass(frozen=True, slots=True)
class LocalizationState:
    """The estimate of a robot's motion. Both poses are in the estimated frame of the world."""

    local: PoseEstimate
    """By dead reckoning; its errors are counted since the start, or since the pose was declared."""
    globe: PoseEstimate
    """By GNSS and dead reckoning."""
    twist: Twist
    """In the frame of the base."""
    velocity_rms: float
    rate_rms: float
    acceleration: Acceleration
    """In the frame of the base, without gravity."""
    acceleration_rms: float
    angular_acceleration_rms: float


AT_ORIGIN: Final = PoseEstimate(ORIGIN, 0.0, 0.0, 0.0)
UNMOVED: Final = LocalizationState(AT_ORIGIN, AT_ORIGIN, Twist(), 0.0, 0.0, UNACCELERATED, 0.0, 0.0)


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
        """By odometry and gyroscope."""
        return self._state().twist

    def acceleration(self) -> Acceleration:
        """By the accelerometer, without gravity."""
        return self._state().acceleration
