"""Encoders, with the errors that `EncoderSetup` states, and the noise of sensors."""

from __future__ import annotations

import zlib
from collections.abc import Callable
from itertools import chain
from typing import Final

import numpy as np

from jauspy.geometry.vectors import Vector
from jauspy.platform.joints import EncoderSetup
from jauspy_sim.assembly import TIMESTEP

BLOCK: Final = 512
"""Random numbers that are drawn at once."""


class Noise:
    """Normally distributed numbers of a named source: the same seed and name give the same numbers."""

    def __init__(self, seed: int, name: str, deviation: float = 1.0) -> None:
        self._random = np.random.default_rng((seed, zlib.crc32(name.encode())))
        self._deviation = deviation
        self.draw: Callable[[], float] = chain.from_iterable(iter(self._block, None)).__next__
        """Returns the next number; half as long a call as that of a method."""

    def _block(self) -> list[float]:
        numbers: list[float] = self._random.normal(0.0, self._deviation, BLOCK).tolist()
        return numbers

    def uniform(self, largest: float) -> Vector:
        """Three numbers between minus and plus the largest."""
        x, y, z = self._random.uniform(-largest, largest, 3).tolist()
        return x, y, z


class Encoder:
    """An encoder: a position in counts, whose rate is the difference of counts."""

    def __init__(self, setup: EncoderSetup, noise: Noise, dt: float = TIMESTEP) -> None:
        self._step, self._deviation, self._draw, self._dt = setup.encoder_step, setup.encoder_noise, noise.draw, dt
        self._part = dt / (dt + setup.velocity_time)
        self.position = self.rate = 0.0
        """Radians and rad/s, or metres and m/s, as measured."""

    def start(self, true: float) -> None:
        """Read at first; the rate begins at zero."""
        self.sample(true)
        self.rate = 0.0

    def sample(self, true: float, acceleration: float = 0.0) -> tuple[float, float]:
        """Read the true position, `dt` seconds after the last time; returns position and rate as measured.

        With the acceleration that was commanded meanwhile, the rate does not lag behind by the time of its average.
        """
        if self._deviation:
            true += self._deviation * self._draw()
        if step := self._step:
            true = step * round(true / step)
        expected = self.rate + acceleration * self._dt
        # the difference is the rate at the end of the step: MuJoCo moves positions by the velocity at its end
        self.rate = rate = expected + self._part * ((true - self.position) / self._dt - expected)
        self.position = true
        return true, rate
