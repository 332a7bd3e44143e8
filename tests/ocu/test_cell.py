"""The modules of a factory cell by verbs: arm, connectors, servos, belt, parts and their power; without physics."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator

import pytest
from tests.helpers.memory_cell import MemoryBackend, MemoryCell

from jauspy.errors import ConfigError, RequestError
from jauspy.ocu import Robot
from jauspy.ocu.cell import check_arrived
from jauspy.platform.modular.arm import ArmController, ModularArmState
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
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


class TestArrived:
    STATE = ModularArmState(joints=("servo_1", "servo_2"), positions=(0.5, 0.1), targets=(0.5, 0.1))

    def test_at_the_targets(self) -> None:
        check_arrived(self.STATE, [0.5, math.nan])

    def test_near_the_goal_it_does_not_matter_that_the_target_has_changed(self) -> None:
        check_arrived(self.STATE, [0.51, 0.1])

    def test_stopped_or_moved_elsewhere(self) -> None:
        with pytest.raises(
            RequestError, match=r"elsewhere: servo_2 was told to be at 0\.100 rad after it was told .* 0\.3"
        ):
            check_arrived(self.STATE, [0.5, 0.3])

    def test_an_arm_of_other_joints(self) -> None:
        with pytest.raises(RequestError, match="has 2 joints now, the motion was for 1"):
            check_arrived(self.STATE, [0.5])


async def test_modular_arm_moves_and_says_what_it_refuses(cell):
    _, robot = cell
    arm = robot.component(ARM).modular_arm
    async with robot.control(str(ARM)):
        state = await arm.move([0.5, -0.25], 0.4)
        assert state.joints == ("servo_1", "servo_2")
        assert state.positions == pytest.approx((0.5, -0.25), abs=1e-3)
        await arm.move([math.nan, 0.75])
        assert (await arm.state()).positions == pytest.approx((0.5, 0.75), abs=1e-3)
        with pytest.raises(RequestError, match=r"refused to move: motion refused: 1 positions for 2 joints"):
            await arm.move([0.1])
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
