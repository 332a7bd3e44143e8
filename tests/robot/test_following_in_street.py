"""A second inc1 follows the first through the simulated street, and stops; judged by MuJoCo's poses and contacts."""

from __future__ import annotations

import asyncio
import logging
import math
from collections.abc import Callable

import pytest

pytest.importorskip("mujoco")

from tests.helpers.two_robots import TwoRobots, two_robots

from jauspy.geometry.poses import Pose
from jauspy.messages.core import Event, SetEmergency
from jauspy.testing import VirtualNetwork

pytestmark = pytest.mark.slow

_LOG = logging.getLogger(__name__)
"""What was measured: `pytest --log-level=INFO`."""

GAP = 2.0
ROUTE = ((1.0, 0.0), (1.0, -5.0), (-3.5, -5.0), (-3.5, 4.0))
"""On the road, around three right angles: to the kerb, along it, across, and back along the other side."""
STEP = 0.05


class Judge:
    """Measures by the physics alone: the way of the leader, the gap along it, and contacts."""

    def __init__(self, two: TwoRobots) -> None:
        self._two = two
        self._trail: list[tuple[float, float, float]] = []
        self._place = 0
        self.gaps: list[float] = []
        self.aside: list[float] = []
        self.touched: set[str] = set()
        (x, y), (ahead, beside) = self._position(1), self._position(0)
        for share in range(101):  # the path begins at the follower, straight to the leader
            self._extend(x + share / 100 * (ahead - x), y + share / 100 * (beside - y))

    def _position(self, robot: int) -> tuple[float, float]:
        pose = self._two.backends[robot].robot.drive.pose()
        return pose.x, pose.y

    def _extend(self, x: float, y: float) -> None:
        if not self._trail:
            self._trail.append((x, y, 0.0))
            return
        a, b, along = self._trail[-1]
        if (far := math.hypot(x - a, y - b)) > 0.02:
            self._trail.append((x, y, along + far))

    def look(self) -> None:
        self._extend(*self._position(0))
        x, y = self._position(1)
        ahead = self._trail[self._place : self._place + 60]
        distances = [math.hypot(x - a, y - b) for a, b, _ in ahead]
        self._place += distances.index(min(distances))
        self.aside.append(min(distances))
        self.gaps.append(self._trail[-1][2] - self._trail[self._place][2])
        self._touch()

    def _touch(self) -> None:
        """What the robots touch besides the ground, and themselves."""
        robot = self._two.backends[0].robot
        model = robot.model
        for contact in robot.data.contact:
            names = sorted(str(model.body(model.geom_bodyid[geom]).name) for geom in (contact.geom1, contact.geom2))
            owners = {name.partition("/")[0] for name in names}
            if (contact.dist <= 0.0 and owners == {"inc1", "inc1_2"}) or (
                contact.dist <= 0.0 and "world" not in names and owners & {"inc1", "inc1_2"} and len(owners) > 1
            ):
                self.touched.add(" ".join(names))

    async def until(self, condition: Callable[[], bool], seconds: float) -> None:
        for _ in range(round(seconds / STEP)):
            if condition():
                return
            await asyncio.sleep(STEP)
            self.look()
        assert condition(), f"not within {seconds} s"


async def test_follows_through_the_street_at_the_gap_without_contact(virtual_network: VirtualNetwork) -> None:
    async with two_robots(virtual_network, "sim") as two:
        judge = Judge(two)
        await two.follow(gap=GAP)

        async def drive() -> None:
            for x, y in ROUTE:
                await two.robots[0].go_to(x, y, speed=0.6, tolerance=0.3)

        driving = asyncio.create_task(drive())
        await judge.until(driving.done, 90.0)
        await driving
        errors = [abs(gap - GAP) for gap in judge.gaps[round(4.0 / STEP) :]]  # after it has closed up
        mean, most = sum(errors) / len(errors), max(errors)
        _LOG.info("gap error: mean %.3f m, max %.3f m; beside the way: max %.3f m", mean, most, max(judge.aside))
        assert mean < 0.12
        assert most < 0.45
        assert max(judge.aside) < 0.25
        assert not judge.touched
        leader, follower = two.poses
        assert leader.y > 3.5
        assert follower.y > 1.0


async def test_stops_behind_a_leader_that_brakes_at_once(virtual_network: VirtualNetwork) -> None:
    """An emergency stop from 1.4 m/s, with all that its brakes can do."""
    async with two_robots(virtual_network, "sim", "empty") as two:
        judge = Judge(two)
        await two.follow(gap=GAP)
        driving = asyncio.create_task(two.robots[0].drive(1.4, 0.0, seconds=20.0))
        await judge.until(lambda: min(two.speeds) > 1.3, 12.0)
        await two.tell_leader(SetEmergency(SetEmergency.EmergencyCode.STOP))
        await judge.until(lambda: max(map(abs, two.speeds)) < 0.01, 4.0)
        driving.cancel()
        _LOG.info("least gap after an emergency stop from 1.4 m/s: %.2f m", min(judge.gaps))
        assert not judge.touched
        assert min(judge.gaps) > two.driver.course.contact


async def test_stops_when_the_link_to_the_leader_is_cut(virtual_network: VirtualNetwork) -> None:
    async with two_robots(virtual_network, "sim") as two:
        judge = Judge(two)
        await two.follow(gap=GAP)
        driving = asyncio.create_task(two.robots[0].go_to(1.0, -7.0, speed=0.6, tolerance=0.3))
        await judge.until(lambda: two.speeds[1] > 0.4, 15.0)
        two.network.lose(Event)
        cut = two.poses[1]
        await judge.until(lambda: abs(two.speeds[1]) < 0.01, 2.0)
        await judge.until(driving.done, 30.0)
        await driving
        further = math.hypot(two.poses[1].x - cut.x, two.poses[1].y - cut.y)
        _LOG.info("stopped %.2f m after the link was cut", further)
        assert further < 0.8
        assert not two.driver.is_following
        assert not judge.touched


async def test_stands_beside_a_leader_that_comes_back(virtual_network: VirtualNetwork) -> None:
    """The leader turns and passes close by: the follower waits, though its place is far ahead on the path."""
    async with two_robots(virtual_network, "sim", "empty", start=Pose(x=-2.3)) as two:
        judge = Judge(two)
        await two.follow(gap=GAP)

        async def drive() -> None:
            for x, y in ((4.0, 0.0), (4.0, 1.2), (-4.0, 1.2)):
                await two.robots[0].go_to(x, y, speed=0.6, tolerance=0.2)

        driving = asyncio.create_task(drive())
        await judge.until(driving.done, 60.0)
        await driving
        assert not judge.touched
