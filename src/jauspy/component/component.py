"""`Component` runs services on a transport with asyncio; `run` runs components as a program."""

from __future__ import annotations

import asyncio
import math
import random
import signal
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Literal, Self, TypeAlias, TypeVar

from jauspy.arguments import check_text, described
from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.component.acknowledgements import Acknowledgements
from jauspy.component.assigned_id import IDRequest
from jauspy.component.inbox import ClientInbox, may_wait
from jauspy.errors import ConfigError, ProtocolError, TransportError
from jauspy.ids import JausID, component_id, message_id
from jauspy.logs import get_logger
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.protocol.addressing import UNKNOWN_LOCATION, Location
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority, broadcast_code
from jauspy.schema.model import Schema
from jauspy.services.core import with_core_services
from jauspy.services.host import Host
from jauspy.services.messaging import Outgoing
from jauspy.services.service import Service, check_services
from jauspy.transport import LocalTransport, Transport
from jauspy.transport.age import MAX_AGE
from jauspy.transport.base import AddressedTransport, ClashAwareTransport, FilteringTransport, LocatingTransport
from jauspy.transport.connect import DEFAULT_ROOT, transport_for


class ErrorGuard:
    """A `with` block that logs and counts exceptions, so that the component continues; reusable, not to be nested."""

    __slots__ = ("_counters", "_name")

    def __init__(self, name: str, counters: Counter[str]) -> None:
        self._name = name
        self._counters = counters

    def __enter__(self) -> None:
        return None

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        if not isinstance(error, Exception):
            return False
        self._counters["internal_error"] += 1
        _LOG.error("%s: %s", self._name, error, exc_info=error)
        return True


class LoopTimer:
    """Calls `on_timeout` once at the time (s) that was set last, by `clock`; uses one timer handle of the loop."""

    def __init__(self, on_timeout: Callable[[], None], clock: Callable[[], float]) -> None:
        self._on_timeout = on_timeout
        self._clock = clock
        self._handle: asyncio.TimerHandle | None = None
        self._at: float | None = None

    def set(self, loop: asyncio.AbstractEventLoop, due: float | None) -> None:
        """Set the time, None for never; the same time as before costs nothing."""
        if self._handle is not None:
            if due == self._at:
                return
            self._handle.cancel()
            self._handle = None
        if due is not None:
            self._handle, self._at = loop.call_later(max(0.0, due - self._clock()), self._expire), due

    def cancel(self) -> None:
        """Cancel the timer, if it is set."""
        if self._handle is not None:
            self._handle.cancel()
            self._handle = None

    def _expire(self) -> None:
        self._handle = None
        self._on_timeout()


S = TypeVar("S", bound=Service)

Intercept: TypeAlias = Callable[[Packet], bool]
"""Called with every received packet; when it returns True, the packet is not passed to the services."""

MAX_PACKETS_PER_TURN: Final = 256
"""Packets of one datagram that are handled in one turn of the event loop; the rest is handled in the next ones."""
MAX_WAITING_PER_TURN: Final = 8
"""Queries and requests for events that are handled in one turn of the event loop; commands never wait for the rest."""
MAX_TRANSPORT_BACKLOG: Final = 64
"""Datagrams that may be queued in the transport when further fragments of a large message are sent."""
_NAME: Final = "jauspy component"
_LOG: Final = get_logger("jauspy.component")


def loop_time() -> float:
    """Seconds of the clock of the running event loop, which is virtual in some tests; without a loop, monotonic."""
    try:
        return asyncio.get_running_loop().time()
    except RuntimeError:
        return time.monotonic()


def wall_clock() -> datetime:
    """The time of the machine, UTC."""
    return datetime.now(UTC)


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentOptions:
    """Settings of a component that few programs need.

    `delivery` has the settings of reliable delivery and large messages. `schema` and `registry` replace the definitions
    and messages that are built in or that services bring. `clock` is monotonic, in seconds; `utc_now` the wall clock.
    `max_message_age` is the time in seconds for which a received command may wait while the component does not read, as
    when its process is stopped; an older one is dropped, unless it is acknowledged. 0 is no limit.
    """

    delivery: Delivery | None = None
    max_message_age: float = MAX_AGE
    schema: Schema | None = None
    registry: Registry | None = None
    clock: Callable[[], float] = loop_time
    utc_now: Callable[[], datetime] = wall_clock
    first_sequence: int | None = None
    """Sequence number of the first message; None: random."""


