"""What a robot's TOML file may say about its joints: tracks, groups, controllers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Self, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, model_validator

from jauspy.platform.description import GroupSetup, JointGains, TrackSetup
from jauspy.platform.pid import Gains

Gain: TypeAlias = Annotated[float, Field(ge=0.0, allow_inf_nan=False)]
JointName: TypeAlias = Annotated[str, Field(min_length=1, max_length=80)]


class StrictConfig(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class TracksConfig(StrictConfig):
    """The chassis: the belts of each side, prismatic joints of the URDF; those of flippers run with the tracks."""

    left: Annotated[tuple[JointName, ...], Field(min_length=1, max_length=4)]
    right: Annotated[tuple[JointName, ...], Field(min_length=1, max_length=4)]
    inertia: Annotated[float, Field(gt=0.0, le=1000.0)] = 40.0
    """What rotors and sprockets weigh at the belt, in kilograms."""

    def setup(self) -> TrackSetup:
        """For the backend."""
        return TrackSetup(self.left, self.right, self.inertia)


class GainsConfig(StrictConfig):
    """A PID controller: effort per error, per integrated error, per change of error."""

    p: Gain
    i: Gain = 0.0
    d: Gain = 0.0
    i_limit: Gain | None = None
    """The most effort that integration may add."""

    def gains(self) -> Gains:
        """For the controller."""
        return Gains(self.p, self.i, self.d, **({} if self.i_limit is None else {"i_limit": self.i_limit}))


class JointConfig(StrictConfig):
    """One joint of a group, and its controllers."""

    name: JointName
    start: float = 0.0
    """Where it is at first, in radians or metres."""
    position: GainsConfig
    velocity: GainsConfig


class GroupConfig(StrictConfig):
    """Joints that are commanded together: an arm, a gripper, flippers."""

    base: JointName
    """The link it stands on."""
    tip: JointName
    """The link at its end."""
    rate: Annotated[float, Field(ge=10.0, le=500.0)] = 250.0
    """How often its controllers act, in hertz."""
    joints: Annotated[tuple[JointConfig, ...], Field(min_length=1, max_length=32)]
    """Base to tip."""

    @model_validator(mode="after")
    def _each_once(self) -> Self:
        names = [joint.name for joint in self.joints]
        if len(set(names)) < len(names):
            raise ValueError(f"joints: {', '.join(sorted({n for n in names if names.count(n) > 1}))} is there twice")
        return self

    def setup(self) -> GroupSetup:
        """For the backend."""
        gains = {joint.name: JointGains(joint.position.gains(), joint.velocity.gains()) for joint in self.joints}
        names, start = zip(*((joint.name, joint.start) for joint in self.joints), strict=True)
        return GroupSetup(names, gains, self.base, self.tip, self.rate, start)


Groups: TypeAlias = Mapping[JointName, GroupConfig]
