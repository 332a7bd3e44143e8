"""A robot that follows another one on virtual time, without physics: path, gap, and all that ends it."""

from __future__ import annotations

import asyncio
import math
import re
from collections.abc import AsyncIterator

import pytest
from tests.helpers.two_robots import FOLLOWER, LEADER, LEADER_ID, TwoRobots, two_robots

from jauspy.errors import ConfigError, RequestError
from jauspy.geometry.poses import Pose
from jauspy.messages.core import ClearEmergency, Event, SetEmergency, Standby
from jauspy.messages.iop import (
    QueryConvoyDetails,
    QueryFollowers,
    RegisterFollower,
    ReportFollowerConfiguration,
    RequestSpeedOverride,
    SetFollowerConfiguration,
    SetFollowerState,
    UpdateConvoyDetails,
)
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu import OCU
from jauspy.testing import VirtualNetwork

START, STOP = SetFollowerState.State.START, SetFollowerState.State.STOP
CORNER = (2.0, 0.0)


@pytest.fixture
async def two(virtual_network: VirtualNetwork) -> AsyncIterator[TwoRobots]:
    async with two_robots(virtual_network) as two:
        yield two


def convoy(*orders: tuple[int, int]) -> UpdateConvoyDetails:
    """101 in front; `orders`: leaders, each with a follower."""
    return UpdateConvoyDetails(
        [
            UpdateConvoyDetails.ConvoySeq(
                UpdateConvoyDetails.ConvoyRecord(1, 101),
                [UpdateConvoyDetails.ConvoyOrderRec(leader, follower) for leader, follower in orders],
            )
        ]
    )


async def drive_leader(two: TwoRobots, speed: float, seconds: float, turn: float = 0.0) -> None:
    await two.robots[0].drive(speed, turn, seconds=seconds)


