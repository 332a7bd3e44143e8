"""A platform without physics whose commands are remembered."""

from __future__ import annotations

import threading

import pytest
from tests.modules.workcell import BACKENDS
from tests.modules.world import World

from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.platform.force_torque import ForceTorqueSensor
from jauspy.platform.joints import JointGroup
from jauspy.platform.ranging import RangeFinder


class FakeDrive:
    def __init__(self) -> None:
        self.efforts: list[tuple[float, float]] = []

    @property
    def effort(self) -> tuple[float, float]:
        return self.efforts[-1] if self.efforts else (0.0, 0.0)

    def set_effort(self, linear_x: float, rotational_z: float) -> None:
        self.efforts.append((linear_x, rotational_z))

    def stop(self) -> None:
        self.efforts.append((0.0, 0.0))

    def pose(self) -> Pose:
        return Pose()

    def twist(self) -> Twist:
        return Twist()

    def acceleration(self) -> Acceleration:
        return Acceleration()


class FakeRobot:
    """Counts the time it was given, and notices who touches it."""

    def __init__(self, breaks_after: int | None = None) -> None:
        self.groups: dict[str, JointGroup] = {}
        self.lidars: dict[str, RangeFinder] = {}
        self.force_torque: dict[str, ForceTorqueSensor] = {}
        self.drive = FakeDrive()
        self.time = 0.0
        self.closed = 0
        self.threads: set[int] = set()
        self.steps = 0
        self.stepped = threading.Condition()
        self._breaks_after = breaks_after

    def advance(self, dt: float) -> None:
        self.threads.add(threading.get_ident())
        with self.stepped:
            self.time += dt
            self.steps += 1
            self.stepped.notify_all()
        if self.steps == self._breaks_after:
            raise RuntimeError("a track came off")

    def close(self) -> None:
        self.closed += 1

    def wait_for_steps(self, more: int) -> None:
        """Wait until it was advanced that many times more."""
        with self.stepped:
            goal = self.steps + more
            assert self.stepped.wait_for(lambda: self.steps >= goal, timeout=30.0)


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
