"""What a query is answered by is known to its class; tests/typing/ has what type checkers know."""

from __future__ import annotations

import asyncio

import pytest

import jauspy
from jauspy.errors import ConfigError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryStatus,
    ReportControl,
    ReportIdentification,
    ReportStatus,
    Resume,
)
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu import OCU
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import pack

ROBOT = JausID(101, 1, 1)


async def test_a_query_is_answered_with_its_report(world):
    await world.robot()
    ocu = await world.ocu()

    report = await ocu.query("101.1.1", QueryStatus())

    assert report == ReportStatus(status=ReportStatus.Status.STANDBY, reserved=0)


async def test_query_is_repeated_after_a_lost_answer(world):
    await world.robot()
    world.network.lose(ReportStatus, times=2)
    ocu = await world.ocu(timeout=0.05)

    await ocu.query(ROBOT, QueryStatus())

    assert len(world.network.sent(QueryStatus)) == 3
    assert ocu.stats.answers == 1
    assert ocu.stats.rtt_max == 0.0  # nobody knows which question was answered


async def test_timeout_error_names_query_and_remedy(world):
    ocu = await world.ocu(timeout=0.02, retries=1)

    with pytest.raises(
        ResponseTimeout, match=r"101\.1\.1 was sent QueryStatus 2 times in 0\.04 s and no answer came; check"
    ):
        await ocu.query(ROBOT, QueryStatus())
    assert ocu.stats.timeouts == 1


async def test_equal_queries_are_concurrent(world):
    await world.robot()
    ocu = await world.ocu()

    reports = await asyncio.gather(*(ocu.query(ROBOT, QueryStatus()) for _ in range(20)))

    assert len(reports) == 20
    assert ocu.stats.answers == 20


async def test_queries_with_one_report_class_are_serialised(world):
    await world.robot()
    world.network.lose(ReportLocalPose, times=1)
    ocu = await world.ocu()

    async def ask(mask: int) -> ReportLocalPose:
        return await ocu.query(ROBOT, QueryLocalPose(presence_vector=mask), expects=ReportLocalPose)

    only_x, only_yaw, again_x = await asyncio.gather(ask(0x01), ask(0x40), ask(0x01))

    assert (only_x.x, only_x.yaw) == (again_x.x, again_x.yaw) == (pytest.approx(0, abs=1e-4), None)
    assert (only_yaw.x, only_yaw.yaw) == (None, pytest.approx(0, abs=1e-4))


async def test_repeated_equal_queries_do_not_starve_others(world):
    await world.robot()
    ocu = await world.ocu(timeout=1)
    world.network.delay = 0.05

    async def poll() -> None:
        while True:
            await ocu.query(ROBOT, QueryLocalPose(presence_vector=1))

    async with asyncio.TaskGroup() as group:
        polling = []
        for _ in range(3):
            polling.append(group.create_task(poll()))
            await asyncio.sleep(0.03)
        for mask in (2, 4, 2, 0x40):
            await asyncio.wait_for(ocu.query(ROBOT, QueryLocalPose(presence_vector=mask)), 1)
        others = [group.create_task(ocu.query(ROBOT, QueryLocalPose(presence_vector=mask))) for mask in (2, 4, 8)]
        await asyncio.sleep(0)
        others[0].cancel()
        await asyncio.wait(others, timeout=1)
        assert [each.done() for each in others] == [True] * 3
        for each in polling:
            each.cancel()


async def test_timeout_before_sending_is_explained(world):
    ocu = await world.ocu(timeout=1)
    first = asyncio.create_task(ocu.query(ROBOT, QueryLocalPose(presence_vector=1)))
    await asyncio.sleep(0)
    with pytest.raises(ResponseTimeout, match=r"QueryLocalPose was not sent to 101\.1\.1: for 0\.2 s another"):
        await ocu.query(ROBOT, QueryLocalPose(presence_vector=2), timeout=0.2, retries=0)
    assert ocu.stats.timeouts == 1
    with pytest.raises(ResponseTimeout, match="was sent QueryLocalPose"):
        await first


