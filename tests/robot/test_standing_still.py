"""A robot that stands still because nobody steps or watches it any more never does so silently."""

from __future__ import annotations

import asyncio
import logging
import threading
from collections.abc import Iterator

import pytest
from tests.helpers.robot import FakeRobot

from jauspy.backends.kinematic import KinematicRobot
from jauspy.messages.core import ReportStatus, Reset
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.robot import realtime
from jauspy.robot.realtime import RECOVERY_TIME, STALL_TIME, WHOLE_ROBOT, RealTime, StepTimer
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

BEAT = 0.25
DRIVE = SetWrenchEffort(propulsive_linear_effort_x=40.0)
OPEN_AGAIN = "close the robot, and open it again"
MODULES = (102, 104, 105)
Status = ReportStatus.Status


class PanicError(BaseException):
    """Derived from `BaseException`, as are the panics of extensions in Rust and the time limit of a test."""


class Clock:
    """Seconds that a test sets; each reading takes a millisecond."""

    def __init__(self) -> None:
        self.now = 50.0

    def __call__(self) -> float:
        self.now += 0.001
        return self.now


class HangingRobot(FakeRobot):
    """A robot whose second step ends only when the test says so."""

    def __init__(self, breaks_after: int | None = None) -> None:
        super().__init__(breaks_after)
        self.hangs, self.goes_on = threading.Event(), threading.Event()

    def advance(self, dt: float) -> None:
        super().advance(dt)
        if self.steps == 2:
            self.hangs.set()
            assert self.goes_on.wait(30.0)


@pytest.fixture
def hanging_robot() -> Iterator[HangingRobot]:
    robot = HangingRobot()
    yield robot
    robot.goes_on.set()


def beat(runner: RealTime, clock: Clock, seconds: float) -> None:
    """Heartbeats of a program that runs for this time."""
    for _ in range(round(seconds / BEAT)):
        clock.now += BEAT
        runner.alive()


# --- a thread that does not advance -----------------------------------------------------------------------------------


def test_a_step_that_does_not_end_is_a_fault_and_the_robot_stands_until_a_retry(
    hanging_robot: HangingRobot, caplog: pytest.LogCaptureFixture
) -> None:
    clock = Clock()
    with RealTime(hanging_robot, clock=clock) as runner:
        assert hanging_robot.hangs.wait(30.0)
        runner.alive()  # it sees the first step
        beat(runner, clock, STALL_TIME - BEAT)
        assert not runner.faults
        beat(runner, clock, 2 * BEAT)
        assert runner.faults == {WHOLE_ROBOT: "no step has ended for 3 s: the backend or its thread hangs"}
        assert [record.message for record in caplog.records if record.levelno == logging.ERROR] == [
            "the robot failed: no step has ended for 3 s: the backend or its thread hangs"
        ]
        runner.retry(WHOLE_ROBOT)
        beat(runner, clock, BEAT)
        assert runner.faults, "it hangs still"

        runner.drive.set_effort(1.0, 0.0)
        ended = runner.counters["steps"]
        hanging_robot.goes_on.set()
        while runner.counters["steps"] < ended + 3:
            pass
        assert hanging_robot.drive.effort == (0.0, 0.0), "what was commanded meanwhile moves nothing"
        assert hanging_robot.steps == 2
        beat(runner, clock, BEAT)
        assert "the robot's thread steps again, after more than 3." in caplog.text
        runner.retry(WHOLE_ROBOT)
        hanging_robot.wait_for_steps(3)
        assert not runner.faults


def test_a_program_that_was_held_up_does_not_take_its_robot_for_hanging(hanging_robot: HangingRobot) -> None:
    clock = Clock()
    with RealTime(hanging_robot, clock=clock) as runner:
        assert hanging_robot.hangs.wait(30.0)
        for _ in range(4):
            clock.now += 1000.0
            runner.alive()
        assert not runner.faults
        hanging_robot.goes_on.set()


def test_motors_that_are_enabled_have_more_time(fake_robot: FakeRobot) -> None:
    clock, began, goes_on = Clock(), threading.Event(), threading.Event()

    def enable() -> None:
        began.set()
        assert goes_on.wait(30.0)

    with RealTime(fake_robot, clock=clock) as runner:
        done = runner.enable(enable)
        assert began.wait(30.0)
        runner.alive()
        beat(runner, clock, RECOVERY_TIME - 2 * BEAT)
        assert not runner.faults
        beat(runner, clock, 3 * BEAT)
        assert runner.faults == {WHOLE_ROBOT: "no step has ended for 30 s: the backend or its thread hangs"}
        goes_on.set()
        done.result(30.0)


def test_a_robot_that_recovers_has_more_time() -> None:
    clock, robot = Clock(), HangingRobot(breaks_after=1)
    with RealTime(robot, clock=clock) as runner:
        while not runner.faults:
            pass
        runner.retry(WHOLE_ROBOT)
        assert robot.hangs.wait(30.0), "as while its drives are configured"
        runner.alive()
        beat(runner, clock, 2 * STALL_TIME)
        robot.goes_on.set()
        robot.wait_for_steps(1)
        assert not runner.faults


