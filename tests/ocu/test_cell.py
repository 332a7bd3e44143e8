"""The modules of a factory cell by verbs: arm, connectors, servos, belt, parts and their power; without physics."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator

import pytest
from tests.helpers.memory_cell import MemoryBackend, MemoryCell

from jauspy.errors import ConfigError, RequestError
from jauspy.messages.cell import HoldModularArm, ScheduleConnector
from jauspy.ocu import Robot
from jauspy.platform.modular.arm import ArmController, MotionResult, TrajectoryPoint
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.services.cell import motion_command, trajectory_command
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

CONFIG = robot_files.load("cell")
IDS = {module.part or module.type: CONFIG.id_of(module) for module in CONFIG.modules if module.type != "CM-MOB"}
ARM = IDS["arm"]
APPLIED = 0.05
"""Seconds in which the robot has taken a command."""


@pytest.fixture
async def cell(virtual_network: VirtualNetwork) -> AsyncIterator[tuple[MemoryCell, Robot]]:
    backend = MemoryBackend()
    async with RobotRunner(CONFIG, virtual_network.transport, backend=backend, realtime=VirtualTime):
        assert backend.robot is not None
        backend.robot.assemble("servo_1", "servo_2")
        async with virtual_network.ocu("42.1.1") as ocu:
            robot = await ocu.robot(CONFIG.subsystem)
            while IDS["servo_2"] not in {each.id for each in robot.components}:
                robot = await ocu.robot(CONFIG.subsystem)
            yield backend.robot, robot


@pytest.mark.slow
async def test_modular_arm_moves_and_says_what_it_refuses(cell):
    _, robot = cell
    arm = robot.component(ARM).modular_arm
    async with robot.control(str(ARM)):
        state = await arm.move([0.5, -0.25], 0.4)
        assert state.joints == ("servo_1", "servo_2")
        assert state.positions == pytest.approx((0.5, -0.25), abs=1e-3)
        await arm.move([math.nan, 0.75])
        assert (await arm.state()).positions == pytest.approx((0.5, 0.75), abs=1e-3)
        with pytest.raises(RequestError, match=r"^1 positions for 2 joints \(servo_1, servo_2\)"):
            await arm.move([math.nan])
        with pytest.raises(RequestError, match=r"refused to move: motion refused: \[1\] positions for 2 joints"):
            await arm.move([0.1])
        with pytest.raises(RequestError, match=r"refused to move: motion refused: \[2\] positions"):
            await arm.move([0.1, 0.1], -1.0)
        with pytest.raises(TypeError, match="joint 2 is a number, not the str 'up'"):
            await arm.begin([0.1, "up"])
        await arm.set_controller(ArmController.PID)
        await asyncio.sleep(APPLIED)
        assert (await arm.state()).controller is ArmController.PID
        await arm.begin([2.0, 2.0], 30.0)
        await asyncio.sleep(APPLIED)
        assert (await arm.state()).moving
        await arm.stop()
        await asyncio.sleep(APPLIED)
        assert not (await arm.state()).moving


@pytest.mark.slow
async def test_motions_end_with_their_own_result_and_reason(cell):
    memory, robot = cell
    arm = robot.component(ARM).modular_arm
    assert await arm.result() == (MotionResult.UNKNOWN, "the arm has taken no motion since the component was started")
    async with robot.control(str(ARM)):
        first = await arm.begin([3.0, 3.0], 9.0)
        assert await arm.result(first) == (MotionResult.IN_PROGRESS, "")
        second = await arm.begin([0.1, 0.1], 9.0)
        assert await arm.result(first) == (MotionResult.REPLACED, "another motion took its place")
        await arm.stop()
        assert await arm.result(second) == (MotionResult.STOPPED, "the arm was told to hold")
        third = await arm.begin([0.2, 0.1], 0.3)
        await asyncio.sleep(0.5)
        assert await arm.result(third) == await arm.result() == (MotionResult.REACHED, "")
        assert (await arm.result(first))[0] is MotionResult.REPLACED, "later motions do not change it"
        moving = asyncio.create_task(arm.move([1.0, 1.0], 9.0))
        await asyncio.sleep(0.3)
        memory.power.switch("servo_2", on=False)
        with pytest.raises(RequestError, match=r"did not complete the motion: .* no report of servo_2"):
            await moving


@pytest.mark.slow
async def test_blocked_arm_is_reported_within_a_fraction_of_a_second(cell):
    memory, robot = cell
    arm, clock = robot.component(ARM).modular_arm, asyncio.get_running_loop().time
    words = "Blocked: servo_1, 6 N m, 0.31 rad short; the arm holds where it is"
    async with robot.control(str(ARM)):
        moving = asyncio.create_task(arm.move([1.0, 1.0], 9.0))
        await asyncio.sleep(0.5)
        memory.arm.block(words)
        blocked = clock()
        with pytest.raises(RequestError, match=f"^{words}"):
            await moving
        assert clock() - blocked < 0.5


@pytest.mark.slow
async def test_state_of_an_earlier_motion_is_not_taken_for_a_new_one(cell, monkeypatch):
    """The robot's thread takes the motion late, and its state meanwhile is that of a motion that has succeeded."""
    memory, robot = cell
    arm = robot.component(ARM).modular_arm
    begin, late = memory.arm.begin, []
    async with robot.control(str(ARM)):
        await arm.move([0.1, 0.1], 0.2)
        monkeypatch.setattr(memory.arm, "begin", late.append)
        moving = asyncio.create_task(arm.move([0.4, 0.4], 0.2))
        await asyncio.sleep(1.0)
        assert not moving.done()
        assert not (await arm.state()).moving, "which says nothing of the motion that is to come"
        begin(late[0])
        assert (await moving).positions == pytest.approx((0.4, 0.4), abs=1e-3)


