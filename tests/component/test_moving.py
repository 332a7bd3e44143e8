"""A component that starts without a node and a subsystem, is given them, and goes on without a restart."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path

import pytest

import jauspy
from jauspy.errors import ResponseTimeout, TransportError
from jauspy.messages.core import (
    ConfirmControl,
    ConfirmEventRequest,
    CreateEvent,
    Event,
    QueryControl,
    QueryHeartbeatPulse,
    QueryTime,
    RegisterServices,
    RejectControl,
    ReportControl,
    ReportHeartbeatPulse,
    RequestControl,
    ServiceRec,
)
from jauspy.node import NodeConfig, NodeManager
from jauspy.services.core import AccessControl, Discovery, Events, Liveness
from jauspy.testing import until
from jauspy.transport import LoopbackHub, LoopbackTransport

NOWHERE, HOME, OCU = "0.0.101", "101.1.101", "42.1.1"


class Client(Liveness):
    """Takes its subsystem from the first heartbeat, and node 1."""

    def report_heartbeat_pulse(self, source: jauspy.JausID) -> ReportHeartbeatPulse:
        me = self.host.id
        if not me.subsystem:
            self.host.ask_for_id(jauspy.JausID(source.subsystem, 1, me.component))
        return ReportHeartbeatPulse()


@pytest.fixture
async def manager(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        yield node


def at(root: Path, id: str, *services: jauspy.Service) -> jauspy.Component:
    return jauspy.Component(id, services or [Liveness()], connect=f"local:{root}", name="the mover")


async def test_action_changes_the_id(root: Path, manager: NodeManager):
    master = at(root, "101.1.1")
    async with master, at(root, NOWHERE, Client()) as me, jauspy.OCU(OCU, connect=f"local:{root}") as ocu:
        assert me.id == jauspy.JausID(0, 0, 101)
        master.send("101.255.255", QueryHeartbeatPulse())
        await until(lambda: str(me.id) == HOME and me.is_connected)
        robot = await ocu.discover(101)
        while {str(each.id) for each in robot.components} != {"101.1.1", HOME}:
            robot = await ocu.discover(101)
        assert robot.component(HOME).info.name == "the mover"
        await ocu.query(HOME, QueryTime(0xFF))
        with pytest.raises(ResponseTimeout):
            await ocu.query("0.0.102", QueryTime(0xFF), timeout=0.2, retries=0)
        assert sorted(path.name for path in root.glob("[0-9]*")) == sorted(
            str(int(jauspy.JausID.parse(id))) for id in (OCU, HOME, "101.1.1")
        )


async def test_component_is_reachable_at_once_under_its_new_id(root: Path, manager: NodeManager):
    async with at(root, NOWHERE) as me, jauspy.OCU(OCU, connect=f"local:{root}") as ocu:
        me.move(HOME)
        await ocu.query(HOME, QueryTime(0xFF), timeout=5.0, retries=0)


async def test_component_is_found_before_and_after_a_move_over_tcp(root: Path):
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=0)
    async with (
        NodeManager(config) as node,
        jauspy.OCU(OCU, connect=f"local:{root}") as ocu,
        jauspy.Component("101.1.7", [Liveness()], connect=f"tcp://127.0.0.1:{node.tcp_port}") as me,
    ):
        for id in ("101.1.7", HOME):
            me.move(id)
            await ocu.query(id, QueryTime(0xFF))
            robot = await ocu.discover(101)
            assert robot.component(id).info.name == "jauspy component"


async def test_move_ends_control_and_events_of_the_old_id():
    hub = LoopbackHub()
    old, new = jauspy.JausID.parse("101.1.7"), jauspy.JausID.parse(HOME)
    heard: list[tuple[jauspy.JausID, type]] = []
    access = AccessControl()
    me = jauspy.Component(old, [access], transport=LoopbackTransport(old, hub))
    client = jauspy.Component(OCU, [Liveness()], transport=LoopbackTransport(jauspy.JausID.parse(OCU), hub))

    def tap(datagram: bytes) -> None:
        from jauspy.messages import registry
        from jauspy.protocol.judp import unpack

        heard.extend((each.source, type(registry.decode(each.payload))) for each in unpack(datagram) if each.payload)

    async with me, client:
        client._transport.received = tap
        client.send(old, RequestControl(authority_code=200))
        client.send(old, CreateEvent(1, CreateEvent.EventType.PERIODIC, 50.0, QueryTime(1).encode()))
        await until(lambda: (old, Event) in heard)
        assert me.controller == client.id

        heard.clear()
        me.move(new)
        assert (me.id, me.controller) == (new, None)
        await until(lambda: {(old, RejectControl), (old, ConfirmEventRequest)} <= set(heard))
        assert not [each for each in heard if each[0] == new]

        client.send(new, RequestControl(authority_code=200))
        client.send(new, CreateEvent(2, CreateEvent.EventType.PERIODIC, 50.0, QueryTime(1).encode()))
        await until(lambda: {(new, ConfirmControl), (new, ConfirmEventRequest), (new, Event)} <= set(heard))
        client.send(new, QueryControl())
        await until(lambda: (new, ReportControl) in heard)
        assert me.controller == client.id


async def test_move_to_an_id_in_use_is_an_error_and_keeps_the_id(root: Path, manager: NodeManager):
    async with at(root, HOME), at(root, "101.1.7") as me, jauspy.OCU(OCU, connect=f"local:{root}") as ocu:
        with pytest.raises(TransportError, match=r"another component 101\.1\.101 is already running"):
            me.move(HOME)
        assert str(me.id) == "101.1.7"
        await ocu.query("101.1.7", QueryTime(0xFF))
        me.host.ask_for_id(jauspy.JausID.parse(HOME))
        me.wake()
        assert str(me.id) == "101.1.7"
        assert me.counters["component.move_failed"] == 2


async def test_failed_move_does_not_affect_clients():
    hub = LoopbackHub()
    id, taken, client = map(jauspy.JausID.parse, ("101.1.7", HOME, OCU))
    me = jauspy.Component(id, [AccessControl()], transport=LoopbackTransport(id, hub))
    async with me, jauspy.Component(HOME, [Liveness()], transport=LoopbackTransport(taken, hub)):
        for source, message in (
            (taken, RegisterServices([ServiceRec("urn:x:y", 1, 0)])),
            (client, RequestControl(authority_code=200)),
            (client, CreateEvent(1, CreateEvent.EventType.PERIODIC, 50.0, QueryTime(1).encode())),
        ):
            me.host.receive(message.encode(), source, me.host.now)
        me.wake()
        with pytest.raises(TransportError, match="is already on this loopback hub"):
            me.move(HOME)
        assert me.controller == client
        assert taken in me.service(Discovery).directory.all()
        assert len(me.service(Events).subscriptions) == 1


async def test_move_ends_waits_for_acks_to_the_old_id():
    hub = LoopbackHub()
    id = jauspy.JausID.parse("101.1.7")
    async with jauspy.Component(id, [Liveness()], transport=LoopbackTransport(id, hub)) as me:
        waiting = asyncio.create_task(me.deliver("101.1.9", ReportHeartbeatPulse()))
        await asyncio.sleep(0)
        me.move(HOME)
        with pytest.raises(ResponseTimeout):
            await waiting


async def test_moved_component_reopens_under_its_new_id(root: Path, manager: NodeManager):
    me = at(root, NOWHERE)
    async with me:
        me.move(HOME)
    async with me, jauspy.OCU(OCU, connect=f"local:{root}") as ocu:
        await ocu.query(HOME, QueryTime(0xFF))


async def test_move_ends_registrations_of_others():
    hub = LoopbackHub()
    id = jauspy.JausID.parse("101.1.7")
    other = jauspy.JausID.parse("101.1.9")
    async with (
        jauspy.Component(id, [Liveness()], transport=LoopbackTransport(id, hub)) as me,
        jauspy.Component(other, [Liveness()], transport=LoopbackTransport(other, hub)),
    ):
        register = RegisterServices([ServiceRec("urn:x:y", 1, 0)]).encode()
        me.host.receive(register, other, me.host.now)
        directory = me.service(Discovery).directory
        assert set(directory.all()) == {id, other}
        me.move(HOME)
        assert set(me.service(Discovery).directory.all()) == {jauspy.JausID.parse(HOME)}
