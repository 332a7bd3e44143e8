"""The car: a chassis that drives once servo modules with wheels are attached to its sides."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import mujoco

from jauspy.geometry.poses import Acceleration, Transform, Twist
from jauspy.geometry.vectors import rotated, rotation_from_quaternion, transposed
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.cell import Car, CarState
from jauspy.platform.modular.parts import CellSetup, PartKind
from jauspy_sim.assembly import view
from jauspy_sim.cell.connectors import SimulatedConnector
from jauspy_sim.cell.servos import SimulatedServo

MIN_WHEELS: Final = 4
"""Least number of wheels of an assembled car."""

EFFORT_RATE: Final = 1.0
"""Fractions of the full torque by which that of a wheel changes in a second: sudden changes shake its latches."""


class SimulatedCar(Car):
    """Drives by the torques of its wheels' servo modules, within their speeds; x of the chassis is forward.

    Once it is assembled, it alone commands these modules: targets of others are ignored.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        cell: CellSetup,
        connectors: Mapping[str, SimulatedConnector],
        servos: Mapping[str, SimulatedServo],
    ) -> None:
        self._qpos, self._qvel, self._qacc = map(view, (data.qpos, data.qvel, data.qacc))
        joint = model.joint(cell.car)
        self._at, self._dof = int(joint.qposadr[0]), int(joint.dofadr[0])
        self._kinds = {part.name: cell.types[part.type].kind for part in cell.parts}
        self._name = cell.car
        self._servos, self._connectors = servos, connectors
        own = [connector for connector in connectors.values() if connector.part == cell.car]
        # a wheel on a side whose connector points to y rolls forward when it turns about y
        self._sides = [
            (connector, math.copysign(1.0, connector.frame.rotation[1][2])) for connector in own if _sideways(connector)
        ]
        self._wheels: tuple[tuple[SimulatedServo, float], ...] = ()
        self._driving = False
        self._wanted, self._effort = (0.0, 0.0), (0.0, 0.0)
        """Fractions of the torques on the left and on the right: commanded, and applied."""

    @property
    def wheels(self) -> tuple[tuple[SimulatedServo, float], ...]:
        """The modules that turn its wheels, with the sign that drives it forward."""
        return self._wheels

    def state(self) -> CarState:
        """The state: whether it is assembled, and its motion."""
        qpos, at, dof = self._qpos, self._at, self._dof
        rotation = rotation_from_quaternion(qpos[at + 3], qpos[at + 4], qpos[at + 5], qpos[at + 6])
        frame = Transform(rotation, (qpos[at], qpos[at + 1], qpos[at + 2]))
        back = transposed(rotation)
        v, a = self._qvel[dof : dof + 6], self._qacc[dof : dof + 6]
        return CarState(
            assembled=len(self._wheels) >= MIN_WHEELS,
            pose=frame.to_pose(),
            twist=Twist(*rotated(back, (v[0], v[1], v[2])), v[3], v[4], v[5]),
            acceleration=Acceleration(*rotated(back, (a[0], a[1], a[2])), a[3], a[4], a[5]),
        )

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:  # noqa: ARG002 - never
        """Drive with fractions of the full effort; NaN and infinite values stop it."""
        if len(self._wheels) < MIN_WHEELS:
            return
        if not (math.isfinite(linear_x) and math.isfinite(rotational_z)) or not (linear_x or rotational_z):
            self.stop()
            return
        self._driving = True
        left, right = linear_x - rotational_z, linear_x + rotational_z
        largest = max(1.0, abs(left), abs(right))
        self._wanted = left / largest, right / largest

    def control(self, dt: float) -> None:
        """Bring the torques closer to the commanded ones, `dt` seconds after the last time."""
        if not self._driving or self._effort == self._wanted:
            return
        step = EFFORT_RATE * dt
        rows = zip(self._effort, self._wanted, strict=True)
        left, right = (now + min(step, max(-step, wanted - now)) for now, wanted in rows)
        self._effort = left, right
        for servo, side in self._wheels:
            fraction = left if side > 0.0 else -right
            servo.command(Target(ControlMode.EFFORT, fraction * servo.setup.max_torque))

    def stop(self) -> None:
        """Brake to a standstill and hold it."""
        if self._driving:
            self._driving = False
            self._wanted = self._effort = 0.0, 0.0
            for servo, _ in self._wheels:
                servo.hold()

    def update(self) -> None:
        """Find its wheels, after an attachment has changed."""
        found = []
        for connector, side in self._sides:
            servo = self._servos.get(connector.state().attached_to)
            if servo is None:
                continue
            output = self._connectors[f"{servo.name}/output"].state().attached_to
            if self._kinds.get(output) is PartKind.WHEEL:
                found.append((servo, side))
        wheels = tuple(found)
        if wheels != self._wheels:
            self.stop()
            for servo, _ in self._wheels:
                servo.claim("")
            self._wheels = wheels
            if len(wheels) >= MIN_WHEELS:
                for servo, _ in wheels:
                    servo.claim(self._name)


def _sideways(connector: SimulatedConnector) -> bool:
    return abs(connector.frame.rotation[1][2]) > 0.9
