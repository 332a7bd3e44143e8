from __future__ import annotations

import asyncio

import pytest

import jauspy
from jauspy.errors import ConfigError, ResponseTimeout, TransportError
from jauspy.ids import JausID
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


async def test_a_lost_answer_is_asked_for_again(world):
    await world.robot()
    world.network.lose(ReportStatus, times=2)
    ocu = await world.ocu(timeout=0.05)

    await ocu.query(ROBOT, QueryStatus())

    assert len(world.network.sent(QueryStatus)) == 3
    assert ocu.stats.answers == 1
    assert ocu.stats.rtt_max == 0.0  # nobody knows which question was answered


async def test_silence_says_what_was_sent_and_what_to_do(world):
    ocu = await world.ocu(timeout=0.02, retries=1)

    with pytest.raises(
        ResponseTimeout, match=r"101\.1\.1 was sent QueryStatus 2 times in 0\.04 s and no answer came; check"
    ):
        await ocu.query(ROBOT, QueryStatus())
    assert ocu.stats.timeouts == 1


async def test_equal_queries_may_be_outstanding_at_once(world):
    await world.robot()
    ocu = await world.ocu()

    reports = await asyncio.gather(*(ocu.query(ROBOT, QueryStatus()) for _ in range(20)))

    assert len(reports) == 20
    assert ocu.stats.answers == 20


async def test_different_queries_with_like_answers_each_get_their_own(world):
    await world.robot()
    world.network.lose(ReportLocalPose, times=1)
    ocu = await world.ocu()

    async def ask(mask: int) -> ReportLocalPose:
        return await ocu.query(ROBOT, QueryLocalPose(presence_vector=mask), expects=ReportLocalPose)

    only_x, only_yaw, again_x = await asyncio.gather(ask(0x01), ask(0x40), ask(0x01))

    assert (only_x.x, only_x.yaw) == (again_x.x, again_x.yaw) == (pytest.approx(0, abs=1e-4), None)
    assert (only_yaw.x, only_yaw.yaw) == (None, pytest.approx(0, abs=1e-4))


async def test_nobody_waits_for_ever_behind_those_who_ask_the_same_again_and_again(world):
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


async def test_a_query_that_had_no_turn_says_so(world):
    ocu = await world.ocu(timeout=1)
    first = asyncio.create_task(ocu.query(ROBOT, QueryLocalPose(presence_vector=1)))
    await asyncio.sleep(0)
    with pytest.raises(ResponseTimeout, match=r"QueryLocalPose was not sent to 101\.1\.1: for 0\.2 s another"):
        await ocu.query(ROBOT, QueryLocalPose(presence_vector=2), timeout=0.2, retries=0)
    assert ocu.stats.timeouts == 1
    with pytest.raises(ResponseTimeout, match="was sent QueryLocalPose"):
        await first


async def test_a_loop_that_only_sends_lets_others_run(world):
    ocu = await world.ocu()
    other = asyncio.create_task(asyncio.sleep(0))
    for _ in range(5):
        await ocu.send(ROBOT, Resume())
    assert other.done()


async def test_late_answers_and_messages_that_nobody_knows_are_counted(world):
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


async def test_an_answer_of_another_kind_is_named(world):
    await world.robot()
    ocu = await world.ocu(timeout=0.1, retries=0)
    with pytest.raises(ResponseTimeout, match=r"no ReportControl came, but ReportStatus did \(`expects` says what to"):
        await ocu.query(ROBOT, QueryStatus(), expects=ReportControl)
    with pytest.raises(ResponseTimeout, match="no answer came"):
        await ocu.query("101.1.9", QueryStatus())


async def test_an_answer_that_is_not_known_is_named(world):
    ocu = await world.ocu(timeout=0.1, retries=0)
    peer = world.transport(ROBOT)
    await peer.open()
    peer.received = lambda _: peer.send(pack(Packet(peer.id, ocu.id, b"\x99\xdd\x01")))
    with pytest.raises(ResponseTimeout, match=r"no ReportStatus came, but DD99h, which is not known here, did"):
        await ocu.query(ROBOT, QueryStatus())
    await peer.close()


async def test_levels_of_identification_are_not_mixed_up(world):
    await world.robot()
    ocu = await world.ocu()

    reports = await asyncio.gather(
        *(ocu.query(ROBOT, QueryIdentification(query_type=level)) for level in (1, 2, 3, 4) * 3)
    )

    assert [int(report.query_type) for report in reports] == [1, 2, 3, 4] * 3


async def test_a_cancelled_query_makes_way_for_the_next(world):
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


async def test_the_wrong_sender_and_garbage_do_not_count_as_answers(world):
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


async def test_closing_ends_what_waits(world):
    ocu = await world.ocu(timeout=30)
    waiting = asyncio.create_task(ocu.query(ROBOT, QueryStatus()))
    await asyncio.sleep(0)

    await ocu.close()
    await ocu.close()

    with pytest.raises(TransportError, match="the OCU was closed while this waited"):
        await waiting
    with pytest.raises(TransportError, match="not open; use it inside `async with"):
        await ocu.query(ROBOT, QueryStatus())


async def test_only_queries_have_an_answer_by_themselves(world):
    ocu = await world.ocu()
    with pytest.raises(ConfigError, match="Resume is no query"):
        await ocu.query(ROBOT, Resume())
    with pytest.raises(ConfigError, match="timeout 0 s must be above 0"):
        await ocu.query(ROBOT, QueryStatus(), timeout=0)


async def test_a_wildcard_takes_the_first_answer(world):
    await world.robot()
    ocu = await world.ocu()
    report = await ocu.query("101.255.255", QueryIdentification(query_type=2), expects=ReportIdentification)
    assert report.identification == "test robot"


async def test_stats(world):
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
async def test_a_wrong_connect_shows_the_forms(connect):
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


async def test_all_who_answer_a_wildcard_are_told_apart_and_each_once(world):
    await world.robot()
    await world.robot(JausID(102, 1, 7))
    ocu = await world.ocu()
    world.network.lose(ReportStatus, times=1)

    found = [pair async for pair in ocu.query_each("65535.255.255", QueryStatus(), within=1.2)]

    assert sorted(source for source, _ in found) == [ROBOT, JausID(102, 1, 7)]
    assert all(isinstance(answer, ReportStatus) for _, answer in found)


async def test_who_reads_answers_slowly_gets_all_that_came_in_time(world):
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
async def test_no_time_for_answers(world, within):
    ocu = await world.ocu()
    with pytest.raises(ConfigError, match=r"within .* s must be above 0"):
        await anext(ocu.query_each("9.255.255", QueryStatus(), within=within))


async def test_nobody_answers_a_wildcard(world):
    ocu = await world.ocu()
    assert [each async for each in ocu.query_each("9.255.255", QueryStatus(), within=0.1)] == []
