"""The controller of a modular arm: it follows changes of attachments, plans motions, and commands the modules."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.poses import IDENTITY, Pose, Transform
from jauspy.platform.modular.arm import ArmController, ModularArm, ModularArmState
from jauspy.platform.modular.connector import VacuumConnector
from jauspy.platform.modular.control_laws import ControlLaw, Measured, ModelLaw, PidLaw, smooth_step
from jauspy.platform.modular.dynamics import ArmModel, PayloadEstimator
from jauspy.platform.modular.graph import Attachment, Chain, attachments, find_chain
from jauspy.platform.modular.parts import CellSetup, ServoData
from jauspy.platform.modular.servo import ServoDrive
from jauspy.platform.modular.trajectory import Limits, Motion, MotionError, Setpoint, Shaper, plan_within_torques

Array = NDArray[np.float64]

FADE_TIME: Final = 0.05
"""Seconds in which the torques go over from one model or controller to the next."""

SPEED_RESERVE: Final = 0.8
"""Fraction of a module's speed that planned motions use; beyond, the voltage limits its torque."""

TORQUE_RESERVE: Final = 0.9
"""Fraction of a module's torque that planned motions use; the rest is for control."""

ACCELERATION: Final = 25.0
"""rad/s^2: the largest acceleration of a planned motion; torque usually allows less."""

JERK_TIME: Final = 0.12
"""Seconds in which a planned motion builds up its full acceleration."""

SHAPING_TIME: Final = 0.05
"""Seconds over which setpoints are averaged."""

POSITION_TOLERANCE: Final = 0.005
"""Radians: a joint follows if it is that close to its setpoint."""

STANDSTILL: Final = 0.05
"""rad/s: a joint at rest is slower."""

RELAXATION_TIME: Final = 0.3
"""Seconds in which an arm that is held at both ends gives way."""

SHARING_TIME: Final = 0.4
"""Seconds in which a second base takes over half of the arm's weight."""

SETTLING_TIME: Final = 2.0
"""Seconds after its end that a motion may take to come within tolerance."""


