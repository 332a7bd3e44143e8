"""Click to reach: the pose before a thing, what browsers may send, and the motion that the operator agrees with."""

from __future__ import annotations

import asyncio
import math
from dataclasses import replace
from typing import Any

import pytest

pytest.importorskip("numpy", reason="numpy is not installed")

from tests.helpers.straight_planner import StraightPlanner
from tests.planning.test_service import Beside, beside

from jauspy.console.operation import Operation
from jauspy.console.reaching import MAX_DISTANCE, STANDOFF, Reaching, pointed_at, pose_before
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.motion import JointGoal, Plan, PlanRequest
from jauspy.testing import VirtualNetwork

THING = (0.9, 0.1, 0.4)
PAGE = "page"


class TurningPlanner(StraightPlanner):
    """Takes goals of the tool, too, and turns the first joint for each of them."""

    def plan(self, request: PlanRequest) -> Plan:
        if not isinstance(request.goal, JointGoal):
            first, *others = request.start
            request = replace(request, goal=JointGoal((first + 0.3, *others)))
        return super().plan(request)


@pytest.mark.parametrize("thing", [(0.9, 0.1, 0.4), (0.2, -0.8, 0.1), (-0.5, 0.0, 1.2)])
def test_the_tool_ends_before_the_thing_and_points_at_it(thing: tuple[float, float, float]) -> None:
    position, (roll, pitch, yaw) = pose_before((0.4, 0.0, 0.5), thing)
    assert math.dist(position, thing) == pytest.approx(STANDOFF)
    ahead = Transform.from_pose(Pose(*position, roll, pitch, yaw)).apply((STANDOFF, 0.0, 0.0))
    assert ahead == pytest.approx(thing)


def test_a_thing_at_the_tool_is_refused() -> None:
    with pytest.raises(ConfigError, match="the tool is already there: 5 cm before the thing"):
        pose_before((0.4, 0.0, 0.5), (0.45, 0.0, 0.5))


HOSTILE: list[Any] = [
    None,
    [],
    "x",
    {},
    {"x": 1.0, "y": 1.0},
    {"x": "1", "y": 0.0, "z": 0.0},
    {"x": True, "y": 0.0, "z": 0.0},
    {"x": math.nan, "y": 0.0, "z": 0.0},
    {"x": math.inf, "y": 0.0, "z": 0.0},
    {"x": 10**400, "y": 0, "z": 0},
    {"x": MAX_DISTANCE, "y": 0.0, "z": 0.0},
    {"x": {"x": 1}, "y": 0.0, "z": 0.0},
]


@pytest.mark.parametrize("asked", HOSTILE)
def test_what_is_no_place_is_ignored(asked: Any) -> None:
    assert pointed_at(asked) is None


def test_a_place_is_taken() -> None:
    assert pointed_at({"x": 1, "y": -0.5, "z": 0.25, "more": []}) == (1.0, -0.5, 0.25)


async def operated(inc1: Beside) -> Operation:
    operation = Operation(inc1.robot, lambda _: None)
    assert await operation.take(PAGE, 127) == ""
    return operation


async def until_asked(reaching: Reaching, task: asyncio.Task[None]) -> None:
    while not reaching.asks:
        assert not task.done(), task
        await asyncio.sleep(0.05)


@pytest.mark.slow
async def test_nothing_moves_until_the_operator_agrees_and_the_arm_comes_back(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.planning.test_service.StraightPlanner", TurningPlanner)
    async with beside(virtual_network) as inc1:
        operation = await operated(inc1)
        arm, reaching = inc1.robot.arm, Reaching()
        before = list((await arm.joints()).positions.values())
        task = asyncio.create_task(reaching.reach(inc1.robot, operation, THING))
        await until_asked(reaching, task)
        await asyncio.sleep(1.0)
        assert list((await arm.joints()).positions.values()) == before
        assert await inc1.planner.preview() is not None

        reaching.agree()
        while task.done() is False and not operation._lent:
            await asyncio.sleep(0.02)
        operation.follow(await inc1.ocu.discover(101))  # a discovery meanwhile does not take the arm back
        await task
        after = list((await arm.joints()).positions.values())
        assert after[0] == pytest.approx(before[0] + 0.3, abs=0.02)
        assert operation.refusal(PAGE) == ""
        assert arm.info.id in operation._control.ids  # type: ignore[union-attr]
        await arm.move({next(iter((await arm.joints()).positions)): before[0]})
        await operation.release()


@pytest.mark.slow
async def test_who_cancels_a_plan_moves_nothing(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.planning.test_service.StraightPlanner", TurningPlanner)
    async with beside(virtual_network) as inc1:
        operation = await operated(inc1)
        reaching = Reaching()
        before = (await inc1.robot.arm.joints()).positions
        task = asyncio.create_task(reaching.reach(inc1.robot, operation, THING))
        await until_asked(reaching, task)
        task.cancel()
        await asyncio.wait([task])
        assert not reaching.asks
        reaching.agree()
        await asyncio.sleep(1.0)
        assert (await inc1.robot.arm.joints()).positions == before
        assert await inc1.planner.preview() is None
        await operation.release()


@pytest.mark.slow
async def test_an_arm_that_was_stopped_on_its_way_is_operated_again(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.planning.test_service.StraightPlanner", TurningPlanner)
    async with beside(virtual_network) as inc1:
        operation = await operated(inc1)
        reaching = Reaching()
        task = asyncio.create_task(reaching.reach(inc1.robot, operation, THING))
        await until_asked(reaching, task)
        reaching.agree()
        while (await inc1.planner.state()).phase != "executing":
            await asyncio.sleep(0.02)
        task.cancel()
        await asyncio.wait([task])
        stopped = list((await inc1.robot.arm.joints()).positions.values())
        await asyncio.sleep(1.0)
        assert list((await inc1.robot.arm.joints()).positions.values()) == pytest.approx(stopped, abs=0.02)
        assert inc1.robot.arm.info.id in operation._control.ids  # type: ignore[union-attr]
        await operation.release()
