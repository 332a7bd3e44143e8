"""Control laws by which the joints of a modular arm follow setpoints: a PID each (stage 1), or a model (stage 2).

Both return the torques of the motors. Vectors are in the order of the chain; rad, rad/s, N m.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.joint_control import Pid
from jauspy.platform.joints import Gains
from jauspy.platform.modular.dynamics import ArmModel
from jauspy.platform.modular.parts import ServoData
from jauspy.platform.modular.trajectory import Setpoint

Array = NDArray[np.float64]

TORQUE_BANDWIDTH: Final = 100.0
"""rad/s: natural frequency of errors of the springs' torques, at most."""

LARGEST_STEP: Final = 0.45
"""Greatest product of the natural frequency of `TORQUE_BANDWIDTH` and the control period."""

STIFFENING: Final = 4.0
"""Greatest ratio of that frequency to that of the rotor on its spring; its square is the gain of the torque error."""

SEPARATION: Final = 8.0
"""Ratio of that frequency to the natural frequency of position errors."""

POSITION_DAMPING: Final = 0.9
"""Damping ratio of position errors."""

INTEGRAL_TIME: Final = 0.35
"""Seconds in which what remains of an error is integrated away."""

SMOOTHING: Final = 0.01
"""Seconds over which the rate of the planned torque is averaged; it jumps where the jerk of a motion does."""

STICTION_SPEED: Final = 0.03
"""rad/s: below this speed of the setpoint friction is compensated only in part."""

SLIDING_SPEED: Final = 0.05
"""rad/s: the same for the speed of the motor, while the setpoint stands still."""

SLIDING_ERROR: Final = 0.02
"""Radians: the same for the position error; friction that is not compensated helps to come to rest."""

SLIDING_PART: Final = 0.7
"""Part of the friction that is compensated then; with all of it the arm would hunt about its target."""


class JointMeasurements(NamedTuple):
    """Measurements of all modules, and the rates of the springs' torques (N m/s)."""

    q: Array
    v: Array
    spring: Array
    spring_rate: Array


class ControlLaw(Protocol):
    """A stage of control, for one chain."""

    def torques(self, setpoint: Setpoint, measured: JointMeasurements, dt: float) -> Array:
        """The torques of the motors for the next `dt` seconds."""
        ...

    def take_over(self, torques: Array, setpoint: Setpoint, measured: JointMeasurements) -> None:
        """Begin with these torques as far as possible, which another law has commanded last."""
        ...


class PidLaw:
    """Stage 1: one PID controller for each module, which knows nothing of the others.

    The position is that of the output, the rate that of the motor, as the module's encoders measure them: the rate of
    the output, which is beyond the spring, would excite it.
    """

    def __init__(self, servos: Sequence[ServoData], gains: Sequence[Gains]) -> None:
        self._pids = [Pid(gain, servo.max_torque) for gain, servo in zip(gains, servos, strict=True)]
        self._compliance = np.array([1.0 / servo.stiffness for servo in servos])

    def torques(self, setpoint: Setpoint, measured: JointMeasurements, dt: float) -> Array:
        """The torques of the motors."""
        rows = zip(self._pids, *self._errors(setpoint, measured), strict=True)
        return np.array([pid.update(error, rate, dt) for pid, error, rate in rows])

    def take_over(self, torques: Array, setpoint: Setpoint, measured: JointMeasurements) -> None:
        """Begin with these torques, as far as the limits of the integral parts allow."""
        rows = zip(self._pids, torques.tolist(), *self._errors(setpoint, measured), strict=True)
        for pid, torque, error, rate in rows:
            pid.reset(torque - pid.gains.p * error - pid.gains.d * rate)

    def _errors(self, setpoint: Setpoint, measured: JointMeasurements) -> tuple[list[float], list[float]]:
        motor = measured.v + measured.spring_rate * self._compliance
        return (setpoint.q - measured.q).tolist(), (setpoint.v - motor).tolist()


