"""Lifting without physics: which box is next, what is said without one, and what a miss teaches."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.frames import shifted
from jauspy.cell.lift import ATTEMPTS, BELT_SPEED, LARGEST_LESSON, LATE, Aim, Lifter
from jauspy.cell.schedule import TaskFailed
from jauspy.platform.modular.parts import PartKind


class Cell:
    """A clock, a belt, and boxes where the test puts them."""

    def __init__(self, **boxes: tuple[float, float, float]) -> None:
        self.time = 0.0
        self.boxes = boxes
        self.belt: list[float] = []
        self.enabled: list[tuple[str, bool, float]] = []

    def now(self) -> float:
        return self.time

    async def sleep(self, seconds: float) -> None:
        self.time += seconds

    def latest(self, box: str) -> tuple[float, pin.SE3]:
        return self.time, shifted(*self.boxes[box])

    async def run_conveyor(self, speed: float) -> None:
        self.belt.append(speed)

    async def enable(self, name: str, enabled: bool) -> None:
        self.enabled.append((name, enabled, self.time))

    async def command_arm(self, positions: object, duration: float) -> None:
        """The test's arm moves by itself."""


class Arm:
    """An arm whose tip, when it throws, flies along a line at 2 m/s."""

    tip = "servo_5/output"

    def __init__(self, cell: Cell) -> None:
        self._cell = cell
        self.chain = self
        self.root = np.array([0.6, 0.2, 0.4])

    async def look(self, *ignored: str) -> None:
        """It sees what is there."""

    async def positions(self) -> np.ndarray:
        return np.zeros(5)

    def above(self, point: object, near: np.ndarray) -> list[np.ndarray]:
        return [near]

    def solve_down(self, point: object, start: np.ndarray) -> np.ndarray:
        return start

    async def go(self, goal: np.ndarray) -> None:
        """It is there at once."""

    async def state(self) -> Any:
        at = self._cell.time
        return SimpleNamespace(payload=0.3, positions=(at,), velocities=(2.0,))

    def ordered(self, state: object, values: tuple[float, ...]) -> np.ndarray:
        return np.array(values)

    def forward(self, q: np.ndarray) -> pin.SE3:
        return shifted(*(self.root + np.array([2.0 * float(q[0]) - 1.0, 0.0, 0.5])).tolist())

    def velocity(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return np.array([float(v[0]), 0.0, 0.0])

    async def move(self, goal: np.ndarray, duration: float) -> None:
        """It is there at once."""

    async def vector(self, goal: np.ndarray) -> list[float]:
        return [float(each) for each in goal]


def layout(**missing: None) -> Any:
    """A belt along y whose top is at 0.2 m, an area 2 m ahead of the arm, and four boxes."""
    box = SimpleNamespace(kind=PartKind.BOX)
    setup = SimpleNamespace(
        conveyor=SimpleNamespace(pose=SimpleNamespace(x=1.0, y=0.0, z=0.2)),
        target=SimpleNamespace(pose=SimpleNamespace(x=2.6, y=0.2)),
        parts=[SimpleNamespace(name=f"box_{number}") for number in range(1, 5)],
    )
    for name in missing:
        setattr(setup, name, None)
    return SimpleNamespace(setup=setup, type_of=lambda _: box, grasp=lambda _: shifted(z=0.05))


def lifter(cell: Cell) -> Lifter:
    arm: Any = Arm(cell)
    client: Any = cell
    return Lifter(client, layout(), arm)


@pytest.mark.parametrize("missing", ["conveyor", "target"])
def test_without_belt_or_area_it_does_not_begin(missing: str) -> None:
    cell: Any = Cell()
    arm: Any = None
    with pytest.raises(TaskFailed, match="no conveyor, or no area to throw into"):
        Lifter(cell, layout(**{missing: None}), arm)


def test_boxes_that_have_passed_or_fallen_are_left_and_the_nearest_is_the_first() -> None:
    boxes = {
        "box_1": (1.0, -0.8, 0.2),
        "box_2": (1.0, -0.3, 0.2),
        "box_3": (1.0, 0.0, 0.2),  # closer to the arm than its run-up, too late
        "box_4": (1.0, -0.5, 0.0),  # on the floor
    }
    assert lifter(Cell(**boxes))._in_order() == ["box_2", "box_1"]


async def test_after_three_boxes_it_gives_up_and_stops_the_belt(monkeypatch: pytest.MonkeyPatch) -> None:
    cell = Cell(**{f"box_{number}": (1.0, -0.2 * number, 0.2) for number in range(1, 5)})
    task, tried = lifter(cell), list[str]()

    async def take(box: str) -> bool:
        tried.append(box)
        return False

    monkeypatch.setattr(task, "_take", take)
    with pytest.raises(TaskFailed, match=f"no box could be taken off the belt in {ATTEMPTS} attempts"):
        await task.run()
    assert tried == ["box_1", "box_2", "box_3"]
    assert cell.belt == [0.0]


async def test_a_box_that_is_held_up_is_waited_for_three_seconds_longer(monkeypatch: pytest.MonkeyPatch) -> None:
    cell = Cell(box_1=(1.0, -0.7, 0.2), box_2=(1.0, 1.0, 0.2), box_3=(1.0, 1.0, 0.2), box_4=(1.0, 1.0, 0.2))
    task = lifter(cell)
    monkeypatch.setattr(task, "_following", lambda *_: (1.0, 0.4, 0.15))
    with pytest.raises(TaskFailed, match="no box could be taken off the belt in 1 attempts"):
        await task.run()
    assert cell.time == pytest.approx((0.15 + 0.7) / BELT_SPEED + LATE, abs=0.3)
    assert cell.enabled == []
    assert cell.belt[-2:] == [0.0, 0.0]


async def test_an_empty_belt_is_no_attempt() -> None:
    cell = Cell(**{f"box_{number}": (1.0, 1.0, 0.2) for number in range(1, 5)})
    with pytest.raises(TaskFailed, match="in 0 attempts"):
        await lifter(cell).run()


def rests(aim: Aim, bias: np.ndarray, scatter: float, seed: int, throws: int) -> list[float]:
    """Throw at a goal with a bias and a scatter, learning from each; distances from the goal, metres."""
    random, goal, errors = np.random.default_rng(seed), np.array([2.3, 0.2]), []
    for _ in range(throws):
        planned = aim.at(goal)
        rest = planned + bias + scatter * random.normal(size=2)
        errors.append(float(np.linalg.norm(rest - goal)))
        aim.learn(planned, rest)
    return errors


def test_a_bias_is_corrected_after_one_throw() -> None:
    errors = rests(Aim(), np.array([0.04, -0.02]), 0.0, 0, 3)
    assert errors[0] == pytest.approx(np.hypot(0.04, 0.02))
    assert max(errors[1:]) < 1e-9


@pytest.mark.parametrize("seed", range(5))
def test_later_throws_are_as_exact_as_their_scatter_allows(seed: int) -> None:
    errors = rests(Aim(), np.array([0.04, -0.02]), 0.004, seed, 40)
    assert float(np.mean(errors[20:])) < 1.4 * 0.004 * np.sqrt(np.pi / 2.0)


def test_a_correction_with_the_wrong_sign_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Aim, "at", lambda self, goal: goal + self.bias)
    assert max(rests(Aim(), np.array([0.04, -0.02]), 0.0, 0, 3)[1:]) > 0.04


def test_a_box_that_tumbles_moves_the_aim_little() -> None:
    aim = Aim()
    rests(aim, np.array([0.01, 0.0]), 0.0, 0, 4)
    aim.learn(np.zeros(2), np.array([0.3, -0.4]))
    assert np.linalg.norm(aim.bias - np.array([0.01, 0.0])) < 0.005
    assert LARGEST_LESSON < 0.5  # of the first one, too, only so much counts
    first = Aim()
    first.learn(np.zeros(2), np.array([0.3, -0.4]))
    assert np.linalg.norm(first.bias) == pytest.approx(LARGEST_LESSON)
