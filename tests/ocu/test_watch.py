"""What appears, changes and vanishes, on virtual time."""

from __future__ import annotations

import asyncio
from contextlib import AsyncExitStack

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID, message_id
from jauspy.messages.core import (
    ComponentRec,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryServices,
    ReportIdentification,
    ReportServices,
    ServiceRec,
)
from jauspy.ocu import (
    OCU,
    Appeared,
    Changed,
    ComponentInfo,
    NodeInfo,
    ServiceInfo,
    SubsystemInfo,
    Vanished,
    follow_ups,
    subsystems,
)
from jauspy.ocu.subsystems import INTRODUCTION_TIME, MAX_COMPONENTS, MAX_SERVICES_OF_COMPONENT, SubsystemTree
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import pack
from jauspy.services.core import Discovery, Identity, Liveness
from jauspy.testing import LocalNode

ME = JausID(101, 1, 1)


def named(name: str) -> Discovery:
    return Discovery({2: Identity(name, 10001), 3: Identity("node", 40001), 4: Identity("component", 60001)})


def kinds(news) -> list[str]:
    """`+subsystem 101.0.0` and the like."""
    sign = {Appeared: "+", Changed: "~", Vanished: "-"}
    found = []
    for each in news:
        thing = each.before if isinstance(each, Vanished) else each.now
        what = thing.short if isinstance(thing, ServiceInfo) else type(thing).__name__.removesuffix("Info").lower()
        found.append(f"{sign[type(each)]}{what} {each.id}")
    return found


async def read(news, seconds: float) -> list:
    """Everything that is told within this time."""
    found: list = []
    reading = asyncio.ensure_future(anext(news))
    end = asyncio.get_running_loop().time() + seconds
    while (left := end - asyncio.get_running_loop().time()) > 0:
        done, _ = await asyncio.wait({reading}, timeout=left)
        if done:
            found.append(reading.result())
            reading = asyncio.ensure_future(anext(news))
    reading.cancel()
    await asyncio.wait({reading})
    return found


ALL = [
    "+subsystem 101.0.0",
    "+node 101.1.0",
    "+component 101.1.1",
    "+core:Discovery 101.1.1",
    "+core:Liveness 101.1.1",
]


async def collect(ocu, into: list, **options) -> None:
    async for each in ocu.watch(parts=True, **options):
        into.append(each)  # noqa: PERF401 - what was told is looked at meanwhile


@pytest.fixture(params=[follow_ups.MAX_BROADCAST, 0], ids=["all-at-once", "in-turn"])
async def news(request, monkeypatch, virtual_network, ocu):
    """The news of a watching OCU so far, of a few components and as in a large fleet."""
    monkeypatch.setattr(follow_ups, "MAX_BROADCAST", request.param)
    found: list = []
    task = asyncio.create_task(collect(ocu, found))
    yield found
    task.cancel()
    await asyncio.wait({task})


async def test_appearances_come_from_whole_to_part_once_each(virtual_network, news):
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(60)
        assert [each for each in kinds(news) if "Transport" not in each and "Events" not in each] == ALL
        assert isinstance(news[0].now, SubsystemInfo)
        assert isinstance(news[1].now, NodeInfo)
        assert isinstance(news[2].now, ComponentInfo)
        assert (news[0].now.name, news[2].now.name) == ("robot", "component")


async def test_silent_component_vanishes_parts_first_and_may_return(virtual_network, news):
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(10)
        appeared = kinds(news)
        virtual_network.disconnect(ME)
        news.clear()
        await asyncio.sleep(4.5)
        assert news == []
        await asyncio.sleep(5)
        assert kinds(news) == [each.replace("+", "-") for each in reversed(appeared)]
        assert news[-1].before.name == "robot"

        news.clear()
        virtual_network.reconnect(ME)
        await asyncio.sleep(4)
        assert kinds(news) == appeared


