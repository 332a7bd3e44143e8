"""Groups of joints in MuJoCo: controllers read its state and set the efforts of its motors."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco

from jauspy.platform.description import Description, GroupSetup, Joint
from jauspy.platform.joint_control import JointController
from jauspy.platform.joints import JointState, Target
from jauspy_sim.assembly import TIMESTEP


class SimulatedJoints:
    """A `JointGroup`; joints and motors have their URDF's names after `prefix`."""

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, description: Description, setup: GroupSetup
    ) -> None:
        self._qpos, self._qvel, self._bias, self._ctrl = data.qpos, data.qvel, data.qfrc_bias, data.ctrl
        self._joints = tuple(description.joint(name) for name in setup.joints)
        self._chain = description.chain(setup.base, setup.tip)
        found = [model.joint(f"{prefix}{joint.name}") for joint in self._joints]
        self._positions = _places([int(joint.qposadr[0]) for joint in found])
        self._dofs = _places([int(joint.dofadr[0]) for joint in found])
        self._motors = _places([int(model.actuator(f"{prefix}{joint.name}").id) for joint in self._joints])
        self._every = max(1, round(1.0 / (setup.rate * TIMESTEP)))
        self._until_next = 0
        _place(data, model, prefix, description, dict(zip(setup.joints, setup.start, strict=True)))
        self._controllers = [
            JointController(joint, setup.gains[joint.name], start)
            for joint, start in zip(self._joints, setup.start, strict=True)
        ]

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
            tuple(self._qpos[self._positions].tolist()),
            tuple(self._qvel[self._dofs].tolist()),
            tuple(self._ctrl[self._motors].tolist()),
        )

    def control(self) -> None:
        """Set the motors' efforts for the physics step that follows, when the control loop is due."""
        if self._until_next:
            self._until_next -= 1
            return
        self._until_next = self._every - 1
        dt = self._every * TIMESTEP
        rows = zip(
            self._controllers,
            self._qpos[self._positions].tolist(),
            self._qvel[self._dofs].tolist(),
            self._bias[self._dofs].tolist(),  # gravity and what motion adds
            strict=True,
        )
        self._ctrl[self._motors] = [
            controller.effort(position, velocity, dt, bias) for controller, position, velocity, bias in rows
        ]


def _places(found: list[int]) -> slice | list[int]:
    """Indices as numpy takes them fastest: a slice when they follow each other."""
    follow = found == list(range(found[0], found[0] + len(found)))
    return slice(found[0], found[0] + len(found)) if follow else found


def _place(
    data: mujoco.MjData, model: mujoco.MjModel, prefix: str, description: Description, start: dict[str, float]
) -> None:
    """Put joints, and those that mimic them, where they start."""
    for joint in description.joints.values():
        position = start.get(joint.name, start.get(joint.mimics or ""))
        if position is not None:
            data.qpos[model.joint(f"{prefix}{joint.name}").qposadr[0]] = position
