"""One component on one transport: datagrams in, the services' answers out, and one timer for all of their timers."""

from __future__ import annotations

import asyncio
import logging
import random
from collections import Counter
from collections.abc import Callable
from types import TracebackType
from typing import Final, Self

from jauspy.codec.base import Message
from jauspy.component.alarm import Alarm
from jauspy.component.deliveries import Deliveries
from jauspy.component.guard import Guard
from jauspy.component.outlet import Outlet
from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority
from jauspy.services.host import Host
from jauspy.transport.base import Transport

_LOG: Final = logging.getLogger("jauspy.component")

MAX_PER_WAKEUP: Final = 256
"""Packets handled before the event loop gets its turn; the rest, which is bounded, is handled right after that."""
MAX_BACKLOG: Final = 64
"""Datagrams that may wait in the transport when further pieces of a large message are sent."""


def loop_time() -> float:
    """Seconds of the clock that the running event loop lives on: the monotonic one, or a virtual one in tests."""
    return asyncio.get_running_loop().time()


Intercept = Callable[[Packet], bool]
"""Sees every received packet first; what it returns true for does not reach the services."""


class Shell:
    """Runs `host` on `transport`: `async with Shell(host, transport): ...`, or `await shell.run()`.

    `clock` is monotonic, in seconds, the event loop's unless given; `delivery` has the settings of reliable delivery
    and large messages. While the transport has no connection, what is sent is dropped and counted there, and
    everything goes on when it is back. The network, and bugs of services, raise nothing here.
    """

    def __init__(
        self,
        host: Host,
        transport: Transport,
        *,
        clock: Callable[[], float] = loop_time,
        intercept: Intercept | None = None,
        first_sequence: int | None = None,
        delivery: Delivery | None = None,
    ) -> None:
        self.host = host
        self.transport = transport
        host.prompt = self._prompted
        self._clock = clock
        self._intercept = intercept
        start = random.randrange(0x10000) if first_sequence is None else first_sequence  # noqa: S311 - not a secret
        self._endpoint = Endpoint(host.id, first_sequence=start, delivery=delivery)
        self._deliveries = Deliveries(self._endpoint, self._unreachable)
        self._errors: Counter[str] = Counter()
        self._guard = Guard(f"component {host.id}", self._errors)
        self._outlet = Outlet(self._endpoint, transport, self._deliveries, self._errors)
        self._alarm = Alarm(self._timeout, clock)
        self._continuation: asyncio.Handle | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._closed = asyncio.Event()

    @property
    def id(self) -> JausID:
        """The component's id."""
        return self.host.id

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._loop is not None

    @property
    def counters(self) -> dict[str, int]:
        """Everything counted, by floor: `host.…`, `endpoint.…`, `transport.…` and `component.…`."""
        floors = {
            "component": self._errors,
            "host": self.host.counters,
            "endpoint": self._endpoint.counters,
            "transport": self.transport.counters,
        }
        copies = {floor: dict(counts) for floor, counts in floors.items()}  # other threads may look, too
        return {f"{floor}.{name}": value for floor, counts in copies.items() for name, value in counts.items()}

    async def open(self) -> None:
        """Open the transport and start; raises `TransportError` when it cannot be opened. Twice is fine."""
        if self.is_open:
            return
        self.transport.received = self._received
        self._loop = asyncio.get_running_loop()
        self._closed.clear()
        try:
            await self.transport.open()
        except BaseException:
            self._stop()
            await self.transport.close()
            raise
        self._flush()

    async def close(self) -> None:
        """Stop what moves, send what waits and close the transport. Twice is fine."""
        if self.is_open:
            with self._guard:
                self.host.close(self._clock())
            self._flush()
            self._stop()
        await self.transport.close()
        self._closed.set()

    async def run(self) -> None:
        """Open, serve until cancelled or closed, close."""
        async with self:
            await self._closed.wait()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    def send(
        self,
        destination: JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> None:
        """Send a message as this component, now; raises `EncodeError` or, when it is too long, `ProtocolError`.

        With `Ack.REQUIRED` it is resent until acknowledged or given up, which is counted; `deliver` waits for that.
        """
        self._send(destination, message, priority, broadcast, ack)

    async def deliver(self, destination: JausID, message: Message, *, priority: Priority = Priority.STANDARD) -> None:
        """Send, and wait until it was acknowledged; raises `ResponseTimeout` when it was not, after all resends.

        Also raises `ProtocolError` for a wildcard destination, since nobody acknowledges broadcasts.
        """
        if destination.is_wildcard:
            raise ProtocolError("not_acknowledged", f"{destination} is a broadcast, which nobody acknowledges")
        if self._loop is None:
            raise TransportError(f"component {self.id} is not open")
        ticket = self._send(destination, message, priority, Broadcast.NONE, Ack.REQUIRED)
        await self._deliveries.wait(ticket, f"{destination} did not acknowledge {message.NAME}")

    def move(self, id: JausID) -> None:
        """Have another id from now on; events and control end, as they do when a component leaves.

        Raises `TransportError` when the id is taken on this machine; the component then keeps the one it has.
        """
        self.host.ask_for_id(id)
        self._flush_output()
        if (problem := self._move()) is not None:
            raise problem
        self._flush()

    def wake(self) -> None:
        """Call this after acting on the host from outside: sends what it wants to send, sets its timers."""
        self._flush()

    # --- inside ---------------------------------------------------------------------------------------------------

    def _send(
        self, destination: JausID, message: Message, priority: Priority, broadcast: Broadcast, ack: Ack
    ) -> int | None:
        payload, now = message.encode(), self._clock()
        ticket = self._endpoint.send(destination, payload, now=now, priority=priority, broadcast=broadcast, ack=ack)
        self._outlet.transmit()
        if self._loop is not None:
            self._schedule(self._loop)
        return ticket

    def _received(self, datagram: bytes) -> None:
        if self._loop is None:
            return
        with self._guard:
            self._endpoint.receive(datagram, self._clock())
        if self._continuation is None:
            self._handle(self._loop)

    def _continue(self) -> None:
        self._continuation = None
        if self._loop is not None:
            self._handle(self._loop)

    def _handle(self, loop: asyncio.AbstractEventLoop) -> None:
        """Handle what was received; what is too much for one turn of the event loop comes with the next."""
        for _ in range(MAX_PER_WAKEUP):
            packet = self._endpoint.next_event()
            if packet is None:
                break
            self._deliver(packet)
        else:
            self._continuation = loop.call_soon(self._continue)
        self._flush()

    def _deliver(self, packet: Packet) -> None:
        with self._guard:
            if self._intercept is None or not self._intercept(packet):
                self.host.receive(packet.payload, packet.source, self._clock())

    def _flush(self) -> None:
        """Send everything that waits to be sent, and set the timer anew."""
        if self._loop is None:
            return
        with self._guard:
            self._flush_output()
            if self.host.wanted_id is not None and (problem := self._move()) is not None:
                _LOG.error("%s keeps its id: %s", self.id, problem)
        self._schedule(self._loop)

    def _flush_output(self) -> None:
        now = self._clock()
        self._outlet.flush(self.host.poll_output(now), now)

    def _move(self) -> TransportError | None:
        """Take the id that the host wants, after goodbyes under the old one; returns why that is not possible."""
        wanted = self.host.wanted_id
        if wanted is None:
            return None
        try:
            self.transport.move(wanted, self._say_goodbye)
        except TransportError as error:
            self.host.ask_for_id(self.id)
            self._errors["move_failed"] += 1
            return error
        self._endpoint.change_id(wanted)
        self.host.take_id(wanted, self._clock())
        self._flush_output()
        return None

    def _say_goodbye(self) -> None:
        self.host.leave(self._clock())
        self._flush_output()

    def _unreachable(self, client: JausID) -> None:
        """Somebody did not acknowledge: what is done for it ends; what services say to that goes out next turn."""
        self.host.unreachable(client, self._clock())
        if self._loop is not None:
            self._loop.call_soon(self._flush)

    def _schedule(self, loop: asyncio.AbstractEventLoop) -> None:
        """Set the one timer anew; most datagrams change nothing about it."""
        services, delivery = self.host.next_timeout(), self._endpoint.next_timeout()
        at = services if delivery is None or (services is not None and services < delivery) else delivery
        self._alarm.set(loop, at)

    def _prompted(self) -> None:
        if self._loop is not None:
            self._schedule(self._loop)

    def _timeout(self) -> None:
        with self._guard:
            self._endpoint.handle_timeout(self._clock(), room=self.transport.waiting < MAX_BACKLOG)
            self.host.handle_timeout(self._clock())
        self._flush()

    def _stop(self) -> None:
        self._loop = None
        self._deliveries.fail(TransportError(f"component {self.id} was closed before this was acknowledged"))
        if self._continuation is not None:
            self._continuation.cancel()
            self._continuation = None
        while self._endpoint.next_event() is not None:
            pass  # a command from before must not act when it is opened again
        self._alarm.cancel()
