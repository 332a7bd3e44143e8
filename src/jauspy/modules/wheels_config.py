"""The table `[wheels]` of a robot's TOML file."""

from __future__ import annotations

from typing import Annotated, Literal, Self, TypeAlias

from pydantic import Field, model_validator

from jauspy.geometry.urdf import RobotDescription
from jauspy.modules.config_base import StrictConfig
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
