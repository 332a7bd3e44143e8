"""Loads of the connections of a modular arm along planned motions, as fractions of their strengths."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array
from jauspy.cell.held_load import MOST, UP
from jauspy.platform.modular.holding import Holding
from jauspy.platform.modular.parts import ConnectorLimits

if TYPE_CHECKING:
    from jauspy.cell.modular_arm import Chain

SAMPLES: Final = 13
"""States of a motion at which loads are computed."""


@dataclass(frozen=True, slots=True)
class Used:
    """The most loaded connection of a motion."""

    fraction: float
    """Fraction of its strength that is used."""
    connector: str

    def __str__(self) -> str:
        return f"{self.connector} would use {self.fraction:.0%} of its strength, at most {MOST:.0%} is safe"


NOTHING: Final = Used(0.0, "")


def smooth_states(start: Array, goal: Array, duration: float) -> Iterable[tuple[Array, Array, Array]]:
    """Positions, velocities and accelerations of a motion of least jerk from rest to rest, which real ones resemble."""
    way = goal - start
    for s in np.linspace(0.0, 1.0, SAMPLES).tolist():
        place = s**3 * (10.0 - 15.0 * s + 6.0 * s * s)
        speed = 30.0 * s * s * (1.0 - s) ** 2 / duration
        change = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / duration**2
        yield start + place * way, speed * way, change * way


def sampled_states(times: Sequence[float], postures: Sequence[Array]) -> Iterable[tuple[Array, Array, Array]]:
    """The same of a trajectory through postures (rad) at times (s), by differences."""
    rows = np.array(postures)
    speeds = np.gradient(rows, np.array(times), axis=0)
    changes = np.gradient(speeds, np.array(times), axis=0)
    return zip(rows, speeds, changes, strict=True)


def strengths(chain: Chain, limits: ConnectorLimits) -> list[Holding]:
    """Strength of each connection of a chain: that of its latch, or where a part has none, of its cup."""
    return [limits.strength(latched=connection.latched) for connection in chain.connections]


def utilisations(wrenches: Array, holding: Sequence[Holding]) -> list[float]:
    """The largest fraction of each connection's strength; `wrenches` have the shape (states, connections, 6)."""
    forces, moments = wrenches[..., :3], wrenches[..., 3:]
    return [
        float(np.max(strength.utilisations(forces[:, row], moments[:, row]))) for row, strength in enumerate(holding)
    ]


def largest_load(
    chain: Chain,
    states: Iterable[tuple[Array, Array, Array]],
    limits: ConnectorLimits,
    held: pin.Inertia | None = None,
) -> Used:
    """The most loaded connection between the parts of a chain, and that to its base.

    `states` are positions, velocities and accelerations of the joints; `held` hangs on the tip, in the tip's frame.
    """
    bodies = list(chain.bodies)
    if held is not None:
        tip = chain.model.frames[chain.tool]
        bodies.append((tip.parentJoint, tip.placement.act(held)))
    wrenches = [_wrenches(chain, bodies, *state) for state in states]
    if not wrenches or not chain.connections:
        return NOTHING
    used = utilisations(np.array(wrenches), strengths(chain, limits))
    worst = int(np.argmax(used))
    return Used(used[worst], chain.connections[worst].name)


def _wrenches(chain: Chain, bodies: Sequence[tuple[int, pin.Inertia]], q: Array, v: Array, a: Array) -> list[Array]:
    """What each connection transmits to what is beyond it, in its frame, whose z points there."""
    model, data = chain.model, chain.data
    pin.forwardKinematics(model, data, q, v, a)
    beyond = [pin.Force.Zero()]  # in the world, from the tip on
    for joint, inertia in reversed(bodies):
        place, velocity = data.oMi[joint], data.v[joint]
        felt = data.a[joint] + pin.Motion(place.rotation.T @ UP, np.zeros(3))
        wrench = inertia * felt + velocity.cross(inertia * velocity)
        beyond.append(beyond[-1] + place.act(wrench))
    count = len(bodies)
    return [
        (data.oMi[connection.joint] * connection.frame).actInv(beyond[count - connection.first]).vector
        for connection in chain.connections
    ]
