"""Refusals and challenges as if from the robot, sent to the program of an operator: it never sends a plain command."""

import asyncio

import pytest
from tests.helpers.robot import FakeDrive
from tests.ocu.conftest import World, world

from jauspy.component import Component
from jauspy.component.component import loop_time
from jauspy.ids import JausID
from jauspy.messages.core import ReleaseControl, RequestControl, Resume
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.messages.operators import RejectCommand, ReportSealChallenge, SealedCommand
from jauspy.ocu import OCU
from jauspy.ocu.sealing import MIN_ASK_INTERVAL
from jauspy.protocol.header import Packet
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.services.core import AccessControl, CommandSeal, Discovery, Events, Liveness
from jauspy.services.mobility import PrimitiveDriver, Vehicle

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

__all__ = ["world"]

ROBOT = JausID(101, 1, 1)
EFFORT = SetWrenchEffort(propulsive_linear_effort_x=40.0)
PLAIN = (RequestControl, Resume, SetWrenchEffort, ReleaseControl)


class Pair:
    """A robot that takes sealed commands only, and the program of its operator."""

    def __init__(self, world: World, component: Component, ocu: OCU) -> None:
        self.world, self.component, self.ocu = world, component, ocu
        self._number = 0

    def forge(self, message: object) -> None:
        """Deliver a message to the program as if from the robot."""
        self._number += 1
        self.ocu._connection.on_packet(Packet(ROBOT, self.ocu.id, message.encode(), self._number))

    def plain(self) -> list[object]:
        return [each for kind in PLAIN for each in self.world.network.sent(kind)]

    def taken(self) -> int:
        return self.component.counters["host.received"]


@pytest.fixture
async def pair(world: World, tmp_path) -> Pair:
    key = OperatorKey.generate()
    path = tmp_path / "alice.key"
    path.write_bytes(key.pem())
    path.chmod(0o600)
    seal = CommandSeal([Operator("alice", "supervisor", 255, key.public)], secret=bytes(32))
    vehicle = Vehicle(FakeDrive(clock=loop_time))
    services = [AccessControl(), Events(), Discovery(), Liveness(), PrimitiveDriver(vehicle), seal]
    component = await world.component(ROBOT, services)
    return Pair(world, component, await world.ocu(operator=path))


@pytest.mark.parametrize("reason", RejectCommand.Reason)
async def test_refusals_of_any_reason_change_nothing(pair: Pair, reason: RejectCommand.Reason) -> None:
    driver = (await pair.ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control() as control:
        await driver.resume()
        for number in range(50):
            for kind in PLAIN:
                pair.forge(RejectCommand(kind.CODE, number, reason))
            await driver.send(EFFORT)
            await asyncio.sleep(0.05)
        assert control.held
        assert pair.component.controller == pair.ocu.id
    assert len(pair.world.network.sent(SealedCommand)) >= 50
    assert not pair.plain()


async def test_forged_challenges_delay_commands_for_a_moment(pair: Pair) -> None:
    driver = (await pair.ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control():
        await driver.resume()
        await asyncio.sleep(2 * MIN_ASK_INTERVAL)
        pair.forge(RejectCommand(SetWrenchEffort.CODE, 1, RejectCommand.Reason.UNKNOWN_CHALLENGE))
        await asyncio.sleep(0)  # the program asks for another challenge now
        pair.forge(ReportSealChallenge(1, 2))
        for _ in range(20):
            await driver.send(EFFORT)
            await asyncio.sleep(0.05)
        refused = pair.component.counters["host.refused.unknown_challenge"]
        assert 1 <= refused <= 6, "until the next challenge, 0.2 s later"
    assert not pair.plain()


async def test_challenges_that_nobody_asked_for_are_not_used(pair: Pair) -> None:
    driver = (await pair.ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
    async with driver.control():
        await driver.resume()
        for number in range(50):
            pair.forge(ReportSealChallenge(number, number))
            await driver.send(EFFORT)
            await asyncio.sleep(0.02)
    assert not [name for name in pair.component.counters if "refused" in name]
    assert not pair.plain()
