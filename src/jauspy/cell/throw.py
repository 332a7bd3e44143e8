"""The plan of a throw: wind-up, release and follow-through of a modular arm, within limits and clear of all else.

The arm moves straight in joint space, by the same trajectory that its controller plans for a command with a duration.
The box is released where the range of its flight is largest along the motion: there a small error of time changes the
range least. The motion's duration, and so its speed, sets the range.

A box rests where it lands only if it comes down almost flat, its leading edge a little lower, and not too flat a curve:
friction then stops it within the impact. One that lands on its trailing edge tumbles forward; one that lands on a
corner turns, and goes to the side. Both are part of the search's cost.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from operator import attrgetter
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.arm_loads import strengths, utilisations
from jauspy.cell.frames import Array
from jauspy.cell.modular_arm import BASE, Chain
from jauspy.cell.motion import NoPath
from jauspy.cell.scene import CLEAR, Clearance, Piece, PlanningScene
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.arm_setpoints import SHAPING_TIME
from jauspy.platform.modular.assembly import TORQUE_RESERVE, motion_limits
from jauspy.platform.modular.dynamics import solid_inertia
from jauspy.platform.modular.holding import SAFETY
from jauspy.platform.modular.parts import ConnectorLimits, ServoData
from jauspy.platform.modular.trajectory import Limits, MotionError, PlannedMotion, Setpoint

PERIOD: Final = 0.008
"""Seconds from one sample of a planned motion to the next."""
MARGIN: Final = 0.02
"""Metres from everything, for the arm, the box that it holds, and the box in flight."""
NARROW: Final = 0.015
"""The same where a search ends with no throw that keeps `MARGIN`."""
DRAWN: Final = 20_000
STARTS: Final = 12
STEPS: Final = 150
RESTARTS: Final = 8
FIRST_WIDTH: Final = 0.1
NEAR: Final = 0.03
"""Throws that are drawn at random, those of them that are planned, the most that are tried from the best of these on,
how often all that is done, and the width of the first steps from random throws and from an earlier one."""
LEANING: Final = 0.042
"""Radians by which a box leans forward when it lands. In simulations of boxes with their longer side ahead, whose
attitude differs by chance (`tools/landings.py`), from 0.02 to 0.1 nine of ten come to rest within 14 mm of the same
place; those that lean back tumble."""
SLIDE: Final = 0.012
"""Metres that such a box comes to rest beyond its landing, in the same simulations."""
STEEPNESS: Final = 0.6
"""Horizontal over vertical speed at the landing that friction takes in the impact: the friction of cardboard."""
GOOD: Final = 0.1
"""Cost from which on a throw is not improved."""
SPACIOUS: Final = 0.03
"""Metres of clearance from which on more is no better: a throw that is turned to another aim has some left."""
AIMING_STEPS: Final = 10
AIMED: Final = 0.001
LEVEL: Final = 0.003
LARGEST_STEP: Final = 0.4
"""Corrections of a motion, at most; the metres from the aim and radians from `LEANING` at which they end; and the
largest change of the logarithm of its duration, and of a joint (rad), in each."""
COARSE: Final = 6
FINE: Final = 1
"""Samples of a motion from one to the next at which the release is searched, at first and then."""
PROBE: Final = 0.02
"""Radians by which the joint before the last is turned to find what that changes."""
SHORT: Final = 0.1
"""Metres by which the fastest throw may be too short while its box is not level yet."""
LIFT_OFF: Final = 1.5
PARTING: Final = 6
"""m/s^2 with which the tip moves away from the box at least, and for how many samples from the release on: what the
cup still touches is pushed, and spins."""
_DISTANCE: Final = attrgetter("distance")
BOUNDS: Final = np.array(
    [(-0.6, 0.8), (-1.2, 0.5), (-0.7, 0.7), (0.6, 1.0), (0.6, 1.0), (0.5, 1.0), (0.3, 0.9), (0.3, 0.9)]
)
"""Ranges of what is searched, those of a throw over the shoulder: radians of the three joints that bend at the release
(0 is upright), the fractions of their speeds there, and the seconds at these speeds from the wind-up to the release and
from there to the end."""


@dataclass(frozen=True, slots=True)
class Load:
    """A box on the tip."""

    mass: float
    """Kilograms."""
    size: tuple[float, float, float]
    """Metres, in the box's frame."""
    frame: pin.SE3
    """The frame of its middle in that of the tip."""


