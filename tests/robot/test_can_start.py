"""A robot on CAN is started by a program that is held up: drives are enabled last, and once more if need be."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest

pytest.importorskip("canopen", reason="canopen is not installed")

from jauspy.backends.can.cia402 import DriveState
from jauspy.backends.can.master import Phase
from jauspy.backends.can.robot import CanRobot
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import Reset
from jauspy.platform.contract import Robot
from jauspy.platform.guarded_robot import GuardedRobot
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.transport import Transport
from jauspy.virtual.environment import VirtualTime

CYCLE = 0.005
STALL = 0.3
"""Seconds; without heartbeat for 0.2 s drives go to Fault."""
POWERED = {DriveState.OPERATION_ENABLED, DriveState.QUICK_STOP_ACTIVE}
"""Modules in Standby stop what they move again and again."""


@dataclass
class Start:
    """A robot with a chassis and an arm, and no cameras; `before_cycle` may hold its program up."""

    network: VirtualNetwork
    folder: Path
    before_cycle: Callable[[Start], None] = lambda _: None
    while_modules_open: Callable[[Start], None] = lambda _: None
    robots: list[CanRobot] = field(default_factory=list)
    stalls: int = 0

    @property
    def robot(self) -> CanRobot:
        return self.robots[0]

    def stall(self) -> None:
        """Let the time pass without the robot's program."""
        self.stalls += 1
        self.robot._ticker._now += STALL
        assert self.robot.fleet is not None
        for _ in range(round(STALL / CYCLE)):
            self.robot.fleet.step(CYCLE)

    def runner(self) -> RobotRunner:
        path = self.folder / "it.toml"
        path.write_text(
            'extends = "inc1"\nlidars = []\ncameras = []\nforce_torque = []\n'
            '[[modules]]\ntype = "CM-MOB"\ncomponent = 102\n[[modules]]\ntype = "CM-MAN"\ncomponent = 104\n'
        )
        return RobotRunner(
            robot_files.load(path), self._transport, backend="can", world="empty", realtime=self._realtime
        )

    def _transport(self, id: JausID) -> Transport:
        self.while_modules_open(self)
        return self.network.transport(id)

    def _realtime(self, robot: Robot) -> VirtualTime:
        assert isinstance(robot, GuardedRobot)
        inner = robot.inner
        assert isinstance(inner, CanRobot)
        self.robots.append(inner)
        wait = inner.master._wait_cycle

        def wait_cycle() -> None:
            self.before_cycle(self)
            wait()

        inner.master._wait_cycle = wait_cycle
        return VirtualTime(robot)


@pytest.fixture
def start(virtual_network: VirtualNetwork, tmp_path: Path) -> Start:
    return Start(virtual_network, tmp_path)


def states(start: Start) -> set[DriveState]:
    assert start.robot.fleet is not None
    return {drive.state for drive in start.robot.fleet.drives.values()}


@pytest.mark.slow
async def test_drives_are_enabled_when_all_modules_are_open(start: Start) -> None:
    """Making components takes the interpreter for tenths of a second."""
    seen = []

    def while_modules_open(start: Start) -> None:
        seen.append(states(start))
        start.stall()

    start.while_modules_open = while_modules_open
    async with start.runner() as runner:
        await asyncio.sleep(0.5)
        assert start.stalls == 2
        assert not POWERED & (seen[0] | seen[1])
        assert not runner.faults
        assert start.robot.master.running
        assert states(start) <= POWERED


@pytest.mark.parametrize("phase", [Phase.ENABLING, Phase.RUNNING])
async def test_drives_are_enabled_once_more_and_this_is_said(
    start: Start, phase: Phase, caplog: pytest.LogCaptureFixture
) -> None:
    def before_cycle(start: Start) -> None:
        if start.robot.master._phase is phase and not start.stalls:
            start.stall()

    start.before_cycle = before_cycle
    async with start.runner() as runner:
        await asyncio.sleep(0.5)
        assert start.stalls == 1
        assert not runner.faults
        assert start.robot.master.running
        assert states(start) <= POWERED
    [said] = caplog.messages
    assert re.fullmatch(
        r"virtual:motors: the robot's program did not run for 0\.3\d s while the drives were enabled: they are enabled "
        r"once more",
        said,
    )


async def test_a_program_that_is_held_up_again_is_a_failure_with_the_reason(start: Start) -> None:
    def before_cycle(start: Start) -> None:
        if start.robot.master._phase is Phase.RUNNING and start.stalls < 2:
            start.stall()

    start.before_cycle = before_cycle
    async with start.runner() as runner, start.network.ocu() as ocu:
        assert set(runner.faults) == {"101.1.102", "101.1.104"}
        assert "the robot's program did not run for 0.3" in runner.faults["101.1.102"]
        await asyncio.sleep(0.5)
        assert not start.robot.master.running
        for component in runner.components:
            await ocu.send(component.id, Reset(), ack=True)
        await asyncio.sleep(0.5)
        assert not runner.faults
        assert start.robot.master.running
        assert states(start) <= POWERED


async def test_a_drive_that_fails_when_all_are_enabled_is_a_failure(start: Start) -> None:
    def before_cycle(start: Start) -> None:
        if start.robot.master.running and start.robot.fleet is not None:
            start.robot.fleet.drives["arm_2"].fail(0x2310, 2)

    start.before_cycle = before_cycle
    async with start.runner() as runner:
        await asyncio.sleep(0.2)
        assert "drive 'arm_2' (node 5), which moves" in runner.faults["101.1.104"]


async def test_a_drive_that_cannot_be_enabled_ends_the_start(start: Start, caplog: pytest.LogCaptureFixture) -> None:
    def before_cycle(start: Start) -> None:
        if start.robot.master._phase is Phase.ENABLING and start.robot.fleet is not None:
            start.robot.fleet.drives["arm_2"].fail(0x2310, 2)

    start.before_cycle = before_cycle
    runner = start.runner()
    with pytest.raises(ConfigError, match=r"can: drive 'arm_2' \(node 5\), which moves .* is in Fault"):
        await runner.open()
    assert not runner.running
    assert not caplog.messages
