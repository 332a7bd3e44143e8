"""Encoders and IMU of a simulated servo module, with the errors that `ServoSensors` states."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.vectors import Vector
from jauspy.platform.modular.parts import ServoSensors
from jauspy_sim.assembly import TIMESTEP

BLOCK: Final = 512
"""Random numbers that are drawn at once."""


class Noise:
    """Normally distributed numbers of a named source: the same seed and name give the same numbers."""

    def __init__(self, seed: int, name: str) -> None:
        self._random = np.random.default_rng((seed, zlib.crc32(name.encode())))
        self._left: list[float] = []

    def __call__(self) -> float:
        """The next number, of standard deviation 1."""
        if not self._left:
            self._left = self._random.standard_normal(BLOCK).tolist()
        return self._left.pop()

    def uniform(self, largest: float) -> Vector:
        """Three numbers between minus and plus the largest."""
        x, y, z = self._random.uniform(-largest, largest, 3).tolist()
        return x, y, z


class Encoder:
    """An encoder: a position in counts, whose rate is the difference of counts."""

    def __init__(self, setup: ServoSensors, noise: Noise) -> None:
        self._step, self._deviation, self._noise = setup.encoder_step, setup.encoder_noise, noise
        self._part = TIMESTEP / (TIMESTEP + setup.velocity_time)
        self._per_step = 1.0 / TIMESTEP
        self.position = self.rate = 0.0
        """Radians and rad/s at the output of the module."""

    def start(self, true: float) -> None:
        """Read after the power has come; the rate begins at zero."""
        self.position = self.rate = 0.0
        self.sample(true)
        self.rate = 0.0

    def sample(self, true: float) -> None:
        """Read the true position after another physics step."""
        if self._deviation:
            true += self._deviation * self._noise()
        if step := self._step:
            true = step * round(true / step)
        self.rate += self._part * ((true - self.position) * self._per_step - self.rate)
        self.position = true


class Imu:
    """Gyroscope and accelerometer: each axis has a bias for good, and noise in each measurement."""

    def __init__(self, setup: ServoSensors, noise: Noise) -> None:
        self._noise = noise
        self._gyro_noise = setup.imu_noise(setup.gyro_density)
        self._accelerometer_noise = setup.imu_noise(setup.accelerometer_density)
        self.gyro_bias: Vector = (setup.gyro_bias * noise(), setup.gyro_bias * noise(), setup.gyro_bias * noise())
        self.accelerometer_bias = noise.uniform(setup.accelerometer_bias)

    def angular_velocity(self, true: Sequence[float] | NDArray[np.float64]) -> Vector:
        """A measurement, rad/s."""
        return self._measured(true, self.gyro_bias, self._gyro_noise)

    def acceleration(self, true: Sequence[float]) -> Vector:
        """A measurement of the specific force, m/s^2."""
        return self._measured(true, self.accelerometer_bias, self._accelerometer_noise)

    def _measured(self, true: Sequence[float] | NDArray[np.float64], bias: Vector, deviation: float) -> Vector:
        noise = self._noise
        x, y, z = (value + offset + deviation * noise() for value, offset in zip(true, bias, strict=True))
        return float(x), float(y), float(z)
