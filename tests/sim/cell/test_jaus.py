"""The simulated cell as a JAUS client sees it, on virtual time."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from dataclasses import dataclass

import pytest

pytest.importorskip("mujoco", reason="the simulated cell needs the extra 'sim'")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import ARM, build_arm, build_car, weightless

from jauspy import OCU
from jauspy.messages import cell as m
from jauspy.messages.manipulator import JointVelocityRec, SetJointVelocity
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, SetVelocityCommand
from jauspy.platform.modular.cell import CONVEYOR, Car, ConveyorState
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.services.cell import motion_command
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork
from jauspy_sim.cell.robot import SimulatedCell

CONFIG = robot_files.load("cell")
IDS = {module.part: str(CONFIG.id_of(module)) for module in CONFIG.modules if module.node == 2}
SERVOS = [name for name in ARM if name.startswith("servo")]
CURRENT = SetVelocityCommand.CommandType(0)
REST = 0.02
"""rad/s, m/s: slower is standing still."""


@dataclass
class Simulated:
    """A cell that runs, its arm of five joints, and a client."""

    runner: RobotRunner
    robot: SimulatedCell
    ocu: OCU
    network: VirtualNetwork

    @property
    def ids(self) -> set[str]:
        return {str(component.id) for component in self.runner.components}

    def moving(self) -> set[str]:
        """What moves: the UR10, the arm, the belt."""
        snapshot = self.runner.snapshot
        assert snapshot is not None
        belt = snapshot.parts[CONVEYOR]
        assert isinstance(belt, ConveyorState)
        speeds = {
            "ur10": max(map(abs, snapshot.joints["ur10"].velocities)),
            "arm": max(abs(self.robot.servos[name].state().velocity) for name in SERVOS),
            "belt": abs(belt.speed),
        }
        return {name for name, speed in speeds.items() if speed > REST}


class _Backend:
    name = "sim"

    def open(self, robot, world):
        self.robot = SimulatedCell.open(robot, world)
        return self.robot


@asynccontextmanager
async def simulated() -> AsyncIterator[Simulated]:
    backend = _Backend()
    async with VirtualNetwork() as network:
        runner = RobotRunner(CONFIG, network.transport, backend=backend, realtime=VirtualTime)
        async with runner, network.ocu() as ocu:
            build_arm(backend.robot)
            await asyncio.sleep(0.3)
            yield Simulated(runner, backend.robot, ocu, network)


@pytest.mark.slow
async def test_the_modules_of_an_arm_are_components_and_move_together():
    async with simulated() as cell:
        assert {IDS[name] for name in ARM} <= cell.ids
        robot = await cell.ocu.discover(201)
        assert {str(each.id) for each in robot.components} == cell.ids
        arm = robot.component("201.3.1").service("ModularArm")
        state = await arm.query(m.QueryModularArmState())
        assert [each.name for each in state.joint_list] == SERVOS
        async with arm.control():
            await arm.resume()
            stay = math.nan
            await arm.perform(motion_command([0.4, 0.3, stay, stay, -0.5], 1.5), within=6.0)
        state = await arm.query(m.QueryModularArmState())
        assert state.modular_arm_motion_rec.error == ""
        assert [each.position for each in state.joint_list] == pytest.approx([0.4, 0.3, 0.0, 0.0, -0.5], abs=0.02)
        servo = robot.component(IDS["servo_5"]).service("ServoModule")
        report = await servo.query(m.QueryServoState(0xFFFFFFFF))
        assert report.position == pytest.approx(-0.5, abs=0.02)
        assert report.claimed_by == "arm"


@pytest.mark.slow
async def test_a_module_without_power_disappears_and_ends_the_motion():
    async with simulated() as cell:
        robot = await cell.ocu.discover(201)
        arm = robot.component("201.3.1").service("ModularArm")
        power = robot.component("201.1.13").service("ModulePower")
        async with arm.control(), power.control():
            await arm.resume()
            await power.resume()
            await arm.send(motion_command([0.5] * 5, 4.0), ack=True)
            await asyncio.sleep(1.0)
            record = m.SetModulePower.ModulePowerRec
            off = m.SetModulePower([record("servo_4", m.SetModulePower.Power.SWITCHED_OFF)])
            await power.send(off, ack=True)
            await asyncio.sleep(0.3)
            assert IDS["servo_4"] not in cell.ids
            state = await arm.query(m.QueryModularArmState())
            assert state.modular_arm_motion_rec.error == "the motion ended early: no report of servo_4"
            robot = await cell.ocu.discover(201)
            assert IDS["servo_4"] not in {str(each.id) for each in robot.components}
        held = robot.component(IDS["tube_2"]).service("VacuumConnector")
        assert (await held.query(m.QueryConnectorState(0xFFFFFFFF, 1))).attached_to == "servo_4"


@pytest.mark.slow
async def test_the_car_appears_and_is_driven_over_jaus():
    async with simulated() as cell:
        joint = cell.robot.model.joint("car")
        cell.robot.data.qpos[joint.qposadr[0] : joint.qposadr[0] + 7] = (-2.0, 0.0, 0.03, 1.0, 0.0, 0.0, 0.0)
        assert "201.1.20" not in cell.ids
        with weightless(cell.robot):
            build_car(cell.robot)
        await asyncio.sleep(0.5)
        assert "201.1.20" in cell.ids
        car = (await cell.ocu.discover(201)).component("201.1.20")
        driver, sensor = car.service("VelocityStateDriver"), car.service("LocalPoseSensor")
        start = await sensor.query(QueryLocalPose(0xFFFF), expects=ReportLocalPose)
        async with driver.control():
            await driver.resume()
            for _ in range(4):
                await driver.send(SetVelocityCommand(CURRENT, velocity_x=0.15), ack=True)
                await asyncio.sleep(0.5)
            moved = await sensor.query(QueryLocalPose(0xFFFF), expects=ReportLocalPose)
        assert moved.x - start.x == pytest.approx(0.3, abs=0.12)
        await asyncio.sleep(0.2)
        assert abs(Car.of(cell.robot).state().twist.vx) < REST


def _velocity(speed: float) -> JointVelocityRec:
    kind = JointVelocityRec
    return kind(joint_velocity=kind.JointVelocity(kind.JointVelocityChoice(1), speed))


@pytest.mark.slow
@pytest.mark.parametrize("lost", ["the client is gone", "control is released"])
async def test_everything_stands_within_200_ms_of_the_loss_of_control(lost):
    async with simulated() as cell:
        robot = await cell.ocu.discover(201)
        services = [
            robot.component(id).service(name)
            for id, name in (
                ("201.1.10", "ManipulatorJointVelocityDriver"),
                ("201.1.12", "Conveyor"),
                ("201.3.1", "ModularArm"),
            )
        ]
        async with AsyncExitStack() as stack:
            controls = [await stack.enter_async_context(each.control()) for each in services]
            for each in services:
                await each.resume()
            ur10, belt, arm = services
            await belt.send(m.SetConveyorSpeed(0.25), ack=True)
            await arm.send(motion_command([1.0, 0.3, 0.3, 0.3, 2.0], 4.0), ack=True)
            await ur10.send(SetJointVelocity([_velocity(each) for each in (0.3, 0.0, 0.0, 0.0, 0.0, 0.5)]), ack=True)
            await asyncio.sleep(1.5)
            assert cell.moving() == {"ur10", "arm", "belt"}
            if lost == "the client is gone":
                cell.network.disconnect(cell.ocu.id)
                while any(component.host.controller for component in cell.runner.components):
                    await asyncio.sleep(0.01)
            else:
                await asyncio.gather(*(each.__aexit__(None, None, None) for each in controls))
            await asyncio.sleep(0.2)
            assert cell.moving() == set()
            cell.network.reconnect(cell.ocu.id)
        assert cell.robot.connectors["platform_1/top"].state().attached_to == "servo_1"
        assert cell.robot.connectors["tube_2/output"].state().attached_to == "servo_4"
