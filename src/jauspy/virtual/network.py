"""A network in memory with loss, delay, duplication and reordering, repeatable, on virtual time."""

from __future__ import annotations

import asyncio
import random
from collections import deque
from collections.abc import Callable, Iterable
from datetime import datetime
from itertools import count
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Self

from jauspy.codec.message import Message
from jauspy.component import Component
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.protocol.header import Packet
from jauspy.protocol.judp import unpack_all
from jauspy.services.service import Service
from jauspy.transport import LoopbackHub, LoopbackTransport
from jauspy.virtual.clock import VirtualClock
from jauspy.virtual.environment import Environment, VirtualTime

if TYPE_CHECKING:
    from jauspy.robot.runner import RobotRunner

REORDERING_DELAY: Final = 0.01
"""Seconds by which a datagram is delayed so that others overtake it."""
MAX_LOG: Final = 100_000
"""Packets that `log` remembers: the latest."""


class VirtualNetwork(Environment):
    """`async with VirtualNetwork(loss=0.2, delay=0.05) as network: ...`; everything inside uses virtual time.

    `loss`, `duplication` and `reordering` are fractions of the datagrams (0..1), `delay` and `jitter` seconds; jitter
    is added at random, up to its full value. All may be changed at any time. `seed` makes it repeatable. `log`
    holds every packet that was sent, lost ones too.
    """

    def __init__(
        self,
        *,
        loss: float = 0.0,
        duplication: float = 0.0,
        reordering: float = 0.0,
        delay: float = 0.0,
        jitter: float = 0.0,
        seed: int = 1,
    ) -> None:
        self.loss, self.duplication, self.reordering = loss, duplication, reordering
        self.delay, self.jitter = delay, jitter
        self.clock = VirtualClock()
        self.log: deque[Packet] = deque(maxlen=MAX_LOG)
        self.keeps: Callable[[Packet], bool] = lambda _: True
        """Packets for which it returns false are lost, in addition to random loss."""
        self.allow_errors = False
        """True to let a test with the fixture `virtual_network` pass although a service raised an exception."""
        self._components: list[Component] = []
        self._disconnected: set[JausID] = set()
        self._random = random.Random(seed)  # noqa: S311 - repeatable, not secret
        self._hub = _Hub(self)

    def transport(self, id: str | JausID) -> LoopbackTransport:
        """A transport for the component of this id."""
        return LoopbackTransport(JausID.of(id), self._hub)

    def component(self, id: str | JausID, services: Iterable[Service], **options: Any) -> Component:
        """A component of these services; `options` are those of `Component`."""
        made = super().component(id, services, **options)
        self._components.append(made)
        return made

    def check_services(self) -> None:
        """Raise `AssertionError`, from the exception, if a service of a component raised one; see `allow_errors`."""
        for component in () if self.allow_errors else self._components:
            if component.host.first_error is not None:
                name, error = component.host.first_error
                raise AssertionError(f"{name} of {component.id} raised {type(error).__name__}: {error}") from error

    def robot(self, name: str = "inc1") -> RobotRunner:
        """A whole robot of this name on the `kinematic` backend, to be used with `async with`; on virtual time, too."""
        from jauspy.robot import robot_files  # noqa: PLC0415 - needs the extra `robot`
        from jauspy.robot.runner import RobotRunner  # noqa: PLC0415

        return RobotRunner(
            robot_files.load(name), self.transport, backend="kinematic", realtime=VirtualTime, utc_now=self.utc_now
        )

    def now(self) -> float:
        """Seconds of the event loop's clock."""
        return asyncio.get_running_loop().time()

    def utc_now(self) -> datetime:
        """The wall clock, which starts at midnight of 1 January 2026."""
        return self.clock.utc_now()

    async def __aenter__(self) -> Self:
        self.clock.__enter__()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.clock.__exit__(kind, error, trace)

    # --- disturbances ---------------------------------------------------------------------------------------------

    def lose(self, kind: type[Message], times: int | None = None, *, after: int = 0) -> None:
        """Lose packets with this message from now on: all but the first `after`, and no more than `times`."""
        code, number = _code(kind), count()
        end = None if times is None else after + times

        def keeps(packet: Packet) -> bool:
            if packet.payload[:2] != code:
                return True
            position = next(number)
            return position < after or (end is not None and position >= end)

        self.keeps = keeps

    def disconnect(self, id: str | JausID) -> None:
        """Lose all that this component sends and all that is sent to it, as if its cable were unplugged."""
        self._disconnected.add(JausID.of(id))

    def reconnect(self, id: str | JausID) -> None:
        """Undo `disconnect`."""
        self._disconnected.discard(JausID.of(id))

    def stall(self, id: str | JausID, seconds: float) -> None:
        """Keep the component from reading for this time, as if its process were stopped; it reads afterwards what came.

        Its timers run on. Raises `ConfigError` if no component here has this id.
        """
        member = self._hub.members.get(int(JausID.of(id)))
        if member is None:
            raise ConfigError(f"no component on this network has the id {id}")
        member.stall(seconds)

    # --- traffic --------------------------------------------------------------------------------------------------

    def sent(self, kind: type[Message], source: str | JausID | None = None) -> list[Packet]:
        """The packets with this message, from `source` or any component, that were sent so far."""
        code, wanted = _code(kind), None if source is None else JausID.of(source)
        return [packet for packet in self.log if packet.payload[:2] == code and wanted in (None, packet.source)]

    def delays(self, datagram: bytes) -> list[float]:
        """The delays after which this datagram arrives, one for each copy; logs it."""
        packets, _ = unpack_all(datagram)
        self.log += packets
        if any(packet.source in self._disconnected or packet.destination in self._disconnected for packet in packets):
            return []
        if not all(map(self.keeps, packets)) or self._happens(self.loss):
            return []
        return [self._delay() for _ in range(1 + self._happens(self.duplication))]

    def _delay(self) -> float:
        reordering = REORDERING_DELAY if self._happens(self.reordering) else 0.0
        return self.delay + reordering + (self._random.uniform(0.0, self.jitter) if self.jitter else 0.0)

    def _happens(self, fraction: float) -> bool:
        return fraction > 0.0 and self._random.random() < fraction


class _Hub(LoopbackHub):
    """Routes each datagram after its delay."""

    def __init__(self, network: VirtualNetwork) -> None:
        super().__init__()
        self._network = network

    def route(self, datagram: bytes, sender: LoopbackTransport) -> None:
        """Deliver copies of a datagram after the delays of the network."""
        for delay in self._network.delays(datagram):
            if delay > 0.0:
                asyncio.get_running_loop().call_later(delay, super().route, datagram, sender)
            else:
                super().route(datagram, sender)


def _code(kind: type[Message]) -> bytes:
    return kind.CODE.to_bytes(2, "little")
