"""Groups of joints in MuJoCo: controllers read its state and set the efforts of its motors."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco

from jauspy.geometry.urdf import Joint, RobotDescription
from jauspy.platform.description import GroupSetup
from jauspy.platform.joint_control import JointController
from jauspy.platform.joints import JointState, Target
from jauspy_sim.assembly import TIMESTEP, view


class SimulatedJoints:
    """A `JointGroup`; joints and motors have their URDF's names after `prefix`."""

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, description: RobotDescription, setup: GroupSetup
    ) -> None:
        self._qpos, self._qvel, self._bias, self._ctrl = map(view, (data.qpos, data.qvel, data.qfrc_bias, data.ctrl))
        self._joints = tuple(description.joint(name) for name in setup.joints)
        self._chain = description.chain(setup.base, setup.tip)
        found = [model.joint(f"{prefix}{joint.name}") for joint in self._joints]
        self._positions = [int(joint.qposadr[0]) for joint in found]
        self._dofs = [int(joint.dofadr[0]) for joint in found]
        self._motors = [int(model.actuator(f"{prefix}{joint.name}").id) for joint in self._joints]
        self.every = max(1, round(1.0 / (setup.rate * TIMESTEP)))
        """Physics steps from one `control` to the next."""
        self._dt = self.every * TIMESTEP
        _place(data, model, prefix, description, dict(zip(setup.joints, setup.start, strict=True)))
        self._controllers = [
            JointController(joint, setup.gains[joint.name], start)
            for joint, start in zip(self._joints, setup.start, strict=True)
        ]
        self._rows = list(zip(self._controllers, self._positions, self._dofs, self._motors, strict=True))

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """What each joint is to do from now on, base to tip; None leaves a joint at what it does."""
        state = self.state()
        rows = zip(self._controllers, targets, state.positions, state.velocities, strict=True)
        for controller, target, position, velocity in rows:
            if target is not None:
                controller.follow(target, position, velocity)

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        for controller, position in zip(self._controllers, self.state().positions, strict=True):
            controller.hold(position)

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        return JointState(
            tuple([self._qpos[at] for at in self._positions]),
            tuple([self._qvel[at] for at in self._dofs]),
            tuple([self._ctrl[at] for at in self._motors]),
        )

    def control(self) -> None:
        """Set the motors' efforts for the next `every` physics steps; the bias is gravity, and what motion adds."""
        qpos, qvel, bias, ctrl, dt = self._qpos, self._qvel, self._bias, self._ctrl, self._dt
        for controller, position, dof, motor in self._rows:
            ctrl[motor] = controller.effort(qpos[position], qvel[dof], dt, bias[dof])


def _place(
    data: mujoco.MjData, model: mujoco.MjModel, prefix: str, description: RobotDescription, start: dict[str, float]
) -> None:
    """Put joints, and those that mimic them, where they start."""
    for joint in description.joints.values():
        position = start.get(joint.name, start.get(joint.mimics or ""))
        if position is not None:
            data.qpos[model.joint(f"{prefix}{joint.name}").qposadr[0]] = position
