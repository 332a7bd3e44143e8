"""Simulated cells for tests."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files
from jauspy_sim.cell.robot import SimulatedCell
from jauspy_sim.cell.start import GAP, put, put_on, put_on_each_other

__all__ = ["ARM", "GAP", "build_arm", "cell_model", "open_cell", "put", "put_on", "small_cell", "weightless"]

ARM = ("servo_1", "bracket_1", "servo_2", "tube_1", "servo_3", "tube_2", "servo_4", "servo_5")
"""The arm of five joints of the included cell, from its base up."""


def build_arm(cell: SimulatedCell, parts: Sequence[str] = ARM) -> None:
    """Have an arm there."""
    cell.prepare("platform_1/top", parts)


def cell_model(**changes: Any) -> RobotModel:
    """The included cell, with changes of its `CellSetup`."""
    model = robot_files.robot_model(robot_files.load("cell"))
    assert model.cell is not None
    return replace(model, cell=replace(model.cell, **changes))


def open_cell(**changes: Any) -> SimulatedCell:
    return SimulatedCell.open(cell_model(**changes), "cell")


@contextmanager
def weightless(cell: SimulatedCell) -> Iterator[None]:
    """Without gravity, so that what is put on a connector stays there until that holds it."""
    gravity = cell.model.opt.gravity.copy()
    cell.model.opt.gravity[:] = 0.0
    yield
    cell.model.opt.gravity[:] = gravity


def small_cell(names: Sequence[str], **changes: Any) -> SimulatedCell:
    """A cell with these parts only, and without bins, conveyor and car."""
    setup = cell_model().cell
    assert setup is not None
    parts = tuple(part for part in setup.parts if part.name in names)
    bare: dict[str, Any] = {"parts": parts, "bins": (), "fixtures": (), "conveyor": None, "car": ""}
    return open_cell(**(bare | changes))


def build_car(cell: SimulatedCell) -> None:
    """Put wheels on servo modules, and these on the car, attached and locked."""
    sides = ("front_left", "rear_left", "front_right", "rear_right")
    for number, side in enumerate(sides):
        put_on_each_other(cell, f"car/{side}", [f"servo_{6 + number}"])
        put_on_each_other(cell, f"servo_{6 + number}/output", [f"wheel_{1 + number}"])
