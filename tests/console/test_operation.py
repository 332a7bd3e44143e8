"""Operating a robot from a browser: control, hand-over, and the dead-man's switch."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Iterable
from contextlib import asynccontextmanager
from dataclasses import dataclass

import pytest

from jauspy.console.dead_man import DEAD_MAN_TIME
from jauspy.console.fleet import Fleet
from jauspy.console.killed_console import Watchdog
from jauspy.console.operation import REQUEST_TIME, Operation, modes_of
from jauspy.console.users import User
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryControl
from jauspy.ocu import OCU
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork

STOP_TIME = 0.3
"""Seconds in which a robot stands after the last message of its operator's browser."""


@dataclass
class Desk:
    runner: RobotRunner
    operation: Operation
    events: list[str]
    ocu: OCU

    @property
    def speed(self) -> float:
        assert self.runner.snapshot is not None
        return self.runner.snapshot.twist.vx

    async def drive(self, seconds: float, forward: float = 1.0, token: str = "first") -> str:
        problem = ""
        for _ in range(round(seconds / 0.05)):
            problem = self.operation.drive(token, forward, 0.0)
            await asyncio.sleep(0.05)
        return problem


@asynccontextmanager
async def desk(network: VirtualNetwork) -> AsyncIterator[Desk]:
    async with network.robot() as runner, network.ocu() as ocu:
        events: list[str] = []
        operation = Operation(await ocu.discover(101), events.append)
        try:
            yield Desk(runner, operation, events, ocu)
        finally:
            await operation.release()


