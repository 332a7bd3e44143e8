"""The IMU of a simulated servo module, with the errors that `ServoSensors` states."""

from __future__ import annotations

from jauspy.geometry.vectors import Vector
from jauspy.platform.modular.parts import ServoSensors
from jauspy_sim.physics.encoders import Noise


class Imu:
    """Gyroscope and accelerometer: each axis has a bias for good, and noise in each measurement."""

    def __init__(self, setup: ServoSensors, noise: Noise) -> None:
        self._draw = draw = noise.draw
        self._gyro_noise = setup.imu_noise(setup.gyro_density)
        self._accelerometer_noise = setup.imu_noise(setup.accelerometer_density)
        self.gyro_bias: Vector = (setup.gyro_bias * draw(), setup.gyro_bias * draw(), setup.gyro_bias * draw())
        self.accelerometer_bias = noise.uniform(setup.accelerometer_bias)

    def angular_velocity(self, true: Vector) -> Vector:
        """A measurement, rad/s."""
        return self._measured(true, self.gyro_bias, self._gyro_noise)

    def acceleration(self, true: Vector) -> Vector:
        """A measurement of the specific force, m/s^2."""
        return self._measured(true, self.accelerometer_bias, self._accelerometer_noise)

    def _measured(self, true: Vector, bias: Vector, deviation: float) -> Vector:
        draw = self._draw
        x, y, z = true
        a, b, c = bias
        return x + a + deviation * draw(), y + b + deviation * draw(), z + c + deviation * draw()
