"""A backend that fails: its modules go to Failure with the reason, the others answer, and Reset brings them back."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import Any

import pytest
from tests.helpers.robot import FakeJoints, FakeRobot

from jauspy.backends.kinematic import KinematicBackend, KinematicDrive, KinematicRobot
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Twist
from jauspy.messages.core import ReportStatus, Reset
from jauspy.messages.manipulator import QueryJointPositions
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.ocu.service import ServiceClient
from jauspy.platform.commands import CHASSIS
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import SkidSteerDrive
from jauspy.platform.joints import JointState
from jauspy.robot.realtime import SLOW_STEP, WARNING_INTERVAL, WHOLE_ROBOT, RealTime
from jauspy.robot.robot_files import load
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork

Status = ReportStatus.Status
DRIVE = SetWrenchEffort(propulsive_linear_effort_x=40.0)


@asynccontextmanager
async def running(network: VirtualNetwork) -> AsyncIterator[tuple[RobotRunner, OCU, Robot, ServiceClient]]:
    """A robot that a client drives, and another client."""
    async with network.robot() as runner, network.ocu("42.1.1") as operator, network.ocu("42.1.2") as ocu:
        robot = await ocu.discover(101)
        driver = (await operator.discover(101)).service("PrimitiveDriver")
        async with driver.control():
            await driver.resume()
            await driver.send(DRIVE)
            yield runner, ocu, robot, driver


async def settle(robot: Robot, component: int, wanted: Status) -> None:
    management = robot.component(component).service("Management")
    async with asyncio.timeout(2.0):
        while await management.status() != wanted:
            await asyncio.sleep(0.05)


@pytest.mark.slow
async def test_a_part_that_cannot_be_commanded(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    async with running(virtual_network) as (runner, ocu, robot, driver):
        await asyncio.sleep(1.0)
        assert runner.snapshot.twist.vx > 0.1

        def no_bus(self: KinematicDrive, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
            raise OSError("no such bus")

        with monkeypatch.context() as broken:
            broken.setattr(KinematicDrive, "set_effort", no_bus)
            await driver.send(DRIVE)
            await settle(robot, 102, Status.FAILURE)
        assert "101.1.102 (CM-MOB) is in Failure: the chassis: OSError: no such bus; Reset tries again" in caplog.text
        await asyncio.sleep(1.0)
        assert runner.snapshot.twist.vx == pytest.approx(0.0, abs=1e-3)
        await settle(robot, 104, Status.STANDBY)
        assert (await ocu.query("101.1.104", QueryJointPositions())).joint_position_list

        await ocu.send("101.1.102", Reset(), ack=True)
        await settle(robot, 102, Status.STANDBY)
        assert not runner.faults
    async with running(virtual_network) as (runner, *_):
        await asyncio.sleep(1.0)
        assert runner.snapshot.twist.vx > 0.1


@pytest.mark.slow
async def test_a_robot_that_cannot_advance(virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch) -> None:
    async with running(virtual_network) as (runner, ocu, robot, _):
        with monkeypatch.context() as broken:
            broken.setattr(KinematicRobot, "advance", lambda self, dt: 1 / 0)
            for component in (102, 104, 105):
                await settle(robot, component, Status.FAILURE)
            stopped_at = runner.snapshot.time
            assert (await ocu.query("101.1.102", QueryLocalPose(0x1FF))).x is not None

            await ocu.send("101.1.102", Reset(), ack=True)
            await asyncio.sleep(0.5)
            await settle(robot, 102, Status.FAILURE)
            assert runner.snapshot.time == stopped_at
        for component in (102, 104, 105):
            await ocu.send(f"101.1.{component}", Reset(), ack=True)
            await settle(robot, component, Status.STANDBY)
        await asyncio.sleep(0.2)
        assert runner.snapshot.time > stopped_at


async def test_a_backend_that_cannot_open_is_one_sentence(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_bus(self: KinematicBackend, robot: object, world: str) -> None:
        raise OSError("no such bus")

    monkeypatch.setattr(KinematicBackend, "open", no_bus)
    runner = RobotRunner(load("inc1"), virtual_network.transport, backend="kinematic")
    with pytest.raises(ConfigError, match="the backend 'kinematic' cannot open the robot: OSError: no such bus"):
        await runner.open()


class Changed:
    """A part with other attributes, or without one."""

    def __init__(self, part: object, missing: str = "", **changes: object) -> None:
        self._part, self._missing = part, missing
        vars(self).update(changes)

    def __getattr__(self, name: str) -> object:
        if name == self._missing:
            raise AttributeError(name)
        return getattr(self._part, name)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (
            lambda robot: Changed(robot, drive=Changed(robot.drive, "twist")),
            r"its drive \(Changed\) has no method twist\(\), which must be there: Velocity of the base in its",
        ),
        (
            lambda robot: setattr(robot.drive, "pose", lambda: (0.0, 0.0)),
            r"KinematicDrive\.pose\(\) returned a tuple, not a P",
        ),
        (lambda robot: setattr(robot.drive, "pose", lambda: Pose(y=math.nan)), r"\.pose\(\) returned y = nan"),
        (
            lambda robot: setattr(robot.groups["arm"], "state", lambda: None),
            r"\.state\(\) returned None, not a JointState",
        ),
        (
            lambda robot: setattr(robot.groups["arm"], "state", lambda: JointState((0.0,) * 5, (0.0,) * 4, (0.0,) * 5)),
            r"\.state\(\) of the group 'arm' returned 4 velocities for 5 joints",
        ),
        (lambda robot: setattr(robot.drive, "stop", None), "stop of its drive .* is None, and must be a method"),
        (
            lambda robot: Changed(robot, lidars=None),
            "lidars of the robot .* must be a mapping of parts by name, not None",
        ),
        (lambda robot: setattr(robot.drive, "pose", lambda: 1 / 0), "cannot read the robot: ZeroDivisionError"),
    ],
)
async def test_what_a_backend_does_otherwise_than_the_contract_is_one_sentence(
    virtual_network: VirtualNetwork, change: Callable[[Any], Any], sentence: str
) -> None:
    class Backend(KinematicBackend):
        name = "mine"

        def open(self, robot: RobotModel, world: str) -> KinematicRobot:
            found = super().open(robot, world)
            return change(found) or found

    runner = RobotRunner(load("inc1"), virtual_network.transport, backend=Backend())
    with pytest.raises(ConfigError, match=f"the backend 'mine'.*{sentence}"):
        await runner.open()


@pytest.mark.slow
async def test_a_position_that_is_no_number_is_a_fault(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    async with running(virtual_network) as (runner, _, robot, _):
        monkeypatch.setattr(KinematicDrive, "pose", lambda self: Pose(x=math.nan))
        await settle(robot, 102, Status.FAILURE)
        assert math.isfinite(runner.snapshot.pose.x)
        assert "the robot: ValueError: KinematicDrive.pose() returned x = nan; Reset tries again" in caplog.text


def test_a_fault_stops_every_other_part(fake_robot: FakeRobot) -> None:
    arm = fake_robot.groups["arm"] = FakeJoints()
    runner = RealTime(fake_robot)
    runner.open()
    try:
        holds = arm.holds
        fake_robot.drive.set_effort = lambda *_: 1 / 0  # type: ignore[assignment]
        runner.drive.set_effort(1.0, 0.0)
        fake_robot.wait_for_steps(3)
        assert set(runner.faults) == {CHASSIS}
        assert arm.holds > holds
        steps = runner.counters["faults"]
        runner.drive.set_effort(1.0, 0.0)  # a failed part gets no commands
        fake_robot.wait_for_steps(3)
        assert runner.counters["faults"] == steps
    finally:
        runner.close()


def test_a_slow_backend_is_warned_about(fake_robot: FakeRobot, caplog: pytest.LogCaptureFixture) -> None:
    now = [0.0]
    advance = fake_robot.advance

    def slow(dt: float) -> None:
        now[0] += 2 * SLOW_STEP
        advance(dt)

    fake_robot.advance = slow  # type: ignore[method-assign]
    with RealTime(fake_robot, clock=lambda: now[0]) as runner:
        fake_robot.wait_for_steps(5)
        assert runner.counters["slow"] >= 4
    assert 1 <= caplog.text.count("a step of the robot took 0.30 s") <= 1 + now[0] / WARNING_INTERVAL


def test_a_robot_that_fails_once_works_again_after_a_retry(fragile_robot: FakeRobot) -> None:
    with RealTime(fragile_robot) as runner:
        while not runner.faults:
            pass
        assert runner.faults == {WHOLE_ROBOT: "RuntimeError: a track came off"}
        runner.retry(WHOLE_ROBOT)
        fragile_robot.wait_for_steps(3)
        assert not runner.faults


async def test_an_incomplete_backend_is_told_what_it_lacks(
    virtual_network: VirtualNetwork, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Drive(SkidSteerDrive):
        def twist(self) -> Twist:
            return Twist()

    monkeypatch.setattr(KinematicBackend, "open", lambda self, robot, world: Drive())  # type: ignore[abstract]
    runner = RobotRunner(load("inc1"), virtual_network.transport, backend="kinematic")
    with pytest.raises(
        ConfigError, match=r"^the backend 'kinematic' is incomplete: Drive lacks .*pose\(\).*, which must be there"
    ) as caught:
        await runner.open()
    assert "set_track_efforts()" in str(caught.value)
    assert "twist()" not in str(caught.value)
