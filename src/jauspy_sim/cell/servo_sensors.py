"""The IMU of a simulated servo module, with the errors that `ServoSensors` states."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.vectors import Vector
from jauspy.platform.modular.parts import ServoSensors
from jauspy_sim.physics.encoders import Noise


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
