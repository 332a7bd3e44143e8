"""Tables of a robot's TOML file about the vehicle: `[wheels]`, `[[lights]]`, `[localization]`."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal, Self, TypeAlias

from pydantic import Field, model_validator

from jauspy.geometry.urdf import RobotDescription
from jauspy.modules.config_base import StrictConfig, UrdfName
from jauspy.platform.lights import LampSetup, Switch
from jauspy.platform.localization import (
    MICRO_G,
    RTK,
    GnssSetup,
    ImuSetup,
    LocalizationSetup,
    OdometrySetup,
)
from jauspy.platform.wheels import WheelJoints, WheelKind, WheelSetup, wheel_setup

Joints: TypeAlias = tuple[Annotated[str, Field(min_length=1, max_length=80)], ...]


class WheelsConfig(StrictConfig):
    """A chassis on wheels: the continuous joints of its driven wheels; those that are not named roll freely."""

    type: Literal["skid_steer", "ackermann", "mecanum"]
    left: Annotated[Joints, Field(min_length=1, max_length=8)]
    right: Annotated[Joints, Field(min_length=1, max_length=8)]
    steered: Annotated[Joints, Field(max_length=8)] = ()
    """Of an ackermann chassis: the revolute joints that turn the wheels of one axle."""
    radius: Annotated[float, Field(gt=0.0, le=5.0)] | None = None
    """Metres; by default that of the collision shape of each wheel."""
    inertia: Annotated[float, Field(gt=0.0, le=1000.0)] = 0.02
    """Of rotor and gear of each driven wheel at the wheel, in kg m^2."""

    @model_validator(mode="after")
    def _check_names(self) -> Self:
        names = (*self.left, *self.right, *self.steered)
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise ValueError(f"wheels: {', '.join(twice)} is there twice")
        return self

    def setup(self, description: RobotDescription) -> WheelSetup:
        """Measure the wheels; raises `ConfigError` with the key that does not match the URDF."""
        kind = WheelKind(self.type)
        joints = WheelJoints(kind, self.left, self.right, self.steered, self.radius, self.inertia)
        return wheel_setup(description, joints)


Coordinate: TypeAlias = Annotated[float, Field(ge=-10.0, le=10.0)]


class LightConfig(StrictConfig):
    """A lamp that shines along the x axis of a link, in a round cone."""

    name: UrdfName
    link: UrdfName
    switch: Switch
    """The light of JAUS's IlluminationService that switches it."""
    cone: Annotated[float, Field(ge=5.0, le=150.0)] = 60.0
    """Full opening angle of the cone, in degrees."""
    brightness: Annotated[float, Field(gt=0.0, le=1e6)] = 2000.0
    """In lumens."""
    position: tuple[Coordinate, Coordinate, Coordinate] = (0.0, 0.0, 0.0)
    """In the frame of the link, in metres."""
    tilt: Annotated[float, Field(ge=-90.0, le=90.0)] = 0.0
    """Degrees below the x axis."""
    on: bool = False
    """Whether it is on at the start."""

    def setup(self) -> LampSetup:
        """Return the setup for the backend."""
        return LampSetup(
            self.name,
            self.link,
            self.switch,
            math.radians(self.cone),
            self.brightness,
            self.position,
            math.radians(self.tilt),
            self.on,
        )


Fraction: TypeAlias = Annotated[float, Field(ge=0.0, le=0.5)]
Rate: TypeAlias = Annotated[float, Field(gt=0.0, le=250.0)]
Deviation: TypeAlias = Annotated[float, Field(ge=0.0, le=100.0)]

_ODOMETRY, _IMU, _GNSS = OdometrySetup(), ImuSetup(), GnssSetup()


class OdometryConfig(StrictConfig):
    """Encoders of tracks or wheels, in a simulation."""

    scale_error: Fraction = _ODOMETRY.scale_error
    """Standard deviation of the calibration, as a fraction of the distance."""
    noise: Deviation = _ODOMETRY.noise
    """Standard deviation of the distance after one metre, in metres; it grows with the square root of the distance."""
    resolution: Annotated[float, Field(gt=0.0, le=0.1)] = _ODOMETRY.resolution
    """Metres of one count."""

    def setup(self) -> OdometrySetup:
        """Return the setup for the backend."""
        return OdometrySetup(self.scale_error, self.noise, self.resolution)