async def test_lost_packets_cause_no_vanished_component(virtual_network, news):
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(10)
        news.clear()
        virtual_network.loss = 0.3
        await asyncio.sleep(120)
        assert news == []


async def test_component_that_missed_the_broadcast_is_queried_directly(virtual_network, news):
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(10)
        news.clear()
        virtual_network.keeps = lambda packet: not packet.destination.is_wildcard
        await asyncio.sleep(60)
        assert news == []


async def test_new_name_is_reported_as_change(virtual_network, news):
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(10)
        news.clear()
    async with virtual_network.component(ME, [named("another"), Liveness()], core=False):
        await asyncio.sleep(10)
        assert kinds(news) == ["~subsystem 101.0.0"]
        assert (news[0].before.name, news[0].now.name) == ("robot", "another")


async def test_services_appear_and_vanish(virtual_network, news):
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(10)
        news.clear()
    async with virtual_network.component(ME, [named("robot")], core=False):
        await asyncio.sleep(10)
        assert kinds(news) == ["-core:Liveness 101.1.1"]


async def test_a_large_fleet_is_not_asked_all_at_once_again(virtual_network, ocu, monkeypatch):
    monkeypatch.setattr(follow_ups, "MAX_BROADCAST", 0)
    sent: list[tuple[int, bool]] = []

    def noted(packet):
        if packet.source == ocu.id:
            sent.append((message_id(packet.payload), packet.destination.is_wildcard))
        return True

    virtual_network.keeps = noted
    async with virtual_network.component(ME, [named("one"), Liveness()], core=False):
        task = asyncio.create_task(collect(ocu, []))
        await asyncio.sleep(60)
        task.cancel()
        await asyncio.wait({task})
    assert sent.count((QueryServices.CODE, True)) <= 2
    assert sent.count((QueryIdentification.CODE, True)) == 30
    assert sent.count((QueryHeartbeatPulse.CODE, True)) == 30
    assert 60 <= sent.count((QueryServices.CODE, False)) <= 125


class Lister(Discovery):
    """Lists 101.1.100 besides itself, which sends nothing."""

    def report_services(self, query: QueryServices, source: JausID) -> ReportServices:
        found = super().report_services(query, source)
        found.node_list += listed(JausID(101, 1, 100), 1).node_list
        return found


async def test_nobody_of_a_large_fleet_vanishes_between_renewals(virtual_network, ocu, monkeypatch):
    """Not what answers no heartbeats, nor what is only listed by others, though services are asked for each 20 s."""
    monkeypatch.setattr(follow_ups, "MAX_BROADCAST", 0)
    monkeypatch.setattr(follow_ups, "MAX_FOLLOW_UPS", 1)
    found: list = []
    async with AsyncExitStack() as stack:
        for number in range(1, 41):
            services = [named("robot") if number > 1 else Lister()]
            await stack.enter_async_context(virtual_network.component(JausID(101, 1, number), services, core=False))
        task = asyncio.create_task(collect(ocu, found))
        await asyncio.sleep(180)
        task.cancel()
        await asyncio.wait({task})
    news = kinds(found)
    assert sum(each.startswith("+component") for each in news) == 41
    assert "+component 101.1.100" in news
    assert not [each for each in news if each.startswith("-")]


async def test_watch_can_be_limited_to_one_subsystem(virtual_network, ocu):
    found: list = []
    task = asyncio.create_task(collect(ocu, found, subsystem=102))
    async with (
        virtual_network.component(ME, [named("one")], core=False),
        virtual_network.component("102.1.1", [named("two")], core=False),
    ):
        await asyncio.sleep(10)
    task.cancel()
    await asyncio.wait({task})
    assert {each.id.subsystem for each in found} == {102}


