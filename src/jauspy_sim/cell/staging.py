"""Parts put where a test or a benchmark needs them, as no robot could: at once, and exactly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import mujoco

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import quaternion
from jauspy_sim.cell.robot import SimulatedCell

ARM: Final = ("servo_1", "bracket_1", "servo_2", "tube_1", "servo_3", "tube_2", "servo_4", "servo_5")
"""The arm of five joints of the included cell, from its base up."""

GAP: Final = 0.0003
"""Metres between plates that are put on each other: contact, without overlap."""


def put(cell: SimulatedCell, name: str, pose: Transform) -> None:
    """Put a part somewhere in the world, at rest."""
    joint = cell.model.joint(name)
    position, dof = int(joint.qposadr[0]), int(joint.dofadr[0])
    cell.data.qpos[position : position + 7] = (*pose.position, *quaternion(pose.rotation))
    cell.data.qvel[dof : dof + 6] = 0.0
    mujoco.mj_kinematics(cell.model, cell.data)


def put_on(cell: SimulatedCell, connector: str, name: str, error: Transform = IDENTITY) -> None:
    """Put a part in front of a connector, with its plate in contact, and enable the connector."""
    offset = Transform(position=(0.0, 0.0, GAP)) @ error
    put(cell, name, cell.truth.connector(connector) @ offset)
    cell.connectors[connector].set(True)


def build_arm(
    cell: SimulatedCell,
    parts: Sequence[str] = ARM,
    base: str = "platform_1/top",
    errors: Mapping[str, Transform] | None = None,
) -> None:
    """Put parts on each other and have the connectors attach them. Raises `RuntimeError` if one does not."""
    connector = base
    for name in parts:
        put_on(cell, connector, name, (errors or {}).get(name, IDENTITY))
        cell.advance(0.008)
        state = cell.connectors[connector].state()
        if state.attached_to != name:
            raise RuntimeError(f"{connector} does not hold {name}: {state.last_error}")
        own = next(iter(cell.setup.type_of(name).connectors), "")
        connector = f"{name}/{own}"
