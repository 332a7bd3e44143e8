"""Allocators of ids: their tables under friendly and hostile requests, and components that start without an id."""

from __future__ import annotations

import asyncio
import socket
from datetime import UTC, datetime

import pytest

import jauspy
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.messages.exp import GrantSubsystemID, QuerySubsystemIDs, RequestSubsystemID
from jauspy.messages.iop import GrantNodeID, RequestNodeID
from jauspy.protocol import judp
from jauspy.protocol.header import Broadcast, Packet
from jauspy.services.core import with_core_services
from jauspy.services.host import Host
from jauspy.services.iop import NodeIDAllocator, SubsystemIDAllocator
from jauspy.services.iop.id_allocators import EVERYBODY, GRANTS, MAX_HEARD, MAX_SUBSYSTEMS, NEW_BURST
from jauspy.testing import LocalNode

ME, NOBODY = JausID(1, 1, 110), JausID(0, 0, 30)
VEHICLE, OCU = RequestSubsystemID.SubsystemType.VEHICLE, RequestSubsystemID.SubsystemType.OCU
MAC = [2, 0, 0, 0, 0, 7]


def key(number: int) -> list[int]:
    return [2, *number.to_bytes(5, "big")]


class Allocating:
    """An allocator without a network."""

    def __init__(self, service) -> None:
        self.host = Host(
            ME, with_core_services([service], ""), utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0
        )
        self.now = 0.0

    def ask(self, message, source: JausID = NOBODY) -> list:
        self.host.receive(message.encode(), source, self.now)
        return list(self.host.poll_output(self.now))

    def granted(self, message, source: JausID = NOBODY):
        (output,) = self.ask(message, source)
        return registry.decode(output.payload)


def test_the_first_subsystem_is_100_and_a_key_keeps_its_number():
    tested = Allocating(SubsystemIDAllocator(taken=lambda: {101}))
    (output,) = tested.ask(RequestSubsystemID(MAC, VEHICLE))
    assert (output.destination, output.broadcast) == (EVERYBODY, Broadcast.GLOBAL)
    grant = registry.decode(output.payload)
    assert (grant.subsystem_id, grant.subsystem_type, grant.ma_caddr) == (100, VEHICLE, MAC)
    assert tested.granted(RequestSubsystemID(key(9), OCU)).subsystem_id == 102, "101 is taken"
    assert tested.granted(RequestSubsystemID(MAC, VEHICLE)).subsystem_id == 100


def test_wire_bytes_of_request_and_grant_are_those_of_the_toolset():
    """Fields in the order that the allocator of the JAUS Toolset has them: MAC and type; id, type and MAC."""
    assert RequestSubsystemID(MAC, VEHICLE).encode().hex() == "01db" + "020000000007" + "1127"
    assert GrantSubsystemID(100, VEHICLE, MAC).encode().hex() == "01fb" + "6400" + "1127" + "020000000007"


def test_queries_list_by_kind_and_by_address():
    tested = Allocating(SubsystemIDAllocator())
    tested.ask(RequestSubsystemID(MAC, VEHICLE))
    tested.ask(RequestSubsystemID(key(9), OCU))
    client = JausID(42, 1, 1)

    def listed(kind: int, mac=MAC) -> list[int]:
        report = tested.granted(QuerySubsystemIDs(kind, mac), client)
        return [record.subsystem_id for record in report.subsystem_ids_list]

    assert [listed(0), listed(1), listed(2), listed(3), listed(3, key(1))] == [[100, 101], [101], [100], [100], []]


@pytest.mark.slow
def test_a_flood_of_invented_keys_is_slowed_counted_and_ends_at_the_bound():
    tested = Allocating(SubsystemIDAllocator())
    number = 0
    for second in range(3 * MAX_SUBSYSTEMS):
        tested.now = float(second)
        outputs = []
        for _ in range(3):
            number += 1
            outputs += tested.ask(RequestSubsystemID(key(number), VEHICLE))
        assert len(outputs) <= (NEW_BURST if second == 0 else 3)
    grant = tested.granted(RequestSubsystemID(key(10**9), VEHICLE))
    assert grant.subsystem_id == 0, "the table is full"
    assert len(tested.host.service(SubsystemIDAllocator)._table.entries) == MAX_SUBSYSTEMS
    assert tested.host.counters["too_many_id_requests"] > 100


def test_nobody_gets_more_than_so_many_broadcasts_a_second():
    tested = Allocating(SubsystemIDAllocator())
    outputs = [output for _ in range(1000) for output in tested.ask(RequestSubsystemID(MAC, VEHICLE))]
    assert len(outputs) == GRANTS
    tested.now = 1.0
    assert tested.granted(RequestSubsystemID(MAC, VEHICLE)).subsystem_id == 100


@pytest.mark.parametrize("payload", [b"\x01\xdb", b"\x01\xdb" + bytes(7), b"\x01\xdb" + bytes(6) + b"\xff\xff"])
def test_malformed_requests_get_no_answer(payload):
    tested = Allocating(SubsystemIDAllocator())
    tested.host.receive(payload, NOBODY, 0.0)
    assert not list(tested.host.poll_output(0.0))
    assert tested.host.service(SubsystemIDAllocator)._table.entries == []


def test_nodes_are_those_that_nobody_has_and_only_of_the_own_subsystem():
    tested = Allocating(NodeIDAllocator(lambda: {2}))
    assert tested.ask(RequestNodeID([*MAC, 30]), JausID(7, 0, 30)) == []
    assert tested.host.counters["foreign_id_request"] == 1
    (output,) = tested.ask(RequestNodeID([*MAC, 30]), JausID(1, 0, 30))
    assert output.destination == JausID(1, 255, 255)
    assert registry.decode(output.payload).node_id == 3
    tested.now = 1e6
    numbers = []
    for number in range(300):
        tested.now += 1.0
        numbers.append(tested.granted(RequestNodeID([*key(number), 30]), JausID(1, 0, 30)).node_id)
    assert sorted(id for id in numbers if id) == list(range(3, 255)), "3 is of the same key as before"
    assert numbers[-1] == 0


