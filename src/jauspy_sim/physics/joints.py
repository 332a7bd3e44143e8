"""Joint groups and the free joint of a chassis in MuJoCo: commands to motors, and states."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Protocol

import mujoco

from jauspy.geometry.poses import Pose, Twist
from jauspy.geometry.urdf import Joint, RobotDescription
from jauspy.platform.description import GroupSetup
from jauspy.platform.joint_control import FedForwardController, JointController, JointSetpoint
from jauspy.platform.joints import ContactReaction, JointContact, JointSensors, JointState, Target
from jauspy.platform.motors import MotorLoad
from jauspy_sim.assembly import TIMESTEP, view
from jauspy_sim.physics.contact_guard import ContactGuard
from jauspy_sim.physics.dynamics import Dynamics
from jauspy_sim.physics.encoders import Encoder, Noise
from jauspy_sim.physics.load_brake import LoadBrake


class Held(Protocol):
    """What a group's tip holds, as its controllers know it."""

    @property
    def known(self) -> bool:
        """True if nothing is held, or its weight is known."""
        ...

    def prepare(self, setpoints: Sequence[tuple[float, float]]) -> bool:
        """Set the load for the next step; `setpoints`: velocities and accelerations of the joints.

        True to learn from this step.
        """
        ...

    def learn(
        self, setpoints: Sequence[tuple[float, float]], efforts: Sequence[float], needed: Sequence[float]
    ) -> None:
        """Learn from the efforts of the step, as measured, where the model of robot and load had said `needed`."""
        ...


