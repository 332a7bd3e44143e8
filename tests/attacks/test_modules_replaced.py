"""A module of a cell disappears, and another one has its id or place: nothing meant for the old one moves the new."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest
from tests.helpers.memory_cell import MemoryBackend
from tests.robot.test_cell_modules import IDS, World, world
from tests.robot.test_cell_services import OTHER, Bench

from jauspy.errors import ConfigError
from jauspy.messages import cell as m
from jauspy.messages.core import CreateCommandEvent, QueryControl, ReportControl, RequestControl, Resume
from jauspy.messages.operators import SealedCommand
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.services.cell import motion_command
from jauspy.virtual.environment import VirtualTime
from jauspy.virtual.network import VirtualNetwork

SERVO = IDS["servo_1"]
TURN = m.SetServoTarget(m.SetServoTarget.Mode.VELOCITY_MODE, 0.5)


async def replace_servo(cell: World, away: float = 0.2) -> None:
    """End the component of `servo_1`, and start another one with its id."""
    cell.robot.power.switch("servo_1", False)
    await asyncio.sleep(away)
    assert SERVO not in cell.ids
    cell.robot.power.switch("servo_1", True)
    await asyncio.sleep(0.2)
    assert SERVO in cell.ids


async def with_servo(cell: World) -> None:
    cell.robot.assemble("servo_1")
    cell.robot.arm._joints = list  # no arm claims it
    await asyncio.sleep(0.2)


@pytest.mark.slow
async def test_a_new_module_is_controlled_by_nobody() -> None:
    async with world() as cell:
        await with_servo(cell)
        ocu = cell.ocu
        await ocu.send(SERVO, RequestControl(255), ack=True)
        await ocu.send(SERVO, Resume(), ack=True)
        await ocu.send(SERVO, TURN, ack=True)
        await asyncio.sleep(0.1)
        assert cell.robot.servos["servo_1"].current.velocity == 0.5
        await replace_servo(cell)
        report = await ocu.query(SERVO, QueryControl(), expects=ReportControl)
        assert report.subsystem_id == report.authority_code == 0
        for command in (TURN, Resume(), TURN):  # a client that has not noticed
            await ocu.send(SERVO, command, ack=True)
        await ocu.send(SERVO, RequestControl(255), ack=True)  # and repeats its request, as it must
        await ocu.send(SERVO, TURN, ack=True)
        await asyncio.sleep(0.2)
        assert cell.robot.servos["servo_1"].current.velocity == 0.0


@pytest.mark.slow
@pytest.mark.parametrize("away", [0.1, 1.0])
async def test_a_command_that_is_repeated_meanwhile_does_not_move_the_new_module(away: float) -> None:
    async with world() as cell:
        await with_servo(cell)
        await cell.ocu.send(SERVO, RequestControl(255), ack=True)
        await cell.ocu.send(SERVO, Resume(), ack=True)
        cell.robot.power.switch("servo_1", False)
        await asyncio.sleep(0.06)
        waiting = asyncio.ensure_future(cell.ocu.send(SERVO, TURN, ack=True))
        await asyncio.sleep(away)
        cell.robot.power.switch("servo_1", True)
        await asyncio.sleep(3.0)
        await asyncio.gather(waiting, return_exceptions=True)
        assert SERVO in cell.ids
        assert cell.robot.servos["servo_1"].current.velocity == 0.0


@pytest.mark.slow
async def test_a_subscription_ends_with_the_module() -> None:
    async with world() as cell:
        await with_servo(cell)
        servo = (await cell.ocu.discover(201)).component(SERVO).service("ServoModule")
        heard = 0
        async with servo.subscribe(m.QueryServoState(1), rate=20.0) as states:
            reports = aiter(states)
            await anext(reports)
            await replace_servo(cell)
            (host,) = (each.host for each in cell.runner.components if str(each.id) == SERVO)
            before = dict(host.counters).get("sent", 0)
            await asyncio.sleep(0.5)
            heard = dict(host.counters).get("sent", 0) - before
        assert heard <= 12, "only what the client has asked for again"


@pytest.mark.slow
async def test_a_sealed_command_for_the_old_module_is_refused_by_the_new_one(tmp_path: Path) -> None:
    pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")
    from jauspy.protocol.seal import OperatorKey

    key = OperatorKey.generate()
    (tmp_path / "alice.key").write_bytes(key.pem())
    (tmp_path / "alice.key").chmod(0o600)
    (tmp_path / "operators.toml").write_text(f'operators.alice = {{ role = "supervisor", key = "{key.public}" }}\n')
    (tmp_path / "robot.toml").write_text('extends = "cell"\noperators = "operators.toml"\n')
    backend = MemoryBackend()
    async with VirtualNetwork() as network:
        config = robot_files.load(str(tmp_path / "robot.toml"))
        runner = RobotRunner(config, network.transport, backend=backend, realtime=VirtualTime)
        async with runner, network.ocu("42.1.1", operator=tmp_path / "alice.key") as ocu:
            cell = World(network, backend, runner, ocu)
            await with_servo(cell)
            for command in (RequestControl(255), Resume(), TURN):
                await ocu.send(SERVO, command, ack=True)
            await asyncio.sleep(0.1)
            assert cell.robot.servos["servo_1"].current.velocity == 0.5
            recorded = [each.payload for each in network.sent(SealedCommand) if str(each.destination) == SERVO]
            await replace_servo(cell, away=0.06)
            (host,) = (each.host for each in runner.components if str(each.id) == SERVO)
            for payload in recorded:
                host.receive(payload, ocu.id, host.now)
            await asyncio.sleep(0.2)
            refused = {name: n for name, n in dict(host.counters).items() if name.startswith("refused.")}
            assert sum(refused.values()) >= len(recorded) >= 3
            assert host.controller is None
            assert cell.robot.servos["servo_1"].current.velocity == 0.0


def test_an_id_belongs_to_one_module(tmp_path: Path) -> None:
    file = tmp_path / "robot.toml"
    file.write_text(
        'extends = "cell"\n[[modules]]\ntype = "CM-SRV"\npart = "servo_1"\nnode = 2\ncomponent = 1\n'
        '[[modules]]\ntype = "CM-SRV"\npart = "servo_2"\nnode = 2\ncomponent = 1\n'
    )
    with pytest.raises(ConfigError):
        robot_files.load(str(file))


# --- the modular arm: its id stays, its joints change -------------------------------------------------------------


@pytest.fixture
def arm() -> Bench:
    bench = Bench("arm")
    bench.control()
    return bench


def exchange(bench: Bench) -> None:
    """Another servo module takes the place of the last one."""
    bench.robot.arm._order = ("servo_2", "servo_1")
    bench.run(0.05)


CHECKED = 0.1
"""Seconds in which the service has looked at what became of a motion."""


def test_a_motion_for_other_joints_is_refused(arm: Bench) -> None:
    arm.ask(m.QueryModularArmState())
    exchange(arm)
    arm.tell(motion_command([1.0, 0.2], 5.0))
    assert not arm.robot.arm.state().moving
    arm.run(CHECKED)
    assert arm.count("joints_changed") == 1
    error = arm.ask(m.QueryModularArmState()).modular_arm_motion_rec.error
    assert error == "motion refused: the joints have changed since they were reported to this client"
    arm.tell(motion_command([1.0, 0.2], 5.0))
    assert arm.robot.arm.state().moving, "now the client knows them"
    assert arm.ask(m.QueryModularArmState()).modular_arm_motion_rec.error == ""


def test_a_refused_motion_is_unsuccessful(arm: Bench) -> None:
    arm.ask(m.QueryModularArmSpecification())
    exchange(arm)
    sent = [*arm.tell(CreateCommandEvent(1, 2, motion_command([1.0, 0.2]).encode())), *arm.run(CHECKED)]
    assert [int(each.command_result) for each in sent if hasattr(each, "command_result")] == [1]


def test_what_others_were_told_does_not_count(arm: Bench) -> None:
    arm.ask(m.QueryModularArmState())
    exchange(arm)
    arm.tell(m.QueryModularArmState(), client=OTHER)
    arm.tell(motion_command([1.0, 0.2], 5.0))
    arm.run(CHECKED)
    assert arm.count("joints_changed") == 1


def test_a_client_that_orders_the_joints_knows_them(arm: Bench) -> None:
    arm.ask(m.QueryModularArmState())
    order = m.SetModularArmOrder
    arm.tell(order([order.JointNameRec("servo_2"), order.JointNameRec("servo_1")]), motion_command([1.0, 0.2], 5.0))
    assert arm.robot.arm.state().moving


def test_clients_that_are_remembered_are_bounded(arm: Bench) -> None:
    from jauspy.ids import JausID
    from jauspy.services.cell import ModularArmService

    for number in range(1, 250):
        arm.tell(m.QueryModularArmState(), client=JausID(99, 1, number))
    service = arm.host.service(ModularArmService)
    assert service is not None
    assert len(service._told) <= 64
