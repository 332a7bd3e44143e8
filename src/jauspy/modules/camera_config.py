"""The tables of a robot's TOML file about cameras."""

from __future__ import annotations

import math
from typing import Annotated, Self, TypeAlias

from pydantic import Field, model_validator

from jauspy.cloud.depth import DepthSettings
from jauspy.cloud.stream import MAX_POINTS
from jauspy.errors import ConfigError
from jauspy.modules.config_base import StrictConfig, UrdfName
from jauspy.platform.camera import CameraSetup, OutsideSetup, Viewpoint
from jauspy.platform.imaging_settings import ImagingSetup
from jauspy.platform.video_settings import VideoSettings

Coefficient: TypeAlias = Annotated[float, Field(ge=-10.0, le=10.0)]


class DepthConfig(StrictConfig):
    """Point clouds of a depth camera."""

    size: tuple[Annotated[int, Field(ge=16, le=1920)], Annotated[int, Field(ge=16, le=1080)]] = (400, 250)
    """Points across and down, at most."""
    rate: Annotated[float, Field(gt=0.0, le=60.0)] = 10.0
    """Clouds per second."""
    range: tuple[Annotated[float, Field(ge=0.0)], Annotated[float, Field(gt=0.0, le=1000.0)]] = (0.2, 10.0)
    """Minimal and maximal distance along the camera's axis, in metres."""

    @model_validator(mode="after")
    def _check_size(self) -> Self:
        if self.range[0] >= self.range[1]:
            raise ValueError(f"range: {list(self.range)} is empty; give the minimal and then the maximal distance")
        if self.size[0] * self.size[1] > MAX_POINTS:
            raise ValueError(f"size: {list(self.size)} are too many points for one message; it has {MAX_POINTS}")
        return self

    def settings(self) -> DepthSettings:
        """Return the settings for the process that makes the clouds."""
        return DepthSettings(*self.size, self.rate, *self.range)


class ImagingConfig(StrictConfig):
    """Capabilities and imperfections of a camera's lens and sensor."""

    optical_zoom: Annotated[float, Field(ge=1.0, le=50.0)] = 1.0
    """Largest factor of the lens; 1 for a fixed focal length."""
    digital_zoom: Annotated[float, Field(ge=1.0, le=16.0)] = 4.0
    """Largest factor of the digital zoom; 1 for none."""
    exposure_time: tuple[Annotated[float, Field(ge=0.0001)], Annotated[float, Field(le=60.0)]] = (0.001, 0.066)
    """Shortest and longest, in seconds."""
    aperture: tuple[Annotated[float, Field(ge=0.7)], Annotated[float, Field(le=128.0)]] = (2.8, 2.8)
    """Smallest and largest f-number."""
    max_iso: Annotated[int, Field(ge=100, le=3200)] = 3200
    sensor_width: Annotated[float, Field(ge=1.0, le=50.0)] = 6.4
    """In millimetres; it determines the focal length, and with it the depth of field."""
    nearest_focus: Annotated[float, Field(ge=0.01, le=10.0)] = 0.1
    """In metres."""
    distortion: tuple[Coefficient, Coefficient, Coefficient, Coefficient, Coefficient] = (0.0, 0.0, 0.0, 0.0, 0.0)
    """k1, k2, p1, p2, k3 of OpenCV's model."""
    shot_noise: Annotated[float, Field(ge=0.0, le=0.5)] = 0.0035
    """Standard deviation of the light of a white pixel at ISO 100, as a fraction."""
    read_noise: Annotated[float, Field(ge=0.0, le=0.5)] = 0.0002
    """Standard deviation at ISO 100 in black, as a fraction of white."""
    seed: Annotated[int, Field(ge=0)] = 0
    """Seed of the noise."""

    @model_validator(mode="after")
    def _check_order(self) -> Self:
        for key in ("exposure_time", "aperture"):
            low, high = getattr(self, key)
            if low > high:
                raise ValueError(f"{key}: [{low}, {high}] is empty; give the least and then the largest")
        return self

    def setup(self) -> ImagingSetup:
        """Return the setup for the camera's process."""
        given = self.model_dump()
        return ImagingSetup(**(given | {"sensor_width": self.sensor_width / 1000.0}))


