"""What a robot's TOML file may say about its cameras."""

from __future__ import annotations

import math
from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from jauspy.cloud.depth import DepthSettings
from jauspy.cloud.message import MAX_POINTS
from jauspy.errors import ConfigError
from jauspy.modules.config_joints import JointName
from jauspy.platform.camera import CameraSetup
from jauspy.platform.video_settings import VideoSettings


class DepthConfig(BaseModel):
    """What a camera that also measures distances makes clouds of."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    size: tuple[Annotated[int, Field(ge=16, le=1920)], Annotated[int, Field(ge=16, le=1080)]] = (400, 250)
    """Points across and down, at most."""
    rate: Annotated[float, Field(gt=0.0, le=60.0)] = 10.0
    """Clouds per second."""
    range: tuple[Annotated[float, Field(ge=0.0)], Annotated[float, Field(gt=0.0, le=1000.0)]] = (0.2, 10.0)
    """The least and the largest distance along the camera's axis that it measures, in metres."""

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if self.range[0] >= self.range[1]:
            raise ValueError(f"range: {list(self.range)} is empty; give the least distance and then the largest")
        if self.size[0] * self.size[1] > MAX_POINTS:
            raise ValueError(f"size: {list(self.size)} are too many points for one message; it has {MAX_POINTS}")
        return self

    def settings(self) -> DepthSettings:
        """For the process that makes them."""
        return DepthSettings(*self.size, self.rate, *self.range)


class CameraConfig(BaseModel):
    """A camera that looks along the x axis of a link of the URDF; z is up."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: JointName
    link: JointName
    fov: Annotated[float, Field(ge=5.0, le=150.0)] = 80.0
    """From the left edge of the picture to the right one, in degrees."""
    size: tuple[int, int] = (640, 480)
    """Width and height of the stream's pictures at first."""
    rate: int = 15
    """Pictures per second, at first."""
    bit_rate: int = 2000
    """Kilobits per second, at first."""
    depth: DepthConfig | None = None
    """Of a camera that also measures distances."""
    stamped: bool = False
    """Whether the upper edge of each picture shows its number and the time it was taken, as black and white squares."""

    @model_validator(mode="after")
    def _can_be_encoded(self) -> Self:
        try:
            self.settings()
        except ConfigError as error:
            raise ValueError(str(error)) from None
        return self

    def setup(self) -> CameraSetup:
        """For the backend."""
        return CameraSetup(self.name, self.link, math.radians(self.fov))

    def settings(self) -> VideoSettings:
        """For the encoder; `ConfigError` for what cannot be encoded."""
        return VideoSettings(*self.size, self.rate, 1000 * self.bit_rate)
