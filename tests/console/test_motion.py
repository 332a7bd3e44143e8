"""Moving the tool while something is held: the dead-man's switch, and motions that end with their operator."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, cast

import pytest

from jauspy.console.browser_messages import ToolVelocity, jog_message
from jauspy.console.dead_man import DEAD_MAN_TIME
from jauspy.console.manipulators import StandardArm, manipulators
from jauspy.console.motion import MAX_SPEED, STILL, Jogging, Motion, velocity
from jauspy.console.operation import Operation
from jauspy.ocu.robot import Robot
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork

UP: ToolVelocity = (0.0, 0.0, 0.05, 0.0, 0.0, 0.0, "robot")
TURN = "base_link_to_arm_link_1"
STOP_TIME = 0.1
"""Seconds after the dead-man's switch in which the arm stands: 300 ms together."""


@dataclass
class Bench:
    robot: Robot
    runner: RobotRunner
    operation: Operation
    jogging: Jogging
    events: list[str]

    @property
    def speed(self) -> float:
        assert self.runner.snapshot is not None
        return max(map(abs, self.runner.snapshot.joints["arm"].velocities))

    async def hold(self, seconds: float, asked: ToolVelocity = UP, token: str = "first") -> str:
        problem = ""
        for _ in range(round(seconds / 0.05)):
            problem = self.jogging.move(token, asked)
            await asyncio.sleep(0.05)
        return problem


@asynccontextmanager
async def bench(network: VirtualNetwork) -> AsyncIterator[Bench]:
    async with network.robot() as runner, network.ocu() as ocu:
        robot, events = await ocu.discover(101), list[str]()
        operation = Operation(robot, events.append)
        arm = next(iter(manipulators(robot).values()))
        await operation.take("first", 127)
        await arm.move({"arm_link_1_to_arm_link_2": 2.0}, 1.0)
        try:
            yield Bench(robot, runner, operation, Jogging(operation, arm.info.id, events.append), events)
        finally:
            await operation.release()


@pytest.mark.parametrize(
    "text", ["", "[]", "[1,2,3,4,5,6]", '[1,2,3,4,5,6,"world"]', "[" * 1000, '[1e999,0,0,0,0,0,"tool"]']
)
def test_anything_else_means_still(text: str) -> None:
    assert velocity(jog_message(text)) == STILL


def test_a_browser_cannot_ask_for_more_than_the_greatest_speed() -> None:
    linear, angular, frame = velocity((3.0, 4.0, 0.0, 0.0, 0.0, 0.5, "tool"))
    assert linear == pytest.approx((0.6 * MAX_SPEED, 0.8 * MAX_SPEED, 0.0))
    assert (angular, frame) == ((0.0, 0.0, 0.5), "tool")


@pytest.mark.slow
async def test_the_tool_moves_while_held_and_stands_when_the_browser_is_silent(virtual_network: VirtualNetwork) -> None:
    async with bench(virtual_network) as at:
        assert at.jogging.move("second", UP) == "another browser operates this robot"
        before = await at.robot.arm.tool()
        assert await at.hold(2.0) == ""
        after = await at.robot.arm.tool()
        assert after.z - before.z == pytest.approx(0.1, abs=0.03)
        assert math.hypot(after.x - before.x, after.y - before.y) < 0.02
        await asyncio.sleep(DEAD_MAN_TIME + STOP_TIME)
        assert at.speed < 0.01
        assert at.events[-1] == "the arm 101.1.104 was stopped: its operator's browser is silent"
        await at.hold(0.5)
        assert at.speed > 0.01
        at.jogging.leave("second")
        await at.hold(0.2)
        assert at.speed > 0.01
        at.jogging.leave("first")
        await asyncio.sleep(STOP_TIME + 0.1)
        assert at.speed < 0.01


@pytest.mark.slow
async def test_what_is_refused_is_reported(virtual_network: VirtualNetwork) -> None:
    async with bench(virtual_network) as at:
        at.jogging._id = next(each.id for each in at.robot.components if each.id.component == 103)
        assert "101.1.103 cannot move its tool at a velocity" in await at.hold(0.3)


@pytest.mark.slow
async def test_a_motion_ends_when_another_browser_takes_over(virtual_network: VirtualNetwork) -> None:
    async with bench(virtual_network) as at:
        notes: list[str] = []
        console = cast("Any", SimpleNamespace(operation=lambda _: at.operation, note=notes.append))
        arm = next(iter(manipulators(at.robot).values()))
        assert isinstance(arm, StandardArm)
        theirs = Motion(console, "second")
        theirs.begin(101, arm.move({TURN: 1.5}, 0.2), "the motion")
        assert theirs.problem == "another browser operates this robot"
        motion = Motion(console, "first")
        motion.begin(101, arm.move({TURN: 1.5}, 0.2), "the motion")
        motion.begin(101, arm.move({TURN: 0.0}, 1.0), "another one")
        assert motion.problem == "another motion is running: stop it first"
        await asyncio.sleep(1.0)
        assert at.speed > 0.05
        assert await at.operation.take("second", 127) == ""
        await asyncio.sleep(0.5)
        assert at.speed < 0.01
        assert not motion.is_running
        assert motion.problem == "the motion was stopped: another browser operates this robot"
        assert notes == ["the motion of robot 101: the motion was stopped: another browser operates this robot"]


@pytest.mark.slow
async def test_arms_are_listed_with_their_joints(virtual_network: VirtualNetwork) -> None:
    async with bench(virtual_network) as at:
        arms = manipulators(at.robot)
        assert list(arms) == ["101.1.104", "101.1.103"]
        assert [arm.has_tool for arm in arms.values()] == [True, False]
        joints = await arms["101.1.104"].joints()
        assert joints[0].name == TURN
        assert 0 < joints[0].motion.speed < 10
        assert joints[0].shown_range(0.0) == (joints[0].lower, joints[0].upper)
        assert (await arms["101.1.104"].positions()).keys() == {each.name for each in joints}
        assert (await arms["101.1.104"].tool()).startswith("x ")
