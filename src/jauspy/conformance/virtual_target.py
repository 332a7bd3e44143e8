"""A target in memory on virtual time: components and their node manager, and a `Wire` to them without a network.

Used by tests of components. Virtual time passes without waiting.
"""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable, Collection, Iterable
from itertools import count
from typing import Final

from jauspy.conformance.link import PORTS, RAW, Arrival
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.addressing import GroupPort, LocalPort, Port, UdpPort
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Packet
from jauspy.protocol.routing import Router
from jauspy.services.host import Host
from jauspy.services.messaging import Outgoing

ROOT: Final = "/virtual-target"
USUAL_PORT: Final = UdpPort("192.0.2.42", judp.PORT)
OTHER_PORT: Final = UdpPort("192.0.2.42", 49152)
"""Second address of the tester. Both are documentation addresses (RFC 5737)."""

Intercept = Callable[[Packet], bool]
Tick = Callable[[float], None]
"""Advances a simulation, such as a robot, by seconds."""


class TargetComponent:
    """One component: its services and its endpoint. A subclass may override `receive` and `send`."""

    def __init__(self, host: Host, intercept: Intercept = lambda _: False) -> None:
        self.host = host
        self.intercept = intercept
        """Called with every packet first; packets for which it returns true do not reach the services."""
        self.endpoint = Endpoint(host.id, first_sequence=1)
        self._callbacks: dict[int, Callable[[bool], None]] = {}

    def receive(self, payload: bytes, source: JausID, now: float) -> None:
        """Handle a message that was received."""
        self.host.receive(payload, source, now)

    def send(self, outgoing: Outgoing, now: float) -> None:
        """Send a message."""
        ticket = self.endpoint.send(
            outgoing.destination,
            outgoing.payload,
            now=now,
            priority=outgoing.priority,
            broadcast=outgoing.broadcast,
            ack=Ack.NONE if outgoing.on_acknowledged is None else Ack.REQUIRED,
        )
        if outgoing.on_acknowledged is not None and ticket is not None:
            self._callbacks[ticket] = outgoing.on_acknowledged

    def handle(self, datagram: bytes, now: float) -> None:
        """Handle a datagram from the node manager."""
        self.endpoint.receive(datagram, now)

    def work(self, now: float) -> list[bytes]:
        """Do what is due at `now`; returns the datagrams to send."""
        self.endpoint.handle_timeout(now)
        while (packet := self.endpoint.next_event()) is not None:
            if not self.intercept(packet):
                self.receive(packet.payload, packet.source, now)
        self.host.handle_timeout(now)
        for outgoing in self.host.poll_output(now):
            self.send(outgoing, now)
        while (outcome := self.endpoint.next_outcome()) is not None:
            if (callback := self._callbacks.pop(outcome.ticket, None)) is not None:
                callback(outcome.delivered)
        return self.endpoint.poll_output()

    def next_timeout(self) -> float | None:
        """Time of the next call of `work`; None if nothing is scheduled."""
        due = [time for time in (self.host.next_timeout(), self.endpoint.next_timeout()) if time is not None]
        return min(due, default=None)


class VirtualTarget:
    """A `Wire` to components in this process.

    `delay`: seconds that a datagram travels. `tick` is called with the time that passes, at most `step` seconds at a
    time. A subclass may change datagrams in `inbound` and `outbound`.
    """

    features: Collection[str] = (RAW, PORTS)
    first_sequence: int = 0

    def __init__(
        self,
        components: Iterable[TargetComponent],
        *,
        delay: float = 0.001,
        tick: Tick | None = None,
        step: float = 0.02,
        now: float = 0.0,
    ) -> None:
        self.components = {component.host.id: component for component in components}
        self.node = Router(ROOT)
        self._delay = delay
        self._tick = tick
        self._step = step
        self._now = now
        self._order = count()
        self._in_flight: list[tuple[float, int, bytes, UdpPort]] = []
        self._arrived: deque[Arrival] = deque()
        self._listening: set[UdpPort] = {USUAL_PORT}
        for id, component in self.components.items():
            self.node.components.register(int(id), LocalPort(f"{ROOT}/{int(id)}"))
            self._transmit(component)

    # --- may be overridden -------------------------------------------------------------------------------------------

    def inbound(self, datagram: bytes) -> Iterable[bytes]:
        """The datagrams that the node manager receives when the tester sends this one."""
        return (datagram,)

    def outbound(self, datagram: bytes) -> Iterable[bytes]:
        """The datagrams that the tester receives when the node manager sends this one."""
        return (datagram,)

    def reply_port(self, port: UdpPort) -> UdpPort:
        """The address to which the node manager's answers to this port go."""
        return port

    # --- a Wire -----------------------------------------------------------------------------------------------------

    def now(self) -> float:
        """Virtual seconds."""
        return self._now

    def join(self, id: JausID) -> None:
        """Nothing to do: all clients are reached at the tester's address."""

    def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:  # noqa: ARG002 - one address for all
        """Deliver a datagram to the node manager after the delay."""
        port = OTHER_PORT if other_port else USUAL_PORT
        self._listening.add(port)
        for copy in self.inbound(datagram):
            heapq.heappush(self._in_flight, (self._now + self._delay, next(self._order), copy, port))

    def receive(self, until: float) -> Arrival | None:
        """The next arrival; virtual time advances until then, at most to `until`."""
        while not self._arrived and self._now < until:
            self._advance(min(until, self._next_event()))
        return self._arrived.popleft() if self._arrived else None

    def close(self) -> None:
        """Close the components."""
        for component in self.components.values():
            component.host.close(self._now)

    # --- inside -----------------------------------------------------------------------------------------------------

    def _next_event(self) -> float:
        times = [component.next_timeout() for component in self.components.values()]
        times += [self.node.next_timeout(), self._in_flight[0][0] if self._in_flight else None]
        return max(self._now, min((time for time in times if time is not None), default=float("inf")))

    def _advance(self, end: float) -> None:
        while self._tick is not None and self._now < end:
            span = min(self._step, end - self._now)
            self._tick(span)
            self._now = end if span < self._step else self._now + span
        self._now = max(self._now, end)
        while self._in_flight and self._in_flight[0][0] <= self._now:
            _, _, datagram, port = heapq.heappop(self._in_flight)
            self.node.receive(datagram, port, self._now)
            self._route()
        self.node.handle_timeout(self._now)
        self._route()
        for component in self.components.values():
            self._transmit(component)

    def _transmit(self, component: TargetComponent) -> None:
        for datagram in component.work(self._now):
            self.node.receive(datagram, LocalPort(f"{ROOT}/{int(component.host.id)}"), self._now)
        self._route()

    def _route(self) -> None:
        while output := self.node.poll_output():
            for port, datagram in output:
                self._deliver(port, datagram)

    def _deliver(self, port: Port, datagram: bytes) -> None:
        if isinstance(port, LocalPort):
            component = self.components[JausID.from_int(int(port.path.rpartition("/")[2]))]
            component.handle(datagram, self._now)
            self._transmit(component)
        elif isinstance(port, GroupPort | UdpPort):
            back = self.reply_port(port) if isinstance(port, UdpPort) else USUAL_PORT
            if back in self._listening:
                self._arrived += (Arrival(copy, back == OTHER_PORT) for copy in self.outbound(datagram))