async def test_slow_reader_gets_the_sum_of_changes(virtual_network, ocu):
    news = ocu.watch(parts=True)
    async with virtual_network.component(ME, [named("robot")], core=False):
        assert (await anext(news)).now.name == "robot"
        async with virtual_network.component("102.1.1", [named("brief")], core=False):
            await asyncio.sleep(20)
        await asyncio.sleep(20)
        rest = await read(news, 20)
    assert {each.id.subsystem for each in rest} == {101}
    await news.aclose()


@pytest.mark.parametrize("pause", [1.0, 3.0, 9.0])
async def test_slow_reader_causes_no_vanished_component(virtual_network, ocu, pause):
    found: list = []

    async def read_slowly() -> None:
        async for each in ocu.watch(parts=True):
            found.append(each)
            await asyncio.sleep(pause)

    task = asyncio.create_task(read_slowly())
    async with virtual_network.component(ME, [named("robot"), Liveness()], core=False):
        await asyncio.sleep(200)
        appeared = kinds(found)
        assert set(appeared) >= set(ALL)
        assert len(set(appeared)) == len(appeared)
        assert {each[0] for each in appeared} == {"+"}
        found.clear()
    await asyncio.sleep(200)
    assert kinds(found) == [each.replace("+", "-") for each in reversed(appeared)]
    task.cancel()
    await asyncio.wait({task})


async def test_silent_component_vanishes_although_others_list_it():
    tree = SubsystemTree()
    listing = ReportServices.decode(_listing(9))
    tree.add(listing, ME, 0.0)
    assert list(tree) == [ME, JausID(101, 1, 9)]
    tree.add(ReportIdentification(4, 60001, "nine"), JausID(101, 1, 9), 1.0)
    tree.add(listing, ME, 10.0)
    tree.expire(5.0)
    tree.add(listing, ME, 11.0)
    assert list(tree) == [ME]
    tree.add(ReportIdentification(4, 60001, "nine"), JausID(101, 1, 9), 12.0)
    assert list(tree) == [ME, JausID(101, 1, 9)]


def _listing(component: int) -> bytes:
    """A report of 101.1.X that this component offers one service, as sent."""
    service = b"\x05urn:x\x01\x00"
    return ReportServices.CODE.to_bytes(2, "little") + bytes([1, 1, 1, component, 0, 1]) + service


