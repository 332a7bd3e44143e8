"""An OCU with the key of an operator: everything works as without, and only with the key where one is required."""

from __future__ import annotations

import asyncio
import logging

import pytest
from tests.helpers.robot import FakeDrive
from tests.ocu.conftest import World

import jauspy
from jauspy.component import Component
from jauspy.component.component import loop_time
from jauspy.errors import ConfigError, ControlRejected, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportStatus, Resume, SetEmergency, SetTime, Standby
from jauspy.messages.mobility import QueryWrenchEffort, SetWrenchEffort
from jauspy.messages.operators import SealedCommand
from jauspy.ocu import OCU
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.services.core import AccessControl, CommandSeal, Discovery, Events, Liveness, Time
from jauspy.services.mobility import PrimitiveDriver, Vehicle

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

ROBOT = JausID(101, 1, 1)
EFFORT = SetWrenchEffort(propulsive_linear_effort_x=40.0)


@pytest.fixture(scope="module")
def keys(tmp_path_factory):
    """Files with the keys of an operator, an observer, and somebody whom the robot does not know."""
    found = {}
    for name in ("alice", "oscar", "mallory"):
        found[name] = tmp_path_factory.mktemp("keys") / f"{name}.key"
        found[name].write_bytes(OperatorKey.generate().pem())
        found[name].chmod(0o600)
    return found


@pytest.fixture
def operators(keys):
    public = {name: OperatorKey.from_pem(path.read_bytes()).public for name, path in keys.items()}
    return [Operator("alice", "operator", 127, public["alice"]), Operator("oscar", "observer", 0, public["oscar"])]


async def robot(world: World, operators: list[Operator], *, secret: bytes = bytes(32), **more: bool) -> Component:
    vehicle = Vehicle(FakeDrive(clock=loop_time))
    seal = CommandSeal(operators, secret=secret, **more)
    services = [AccessControl(), Events(), Discovery(), Liveness(), Time(), PrimitiveDriver(vehicle), seal]
    return await world.component(ROBOT, services)


async def status(ocu: OCU) -> ReportStatus.Status:
    return (await ocu.query(ROBOT, QueryStatus())).status


async def test_a_program_is_the_same_with_a_key(world, operators, keys):
    component = await robot(world, operators)
    ocu = await world.ocu(operator=keys["alice"])
    driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control(200):
        await driver.resume(1.0)
        await driver.send(EFFORT)
        assert (await driver.query(QueryWrenchEffort(0xFFFF))).propulsive_linear_effort_x == pytest.approx(
            40.0, abs=0.1
        )
        await driver.send(EFFORT, ack=True)
        await driver.perform(Standby(), within=1.0)
        assert await status(ocu) is ReportStatus.Status.STANDBY
        await asyncio.sleep(20.0)  # control is renewed
        assert component.controller == ocu.id
    assert component.controller is None
    assert not [name for name in component.counters if "refused" in name]


async def test_without_a_key_the_reason_is_reported(world, operators, caplog):
    await robot(world, operators)
    ocu = await world.ocu()
    driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    with pytest.raises(ControlRejected, match=r"refused RequestControl: it has no seal.*give an operator's key"):
        async with driver.control():
            pass
    with caplog.at_level(logging.WARNING, "jauspy.ocu"):
        await driver.send(EFFORT)
        await asyncio.sleep(0.1)
        await driver.send(EFFORT)
        await asyncio.sleep(0.1)
    assert len([each for each in caplog.records if each.name == "jauspy.ocu"]) == 1
    assert ocu.stats.refused == 3
    with pytest.raises(RequestError, match="refused CreateCommandEvent"):
        await driver.perform(Resume(), within=1.0)


@pytest.mark.parametrize(("name", "reason"), [("mallory", "not in the operators file"), ("oscar", "may not command")])
async def test_who_may_not_command(world, operators, keys, name, reason):
    component = await robot(world, operators)
    ocu = await world.ocu(operator=keys[name])
    driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    with pytest.raises(ControlRejected, match=reason):
        async with driver.control():
            pass
    await ocu.send(ROBOT, SetEmergency(1))
    assert await status(ocu) is ReportStatus.Status.EMERGENCY
    assert component.controller is None


async def test_a_bad_network(world, operators, keys):
    """Losses, copies and late packets: what is sealed is sent again like everything else."""
    world.network.loss, world.network.duplication, world.network.reordering = 0.1, 0.1, 0.1
    component = await robot(world, operators)
    ocu = await world.ocu(operator=keys["alice"], timeout=0.3, retries=8)
    driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control():
        await driver.resume(3.0)
        for _ in range(20):
            await driver.send(EFFORT, ack=True)
    assert component.counters.get("host.refused.replayed", 0) == 0


async def test_a_robot_that_was_restarted_is_asked_for_another_challenge(world, operators, keys):
    first = await robot(world, operators, secret=b"1" * 32)
    ocu = await world.ocu(operator=keys["alice"])
    await ocu.send(ROBOT, SetTime())
    await first.close()
    second = await robot(world, operators, secret=b"2" * 32)
    driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control():
        assert second.controller == ocu.id
    assert second.counters["host.refused.unknown_challenge"] <= 2


async def test_an_ocu_that_was_restarted(world, operators, keys):
    component = await robot(world, operators)
    for _ in range(3):
        ocu = await world.ocu(operator=keys["alice"])
        await ocu.send(ROBOT, SetTime())
        await asyncio.sleep(0.1)
        await ocu.close()
    assert not [name for name in component.counters if "refused" in name]


async def test_components_without_operators_are_sent_plain_commands(world, keys):
    component = await world.robot(ROBOT)
    ocu = await world.ocu(operator=keys["alice"])
    driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control():
        assert component.controller == ocu.id
        await driver.resume(1.0)
        started = loop_time()
        await driver.send(EFFORT)
        assert loop_time() - started < 0.01
    assert not world.network.sent(SealedCommand)


async def test_a_stop_waits_for_no_challenge(world, operators, keys):
    await robot(world, operators)
    ocu = await world.ocu(operator=keys["alice"])
    started = loop_time()
    await ocu.send(ROBOT, SetEmergency(1))
    assert loop_time() - started < 0.01
    assert len(world.network.sent(SetEmergency)) == 1


async def test_errors_name_the_command_and_not_its_seal(world, operators, keys):
    component = await robot(world, operators)
    ocu = await world.ocu(operator=keys["alice"])
    await ocu.send(ROBOT, SetTime())
    await component.close()
    with pytest.raises(ResponseTimeout, match="did not acknowledge SetTime"):
        await ocu.send(ROBOT, SetTime(), ack=True)


async def test_old_challenges_are_renewed_without_a_pause(world, operators, keys):
    component = await robot(world, operators)
    ocu = await world.ocu(operator=keys["alice"])
    for _ in range(20):
        await ocu.send(ROBOT, SetTime())
        await asyncio.sleep(50.0)
    assert component.counters["host.received"] >= 20
    assert not [name for name in component.counters if "refused" in name]


async def test_keys_of_files(tmp_path, keys):
    with pytest.raises(ConfigError, match="jauspy keys new"):
        OCU(operator=tmp_path / "none.key")
    (bad := tmp_path / "bad.key").write_bytes(b"?")
    with pytest.raises(ConfigError, match="chmod 600"):
        OCU(operator=bad)
    bad.chmod(0o600)
    with pytest.raises(ConfigError, match="not a private key"):
        OCU(operator=bad)
    assert isinstance(jauspy.sync.OCU(operator=str(keys["alice"])), jauspy.sync.OCU)
