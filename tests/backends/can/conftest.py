"""inc1 on simulated drives in this process, on the robot's own time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import pytest

pytest.importorskip("canopen", reason="canopen is not installed")

from tests.helpers.robot import described

from jauspy.backends import find
from jauspy.backends.can.robot import CanRobot
from jauspy.backends.can.simulated.drive import SimulatedDrive
from jauspy.platform.servo_drives import CanSetup

OpenCan = Callable[..., CanRobot]


def setup_of(**changes: Any) -> CanSetup:
    """The drives of inc1; `changes` are keys of `[can]`, or tables of drives by name."""
    setup = described("inc1")[1].can
    assert isinstance(setup, CanSetup)
    drives = dict(setup.drives)
    for name in set(changes) & set(drives):
        drives[name] = replace(drives[name], **changes.pop(name))
    return replace(setup, **changes, drives=drives)


@pytest.fixture
def open_can() -> Iterator[OpenCan]:
    opened: list[CanRobot] = []

    def open_one(**changes: Any) -> CanRobot:
        model = replace(described("inc1")[1], can=setup_of(**changes))
        robot = find("can").open(model, "empty")
        assert isinstance(robot, CanRobot)
        opened.append(robot)
        return robot

    yield open_one
    for robot in opened:
        robot.close()


@pytest.fixture
def robot(open_can: OpenCan) -> CanRobot:
    return open_can()


def simulated(robot: CanRobot, name: str) -> SimulatedDrive:
    assert robot.fleet is not None
    return robot.fleet.drives[name]