async def test_send_loop_lets_other_tasks_run(world):
    ocu = await world.ocu()
    other = asyncio.create_task(asyncio.sleep(0))
    for _ in range(5):
        await ocu.send(ROBOT, Resume())
    assert other.done()


async def test_late_and_unknown_messages_are_counted(world):
    ocu = await world.ocu(timeout=0.1, retries=0)
    await world.robot()
    world.network.delay = 0.2
    with pytest.raises(ResponseTimeout):
        await ocu.query(ROBOT, QueryStatus())
    stranger = world.transport(JausID(9, 1, 1))
    await stranger.open()
    stranger.send(pack(Packet(stranger.id, ocu.id, b"\x99\xdd\x01")))
    await asyncio.sleep(1)
    assert ocu.stats.unexpected == 2
    await stranger.close()


async def test_timeout_error_names_other_messages(world):
    await world.robot()
    ocu = await world.ocu(timeout=0.1, retries=0)
    with pytest.raises(ResponseTimeout, match=r"no ReportControl came, but ReportStatus did \(`expects` says what to"):
        await ocu.query(ROBOT, QueryStatus(), expects=ReportControl)
    with pytest.raises(ResponseTimeout, match="no answer came"):
        await ocu.query("101.1.9", QueryStatus())


async def test_timeout_error_names_unknown_messages(world):
    ocu = await world.ocu(timeout=0.1, retries=0)
    peer = world.transport(ROBOT)
    await peer.open()
    peer.received = lambda _: peer.send(pack(Packet(peer.id, ocu.id, b"\x99\xdd\x01")))
    with pytest.raises(ResponseTimeout, match=r"no ReportStatus came, but DD99h, which is not known here, did"):
        await ocu.query(ROBOT, QueryStatus())
    await peer.close()


async def test_identification_levels_are_distinguished(world):
    await world.robot()
    ocu = await world.ocu()

    reports = await asyncio.gather(
        *(ocu.query(ROBOT, QueryIdentification(query_type=level)) for level in (1, 2, 3, 4) * 3)
    )

    assert [int(report.query_type) for report in reports] == [1, 2, 3, 4] * 3


async def test_cancelled_query_unblocks_the_next(world):
    ocu = await world.ocu(timeout=5)
    first = asyncio.create_task(ocu.query(ROBOT, QueryLocalPose(presence_vector=1)))
    await asyncio.sleep(0)
    second = asyncio.create_task(ocu.query(ROBOT, QueryLocalPose(presence_vector=2)))
    await asyncio.sleep(0)
    await world.robot()

    first.cancel()

    assert (await second).y is not None
    with pytest.raises(asyncio.CancelledError):
        await first


async def test_other_senders_and_garbage_are_no_answers(world):
    ocu = await world.ocu(timeout=0.1, retries=0)
    peer, stranger = world.transport(ROBOT), world.transport(JausID(101, 1, 9))
    await peer.open()
    await stranger.open()

    def answer(_: bytes) -> None:
        stranger.send(pack(Packet(stranger.id, ocu.id, ReportStatus(status=1, reserved=0).encode())))
        peer.send(pack(Packet(peer.id, ocu.id, ReportControl(0, 0, 0, 0).encode())))
        peer.send(pack(Packet(peer.id, ocu.id, b"\x02\x40\x01")))

    peer.received = answer
    with pytest.raises(ResponseTimeout, match=r"an answer came but could not be read \(ReportStatus: byte"):
        await ocu.query(ROBOT, QueryStatus())
    await peer.close()
    await stranger.close()


async def test_close_ends_pending_queries(world):
    ocu = await world.ocu(timeout=30)
    waiting = asyncio.create_task(ocu.query(ROBOT, QueryStatus()))
    await asyncio.sleep(0)

    await ocu.close()
    await ocu.close()

    with pytest.raises(TransportError, match="the OCU was closed while this waited"):
        await waiting
    with pytest.raises(TransportError, match="not open; use it inside `async with"):
        await ocu.query(ROBOT, QueryStatus())