@dataclass(frozen=True, slots=True)
class SampledMotion:
    """Setpoints of a motion every `PERIOD`: rad, rad/s, rad/s^2; shape (samples, joints)."""

    q: Array
    v: Array
    a: Array
    duration: float


@dataclass(frozen=True, slots=True)
class Flight:
    """A box from its release to the floor, in the world."""

    start: pin.SE3
    velocity: Array
    spin: Array
    time: float
    """Seconds until a corner touches the floor."""

    def at(self, time: float) -> pin.SE3:
        """The middle of the box `time` seconds after the release."""
        fall = np.array([0.0, 0.0, -0.5 * GRAVITY * time * time])
        return pin.SE3(
            pin.exp3(self.spin * time) @ self.start.rotation, self.start.translation + self.velocity * time + fall
        )

    @property
    def end(self) -> Array:
        """The middle of the box when it lands, metres."""
        return np.array(self.at(self.time).translation)

    @property
    def rest(self) -> Array:
        """The middle of the box when it has come to rest, if it does not tumble: x and y, metres."""
        return np.asarray(self.end[:2] + SLIDE * self._forward)

    @property
    def _forward(self) -> Array:
        return np.asarray(self.velocity[:2] / np.linalg.norm(self.velocity[:2]))

    @property
    def lean(self) -> tuple[float, float]:
        """Radians at the landing by which the box leans forward along its flight, and to the left of it."""
        rotation = self.at(self.time).rotation
        axis = int(np.argmax(np.abs(rotation[2])))
        up = rotation[:, axis] * math.copysign(1.0, rotation[2, axis])
        forward = self._forward
        ahead, left = float(up[:2] @ forward), float(up[1] * forward[0] - up[0] * forward[1])
        return math.atan2(ahead, up[2]), math.atan2(left, up[2])

    @property
    def steepness(self) -> float:
        """Horizontal over vertical speed at the landing."""
        return math.hypot(*self.velocity[:2].tolist()) / abs(float(self.velocity[2]) - GRAVITY * self.time)


@dataclass(frozen=True, slots=True)
class ThrowPlan:
    """A throw, and what was planned for it."""

    windup: Array
    follow_through: Array
    duration: float
    """Seconds of the motion as it is commanded."""
    release: float
    """Seconds after the begin of the motion."""
    flight: Flight
    clearance: Clearance
    speed_ratio: float
    torque_ratio: float
    """Largest speed and torque of a servo as a fraction of its limit."""
    loads: Mapping[str, float]
    """Largest load of each connection over its strength."""
    row: Array = field(default_factory=lambda: np.zeros(0))
    """The throw as the search has it; see `BOUNDS`."""

    @property
    def utilisation(self) -> float:
        """Largest load of a connection over its strength."""
        return max(self.loads.values())


def motion(start: Array, goal: Array, limits: Limits, duration: float = 0.0) -> SampledMotion:
    """The setpoints that the arm's controller makes of a command; raises `MotionError` if that is too short."""
    rest = np.zeros_like(start)
    planned = PlannedMotion(Setpoint(start, rest, rest), goal.tolist(), limits, duration, SHAPING_TIME)
    window = round(SHAPING_TIME / PERIOD)
    rows = [
        np.concatenate(planned.sample(min(number * PERIOD, planned.duration)))
        for number in range(1, math.ceil(planned.duration / PERIOD) + 1)
    ]
    first, last = np.concatenate([start, rest, rest]), np.concatenate([goal, rest, rest])
    table = np.vstack([np.tile(first, (window, 1)), *[row[np.newaxis] for row in rows], np.tile(last, (window, 1))])
    sums = np.cumsum(table, axis=0)
    mean = (sums[window:] - sums[:-window]) / window
    count = len(start)
    return SampledMotion(
        mean[:, :count], mean[:, count : 2 * count], mean[:, 2 * count :], planned.duration + SHAPING_TIME
    )


def _servos(chain: Chain) -> list[ServoData]:
    return [member.type.servo for member in chain.members if member.type.servo is not None]


def arm_limits(chain: Chain) -> Limits:
    """The limits of planned motions, of all joints of an arm."""
    return motion_limits(_servos(chain))


def fall_time(rise: float, drop: float) -> float:
    """Seconds until what rises at `rise` m/s is `drop` metres below where it is."""
    return (rise + math.sqrt(max(0.0, rise * rise + 2.0 * GRAVITY * drop))) / GRAVITY


