"""Loads of chains in motion: how fast a chain may go straight from one posture to another.

A connector on the output of a servo module is taken to carry that output, too.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

import numpy as np
import pinocchio as pin

from jauspy.cell.arm_loads import strengths
from jauspy.cell.frames import Array, se3
from jauspy.cell.modular_arm import Chain, Member
from jauspy.cell.motion import NoPath
from jauspy.cell.throw import SampledMotion, motion
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.modular.assembly import TORQUE_RESERVE, motion_limits
from jauspy.platform.modular.dynamics import solid_inertia
from jauspy.platform.modular.holding import SAFETY
from jauspy.platform.modular.parts import ConnectorLimits, PartType

STRETCH: Final = 1.3
"""Factor by which a motion is made slower while its loads are too large."""
STRETCHES: Final = 8
EVERY: Final = 3
"""Setpoints from one that is checked to the next: 12 ms."""


@dataclass(frozen=True, slots=True)
class TimedMotion:
    """A straight motion of the joints, and its largest loads as fractions of what modules and connectors bear."""

    duration: float
    """Seconds from its command to rest."""
    torque: float
    connector: float
    effort: float = 0.0
    """Newton metre seconds: torques of all motors over time, as CoBRA's `effort`."""
    energy: float = 0.0
    """Joules: mechanical power of all motors over time, as CoBRA's `mechEnergy`."""

    @property
    def bearable(self) -> bool:
        """True if it is within the limits that planned motions use."""
        return self.torque <= TORQUE_RESERVE and self.connector <= 1.0 / SAFETY


class LoadedChain:
    """A chain with a load at its tip, by the rigid-body dynamics of both."""

    def __init__(
        self, mount: pin.SE3, chain: Chain, limits: ConnectorLimits, mass: float = 0.0, height: float = 0.0
    ) -> None:
        """The chain on a connector at `mount`; `mass` in kilograms, its middle `height` metres beyond the tip."""
        self._chain, self._mass, self._arm = chain, mass, np.array([0.0, 0.0, height])
        self._suction = limits.strength(latched=False)
        holding = zip(
            [(0, mount), *((joint, frame) for _, joint, frame in chain.mounts[:-1])],
            strengths(chain, limits),
            strict=True,
        )
        held = [(joint, frame, strength) for (joint, frame), strength in holding]
        self._carried = [(joint, frame, strength) for joint, frame, strength in held if joint]
        self._feet = [(frame, strength) for joint, frame, strength in held if not joint]
        """Frames in the world of the connectors before the first joint, and their strengths."""
        self._foot = _foot_of(mount, chain)
        """Weight of the parts before the first joint, and its moment about the world's origin."""
        self._servos = [member.type.servo for member in chain.members if member.type.servo is not None]
        self._limits = motion_limits(self._servos)
        self._model = chain.model.copy()
        tool = chain.model.frames[chain.tool]
        if mass:
            point = pin.Inertia(mass, self._arm, np.zeros((3, 3)))
            self._model.appendBodyToJoint(tool.parentJoint, point, tool.placement)
        self._data = self._model.createData()
        self._rotor = np.array([servo.rotor_inertia for servo in self._servos])
        self._damping = np.array([servo.damping for servo in self._servos])
        self._friction = np.array([servo.friction for servo in self._servos])
        self._most = np.array([servo.max_torque for servo in self._servos])

    @classmethod
    def of(
        cls,
        mount: Transform,
        parts: Iterable[tuple[Transform, PartType]],
        mass: float,
        limits: ConnectorLimits,
        *,
        base_latch: bool = True,
    ) -> LoadedChain:
        """A chain that is not built; with each part, its frame in that of the connector that carries it.

        `base_latch`: the part that it stands on has a latch.
        """
        members = [
            Member(f"{number} {type.name}", type, se3(offset), next(iter(type.connectors)))
            for number, (offset, type) in enumerate(parts)
        ]
        return cls(se3(mount), Chain(se3(mount), members, base_latch=base_latch), limits, mass)

    def shortest(self, start: Array, goal: Array) -> TimedMotion:
        """The shortest motion that is bearable; raises `NoPath` when even a slow one is not."""
        duration = 0.0
        for _ in range(STRETCHES):
            moved = motion(start, goal, self._limits, duration)
            found = self.measured(moved)
            if found.bearable:
                return found
            duration = moved.duration * STRETCH
        raise NoPath(
            f"even in {duration:.1f} s it takes {found.torque:.0%} of a torque, {found.connector:.0%} of a connection"
        )

    def timed(self, start: Array, goal: Array, duration: float) -> TimedMotion:
        """The loads of a motion of a given duration; raises `MotionError` if the joints are not that fast."""
        return self.measured(motion(start, goal, self._limits, duration))

    def measured(self, moved: SampledMotion) -> TimedMotion:
        """The largest loads of a motion."""
        torque = connector = effort = energy = 0.0
        step = EVERY * moved.duration / len(moved.q)
        for number in range(0, len(moved.q), EVERY):
            torques, load = self._loads(moved.q[number], moved.v[number], moved.a[number])
            torque = max(torque, float(np.max(np.abs(torques) / self._most)))
            connector = max(connector, load)
            effort += step * float(np.sum(np.abs(torques)))
            energy += step * abs(float(torques @ moved.v[number]))
        return TimedMotion(moved.duration, torque, connector, effort, energy)

    def _loads(self, q: Array, v: Array, a: Array) -> tuple[Array, float]:
        """Torques of the motors, and the largest load of a connector over its strength."""
        model, data = self._model, self._data
        torques = pin.rnea(model, data, q, v, a)
        torques = torques + self._rotor * a + self._damping * v + self._friction * np.sign(v)
        wrenches = [(frame.actInv(data.f[joint]), strength) for joint, frame, strength in self._carried]
        carried = data.liMi[1].act(data.f[1]) + self._foot
        wrenches += [(frame.actInv(carried), strength) for frame, strength in self._feet]
        connector = max(strength.utilisation(w.linear.tolist(), w.angular.tolist()) for w, strength in wrenches)
        if self._mass:
            connector = max(connector, self._cup(q, v, a))
        return torques, connector

    def _cup(self, q: Array, v: Array, a: Array) -> float:
        """The load of the cup at the tip, which holds by suction alone."""
        model, data, tool = self._model, self._data, self._chain.tool
        pin.forwardKinematics(model, data, q, v, a)
        tip = pin.updateFramePlacement(model, data, tool)
        rotation = pin.getFrameVelocity(model, data, tool, pin.LOCAL).angular
        turning = pin.getFrameAcceleration(model, data, tool, pin.LOCAL).angular
        middle = pin.getFrameClassicalAcceleration(model, data, tool, pin.LOCAL).linear
        middle = middle + np.cross(turning, self._arm) + np.cross(rotation, np.cross(rotation, self._arm))
        force = self._mass * (middle + tip.rotation.T @ np.array([0.0, 0.0, GRAVITY]))
        return self._suction.utilisation(force.tolist(), np.cross(self._arm, force).tolist())


def _foot_of(mount: pin.SE3, chain: Chain) -> pin.Force:
    """The force in the world that carries the parts before the first joint."""
    found, frame = pin.Force.Zero(), mount
    for member in chain.members:
        frame = frame * member.offset
        for solid in member.type.solids:
            weight = solid_inertia(solid)
            force = np.array([0.0, 0.0, weight.mass * GRAVITY])
            found += pin.Force(force, np.cross(frame.act(weight.lever), force))
        if member.type.servo is not None:
            break
        frame = frame * se3(member.type.connectors[member.connector])
    return found
