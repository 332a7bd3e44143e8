"""Fixtures of the factory cell; its tests need the extra `cell`."""

from __future__ import annotations

import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from jauspy.cell.scene import Layout
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
