"""The connections of the console: accepts them, and closes idle ones when a host or a session has too many.

uvicorn counts all connections in one number and waits for the first request without end, so any host could keep all
others out. Here a connection is a stranger's until a request on it has had a session. Strangers have shares for each
host; a new one always finds room, and the oldest idle one of the host with most of them is closed for it.
"""

from __future__ import annotations

import asyncio
import errno
import ipaddress
import socket
import ssl
from collections import Counter
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Final

from jauspy.logs import get_logger

HANDSHAKE_TIME: Final = 5.0
"""Seconds for the handshake of TLS."""
IDLE_TIME: Final = 10.0
"""Seconds from connecting, or from the end of an answer, until a request has arrived as a whole."""
REQUEST_TIME: Final = 30.0
"""Seconds for the request of a stranger and its answer, such as a login that waits for others."""
_SWEEP_INTERVAL: Final = 1.0
"""Seconds between two checks of all connections."""
_ACCEPT_PAUSE: Final = 0.1
"""Seconds until the next attempt when the process has no descriptor left."""
_NO_DESCRIPTOR: Final = (errno.EMFILE, errno.ENFILE)
_LOG = get_logger(__name__)

Client = tuple[str, int]
"""Address and port, as in the scope of a request."""


@dataclass(eq=False, slots=True)
class _Connection:
    socket: socket.socket
    host: str
    since: float
    """When it was accepted, or the last request on it began or ended."""
    task: asyncio.Task[None] | None = None
    """Connects it to the server, with the handshake of TLS."""
    transport: asyncio.Transport | None = None
    session: Hashable = None
    requests: int = 0
    """Number of requests that have begun and not ended."""
    is_socket: bool = False
    is_closing: bool = False

    @property
    def is_gone(self) -> bool:
        """True when its descriptor is closed."""
        return self.socket.fileno() < 0

    @property
    def counts(self) -> bool:
        """False when it is closed, or about to be."""
        return not (self.is_gone or self.is_closing or (self.transport is not None and self.transport.is_closing()))

    def close(self) -> None:
        """Close it without waiting for the peer."""
        self.is_closing = True
        if self.transport is not None:
            self.transport.abort()
        elif self.task is not None:
            self.task.cancel()


@dataclass(frozen=True, slots=True)
class Share:
    """How many connections a host or session may have, and all together."""

    of_group: int
    in_all: int
    reason: str
    """Why a connection was closed that was too many."""


STRANGERS: Final = Share(32, 128, "too many had no session")
"""Connections on which no request had a session, by hosts."""
KNOWN: Final = Share(32, 192, "a session had too many")
"""Connections of sessions, beside their sockets."""


