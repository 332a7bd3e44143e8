"""Commands that no operator has sealed, with forged ids, recorded or changed: the robot obeys its operator only."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack

import pytest
from tests.helpers.robot import FakeDrive

from jauspy.codec.message import Message
from jauspy.component import Component
from jauspy.component.component import loop_time
from jauspy.ids import JausID
from jauspy.messages.core import ClearEmergency, ReleaseControl, RequestControl, Resume, SetEmergency, Shutdown, Standby
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.messages.operators import SealedCommand
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.judp import unpack_all
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.services.core import AccessControl, CommandSeal, Discovery
from jauspy.services.mobility import PrimitiveDriver, Vehicle
from jauspy.testing import VirtualNetwork

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

ROBOT, ALICE, MALLORY = JausID(101, 1, 1), JausID(42, 1, 1), JausID(66, 1, 1)
STILL = (0.0, 0.0)
FORWARD = SetWrenchEffort(propulsive_linear_effort_x=100.0)


class Scene:
    """A robot that alice drives, and somebody who hears all datagrams and sends any bytes."""

    def __init__(self, network: VirtualNetwork, stack: AsyncExitStack, key: OperatorKey) -> None:
        self.network, self._stack, self._key = network, stack, key
        self.heard: list[bytes] = []
        self._delays = network.delays
        network.delays = self._listen
        self._line = network.transport(MALLORY)
        self._sequence = 100

    def _listen(self, datagram: bytes) -> list[float]:
        self.heard.append(datagram)
        return self._delays(datagram)

    async def robot(self, secret: bytes) -> tuple[Component, FakeDrive]:
        drive = FakeDrive(clock=loop_time)
        seal = CommandSeal([Operator("alice", "operator", 127, self._key.public)], secret=secret)
        services = [AccessControl(), Discovery(), PrimitiveDriver(Vehicle(drive)), seal]
        return await self._stack.enter_async_context(self.network.component(ROBOT, services)), drive

    async def forge(self, source: JausID, *messages: Message | bytes) -> None:
        """Send what claims to be of `source`."""
        for each in messages:
            self._sequence += 1
            endpoint = Endpoint(source, first_sequence=self._sequence)
            endpoint.send(ROBOT, each if isinstance(each, bytes) else each.encode(), now=0.0)
            for datagram in endpoint.poll_output():
                self._line.send(datagram)
        await asyncio.sleep(0.2)

    def sealed(self) -> list[bytes]:
        """The sealed commands that were heard."""
        payloads = (packet.payload for each in self.heard for packet in unpack_all(each)[0])
        return [each for each in payloads if each[:2] == SealedCommand.CODE.to_bytes(2, "little")]


@pytest.fixture
async def scene(virtual_network: VirtualNetwork) -> AsyncIterator[Scene]:
    async with AsyncExitStack() as stack:
        found = Scene(virtual_network, stack, OperatorKey.generate())
        await found._line.open()
        stack.push_async_callback(found._line.close)
        yield found


@pytest.fixture
def key_file(scene, tmp_path):
    path = tmp_path / "alice.key"
    path.write_bytes(scene._key.pem())
    path.chmod(0o600)
    return path


async def test_nobody_else_commands_the_robot(scene, key_file):
    robot, drive = await scene.robot(b"1" * 32)
    everything = [RequestControl(255), Resume(), FORWARD, ClearEmergency(1), ReleaseControl(), Shutdown()]
    await scene.forge(MALLORY, *everything)
    assert (robot.controller, drive.effort) == (None, STILL)

    async with scene.network.ocu(ALICE, operator=key_file) as ocu:
        driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
        async with driver.control():
            await driver.resume(1.0)
            await scene.forge(ALICE, *everything[1:])
            await scene.forge(MALLORY, *everything)
            assert (robot.controller, drive.effort) == (ALICE, STILL)
            await driver.send(FORWARD)
            await asyncio.sleep(0.1)
            assert drive.effort != STILL

            heard = scene.sealed()
            assert len(heard) >= 3
            await scene.forge(ALICE, *heard)
            await scene.forge(MALLORY, *heard)
            await scene.forge(ALICE, *(each.replace(FORWARD.encode(), Resume().encode()) for each in heard))
            await scene.forge(ALICE, Standby())
            await asyncio.sleep(0.5)
            assert drive.effort == STILL  # whoever can send may stop it, and nothing of the above started it again
        heard = scene.sealed()
    await scene.forge(ALICE, *heard)
    assert (robot.controller, drive.effort) == (None, STILL)
    assert robot.counters["host.refused.replayed"] >= len(heard)


async def test_what_was_recorded_is_worth_nothing_after_a_restart(scene, key_file):
    first, _ = await scene.robot(b"1" * 32)
    async with scene.network.ocu(ALICE, operator=key_file) as ocu:
        driver = (await ocu.discover(101)).component(ROBOT).service("PrimitiveDriver")
        async with driver.control():
            await driver.resume(1.0)
            await driver.send(FORWARD)
    await first.close()
    second, drive = await scene.robot(b"2" * 32)
    await scene.forge(ALICE, *scene.sealed())
    assert (second.controller, drive.effort) == (None, STILL)
    assert second.counters["host.refused.unknown_challenge"] >= 3


async def test_emergencies_of_anybody_hold_up_the_robot_only_as_long_as_they_are_sent(scene, key_file):
    robot, _ = await scene.robot(b"1" * 32)
    for number in range(1, 100):
        await scene.forge(JausID(66, 1, number), SetEmergency(1))
    async with scene.network.ocu(ALICE, operator=key_file) as ocu:
        assert "Emergency" in robot.state
        await ocu.send(ROBOT, ClearEmergency(1))
        await asyncio.sleep(0.1)
        assert "Emergency" not in robot.state