def test_a_flood_of_ids_is_bounded():
    tree = SubsystemTree()
    for number in range(MAX_COMPONENTS + 100):
        tree.add(ReportIdentification(4, 60001, "x"), JausID(1 + number // 200, 1, 1 + number % 200), 0.0)
    assert len(list(tree)) == MAX_COMPONENTS
    assert len(tree.subsystems(INTRODUCTION_TIME)) == MAX_COMPONENTS // 200 + 1
    tree.expire(1.0)
    assert list(tree) == []
    assert tree._names == {}


def test_bound_of_components_is_set_by_the_client():
    tree = SubsystemTree(3)
    for number in range(1, 9):
        tree.add(ReportIdentification(4, 60001, "x"), JausID(number, 1, 1), 0.0)
    assert [id.subsystem for id in tree] == [1, 2, 3]
    for wrong in (0, -1, 1 << 21):
        with pytest.raises(ConfigError, match=r"max_components .* is outside 1..1048576"):
            OCU(max_components=wrong)


def test_a_flood_of_services_and_levels_is_bounded(monkeypatch):
    monkeypatch.setattr(subsystems, "SERVICES_PER_COMPONENT", 10)
    tree = SubsystemTree(100)
    robot = JausID(9, 1, 1)
    tree.add(listed(robot, 10), robot, 0.0)
    for number in range(1, 21):
        source = JausID(7, 1, number)
        tree.add(listed(source, 2 * MAX_SERVICES_OF_COMPONENT), source, 1.0)
        for level in range(256):
            tree.add(ReportIdentification(level, 0, "it"), source, 1.0)
    assert sum(len(each.services) for each in tree.subsystems()[0].components) == 3 * MAX_SERVICES_OF_COMPONENT
    assert tree.size < 1000 + 20 * 6
    tree.expire(0.5)
    tree.add(listed(robot, 10), robot, 2.0)
    tree.expire(1.5)
    source = JausID(7, 1, 1)
    tree.add(listed(source, 20), source, 2.0)
    assert [len(each.services) for part in tree.subsystems() for each in part.components] == [20, 10]


def listed(id: JausID, services: int) -> ReportServices:
    """What this component says of itself."""
    offered = [ServiceRec(f"urn:{number}:{id}", 1, 0) for number in range(services)]
    lists = [offered[start : start + 255] for start in range(0, services, 255)]
    component = ReportServices.ComponentSeq
    components = [component(ComponentRec(id.component, 0), each) for each in lists]
    return ReportServices([ReportServices.NodeSeq(ReportServices.NodeRec(id.node), components)])


async def test_malformed_reports_are_ignored(virtual_network, news):
    peer = virtual_network.transport(ME)
    await peer.open()
    for payload in (b"\x00", ReportIdentification.CODE.to_bytes(2, "little"), b"\x07\x4b\xff\xff"):
        peer.send(pack(Packet(ME, JausID(42, 1, 1), payload, 1)))
    await asyncio.sleep(5)
    await peer.close()
    assert news == []


@pytest.mark.parametrize("options", [{"interval": 0.0}, {"interval": 5.0, "silence": 4.0}, {"subsystem": 65535}])
async def test_invalid_options_are_rejected(ocu, options):
    with pytest.raises(ConfigError):
        await anext(ocu.watch(**options))


async def test_watch_works_over_a_node_manager():
    with LocalNode() as node:
        async with node.ocu() as ocu:
            found: list = []
            task = asyncio.create_task(collect(ocu, found, interval=0.2, silence=1.0))
            async with asyncio.timeout(20):
                async with node.component(ME, [named("robot"), Liveness()]):
                    while f"+core:Liveness {ME}" not in kinds(found):
                        await asyncio.sleep(0.01)
                while f"-subsystem {ME.subsystem}.0.0" not in kinds(found):
                    await asyncio.sleep(0.01)
            task.cancel()
            await asyncio.wait({task})


@pytest.mark.slow
async def test_one_event_for_a_robot_found_and_one_for_a_robot_lost(virtual_network, ocu):
    found: list = []

    async def follow() -> None:
        async for each in ocu.watch():
            found.append((type(each), each.id, each))  # noqa: PERF401 - looked at meanwhile

    task = asyncio.create_task(follow())
    async with virtual_network.robot():
        await asyncio.sleep(20)
        ((kind, id, event),) = found
        assert (kind, id) == (Appeared, JausID(101, 0, 0))
        assert [each.id.component for each in event.now.components] == [
            102,
            103,
            104,
            105,
            106,
            107,
            108,
            109,
            110,
            113,
        ]
        assert all(each.name and each.services for each in event.now.components)
        found.clear()
    await asyncio.sleep(30)
    ((kind, id, event),) = found
    assert (kind, id) == (Vanished, JausID(101, 0, 0))
    assert len(event.before.components) == 10
    task.cancel()
    await asyncio.wait({task})


async def test_lost_component_of_a_robot_is_one_change(virtual_network, ocu):
    found: list = []

    async def follow() -> None:
        async for each in ocu.watch():
            found.append(each)  # noqa: PERF401 - looked at meanwhile

    task = asyncio.create_task(follow())
    async with (
        virtual_network.component(ME, [named("robot"), Liveness()], core=False),
        virtual_network.component("101.1.2", [named("robot"), Liveness()], core=False),
    ):
        await asyncio.sleep(10)
        virtual_network.disconnect(JausID(101, 1, 2))
        await asyncio.sleep(20)
    task.cancel()
    await asyncio.wait({task})
    assert [type(each) for each in found] == [Appeared, Changed]
    assert [each.id for each in found[1].now.components] == [ME]
    assert len(found[1].before.components) == 2