class ModelLaw:
    """Stage 2: inverse dynamics of the arm for the springs' torques, and torque control of each motor with its spring.

    The spring torque of a joint that is to accelerate by `a` follows from the model. The rotor then moves so that
    errors of this torque decay like a damped oscillation: this damps the springs actively.
    """

    def __init__(self, model: ArmModel, servos: Sequence[ServoData], dt: float) -> None:
        self.bias = np.zeros(len(servos))
        """Torques (N m) that are to be added: of a closed loop, in which the model alone does not determine them."""
        self._model = model
        self._joints = [_ModelledJoint(servo, dt) for servo in servos]

    def torques(self, setpoint: Setpoint, measured: JointMeasurements, dt: float) -> Array:
        """The torques of the motors."""
        q, v, spring, spring_rate = measured
        joints, model = self._joints, self._model
        # single numbers, since arrays of five take longer
        inertias = model.mass_matrix(q).diagonal().tolist()
        targets = zip(*[array.tolist() for array in setpoint], strict=True)
        states = zip(q.tolist(), v.tolist(), spring_rate.tolist(), strict=True)
        rows = zip(joints, inertias, targets, states, strict=True)
        wanted = [joint.wanted(inertia, target, state, dt) for joint, inertia, target, state in rows]
        torque = model.inverse_dynamics(q, v, np.array(wanted)) + self.bias
        planned = model.inverse_dynamics(*setpoint)
        columns = [array.tolist() for array in (torque, planned, spring, spring_rate)]
        return np.array([joint.torque(*each, dt) for joint, *each in zip(joints, *columns, strict=True)])

    def take_over(self, torques: Array, setpoint: Setpoint, measured: JointMeasurements) -> None:
        """Begin without knowledge of the past; the arm fades over from the last torques."""


class _ModelledJoint:
    """One joint of a `ModelLaw`: its module, and what is known of the past. `wanted` comes before each `torque`."""

    def __init__(self, servo: ServoData, dt: float) -> None:
        self._stiffness, self._friction, self._damping = servo.stiffness, servo.friction, servo.damping
        self._rotor, self._limit = servo.rotor_inertia, servo.max_torque
        compliance = servo.rotor_inertia / servo.stiffness
        natural = min(STIFFENING / math.sqrt(compliance), TORQUE_BANDWIDTH, LARGEST_STEP / dt)
        omega = natural / SEPARATION
        self._square = natural * natural
        self._torque_gain = compliance * self._square
        self._rate_gain = compliance * 2.0 * natural
        self._position_gain = omega * omega
        self._velocity_gain = 2.0 * POSITION_DAMPING * omega
        self._smoothing = min(1.0, dt / SMOOTHING)
        self._integral = 0.0
        self._planned: float | None = None
        self._planned_rate = 0.0
        self._step = self._soft = self._acceleration = self._resistance = 0.0

    def wanted(
        self, inertia: float, setpoint: tuple[float, float, float], measured: tuple[float, float, float], dt: float
    ) -> float:
        """The acceleration that is wanted, by the setpoint and by position, velocity and rate of the spring's torque.

        `inertia` is that of the joint in the present position of the arm.
        """
        target, speed, acceleration = setpoint
        q, v, spring_rate = measured
        # the part of the torque that is controlled by the spring's: of a light load, whose oscillation is faster than
        # this control, less and less, down to none, when motor and load move as one
        stiff = self._square * inertia
        self._soft = soft = stiff / (stiff + self._stiffness)
        deflection_rate = spring_rate / self._stiffness
        error = target - q
        self._step = step = error * dt
        self._integral += step
        self._acceleration = wanted = (
            acceleration
            + self._velocity_gain * (speed - v - (1.0 - soft) * deflection_rate)
            + self._position_gain * (error + self._integral / INTEGRAL_TIME)
        )
        rotor_velocity = v + deflection_rate
        moving = math.tanh(speed / STICTION_SPEED)
        sliding = SLIDING_PART * (1.0 - abs(moving)) * math.tanh(rotor_velocity / SLIDING_SPEED)
        sliding *= min(1.0, abs(error) / SLIDING_ERROR)
        self._resistance = self._friction * (moving + sliding) + self._damping * rotor_velocity
        return wanted

    def torque(self, torque: float, planned: float, spring: float, spring_rate: float, dt: float) -> float:
        """The torque of the motor, by those of the model: for what is wanted, and for the setpoint."""
        if self._planned is not None:
            self._planned_rate += self._smoothing * ((planned - self._planned) / dt - self._planned_rate)
        self._planned = planned
        soft, limit = self._soft, self._limit
        motor = (
            spring
            + self._resistance
            + self._rotor * self._acceleration
            + (1.0 - soft + soft * self._torque_gain) * (torque - spring)
            + soft * self._rate_gain * (self._planned_rate - spring_rate)
        )
        if -limit <= motor <= limit:
            return motor
        self._integral -= self._step
        return math.copysign(limit, motor)


def smooth_step(part: float) -> float:
    """Go from 0 to 1 while `part` does, with slope 0 at both ends: 3 p^2 - 2 p^3."""
    part = min(1.0, max(0.0, part))
    return part * part * (3.0 - 2.0 * part)
