"""Setpoints of the joints of a modular arm, along the motion in progress or at rest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.modular.arm import MotionResult
from jauspy.platform.modular.assembly import ArmAssembly, carried_over
from jauspy.platform.modular.control_laws import JointMeasurements
from jauspy.platform.modular.servo import ServoReading
from jauspy.platform.modular.splines import Knots, Spline
from jauspy.platform.modular.trajectory import (
    Motion,
    MotionError,
    PlannedMotion,
    Setpoint,
    Shaper,
    plan_within_torques,
)

Array = NDArray[np.float64]

SHAPING_TIME: Final = 0.05
"""Seconds over which setpoints are averaged."""

POSITION_TOLERANCE: Final = 0.005
"""Radians: a joint follows if it is that close to its setpoint."""

STANDSTILL: Final = 0.05
"""rad/s: a joint at rest is slower."""

RELAXATION_TIME: Final = 0.3
"""Seconds in which an arm that is held at both ends gives way."""

YIELDING_TIME: Final = 1.0
"""Seconds after a contact in which an arm follows what pushes it."""

COMPLIANCE: Final = 4.0
"""rad/s of a joint that gives way to the whole torque of its module."""

YIELDING_SPEED: Final = 0.4
"""rad/s at most while it gives way."""

SETTLING_TIME: Final = 2.0
"""Seconds after its end that a motion may take to come within tolerance."""


class ArmSetpoints:
    """Plans motions, plays them, and ends them once the joints have come to rest at their targets.

    Vectors are in the order of the assembly's chain.
    """

    def __init__(self, assembly: ArmAssembly, readings: Sequence[ServoReading] = ()) -> None:
        """Rest where the joints of `assembly` are."""
        self.setpoint = _at_readings(readings)
        """The last setpoint, averaged by the shaper."""
        self.error = ""
        """Reason why the last motion ended early or was not begun; empty after a success."""
        self.result = MotionResult.UNKNOWN
        """Result of the last motion."""
        self._assembly = assembly
        self._planned = self.setpoint
        self._motion: Motion | None = None
        self._yielding = 0.0
        """Seconds left in which the setpoint follows what is measured, after a contact."""
        self._compliance = 0.0
        self._shaper = Shaper(self._planned, 1)
        self._since_end = 0.0
        self._period = 0.002

    @property
    def moving(self) -> bool:
        """True while a motion is in progress, or joints have not come to rest after it."""
        return self._motion is not None

    @property
    def targets(self) -> tuple[float, ...]:
        """Positions (rad) at the end of the motion in progress; without one those of the setpoint."""
        return self._motion.target if self._motion is not None else tuple(self.setpoint.q.tolist())

    def begin(self, targets: Sequence[float], duration: float, *, shaped: bool) -> None:
        """Begin a motion to `targets` (rad) from the present setpoint; `error` says why if limits do not allow it.

        With 0 seconds as `duration` it takes as long as the limits demand. `shaped` averages setpoints over
        `SHAPING_TIME`, if no motion is in progress.
        """
        plan = plan_within_torques
        limits, ratio = self._assembly.limits, self._assembly.torque_ratio
        try:
            motion = plan(self._planned, targets, limits, ratio, duration=duration, shaping=SHAPING_TIME)
        except MotionError as refusal:
            self.refuse(str(refusal))
            return
        self._play(motion, shaped=shaped)

    def begin_spline(self, knots: Knots, *, shaped: bool) -> None:
        """Begin a motion through points from the present setpoint; `error` says why if limits do not allow it."""
        assembly = self._assembly
        try:
            spline = Spline(self._planned, knots)
            allowed = assembly.planned_torques.tolist()
            spline.check(assembly.chain.joints, assembly.limits, assembly.motor_torques, allowed)
        except MotionError as refusal:
            self.refuse(str(refusal))
            return
        self._play(Motion(spline, knots.positions[-1].tolist(), assembly.limits), shaped=shaped)

    def _play(self, motion: Motion, *, shaped: bool) -> None:
        if self._motion is None:
            self._shaper = Shaper(self._planned, round(SHAPING_TIME / self._period) if shaped else 1)
        self._motion = motion
        self._yielding = 0.0
        self.error, self.result, self._since_end = "", MotionResult.IN_PROGRESS, 0.0

    def refuse(self, reason: str) -> None:
        """Begin no motion for a reason, and hold."""
        self.brake()
        self.error, self.result = f"motion refused: {reason}", MotionResult.REFUSED

    def fail(self, reason: str) -> None:
        """End the motion in progress early for a reason; the setpoint goes on until it is told to brake or to rest."""
        self.error, self.result = reason, MotionResult.FAILED

    def brake(self) -> None:
        """Brake along the path of the motion in progress."""
        if self._motion is not None:
            self._motion.brake()
        if self.result is MotionResult.IN_PROGRESS:
            self.result = MotionResult.STOPPED

    def block(self, reason: str, measured: JointMeasurements, *, gives_way: bool) -> None:
        """End the motion in progress where the joints are, because something is in the way.

        Then the setpoint follows the joints, so that the torque at the contact falls; with `gives_way` it also moves
        the way that the contact pushes.
        """
        self.error, self.result = reason, MotionResult.BLOCKED
        self._motion = None
        rest = np.zeros_like(measured.q)
        self.setpoint = self._planned = Setpoint(measured.q.copy(), rest, rest)
        self._yielding, self._compliance = YIELDING_TIME, COMPLIANCE if gives_way else 0.0

    def come_to_rest(self) -> None:
        """Stop from the present setpoint, each joint independently."""
        self._motion, self._since_end = PlannedMotion(self.setpoint, None, self._assembly.limits), 0.0
        self._shaper = Shaper(self.setpoint, 1)

    def adopt(self, assembly: ArmAssembly, readings: Sequence[ServoReading]) -> None:
        """Go on with another assembly: joints that both have keep setpoints, new ones begin at their readings.

        A motion ends early if the joints are others; it brakes if the arm is a closed loop now.
        """
        before, after = self._assembly.chain.joints, assembly.chain.joints
        self._assembly = assembly
        initial = _at_readings(readings)
        self.setpoint = Setpoint(
            *(carried_over(before, after, *vectors) for vectors in zip(self.setpoint, initial, strict=True))
        )
        if after != before:
            self._planned = self.setpoint
            if self._motion is not None and not self._motion.ended:
                self.fail("the motion ended early: modules were attached or released")
            if self._motion is not None or self.setpoint.v.any():
                self.come_to_rest()
        if assembly.chain.held_by:
            self.brake()

    def advance(self, measured: JointMeasurements, powered: Sequence[bool], dt: float) -> Setpoint:
        """The setpoint after another `dt` seconds. Those of modules without power follow what is measured."""
        self._period = dt
        setpoint, motion = self.setpoint, self._motion
        if motion is not None:
            self._planned = motion.advance(dt)
            setpoint = self._shaper.advance(self._planned)
            if motion.ended and self._shaper.ended:
                self._since_end += dt
                self._end_motion(setpoint, measured, powered)
        if not all(powered):
            silent = ~np.array(powered)
            setpoint = Setpoint(
                np.where(silent, measured.q, setpoint.q),
                np.where(silent, measured.v, setpoint.v),
                np.where(silent, 0.0, setpoint.a),
            )
        if self._motion is None:
            if self._assembly.chain.held_by:
                # a closed loop: what its other end demands is followed, so that no force builds up between the ends
                part = min(1.0, dt / RELAXATION_TIME)
                setpoint = Setpoint(setpoint.q + part * (measured.q - setpoint.q), setpoint.v, setpoint.a)
            elif self._yielding > 0.0:
                self._yielding -= dt
                setpoint = self._yield(setpoint, measured, dt)
            rest = np.zeros_like(measured.q)
            self._planned = Setpoint(setpoint.q, rest, rest)
        self.setpoint = setpoint
        return setpoint

    def _yield(self, setpoint: Setpoint, measured: JointMeasurements, dt: float) -> Setpoint:
        """The setpoint of an arm that has met something."""
        pushed = self._assembly.contact.external * (self._compliance / self._assembly.torque_limits)
        fastest = float(np.abs(pushed).max(initial=0.0))
        velocity = pushed * (min(1.0, YIELDING_SPEED / max(fastest, 1e-9)) if self._yielding > 0.0 else 0.0)
        part = min(1.0, dt / RELAXATION_TIME)
        return Setpoint(setpoint.q + part * (measured.q - setpoint.q) + dt * velocity, velocity, setpoint.a)

    def _end_motion(self, setpoint: Setpoint, measured: JointMeasurements, powered: Sequence[bool]) -> None:
        """End the motion once the joints follow, or have had time enough."""
        errors = np.where(powered, np.abs(measured.q - setpoint.q), 0.0)
        speeds = np.where(powered, np.abs(measured.v), 0.0)
        if bool(np.all(errors < POSITION_TOLERANCE)) and bool(np.all(speeds < STANDSTILL)):
            self._motion = None
            if self.result is MotionResult.IN_PROGRESS:
                self.result = MotionResult.REACHED
        elif self._since_end > SETTLING_TIME:
            self._motion = None
            if self.result is not MotionResult.IN_PROGRESS:
                return
            worst = int(np.argmax(errors))
            name = self._assembly.chain.joints[worst]
            if errors[worst] >= POSITION_TOLERANCE:
                self.fail(f"{name} is {errors[worst]:.3f} rad from its target {SETTLING_TIME:.0f} s after the motion")
            else:
                self.result = MotionResult.REACHED


def _at_readings(readings: Sequence[ServoReading]) -> Setpoint:
    positions = [reading.position for reading in readings]
    velocities = [reading.velocity for reading in readings]
    return Setpoint(np.array(positions, dtype=float), np.array(velocities, dtype=float), np.zeros(len(readings)))