async def test_trajectory_moves_named_joints(cell):
    _, robot = cell
    arm = robot.component(ARM).modular_arm
    async with robot.control(str(ARM)):
        points = [TrajectoryPoint(0.2, (0.1,), (0.5,)), TrajectoryPoint(0.4, (0.2,))]
        state = await arm.follow(["servo_2"], points)
        assert state.positions == pytest.approx((0.0, 0.2), abs=1e-3)
        with pytest.raises(RequestError, match=r"refused to move: motion refused: no joint servo_9"):
            await arm.follow(["servo_9"], points)
        with pytest.raises(ConfigError, match="point 2 has 2 values for 1 joints"):
            await arm.follow(["servo_2"], [points[0], TrajectoryPoint(0.4, (0.2,), (0.0, 0.0))])
        with pytest.raises(RequestError, match=r"no points|positions"):
            await arm.follow(["servo_2"], [])


async def test_perform_says_why_the_arm_did_not_move(cell):
    _, robot = cell
    service = robot.component(ARM).service("ModularArm")
    async with robot.control(str(ARM)):
        with pytest.raises(RequestError, match=r"did not carry out MoveModularArm .*: motion refused: \[1\] positions"):
            await service.perform(motion_command([0.5]), within=2.0)
        moving = asyncio.create_task(service.perform(motion_command([0.5, 0.5], 5.0), within=9.0))
        await asyncio.sleep(0.2)
        await service.send(motion_command([0.1, 0.1], 5.0), ack=True)
        with pytest.raises(RequestError, match=r"MoveModularArm .*: another motion took its place"):
            await moving
        moving = asyncio.create_task(
            service.perform(trajectory_command(["servo_1"], [TrajectoryPoint(5.0, (1.0,))], 77), within=9.0)
        )
        await asyncio.sleep(0.2)
        await service.send(HoldModularArm(), ack=True)
        with pytest.raises(RequestError, match=r"SetModularArmTrajectory .*: the arm was told to hold"):
            await moving


async def test_motion_that_does_not_end_says_how_far_it_is(cell):
    _, robot = cell
    async with robot.control(str(ARM)):
        with pytest.raises(RequestError, match=r"still moves, \d\.\d+ rad off its target"):
            await robot.component(ARM).modular_arm.move([3.0, 3.0], 0.0, timeout=0.2)


async def test_connector_attaches_and_releases(cell):
    memory, robot = cell
    connector = robot.component(IDS["gripper"]).connector()
    async with robot.control(str(IDS["gripper"])):
        await connector.enable()
        await asyncio.sleep(APPLIED)
        state = await connector.state()
        assert (state.enabled, state.attached_to, state.last_error) == (True, "", "nothing touches the plate")
        memory.connectors["gripper"].touches = "box_1"
        await connector.enable()
        await asyncio.sleep(APPLIED)
        assert (await connector.state()).attached_to == "box_1"
        await connector.disable()
        await asyncio.sleep(APPLIED)
        assert not (await connector.state()).enabled
        with pytest.raises(TypeError, match="number is a whole number"):
            robot.component(IDS["gripper"]).connector("output")


