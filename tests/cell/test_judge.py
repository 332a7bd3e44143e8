"""The judge on the true state of a robot that the test makes up."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any
from unittest.mock import create_autospec

import pinocchio as pin
import pytest
from hypothesis import given, strategies as st

from jauspy.cell.frames import shifted, transform, turned
from jauspy.cell.judge import Judge, WatchedBackend
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.modular.connector import ConnectorState, VacuumConnector

PLATE = shifted(0.6, 0.2, 0.3) * turned("z", 0.4)


@dataclass
class Truth:
    """One connector at `PLATE`, and one part that is `off` it."""

    off: pin.SE3

    def pose(self, part: str) -> Pose:
        return transform(PLATE * self.off).to_pose()

    def connector(self, name: str) -> Transform:
        return transform(PLATE)

    def velocity(self, body: str) -> Any:
        return (0.1, 0.0, 0.0), (0.0, 0.0, 0.2)

    def penetration(self) -> float:
        return 0.0004


@dataclass
class Robot:
    truth: Truth
    time: float = 12.5
    optional_parts: list[Any] = field(default_factory=list)
    cameras: dict[str, str] = field(default_factory=dict)
    faults: Any = None

    def prepare(self, connector: str, parts: Any, errors: Any = None) -> None:
        """The test assembles nothing."""

    def place(self, part: str, pose: Any) -> None:
        """The test places nothing."""

    def probe(self) -> None:
        """The test measures no physics."""


def judge(off: pin.SE3, **fields: Any) -> Judge:
    robot: Any = Robot(Truth(off), **fields)
    return Judge(robot)


def test_a_part_that_sits_well_is_off_by_nothing() -> None:
    found = judge(pin.SE3.Identity()).placement("platform_1/top", "servo_1")
    assert found.part == "servo_1"
    assert (found.distance, found.tilt, found.turn) == pytest.approx((0.0, 0.0, 0.0), abs=1e-7)


@given(st.floats(-0.05, 0.05), st.floats(-0.05, 0.05), st.floats(-0.01, 0.01), st.integers(-2, 2))
def test_whole_quarters_of_a_turn_are_no_error(x: float, y: float, turn: float, quarters: int) -> None:
    off = shifted(x, y) * turned("z", quarters * math.pi / 2.0 + turn)
    found = judge(off).placement("platform_1/top", "servo_1")
    assert found.distance == pytest.approx(math.hypot(x, y), abs=1e-9)
    assert found.tilt == pytest.approx(0.0, abs=1e-6)
    assert found.turn == pytest.approx(abs(turn), abs=1e-5)


@given(st.floats(0.002, 0.1), st.floats(-3.0, 3.0), st.integers(-2, 2))
def test_a_lean_is_a_tilt_and_no_turn(lean: float, about: float, quarters: int) -> None:
    axis = turned("z", about)
    off = axis * turned("x", lean) * axis.inverse() * turned("z", quarters * math.pi / 2.0)
    found = judge(off).placement("platform_1/top", "servo_1")
    assert found.tilt == pytest.approx(lean, abs=1e-6)
    assert found.turn == pytest.approx(0.0, abs=1e-6)


def test_it_reads_time_velocity_and_penetration() -> None:
    found = judge(pin.SE3.Identity())
    assert found.time == 12.5
    assert found.velocity("box_1") == ((0.1, 0.0, 0.0), (0.0, 0.0, 0.2))
    assert found.connector("platform_1/top").translation == pytest.approx(PLATE.translation)
    assert found.pose("servo_1").translation == pytest.approx(PLATE.translation)


def test_a_connector_that_holds_nothing_is_not_among_those_that_hold() -> None:
    holding, free = (create_autospec(VacuumConnector, instance=True) for _ in range(2))
    holding.name, holding.state.return_value = "platform_1/top", ConnectorState(True, True, "servo_1")
    free.name, free.state.return_value = "gripper", ConnectorState(True, True, "")
    parts = [holding, free, object()]
    found = judge(pin.SE3.Identity(), optional_parts=parts)
    assert found.attached() == {"platform_1/top": "servo_1"}


def test_a_camera_by_its_name_or_the_first() -> None:
    found = judge(pin.SE3.Identity(), cameras={"overview": "one", "car": "two"})
    assert found.camera("car") == "two"
    assert found.camera("other") == "one"
    assert judge(pin.SE3.Identity()).camera("car") is None


def test_a_robot_without_true_poses_is_refused_with_what_to_do() -> None:
    robot: Any = SimpleNamespace(time=0.0)
    with pytest.raises(ConfigError, match="does not report the true poses of parts; use the backend `sim`"):
        Judge(robot)


def test_the_backend_that_is_watched_opens_another_ones_robots() -> None:
    opened: list[tuple[Any, str]] = []
    inner: Any = SimpleNamespace(name="sim", open=lambda robot, world: opened.append((robot, world)) or "the robot")
    watched, model = WatchedBackend(inner), object()
    assert watched.name == "sim"
    assert watched.robot is None
    opened_robot: Any = watched.open(model, "empty")
    assert opened_robot == watched.robot == "the robot"
    assert opened == [(model, "empty")]
