"""The modules of a factory cell as JAUS components: they appear with their power, and obey one client."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import dataclass, replace

import pytest
from tests.helpers.memory_cell import MemoryBackend, MemoryCell

from jauspy import OCU
from jauspy.errors import ConfigError, TransportError
from jauspy.geometry.poses import Pose
from jauspy.messages import cell as m, mobility
from jauspy.messages.core import QueryConfiguration
from jauspy.platform.modular.cell import CarState
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.services.cell import motion_command
from jauspy.services.core.discovery import SUBSYSTEM
from jauspy.transport import LoopbackTransport
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

CONFIG = robot_files.load("cell")
IDS = {module.part or module.type: str(CONFIG.id_of(module)) for module in CONFIG.modules if module.type != "CM-MOB"}
ALWAYS = {"201.1.10", "201.1.11", "201.1.12", "201.1.13", "201.3.1"}
BASE_PARTS = ("platform_1", "platform_2", "car")
BASES = {IDS[name] for name in BASE_PARTS}


@dataclass
class World:
    """A cell that runs, and a client."""

    network: VirtualNetwork
    backend: MemoryBackend
    runner: RobotRunner
    ocu: OCU

    @property
    def robot(self) -> MemoryCell:
        assert self.backend.robot is not None
        return self.backend.robot

    @property
    def ids(self) -> set[str]:
        return {str(component.id) for component in self.runner.components}


@asynccontextmanager
async def world() -> AsyncIterator[World]:
    backend = MemoryBackend()
    async with VirtualNetwork() as network:
        runner = RobotRunner(CONFIG, network.transport, backend=backend, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            yield World(network, backend, runner, ocu)


async def test_modules_appear_and_disappear_with_their_power():
    async with world() as cell:
        assert cell.ids == ALWAYS | BASES
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.2)
        assert cell.ids == ALWAYS | BASES | {IDS["servo_1"], IDS["tube_1"], IDS["servo_2"]}
        cell.robot.connectors["servo_1/output"].set(False)
        await asyncio.sleep(0.2)
        assert cell.ids == ALWAYS | BASES | {IDS["servo_1"]}
        cell.robot.power.switch("servo_1", False)
        await asyncio.sleep(0.2)
        assert cell.ids == ALWAYS | BASES
    assert cell.runner.components == ()


@pytest.mark.slow
async def test_discovery_follows_at_once():
    async with world() as cell:
        cell.robot.assemble("servo_1", "tube_1", "servo_2")
        await asyncio.sleep(0.1)
        robot = await cell.ocu.discover(201)
        assert {str(each.id) for each in robot.components} == cell.ids
        services = {each.urn.rpartition(":")[2] for each in robot.component(IDS["servo_1"]).info.services}
        assert services >= {"ServoModule", "VacuumConnector", "Management", "AccessControl", "Discovery"}
        answers = await offers(cell, "201.1.10")
        assert answers == cell.ids
        cell.robot.connectors["platform_1/top"].set(False)
        await asyncio.sleep(0.1)
        assert await offers(cell, "201.1.10") == cell.ids == ALWAYS | BASES
        robot = await cell.ocu.discover(201)
        assert {str(each.id) for each in robot.components} == ALWAYS | BASES


async def offers(cell: World, id: str) -> set[str]:
    """The components that the Discovery of one of them names."""
    report = await cell.ocu.query(id, QueryConfiguration(SUBSYSTEM))
    nodes = [(node.node_rec.node_id, node.component_list) for node in report.node_list]
    return {f"201.{node}.{each.component_id}" for node, components in nodes for each in components}


@pytest.mark.slow
async def test_all_modules_at_once_are_discovered():
    async with world() as cell:
        parts = [module.part for module in CONFIG.modules if module.node == 2 and module.part not in BASE_PARTS]
        cell.robot.assemble(*parts)
        await asyncio.sleep(0.2)
        robot = await cell.ocu.discover(201)
        assert {str(each.id) for each in robot.components} == cell.ids
        assert len(cell.ids) == len(CONFIG.modules) - 1  # without the car, which has no wheels


@pytest.mark.slow
async def test_the_car_appears_with_its_wheels_and_is_driven_by_the_public_services():
    async with world() as cell:
        cell.robot.car.current = CarState(assembled=True, pose=Pose(1.0, 2.0, 0.0, yaw=0.5))
        await asyncio.sleep(0.1)
        assert "201.1.20" in cell.ids
        robot = await cell.ocu.discover(201)
        car = robot.component("201.1.20")
        pose = await car.service("LocalPoseSensor").query(
            mobility.QueryLocalPose(0xFFFF), expects=mobility.ReportLocalPose
        )
        assert (pose.x, pose.y, pose.yaw) == pytest.approx((1.0, -2.0, -0.5), abs=1e-3)
        driver = car.service("PrimitiveDriver")
        async with driver.control():
            await driver.resume()
            await driver.send(mobility.SetWrenchEffort(propulsive_linear_effort_x=50.0), ack=True)
            await asyncio.sleep(0.5)
            assert cell.robot.car.effort == pytest.approx((0.5, 0.0), abs=1e-3)
        await asyncio.sleep(0.2)
        assert cell.robot.car.effort == (0.0, 0.0)
        cell.robot.car.current = replace(cell.robot.car.current, assembled=False)
        await asyncio.sleep(0.2)
        assert "201.1.20" not in cell.ids


async def test_a_client_loses_a_module_that_loses_its_power():
    async with world() as cell:
        cell.robot.assemble("servo_1")
        cell.robot.arm._joints = list
        await asyncio.sleep(0.2)
        robot = await cell.ocu.discover(201)
        servo = robot.component(IDS["servo_1"]).service("ServoModule")
        async with servo.control() as control:
            await servo.resume()
            await servo.send(m.SetServoTarget(m.SetServoTarget.Mode.VELOCITY_MODE, 0.5), ack=True)
            await asyncio.sleep(0.1)
            assert cell.robot.servos["servo_1"].current.velocity == 0.5
            cell.robot.power.switch("servo_1", False)
            async with asyncio.timeout(10.0):
                await control.until_lost()
        cell.robot.power.switch("servo_1", True)
        await asyncio.sleep(0.2)
        assert cell.robot.servos["servo_1"].current.velocity == 0.0, "the next client must not inherit a motion"
        async with servo.control():
            await servo.resume()


async def test_changes_of_a_connector_are_events():
    async with world() as cell:
        gripper = (await cell.ocu.discover(201)).component("201.1.11").service("VacuumConnector")
        async with gripper.subscribe(m.QueryConnectorState(0b11, 1)) as changes:
            reports = aiter(changes)
            assert (await anext(reports)).attached_to == ""
            cell.robot.attach("gripper", "box_1")
            report = await anext(reports)
            assert (report.enabled, report.attached_to) == (1, "box_1")


@pytest.mark.slow
async def test_periodic_events_of_the_modular_arm():
    async with world() as cell:
        cell.robot.assemble("servo_1", "servo_2")
        arm = (await cell.ocu.discover(201)).component("201.3.1").service("ModularArm")
        began = cell.network.now()
        async with arm.subscribe(m.QueryModularArmState(), rate=20.0) as states:
            reports = aiter(states)
            for _ in range(20):
                state = await anext(reports)
        assert [each.name for each in state.joint_list] == ["servo_1", "servo_2"]
        assert cell.network.now() - began == pytest.approx(1.0, abs=0.2)


@pytest.mark.slow
@pytest.mark.parametrize("lost", ["released", "client gone"])
async def test_all_motion_stops_within_200_ms_of_the_loss_of_control(lost):
    async with world() as cell:
        cell.robot.assemble("servo_1", "servo_2")
        await asyncio.sleep(0.2)
        robot = await cell.ocu.discover(201)
        belt, arm = (
            robot.component(id).service(name) for id, name in (("201.1.12", "Conveyor"), ("201.3.1", "ModularArm"))
        )
        async with AsyncExitStack() as stack:
            controls = [await stack.enter_async_context(each.control()) for each in (belt, arm)]
            for each in (belt, arm):
                await each.resume()
            await belt.send(m.SetConveyorSpeed(0.25), ack=True)
            await arm.send(motion_command([3.0, 3.0], 20.0), ack=True)
            await asyncio.sleep(0.2)
            assert cell.robot.conveyor.current.speed == 0.25
            assert cell.robot.arm.state().moving
            if lost == "client gone":
                cell.network.disconnect(cell.ocu.id)
                await until_no_control(cell)
            else:
                for control in controls:
                    await control.__aexit__(None, None, None)
            await asyncio.sleep(0.2)
            assert cell.robot.conveyor.current.speed == 0.0
            assert not cell.robot.arm.state().moving
            assert cell.robot.connectors["platform_1/top"].current.attached_to == "servo_1"
            cell.network.reconnect(cell.ocu.id)


async def until_no_control(cell: World) -> None:
    """Wait until access control has timed out in every component."""
    while any(component.host.controller for component in cell.runner.components):
        await asyncio.sleep(0.01)


async def test_a_backend_without_the_parts_of_the_file_is_refused():
    class Incomplete(MemoryBackend):
        def open(self, robot, world):
            super().open(robot, world)
            del self.robot.servos["servo_3"]
            return self.robot

    async with VirtualNetwork() as network:
        runner = RobotRunner(CONFIG, network.transport, backend=Incomplete(), realtime=VirtualTime)
        with pytest.raises(ConfigError, match="no servo module 'servo_3'"):
            await runner.open()
        assert runner.components == ()


async def test_a_module_whose_transport_fails_is_tried_again():
    class Failing(LoopbackTransport):
        tries = 0

        async def open(self) -> None:
            Failing.tries += 1
            if Failing.tries == 1:
                raise TransportError("no node manager runs")
            await super().open()

    async with VirtualNetwork() as network:
        backend = MemoryBackend()

        def transport(id):
            found = network.transport(id)
            if str(id) == IDS["servo_1"]:
                found.__class__ = Failing
            return found

        runner = RobotRunner(CONFIG, transport, backend=backend, realtime=VirtualTime)
        async with runner:
            backend.robot.assemble("servo_1")
            await asyncio.sleep(0.5)
            ids = [str(component.id) for component in runner.components]
            assert IDS["servo_1"] not in ids
            await asyncio.sleep(1.0)
            assert IDS["servo_1"] in [str(component.id) for component in runner.components]