async def test_a_connector_is_set_after_a_delay_unless_something_else_comes(cell):
    memory, robot = cell
    gripper, connector = memory.connectors["gripper"], robot.component(IDS["gripper"]).connector()
    async with robot.control(str(IDS["gripper"])):
        await connector.enable(after=0.5)
        await asyncio.sleep(APPLIED)
        assert gripper.scheduled == (True, 0.5)
        await connector.disable(after=60.0)
        await asyncio.sleep(APPLIED)
        assert gripper.scheduled == (False, 60.0)
        await connector.enable()
        await asyncio.sleep(APPLIED)
        assert gripper.scheduled is None
        for after in (-0.1, 60.1, math.nan, math.inf):
            with pytest.raises(ConfigError, match=r"after=.* is outside 0\.\.60 s"):
                await connector.disable(after=after)
        for delay in (-0.1, 60.1, 1e300):
            command = ScheduleConnector(1, ScheduleConnector.Enabled.DISABLED, delay)
            await robot.component(IDS["gripper"]).service("VacuumConnector").send(command)
        await asyncio.sleep(APPLIED)
        assert gripper.scheduled is None
        await connector.disable(after=30.0)
        await asyncio.sleep(APPLIED)
        assert gripper.scheduled == (False, 30.0)
    await asyncio.sleep(APPLIED)
    assert gripper.scheduled is None, "control was released"


async def test_a_command_before_control_is_released_takes_effect(cell):
    memory, robot = cell
    gripper, connector = memory.connectors["gripper"], robot.component(IDS["gripper"]).connector()
    gripper.touches = "box_1"
    async with robot.control(str(IDS["gripper"])):
        await connector.enable()
        await asyncio.sleep(APPLIED)
        await connector.disable()
    await asyncio.sleep(APPLIED)
    assert (gripper.current.enabled, gripper.current.attached_to) == (False, "")


async def test_a_release_is_scheduled_right_after_the_pump_was_started(cell):
    memory, robot = cell
    gripper, connector = memory.connectors["gripper"], robot.component(IDS["gripper"]).connector()
    async with robot.control(str(IDS["gripper"])):
        await connector.enable()
        await connector.disable(after=5.0)
        await asyncio.sleep(APPLIED)
        assert (gripper.current.enabled, gripper.scheduled) == (True, (False, 5.0))


async def test_belt_runs_and_servo_reports(cell):
    memory, robot = cell
    belt, servo = robot.component(IDS["CM-CNV"]).conveyor, robot.component(IDS["servo_1"]).servo
    async with robot.control(str(IDS["CM-CNV"])):
        await belt.run(0.25)
        await asyncio.sleep(APPLIED)
        assert (await belt.state()).speed == pytest.approx(0.25)
        await belt.run(0)
        await asyncio.sleep(APPLIED)
        assert memory.conveyor.current.speed == 0.0
    assert (await servo.state()).voltage == pytest.approx(36.0)


async def test_parts_are_observed_and_modules_switched(cell):
    memory, robot = cell
    station = robot.component(IDS["CM-PRT"]).part_station
    seen = await station.observe()
    part = next(iter(memory.cell.parts))
    assert seen.types[part.name] == part.type
    assert seen.poses[part.name].position == pytest.approx((part.pose.x, part.pose.y, part.pose.z))
    assert seen.time > 0.0
    async with robot.control(str(IDS["CM-PRT"])):
        power = await station.energy()
        assert power.switches["servo_1"]
        assert power.consumption["servo_1"].energy == 10.0
        assert power.energy == 10.0 * len(power.switches)
        assert power.batteries["car"].charge == 0.5
        await station.switch(["servo_1"], on=False)
        await asyncio.sleep(APPLIED)
        assert not memory.power.switches["servo_1"]
        await station.switch(["servo_1"], on=True)
        await asyncio.sleep(APPLIED)
        assert memory.power.switches["servo_1"]


async def test_component_without_such_a_module_says_what_it_offers(cell):
    _, robot = cell
    with pytest.raises(ConfigError, match=r"does not offer ModularArm; it offers .*VacuumConnector"):
        _ = robot.component(IDS["gripper"]).modular_arm