async def test_other_messages_need_expects(world):
    ocu = await world.ocu()
    with pytest.raises(ConfigError, match="Resume is not a query"):
        await ocu.query(ROBOT, Resume())
    with pytest.raises(ConfigError, match="timeout 0 s must be above 0"):
        await ocu.query(ROBOT, QueryStatus(), timeout=0)


async def test_wildcard_query_returns_the_first_answer(world):
    await world.robot()
    ocu = await world.ocu()
    report = await ocu.query("101.255.255", QueryIdentification(query_type=2), expects=ReportIdentification)
    assert report.identification == "test robot"


async def test_statistics_are_counted(world):
    await world.robot()
    ocu = await world.ocu()
    for _ in range(3):
        await ocu.query(ROBOT, QueryHeartbeatPulse())

    stats = ocu.stats
    assert (stats.sent, stats.received, stats.answers) == (3, 3, 3)
    assert 0 < stats.rtt_min <= stats.rtt_median <= stats.rtt_max < 1


@pytest.mark.parametrize(
    "connect", ["http://x", "tcp://", "udp://", "local:", "udp://host:99999", "udp://host/path", "10.0.0.1"]
)
async def test_invalid_connect_error_lists_the_forms(connect):
    with pytest.raises(ConfigError, match=r"udp://HOST\[:PORT\].*tcp://HOST.*local:DIRECTORY"):
        await jauspy.OCU("42.1.1", connect=connect).open()


async def test_an_unknown_host_is_named():
    with pytest.raises(TransportError, match=r"host 'nowhere\.invalid'"):
        await OCU(connect="udp://nowhere.invalid").open()


@pytest.mark.parametrize("id", ["42.1", "65535.1.1", "42.0.1"])
def test_a_wrong_id_is_refused(id):
    with pytest.raises(ConfigError):
        OCU(id)


async def test_direct_udp_needs_no_node_manager_to_open():
    async with OCU(connect="udp://127.0.0.1:9") as ocu:
        assert ocu.is_open
    assert not ocu.is_open


async def test_query_each_yields_each_sender_once(world):
    await world.robot()
    await world.robot(JausID(102, 1, 7))
    ocu = await world.ocu()
    world.network.lose(ReportStatus, times=1)

    found = [pair async for pair in ocu.query_each("65535.255.255", QueryStatus(), within=1.2)]

    assert sorted(source for source, _ in found) == [ROBOT, JausID(102, 1, 7)]
    assert all(isinstance(answer, ReportStatus) for _, answer in found)


async def test_slow_reader_gets_all_answers_in_time(world):
    ids = [JausID(101, 1, number) for number in (1, 2, 3)]
    for id in ids:
        await world.robot(id)
    ocu = await world.ocu()
    found = []
    async for source, _ in ocu.query_each("101.255.255", QueryStatus(), within=0.2):
        found.append(source)
        await asyncio.sleep(1.0)
    assert sorted(found) == ids


@pytest.mark.parametrize("within", [0, -1, float("nan")])
async def test_query_each_rejects_zero_seconds(world, within):
    ocu = await world.ocu()
    with pytest.raises(ConfigError, match=r"within .* s must be above 0"):
        await anext(ocu.query_each("9.255.255", QueryStatus(), within=within))


async def test_query_each_without_answers_ends(world):
    ocu = await world.ocu()
    assert [each async for each in ocu.query_each("9.255.255", QueryStatus(), within=0.1)] == []


NAMED_OTHERWISE = {"QueryHostManipulator", "QueryJointOperationalParameters", "QueryPanTiltHostManipulator"}
"""Queries of IOP v3 whose reports are not named after them; what their services send says which they are."""


def test_the_report_is_of_the_same_service_and_version():
    queries = [query for query in registry if query.IS_QUERY]
    known = [query for query in queries if hasattr(query, "REPORT")]
    assert len(known) > 0.9 * len(queries)
    for query in known:
        assert (query.REPORT.SERVICE, query.REPORT.VERSION) == (query.SERVICE, query.VERSION)
        same = query.REPORT.NAME.removeprefix("Report") == query.NAME.removeprefix("Query")
        assert same or query.CODE < 0x4000 or query.NAME in NAMED_OTHERWISE, query