def flight_state(chain: Chain, load: Load, q: Array, v: Array) -> Flight:
    """The flight of a box that the tip lets go in a state of the joints, without its end."""
    tip = chain.forward(q)
    jacobian = pin.computeFrameJacobian(chain.model, chain.data, q, chain.tool, pin.LOCAL_WORLD_ALIGNED)
    spin = jacobian[3:] @ v
    box = tip * load.frame
    velocity = jacobian[:3] @ v + pin.skew(spin) @ (box.translation - tip.translation)
    return Flight(box, velocity, spin, 0.0)


def flight(chain: Chain, load: Load, q: Array, v: Array) -> Flight:
    """The flight of a box that the tip lets go in a state of the joints, until a corner touches the floor."""
    found = flight_state(chain, load, q, v)
    half = np.array(load.size) / 2.0
    # the lowest corner lies between a flat and an upright box: from the former on, steps of a millisecond
    drop = float(found.start.translation[2] - np.linalg.norm(half))
    time = max(0.0, fall_time(float(found.velocity[2]), drop))
    while time < 3.0:
        pose = found.at(time)
        if pose.translation[2] - float(np.abs(pose.rotation[2]) @ half) <= 0.0:
            break
        time += 0.001
    return replace(found, time=time)


class ThrowPlanner:
    """Plans throws of one box with an arm that bends in a plane, which its first joint turns."""

    def __init__(
        self,
        chain: Chain,
        scene: PlanningScene,
        load: Load,
        pieces: Sequence[Piece],
        limits: ConnectorLimits,
        *,
        seed: int = 0,
    ) -> None:
        self.chain, self.scene, self.load = chain, scene, load
        self._pieces = pieces
        """Shapes of the box, in the frame of its middle."""
        self._strengths, self._suction = strengths(chain, limits), limits.strength(latched=False)
        """What the connections of the arm bear, and the cup that holds the box."""
        self.servos = _servos(chain)
        self.limits = arm_limits(chain)
        self._seed = seed
        along = load.frame.rotation[:, 0]
        self._roll = math.remainder(-math.atan2(along[1], along[0]), math.pi)
        """Position of the last joint that has the box level along the throw, however it was taken."""
        upright = chain.forward(np.append(np.zeros(chain.model.nq - 1), self._roll)) * load.frame
        self._beside = float((upright.translation - chain.root)[1])
        """Metres by which the box is to the left of the plane in which the arm bends."""
        self._dynamics = chain.model.copy()
        x, y, z = load.size
        self._box = pin.Inertia.FromBox(load.mass, x, y, z)
        frame = chain.model.frames[chain.tool].placement * load.frame
        self._dynamics.appendBodyToJoint(chain.model.njoints - 1, self._box, frame)
        self._data = self._dynamics.createData()
        first = chain.members[0]
        self._base = chain.base
        weight = sum((solid_inertia(solid) for solid in first.type.solids), pin.Inertia.Zero())
        frame = chain.base * first.offset
        self._foot = frame.act(weight) * pin.Motion(np.array([0.0, 0.0, GRAVITY]), np.zeros(3))
        """What the first part, which stands still, weighs on what it stands on."""

    # --- planning -------------------------------------------------------------------------------------------------

    def plan(self, aim: Array, like: ThrowPlan | None = None) -> ThrowPlan:
        """A throw whose box rests at `aim`, metres in the world, found by random search and then step by step.

        The search begins at `like`, an earlier throw, if there is one. It ends with the first best throw that keeps all
        limits, since another search takes 15 s of CPU time. Raises `NoPath`, which names what the best one violates.
        """
        random = np.random.default_rng(self._seed)
        best: _Trial | None = None
        if like is not None:
            best = self._improved(random, self._tried(like.row, aim), aim, NEAR)
            if best.plan is not None:
                return best.plan
        for _ in range(RESTARTS):
            found = self._climb(random, aim)
            best = found if best is None or found.penalty < best.penalty else best
            if best.plan is not None:
                return best.plan
        raise NoPath(f"no throw found: the best one is {best.problem if best is not None else 'too short'}")

    def _climb(self, random: np.random.Generator, aim: Array) -> _Trial:
        """The best of random throws, improved by steps whose width follows their success."""
        low, high = BOUNDS.T
        rows = random.uniform(low, high, (DRAWN, len(low)))
        sketched = sorted((self._sketched(row, aim), number) for number, row in enumerate(rows))[:STARTS]
        best = min((self._tried(rows[number], aim) for _, number in sketched), key=_penalty)
        return self._improved(random, best, aim, FIRST_WIDTH)

    def _improved(self, random: np.random.Generator, best: _Trial, aim: Array, width: float) -> _Trial:
        """A throw, improved by random steps of this width at first, a fraction of the ranges."""
        low, high = BOUNDS.T
        for _ in range(STEPS):
            if best.penalty < GOOD:
                break
            row = np.clip(best.row + width * (high - low) * random.normal(size=len(low)), low, high)
            found = self._tried(row, aim)
            better = found.penalty < best.penalty
            best, width = (found, min(0.2, 1.5 * width)) if better else (best, max(0.005, 0.95 * width))
        return best

    def _sketched(self, row: Array, aim: Array) -> float:
        """The penalty of a throw by the flight from its posture alone, before its motion is planned."""
        far = self._far(aim)
        q, speed = self._posture(row, aim)
        speed /= np.max(speed / self.limits.velocity)
        most = self._range(q, speed, aim)
        if most < far:
            return 10.0 + far - most
        low, high = 0.3, 1.0
        for _ in range(8):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if self._range(q, middle * speed, aim) > far else (middle, high)
        v = high * speed
        step = 0.02 * v
        change = (self._range(q + step, v, aim) - self._range(q - step, v, aim)) / 0.04
        thrown = flight(self.chain, self.load, q, v)
        return landing_cost(thrown) + abs(thrown.lean[0] - LEANING) + 0.3 * abs(change)

    def aimed(self, windup: Array, goal: Array, aim: Array) -> ThrowPlan:
        """A throw between two postures; raises `_Violation`, a `NoPath`.

        Its duration makes the box rest at `aim`. The joint before the last is turned so that it leans by `LEANING`.
        """
        far = self._far(aim)
        try:
            moved = fastest = motion(windup, goal, self.limits)
        except MotionError as error:
            raise _Violation("beyond the limits", 20.0) from error
        release = self._release(moved, aim)
        # Newton's method for range and lean; the slopes along the duration are improved as by Broyden
        turned, probe = np.zeros(len(windup)), np.zeros(len(windup))
        probe[-2] = PROBE
        slopes = np.diag([-far, 1.0])
        step, off = np.zeros(2), np.zeros(2)
        for count in range(AIMING_STEPS):
            if moved is fastest and release.range < far - SHORT * 0.5**count:
                break
            thrown = flight(self.chain, self.load, release.q, release.v)
            before, off = off, np.array([release.range - far, thrown.lean[0] - LEANING])
            if abs(off[0]) < AIMED and abs(off[1]) < LEVEL:
                return self.checked(windup + turned, goal + turned, moved, release.sample, thrown)
            if count and abs(step[0]) > 1e-6:
                slopes[:, 0] = (off - before - slopes[:, 1] * step[1]) / step[0]
            near = self._release(replace(moved, q=moved.q + probe), aim)
            lean = flight(self.chain, self.load, near.q, near.v).lean[0]
            slopes[:, 1] = (near.range - release.range) / PROBE, (lean - thrown.lean[0]) / PROBE
            step = np.clip(np.linalg.lstsq(slopes, -off, rcond=1e-6)[0], -LARGEST_STEP, LARGEST_STEP)
            step[0] = max(step[0], math.log(fastest.duration / moved.duration))
            turned[-2] += step[1]
            longer = moved.duration * math.exp(step[0])
            fastest = replace(fastest, q=fastest.q + step[1] * probe / PROBE)
            moved = fastest
            if longer > fastest.duration:
                moved = motion(windup + turned, goal + turned, self.limits, longer)
            release = self._release(moved, aim)
        short = abs(far - release.range)
        raise _Violation(f"{short:.3f} m off", 10.0 + short)

    def turned(self, plan: ThrowPlan, aim: Array) -> ThrowPlan:
        """The same throw, turned to and timed for another aim; raises `NoPath` if that breaks a limit, or `MARGIN`."""
        windup, goal = plan.windup.copy(), plan.follow_through.copy()
        windup[0] = goal[0] = self._heading(aim)
        windup[-1] = goal[-1] = self._roll
        found = self.aimed(windup, goal, aim)
        if found.clearance.distance < MARGIN:
            raise NoPath(f"it would pass {_near(found.clearance)}")
        return replace(found, row=plan.row)

    def checked(self, windup: Array, goal: Array, moved: SampledMotion, release: float, thrown: Flight) -> ThrowPlan:
        """The plan of a motion released at a sample, with a fraction; raises `NoPath` if a limit is broken."""
        speeds = np.array([servo.max_speed for servo in self.servos])
        speed = float(np.max(np.abs(moved.v) / speeds))
        if speed > 1.0:
            raise _Violation("too fast for a servo", 9.0)
        torque, loads = self.loads(moved, math.ceil(release))
        load = max(loads.values())
        excess = max(0.0, torque - TORQUE_RESERVE) + max(0.0, load - 1.0 / SAFETY)
        if excess > 0.0:
            raise _Violation(f"at {torque:.2f} of the torques and {load:.2f} of the strengths", 2.0 + excess)
        first = math.floor(release)
        after = zip(*(rows[first : first + PARTING] for rows in (moved.q, moved.v, moved.a)), strict=True)
        push = max(float(self._cup(*state).linear[2]) for state in after) / self.load.mass
        if push > -LIFT_OFF:
            penalty = 1.0 + MARGIN + 0.05 * (push + LIFT_OFF)
            raise _Violation(f"the box would leave the cup at {-push:.1f} m/s^2", penalty)
        clearance = self._clearance(moved, math.ceil(release), thrown)
        if clearance.distance < NARROW:
            raise _Violation(_near(clearance), 1.0 + MARGIN - clearance.distance)
        return ThrowPlan(
            windup, goal, moved.duration, (release + 1.0) * PERIOD, thrown, clearance, speed, torque, loads
        )

    def loads(self, moved: SampledMotion, index: int) -> tuple[float, dict[str, float]]:
        """The largest torque of a servo over its limit in a motion, and the largest load of each connection.

        The loads are fractions of the strengths, by connector; `BASE` is what the arm stands on.
        """
        torque = 0.0
        rotor = np.array([servo.rotor_inertia for servo in self.servos])
        damping = np.array([servo.damping for servo in self.servos])
        friction = np.array([servo.friction for servo in self.servos])
        most = np.array([servo.max_torque for servo in self.servos])
        model, data = self._dynamics, self._data
        mounts, cup = self.chain.mounts[:-1], [0.0]
        wrenches = np.empty((len(moved.q), len(mounts) + 1, 6))
        for number in range(len(moved.q)):
            q, v, a = moved.q[number], moved.v[number], moved.a[number]
            held = number <= index
            if not held and model is self._dynamics:
                model, data = self.chain.model, self.chain.data
            torques = pin.rnea(model, data, q, v, a) + rotor * a + damping * v + friction * np.sign(v)
            torque = max(torque, float(np.max(np.abs(torques) / most)))
            wrenches[number, 0] = self._base.actInv(data.liMi[1].act(data.f[1]) + self._foot)
            for row, (_, joint, frame) in enumerate(mounts, 1):
                wrenches[number, row] = frame.actInv(data.f[joint])
            if held:
                wrench = self._cup(q, v, a)
                cup.append(self._suction.utilisation(wrench.linear.tolist(), wrench.angular.tolist()))
        used = utilisations(wrenches, self._strengths)
        names = (BASE, *(name for name, _, _ in self.chain.mounts))
        return torque, dict(zip(names, (*used, max(cup)), strict=True))

    # --- inside ---------------------------------------------------------------------------------------------------

    def _tried(self, row: Array, aim: Array) -> _Trial:
        """The throw of one row of `BOUNDS`."""
        release, speed = self._posture(row, aim)
        try:
            plan = self.aimed(release - row[6] * speed, release + row[7] * speed, aim)
        except _Violation as found:
            return _Trial(row, found.penalty, None, str(found))
        return _Trial(row, _cost(plan), replace(plan, row=row), "")

    def _posture(self, row: Array, aim: Array) -> tuple[Array, Array]:
        """Positions (rad) and velocities (rad/s) at the release of a row of `BOUNDS`."""
        positions = np.array([self._heading(aim), *row[:3], self._roll])
        return positions, np.array([0.0, *row[3:6], 0.0]) * self.limits.velocity

    def _heading(self, aim: Array) -> float:
        """Position of the first joint, radians, at which the box flies over `aim`."""
        x, y, _ = aim - self.chain.root
        return math.atan2(y, x) - math.asin(self._beside / math.hypot(x, y))

    def _far(self, aim: Array) -> float:
        """Metres from the arm's base to the landing of a box that rests at `aim`."""
        return float(np.linalg.norm(aim[:2] - self.chain.root[:2])) - SLIDE

    def _range(self, q: Array, v: Array, aim: Array) -> float:
        """Metres from the arm's base to the landing, along the direction of the aim."""
        away = aim[:2] - self.chain.root[:2]
        return float((self._landing(q, v) - self.chain.root[:2]) @ away / np.linalg.norm(away))

    def _release(self, moved: SampledMotion, aim: Array) -> _Release:
        """The moment of a motion with the longest flight towards `aim`."""
        best, most = 0, -math.inf
        for number in range(len(moved.q) // 5, len(moved.q), COARSE):
            if (far := self._range(moved.q[number], moved.v[number], aim)) > most:
                best, most = number, far
        ranges = {
            number: self._range(moved.q[number], moved.v[number], aim)
            for number in range(max(0, best - COARSE), min(len(moved.q), best + COARSE + 1), FINE)
        }
        best = max(ranges, key=ranges.__getitem__)
        before, here, after = ranges.get(best - FINE, 0.0), ranges[best], ranges.get(best + FINE, 0.0)
        # between samples: the top of the parabola through three of them
        bend = before - 2.0 * here + after
        later = 0.5 * FINE * (before - after) / bend if bend < 0.0 else 0.0
        wait = later * PERIOD
        q, v = moved.q[best] + wait * moved.v[best], moved.v[best] + wait * moved.a[best]
        return _Release(best + later, q, v, self._range(q, v, aim))

    def _landing(self, q: Array, v: Array) -> Array:
        """Where the middle of the box comes down to half of its height, x and y in metres."""
        here = flight_state(self.chain, self.load, q, v)
        time = fall_time(float(here.velocity[2]), float(here.start.translation[2]) - self.load.size[2] / 2.0)
        return np.array(here.start.translation[:2] + here.velocity[:2] * time)

    def _cup(self, q: Array, v: Array, a: Array) -> pin.Force:
        """The force and moment that the tip exerts on the box while it holds it, in the tip's frame."""
        model, data, tool = self._dynamics, self._data, self.chain.tool
        pin.forwardKinematics(model, data, q, v, a)
        pin.updateFramePlacement(model, data, tool)
        acceleration = pin.getFrameAcceleration(model, data, tool, pin.LOCAL)
        velocity = pin.getFrameVelocity(model, data, tool, pin.LOCAL)
        up = data.oMf[tool].rotation.T @ np.array([0.0, 0.0, GRAVITY])
        acceleration = pin.Motion(acceleration.linear + up, acceleration.angular)
        box = self.load.frame.act(self._box)
        return box * acceleration + velocity.cross(box * velocity)

    def _clearance(self, moved: SampledMotion, index: int, thrown: Flight) -> Clearance:
        best, held = CLEAR, self.scene.held
        try:
            for number in range(0, len(moved.q), 2):
                if number > index:
                    self.scene.release()
                here = self.scene.clearance(moved.q[number], enough=best.distance)
                best = min(best, here, key=_DISTANCE)
        finally:
            self.scene.restore(held)
        # the end of the flight is the landing
        for time in np.arange(0.0, max(0.0, thrown.time - 0.06), 0.02).tolist():
            best = min(best, self.scene.clearance_of(self._pieces, thrown.at(time)), key=_DISTANCE)
        return best


class _Violation(NoPath):
    """A throw that breaks a limit; the smaller `penalty`, the closer it is to one that does not."""

    def __init__(self, problem: str, penalty: float) -> None:
        super().__init__(problem)
        self.penalty = penalty


@dataclass(frozen=True, slots=True)
class _Release:
    """A moment of a motion: number of the sample, with a fraction; rad, rad/s; metres to the landing from there."""

    sample: float
    q: Array
    v: Array
    range: float


@dataclass(frozen=True, slots=True)
class _Trial:
    row: Array
    penalty: float
    plan: ThrowPlan | None
    problem: str


def _penalty(trial: _Trial) -> float:
    return trial.penalty


def _near(clearance: Clearance) -> str:
    return f"{1000.0 * clearance.distance:.0f} mm from {' and '.join(clearance.between) or 'something'}"


def _cost(plan: ThrowPlan) -> float:
    """Below 1, the least penalty of a violation, where a throw keeps `MARGIN`."""
    if plan.clearance.distance < MARGIN:
        return 1.0 + MARGIN - plan.clearance.distance
    close = max(0.0, SPACIOUS - plan.clearance.distance)
    return 0.9 * math.tanh(landing_cost(plan.flight) + 10.0 * close)


def landing_cost(thrown: Flight) -> float:
    """How far a box that leans forward by `LEANING` may come to rest from where it lands, without unit; 0 is best."""
    return 3.0 * abs(thrown.lean[1]) + 2.0 * max(0.0, thrown.steepness - STEEPNESS)
