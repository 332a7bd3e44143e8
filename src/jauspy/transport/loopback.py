"""Transports between components of one process, without sockets."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import addressing, judp
from jauspy.protocol.addressing import HERE, Location
from jauspy.protocol.counters import Counters
from jauspy.transport.age import MAX_AGE
from jauspy.transport.base import Receiver, ignore

_LOG = get_logger(__name__)


class LoopbackHub:
    """Connects loopback transports; routes like a node manager."""

    def __init__(self) -> None:
        self.members: dict[int, LoopbackTransport] = {}

    def route(self, datagram: bytes, sender: LoopbackTransport) -> None:
        """Deliver a datagram to every member that it addresses."""
        for raw in judp.headers(datagram):
            exact = self.members.get(raw.destination)
            if exact is not None:
                exact.deliver(datagram)
            elif addressing.is_wildcard(raw.destination):
                for id, member in list(self.members.items()):
                    if member is not sender and addressing.reaches(raw.destination, id):
                        member.deliver(datagram)


class LoopbackTransport:
    """A transport over a `LoopbackHub`; datagrams arrive in a later turn of the event loop."""

    def __init__(self, id: JausID, hub: LoopbackHub) -> None:
        self.id = id
        self.received: Receiver = ignore
        self.max_age = MAX_AGE
        self._stalled_until = float("-inf")
        self._hub = hub
        self._counters = Counters(_LOG)

    @property
    def connected(self) -> bool:
        """True between `open` and `close`."""
        return self._hub.members.get(int(self.id)) is self

    @property
    def waiting(self) -> int:
        """Always 0."""
        return 0

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""
        return self._counters

    async def open(self) -> None:
        """Join the hub; raises `TransportError` when the id is in use."""
        self._join(self.id)

    async def close(self) -> None:
        """Leave the hub."""
        if self.connected:
            del self._hub.members[int(self.id)]

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Change the id; raises `TransportError` when the new one is in use."""
        if self.connected:
            self._join(id)
            on_leave()
            del self._hub.members[int(self.id)]
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Route a datagram; dropped and counted when it is malformed or the transport is closed."""
        if not self.connected:
            self._counters.drop("closed")
            return
        try:
            self._hub.route(datagram, self)
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
        else:
            self._counters["sent"] += 1

    def locate(self, id: JausID, found: Callable[[Location], None]) -> None:  # noqa: ARG002 - the same for all ids
        """Call `found`: whoever sends to the hub is in this process."""
        found(HERE)

    def _join(self, id: JausID) -> None:
        if self._hub.members.setdefault(int(id), self) is not self:
            raise TransportError(f"another component {id} is already on this loopback hub; choose another id")

    def stall(self, seconds: float) -> None:
        """Read nothing for this time from now on, as when the process does not run; what arrives is read afterwards."""
        self._stalled_until = asyncio.get_running_loop().time() + seconds

    def deliver(self, datagram: bytes) -> None:
        """Called by the hub."""
        loop = asyncio.get_running_loop()
        now = loop.time()
        if now < self._stalled_until:
            loop.call_at(self._stalled_until, self._arrive, datagram, now)
        else:
            loop.call_soon(self._arrive, datagram, now)

    def _arrive(self, datagram: bytes, since: float) -> None:
        if not self.connected:
            return
        if asyncio.get_running_loop().time() - since > self.max_age and not judp.may_be_late(datagram):
            self._counters.drop("stale")
            return
        self._counters["received"] += 1
        self.received(datagram)
