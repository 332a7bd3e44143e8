"""One contract for every arm of the cell: the UR10, and modular arms with 0 to 9 joints."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

import pytest

pytest.importorskip("mujoco", reason="needs the extra `sim`")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.sampling import sampled
from tests.helpers.servo_plant import ServoPlant, many

from jauspy import backends
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot import robot_files

UR10 = "ur10"
ARMS = [UR10, *range(10)]
STEP = 0.002
AT_REST = 0.03
"""rad/s"""


class Ur10:
    """The robot of the cell, by itself."""

    def __init__(self) -> None:
        self._robot = backends.find("sim").open(_ur10(), "empty")
        self._group = self._robot.groups[UR10]
        self.count = len(self._group.joints)

    def move(self, targets: Sequence[float]) -> None:
        self._group.command(
            [None if math.isnan(each) else Target(ControlMode.POSITION, each, speed=0.3) for each in targets]
        )

    def hold(self) -> None:
        self._group.hold()

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / STEP)):
            self._robot.advance(STEP)

    @property
    def positions(self) -> tuple[float, ...]:
        return self._group.state().positions

    @property
    def velocities(self) -> tuple[float, ...]:
        return self._group.state().velocities


@cache
def _ur10() -> RobotModel:
    return replace(robot_files.robot_model(robot_files.load("cell")), cell=None)


@dataclass
class Modular:
    """A modular arm on a plant."""

    count: int

    def __post_init__(self) -> None:
        self._plant = ServoPlant(many(self.count))
        self._arm = self._plant.arm()
        self.run(0.02)

    def move(self, targets: Sequence[float]) -> None:
        self._arm.move(targets, 2.0)

    def hold(self) -> None:
        self._arm.hold()

    def run(self, seconds: float) -> None:
        self._plant.run(self._arm, seconds)

    @property
    def positions(self) -> tuple[float, ...]:
        return tuple(self._arm.state().positions)

    @property
    def velocities(self) -> tuple[float, ...]:
        return tuple(self._plant.velocities)


@pytest.fixture(params=sampled(ARMS, 2))
def arm(request: pytest.FixtureRequest) -> Ur10 | Modular:
    return made(request.param)


def made(kind: str | int) -> Ur10 | Modular:
    return Ur10() if kind == UR10 else Modular(int(kind))


def shifted(arm: Ur10 | Modular) -> list[float]:
    """Targets that are a little off the present positions, a different angle for each joint."""
    return [position + 0.2 - 0.05 * at for at, position in enumerate(arm.positions)]


@pytest.mark.slow
def test_reaches_its_targets_and_stays(arm: Ur10 | Modular) -> None:
    targets = shifted(arm)
    arm.move(targets)
    arm.run(3.0)
    assert arm.positions == pytest.approx(targets, abs=0.005)
    assert all(abs(each) < AT_REST for each in arm.velocities)


def test_what_is_left_out_stays(arm: Ur10 | Modular) -> None:
    before = arm.positions
    arm.move([position + 0.2 if at == 0 else math.nan for at, position in enumerate(before)])
    arm.run(2.5)
    wanted = [position + 0.2 if at == 0 else position for at, position in enumerate(before)]
    assert arm.positions == pytest.approx(wanted, abs=0.01)


def test_stands_200_ms_after_hold(arm: Ur10 | Modular) -> None:
    arm.move(shifted(arm))
    arm.run(0.5)
    assert arm.count == 0 or max(map(abs, arm.velocities)) > AT_REST, "it moves"
    arm.hold()
    arm.run(0.2)
    assert all(abs(each) < AT_REST for each in arm.velocities)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ARMS)
def test_the_same_commands_give_the_same_motion_to_the_last_bit(kind: str | int) -> None:
    ends = []
    for _ in range(2):
        arm = made(kind)
        arm.move(shifted(arm))
        arm.run(0.4)
        arm.hold()
        arm.run(0.1)
        ends.append((arm.positions, arm.velocities))
    assert ends[0] == ends[1]
