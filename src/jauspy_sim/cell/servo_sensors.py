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


class Encoders:
    """The encoders on both sides of a spring: positions in counts, the rates of which are differences of counts."""

    def __init__(self, setup: ServoSensors, noise: Noise) -> None:
        self._setup = setup
        self._noise = noise
        self._part = TIMESTEP / (TIMESTEP + setup.velocity_time)
        self.output = self.motor = 0.0
        """Radians at the output."""
        self.output_rate = self.motor_rate = 0.0
        """rad/s at the output."""

    def start(self, motor: float, output: float) -> None:
        """Read after the power has come; the rates begin at zero."""
        self.motor, self.output = self._read(motor), self._read(output)
        self.motor_rate = self.output_rate = 0.0

    def sample(self, motor: float, output: float) -> None:
        """Read the true positions after another physics step."""
        part = self._part
        found = self._read(motor)
        self.motor_rate += part * ((found - self.motor) / TIMESTEP - self.motor_rate)
        self.motor = found
        found = self._read(output)
        self.output_rate += part * ((found - self.output) / TIMESTEP - self.output_rate)
        self.output = found

    def _read(self, true: float) -> float:
        setup = self._setup
        if setup.encoder_noise:
            true += setup.encoder_noise * self._noise()
        step = setup.encoder_step
        return step * round(true / step) if step else true


class Imu:
    """Gyroscope and accelerometer: each axis has a bias for good, and noise in each measurement."""

    def __init__(self, setup: ServoSensors, noise: Noise) -> None:
        self._noise = noise
        self._gyro_noise = setup.imu_noise(setup.gyro_density)
        self._accelerometer_noise = setup.imu_noise(setup.accelerometer_density)
        self.gyro_bias: Vector = (
            setup.gyro_bias * noise(),
            setup.gyro_bias * noise(),
            setup.gyro_bias * noise(),
        )
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
