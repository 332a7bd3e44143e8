"""The brake of a simulated joint: it holds a load that the motor cannot carry, and releases when the load is lower."""

from __future__ import annotations

import math
from typing import Final

import mujoco
import numpy as np

from jauspy.geometry.urdf import Joint
from jauspy.platform.joint_control import JointController
from jauspy.platform.joints import ControlMode, Target

SATURATED: Final = 0.98
"""Share of the greatest effort above which a motor counts as saturated."""
GIVING_WAY: Final = 0.1
"""Share of the speed limit by which a joint must exceed its commanded speed, against its motor, to count as giving
way."""
STEPS: Final = 3
"""Controller steps of giving way before the brake engages."""
CAPACITY: Final = 5.0
"""The greatest torque of the brake, as a multiple of the motor's."""
CARRIES: Final = 0.9
"""Share of the greatest effort below which the load must be for the brake to release."""
RELEASE_TIME: Final = 0.3
"""Seconds for which the load must be that low."""
STIFF: Final = (0.9995, 0.9999)
"""Impedance of the brake (MuJoCo): with the usual one it creeps by a hundredth of a radian in a second."""
REPORT_TIME: Final = 0.2
"""Seconds of overload after which it is reported; shorter ones are shocks."""


class LoadBrake:
    """Stops a joint that gives way while its motor is saturated. The motor is off while the brake holds."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, joint: Joint, dof: int, dt: float) -> None:
        self._model, self._data = model, data
        self._joint, self._dof, self._dt = joint, dof, dt
        self._friction = float(model.dof_frictionloss[dof])
        self._solref, self._solimp = model.dof_solref[dof].copy(), model.dof_solimp[dof].copy()
        self.saturation = SATURATED * joint.effort
        """The effort from which on, either way, `effort` is to be asked."""
        self.watches = False
        """True if it is to be asked whatever the effort is."""
        self._count = 0
        self._last = 0.0
        self._light = self._heavy = 0.0
        self._gravity = 0.0
        self.engaged = False
        self.torque = 0.0
        """Effort of the brake on the joint, N m or N; 0 while it is released."""

    @property
    def overload(self) -> float | None:
        """The load that the motor cannot carry, N m or N; None if there is none."""
        return abs(self.torque) if self.engaged and self._heavy >= REPORT_TIME else None

    def follow(self, controller: JointController, target: Target, position: float, velocity: float) -> None:
        """Make the controller follow a target.

        While the brake holds, only targets in the direction of the load are accepted.
        """
        if not self.engaged:
            controller.follow(target, position, velocity)
            return
        way = target.value - position if target.mode is ControlMode.POSITION else target.value
        if way * self.torque < 0.0:
            load = self.torque - self._gravity
            self._release(controller, position, load)
            controller.follow(target, position, velocity, load)

    def effort(
        self, controller: JointController, position: float, velocity: float, wanted: float, gravity: float
    ) -> float:
        """The motor's effort for the next step, where the controller wants `wanted`."""
        self._gravity = gravity
        if self.engaged:
            return self._hold(controller, position, gravity)
        self.watches = abs(wanted) >= self.saturation and not controller.is_braking
        if not self.watches:
            self._count, self._last = 0, 0.0
            return wanted
        against = -math.copysign(velocity, velocity * wanted)
        commanded = max(0.0, -math.copysign(1.0, wanted) * controller.wanted_velocity)
        gives_way = against - commanded > GIVING_WAY * self._joint.velocity and against >= self._last
        self._count = self._count + 1 if gives_way else 0
        self._last = against
        if self._count < STEPS:
            return wanted
        self._engage()
        controller.hold(position)
        return 0.0

    def _engage(self) -> None:
        self._model.dof_frictionloss[self._dof] = CAPACITY * self._joint.effort
        self._model.dof_solref[self._dof] = (2.0 * self._model.opt.timestep, 1.0)
        self._model.dof_solimp[self._dof][:2] = STIFF
        self.engaged, self._light, self._heavy = True, 0.0, 0.0
        self.torque = 0.0

    def _hold(self, controller: JointController, position: float, gravity: float) -> float:
        data = self._data
        rows = np.flatnonzero((data.efc_type == mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF) & (data.efc_id == self._dof))
        self.torque = float(data.efc_force[rows[0]]) if rows.size else 0.0
        if abs(self.torque) > CARRIES * self._joint.effort:
            self._light, self._heavy = 0.0, self._heavy + self._dt
            return 0.0
        self._light += self._dt
        if self._light < RELEASE_TIME:
            return 0.0
        torque = self.torque
        self._release(controller, position, torque - gravity)
        return torque

    def _release(self, controller: JointController, position: float, beyond_gravity: float) -> None:
        self._model.dof_frictionloss[self._dof] = self._friction
        self._model.dof_solref[self._dof] = self._solref
        self._model.dof_solimp[self._dof] = self._solimp
        self.engaged, self.torque, self._count, self._last = False, 0.0, 0, 0.0
        controller.hold_at(position, beyond_gravity)
