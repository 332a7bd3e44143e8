"""A follower whose client is lost or whose leader ends: the policy for lost links, and following, never both."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator

import pytest
from tests.helpers.two_robots import FOLLOWER, TwoRobots, two_robots

from jauspy.messages.core import SetEmergency
from jauspy.messages.iop import SetCommsLostPolicy as Policy
from jauspy.services.iop import Retrotraverse
from jauspy.services.mobility.driver import Driver
from jauspy.testing import VirtualNetwork

CONTROL = 5.0
"""Seconds after which the silent client loses control, by inc1's file."""
BACK = Policy(
    Policy.PolicyRec(1),
    Policy.CommsLostSeq(
        Policy.CommsLostDetectionRec(0),
        Policy.RetrotraverseParameterSeq(Policy.RetrotraverseActionRec(50.0, 0.0, Policy.Parameters(0, 0), 0.0), None),
    ),
    Policy.CommsRegainedSeq(Policy.CommsRegainedRec(0, 1)),
)
CONTINUE = Policy(
    Policy.PolicyRec(1),
    Policy.CommsLostSeq(Policy.CommsLostDetectionRec(0), Policy.ContinueMissionVar(0)),
    Policy.CommsRegainedSeq(Policy.CommsRegainedRec(0, 1)),
)


@pytest.fixture
async def two(virtual_network: VirtualNetwork) -> AsyncIterator[TwoRobots]:
    async with two_robots(virtual_network) as two:
        yield two


async def lose_the_follower(two: TwoRobots, policy: Policy) -> float:
    """Follow the leader for some metres, then cut off its client; returns x where the follower was then."""
    await two.tell_follower(policy)
    await two.follow(gap=2.0)
    await two.robots[0].drive(0.6, 0.0, seconds=8.0)
    two.network.disconnect("42.2.1")
    return two.poses[1].x


async def driven_for(two: TwoRobots, seconds: float) -> list[tuple[float, Driver | None]]:
    """Drive the leader on, and note x of the follower, and who drives it, each tenth of a second."""
    driving = asyncio.create_task(two.robots[0].drive(0.6, 0.0, seconds=seconds))
    noted = []
    while not driving.done():
        noted.append((two.poses[1].x, two.driver.vehicle.pilot.driver))
        await asyncio.sleep(0.1)
    await driving
    return noted


@pytest.mark.slow
async def test_a_follower_without_its_client_drives_back_and_follows_no_more(two: TwoRobots) -> None:
    begun = two.poses[1].x
    await lose_the_follower(two, BACK)
    noted = await driven_for(two, CONTROL + 20.0)
    drivers = [driver for _, driver in noted]
    first_back = next(index for index, driver in enumerate(drivers) if isinstance(driver, Retrotraverse))
    assert not any(driver is two.driver for driver in drivers[first_back:])
    assert any(driver is None for driver in drivers[:first_back]), "it stood before it drove back"
    assert two.poses[1].x == pytest.approx(begun, abs=0.3)
    assert not two.driver.is_following


@pytest.mark.slow
async def test_following_is_no_mission_that_goes_on_without_a_client(two: TwoRobots) -> None:
    await lose_the_follower(two, CONTINUE)
    noted = await driven_for(two, CONTROL + 10.0)
    assert not two.driver.is_following
    stopped = [x for x, driver in noted[-80:] if driver is None]
    assert len(stopped) == 80
    assert max(stopped) - min(stopped) < 0.05


@pytest.mark.slow
async def test_an_emergency_on_the_way_back_of_a_follower_ends_it(two: TwoRobots) -> None:
    await lose_the_follower(two, BACK)
    await two.until(lambda: isinstance(two.driver.vehicle.pilot.driver, Retrotraverse), CONTROL + 5.0)
    await asyncio.sleep(1.0)
    assert two.speeds[1] < -0.1
    await two.ocus[0].send(FOLLOWER, SetEmergency(SetEmergency.EmergencyCode.STOP), ack=True)
    await two.until(lambda: two.speeds[1] == 0.0, 2.0)
    stopped = two.poses[1].x
    await asyncio.sleep(10.0)
    assert two.poses[1].x == pytest.approx(stopped, abs=0.02)
    assert not two.driver.is_following


@pytest.mark.slow
async def test_a_leader_that_starts_again_is_not_followed_by_itself(two: TwoRobots) -> None:
    await two.follow(gap=2.0)
    driving = asyncio.create_task(two.robots[0].drive(0.6, 0.0, seconds=20.0))
    await asyncio.sleep(4.0)
    two.network.disconnect("101.1.102")
    await two.until(lambda: two.speeds[1] == 0.0, 2.0)
    await two.until(lambda: not two.driver.is_following, 4.0)
    assert "no pose of its leader" in two.driver.ended_by
    stopped = two.poses[1].x
    two.network.reconnect("101.1.102")
    await asyncio.sleep(8.0)
    assert two.poses[1].x == pytest.approx(stopped, abs=0.02)
    driving.cancel()
    await two.follow(gap=2.0)
    await two.until(lambda: two.speeds[1] > 0.2, 5.0)
