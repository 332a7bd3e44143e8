"""A robot in memory: real services on a drive that integrates what it is told, on virtual time."""

# ruff: noqa: ASYNC109 - timeouts here configure what is tested

from __future__ import annotations

from collections.abc import AsyncIterator, Iterable
from contextlib import AsyncExitStack
from typing import Any

import pytest
from tests.helpers.robot import FakeDrive

from jauspy.codec.message import Message
from jauspy.component import Component
from jauspy.component.component import loop_time
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.protocol.judp import unpack_all
from jauspy.services.core import AccessControl, Discovery, Events, Identity, Liveness
from jauspy.services.mobility import LocalPoseSensor, PrimitiveDriver, Vehicle, VelocityStateSensor
from jauspy.services.service import Service
from jauspy.testing import VirtualNetwork

ROBOT = JausID(101, 1, 1)
DRIVER = JausID(101, 1, 102)


class World:
    """Starts robots, components and OCUs on one network, and ends them."""

    def __init__(self, network: VirtualNetwork, stack: AsyncExitStack) -> None:
        self.network = network
        self.transport = network.transport
        self.drives: list[FakeDrive] = []
        self._stack = stack

    async def component(self, id: JausID, services: Iterable[Service], **definitions: Any) -> Component:
        return await self._stack.enter_async_context(self.network.component(id, services, core=False, **definitions))

    async def robot(self, id: JausID = ROBOT, *, drive: FakeDrive | None = None, timeout: int = 5) -> Component:
        """One component with everything, subsystem 101 unless told otherwise."""
        drive = drive or FakeDrive(clock=loop_time)
        self.drives.append(drive)
        names = {2: Identity("test robot", 10001), 3: Identity("test node", 40001), 4: Identity("all in one", 60001)}
        vehicle = Vehicle(drive)
        return await self.component(
            id,
            [
                AccessControl(timeout=timeout),
                Events(timeout=1),
                Discovery(names),
                Liveness(),
                PrimitiveDriver(vehicle),
                LocalPoseSensor(vehicle),
                VelocityStateSensor(vehicle),
            ],
        )

    async def ocu(self, id: str = "42.1.1", *, timeout: float = 0.1, retries: int = 3, **options: Any) -> OCU:
        return await self._stack.enter_async_context(self.network.ocu(id, timeout=timeout, retries=retries, **options))


def hold_back(network: VirtualNetwork, kind: type[Message], seconds: float) -> None:
    """From now on packets with this message arrive so much later, and others overtake them."""
    delays = network.delays

    def held(datagram: bytes) -> list[float]:
        late = any(each.payload[:2] == kind.CODE.to_bytes(2, "little") for each in unpack_all(datagram)[0])
        return [each + seconds * late for each in delays(datagram)]

    network.delays = held


@pytest.fixture
async def world(virtual_network: VirtualNetwork) -> AsyncIterator[World]:
    async with AsyncExitStack() as stack:
        yield World(virtual_network, stack)