class Component:
    """`async with jauspy.Component("101.1.120", [Battery()]): ...`, or `jauspy.run(component)`.

    Core services (Transport, Events, AccessControl, Management, Time, Liveness and Discovery) are included by default;
    with `core=False` only those that the given services inherit from. `name` is reported by Discovery. `connect` is the
    address of the node manager: None (on this machine, its sockets in /tmp), or as for `OCU`; with "udp://HOST" the
    component can act as a client, but others cannot discover it. `transport` replaces the connection. An id with zeros,
    as in `"0.0.101"`, is completed later, see `move`. An exception in a service is logged with the message that
    triggered it; the component keeps its state, or goes to Failure with `on_action_error="failure"`.

    While there is no connection, what is sent is dropped and counted by the transport. Nothing raises because of the
    network or of exceptions in services.

    Raises `ConfigError` that names every method which a service lacks, with its signature.
    """

    def __init__(
        self,
        id: str | JausID,
        services: Iterable[Service],
        *,
        name: str = _NAME,
        core: bool = True,
        connect: str | None = None,
        transport: Transport | None = None,
        on_action_error: Literal["stay", "failure"] = "stay",
        options: ComponentOptions | None = None,
    ) -> None:
        options = options or ComponentOptions()
        me = component_id(id)
        check_text(name, "a component's name")
        given = check_services(services)
        host = Host(
            me,
            with_core_services(given, name) if core else given,
            utc_now=options.utc_now,
            now=options.clock(),
            on_action_error=on_action_error,
            schema=options.schema,
            registry=options.registry,
        )
        self._set_up(host, connect, transport, None, options)

    @classmethod
    def of_host(
        cls,
        host: Host,
        transport: Transport,
        *,
        intercept: Intercept | None = None,
        options: ComponentOptions | None = None,
    ) -> Self:
        """A component that runs an existing `Host`, with exactly its services."""
        component = cls.__new__(cls)
        component._set_up(host, None, transport, intercept, options or ComponentOptions())  # noqa: SLF001 - its own
        return component

    def _set_up(
        self,
        host: Host,
        connect: str | None,
        transport: Transport | None,
        intercept: Intercept | None,
        options: ComponentOptions,
    ) -> None:
        self.host = host
        self._connect = connect
        self._given_transport = transport
        self._intercept = intercept
        self._options = options
        self._clock = options.clock
        self._transport = transport
        host.on_timer_change = self._on_timer_change
        host.on_expect = self._leave_out_heartbeats
        host.locate = self._locate
        self._errors: Counter[str] = Counter()
        self._guard = ErrorGuard(f"component {host.id}", self._errors)
        self._timer = LoopTimer(self._on_timeout, self._clock)
        self._make_endpoint()
        self._continuation: asyncio.Handle | None = None
        self._handled = 0
        self._loop: asyncio.AbstractEventLoop | None = None
        self._closed = asyncio.Event()

    def _make_endpoint(self) -> None:
        first = self._options.first_sequence
        start = random.randrange(0x10000) if first is None else first  # noqa: S311 - not a secret
        self._endpoint = Endpoint(self.host.id, first_sequence=start, delivery=self._options.delivery)
        self._inbox = ClientInbox(self._endpoint.counters)
        self._acknowledgements = Acknowledgements(self._endpoint, self._on_unreachable)

    def __repr__(self) -> str:
        return (
            f"<component {self.id} with {', '.join(definition.name for definition in self.host.definitions.values())}>"
        )

    @property
    def id(self) -> JausID:
        """Current JAUS id of the component."""
        return self.host.id

    @property
    def state(self) -> str:
        """The state of the component, as a dotted path."""
        return self.host.state

    @property
    def controller(self) -> JausID | None:
        """The client in control, if any."""
        return self.host.controller

    @property
    def is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._loop is not None

    @property
    def is_connected(self) -> bool:
        """True while its node manager answers."""
        return self.is_open and self._transport is not None and self._transport.connected

    @property
    def counters(self) -> Mapping[str, int]:
        """All counters, by part: `host.…`, `endpoint.…`, `transport.…` and `component.…`."""
        parts: dict[str, Mapping[str, int]] = {
            "component": self._errors,
            "host": self.host.counters,
            "endpoint": self._endpoint.counters,
            "transport": self._transport.counters if self._transport else {},
        }
        copies = {part: dict(counts) for part, counts in parts.items()}  # other threads may read them, too
        return {f"{part}.{name}": value for part, counts in copies.items() for name, value in counts.items()}

    def service(self, kind: type[S]) -> S:
        """The service of this class; `ConfigError` when the component has none."""
        found = self.host.service(kind)
        if found is None:
            raise ConfigError(f"{self} has no service of the class {kind.__name__}")
        return found

    async def open(self) -> None:
        """Connect and start. Raises `TransportError`, whose text contains what to do. May be called twice."""
        if self.is_open:
            return
        transport = self._transport = self._given_transport or await self._make_transport()
        transport.received = self._on_datagram
        transport.max_age = self._options.max_message_age or math.inf
        self._make_endpoint()
        self._loop = asyncio.get_running_loop()
        self._closed.clear()
        try:
            await transport.open()
        except BaseException:
            self._stop()
            await transport.close()
            raise
        self._leave_out_heartbeats()
        self._flush()

    async def close(self) -> None:
        """Stop all motion, send what is queued and disconnect. May be called twice."""
        if self.is_open:
            with self._guard:
                self.host.close(self._clock())
            self._flush()
            self._stop()
        if self._transport is not None:
            await self._transport.close()
        self._closed.set()

    async def run(self) -> None:
        """Open, serve until closed or cancelled, close."""
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
        destination: str | JausID,
        message: Message,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> None:
        """Send a message now; raises `EncodeError` for a value that does not fit, `ProtocolError` if it is too long.

        With `Ack.REQUIRED` it is resent until it is acknowledged or given up, which is counted; `deliver` waits for it.
        """
        self._send(JausID.of(destination), message.encode(), priority, broadcast, ack)

    def send_encoded(
        self,
        destination: str | JausID,
        payload: bytes,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> None:
        """Send the bytes of a message, with its id, as `send` does; they may be no valid message."""
        self._send(JausID.of(destination), payload, priority, broadcast, ack)

    async def deliver(
        self, destination: str | JausID, message: Message, *, priority: Priority = Priority.STANDARD
    ) -> None:
        """Send, and wait for the acknowledgement; if there is none after all resends, `ResponseTimeout` is raised.

        Raises `ProtocolError` for a wildcard destination, since broadcasts are not acknowledged.
        """
        receiver = JausID.of(destination)
        if receiver.is_wildcard:
            raise ProtocolError("not_acknowledged", f"{receiver} is a broadcast, which is not acknowledged")
        ticket = self._send(receiver, message.encode(), priority, Broadcast.NONE, Ack.REQUIRED)
        await self._acknowledgements.wait(ticket, f"{receiver} did not acknowledge {message.NAME}")

    def move(self, id: str | JausID) -> None:
        """Change the id: registration and Discovery have the new one, events and control end.

        Clients are notified under the old id. Raises `TransportError` when the new id is taken on this machine; the
        component then keeps its id. An action does the same with `self.host.ask_for_id(id)`.
        """
        transport = self._require_open()
        self.host.ask_for_id(component_id(id))
        self._send_queued(transport)
        if (problem := self._change_id(transport)) is not None:
            raise problem
        self._flush()

    def request_id(self, key: bytes) -> None:
        """Ask for the subsystem and node that the id lacks, until SubsystemIDAllocator and NodeIDAllocator grant them.

        `key`: six bytes that no other component of the system has, as the machine's MAC address. Anybody on the network
        can answer; there is no proof of who grants.
        """
        self._require_open()
        self._intercept = IDRequest(self.host, key).intercept
        self._leave_out_heartbeats()
        self._flush()

    def wake(self) -> None:
        """Send what services have queued, and set their timers.

        To be called after services were used outside of actions.
        """
        self._require_open()
        self._flush()

    # --- sending --------------------------------------------------------------------------------------------------

    def _require_open(self) -> Transport:
        if self._transport is None or self._loop is None:
            raise ConfigError(f"{self} is not open; use `async with component:` first")
        return self._transport

    async def _make_transport(self) -> Transport:
        if self._connect is None:
            return LocalTransport(self.id, Path(DEFAULT_ROOT))
        return await transport_for(self.id, self._connect)

    def _send(
        self, destination: JausID, payload: bytes, priority: Priority, broadcast: Broadcast, ack: Ack
    ) -> int | None:
        transport, now = self._require_open(), self._clock()
        ticket = self._endpoint.send(destination, payload, now=now, priority=priority, broadcast=broadcast, ack=ack)
        self._transmit(transport)
        self._set_timer()
        return ticket

    def _flush(self) -> None:
        """Send everything that is queued, and set the timer again."""
        if self._loop is None or self._transport is None:
            return
        with self._guard:
            self._send_queued(self._transport)
            if self.host.requested_id is not None and (problem := self._change_id(self._transport)) is not None:
                _LOG.error("%s keeps its id: %s", self.id, problem)
        self._set_timer()

    def _send_queued(self, transport: Transport) -> None:
        """Send what services have queued; what cannot be sent is counted, and logged the first time."""
        now = self._clock()
        for outgoing in self.host.poll_output(now):
            self._pack(outgoing, now)
        self._transmit(transport)

    def _pack(self, outgoing: Outgoing, now: float) -> None:
        destination, payload, priority, broadcast, on_acknowledged = outgoing
        ack = Ack.NONE if on_acknowledged is None or self._acknowledgements.is_full else Ack.REQUIRED
        try:
            ticket = self._endpoint.send(destination, payload, now=now, priority=priority, broadcast=broadcast, ack=ack)
        except ProtocolError as error:
            reason = f"unsendable.{error.reason}"
            if not self._errors[reason]:
                code = message_id(payload)
                _LOG.warning("%s: cannot send %04Xh to %s: %s", self.id, code, destination, error)
            self._errors[reason] += 1
        else:
            if on_acknowledged is not None and ticket is not None:
                self._acknowledgements.add_callback(ticket, partial(self._on_acknowledged, on_acknowledged))

    def _on_acknowledged(self, on_acknowledged: Callable[[bool], None], delivered: bool) -> None:
        """Tell a service, with the present time."""
        self.host.now = self._clock()
        on_acknowledged(delivered)

    def _transmit(self, transport: Transport) -> None:
        for datagram in self._endpoint.poll_output():
            transport.send(datagram)
        self._acknowledgements.process()

    def _change_id(self, transport: Transport) -> TransportError | None:
        """Take the id that the host requests, after it has left under the old one; returns why that is not possible."""
        requested = self.host.requested_id
        if requested is None:
            return None
        try:
            transport.move(requested, self._leave)
        except TransportError as error:
            self.host.ask_for_id(self.id)
            self._errors["move_failed"] += 1
            return error
        self._endpoint.change_id(requested)
        self.host.take_id(requested, self._clock())
        self._send_queued(transport)
        return None

    def _leave(self) -> None:
        self.host.leave(self._clock())
        if self._transport is not None:
            self._send_queued(self._transport)

    # --- events of the loop ---------------------------------------------------------------------------------------

    def _on_datagram(self, datagram: bytes) -> None:
        if self._loop is None:
            return
        if (code := broadcast_code(datagram)) is not None and self._intercept is None and not self.host.takes(code):
            # as heartbeats of all robots where the transport does not leave them out
            self.host.count("unknown_message", f"{code:04X}h")
            return
        with self._guard:
            self._endpoint.receive(datagram, self._clock())
        self._handle_packets()

    def _handle_packets(self) -> None:
        """Handle what was received, up to `MAX_PACKETS_PER_TURN`; beyond `MAX_WAITING_PER_TURN` some have to wait."""
        flush = True
        for _ in range(MAX_PACKETS_PER_TURN):
            packet = self._endpoint.next_event()
            if packet is None:
                break
            if may_wait(packet):
                if len(self._inbox) or self._handled >= MAX_WAITING_PER_TURN:
                    self._inbox.put(packet)
                    self._end_turn()
                    flush = False  # the next turn does it
                    continue
                self._handled += 1
                self._end_turn()
            self._handle(packet)
            flush = True
        else:
            self._end_turn()
        if flush:
            self._flush()

    def _handle(self, packet: Packet) -> None:
        with self._guard:
            if self._intercept is None or not self._intercept(packet):
                self.host.receive(packet.payload, packet.source, self._clock())

    def _end_turn(self) -> None:
        if self._continuation is None and self._loop is not None:
            self._continuation = self._loop.call_soon(self._begin_turn)

    def _begin_turn(self) -> None:
        """Handle the rest of the last turn's packets, and some of those that wait in the inbox."""
        self._continuation, self._handled = None, 0
        self._handle_packets()
        while self._handled < MAX_WAITING_PER_TURN and (packet := self._inbox.take()) is not None:
            self._handled += 1
            self._handle(packet)
        if self._handled:
            self._end_turn()
            self._flush()

    def _on_unreachable(self, client: JausID) -> None:
        """End the events and control of a client that did not acknowledge.

        What services send for this is sent in the next turn.
        """
        self.host.unreachable(client, self._clock())
        if self._loop is not None:
            self._loop.call_soon(self._flush)

    def _set_timer(self) -> None:
        """Set the timer; most datagrams do not change it."""
        if self._loop is not None:
            services, delivery = self.host.next_timeout(), self._endpoint.next_timeout()
            due = services if delivery is None or (services is not None and services < delivery) else delivery
            self._timer.set(self._loop, due)

    def host_towards(self, id: JausID) -> str | None:
        """The host to which datagrams for a component are sent; None if the transport does not know it."""
        return self._transport.host_towards(id) if isinstance(self._transport, AddressedTransport) else None

    async def id_clash(self) -> str | None:
        """The address of another machine that uses the id of this component; None if the transport knows of none."""
        transport = self._transport
        return await transport.id_clash() if isinstance(transport, ClashAwareTransport) else None

    def _locate(self, id: JausID, found: Callable[[Location], None]) -> None:
        if isinstance(self._transport, LocatingTransport):
            self._transport.locate(id, found)
        else:
            found(UNKNOWN_LOCATION)

    def _leave_out_heartbeats(self) -> None:
        """Have those broadcasts left out that all robots send, unless a service takes them (ADR 220)."""
        if isinstance(self._transport, FilteringTransport):
            is_taken = self._intercept is not None or self.host.takes(ReportHeartbeatPulse.CODE)
            self._transport.leave_out_broadcasts(() if is_taken else (ReportHeartbeatPulse.CODE,))

    def _on_timer_change(self) -> None:
        self._set_timer()

    def _on_timeout(self) -> None:
        try:
            with self._guard:
                room = self._transport is not None and self._transport.waiting < MAX_TRANSPORT_BACKLOG
                self._endpoint.handle_timeout(self._clock(), room=room)
                self.host.handle_timeout(self._clock(), room=room)
        finally:
            self._flush()  # also after the panic of an extension: without a timer all watchdogs would end

    def _stop(self) -> None:
        self._loop = None
        self._acknowledgements.fail(TransportError(f"component {self.id} was closed before this was acknowledged"))
        if self._continuation is not None:
            self._continuation.cancel()
            self._continuation = None
        self._timer.cancel()


def run(*components: Component) -> None:
    """Run components until Ctrl-C or SIGTERM, or until all are closed.

    Raises `TransportError` when one cannot start. In a program with its own event loop, use `component.run()`.
    """
    for component in components:
        if not isinstance(component, Component):
            raise TypeError(
                f"run() takes components, as in jauspy.Component('101.1.120', [...]), not {described(component)}"
            )
    try:
        asyncio.run(_serve(components))
    except TransportError as error:
        raise error.with_traceback(None) from None  # its last line says what to do; the traceback does not help


async def _serve(components: tuple[Component, ...]) -> None:
    await until_signalled(asyncio.gather(*(component.run() for component in components)))


async def until_signalled(serving: asyncio.Future[Any]) -> None:
    """Wait for `serving`; Ctrl-C, SIGTERM and SIGHUP (unless ignored, as by nohup) cancel it, which is no error then.

    Works in the main thread only; in other threads, signals have no effect here.
    """
    loop = asyncio.get_running_loop()
    stopped = False

    def stop() -> None:
        nonlocal stopped
        stopped = True
        serving.cancel()

    numbers = [signal.SIGINT, signal.SIGTERM]
    if signal.getsignal(signal.SIGHUP) is not signal.SIG_IGN:
        numbers.append(signal.SIGHUP)
    if threading.current_thread() is not threading.main_thread():
        numbers.clear()
    for number in numbers:
        loop.add_signal_handler(number, stop)
    try:
        await serving
    except asyncio.CancelledError:
        if not stopped:
            raise
    finally:
        for number in numbers:
            loop.remove_signal_handler(number)