def test_a_robot_that_is_retried_amid_a_step_has_more_time_too(monkeypatch: pytest.MonkeyPatch) -> None:
    clock, robot = Clock(), HangingRobot(breaks_after=1)
    with RealTime(robot, clock=clock) as runner:
        while not runner.faults:
            pass
        monkeypatch.setattr(robot.drive, "set_effort", lambda *_: runner.retry(WHOLE_ROBOT))
        runner.drive.set_effort(1.0, 0.0)  # a command is applied before the robot is advanced
        assert robot.hangs.wait(30.0)
        runner.alive()
        beat(runner, clock, 2 * STALL_TIME)
        robot.goes_on.set()
        assert not runner.faults
        robot.wait_for_steps(1)
        assert not runner.faults


def test_a_robot_that_cannot_be_closed_is_told(
    hanging_robot: HangingRobot, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    class Releasing(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            hanging_robot.goes_on.set()

    monkeypatch.setattr(realtime, "CLOSING_TIME", 0.01)
    logger, handler = logging.getLogger("jauspy.robot"), Releasing()
    logger.addHandler(handler)
    try:
        with RealTime(hanging_robot):
            assert hanging_robot.hangs.wait(30.0)
    finally:
        logger.removeHandler(handler)
    assert "the robot cannot be closed: its thread has not ended for 0.01 s" in caplog.text


# --- a thread that ends -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("error", [SystemExit("no bus"), PanicError("no bus"), RuntimeError("no bus")])
def test_no_exception_of_the_robot_ends_its_thread(
    fake_robot: FakeRobot, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, error: BaseException
) -> None:
    def fail(dt: float) -> None:
        raise error

    with RealTime(fake_robot, clock=Clock()) as runner:
        fake_robot.wait_for_steps(1)
        with monkeypatch.context() as broken:
            broken.setattr(fake_robot, "advance", fail)
            while not runner.faults:
                assert not runner.ended.done()
            assert runner.faults == {WHOLE_ROBOT: f"{type(error).__name__}: no bus"}
            assert f"the robot failed: {type(error).__name__}: no bus" in caplog.text
        assert fake_robot.drive.stops
        runner.retry(WHOLE_ROBOT)
        fake_robot.wait_for_steps(2)
        assert not runner.faults


def test_a_robot_whose_parts_cannot_be_listed_keeps_its_thread() -> None:
    class Lost(FakeRobot):
        lost = False

        def __getattribute__(self, name: str) -> object:
            if name == "groups" and object.__getattribute__(self, "lost"):
                raise OSError("no bus")
            return super().__getattribute__(name)

    robot = Lost()
    with RealTime(robot, clock=Clock()) as runner:
        robot.wait_for_steps(1)
        robot.lost = True
        while not runner.faults:
            assert not runner.ended.done()
        robot.lost = False
        runner.retry(WHOLE_ROBOT)
        robot.wait_for_steps(2)


def test_motors_whose_enabling_panics_do_not_keep_the_program_waiting(fake_robot: FakeRobot) -> None:
    def enable() -> None:
        raise PanicError("no bus")

    with RealTime(fake_robot, clock=Clock()) as runner:
        with pytest.raises(PanicError, match="no bus"):
            runner.enable(enable).result(30.0)
        while not runner.faults:
            pass
        assert runner.faults == {WHOLE_ROBOT: "PanicError: no bus"}


def test_a_thread_that_ends_is_a_fault_that_stays(
    fake_robot: FakeRobot, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(self: StepTimer, now: float) -> None:
        raise RuntimeError("a defect")

    with RealTime(fake_robot) as runner:
        fake_robot.drive.set_effort(1.0, 0.0)
        monkeypatch.setattr(StepTimer, "begin", fail)
        with pytest.raises(RuntimeError, match="a defect"):
            runner.ended.result(30.0)
        why = "its thread has ended: RuntimeError: a defect"
        assert runner.faults == {WHOLE_ROBOT: why}
        assert f"the robot failed: {why}" in caplog.text
        assert fake_robot.drive.effort == (0.0, 0.0)
        runner.retry(WHOLE_ROBOT)
        assert runner.faults == {WHOLE_ROBOT: why}


# --- a program that does not run --------------------------------------------------------------------------------------


def test_a_stop_because_the_program_hangs_is_told_by_the_robots_thread(
    fake_robot: FakeRobot, caplog: pytest.LogCaptureFixture
) -> None:
    clock = Clock()
    with RealTime(fake_robot, heartbeat_timeout=1.0, clock=clock) as runner:
        clock.now += 2.0
        while not runner.counters["abandoned"]:
            pass
        assert "has not run" not in caplog.text, "it is starting"
        runner.alive()
        fake_robot.wait_for_steps(3)
        clock.now += 2.0
        abandoned = runner.counters["abandoned"]
        while runner.counters["abandoned"] == abandoned:
            pass
        fake_robot.wait_for_steps(3)
        assert caplog.text.count("the program has not run for 1 s: the robot is stopped") == 1


# --- the modules of a whole robot -------------------------------------------------------------------------------------


async def stands(network: VirtualNetwork, why: str, remedy: str, caplog: pytest.LogCaptureFixture) -> None:
    """The whole robot of `network` is in Failure for this reason, and a client is told."""
    async with network.ocu() as ocu:
        robot = await ocu.discover(101)
        for component in MODULES:
            assert await robot.component(component).service("Management").status() == Status.FAILURE
            assert f"101.1.{component} (" in caplog.text
        assert f"is in Failure: the robot: {why}; {remedy}" in caplog.text
        reason = await ocu.explain("101.1.102", DRIVE)
        assert reason.startswith("101.1.102 is in Failure: send Reset")
        await ocu.send("101.1.102", Reset(), ack=True)
        await asyncio.sleep(0.5)
        assert await robot.component(102).service("Management").status() == Status.FAILURE


async def test_a_step_task_that_was_cancelled_is_told(
    virtual_network: VirtualNetwork, caplog: pytest.LogCaptureFixture
) -> None:
    loop, reported = asyncio.get_running_loop(), []
    handler = loop.get_exception_handler()
    async with virtual_network.robot() as runner:
        await asyncio.sleep(0.5)
        loop.set_exception_handler(lambda _, context: reported.append(context["message"]))
        next(task for task in asyncio.all_tasks() if task.get_name() == "virtual robot").cancel()
        await asyncio.sleep(0.2)
        why = "the task that steps it has ended: it was cancelled"
        assert set(runner.faults.values()) == {f"the robot: {why}"}
        assert f"the robot failed: {why}" in caplog.text
        with pytest.raises(RuntimeError, match="the task that steps the robot was cancelled"):
            await runner.wait()
        await stands(virtual_network, why, OPEN_AGAIN, caplog)
    loop.set_exception_handler(handler)
    assert reported == ["the task that steps a virtual robot has ended"], "so that a test fails in which it ends"


async def test_a_step_task_that_ended_by_a_tests_time_limit_is_told(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(self: KinematicRobot, dt: float) -> None:
        raise PanicError("Timeout (>300.0s)")

    loop, reported = asyncio.get_running_loop(), []
    handler = loop.get_exception_handler()
    async with virtual_network.robot() as runner:
        loop.set_exception_handler(lambda _, context: reported.append(context["exception"]))
        with monkeypatch.context() as broken:
            broken.setattr(KinematicRobot, "advance", fail)
            await asyncio.sleep(0.2)
        why = "the task that steps it has ended: PanicError: Timeout (>300.0s)"
        await stands(virtual_network, why, OPEN_AGAIN, caplog)
        with pytest.raises(PanicError):
            await runner.wait()
    loop.set_exception_handler(handler)
    assert [type(error) for error in reported] == [PanicError]


async def test_heartbeats_that_end_while_the_robot_is_closed_are_no_failure(
    virtual_network: VirtualNetwork, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As with a second Ctrl-C, which cancels all tasks of a program."""
    async with virtual_network.robot("inc1") as robot:
        close = robot.components[-1].close

        async def slow_close() -> None:
            next(task for task in asyncio.all_tasks() if task.get_name() == "heartbeats").cancel()
            await asyncio.sleep(0.1)
            await close()

        monkeypatch.setattr(robot.components[-1], "close", slow_close)
    assert "heartbeats" not in caplog.text


@pytest.mark.slow
async def test_heartbeats_that_end_are_told(virtual_network: VirtualNetwork, caplog: pytest.LogCaptureFixture) -> None:
    async with virtual_network.robot() as runner, virtual_network.ocu("42.1.2") as ocu:
        driver = (await ocu.discover(101)).service("PrimitiveDriver")
        async with driver.control():
            await driver.resume()
            await driver.send(DRIVE)
            await asyncio.sleep(1.0)
            assert runner.snapshot.twist.vx > 0.1
            next(task for task in asyncio.all_tasks() if task.get_name() == "heartbeats").cancel()
            await asyncio.sleep(0.5)
        why = "the task 'heartbeats' of its program has ended: it was cancelled"
        await stands(virtual_network, why, OPEN_AGAIN, caplog)


@pytest.mark.slow
async def test_a_virtual_robot_that_does_not_advance_is_told(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(VirtualTime, "_make_step", lambda self: None)
    async with virtual_network.robot():
        await asyncio.sleep(STALL_TIME + 1.0)
        why = "no step has ended for 3 s: the backend or its thread hangs"
        await stands(virtual_network, why, "Reset tries again", caplog)


async def test_a_robot_is_closed_without_a_report(
    virtual_network: VirtualNetwork, caplog: pytest.LogCaptureFixture
) -> None:
    async with virtual_network.robot() as runner:
        waiting = asyncio.create_task(runner.wait())
        await asyncio.sleep(2.0)
    await waiting
    assert not [record for record in caplog.records if record.levelno >= logging.WARNING]
