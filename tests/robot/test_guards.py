"""The guards of inc1 over JAUS: policies, status and reasons; driving and moving in all modes, in MuJoCo."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from tests.helpers.self_contacts import ContactJudge
from tests.helpers.simulated import Simulation, simulated

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ControlRejected, RequestError
from jauspy.messages.iop import (
    QueryGuardedTeleopCapabilities,
    QueryGuardedTeleopConfiguration,
    QueryGuardedTeleopStatus,
    QuerySelfCollisionAvoidanceCapabilities,
    QuerySelfCollisionAvoidanceConfiguration,
    QuerySelfCollisionAvoidanceStatus,
    ReportGuardedTeleopStatus,
    SetGuardedTeleopPolicy,
    SetGuardedTeleopPolicyResponse,
    SetSelfCollisionAvoidancePolicy,
    SetSelfCollisionAvoidancePolicyResponse,
)
from jauspy.messages.mobility import SetLocalVector, SetWrenchEffort
from jauspy.ocu import OCU, Guard, Guards, Robot
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork

WORLD = """<mujoco><worldbody>
  <geom name="ground" type="plane" size="20 20 0.1"/>
  <body name="wall"><geom type="box" size="0.1 6 0.6" pos="2 0 0.6"/></body>
</worldbody></mujoco>"""
MASTER = 110


@dataclass
class Scene:
    robot: Robot
    ocu: OCU
    runner: RobotRunner
    judge: ContactJudge
    network: VirtualNetwork

    async def guard(self, name: str) -> Guard:
        return next(guard for guard in await self.robot.guards.observe() if guard.name == name)


@asynccontextmanager
async def scene(network: VirtualNetwork, folder: Path, robot: str = "inc1") -> AsyncIterator[Scene]:
    """inc1, 1.9 m before a wall."""
    world = folder / "wall.xml"
    world.write_text(WORLD)
    simulation = Simulation()
    async with simulated(network, simulation, robot, world=str(world)) as runner, network.ocu("42.1.1") as ocu:
        judge = ContactJudge(simulation.robot, "inc1")
        yield Scene(await ocu.robot(101), ocu, runner, judge, network)


@pytest.mark.slow
async def test_guards_are_off_until_a_policy_switches_them_on(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        assert [(guard.name, guard.enabled, guard.active) for guard in await inc1.robot.guards.observe()] == [
            ("self_collision", False, False),
            ("obstacle", False, False),
        ]
        await inc1.robot.guards.switch(self_collision=True, obstacle=True)
        await asyncio.sleep(0.5)
        found = await inc1.robot.guards.observe()
        assert [guard.enabled for guard in found] == [True, True]
        assert found[1].distance == pytest.approx(1.9 - 0.345, abs=0.06)
        await inc1.robot.guards.switch(obstacle=False)
        assert [guard.enabled for guard in await inc1.robot.guards.observe()] == [True, False]


@pytest.mark.slow
@pytest.mark.parametrize(
    "mode",
    [
        "effort",
        "waypoint",
        pytest.param("velocity", marks=pytest.mark.slow),
        pytest.param("vector", marks=pytest.mark.slow),
    ],
)
async def test_it_stops_before_the_wall_in_every_mode_and_drives_back(
    mode: str, virtual_network: VirtualNetwork, tmp_path: Path
) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        robot = inc1.robot
        await robot.guards.switch(obstacle=True)
        async with robot.control("drive"):
            if mode == "effort":
                await robot.drive_effort(70.0, seconds=4.0)
            elif mode == "velocity":
                await robot.drive(0.6, seconds=5.0)
            elif mode == "vector":
                driver = robot.service("LocalVectorDriver")
                async with driver.streaming(rate=5.0) as stream:
                    await stream.send(SetLocalVector(0.6, heading=0.0))
                    await asyncio.sleep(5.0)
            else:
                with pytest.raises(RequestError):
                    await robot.go_to(1.9, 0.0, speed=0.6, timeout=6.0)
            pose = await robot.pose()
            assert 1.9 - 0.345 - 0.3 < pose.x < 1.9 - 0.345 - 0.08
            await robot.drive(-0.4, seconds=1.5)
            assert (await robot.pose()).x < pose.x - 0.2
        assert not inc1.judge.outside()


@pytest.mark.slow
async def test_the_reason_and_the_distance_are_on_the_wire(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        robot = inc1.robot
        await robot.guards.switch(obstacle=True)
        async with robot.control("drive"):
            await robot.drive(0.6, seconds=4.0)
            driving = asyncio.create_task(robot.drive(0.6, seconds=2.0))
            await asyncio.sleep(1.0)
            guard = await inc1.guard("obstacle")
            assert guard.active
            assert guard.distance == pytest.approx(inc1.judge.clearance("wall"), abs=0.05)
            assert f"obstacle {guard.distance:.2f} m ahead" in guard.problem
            assert inc1.runner.overloads["obstacle"] == guard.problem
            status = await robot.service("GuardedTeleopPolicyManager").query(QueryGuardedTeleopStatus())
            assert status.guarded_teleop_status is ReportGuardedTeleopStatus.GuardedTeleopStatus.ACTIVE_STOP_ON_OBSTACLE
            await driving


@pytest.mark.slow
async def test_it_does_not_stop_without_the_guard(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with scene(virtual_network, tmp_path) as inc1, inc1.robot.control("drive"):
        driving = asyncio.create_task(inc1.robot.drive(0.6, seconds=5.0))
        await asyncio.sleep(4.5)
        assert inc1.judge.outside() == {"wall"}
        await driving


@pytest.mark.slow
async def test_the_arm_stops_before_it_touches_the_robot(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        robot = inc1.robot
        await robot.guards.switch(self_collision=True)
        async with robot.control("arm"):
            with pytest.raises(RequestError, match="Blocked: arm_link_3_to_arm_link_4"):
                await robot.arm.move({"arm_link_3_to_arm_link_4": -2.1})
            guard = await inc1.guard("self_collision")
            assert "arm_link_1" in guard.problem
            assert 0.005 < guard.distance < 0.02
            assert not inc1.judge.within()
            await robot.arm.move({"arm_link_3_to_arm_link_4": 0.3})
            assert (await inc1.guard("self_collision")).problem == ""


def teleop_policy(behavior: int, **limits: int) -> SetGuardedTeleopPolicy:
    kind = SetGuardedTeleopPolicy
    state = kind.State(
        obstacle_avoidance_behavior=behavior,
        stop_on_pitchover_limit=limits.get("pitchover", 0),
        stop_on_rollover_limit=limits.get("rollover", 0),
    )
    return kind(kind.PolicyRec(7), kind.GuardedTeleopRec(state, limits.get("tolerance")))


def collision_policy(behavior: int, priority: int = 3) -> SetSelfCollisionAvoidancePolicy:
    kind = SetSelfCollisionAvoidancePolicy
    return kind(kind.SelfCollisionAvoidancePolicyRec(9), kind.SelfCollisionAvoidanceRec(behavior, priority))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("message", "response", "taken"),
    [
        (teleop_policy(1, tolerance=5), SetGuardedTeleopPolicyResponse(7, 0), True),
        (teleop_policy(2), SetGuardedTeleopPolicyResponse(7, 1), False),
        (teleop_policy(1, pitchover=1), SetGuardedTeleopPolicyResponse(7, 1), False),
        (teleop_policy(1, rollover=1), SetGuardedTeleopPolicyResponse(7, 1), False),
        (collision_policy(1), SetSelfCollisionAvoidancePolicyResponse(9, 0), True),
        (collision_policy(2), SetSelfCollisionAvoidancePolicyResponse(9, 1), False),
    ],
)
async def test_policies_that_are_unknown_are_refused_and_change_nothing(
    message: Message, response: Message, taken: bool, virtual_network: VirtualNetwork, tmp_path: Path
) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        robot = inc1.robot
        teleop = robot.service("GuardedTeleopPolicyManager")
        collision = robot.service("SelfCollisionAvoidancePolicyManager")
        async with robot.control(MASTER):
            assert await teleop.query(message, expects=type(response)) == response
        await asyncio.sleep(0.5)
        assert any(guard.enabled for guard in await robot.guards.observe()) == taken
        is_teleop = isinstance(message, SetGuardedTeleopPolicy)
        config = await teleop.query(QueryGuardedTeleopConfiguration())
        assert config.state.obstacle_avoidance_behavior == (taken and is_teleop)
        assert config.path_tolerance == (pytest.approx(5.0, abs=1e-3) if taken and is_teleop else None)
        found = await collision.query(QuerySelfCollisionAvoidanceConfiguration())
        assert found.self_collision_avoidance_state == (taken and not is_teleop)
        assert found.priority == (3 if taken and not is_teleop else 255)


@pytest.mark.slow
async def test_capabilities_are_to_stop(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        teleop = await inc1.robot.service("GuardedTeleopPolicyManager").query(QueryGuardedTeleopCapabilities())
        bits = teleop.supported_behaviors
        assert (bits.stop_on_obstacle, bits.avoid_obstacle, bits.pitchover_limit, bits.rollover_limit) == (1, 0, 0, 0)
        collision = inc1.robot.service("SelfCollisionAvoidancePolicyManager")
        found = await collision.query(QuerySelfCollisionAvoidanceCapabilities())
        assert (found.supported_behaviors.stop_on_obstacle, found.supported_behaviors.avoid_obstacle) == (1, 0)
        status = await collision.query(QuerySelfCollisionAvoidanceStatus())
        assert status.self_collision_avoidance_status == status.SelfCollisionAvoidanceStatus.DISABLED


@pytest.mark.slow
async def test_a_policy_needs_control(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with scene(virtual_network, tmp_path) as inc1:
        async with virtual_network.ocu("42.1.2") as other, (await other.robot(101)).control(MASTER):
            with pytest.raises(ControlRejected):
                await inc1.robot.guards.switch(obstacle=True)
            await inc1.robot.service("GuardedTeleopPolicyManager").send(teleop_policy(1))
            await asyncio.sleep(0.5)
        assert not any(guard.enabled for guard in await inc1.robot.guards.observe())


@pytest.mark.slow
async def test_losing_the_operator_stops_a_guarded_robot(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    """The stop of the dead-man passes the guard at once."""
    async with scene(virtual_network, tmp_path) as inc1:
        await inc1.robot.guards.switch(obstacle=True, self_collision=True)
        async with inc1.robot.control("drive") as control:
            driver = inc1.robot.service("PrimitiveDriver")
            effort = SetWrenchEffort(propulsive_linear_effort_x=30.0, propulsive_rotational_effort_z=0.0)
            await driver.send(effort, ack=True)
            await asyncio.sleep(0.4)
            snapshot = inc1.runner.snapshot
            assert snapshot is not None
            assert snapshot.twist.vx > 0.1
        assert not control.held
        await asyncio.sleep(0.5)
        snapshot = inc1.runner.snapshot
        assert snapshot is not None
        assert math.isclose(snapshot.twist.vx, 0.0, abs_tol=0.02)


async def test_a_robot_without_guards_says_so(virtual_network: VirtualNetwork) -> None:
    async with virtual_network.ocu("42.1.1") as ocu:
        with pytest.raises(ConfigError, match="it has no such guard"):
            await Guards(ocu._connection, ()).observe()


@pytest.mark.slow
async def test_a_guard_ends_the_way_back_before_an_obstacle(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    """Back along the path, which ends 1.55 m before the wall, with a guard that keeps 1.8 m."""
    robot_file = tmp_path / "robot.toml"
    robot_file.write_text('extends = "inc1"\n[guarded_teleop]\nenabled = true\ndistance = 1.8\n')
    async with scene(virtual_network, tmp_path, str(robot_file)) as inc1, inc1.robot.control("drive"):
        await inc1.robot.drive(-0.4, seconds=3.5)
        away = inc1.runner.snapshot.pose.x
        assert away < -1.0
        with pytest.raises(RequestError, match="did not carry out StartRetrotraverse"):
            await inc1.robot.retrotraverse(5.0)
        stopped = inc1.runner.snapshot.pose.x
        assert away + 0.3 < stopped < -0.15
        assert (await inc1.guard("obstacle")).distance == pytest.approx(1.8, abs=0.08)
        assert abs(inc1.runner.snapshot.twist.vx) < 0.01
