"""The chassis on wheels in MuJoCo: commands to motors, brakes and steering, and its state."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import mujoco

from jauspy.geometry.poses import Pose, Twist
from jauspy.platform.motors import MotorLoad
from jauspy.platform.wheels import WheelDrive, WheelKind, WheelSetup
from jauspy_sim.assembly import view
from jauspy_sim.physics.joints import FloatingBase


class SimulatedWheels(WheelDrive):
    """A `DriveBase`: free joint `base`, joints and motors of the wheels, their names after `prefix`."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, wheels: WheelSetup) -> None:
        super().__init__(wheels)
        self._model, self._data = model, data
        self._qpos = view(data.qpos)
        base = FloatingBase(model, data, prefix)
        self._pose, self._twist = base.pose, base.twist
        names = [f"{prefix}{wheel.joint.name}" for wheel in wheels.wheels]
        self._dofs = [int(model.joint(name).dofadr[0]) for name in names]
        self._motors = [int(model.actuator(name).id) for name in names]
        self._steering = [int(model.actuator(f"{prefix}{steered.joint.name}").id) for steered in wheels.steering]
        self._rollers = (
            [int(model.joint(f"{name}/rollers").qposadr[0]) for name in names]
            if wheels.kind is WheelKind.MECANUM
            else []
        )
        self._angle = self._wanted_angle = 0.0
        self.stop()

    def set_wheel_efforts(self, efforts: tuple[float, ...], steering: float | None) -> None:
        """Drive the motors; all at zero brake, with all of their torque."""
        braking = not any(efforts)
        rows = zip(self.wheels.wheels, self._motors, self._dofs, efforts, strict=True)
        for wheel, motor, dof, effort in rows:
            self._data.ctrl[motor] = wheel.sign * wheel.joint.effort * effort
            self._model.dof_frictionloss[dof] = wheel.joint.effort if braking else wheel.joint.friction
        self._wanted_angle = self._wanted_angle if steering is None else steering

    def rim_speeds(self) -> Sequence[float]:
        """m/s, positive forward."""
        rows = zip(self.wheels.wheels, self._dofs, strict=True)
        return [wheel.sign * wheel.radius * float(self._data.qvel[dof]) for wheel, dof in rows]

    def motor_loads(self) -> Iterator[MotorLoad]:
        """Torques of the motors, less what their speed takes (damping), and rates; none while they brake."""
        for wheel, motor, dof in zip(self.wheels.wheels, self._motors, self._dofs, strict=True):
            rate, wanted = float(self._data.qvel[dof]), float(self._data.ctrl[motor])
            yield MotorLoad(wheel.joint.name, wanted - wheel.joint.damping * rate if wanted else 0.0, rate)

    @property
    def steering(self) -> float:
        """The steering angle, radians to the left."""
        return self._angle

    def pose(self) -> Pose:
        """Pose of the root link in the world."""
        return self._pose()

    def twist(self) -> Twist:
        """Velocity of the root link in its own frame."""
        return self._twist()

    def step(self, dt: float) -> None:
        """Turn the steering towards its target, and reset the rollers; after each `dt` seconds of physics."""
        for position in self._rollers:
            self._qpos[position] = 0.0
        if self._angle != self._wanted_angle:
            change = min(steered.joint.velocity for steered in self.wheels.steering) * dt
            self._angle += min(change, max(-change, self._wanted_angle - self._angle))
            for motor, angle in zip(self._steering, self.wheels.steering_angles(self._angle), strict=True):
                self._data.ctrl[motor] = angle
