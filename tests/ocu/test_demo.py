from __future__ import annotations

import asyncio
import math

import pytest

from jauspy.errors import ControlRejected, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import ReportStatus
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu import demo
from jauspy.ocu.demo import Observer


class Notes(Observer):
    def __init__(self) -> None:
        self.steps: list[str] = []
        self.robots: list[int] = []
        self.left: dict[str, list[float]] = {"m": [], "rad": []}

    def step(self, text: str) -> None:
        self.steps.append(text)

    def discovered(self, robot) -> None:
        self.robots.append(robot.id)

    def moved(self, motion, left: float, unit: str) -> None:
        self.left[unit].append(left)


async def test_the_scripted_drive(world):
    robot = await world.robot()
    world.drives[0].speed = 1.5
    notes = Notes()

    result = await demo.run(await world.ocu(), observer=notes)

    assert abs(result.distance_error) < 0.05
    assert abs(result.angle_error) < math.radians(3)
    assert result.end.x == pytest.approx(2.0, abs=0.06)
    assert result.end.yaw == pytest.approx(math.pi / 2, abs=0.06)  # JAUS: to the right
    assert world.drives[0].pose().yaw < 0  # the platform's yaw grows to the left
    assert (result.lost_reports, result.confirmed_rate) == (0, pytest.approx(10, abs=0.02))
    assert result.stats.answers > 5
    assert notes.robots == [101]
    assert [text.split()[0] for text in notes.steps] == [
        "Discover", "Take", "Resume", "Subscribe", "Drive", "Turn", "Standby", "Release", "Done",
    ]  # fmt: skip
    assert notes.left["m"][0] == pytest.approx(2, abs=0.01)
    assert (robot.host.controller, robot.host.status) == (None, ReportStatus.Status.STANDBY)


async def test_a_robot_that_does_not_move_is_given_up_and_left_in_standby(world):
    robot = await world.robot()
    world.drives[0].speed = 0.0
    with pytest.raises(
        RequestError, match=r"2 m forward took longer than 0\.5 s, with 2\.00 to go .* see whether something"
    ):
        await demo.run(await world.ocu(), leg_time=0.5)
    assert (robot.host.controller, robot.host.status) == (None, ReportStatus.Status.STANDBY)


async def test_preemption_ends_it_at_the_next_report(world):
    await world.robot()
    ocu, other = await world.ocu(), await world.ocu("43.1.1")
    running = asyncio.create_task(demo.run(ocu, authority=100))
    async with asyncio.timeout(3):
        while not world.network.sent(SetWrenchEffort):
            await asyncio.sleep(0.01)

    async with (await other.discover(101)).service("PrimitiveDriver").control(authority=200):
        with pytest.raises(ControlRejected, match="was lost"):
            await running
        assert world.drives[0].effort == (0.0, 0.0)


async def test_reports_that_stay_out_end_it(world):
    robot = await world.robot()
    ocu = await world.ocu()
    running = asyncio.create_task(demo.run(ocu))
    async with asyncio.timeout(3):
        while not world.network.sent(SetWrenchEffort):
            await asyncio.sleep(0.01)
    world.network.keeps = lambda packet: packet.source != robot.id

    with pytest.raises(ResponseTimeout, match="no event with a report on QueryLocalPose"):
        await running


async def test_somebody_elses_robot_is_not_taken(world):
    await world.robot()
    ocu, other = await world.ocu(), await world.ocu("43.1.1")
    async with (await other.discover(101)).service("PrimitiveDriver").control(authority=220):
        with pytest.raises(ControlRejected, match=r"held by 43\.1\.1 with authority 220; you asked with 200"):
            await demo.run(ocu)
    assert JausID(42, 1, 1) not in {each.source for each in world.network.sent(SetWrenchEffort)}
