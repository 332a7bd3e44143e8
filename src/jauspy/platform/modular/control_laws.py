"""How the joints of a modular arm follow their setpoints: a PID each (stage 1), or the arm's model (stage 2).

Both return the torques of the motors. Vectors are in the order of the chain; rad, rad/s, N m.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final, Protocol

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.description import Gains
from jauspy.platform.joint_control import Pid
from jauspy.platform.modular.dynamics import ArmModel
from jauspy.platform.modular.parts import ServoData
from jauspy.platform.modular.trajectory import Setpoint

Array = NDArray[np.float64]

POSITION_BANDWIDTH: Final = 18.0
"""rad/s: natural frequency of position errors, well below that of the torques."""

POSITION_DAMPING: Final = 0.9
"""Damping ratio of position errors."""

INTEGRAL_TIME: Final = 0.35
"""Seconds in which what remains of an error is integrated away."""

TORQUE_BANDWIDTH: Final = 160.0
"""rad/s: natural frequency of errors of the springs' torques, if the control rate allows it."""

LARGEST_STEP: Final = 0.35
"""Natural frequency of the torques times the control period, at most."""

STICTION_SPEED: Final = 0.03
"""rad/s: below this speed of the setpoint friction is compensated only in part."""


class ControlLaw(Protocol):
    """A stage of control, for one chain."""

    def torques(self, setpoint: Setpoint, q: Array, v: Array, spring: Array, dt: float) -> Array:
        """The torques of the motors; `spring` are those that the springs measure."""
        ...


class PidLaw:
    """Stage 1: one PID controller for each module, which knows nothing of the others."""

    def __init__(self, gains: Sequence[Gains], limits: Sequence[float]) -> None:
        self._pids = [Pid(each, limit) for each, limit in zip(gains, limits, strict=True)]

    def torques(self, setpoint: Setpoint, q: Array, v: Array, spring: Array, dt: float) -> Array:  # noqa: ARG002 - the interface of all laws
        """The torques of the motors."""
        errors, rates = (setpoint.q - q).tolist(), (setpoint.v - v).tolist()
        rows = zip(self._pids, errors, rates, strict=True)
        return np.array([pid.update(error, rate, dt) for pid, error, rate in rows])


class ModelLaw:
    """Stage 2: inverse dynamics of the arm for the springs' torques, and torque control of each motor with its spring.

    The spring torque of a joint that is to accelerate by `a` follows from the model. The rotor then moves so that
    errors of this torque decay like a damped oscillation of `TORQUE_BANDWIDTH`: this damps the springs actively.
    """

    def __init__(self, model: ArmModel, servos: Sequence[ServoData]) -> None:
        self.model = model
        self._friction = np.array([each.friction for each in servos])
        self._damping = np.array([each.damping for each in servos])
        self._stiffness = np.array([each.stiffness for each in servos])
        self._rotor = np.array([each.rotor_inertia for each in servos])
        self._limit = np.array([each.max_torque for each in servos])
        self._integral = np.zeros(len(servos))
        self._last_spring: Array | None = None

    def torques(self, setpoint: Setpoint, q: Array, v: Array, spring: Array, dt: float) -> Array:
        """The torques of the motors."""
        position_error, velocity_error = setpoint.q - q, setpoint.v - v
        self._integral += position_error * dt
        omega = POSITION_BANDWIDTH
        wanted = (
            setpoint.a
            + 2.0 * POSITION_DAMPING * omega * velocity_error
            + omega * omega * (position_error + self._integral / INTEGRAL_TIME)
        )
        torque = self.model.inverse_dynamics(q, v, wanted)
        spring_rate = np.zeros_like(spring) if self._last_spring is None else (spring - self._last_spring) / dt
        self._last_spring = spring
        natural = min(TORQUE_BANDWIDTH, LARGEST_STEP / dt)
        compliance = self._rotor / self._stiffness
        rotor_velocity = v + spring_rate / self._stiffness
        friction = self._friction * np.tanh(setpoint.v / STICTION_SPEED) + self._damping * rotor_velocity
        motor = (
            spring
            + friction
            + self._rotor * wanted
            + compliance * (natural * natural * (torque - spring) - 2.0 * natural * spring_rate)
        )
        limited: Array = np.clip(motor, -self._limit, self._limit)
        self._integral -= np.where(limited != motor, position_error * dt, 0.0)
        return limited


def smooth_step(part: float) -> float:
    """From 0 to 1 while `part` goes from 0 to 1, with slope 0 at both ends."""
    part = min(1.0, max(0.0, part))
    return part * part * (3.0 - 2.0 * part)


def all_finite(values: Sequence[float]) -> bool:
    """Whether no value is infinite or NaN."""
    return all(map(math.isfinite, values))