Length: TypeAlias = Annotated[float, Field(ge=-1000.0, le=1000.0)]


class OutsideConfig(StrictConfig):
    """The pose of a camera outside of the robot."""

    view: Viewpoint
    """"fixed" at a place of the world, "chase" behind the robot, or "orbit" around it."""
    position: tuple[Length, Length, Length] = (-3.0, -3.0, 2.0)
    """Of a fixed camera, in the world, in metres."""
    target: tuple[Length, Length, Length] | None = None
    """The point at which a fixed camera looks; the robot when left out."""
    distance: Annotated[float, Field(ge=0.5, le=100.0)] = 2.6
    """From the robot, over the ground, in metres."""
    height: Annotated[float, Field(ge=0.0, le=100.0)] = 1.5
    """Above the robot's base."""
    aim: Annotated[float, Field(ge=-10.0, le=10.0)] = 0.35
    """Height above the base of the point at which it looks."""
    angle: Annotated[float, Field(ge=-360.0, le=360.0)] = 0.0
    """Degrees from straight behind the robot, counterclockwise."""
    period: Annotated[float, Field(ge=1.0, le=3600.0)] = 24.0
    """Seconds of a turn of an orbit."""

    def setup(self) -> OutsideSetup:
        """Return the setup for the backend."""
        given = {name: getattr(self, name) for name in type(self).model_fields}
        return OutsideSetup(**(given | {"angle": math.radians(self.angle)}))


class CameraConfig(StrictConfig):
    """A camera that looks along the x axis of a link of the URDF (z is up), or at the robot from outside."""

    name: UrdfName
    link: UrdfName | None = None
    outside: OutsideConfig | None = None
    """In place of a link."""
    fov: Annotated[float, Field(ge=5.0, le=150.0)] = 80.0
    """Horizontal field of view, in degrees."""
    size: tuple[int, int] = (640, 480)
    """Width and height of the stream's pictures at first."""
    rate: int = 15
    """Pictures per second, at first."""
    bit_rate: int = 2000
    """Kilobits per second, at first."""
    depth: DepthConfig | None = None
    """Settings of a depth camera; None for other cameras."""
    imaging: ImagingConfig = ImagingConfig()
    """Lens and sensor."""
    stamped: bool = False
    """Whether the upper edge of each picture shows its number and the time it was taken, as black and white squares."""

    @model_validator(mode="before")
    @classmethod
    def _expand(cls, given: object) -> object:
        """Accept `outside = "chase"` as a short form of a table with only that view."""
        if isinstance(given, dict) and isinstance(view := given.get("outside"), str):
            return given | {"outside": {"view": view}}
        return given

    @model_validator(mode="after")
    def _check_place(self) -> Self:
        if (self.link is None) == (self.outside is None):
            raise ValueError("link: a camera needs the link that carries it, or else `outside`, and not both")
        if self.outside is not None and self.depth is not None:
            raise ValueError("depth: a camera outside of the robot measures no depths; leave it out")
        return self

    @model_validator(mode="after")
    def _check_encoding(self) -> Self:
        try:
            self.settings()
        except ConfigError as error:
            raise ValueError(str(error)) from None
        return self

    def setup(self) -> CameraSetup:
        """Return the setup for the backend."""
        return CameraSetup(
            self.name,
            self.link or "",
            math.radians(self.fov),
            self.imaging.setup(),
            self.outside.setup() if self.outside else None,
        )

    def settings(self) -> VideoSettings:
        """Return the settings for the encoder; raises `ConfigError` for what cannot be encoded."""
        return VideoSettings(*self.size, self.rate, 1000 * self.bit_rate)
