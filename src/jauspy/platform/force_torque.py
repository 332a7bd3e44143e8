"""The contract of force-torque sensors, which sit between two links."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Final, Protocol

from annotated_types import Interval

from jauspy.geometry.vectors import Vector
from jauspy.platform.ranging import Sampling
from jauspy.platform.tables import Deviation, Seed, Table, UrdfName

ZERO: Final[Vector] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class ForceTorqueSetup(Table):
    """A sensor of forces and torques between a link of the URDF and the link that carries it."""

    name: UrdfName
    link: UrdfName
    rate: Annotated[float, Interval(gt=0.0, le=500.0)] = 100.0
    """Measurements per second."""
    force: Annotated[float, Interval(gt=0.0, le=5000.0)] = 300.0
    """The largest force along each axis, N."""
    torque: Annotated[float, Interval(gt=0.0, le=5000.0)] = 30.0
    """The largest torque about each axis, N m."""
    noise: tuple[Deviation, Deviation] = (0.1, 0.01)
    """Standard deviations of forces and torques in a simulation, N and N m."""
    seed: Seed = 0
    """Seed of the noise: the same seed gives the same noise."""


@dataclass(frozen=True, slots=True)
class Wrench:
    """The force and torque of the link, with all that it carries and touches, on the sensor; in the link's frame.

    It includes the weight of the tool, which acts downwards; nothing is tared.
    """

    time: float
    """The robot's time, in seconds."""
    force: Vector = ZERO
    """N."""
    torque: Vector = ZERO
    """N m."""


class ForceTorqueSensor(Protocol):
    """A force-torque sensor of a robot."""

    @property
    def setup(self) -> ForceTorqueSetup:
        """Link, rate and limits."""
        ...

    @property
    def wrench(self) -> Wrench:
        """The last measurement."""
        ...


class SampledForceTorque:
    """A `ForceTorqueSensor` that samples the function `measure` in `step`."""

    def __init__(self, setup: ForceTorqueSetup, measure: Callable[[], tuple[Vector, Vector]]) -> None:
        self.setup = setup
        self._measure = measure
        self._sampling = Sampling(setup.rate)
        self.wrench = Wrench(0.0)

    def step(self, now: float) -> None:
        """The robot's time is `now`; never earlier than in the call before."""
        if self._sampling.is_due(now):
            force, torque = self._measure()
            self.wrench = Wrench(now, _limited(force, self.setup.force), _limited(torque, self.setup.torque))


def _limited(values: Vector, limit: float) -> Vector:
    x, y, z = (min(limit, max(-limit, value)) for value in values)
    return x, y, z
