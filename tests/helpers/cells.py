"""Simulated cells for tests, and parts put where a test needs them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import mujoco

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.geometry.vectors import quaternion
from jauspy.modules import robot_files
from jauspy.platform.description import RobotModel
from jauspy.platform.modular.parts import CellSetup
from jauspy_sim.cell.robot import SimulatedCell

ARM = ("servo_1", "bracket_1", "servo_2", "tube_1", "servo_3", "tube_2", "servo_4", "servo_5")
"""The arm of five joints, from its base up."""

GAP = 0.0003
"""Metres between plates that are put on each other: contact, without overlap."""


def cell_model(**changes: Any) -> RobotModel:
    """The included cell, with changes of its `CellSetup`."""
    model = robot_files.robot_model(robot_files.load("cell"))
    assert model.cell is not None
    return replace(model, cell=replace(model.cell, **changes))


def open_cell(**changes: Any) -> SimulatedCell:
    return SimulatedCell.open(cell_model(**changes), "cell")


def small_cell(names: Sequence[str], **changes: Any) -> SimulatedCell:
    """A cell with these parts only, and without bins, conveyor and car."""
    setup = cell_model().cell
    assert setup is not None
    parts = tuple(part for part in setup.parts if part.name in names)
    bare: dict[str, Any] = {"parts": parts, "bins": (), "fixtures": (), "conveyor": None, "car": ""}
    return open_cell(**(bare | changes))


def put(cell: SimulatedCell, name: str, pose: Transform) -> None:
    """Put a part somewhere, at rest."""
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
    """Put parts on each other and have the connectors attach them, without a robot."""
    connector = base
    setup: CellSetup = cell.setup
    for name in parts:
        put_on(cell, connector, name, (errors or {}).get(name, IDENTITY))
        cell.advance(0.008)
        state = cell.connectors[connector].state()
        assert state.attached_to == name, state
        own = next(iter(setup.type_of(name).connectors))
        connector = f"{name}/{own}"