@pytest.mark.slow
async def test_a_browser_takes_control_and_drives(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at:
        assert at.operation.drive("first", 1.0, 0.0) == "take control first"
        assert await at.operation.take("first", 127) == ""
        assert at.operation.is_controlled
        assert await at.drive(2.0) == ""
        assert at.speed > 0.4
        assert at.operation.drive("second", 1.0, 0.0) == "another browser operates this robot"


@pytest.mark.slow
async def test_the_watchdog_knows_what_is_controlled(virtual_network: VirtualNetwork) -> None:
    told: list[tuple[int, int]] = []

    class Recorder(Watchdog):
        def hold(self, robot: int, components: Iterable[JausID]) -> None:
            told.append((robot, len(tuple(components))))

    async with virtual_network.robot(), virtual_network.ocu() as ocu:
        operation = Operation(await ocu.discover(101), lambda _: None, Recorder("42.1.1", None))
        await operation.take("first", 127)
        assert told == [(101, 5)]
        await operation.release()
        assert told == [(101, 5), (101, 0)]


@pytest.mark.slow
async def test_the_robot_stops_when_the_browser_is_silent(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at:
        await at.operation.take("first", 127)
        await at.drive(2.0)
        await asyncio.sleep(STOP_TIME - 0.05)  # the last message was 0.05 s ago
        assert abs(at.speed) < 0.02
        assert at.events[-1] == "robot 101 was stopped: its operator's browser is silent"
        assert await at.drive(1.0) == "", "the operator may drive on"
        assert at.speed > 0.2


@pytest.mark.slow
async def test_hand_over_stops_the_robot_first(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at:
        await at.operation.take("first", 127)
        await at.drive(2.0)
        assert await at.operation.take("second", 127) == ""
        await asyncio.sleep(STOP_TIME)
        assert abs(at.speed) < 0.05
        assert at.operation.drive("first", 1.0, 0.0) == "another browser operates this robot"
        assert await at.drive(1.0, token="second") == ""
        assert at.speed > 0.2


ANNA, BEN, CARA, DAN = (
    User("anna", "operator", 127),
    User("ben", "operator", 127),
    User("cara", "supervisor", 255),
    User("dan", "observer", 0),
)


@pytest.mark.slow
async def test_another_user_asks_and_the_operator_decides(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at:
        operation = at.operation
        await operation.take("a", 127, ANNA)
        assert "ask for it, or take it over" in await operation.take("b", 127, BEN)
        operation.ask("b", 255, BEN)
        assert operation.request is not None
        assert (operation.request.user, operation.request.authority) == (BEN, 127)
        assert await operation.answer("b", grant=True) == "", "only the operator may answer"
        assert operation.operator == "a"
        await operation.answer("a", grant=False)
        assert (operation.operator, operation.request) == ("a", None)
        operation.ask("b", 127, BEN)
        await asyncio.sleep(REQUEST_TIME + 1.0)
        assert operation.request is None, "nobody has answered"
        operation.ask("b", 127, BEN)
        await operation.answer("a", grant=True)
        assert (operation.operator, operation.user) == ("b", BEN)
        assert at.events[-1] == "ben operates robot 101 with authority 127"


@pytest.mark.slow
async def test_a_higher_authority_takes_over_and_observers_do_not(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at:
        operation = at.operation
        assert await operation.take("d", 0, DAN) == "dan may only observe (observer)"
        operation.ask("d", 0, DAN)
        assert operation.request is None
        assert await operation.take("a", 200, ANNA) == "anna has an authority of at most 127 (operator)"
        await operation.take("a", 127, ANNA)
        assert await operation.take("c", 200, CARA) == ""
        assert (operation.operator, operation.authority) == ("c", 200)
        assert operation.is_controlled
        component = next(each for each in operation.robot.components if each.find("PrimitiveDriver"))
        report = await at.ocu.query(component.id, QueryControl())
        assert report.authority_code == 200, "control is requested anew with the other authority"


@pytest.mark.slow
async def test_control_that_was_lost_is_taken_again(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at, virtual_network.ocu("42.1.9") as other:
        await at.operation.take("first", 127)
        async with (await other.discover(101)).control(authority=200):
            await asyncio.sleep(1.0)
            assert not at.operation.is_controlled
        assert await at.operation.take("first", 127) == ""
        assert at.operation.is_controlled


@pytest.mark.slow
async def test_refused_control_says_why(virtual_network: VirtualNetwork) -> None:
    async with (
        desk(virtual_network) as at,
        virtual_network.ocu("42.1.9") as other,
        (await other.discover(101)).control(authority=200),
    ):
        problem = await at.operation.take("first", 127)
        assert "held by 42.1.9 with authority 200" in problem
        assert at.operation.problem_for("first") == problem
        assert at.operation.problem_for("second") == ""
        assert not at.operation.is_controlled


@pytest.mark.slow
async def test_the_fleet_follows_robots_and_their_states(virtual_network: VirtualNetwork) -> None:
    events: list[str] = []
    async with virtual_network.ocu() as ocu:
        fleet = Fleet(ocu)
        fleet.on_event = events.append
        fleet.start()
        try:
            async with virtual_network.robot(), virtual_network.ocu("42.1.9") as other:
                async with asyncio.timeout(20.0):
                    while 101 not in fleet.robots:
                        await asyncio.sleep(0.1)
                async with (await other.discover(101)).control("drive"):
                    await asyncio.sleep(2.0)
                    (id,) = (each.id for each in fleet.robots[101].components if each.find("PrimitiveDriver"))
                    assert (fleet.states[id].status, fleet.states[id].controller) == ("READY", "42.1.9")
                    assert not fleet.is_silent(id)
            async with asyncio.timeout(30.0):
                while fleet.robots:
                    await asyncio.sleep(0.1)
        finally:
            await fleet.close()
    assert events[0] == "robot 101 inc1 has appeared"
    assert "101.1.102 is controlled by 42.1.9, was by nobody" in events
    assert events[-1] == "robot 101 inc1 does not answer any more"


@pytest.mark.slow
async def test_a_robot_is_driven_by_effort_where_it_offers_that(virtual_network: VirtualNetwork) -> None:
    async with desk(virtual_network) as at:
        assert modes_of(at.operation.robot) == ["velocity", "effort"]
        assert at.operation.set_mode("first", "effort") == "take control first"
        await at.operation.take("first", 127)
        await at.drive(0.5)
        assert at.operation.set_mode("first", "somehow") == "this robot does not offer the mode somehow"
        assert at.operation.set_mode("first", "effort") == ""
        names = Counter[str]()

        def count(_source: JausID, _destination: JausID, payload: bytes, *, sent: bool) -> None:
            names[registry.decode(payload).NAME] += sent

        at.ocu.trace(count)
        at.operation.speed_limit = 0.4
        await at.drive(2.0)
        assert at.operation.commanded == (0.4, 0.0)
        assert names["SetWrenchEffort"] > 30
        assert names["SetVelocityCommand"] <= 1, "the velocity before is not repeated beside the effort"
        assert at.speed > 0.3
        await asyncio.sleep(DEAD_MAN_TIME + STOP_TIME)
        assert abs(at.speed) < 0.05
        at.ocu.trace(None)