class AssembledArm(ModularArm):
    """Moves the longest chain of servo modules that a base carries.

    The backend calls `control` at a fixed rate (250 to 500 Hz), all in the robot's thread. It reads the states of
    connectors again only when `revision` has changed, which counts attachments and releases of the whole cell.
    `base_pose` returns the pose of a base in the world, given its name; without it, bases stand where `cell` says.
    """

    def __init__(
        self,
        name: str,
        cell: CellSetup,
        servos: Mapping[str, ServoDrive],
        connectors: Sequence[VacuumConnector],
        *,
        revision: Callable[[], int],
        base_pose: Callable[[str], Pose] | None = None,
    ) -> None:
        self.name = name
        self._cell = cell
        self._servos = servos
        self._connectors = connectors
        self._count_changes = revision
        self._revision: int | None = None
        placed = {part.name: part.pose for part in cell.parts}
        self._base_pose = base_pose or placed.__getitem__
        self._controller = ArmController.MODEL
        self._order: tuple[str, ...] = ()
        self._error = ""
        self._motion: Motion | None = None
        self._law: ControlLaw | None = None
        self._fade = 0.0
        self._since_end = 0.0
        self._chain = Chain()
        none = np.zeros(0)
        self._setpoint = self._planned = Setpoint(none, none, none)
        self._shaper = Shaper(self._planned, 1)
        self._period = 0.002
        self._measured = Measured(none, none, none, none)
        self._last_torques = self._fade_from = none
        self._take(Chain())

    @property
    def chain(self) -> Chain:
        """The arm as it is assembled now."""
        return self._chain

    def state(self) -> ModularArmState:
        """Its joints and motion."""
        chain, at = self._chain, self._index
        readings = self._readings
        targets = self._motion.target if self._motion is not None else tuple(self._setpoint.q.tolist())
        return ModularArmState(
            base=chain.base,
            tip=chain.tip,
            joints=tuple(chain.joints[each] for each in at),
            parts=chain.parts,
            positions=tuple(readings[each].position for each in at),
            velocities=tuple(readings[each].velocity for each in at),
            efforts=tuple(readings[each].torque for each in at),
            targets=tuple(targets[each] for each in at),
            moving=self._motion is not None,
            controller=self._controller,
            payload=self._model.load_mass,
            tip_pose=self._tip_pose(),
            error=self._error,
        )

    def move(self, positions: Sequence[float], duration: float) -> None:
        """Move the joints; see `ModularArm.move`. With NaN as duration it takes as long as the limits demand."""
        error = self._refusal(positions, duration)
        if error:
            self._error = error
            return
        targets = list(self._motion.target if self._motion is not None else self._setpoint.q.tolist())
        for at, position in zip(self._index, positions, strict=True):
            if not math.isnan(position):
                targets[at] = float(position)
        try:
            motion = plan_within_torques(
                self._planned,
                targets,
                self._limits,
                self._torque_ratio,
                duration=0.0 if math.isnan(duration) else duration,
                shaping=SHAPING_TIME,
            )
        except MotionError as refusal:
            self._error = f"motion refused: {refusal}"
            return
        if self._motion is None:
            shaped = self._controller is ArmController.MODEL
            self._shaper = Shaper(self._planned, round(SHAPING_TIME / self._period) if shaped else 1)
        self._motion = motion
        self._error, self._since_end = "", 0.0

    def hold(self) -> None:
        """Brake along the present path, and hold all joints."""
        if self._motion is not None:
            self._motion.brake()

    def set_controller(self, controller: ArmController) -> None:
        """Select the controller of the joints; torques fade over from one controller to the other."""
        if controller is not self._controller:
            self._controller = controller
            self._law = None
            self._fade = 0.0

    def set_order(self, joints: Sequence[str]) -> None:
        """Fix the order of the joints by names; those that are not named follow in the order of the chain."""
        unknown = [name for name in joints if name not in self._servos]
        if unknown or len(set(joints)) != len(joints):
            problem = f"no servo module {unknown[0]!r}" if unknown else "a servo module is named twice"
            self._error = f"order of joints refused: {problem}; there are: {', '.join(sorted(self._servos))}"
            return
        self._order = tuple(joints)
        self._index = self._find_index()
        self._error = ""

    def control(self, now: float, dt: float) -> None:  # noqa: ARG002 - backends pass their time to all controllers
        """Command the servo modules for the next `dt` seconds."""
        revision = self._count_changes()
        if revision != self._revision:
            self._revision = revision
            self._follow_attachments()
        if not self._drives:
            return
        self._read(dt)
        self._period = dt
        setpoint = self._next_setpoint(dt)
        if self._payload is not None and all(self._powered):
            q, v, spring, _ = self._measured
            self._model.set_load(self._payload.update(q, v, spring, dt))
        if self._law is None:
            self._law = self._make_law(dt)
            self._law.take_over(self._last_torques, setpoint, self._measured)
        if isinstance(self._law, ModelLaw):
            self._law.bias = self._shared_load(dt)
        torques = self._law.torques(setpoint, self._measured, dt)
        if self._fade < FADE_TIME:
            if self._fade == 0.0:
                self._fade_from = self._last_torques
            self._fade += dt
            torques = self._fade_from + smooth_step(self._fade / FADE_TIME) * (torques - self._fade_from)
        torques = np.minimum(np.maximum(torques, -self._torque_limits), self._torque_limits)  # `clip` takes longer
        self._last_torques = torques
        for drive, reading, torque in zip(self._drives, self._readings, torques.tolist(), strict=True):
            if reading.powered:
                drive.set_torque(torque)

    def _follow_attachments(self) -> None:
        """Take the arm that is assembled now; joints that it had before keep setpoints and torques."""
        connected = attachments((each.name, each.state()) for each in self._connectors)
        chain = find_chain(self._cell, connected, self._chain.base)
        if chain != self._chain:
            self._take(chain)
            self._share_load(connected)

    def _share_load(self, connected: tuple[Attachment, ...]) -> None:
        """If the arm holds on to a second base, model it as that one carries it, too."""
        self._other, self._sharing = None, 0.0
        for connection in self._chain.held_by:
            other = find_chain(self._cell, connected, connection)
            if other.base == connection and set(other.joints) == set(self._chain.joints):
                self._other = ArmModel(self._cell, other)
                self._other.set_base(Transform.from_pose(self._base_pose(other.ground)))
                self._other_index = [self._chain.joints.index(name) for name in other.joints]
                return

    def _shared_load(self, dt: float) -> Array:
        """What to add to the torques so that each of two bases carries half of the arm: then either may let go."""
        q = self._measured.q
        if self._other is None:
            return np.zeros(len(q))
        self._sharing = min(1.0, self._sharing + dt / SHARING_TIME)
        carried = np.empty_like(q)
        carried[self._other_index] = self._other.gravity(q[self._other_index])
        return 0.5 * smooth_step(self._sharing) * (carried - self._model.gravity(q))

    def _take(self, chain: Chain) -> None:
        before, setpoint = self._chain, self._setpoint
        kept = {name: at for at, name in enumerate(before.joints)}
        for name, drive in self._servos.items():
            if name in kept and name not in chain.joints:
                drive.claim("")
                drive.hold()
        self._chain = chain
        self._drives = [self._servos[name] for name in chain.joints]
        self._readings = [drive.read() for drive in self._drives]
        self._data = [_servo_data(self._cell, name) for name in chain.joints]
        self._torque_limits = np.array([each.max_torque for each in self._data])
        self._rotors = np.array([each.rotor_inertia for each in self._data])
        self._dampings = np.array([each.damping for each in self._data])
        self._frictions = np.array([each.friction for each in self._data])
        self._limits = _limits(self._data)
        rows = [
            (float(setpoint.q[kept[name]]), float(setpoint.v[kept[name]]), float(setpoint.a[kept[name]]))
            if name in kept
            else (reading.position, reading.velocity, 0.0)
            for name, reading in zip(chain.joints, self._readings, strict=True)
        ]
        table = np.array(rows).reshape(len(rows), 3)
        spring = [
            float(self._measured.spring[kept[name]]) if name in kept else reading.torque
            for name, reading in zip(chain.joints, self._readings, strict=True)
        ]
        self._measured = Measured(table[:, 0], table[:, 1], np.array(spring), np.zeros(len(spring)))
        self._last_torques = np.array(
            [
                self._last_torques[kept[name]] if name in kept else reading.torque
                for name, reading in zip(chain.joints, self._readings, strict=True)
            ]
        )
        self._setpoint = Setpoint(table[:, 0].copy(), table[:, 1].copy(), table[:, 2].copy())
        if chain.joints != before.joints:
            self._planned = self._setpoint
        self._powered = [reading.powered for reading in self._readings]
        side = {name: self._servos[name].read().position for name in chain.side_joints}
        self._model = ArmModel(self._cell, chain, side)
        self._place_base()
        self._index = self._find_index()
        for drive in self._drives:
            drive.claim(self.name)
        if chain.joints != before.joints:
            if self._motion is not None and not self._motion.ended:
                self._error = "the motion ended early: modules were attached or released"
            if self._motion is not None or self._setpoint.v.any():
                self._come_to_rest()
        if chain.held_by and self._motion is not None:
            self._motion.brake()
        self._payload = PayloadEstimator(self._model, len(chain.joints)) if self._model.has_load else None
        self._law = None
        self._fade = 0.0

    def _make_law(self, dt: float) -> ControlLaw:
        if self._controller is ArmController.MODEL:
            return ModelLaw(self._model, self._data, dt)
        return PidLaw(self._data, [drive.gains()[0] for drive in self._drives])

    def _place_base(self) -> None:
        """Take the pose of the base, which turns gravity in its frame."""
        ground = self._chain.ground
        self._base = Transform.from_pose(self._base_pose(ground)) if ground else IDENTITY
        self._model.set_base(self._base)

    def _find_index(self) -> tuple[int, ...]:
        """The indices of the joints in the chain, in the order of commands and states."""
        joints = self._chain.joints
        named = [name for name in self._order if name in joints]
        return tuple(joints.index(name) for name in (*named, *(name for name in joints if name not in named)))

    def _read(self, dt: float) -> None:
        self._readings = [drive.read() for drive in self._drives]
        table = np.array([reading[1:] for reading in self._readings])
        q, v, spring = table[:, 0], table[:, 1], table[:, 2]
        self._measured = Measured(q, v, spring, (spring - self._measured.spring) / dt)
        powered = [reading.powered for reading in self._readings]
        if powered != self._powered:
            self._follow_power(powered)

    def _follow_power(self, powered: list[bool]) -> None:
        """Brake if a module has fallen silent in a motion; one that reports again holds where it is."""
        silent = [
            name
            for name, before, now in zip(self._chain.joints, self._powered, powered, strict=True)
            if before and not now
        ]
        back = np.array([now and not before for before, now in zip(self._powered, powered, strict=True)])
        self._powered = powered
        if silent and self._motion is not None:
            self._error = f"the motion ended early: no report of {', '.join(silent)}"
            self._motion.brake()
        elif back.any():
            self._come_to_rest()
        self._law = None
        self._fade = 0.0
        self._last_torques = np.where(powered, self._last_torques, self._measured.spring)

    def _come_to_rest(self) -> None:
        """Stop from the present setpoint, each joint independently."""
        self._motion, self._since_end = Motion(self._setpoint, None, self._limits), 0.0
        self._shaper = Shaper(self._setpoint, 1)

    def _next_setpoint(self, dt: float) -> Setpoint:
        setpoint, motion = self._setpoint, self._motion
        q, v = self._measured.q, self._measured.v
        if motion is not None:
            self._planned = motion.advance(dt)
            setpoint = self._shaper.advance(self._planned)
            if motion.ended and self._shaper.ended:
                self._since_end += dt
                self._end_motion(setpoint)
        if not all(self._powered):
            silent = ~np.array(self._powered)
            setpoint = Setpoint(
                np.where(silent, q, setpoint.q), np.where(silent, v, setpoint.v), np.where(silent, 0.0, setpoint.a)
            )
        if self._motion is None:
            if self._chain.held_by:
                # a closed loop: what its other end demands is followed, so that no force builds up between the ends
                part = min(1.0, dt / RELAXATION_TIME)
                setpoint = Setpoint(setpoint.q + part * (q - setpoint.q), setpoint.v, setpoint.a)
            self._planned = Setpoint(setpoint.q, np.zeros_like(q), np.zeros_like(q))
        self._setpoint = setpoint
        return setpoint

    def _end_motion(self, setpoint: Setpoint) -> None:
        """End the motion once the joints follow, or have had time enough."""
        q, v = self._measured.q, self._measured.v
        off = np.where(self._powered, np.abs(q - setpoint.q), 0.0)
        still = np.where(self._powered, np.abs(v), 0.0) < STANDSTILL
        if bool(np.all(off < POSITION_TOLERANCE)) and bool(np.all(still)):
            self._motion = None
        elif self._since_end > SETTLING_TIME:
            self._motion = None
            worst = int(np.argmax(off))
            if off[worst] >= POSITION_TOLERANCE and not self._error:
                self._error = (
                    f"{self._chain.joints[worst]} is {off[worst]:.3f} rad from its target {SETTLING_TIME:.0f} s after "
                    "the motion"
                )

    def _refusal(self, positions: Sequence[float], duration: float) -> str:
        """Why a motion is refused; empty if it is not."""
        names = [self._chain.joints[at] for at in self._index]
        if not names:
            return "motion refused: no servo module is attached to a base"
        if len(positions) != len(names):
            return f"motion refused: {len(positions)} positions for {len(names)} joints ({', '.join(names)})"
        if any(map(math.isinf, positions)):
            return "motion refused: a position is infinite"
        if math.isinf(duration) or duration < 0.0:
            return f"motion refused: a duration of {duration} s"
        if self._chain.held_by:
            return f"motion refused: the arm is also held by {', '.join(self._chain.held_by)}"
        silent = [
            name
            for name, at, position in zip(names, self._index, positions, strict=True)
            if not (self._powered[at] or math.isnan(position))
        ]
        return f"motion refused: no report of {', '.join(silent)}" if silent else ""

    def _torque_ratio(self, setpoint: Setpoint) -> float:
        """The largest torque that a setpoint demands of a motor, as a fraction of what planned motions may use."""
        links = self._model.inverse_dynamics(setpoint.q, setpoint.v, setpoint.a)
        rotors = self._rotors * setpoint.a + self._dampings * setpoint.v + self._frictions * np.sign(setpoint.v)
        return float(np.max(np.abs(links + rotors) / (TORQUE_RESERVE * self._torque_limits), initial=0.0))

    def _tip_pose(self) -> Pose:
        if self._chain.tip_body is None:
            return Pose()
        q = np.array([reading.position for reading in self._readings])
        return (self._base @ self._model.tip_pose(q)).to_pose()


def _servo_data(cell: CellSetup, name: str) -> ServoData:
    servo = cell.type_of(name).servo
    assert servo is not None
    return servo


def _limits(servos: Sequence[ServoData]) -> Limits:
    count = len(servos)
    speeds = tuple(SPEED_RESERVE * each.max_speed for each in servos)
    return Limits(speeds, (ACCELERATION,) * count, (ACCELERATION / JERK_TIME,) * count)
