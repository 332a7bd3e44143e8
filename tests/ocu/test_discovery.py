from __future__ import annotations

import asyncio

import pytest

from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryHeartbeatPulse, QueryServices, ReportIdentification, ReportServices
from jauspy.ocu import ServiceInfo
from jauspy.services.core import Discovery


async def test_a_robot_is_found_with_names_and_services(world):
    await world.robot()
    ocu = await world.ocu()

    robot = await ocu.discover(subsystem=101)

    assert (robot.id, robot.name, robot.info.kind) == (101, "test robot", "vehicle")
    assert [(node.id, node.name) for node in robot.nodes] == [(1, "test node")]
    (component,) = robot.components
    assert (component.id, component.name, component.kind) == (JausID(101, 1, 1), "all in one", "component")
    assert ServiceInfo("urn:jaus:jss:mobility:PrimitiveDriver", "1.1") in component.services


async def test_ocu_is_discovered_by_others(world):
    await world.ocu()
    other = await world.ocu("43.1.1")

    (found,) = await other.discover_all(timeout=0.4)

    assert (found.id, found.info.kind, found.name) == (42, "OCU", "jauspy OCU")
    await other.query("42.1.1", QueryHeartbeatPulse())


async def test_discover_all_finds_all_subsystems(world):
    for number in (101, 102):
        await world.robot(JausID(number, 1, 1))
    ocu = await world.ocu()

    robots = await ocu.discover_all(timeout=0.5)

    assert [robot.id for robot in robots] == [101, 102]
    assert all(robot.components[0].find("PrimitiveDriver") for robot in robots)


async def test_lost_queries_are_repeated(world):
    await world.robot()
    world.network.lose(QueryServices, times=1)
    ocu = await world.ocu()

    robot = await ocu.discover(subsystem=101)

    assert len(world.network.sent(QueryServices)) > 1
    assert robot.service("mobility:PrimitiveDriver")


async def test_component_with_lost_answers_is_found(world):
    await world.robot()
    other = JausID(101, 2, 7)
    await world.component(other, [Discovery()])
    ocu = await world.ocu()
    start = world.network.clock.elapsed
    world.network.keeps = lambda packet: packet.source != other or world.network.clock.elapsed > start + 0.1

    found = await ocu.discover(subsystem=101)

    assert [component.id for component in found.components] == [JausID(101, 1, 1), other]


async def test_components_reported_by_others_are_queried(world):
    robot = await world.robot()
    await world.component(JausID(101, 2, 7), [Discovery()])
    ocu = await world.ocu()
    world.network.keeps = lambda packet: not (packet.source == JausID(101, 2, 7) and packet.destination.is_wildcard)

    found = await ocu.discover(subsystem=101)

    assert [component.id for component in found.components] == [robot.id, JausID(101, 2, 7)]
    assert found.component(7).info.name == "jauspy component"


async def test_missing_subsystem_error_names_the_queries_and_others(world):
    await world.robot()
    ocu = await world.ocu()

    with pytest.raises(ResponseTimeout, match=r"subsystem 7 did not answer.*QueryServices, sent to 7\.255\.255"):
        await ocu.discover(subsystem=7, timeout=0.2)
    with pytest.raises(ResponseTimeout, match=r"\(of the others, 101 did answer\)"):
        await ocu.discover(subsystem=7, timeout=0.2)


async def test_invalid_arguments_are_explained(world):
    ocu = await world.ocu()
    with pytest.raises(ConfigError, match=r"subsystem 70000 is outside 1\.\.65534"):
        await ocu.discover(subsystem=70000)
    with pytest.raises(ConfigError, match="timeout 0 s must be above 0"):
        await ocu.discover_all(timeout=0)


async def test_services_are_found_by_urn_or_short_name(world):
    await world.robot()
    ocu = await world.ocu()
    robot = await ocu.discover(subsystem=101)

    for name in ("urn:jaus:jss:mobility:PrimitiveDriver", "mobility:PrimitiveDriver", "primitivedriver"):
        assert robot.service(name).info.urn == "urn:jaus:jss:mobility:PrimitiveDriver"
    with pytest.raises(
        ConfigError, match=r"does not offer manipulator:Gripper; it offers 101\.1\.1: .*PrimitiveDriver 1\.1"
    ):
        robot.service("manipulator:Gripper")
    with pytest.raises(ConfigError, match=r"has no component 9; it has 101\.1\.1"):
        robot.component(9)


async def test_service_of_several_components_is_ambiguous(world):
    await world.robot()
    await world.robot(JausID(101, 1, 102))
    ocu = await world.ocu()
    robot = await ocu.discover(subsystem=101)

    with pytest.raises(ConfigError, match=r"several components.*101\.1\.1, 101\.1\.102.*robot\.component\(1\)"):
        robot.service("mobility:PrimitiveDriver")
    assert robot.component(102).service("mobility:PrimitiveDriver").id == JausID(101, 1, 102)
    assert robot.component("101.1.1").service("mobility:PrimitiveDriver").id == JausID(101, 1, 1)


async def test_malformed_answers_are_counted_and_others_used(world):
    await world.robot()
    liar = world.transport(JausID(101, 1, 66))
    await liar.open()
    ocu = await world.ocu()
    garbage = [
        ReportServices.CODE.to_bytes(2, "little") + b"\x03\xff",
        ReportIdentification.CODE.to_bytes(2, "little"),
        b"\x01",
    ]

    def lie(_: bytes) -> None:
        from jauspy.protocol.header import Packet
        from jauspy.protocol.judp import pack

        for payload in garbage:
            liar.send(pack(Packet(liar.id, ocu.id, payload)))

    liar.received = lie
    robot = await ocu.discover(subsystem=101)
    await liar.close()

    assert [each.id for each in robot.components] == [JausID(101, 1, 1)]
    assert ocu.stats.malformed >= len(garbage)


@pytest.mark.slow
async def test_discover_all_ends_after_a_second_when_all_have_answered(virtual_network, ocu):
    clock = asyncio.get_running_loop().time
    async with virtual_network.robot():
        began = clock()
        (robot,) = await ocu.discover_all()
        assert clock() - began <= 1.1
        assert len(robot.components) == 10
    began = clock()
    assert await ocu.discover_all() == ()
    assert clock() - began == pytest.approx(2.0, abs=0.1)
