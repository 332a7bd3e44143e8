"""A robot in memory: real services on a drive that integrates what it is told, and a network that may lose packets."""

# ruff: noqa: ASYNC109 - timeouts here configure what is tested

from __future__ import annotations

import asyncio
import gc
import math
import time
from collections.abc import AsyncIterator, Callable, Iterable
from contextlib import AsyncExitStack
from dataclasses import dataclass, field
from datetime import UTC, datetime
from itertools import count

import pytest

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.component import Shell
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.platform.contract import Pose, Twist
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import unpack_all
from jauspy.schema import Schema
from jauspy.services.core import AccessControl, Discovery, Events, Identity, Liveness
from jauspy.services.host import Host
from jauspy.services.mobility import LocalPoseSensor, PrimitiveDriver, Vehicle, VelocityStateSensor
from jauspy.services.service import Service
from jauspy.transport import LoopbackHub, LoopbackTransport

ROBOT = JausID(101, 1, 1)
DRIVER = JausID(101, 1, 102)


@dataclass
class FakeDrive:
    """A skid steer without mass; `speed` is how much faster than life it is."""

    speed: float = 1.0
    efforts: list[tuple[float, float]] = field(default_factory=list)
    _x: float = 0.0
    _y: float = 0.0
    _yaw: float = 0.0
    _at: float = field(default_factory=time.monotonic)

    @property
    def effort(self) -> tuple[float, float]:
        return self.efforts[-1] if self.efforts else (0.0, 0.0)

    def set_effort(self, linear_x: float, rotational_z: float) -> None:
        self._advance()
        self.efforts.append((linear_x, rotational_z))

    def stop(self) -> None:
        self.set_effort(0.0, 0.0)

    def pose(self) -> Pose:
        self._advance()
        return Pose(x=self._x, y=self._y, yaw=math.remainder(self._yaw, math.tau))

    def twist(self) -> Twist:
        return Twist(vx=self.effort[0] * self.speed, wz=self.effort[1] * self.speed)

    def _advance(self) -> None:
        now = time.monotonic()
        left, self._at = now - self._at, now
        while left > 0:
            dt = min(left, 0.002)
            left -= dt
            twist = self.twist()
            self._yaw += twist.wz * dt
            self._x += math.cos(self._yaw) * twist.vx * dt
            self._y += math.sin(self._yaw) * twist.vx * dt


class Network(LoopbackHub):
    """Passes on what `keeps` likes; loses the rest. `log` has every packet that was sent."""

    def __init__(self) -> None:
        super().__init__()
        self.log: list[Packet] = []
        self.keeps: Callable[[Packet], bool] = lambda _: True

    def route(self, datagram: bytes, sender: LoopbackTransport) -> None:
        packets, _ = unpack_all(datagram)
        self.log += packets
        if all(map(self.keeps, packets)):
            super().route(datagram, sender)

    def sent(self, kind: type[Message], source: JausID | None = None) -> list[Packet]:
        code = kind.CODE.to_bytes(2, "little")
        return [each for each in self.log if each.payload[:2] == code and source in (None, each.source)]

    def lose(self, kind: type[Message], times: int = 1 << 30, *, after: int = 0) -> None:
        """Lose packets with this message: all but the first `after`, and no more than `times`."""
        code, number = kind.CODE.to_bytes(2, "little"), count()
        self.keeps = lambda each: each.payload[:2] != code or not after <= next(number) < after + times


class World:
    """Starts robots, components and OCUs on one network, and ends them."""

    def __init__(self, stack: AsyncExitStack) -> None:
        self.network = Network()
        self.drives: list[FakeDrive] = []
        self._stack = stack

    def transport(self, id: JausID) -> LoopbackTransport:
        return LoopbackTransport(id, self.network)

    async def component(
        self, id: JausID, services: Iterable[Service], schema: Schema | None = None, registry: Registry | None = None
    ) -> Shell:
        host = Host(
            id, services, utc_now=lambda: datetime.now(UTC), now=time.monotonic(), schema=schema, registry=registry
        )
        return await self._stack.enter_async_context(Shell(host, self.transport(id)))

    async def robot(self, id: JausID = ROBOT, *, drive: FakeDrive | None = None, timeout: int = 5) -> Shell:
        """One component with everything, subsystem 101 unless told otherwise."""
        drive = drive or FakeDrive()
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

    async def ocu(
        self, id: str = "42.1.1", *, timeout: float = 0.1, retries: int = 3, registry: Registry | None = None
    ) -> OCU:
        transport = self.transport(JausID.parse(id))
        ocu = OCU(id, transport=transport, timeout=timeout, retries=retries, registry=registry)
        return await self._stack.enter_async_context(ocu)


@pytest.fixture
async def world() -> AsyncIterator[World]:
    before = asyncio.all_tasks()
    complaints: list[dict[str, object]] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: complaints.append(context))
    async with AsyncExitStack() as stack:
        yield World(stack)
    for _ in range(3):
        await asyncio.sleep(0)
    gc.collect()
    leaked = asyncio.all_tasks() - before - {asyncio.current_task()}
    assert not leaked
    assert not complaints