class SimulatedJoints:
    """A `JointGroup`; joints and motors have their URDF's names after `prefix`.

    With `sensors` in its setup, its controllers and its state know positions by encoders and efforts by currents;
    `seed` is that of their errors.
    """

    def __init__(
        self,
        model: mujoco.MjModel,
        data: mujoco.MjData,
        prefix: str,
        description: RobotDescription,
        setup: GroupSetup,
        *,
        dynamics: Dynamics | None = None,
        seed: int = 0,
    ) -> None:
        self._qpos, self._qvel, self._bias, self._ctrl = map(view, (data.qpos, data.qvel, data.qfrc_bias, data.ctrl))
        self._joints = tuple(description.joint(name) for name in setup.joints)
        self._chain = description.chain(setup.base, setup.tip)
        found = [model.joint(f"{prefix}{joint.name}") for joint in self._joints]
        self._positions = [int(joint.qposadr[0]) for joint in found]
        self._dofs = [int(joint.dofadr[0]) for joint in found]
        self._motors = [int(model.actuator(f"{prefix}{joint.name}").id) for joint in self._joints]
        self._followers = [_followers(model, prefix, description, joint) for joint in self._joints]
        self.every = max(1, round(1.0 / (setup.rate * TIMESTEP)))
        """Physics steps from one `control` to the next."""
        self._dt = self.every * TIMESTEP
        _set_initial_positions(data, model, prefix, description, dict(zip(setup.joints, setup.start, strict=True)))
        self._dynamics = dynamics
        self._setpoints = [(0.0, 0.0)] * len(self._joints)
        """Velocities and accelerations of the setpoints in the last control cycle."""
        starts = [
            (joint, setup.gains[joint.name], start) for joint, start in zip(self._joints, setup.start, strict=True)
        ]
        fed_forward = [FedForwardController(*row) for row in starts] if dynamics is not None else []
        self._fed_forward = fed_forward
        """Those of the controllers that `dynamics` feeds forward: all or none."""
        self._controllers: Sequence[JointController] = fed_forward or [JointController(*row) for row in starts]
        self._brakes = [
            LoadBrake(model, data, joint, dof, self._dt) for joint, dof in zip(self._joints, self._dofs, strict=True)
        ]
        self.held: Held | None = None
        """What the group's tip holds, which needs `dynamics`."""
        self._guard = (
            ContactGuard(setup.contact, self._joints, fed_forward, dynamics, self._dt)
            if dynamics is not None and setup.contact is not ContactReaction.IGNORE
            else None
        )
        self._needed: Sequence[float] = ()
        self._applied: Sequence[float] = ()
        """Efforts of the last control cycle: by the model, and as measured."""
        sensors = setup.sensors
        self._encoders = _encoders(self._joints, sensors, seed, self._dt) if sensors is not None else ()
        self._noises = _effort_noises(self._joints, sensors, seed) if sensors is not None else ()
        for encoder, address in zip(self._encoders, self._positions, strict=False):
            encoder.start(self._qpos[address])
        self._rows = list(
            zip(
                self._controllers,
                self._dofs,
                self._motors,
                self._followers,
                self._brakes,
                strict=True,
            )
        )

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints, base to tip; None keeps a joint's target."""
        state = self.state()
        if self._guard is not None and any(target is not None for target in targets):
            self._guard.command()
        rows = zip(self._controllers, self._brakes, targets, state.positions, state.velocities, strict=True)
        for controller, brake, target, position, velocity in rows:
            if target is not None:
                brake.follow(controller, target, position, velocity)

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        for controller, position in zip(self._controllers, self.state().positions, strict=True):
            controller.hold(position)

    def state(self) -> JointState:
        """Positions, velocities and efforts as measured: by encoders, those when its controllers acted last."""
        true = self.true_state()
        if not self._encoders:
            return true
        return JointState(
            tuple([encoder.position for encoder in self._encoders]),
            tuple([encoder.rate for encoder in self._encoders]),
            self._measured_efforts(true.efforts),
            true.overloads,
            self.contact,
        )

    def _measured_efforts(self, true: tuple[float, ...]) -> tuple[float, ...]:
        """Efforts as the currents tell them."""
        if not self._noises:
            return true
        return tuple([effort + noise() for effort, noise in zip(true, self._noises, strict=True)])

    def true_state(self) -> JointState:
        """Positions, velocities and efforts after the last step, for measurements only."""
        return JointState(
            tuple([self._qpos[address] for address in self._positions]),
            tuple([self._qvel[address] for address in self._dofs]),
            self._true_efforts(),
            self._overloads(),
            self.contact,
        )

    def _true_efforts(self) -> tuple[float, ...]:
        rows = zip(self._motors, self._brakes, strict=True)
        return tuple([self._ctrl[address] + brake.torque for address, brake in rows])

    def motor_loads(self) -> Iterator[MotorLoad]:
        """Efforts of the motors, without those of brakes, and velocities."""
        for joint, motor, dof in zip(self._joints, self._motors, self._dofs, strict=True):
            yield MotorLoad(joint.name, self._ctrl[motor], self._qvel[dof])

    @property
    def contact(self) -> JointContact | None:
        """The last contact that has ended a motion; None without one, and without a watch for it."""
        return self._guard.contact if self._guard is not None else None

    def setpoints(self) -> tuple[JointSetpoint, ...]:
        """The setpoints of the controllers, base to tip."""
        return tuple([controller.setpoint for controller in self._controllers])

    def _overloads(self) -> dict[str, float]:
        rows = zip(self._joints, self._brakes, strict=True)
        return {joint.name: load for joint, brake in rows if brake.engaged and (load := brake.overload) is not None}

    def control(self) -> None:
        """Set the motors' efforts for the next `every` physics steps.

        Without feed-forward, MuJoCo's bias compensates gravity and motion.
        """
        bias, ctrl, dt = self._bias, self._ctrl, self._dt
        measured = self._measure()
        setpoints, learns = self._setpoints, False
        held, guard = self.held, self._guard
        known = held is None or held.known
        if guard is not None and self._needed:
            guard.step(measured, setpoints, self._applied, self._needed, load_known=known)
        if self._dynamics is not None:
            self._setpoints = setpoints = [controller.begin(dt) for controller in self._fed_forward]
            learns = held is not None and held.prepare(setpoints)
            bias = self._dynamics.efforts(setpoints)
        for (controller, dof, motor, followers, brake), (value, velocity) in zip(self._rows, measured, strict=True):
            needed = bias[dof]
            for multiplier, follower in followers:
                needed += multiplier * bias[follower]
            effort = controller.effort(value, velocity, dt, needed)
            if brake.watches or not -brake.saturation < effort < brake.saturation:
                effort = brake.effort(controller, value, velocity, effort, needed)
            ctrl[motor] = effort
        if guard is None and not learns:
            return
        self._needed = [bias[dof] for dof in self._dofs]
        self._applied = self._measured_efforts(self._true_efforts())
        if learns and held is not None and not (guard is not None and guard.suspects(load_known=known)):
            held.learn(setpoints, self._applied, self._needed)

    def _measure(self) -> list[tuple[float, float]]:
        """Positions and velocities, base to tip; by the encoders where there are some."""
        qpos, qvel = self._qpos, self._qvel
        if not self._encoders:
            return [(qpos[address], qvel[dof]) for address, dof in zip(self._positions, self._dofs, strict=True)]
        rows = zip(self._encoders, self._positions, self._setpoints, strict=True)
        return [encoder.sample(qpos[address], acceleration) for encoder, address, (_, acceleration) in rows]


