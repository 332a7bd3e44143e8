"""Robots for tests of capability modules."""

from __future__ import annotations

import pytest
from tests.helpers.robot import FakeRobot
from tests.robot.workcell import BACKENDS
from tests.robot.world import World


@pytest.fixture
def fake_robot() -> FakeRobot:
    return FakeRobot()


@pytest.fixture
def fragile_robot() -> FakeRobot:
    return FakeRobot(breaks_after=3)


@pytest.fixture(params=BACKENDS)
def world(request: pytest.FixtureRequest) -> World:
    """A robot under control, in Ready, on each backend."""
    world = World(request.param)
    world.take_control()
    return world
