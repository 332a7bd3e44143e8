"""Who can make a follower drive where its leader was not, or slow a leader down: forged poses, floods of followers."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from datetime import UTC, datetime

import pytest
from tests.helpers.two_robots import LEADER, TwoRobots, two_robots

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import ConfirmEventRequest, Event
from jauspy.messages.iop import RegisterFollower, RegisterFollowerResponse, RequestSpeedOverride, UpdateConvoyDetails
from jauspy.messages.mobility import ReportGlobalPose
from jauspy.services.iop.convoy import MAX_ORDERS, Convoy
from jauspy.services.iop.leader_management import MAX_FOLLOWERS
from jauspy.services.units import time_stamp
from jauspy.testing import VirtualNetwork

LEADER_JAUS, STRANGER = JausID.parse(LEADER), JausID(66, 6, 6)
CONNECT = RegisterFollower(RegisterFollower.RequestType.CONNECT)
STOP = RequestSpeedOverride(RequestSpeedOverride.AbsoluteRec(0.0))


@pytest.fixture
async def two(virtual_network: VirtualNetwork) -> AsyncIterator[TwoRobots]:
    async with two_robots(virtual_network) as two:
        await two.follow(gap=2.0)
        await two.until(lambda: two.driver._track is not None, 2.0)
        yield two


def pose(two: TwoRobots, north: float = 0.0, **changes: float | None) -> ReportGlobalPose:
    """That of the leader, shifted by metres to the north."""
    frame = two.driver.vehicle.global_frame()
    here = frame.from_world(two.service(type(two.driver), 0).vehicle.pose)
    fields = {"latitude": here.latitude + north / 111_000.0, "longitude": here.longitude, "yaw": here.heading}
    return ReportGlobalPose(**(fields | changes), time_stamp=time_stamp(datetime(2026, 1, 1, tzinfo=UTC)))


def forge(two: TwoRobots, content: Message | bytes, source: JausID = LEADER_JAUS, event: int | None = None) -> None:
    """Give the follower an event that continues the one of its leader."""
    events, host = two.driver._poses, two.host(1)
    number = (events._sequence or 0) + 1 & 0xFF
    forged = Event(events._event if event is None else event, number, content)
    host.receive(forged.encode(), source, host.now)


def counted(two: TwoRobots, robot: int = 1) -> dict[str, int]:
    return dict(two.host(robot).counters)


@pytest.mark.slow
async def test_poses_of_others_are_counted_and_not_used(two: TwoRobots) -> None:
    before = two.driver._track.path.leader.position
    forge(two, pose(two, 1.0), STRANGER)
    forge(two, pose(two, 1.0), event=(two.driver._poses._event + 1) & 0xFF)
    assert counted(two)["unrequested_event"] == 2
    assert two.driver._track.path.leader.position == before


@pytest.mark.parametrize("far", [8.0, 500.0, 1e6])
async def test_jumps_are_counted_and_do_not_move_it(two: TwoRobots, far: float) -> None:
    before, path = two.poses[1], two.driver._track.path
    place = path.leader.position
    for _ in range(20):
        forge(two, pose(two, min(far, 4e6)))
    assert counted(two)["leader_jump"] == 20
    assert path.leader.position == place
    await asyncio.sleep(1.0)
    assert two.poses[1].x - before.x < 0.5, "it only closes up to its leader"
    assert abs(two.poses[1].y) < 0.01


@pytest.mark.slow
async def test_a_leader_that_jumps_for_good_is_lost_and_the_follower_stops(two: TwoRobots) -> None:
    two.network.lose(Event)
    end = two.host(1).now + 5.0
    while two.driver.is_following:
        assert two.host(1).now < end
        forge(two, pose(two, 50.0))
        await asyncio.sleep(0.1)
    assert "no pose of its leader" in two.driver.ended_by
    assert two.speeds[1] == 0.0


@pytest.mark.slow
@pytest.mark.parametrize(
    "changes",
    [{"latitude": None}, {"longitude": None}, {"yaw": None}, {"latitude": 90.0}, {"latitude": -90.0, "yaw": 3.14159}],
)
async def test_incomplete_and_extreme_poses_are_counted(two: TwoRobots, changes: dict[str, float | None]) -> None:
    path = two.driver._track.path
    place = path.leader.position
    forge(two, pose(two, **changes))
    counts = counted(two)
    assert counts.get("unusable_leader_pose", 0) + counts.get("leader_jump", 0) == 1
    assert path.leader.position == place


@pytest.mark.slow
@pytest.mark.parametrize("content", [b"", b"\x02", b"\x02\x44", b"\xff" * 64, ReportGlobalPose().encode() + b"\x00"])
async def test_events_that_hold_no_pose_are_counted(two: TwoRobots, content: bytes) -> None:
    forge(two, content)
    counts = counted(two)
    assert counts.get("unusable_leader_pose", 0) + counts.get("malformed_Event", 0) == 1
    assert two.host(1).first_error is None
    assert two.driver.is_following


async def test_repeated_events_are_dropped(two: TwoRobots) -> None:
    for _ in range(5):
        forge(two, pose(two))
    host, events = two.host(1), two.driver._poses
    old = Event(events._event, (events._sequence - 3) & 0xFF, pose(two, 0.3))
    host.receive(old.encode(), LEADER_JAUS, host.now)
    assert counted(two)["late_event"] == 1


async def test_confirmations_of_others_do_not_take_the_event_over(two: TwoRobots) -> None:
    host, events = two.host(1), two.driver._poses
    before = events._event
    for request in range(256):
        host.receive(ConfirmEventRequest(request, 77, 10.0).encode(), STRANGER, host.now)
    assert events._event == before


async def test_an_error_that_the_leader_claims_widens_the_gap_only(two: TwoRobots) -> None:
    """A leader that says it knows its place badly is kept away from, never approached."""
    before = two.poses[1].x
    for _ in range(10):
        forge(two, pose(two, position_rms=100.0))
        await asyncio.sleep(0.1)
    assert two.poses[1].x - before < 0.5


async def test_a_flood_of_registrations_is_bounded_and_counted(two: TwoRobots) -> None:
    host = two.host(0)
    for number in range(1, 1001):
        host.receive(CONNECT.encode(), JausID(1000 + number, 1, 1), host.now)
    assert len(two.management.followers) == MAX_FOLLOWERS
    assert host.counters["followers_full"] == 1000 - MAX_FOLLOWERS
    await two.tell_leader(
        UpdateConvoyDetails(
            [
                UpdateConvoyDetails.ConvoySeq(
                    UpdateConvoyDetails.ConvoyRecord(1, 101), [UpdateConvoyDetails.ConvoyOrderRec(101, 102)]
                )
            ]
        )
    )
    host.receive(CONNECT.encode(), JausID(102, 1, 102), host.now)
    assert JausID(102, 1, 102) in two.management.followers, "one that the convoy names has a place"
    assert len(two.management.followers) == MAX_FOLLOWERS
    assert host.counters["follower_replaced"] == 1


@pytest.mark.slow
async def test_strangers_do_not_slow_a_leader_down(two: TwoRobots) -> None:
    host = two.host(0)
    driving = asyncio.create_task(two.robots[0].drive(0.6, 0.0, seconds=4.0))
    await asyncio.sleep(2.0)
    host.receive(STOP.encode(), STRANGER, host.now)
    assert host.counters["speed_override_unregistered"] == 1
    host.receive(CONNECT.encode(), STRANGER, host.now)
    host.receive(STOP.encode(), STRANGER, host.now)
    assert host.counters["speed_override_refused"] == 1
    await asyncio.sleep(1.0)
    assert two.speeds[0] == pytest.approx(0.6, abs=0.05)
    await driving


async def test_a_convoy_is_set_by_the_client_in_control_and_bounded(two: TwoRobots) -> None:
    host, plan = two.host(0), two.service(Convoy, 0)

    def update(orders: list[tuple[int, int]]) -> UpdateConvoyDetails:
        rows = [UpdateConvoyDetails.ConvoyOrderRec(leader, follower) for leader, follower in orders]
        parts = [rows[start : start + 255] for start in range(0, len(rows), 255)]
        return UpdateConvoyDetails(
            [UpdateConvoyDetails.ConvoySeq(UpdateConvoyDetails.ConvoyRecord(1, 101), part) for part in parts]
        )

    host.receive(update([(101, 66)]).encode(), STRANGER, host.now)
    assert plan.leader_of(66) is None
    for orders in (
        [(101, 1000 + number) for number in range(MAX_ORDERS + 1)],
        [(101, 102), (103, 102)],
        [(102, 102)],
        [(0, 102)],
        [(103, 102), (102, 103)],  # two that wait for each other
        [(101, 104), (103, 102), (105, 103), (102, 105)],
        [(102, 101), (101, 102)],
        [(101, 102), (103, 101)],  # the head, 101, follows
    ):
        await two.tell_leader(update(orders))
        assert plan.leader_of(102) is None
    assert host.counters["bad_convoy"] == 8
    await two.tell_leader(update([(101, 102), (102, 103), (102, 104), (104, 105)]))
    assert [plan.leader_of(number) for number in (101, 102, 103, 104, 105)] == [None, 101, 102, 102, 104]


async def test_responses_of_others_do_not_register_a_follower(two: TwoRobots) -> None:
    host = two.host(1)
    response = RegisterFollowerResponse(RegisterFollowerResponse.Result.CONNECTED, timeout=5)
    host.receive(response.encode(), STRANGER, host.now)
    assert counted(two)["unrequested_registration"] == 1
    assert not two.driver._requests.is_registered
