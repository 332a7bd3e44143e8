"""What a robot's TOML file may say about its sensors."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from jauspy.modules.config_joints import JointName
from jauspy.platform.force_torque import ForceTorqueSetup
from jauspy.platform.ranging import LidarSetup


class LidarConfig(BaseModel):
    """A lidar that scans the x-y plane of a link of the URDF, all around."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: JointName
    link: JointName
    rays: Annotated[int, Field(ge=1, le=3600)] = 360
    rate: Annotated[float, Field(gt=0.0, le=100.0)] = 10.0
    """Scans per second."""
    range: tuple[Annotated[float, Field(ge=0.0)], Annotated[float, Field(gt=0.0, le=1000.0)]] = (0.1, 30.0)
    """The least and the largest distance that it measures, in metres."""
    noise: Annotated[float, Field(ge=0.0, le=1.0)] = 0.01
    """Standard deviation of a distance in a simulation, in metres."""
    seed: Annotated[int, Field(ge=0)] = 0
    """Of that noise."""

    @model_validator(mode="after")
    def _reaches(self) -> Self:
        if self.range[0] >= self.range[1]:
            raise ValueError(f"range: {list(self.range)} is empty; give the least distance and then the largest")
        return self

    def setup(self) -> LidarSetup:
        """For the backend."""
        return LidarSetup(self.name, self.link, self.rays, self.rate, *self.range, self.noise, self.seed)


class ForceTorqueConfig(BaseModel):
    """A sensor of forces and torques between a link of the URDF and the link that carries it."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: JointName
    link: JointName
    rate: Annotated[float, Field(gt=0.0, le=500.0)] = 100.0
    """Measurements per second."""
    force: Annotated[float, Field(gt=0.0, le=5000.0)] = 300.0
    """The largest force along each axis, in newtons."""
    torque: Annotated[float, Field(gt=0.0, le=5000.0)] = 30.0
    """The largest torque about each axis, in newton metres."""
    noise: tuple[Annotated[float, Field(ge=0.0, le=100.0)], Annotated[float, Field(ge=0.0, le=100.0)]] = (0.1, 0.01)
    """Standard deviations in a simulation, in newtons and newton metres."""
    seed: Annotated[int, Field(ge=0)] = 0
    """Of that noise."""

    def setup(self) -> ForceTorqueSetup:
        """For the backend."""
        return ForceTorqueSetup(self.name, self.link, self.rate, self.force, self.torque, *self.noise, self.seed)