class ImuConfig(StrictConfig):
    """An inertial measurement unit in a simulation, in the units of data sheets; the defaults are a BMI088's."""

    rate: Annotated[float, Field(ge=20.0, le=250.0)] = _IMU.rate
    """Measurements per second, of a unit that integrates."""
    gyro_noise: Deviation = math.degrees(_IMU.gyro_noise)
    """Noise density of the rates, in degrees/s/sqrt(Hz)."""
    gyro_bias: Deviation = math.degrees(_IMU.gyro_bias)
    """Standard deviation of the rates' bias after switching on, in degrees/s; the robot measures it at rest."""
    gyro_bias_walk: Deviation = math.degrees(_IMU.gyro_bias_walk)
    """Random walk of that bias, in degrees/s/sqrt(s)."""
    gyro_scale_error: Fraction = _IMU.gyro_scale_error
    """Standard deviation of the calibration, as a fraction of the rates."""
    acceleration_noise: Annotated[float, Field(ge=0.0, le=1e5)] = round(_IMU.acceleration_noise / MICRO_G, 6)
    """Noise density of the accelerations, in micro-g/sqrt(Hz)."""
    acceleration_bias: Annotated[float, Field(ge=0.0, le=1e5)] = round(_IMU.acceleration_bias / MICRO_G, 6)
    """Standard deviation of the accelerations' bias, in micro-g."""
    alignment: Annotated[float, Field(gt=0.0, le=3600.0)] = _IMU.alignment
    """Seconds at rest in which the robot has measured the rates' bias before it is ready."""

    def setup(self) -> ImuSetup:
        """Return the setup for the backend."""
        return ImuSetup(
            self.rate,
            math.radians(self.gyro_noise),
            math.radians(self.gyro_bias),
            math.radians(self.gyro_bias_walk),
            self.gyro_scale_error,
            self.acceleration_noise * MICRO_G,
            self.acceleration_bias * MICRO_G,
            self.alignment,
        )


class GnssConfig(StrictConfig):
    """A receiver of satellite navigation in a simulation.

    Values that are left out have defaults by the kind of receiver.
    """

    receiver: Literal["standalone", "rtk"] = "standalone"
    """`standalone`: half of the fixes within 1.5 m, as of u-blox M9 and F9. `rtk`: within 1 cm, as of ZED-F9P."""
    rate: Rate | None = None
    """Fixes per second."""
    noise: Deviation | None = None
    """Standard deviation from fix to fix, along each horizontal axis, in metres."""
    drift: Deviation | None = None
    """Standard deviation of the slow error, along each horizontal axis, in metres."""
    drift_time: Annotated[float, Field(gt=0.0, le=1e5)] | None = None
    """Correlation time of the slow error, in seconds."""
    vertical: Annotated[float, Field(ge=0.0, le=10.0)] | None = None
    """Errors of the height, as a multiple of the horizontal ones."""
    heading_error: Annotated[float, Field(ge=0.0, le=180.0)] | None = None
    """Standard deviation of the heading at the start, in degrees."""

    def setup(self) -> GnssSetup:
        """Return the setup for the backend."""
        kind = RTK if self.receiver == "rtk" else _GNSS
        given: dict[str, Any] = {
            "rate": self.rate,
            "noise": self.noise,
            "drift": self.drift,
            "drift_time": self.drift_time,
            "vertical": self.vertical,
            "heading_error": None if self.heading_error is None else math.radians(self.heading_error),
        }
        return GnssSetup(**{name: getattr(kind, name) if value is None else value for name, value in given.items()})


class LocalizationConfig(StrictConfig):
    """How the robot measures its pose: by sensors with errors, or exactly."""

    source: Literal["sensors", "exact"] | None = None
    """By default `sensors` on the backend `sim`, `exact` on `kinematic`; on a bus of servo drives their encoders."""
    seed: Annotated[int, Field(ge=0)] = 0
    """Seed of all errors."""
    odometry: OdometryConfig = OdometryConfig()
    imu: ImuConfig | Literal["none"] = ImuConfig()
    """`none`: the heading is by odometry."""
    gnss: GnssConfig | Literal["none"] | None = None
    """By default `standalone` with an `[origin]`, and none without."""

    def setup(self, *, has_origin: bool) -> LocalizationSetup:
        """Return the setup for the backend."""
        gnss = GnssConfig() if self.gnss is None else self.gnss
        return LocalizationSetup(
            None if self.source is None else self.source == "exact",
            self.seed,
            self.odometry.setup(),
            None if self.imu == "none" else self.imu.setup(),
            None if gnss == "none" or not has_origin else gnss.setup(),
        )