class Connections:
    """The connections of one listener, by address and port of the browser."""

    def __init__(self, note: Callable[[str], None] = lambda _: None) -> None:
        """`note` is called with sentences for the operator."""
        self._note = note
        self.closed: Counter[str] = Counter()
        """How many were closed, by reason."""
        self._open: dict[Client, _Connection] = {}

    def __len__(self) -> int:
        return len(self._open)

    async def serve(
        self, listener: socket.socket, make_protocol: Callable[[], asyncio.Protocol], tls: ssl.SSLContext | None
    ) -> None:
        """Accept connections until this is cancelled."""
        loop = asyncio.get_running_loop()
        listener.setblocking(False)
        sweeping = asyncio.create_task(self._sweep(), name="console: connections")
        try:
            while True:
                try:
                    sock, address = await loop.sock_accept(listener)
                except OSError as error:
                    _LOG.warning("the console cannot accept a connection: %s", error.strerror)
                    if error.errno in _NO_DESCRIPTOR:
                        self._close_oldest("no descriptor was left", self._strangers())
                    await asyncio.sleep(_ACCEPT_PAUSE)
                    continue
                self._admit(sock, (str(address[0]), int(address[1])), make_protocol, tls)
                await asyncio.sleep(0)  # `sock_accept` does not wait while more connections are there
        finally:
            sweeping.cancel()
            for connection in self._open.values():
                if connection.transport is None:
                    connection.close()

    @contextmanager
    def request_of(self, client: Client | None) -> Iterator[None]:
        """Within this a request of this browser is answered."""
        connection = self._open.get(client) if client else None
        if connection is None:
            yield
            return
        connection.requests += 1
        connection.since = _now()
        try:
            yield
        finally:
            connection.requests -= 1
            connection.since = _now()

    def is_of(self, client: Client | None, session: Hashable, *, is_socket: bool) -> None:
        """Count a connection for a session, which a request on it has proven."""
        connection = self._open.get(client) if client else None
        if connection is None:
            return
        if connection.session is None and not is_socket:
            known = [
                connection
                for connection in self._open.values()
                if connection.session is not None and not connection.is_socket
            ]
            self._make_room(KNOWN, known, lambda connection: connection.session, session)
        connection.session = session
        connection.is_socket = connection.is_socket or is_socket

    def _admit(
        self,
        sock: socket.socket,
        client: Client,
        make_protocol: Callable[[], asyncio.Protocol],
        tls: ssl.SSLContext | None,
    ) -> None:
        self._forget_gone()
        connection = _Connection(sock, network_of(client[0]), _now())
        self._make_room(STRANGERS, self._strangers(), lambda connection: connection.host, connection.host)
        self._open[client] = connection
        connection.task = asyncio.create_task(self._connect(connection, sock, make_protocol, tls))

    async def _connect(
        self,
        connection: _Connection,
        sock: socket.socket,
        make_protocol: Callable[[], asyncio.Protocol],
        tls: ssl.SSLContext | None,
    ) -> None:
        """Hand a socket over to the server, after the handshake of TLS."""
        handshake = None if tls is None else HANDSHAKE_TIME
        try:
            connection.transport, _ = await asyncio.get_running_loop().connect_accepted_socket(
                make_protocol,
                sock,
                ssl=tls,
                ssl_handshake_timeout=handshake,
                ssl_shutdown_timeout=handshake,
            )
        except (OSError, ssl.SSLError, asyncio.CancelledError) as error:
            with suppress(OSError):
                sock.close()
            self.closed["handshake"] += not isinstance(error, asyncio.CancelledError)

    def _strangers(self) -> list[_Connection]:
        return [connection for connection in self._open.values() if connection.session is None]

    def _make_room(
        self,
        share: Share,
        members: list[_Connection],
        group_of: Callable[[_Connection], Hashable],
        group: Hashable,
    ) -> None:
        """Close one connection if this group has its share of them already, or all groups have too many together."""
        present = [member for member in members if member.counts]
        sizes = Counter(map(group_of, present))
        if sizes[group] >= share.of_group:
            self._close_oldest(share.reason, [connection for connection in present if group_of(connection) == group])
        elif len(present) >= share.in_all:
            largest = max(sizes.values())
            self._close_oldest(
                share.reason, [connection for connection in present if sizes[group_of(connection)] == largest]
            )

    def _close_oldest(self, reason: str, found: list[_Connection]) -> None:
        """Close the connection that is idle for longest; if none is idle, the one whose request is oldest."""
        if found:
            oldest = min(found, key=lambda connection: (connection.requests > 0, connection.since))
            self.closed[reason] += 1
            count = self.closed[reason]
            if count & (count - 1) == 0:  # the 1st, 2nd, 4th, ...
                self._note(f"connections closed because {reason}: {count} so far, now one of {oldest.host}")
            oldest.close()

    async def _sweep(self) -> None:
        while True:
            await asyncio.sleep(_SWEEP_INTERVAL)
            now = _now()
            for connection in self._open.values():
                waited = now - connection.since
                if not connection.counts:
                    if waited > IDLE_TIME:
                        connection.close()  # its peer does not read what was still to be sent
                elif not connection.requests and waited > IDLE_TIME:
                    self.closed["no request"] += 1
                    connection.close()
                elif connection.requests and connection.session is None and waited > REQUEST_TIME:
                    self.closed["slow request"] += 1
                    connection.close()
            self._forget_gone()

    def _forget_gone(self) -> None:
        self._open = {client: connection for client, connection in self._open.items() if not connection.is_gone}


def network_of(address: str) -> str:
    """The host whose share an address counts for: of IPv6 a network of 64 bits, since a host has as many addresses."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(found, ipaddress.IPv6Address):
        return str(found.ipv4_mapped or ipaddress.ip_network((found, 64), strict=False))
    return str(found)


def _now() -> float:
    return asyncio.get_running_loop().time()