@pytest.mark.parametrize("service", [SubsystemIDAllocator, NodeIDAllocator])
def test_numbers_of_those_who_are_heard_are_not_handed_out(service):
    tested = Allocating(service())
    first, source = (100, NOBODY) if service is SubsystemIDAllocator else (2, JausID(1, 0, 30))

    def ask(number: int) -> int:
        tested.now += 1.0
        if service is SubsystemIDAllocator:
            return tested.granted(RequestSubsystemID(key(number), VEHICLE)).subsystem_id
        return tested.granted(RequestNodeID([*key(number), 30]), source).node_id

    def beat(number: int) -> None:
        sender = JausID(number, 1, 1) if service is SubsystemIDAllocator else JausID(1, number, 1)
        tested.host.receive(ReportHeartbeatPulse().encode(), sender, tested.now)

    beat(first)
    beat(first + 2)
    tested.host.receive(ReportHeartbeatPulse().encode(), JausID(7, first + 3, 1), tested.now)
    assert [ask(1), ask(2), ask(1)] == [first + 1, first + 3, first + 1]


def test_a_flood_of_heartbeats_is_bounded_and_uses_up_no_numbers():
    tested = Allocating(SubsystemIDAllocator())
    for number in range(100, 10_000):
        tested.host.receive(ReportHeartbeatPulse().encode(), JausID(number, 1, 1), tested.now)
    table = tested.host.service(SubsystemIDAllocator)._table
    assert len(table._heard) == MAX_HEARD
    assert tested.granted(RequestSubsystemID(MAC, VEHICLE)).subsystem_id == 100, "it is not heard any more"
    for number in range(100, 100 + MAX_HEARD):
        tested.host.receive(ReportHeartbeatPulse().encode(), JausID(number, 1, 1), tested.now)
    assert tested.granted(RequestSubsystemID(key(1), VEHICLE)).subsystem_id == 100 + MAX_HEARD
    for number in range(5000, 5000 + MAX_HEARD):
        tested.host.receive(ReportHeartbeatPulse().encode(), JausID(number, 1, 1), tested.now)
    assert tested.granted(RequestSubsystemID(key(2), VEHICLE)).subsystem_id == 101, "no number is lost"


# --- components without an id -----------------------------------------------------------------------------------------


@pytest.mark.asyncio
async def test_a_component_gets_its_subsystem_and_node(virtual_network):
    async with (
        virtual_network.component("1.1.110", [SubsystemIDAllocator()]),
        virtual_network.component("100.1.110", [NodeIDAllocator()]),
        virtual_network.component("0.0.30", []) as component,
        virtual_network.ocu("42.1.1") as ocu,
    ):
        component.request_id(bytes(MAC))
        async with asyncio.timeout(30):
            while component.id != JausID(100, 2, 30):
                await asyncio.sleep(0.5)
        robot = await ocu.discover(100)
        assert str(component.id) in {str(found.id) for found in robot.components}


@pytest.mark.asyncio
async def test_grants_for_others_and_strangers_change_nothing(virtual_network):
    async with virtual_network.component("0.0.30", []) as component, virtual_network.component("9.1.1", []) as other:
        component.request_id(bytes(MAC))
        for grant in (
            GrantSubsystemID(55, VEHICLE, key(1)),
            GrantSubsystemID(0, VEHICLE, MAC),
            GrantSubsystemID(65535, VEHICLE, MAC),
            GrantNodeID(5, [*MAC, 30]),
        ):
            other.send(EVERYBODY, grant, broadcast=Broadcast.GLOBAL)
        other.send_encoded(EVERYBODY, b"\x01\xfb\x00", broadcast=Broadcast.GLOBAL)
        await asyncio.sleep(5.0)
        assert component.id == JausID(0, 0, 30)
        other.send(EVERYBODY, GrantSubsystemID(55, VEHICLE, MAC), broadcast=Broadcast.GLOBAL)
        await asyncio.sleep(2.0)
        assert component.id == JausID(55, 0, 30)
        other.send(EVERYBODY, GrantNodeID(5, [*MAC, 30]), broadcast=Broadcast.GLOBAL)
        await asyncio.sleep(2.0)
        assert component.id == JausID(55, 0, 30), "the grant came from another subsystem"
        assert component.counters["host.foreign_id_grant"] == 1


@pytest.mark.asyncio
async def test_a_key_has_six_bytes(virtual_network):
    async with virtual_network.component("0.0.30", []) as component:
        with pytest.raises(ConfigError, match="has 6 bytes, as a MAC address, not 2"):
            component.request_id(b"ab")


@pytest.mark.parametrize("source", [JausID(0xFFFF, 0xFF, 30), JausID(0, 1, 30)])
async def test_a_request_as_the_toolset_sends_it_passes_a_node_manager(source):
    """From an incomplete id to everybody, without the flag of broadcasts."""
    with LocalNode() as node:
        allocator = jauspy.Component("1.1.110", [SubsystemIDAllocator()], connect=node.local)
        async with allocator:
            packet = Packet(source=source, destination=EVERYBODY, payload=RequestSubsystemID(MAC, VEHICLE).encode())
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
                sock.sendto(judp.pack(packet), ("127.0.0.1", node.port))
            table = allocator.host.service(SubsystemIDAllocator)._table
            async with asyncio.timeout(20):
                while not table.entries:
                    await asyncio.sleep(0.01)
            assert table.entries == [(bytes(MAC), 100, VEHICLE)]
