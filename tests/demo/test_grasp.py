"""What counts as grasped and lifted, by an arm that feels what it is told to."""

import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")

from jauspy.demo import plan
from jauspy.demo.grasp import Grasp
from jauspy.robot.robot_files import load, robot_model


class Arm:
    """Its tool rises by `rise` and then sinks by `sinks`; its hand holds what weighs `weight` and is `width` wide."""

    def __init__(self, rise: float, sinks: float, width: float, weight: float) -> None:
        self._heights = iter((0.0, rise, rise - sinks))
        self._weights = iter((1.5, 1.5 + weight))
        self._width = width

    async def go(self, *_: float) -> float:
        return 0.001

    async def tool_height(self) -> float:
        return next(self._heights)

    async def weight(self) -> float:
        return next(self._weights)

    async def width(self) -> float:
        return self._width

    async def open_gripper(self) -> float:
        return 0.1

    async def close_gripper(self) -> float:
        return self._width


@pytest.mark.parametrize(
    ("felt", "grasped", "lifted"),
    [
        ((0.13, 0.001, 0.049, 1.05), True, True),
        ((0.08, 0.0, 0.049, 1.05), True, False),  # not high enough
        ((0.13, 0.05, 0.049, 1.05), True, False),  # it sinks
        ((0.13, 0.0, 0.0, 0.0), False, False),  # nothing is in the hand
        ((0.13, 0.0, 0.049, 0.1), True, False),  # the hand is as wide, and carries nothing
        ((0.13, 0.0, 0.08, 1.05), False, False),  # something else
    ],
)
async def test_lift_requires_height_width_and_weight(
    monkeypatch: pytest.MonkeyPatch, felt: tuple[float, float, float, float], grasped: bool, lifted: bool
) -> None:
    monkeypatch.setattr(plan, "HOLD_TIME", 0.0)
    grasp = Grasp(Arm(*felt), None, robot_model(load("inc1")), None, size=(640, 480), goals=plan.PLANS["yard"])
    assert (await grasp.reach()).reached
    assert (await grasp.close()).reached is grasped
    assert (await grasp.lift()).reached is lifted
