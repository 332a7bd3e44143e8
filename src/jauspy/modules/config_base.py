"""Base classes of the tables of a robot's TOML file."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from pydantic import BaseModel, ConfigDict, Field

from jauspy.platform.description import Gains

UrdfName: TypeAlias = Annotated[str, Field(min_length=1, max_length=80)]

Name: TypeAlias = Annotated[str, Field(min_length=1, max_length=64)]

Gain: TypeAlias = Annotated[float, Field(ge=0.0, allow_inf_nan=False)]


class StrictConfig(BaseModel):
    """A table of the file; unknown keys are errors."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class GainsConfig(StrictConfig):
    """A PID controller: effort per error, per integrated error, per change of error."""

    p: Gain
    i: Gain = 0.0
    d: Gain = 0.0
    i_limit: Gain | None = None
    """Limit of the integral part of the effort."""

    def gains(self) -> Gains:
        """Return the gains for the controller."""
        return Gains(self.p, self.i, self.d, **({} if self.i_limit is None else {"i_limit": self.i_limit}))