def _encoders(joints: Sequence[Joint], sensors: JointSensors, seed: int, dt: float) -> tuple[Encoder, ...]:
    return tuple([Encoder(sensors, Noise(seed, f"{joint.name} encoder"), dt) for joint in joints])


def _effort_noises(joints: Sequence[Joint], sensors: JointSensors, seed: int) -> tuple[Callable[[], float], ...]:
    """For each joint a source of errors of its effort, N m or N."""
    return tuple([Noise(seed, f"{joint.name} effort", sensors.effort_noise * joint.effort).draw for joint in joints])


def _followers(
    model: mujoco.MjModel, prefix: str, description: RobotDescription, joint: Joint
) -> tuple[tuple[float, int], ...]:
    """Multipliers and degrees of freedom of the joints that mimic a joint, whose motor carries them, too."""
    found = (follower for follower in description.joints.values() if follower.mimics == joint.name)
    return tuple((follower.multiplier, int(model.joint(f"{prefix}{follower.name}").dofadr[0])) for follower in found)


def _set_initial_positions(
    data: mujoco.MjData, model: mujoco.MjModel, prefix: str, description: RobotDescription, start: dict[str, float]
) -> None:
    """Set the initial positions of joints and of those that mimic them."""
    for joint in description.joints.values():
        if (joint.mimics or joint.name) in start:
            data.qpos[model.joint(f"{prefix}{joint.name}").qposadr[0]] = joint.position(start)


class FloatingBase:
    """The root link of a robot that drives: the free joint `base`, its name after `prefix`."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str) -> None:
        joint = model.joint(f"{prefix}base")
        position, dof = int(joint.qposadr[0]), int(joint.dofadr[0])
        self._qpos, self._qvel = view(data.qpos[position : position + 7]), view(data.qvel[dof : dof + 6])

    def pose(self) -> Pose:
        """The pose of the root link in the world."""
        x, y, z, *quaternion = self._qpos.tolist()
        return Pose(x, y, z, *roll_pitch_yaw(*quaternion))

    def twist(self) -> Twist:
        """The velocity of the root link in its own frame."""
        x, y, z, *rates = self._qvel.tolist()  # of a free joint: the velocity in the world's frame, rates in its own
        w, a, b, c = self._qpos[3:]
        tx, ty, tz = 2.0 * (b * z - c * y), 2.0 * (c * x - a * z), 2.0 * (a * y - b * x)
        return Twist(x - w * tx + b * tz - c * ty, y - w * ty + c * tx - a * tz, z - w * tz + a * ty - b * tx, *rates)


def roll_pitch_yaw(w: float, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Fixed-axis angles (REP-103) of a unit quaternion, radians."""
    roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
    pitch = math.asin(min(1.0, max(-1.0, 2.0 * (w * y - z * x))))
    yaw = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
    return roll, pitch, yaw
