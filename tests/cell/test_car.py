"""Room for the car on the belt, and its ride to the end, and plans with the arm, without physics."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import pinocchio as pin
import pytest

from jauspy.cell.assembly import Assembler
from jauspy.cell.car import BEFORE_END, BELT_SPEED, BESIDE, ROOM, CarTask
from jauspy.cell.frames import Array, se3_of_pose, shifted
from jauspy.cell.handling import MAX_PLANS
from jauspy.cell.interface import SeenPart
from jauspy.cell.modular_arm import FIVE_JOINTS
from jauspy.cell.motion import NoPath, Path
from jauspy.cell.scene import Layout, connector_frame
from jauspy.cell.schedule import TaskFailed

BELT = 1.1, 0.22
"""x and the height of the belt, metres; it runs along y."""
CAR = 0.10
"""y of the car's place."""


class Belt:
    """A belt that carries boxes at these y."""

    def __init__(self, **boxes: float) -> None:
        self.boxes, self.speed = boxes, 0.0
        self.moved = 0.0

    async def observe(self, *, fresh: bool = False) -> Mapping[str, SeenPart]:
        return {name: SeenPart("box", shifted(BELT[0], y, BELT[1])) for name, y in self.boxes.items()} | {
            "wheel_1": SeenPart("wheel", shifted(BELT[0], CAR, BELT[1])),
            "box_3": SeenPart("box", shifted(2.3, 0.22, 0.0)),
        }

    async def run_conveyor(self, speed: float) -> None:
        self.speed = speed

    async def sleep(self, seconds: float) -> None:
        self.moved += self.speed * seconds
        self.boxes = {name: y + self.speed * seconds for name, y in self.boxes.items()}


def task(layout: Layout, belt: Belt) -> CarTask:
    cell: Any = belt
    ur10: Any = None
    return CarTask(cell, layout, ur10)


async def test_the_belt_stands_still_when_there_is_room(layout: Layout) -> None:
    belt = Belt(box_1=-0.95, box_2=-0.6)
    await task(layout, belt)._make_room()
    assert belt.moved == 0.0


async def test_boxes_are_taken_back_until_the_car_has_room(layout: Layout) -> None:
    belt = Belt(box_1=-0.45, box_2=-0.10)
    await task(layout, belt)._make_room()
    assert belt.speed == 0.0
    assert belt.boxes["box_2"] == pytest.approx(CAR - ROOM, abs=1e-6)
    assert belt.moved == pytest.approx(-(ROOM - (CAR + 0.10)))
    assert BELT_SPEED > 0.0


async def test_no_box_is_driven_off_the_beginning_of_the_belt(layout: Layout) -> None:
    belt = Belt(box_1=-1.0, box_2=0.05)
    with pytest.raises(TaskFailed, match="boxes would fall off its beginning"):
        await task(layout, belt)._make_room()
    assert belt.moved == 0.0


class Ride(Belt):
    """A belt that carries the car until that is at `stuck`, and a clock."""

    def __init__(self, stuck: float) -> None:
        super().__init__()
        self.time, self.car, self.stuck = 0.0, CAR, stuck

    def now(self) -> float:
        return self.time

    def latest(self, _part: str) -> tuple[float, pin.SE3]:
        return self.time, shifted(BELT[0], min(self.car, self.stuck), BELT[1])

    async def sleep(self, seconds: float) -> None:
        self.time += seconds
        self.car += self.speed * seconds


async def test_the_car_rides_to_the_end_of_the_belt(layout: Layout) -> None:
    belt = Ride(stuck=2.0)
    await task(layout, belt)._ride()
    assert belt.speed == 0.0
    assert belt.time == pytest.approx((1.2 - BEFORE_END - CAR) / BELT_SPEED, abs=0.2)


async def test_a_car_that_stays_where_it_is_ends_the_ride(layout: Layout) -> None:
    belt = Ride(stuck=0.5)
    with pytest.raises(TaskFailed, match=r"the car is 0\.35 m short of the end of the belt after 9\.\d s"):
        await task(layout, belt)._ride()
    assert belt.speed == 0.0


@pytest.mark.slow
def test_ways_around_obstacles_are_searched_for_a_few_postures_only(
    layout: Layout, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A search takes seconds where there is no way, and nearly every angle of the gripper has a posture."""
    cell: Any = None
    ur10 = Assembler(cell, layout)
    searches = []

    def search(start: Array, goal: Array) -> Path:
        searches.append(goal)
        raise NoPath("no way around the forearm was found")

    monkeypatch.setattr(ur10.planner, "to_posture", search)
    base = se3_of_pose(next(part.pose for part in layout.setup.parts if part.name == "platform_1"))
    frames, frame = {}, base * connector_frame(layout.type_of("platform_1"), "top")
    for name in FIVE_JOINTS:
        frames[name] = frame
        kind = layout.type_of(name)
        turn = math.pi if name == "servo_1" else 0.0  # the bracket faces the UR10
        frame = frame * connector_frame(kind, next(iter(kind.connectors)), turn)
    belt: Any = Belt()
    task = CarTask(belt, layout, ur10)
    car = shifted(layout.setup.conveyor.pose.x - BESIDE[0], frames["servo_1"].translation[1] - BESIDE[1], 0.3)
    with pytest.raises(NoPath, match="no way around the forearm was found"):
        task._plan_carry("bracket_1", "servo_1", frames, car * connector_frame(layout.type_of("car"), "top"))
    assert 0 < len(searches) <= MAX_PLANS