@pytest.mark.slow
async def test_follows_the_path_of_the_leader_around_a_corner_and_not_the_chord(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    driving = asyncio.create_task(two.robots[0].go_to(*CORNER, speed=0.6))
    trail = []

    async def watch(task: asyncio.Task[object]) -> None:
        while not task.done():
            await asyncio.sleep(0.05)
            trail.append(two.poses[1])
        await task

    await watch(driving)
    await watch(asyncio.create_task(two.robots[0].go_to(CORNER[0], 4.0, speed=0.6)))
    nearest = min(math.hypot(pose.x - CORNER[0], pose.y - CORNER[1]) for pose in trail)
    assert nearest < 0.3, "a chord of 2 m across the corner would be 1.4 m from it"
    assert two.driver.course.gap is not None
    assert two.driver.course.gap.along == pytest.approx(2.0, abs=0.2)


@pytest.mark.slow
async def test_stops_behind_a_leader_that_stops_and_goes_on_with_it(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    await drive_leader(two, 1.2, 3.5)
    await asyncio.sleep(3.0)
    assert two.speeds[1] == 0.0
    assert 1.5 < two.distance < 2.1
    before = two.poses[1].x
    await drive_leader(two, 0.8, 4.0)
    assert two.poses[1].x > before + 2.0


@pytest.mark.slow
async def test_keeps_a_time_behind_the_leader(two: TwoRobots) -> None:
    await two.follow(gap=None, lag_time=4.0)
    past: dict[int, float] = {}
    driving = asyncio.create_task(drive_leader(two, 0.5, 14.0))
    clock = asyncio.get_running_loop().time
    errors = []
    while not driving.done():
        await asyncio.sleep(0.1)
        tick = round(clock() * 10)
        past[tick] = two.poses[0].x
        if len(past) > 110 and tick - 40 in past:
            errors.append(two.poses[1].x - past[tick - 40])
    await driving
    assert errors
    assert max(map(abs, errors)) < 0.15, "metres from where the leader was 4 s before"


@pytest.mark.slow
async def test_keeps_an_offset_to_the_right_of_the_path(two: TwoRobots) -> None:
    await two.follow(gap=2.0, lateral_offset=0.8)
    await drive_leader(two, 0.6, 14.0)
    leader, follower = two.poses
    assert follower.y - leader.y == pytest.approx(-0.8, abs=0.1), "y is to the left here"


@pytest.mark.slow
async def test_does_not_move_towards_a_leader_that_backs_up(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    await drive_leader(two, 0.6, 6.0)
    await asyncio.sleep(2.0)
    before = two.poses[1]
    await drive_leader(two, -0.3, 4.0)
    assert two.poses[1].x <= before.x + 0.02
    assert two.driver.course.gap is not None
    assert two.driver.course.gap.along == pytest.approx(two.distance, abs=0.15), "the path became shorter"


@pytest.mark.slow
async def test_stops_when_the_leader_is_silent_and_does_not_go_on_by_itself(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    driving = asyncio.create_task(drive_leader(two, 0.6, 12.0))
    await asyncio.sleep(5.0)
    assert two.speeds[1] > 0.5
    two.network.lose(Event)
    lost_at = two.poses[1].x
    await two.until(lambda: two.speeds[1] == 0.0, 2.0)
    assert two.poses[1].x - lost_at < 0.8
    await two.until(lambda: not two.driver.is_following, 4.0)
    assert "no pose of its leader" in two.driver.ended_by
    assert (await two.reported()).follower_state_rec.state == ReportFollowerConfiguration.State.STOP
    two.network.keeps = lambda _: True
    await driving
    before = two.poses[1].x
    await asyncio.sleep(1.0)
    assert two.poses[1].x == before


@pytest.mark.slow
async def test_goes_on_after_a_short_silence(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    driving = asyncio.create_task(drive_leader(two, 0.5, 12.0))
    await asyncio.sleep(4.0)
    two.network.lose(Event, 15)
    await two.until(lambda: two.speeds[1] == 0.0, 2.0)
    await driving
    assert two.driver.is_following
    assert two.distance == pytest.approx(2.0, abs=0.25)


@pytest.mark.slow
async def test_stops_when_its_operator_is_gone(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    driving = asyncio.create_task(drive_leader(two, 0.3, 20.0))
    await asyncio.sleep(4.0)
    assert two.speeds[1] > 0.2
    two.network.disconnect("42.2.1")
    await two.until(lambda: not two.driver.is_following, 7.0)
    await two.until(lambda: two.speeds[1] == 0.0, 1.0)
    driving.cancel()
    two.network.reconnect("42.2.1")


@pytest.mark.slow
@pytest.mark.parametrize(
    "message", [SetEmergency(SetEmergency.EmergencyCode.STOP), pytest.param(Standby(), marks=pytest.mark.slow)]
)
async def test_a_stop_of_the_follower_ends_following(two: TwoRobots, message: SetEmergency | Standby) -> None:
    await two.follow(gap=2.0)
    driving = asyncio.create_task(drive_leader(two, 0.5, 12.0))
    await asyncio.sleep(4.0)
    await two.tell_follower(message)
    await two.until(lambda: two.speeds[1] == 0.0, 0.6)
    assert not two.driver.is_following
    if isinstance(message, SetEmergency):
        await two.tell_follower(ClearEmergency(ClearEmergency.EmergencyCode.STOP))
    before = two.poses[1].x
    await driving
    assert two.poses[1].x == before


@pytest.mark.slow
async def test_another_command_ends_following(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    await drive_leader(two, 0.5, 3.0)
    await two.tell_follower(SetWrenchEffort(propulsive_linear_effort_x=0.0))
    await asyncio.sleep(0.1)
    assert not two.driver.is_following


async def test_start_is_for_the_client_in_control(two: TwoRobots) -> None:
    async with two.network.ocu("43.1.1") as stranger:
        await stranger.send(FOLLOWER, SetFollowerConfiguration(leader_id=LEADER_ID))
        await stranger.send(FOLLOWER, SetFollowerState(START))
        await asyncio.sleep(0.2)
    assert not two.driver.is_following
    assert two.driver.leader is None


async def test_ends_when_the_leader_is_too_far_at_start(two: TwoRobots) -> None:
    await two.follow(gap=0.5, maximum_follow_distance=1.0)
    await two.until(lambda: bool(two.driver.ended_by), 2.0)
    assert two.driver.ended_by == "its leader is 2.3 m away; the bound is 1.0 m"
    assert two.speeds[1] == 0.0


@pytest.mark.parametrize(
    ("settings", "reason"),
    [
        ({"minimum_follow_distance": 5.0, "maximum_follow_distance": 4.0}, "bad_follower_configuration"),
        (
            {"leader_id": SetFollowerConfiguration.Leader_ID(component_id=102, node_id=1, subsystem_id=102)},
            "bad_follower_configuration",
        ),
    ],
)
async def test_settings_that_cannot_be_are_refused(two: TwoRobots, settings: dict[str, object], reason: str) -> None:
    before = two.driver.settings
    await two.tell_follower(SetFollowerConfiguration(**settings))
    assert two.driver.settings == before
    assert two.host(1).counters[reason] == 1


async def test_start_without_a_leader_is_refused(two: TwoRobots) -> None:
    await two.tell_follower(SetFollowerState(START))
    assert two.host(1).counters["no_leader"] == 1


async def test_reports_its_settings_with_the_defaults(two: TwoRobots) -> None:
    await two.follow(gap=2.5, lateral_offset=-0.5, heading=1.0)
    report = (await two.reported()).follower_configuration_rec
    assert (report.leader_id.subsystem_id, report.leader_id.node_id, report.leader_id.component_id) == (101, 1, 102)
    assert report.minimum_follow_distance == pytest.approx(2.5, abs=1e-4)
    assert report.maximum_follower_distance == pytest.approx(30.0, abs=1e-4)
    assert report.lateral_offset == pytest.approx(-0.5, abs=1e-4)
    assert report.max_lateral_error is None
    assert report.heading is None, "it keeps none"


# --- convoy and the leader's speed


@pytest.mark.slow
async def test_the_convoy_says_whom_to_follow(two: TwoRobots) -> None:
    await two.tell_follower(convoy((101, 102)))
    await two.tell_follower(SetFollowerState(START))
    await drive_leader(two, 0.6, 6.0)
    assert two.speeds[1] > 0.3
    details = await two.ocus[1].query(FOLLOWER, QueryConvoyDetails())
    assert details.convoy_list[0].convoy_order_list[0].vehicle_id == 102


@pytest.mark.slow
@pytest.mark.parametrize("is_named", [True, False])
async def test_a_follower_that_the_convoy_names_may_slow_the_leader_down(two: TwoRobots, is_named: bool) -> None:
    if is_named:
        await two.tell_leader(convoy((101, 102)))
    behaviour = SetFollowerConfiguration.ErrorBehavior(stop_leader=0, allow_leader_override=1)
    await two.follow(gap=2.0, maximum_follow_distance=4.0, lag_time=8.0, error_behavior=behaviour)
    driving = asyncio.create_task(drive_leader(two, 0.5, 5.0))
    await asyncio.sleep(3.5)
    assert two.management.followers == (two.host(1).id,)
    assert (two.speeds[0] < 0.4) == is_named
    await driving
    assert (two.host(0).counters["speed_override_refused"] > 0) != is_named


@pytest.mark.slow
async def test_a_passed_bound_stops_the_leader(two: TwoRobots) -> None:
    await two.tell_leader(convoy((101, 102)))
    behaviour = SetFollowerConfiguration.ErrorBehavior(stop_leader=1, allow_leader_override=0)
    await two.follow(gap=2.0, maximum_follow_distance=3.5, lag_time=20.0, error_behavior=behaviour)
    driving = asyncio.create_task(drive_leader(two, 0.5, 8.0))
    await two.until(lambda: not two.driver.is_following, 6.0)
    await two.until(lambda: two.speeds[0] == 0.0, 1.0)
    await asyncio.sleep(2.0)
    assert two.speeds == (0.0, 0.0)
    await two.tell_follower(SetFollowerState(STOP))
    await two.until(lambda: two.speeds[0] > 0.4, 1.0)
    await driving


async def register(ocu: OCU, request: RegisterFollower.RequestType = RegisterFollower.RequestType.CONNECT):
    return await ocu.query(LEADER, RegisterFollower(request))


@pytest.mark.slow
async def test_registration_ends_unless_it_is_renewed(two: TwoRobots) -> None:
    async with two.network.ocu("102.1.200") as follower:
        await two.tell_leader(convoy((101, 102)))
        await follower.send(LEADER, RegisterFollower(RegisterFollower.RequestType.CONNECT))
        await follower.send(LEADER, RequestSpeedOverride(RequestSpeedOverride.PercentRec(50.0)))
        driving = asyncio.create_task(drive_leader(two, 0.6, 9.0))
        await asyncio.sleep(3.0)
        assert two.speeds[0] == pytest.approx(0.3, abs=0.05)
        report = await follower.query(LEADER, QueryFollowers())
        assert [each.follower_id.subsystem_id for each in report.follower_list] == [102]
        await asyncio.sleep(4.0)
        assert two.speeds[0] == pytest.approx(0.6, abs=0.05), "its wish ended with its registration"
        assert (await follower.query(LEADER, QueryFollowers())).follower_list == []
        await driving


@pytest.mark.slow
async def test_a_robot_starts_behind_the_one_before_it_or_where_it_is_told(virtual_network: VirtualNetwork) -> None:
    async with two_robots(virtual_network, start=Pose(x=-3.0, y=1.0, yaw=math.pi / 2)) as two:
        assert two.poses[1] == Pose(x=-3.0, y=1.0, yaw=math.pi / 2)
        await two.robots[1].drive(0.5, 0.0, seconds=1.0)
        assert two.poses[1].x == pytest.approx(-3.0, abs=1e-6)
        assert two.poses[1].y > 1.3


# --- verbs of the client


@pytest.mark.slow
async def test_verbs_begin_and_end_following(two: TwoRobots) -> None:
    follower = two.robots[1]
    assert not (await follower.following()).is_following
    await follower.follow(101, gap=2.0, offset=0.5)
    state = await follower.following()
    assert (state.is_following, str(state.leader)) == (True, LEADER)
    assert (state.gap, state.lag, state.max_gap, state.offset) == pytest.approx((2.0, 0.0, 30.0, 0.5), abs=1e-3)
    await drive_leader(two, 0.6, 12.0)
    leader, behind = two.poses
    assert behind.y - leader.y == pytest.approx(0.5, abs=0.1), "to the left"
    await follower.stop_following()
    assert not (await follower.following()).is_following
    assert two.driver.ended_by == ""


async def test_verbs_set_the_convoy(two: TwoRobots) -> None:
    await two.robots[0].set_convoy(102, 103)
    details = await two.ocus[0].query(LEADER, QueryConvoyDetails())
    (convoy,) = details.convoy_list
    assert [(row.leader_id, row.vehicle_id) for row in convoy.convoy_order_list] == [(101, 102), (102, 103)]
    await two.robots[0].set_convoy()
    assert (await two.ocus[0].query(LEADER, QueryConvoyDetails())).convoy_list == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("leader", "options", "message"),
    [
        (102, {}, "cannot follow itself"),
        (101, {"gap": 5.0, "max_gap": 4.0}, "max_gap=4 above gap"),
        (101, {"gap": -1.0}, "must not be negative"),
        (101, {"gap": math.nan}, "gap"),
        (0, {}, "0"),
        ("101.1", {}, "101.1"),
    ],
)
async def test_wrong_uses_of_the_verbs(two: TwoRobots, leader: object, options: dict[str, float], message: str) -> None:
    with pytest.raises(ConfigError, match=re.escape(message)):
        await two.robots[1].follow(leader, **options)  # type: ignore[arg-type]


async def test_the_verb_says_when_it_does_not_begin(two: TwoRobots) -> None:
    with pytest.raises(RequestError, match=r"does not follow 101\.1\.102"):
        await two.robots[1].follow(101, gap=0.5, max_gap=1.0)
    with pytest.raises(ConfigError, match="each robot drives in it once"):
        await two.robots[0].set_convoy(102, 102)
    with pytest.raises(ConfigError, match=r"a follower is 70000; it must be the number of a subsystem, 1\.\.65534"):
        await two.robots[0].set_convoy(70000)
