"""Joint groups and the tracked chassis in MuJoCo: commands to motors and belts, and their states."""

from __future__ import annotations

import math
from collections.abc import Sequence

import mujoco
import numpy as np

from jauspy.geometry.poses import Pose, Twist
from jauspy.geometry.urdf import Joint, RobotDescription
from jauspy.platform.chassis import SkidSteerDrive
from jauspy.platform.description import GroupSetup, TrackSetup
from jauspy.platform.joint_control import JointController
from jauspy.platform.joints import JointState, Target
from jauspy_sim.assembly import TIMESTEP, view
from jauspy_sim.belts import Belts
from jauspy_sim.load_brake import LoadBrake


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
        self._followers = [_followers(model, prefix, description, joint) for joint in self._joints]
        self.every = max(1, round(1.0 / (setup.rate * TIMESTEP)))
        """Physics steps from one `control` to the next."""
        self._dt = self.every * TIMESTEP
        _set_initial_positions(data, model, prefix, description, dict(zip(setup.joints, setup.start, strict=True)))
        self._controllers = [
            JointController(joint, setup.gains[joint.name], start)
            for joint, start in zip(self._joints, setup.start, strict=True)
        ]
        self._brakes = [
            LoadBrake(model, data, joint, dof, self._dt) for joint, dof in zip(self._joints, self._dofs, strict=True)
        ]
        self.load = np.zeros(model.nv)
        """Further efforts that the controllers compensate, by degree of freedom: of a payload."""
        self._load = view(self.load)
        self._rows = list(
            zip(
                self._controllers,
                self._positions,
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
        rows = zip(self._controllers, self._brakes, targets, state.positions, state.velocities, strict=True)
        for controller, brake, target, position, velocity in rows:
            if target is not None:
                brake.follow(controller, target, position, velocity)

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        for controller, position in zip(self._controllers, self.state().positions, strict=True):
            controller.hold(position)

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        return JointState(
            tuple([self._qpos[at] for at in self._positions]),
            tuple([self._qvel[at] for at in self._dofs]),
            tuple([self._ctrl[at] + brake.torque for at, brake in zip(self._motors, self._brakes, strict=True)]),
            self._overloads(),
        )

    def _overloads(self) -> dict[str, float]:
        rows = zip(self._joints, self._brakes, strict=True)
        return {joint.name: load for joint, brake in rows if brake.engaged and (load := brake.overload) is not None}

    def control(self) -> None:
        """Set the motors' efforts for the next `every` physics steps; MuJoCo's bias compensates gravity and motion."""
        qpos, qvel, bias, ctrl, dt = self._qpos, self._qvel, self._bias, self._ctrl, self._dt
        load = self._load
        for controller, position, dof, motor, followers, brake in self._rows:
            needed = bias[dof] + load[dof]
            for multiplier, follower in followers:
                needed += multiplier * bias[follower]
            wanted = controller.effort(qpos[position], qvel[dof], dt, needed)
            ctrl[motor] = brake.effort(controller, qpos[position], qvel[dof], wanted, needed)


def _followers(
    model: mujoco.MjModel, prefix: str, description: RobotDescription, joint: Joint
) -> tuple[tuple[float, int], ...]:
    """Multipliers and degrees of freedom of the joints that mimic a joint, whose motor carries them, too."""
    found = (each for each in description.joints.values() if each.mimics == joint.name)
    return tuple((each.multiplier, int(model.joint(f"{prefix}{each.name}").dofadr[0])) for each in found)


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
        position, self.dof = int(joint.qposadr[0]), int(joint.dofadr[0])
        self._qpos, self._qvel = view(data.qpos[position : position + 7]), view(data.qvel[self.dof : self.dof + 6])

    def pose(self) -> Pose:
        """In the world."""
        x, y, z, *quaternion = self._qpos.tolist()
        return Pose(x, y, z, *roll_pitch_yaw(*quaternion))

    def twist(self) -> Twist:
        """In its own frame."""
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


class TrackedDrive(SkidSteerDrive):
    """A `DriveBase`: free joint `base`, joints and motors of the belts, their names after `prefix`."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, prefix: str, tracks: TrackSetup) -> None:
        super().__init__()
        self._model = model
        self._data = data
        self._qpos, self._qvel = view(data.qpos), view(data.qvel)
        base = FloatingBase(model, data, prefix)
        self._pose, self._twist = base.pose, base.twist
        names = [f"{prefix}{name}" for name in tracks.left + tracks.right]
        self._belts = Belts(model, data, base.dof, names)
        self._run = view(data.userdata)
        positions = [int(model.joint(name).qposadr[0]) for name in names]
        self._driven_positions = list(enumerate((positions[0], positions[len(tracks.left)])))
        self._belt_positions = positions
        driven = [f"{prefix}{side[0]}" for side in (tracks.left, tracks.right)]
        self._dofs = [int(model.joint(name).dofadr[0]) for name in driven]
        self._motors = [int(model.actuator(name).id) for name in driven]
        self._speeds = [float(model.actuator_ctrlrange[motor][1]) for motor in self._motors]
        self._brakes = [float(model.actuator_forcerange[motor][1]) for motor in self._motors]
        self._gear_friction = [float(model.dof_frictionloss[dof]) for dof in self._dofs]
        self.stop()

    def set_track_efforts(self, left: float, right: float) -> None:
        """Drive the belts with fractions of the motors' voltage, -1..1; zero for both brakes with their full force."""
        braking = not (left or right)
        rows = zip(self._motors, self._speeds, self._dofs, self._brakes, self._gear_friction, strict=True)
        for (motor, speed, dof, brake, friction), effort in zip(rows, (left, right), strict=True):
            self._data.ctrl[motor] = -speed * effort  # on the ground a belt runs backward when the robot drives forward
            self._model.dof_frictionloss[dof] = brake if braking else friction

    def step(self) -> None:
        """Advance the physics by one step, in which the belts run around their shapes."""
        mujoco.mj_step1(self._model, self._data)
        self._belts.run_around()
        mujoco.mj_step2(self._model, self._data)
        for side, position in self._driven_positions:
            self._run[side] -= self._qpos[position]
        for position in self._belt_positions:
            self._qpos[position] = 0.0

    def pose(self) -> Pose:
        """Pose of `base_link` in the world."""
        return self._pose()

    def twist(self) -> Twist:
        """Velocity of `base_link` in its own frame."""
        return self._twist()

    def track_speeds(self) -> tuple[float, float]:
        """As `SkidSteerDrive.track_speeds`, of the first belt of each side."""
        left, right = self._dofs
        return -self._qvel[left], -self._qvel[right]
