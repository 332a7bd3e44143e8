"""Room for the car on the belt, without physics."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest

from jauspy.cell.car import BELT_SPEED, ROOM, CarTask
from jauspy.cell.frames import shifted
from jauspy.cell.interface import SeenPart
from jauspy.cell.scene import Layout
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
