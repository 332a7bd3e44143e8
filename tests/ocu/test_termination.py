"""How OCU programs end, with real processes: whatever ends them, their robot stops."""

from __future__ import annotations

import asyncio
import signal
import subprocess
import sys
from contextlib import asynccontextmanager

import pytest

from jauspy.ids import JausID
from jauspy.messages.core import ReportStatus
from jauspy.ocu import OCU
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.testing.assertions import until

pytestmark = pytest.mark.alone

DRIVER = JausID(101, 1, 102)
CONTROL_TIMEOUT = 2

ASYNCHRONOUS = """
import asyncio, sys, time
import jauspy

async def main():
    async with jauspy.OCU("42.1.1", sys.argv[1]) as ocu:
        robot = await ocu.robot(101)
        async with robot.control("drive"):
            await robot.drive(linear=0.4)
            print("driving", flush=True)
            {what}

asyncio.run(main())
"""
SYNCHRONOUS = """
import sys, time
from jauspy.sync import OCU

with OCU("42.1.1", sys.argv[1]) as ocu:
    robot = ocu.robot(101)
    with robot.control("drive") as control:
        robot.drive(linear=0.4)
        print("driving", flush=True)
        {what}
"""
WITHOUT_BLOCKS = """
import asyncio, sys
import jauspy

async def main():
    ocu = jauspy.OCU("42.1.1", sys.argv[1])
    await ocu.open()
    robot = await ocu.robot(101)
    await robot.control("drive").__aenter__()
    await robot.drive(linear=0.4)
    print("driving", flush=True)
    {what}

{run}
"""


@asynccontextmanager
async def driving(node, program: str):
    """A robot, and a program that drives it."""
    config = robot_files.load("inc1")
    modules = [
        each.model_copy(update={"access_control": each.access_control.model_copy(update={"timeout": CONTROL_TIMEOUT})})
        for each in config.modules
        if each.component == DRIVER.component
    ]
    config = config.model_copy(update={"modules": modules})
    async with RobotRunner(config, node.transport, backend="kinematic") as runner:
        process = await asyncio.create_subprocess_exec(
            sys.executable, "-c", program, node.local, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
        try:
            assert process.stdout is not None
            line = await process.stdout.readline()
            assert line == b"driving\n", (await process.communicate())[1].decode()
            await until(lambda: runner.snapshot.twist.vx > 0.1)
            yield runner, process
        finally:
            if process.returncode is None:
                process.kill()
            await process.communicate()


def state(runner) -> tuple[ReportStatus.Status, float]:
    return runner.components[0].host.status, round(runner.snapshot.twist.vx, 2)


STOPPED = (ReportStatus.Status.STANDBY, 0.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    "program",
    [
        ASYNCHRONOUS.format(what="await asyncio.sleep(60)"),
        SYNCHRONOUS.format(what="control.until_lost()"),
        pytest.param(SYNCHRONOUS.format(what="time.sleep(60)"), marks=pytest.mark.slow),
        pytest.param(
            WITHOUT_BLOCKS.format(what="await asyncio.sleep(60)", run="asyncio.run(main())"), marks=pytest.mark.slow
        ),
        pytest.param(
            WITHOUT_BLOCKS.format(
                what="await asyncio.sleep(60)", run="asyncio.new_event_loop().run_until_complete(main())"
            ),
            marks=pytest.mark.slow,
        ),
    ],
    ids=["async", "sync", "sync-sleeping", "without-blocks", "own-loop"],
)
@pytest.mark.parametrize("number", [signal.SIGTERM, pytest.param(signal.SIGHUP, marks=pytest.mark.slow)])
async def test_signal_stops_the_robot_before_the_program_ends(node_manager, program, number):
    async with driving(node_manager, program) as (runner, process):
        process.send_signal(number)
        assert await asyncio.wait_for(process.wait(), 5.0) == 128 + number
        assert runner.components[0].host.status == ReportStatus.Status.STANDBY
        await until(lambda: state(runner) == STOPPED, within=2.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    "program",
    [
        ASYNCHRONOUS.format(what="raise ValueError('a bug')"),
        SYNCHRONOUS.format(what="raise ValueError('a bug')"),
        WITHOUT_BLOCKS.format(what="raise ValueError('a bug')", run="asyncio.run(main())"),
    ],
    ids=["async", "sync", "without-blocks"],
)
async def test_unhandled_error_stops_the_robot_before_the_program_ends(node_manager, program):
    async with driving_until_error(node_manager, program) as runner:
        assert runner.components[0].host.status == ReportStatus.Status.STANDBY
        await until(lambda: state(runner) == STOPPED, within=2.0)


@asynccontextmanager
async def driving_until_error(node, program: str):
    async with driving(node, program.replace("raise", "time.sleep(0.3); raise").replace("sys\n", "sys, time\n")) as (
        runner,
        process,
    ):
        assert await asyncio.wait_for(process.wait(), 5.0) == 1
        yield runner


@pytest.mark.slow
async def test_hung_program_loses_control_and_the_robot_stops(node_manager):
    async with driving(node_manager, ASYNCHRONOUS.format(what="time.sleep(60)")) as (runner, process):
        await until(lambda: abs(runner.snapshot.twist.vx) < 0.01, within=CONTROL_TIMEOUT + 2.0)
        async with OCU("42.1.2", node_manager.local) as other:
            await until_released(other)
        assert process.returncode is None


async def until_released(other: OCU) -> None:
    async with asyncio.timeout(CONTROL_TIMEOUT + 2.0):
        while "nobody" not in await other.explain(DRIVER):
            await asyncio.sleep(0.1)


@pytest.mark.slow
async def test_program_that_handles_sigterm_itself_keeps_its_handler(node_manager):
    program = ASYNCHRONOUS.format(what="await asyncio.sleep(60)").replace(
        "asyncio.run", "import signal; signal.signal(signal.SIGTERM, lambda *_: sys.exit(7)); asyncio.run"
    )
    async with driving(node_manager, program) as (_, process):
        process.send_signal(signal.SIGTERM)
        assert await asyncio.wait_for(process.wait(), 5.0) == 7
