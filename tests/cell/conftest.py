"""Fixtures of the factory cell; its tests need the extra `cell`."""

from __future__ import annotations

from dataclasses import replace

import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from jauspy.cell.scene import Layout
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Y, rotation_about
from jauspy.platform.description import RobotModel
from jauspy.robot import robot_files


@pytest.fixture(scope="session")
def model() -> RobotModel:
    """The cell's robot."""
    return robot_files.robot_model(robot_files.load("cell"))


@pytest.fixture(scope="session")
def layout(model: RobotModel) -> Layout:
    """The cell's parts and its arm."""
    return Layout(model)


@pytest.fixture(scope="session")
def forked(model: RobotModel) -> Layout:
    """The same cell, whose straight brackets have a second connector at their side."""
    assert model.cell is not None
    kind = model.cell.types["bracket_straight"]
    side = Transform(rotation_about(Y, 1.5707963), (0.025, 0.0, 0.03))
    bracket = replace(kind, connectors={**kind.connectors, "side": side})
    return Layout(replace(model, cell=replace(model.cell, types={**model.cell.types, "bracket_straight": bracket})))
