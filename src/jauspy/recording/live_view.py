"""A live view over Foxglove's WebSocket protocol, which a slow or interrupted client cannot fill with old data.

Each client has a WebSocket server of the SDK for itself, and its bytes pass through a relay. The relay knows how much
the client has not read yet, which the SDK does not tell. Samples that tell a state are always sent; video, scans and
other bulk wait while the client is behind. A client that reads nothing for some time is disconnected, so that what
waited for it is gone; when it connects again, it is sent the present states.
"""

from __future__ import annotations

import asyncio
import secrets
import socket
from collections import Counter, OrderedDict
from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import Any, Final

import foxglove
from foxglove.websocket import ServerListener

from jauspy.errors import TransportError
from jauspy.logs import get_logger
from jauspy.recording.samples import Channels, Sample

MAX_CLIENTS: Final = 8
MAX_STATES: Final = 256
"""States of a topic that a new client is sent."""
BULK_BACKLOG: Final = 256 << 10
"""Bytes that a client has not read from which on it is sent no bulk."""
MAX_BACKLOG: Final = 24 << 20
"""Bytes that a client has not read from which on it is disconnected; more than the meshes of a robot."""
MAX_INBOUND: Final = 1 << 20
"""Bytes from a client that the SDK has not read, from which on the client is disconnected."""
SEND_BUFFER: Final = 128 << 10
"""Bytes of the kernel's send buffer: old data that a client reads after a pause."""
STALL: Final = 3.0
"""Seconds without reading after which a client is disconnected."""
HANDSHAKE_TIME: Final = 10.0
"""Seconds for the handshake of WebSocket."""
CHECK_INTERVAL: Final = 0.25
LOOPBACK: Final = "127.0.0.1"

_LOG: Final = get_logger("jauspy.recording")


class LiveView:
    """Serves samples to clients; all methods are for the event loop's thread.

    `counters`: `clients`, `refused` ones (too many), `stalled` ones (disconnected), `bulk_left_out`.
    """

    def __init__(self) -> None:
        self.counters: Counter[str] = Counter()
        self._clients: set[_Client] = set()
        self._tasks: set[asyncio.Task[None]] = set()
        self._topics: dict[str, Sample] = {}
        """The first sample of each topic, of whose form its channel is."""
        self._states: dict[str, OrderedDict[str, Sample]] = {}
        self._server: asyncio.Server | None = None
        self._session = secrets.token_hex(8)
        """Tells a client that connects again that it is the same view."""

    async def start(self, host: str, port: int) -> int:
        """Listen; returns the port. Raises `TransportError`."""
        loop = asyncio.get_running_loop()
        try:
            self._server = await loop.create_server(lambda: _Side(self._accept), host, port)
        except OSError as error:
            raise TransportError(
                f"cannot listen at {host} port {port}: {error.strerror}; choose another --port"
            ) from None
        return int(self._server.sockets[0].getsockname()[1])

    def publish(self, sample: Sample) -> None:
        """Send a sample to the clients that have subscribed to its topic."""
        self._topics.setdefault(sample.topic, sample)
        if sample.state is not None:
            states = self._states.setdefault(sample.topic, OrderedDict())
            states.pop(sample.state, None)
            states[sample.state] = sample
            if len(states) > MAX_STATES:
                states.popitem(last=False)
        for client in self._clients:
            client.add(sample)

    async def close(self) -> None:
        """Disconnect all clients; without effect when closed."""
        if self._server is not None:
            self._server.close()
        for task in list(self._tasks):
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)

    # --- clients --------------------------------------------------------------------------------------------------

    def _accept(self, side: _Side) -> None:
        if len(self._tasks) >= MAX_CLIENTS:
            self.counters["refused"] += 1
            side.transport.abort()
            return
        self.counters["clients"] += 1
        task = asyncio.create_task(self._serve(side))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _serve(self, side: _Side) -> None:
        """One client, from its connection to its end."""
        client = _Client(
            side, topics=self._topics.values(), states=self._states, counters=self.counters, session=self._session
        )
        try:
            await client.open()
            self._clients.add(client)
            await client.watch()
        except OSError as error:
            _LOG.debug("a client of the live view ended: %s", error)
        finally:
            self._clients.discard(client)
            await client.close()


class _Side(asyncio.Protocol):
    """One side of a relay: passes on what arrives, and ends with the other side."""

    transport: asyncio.Transport

    def __init__(self, accept: Callable[[_Side], None] | None = None) -> None:
        self._accept = accept
        self.other: _Side | None = None
        self.ended = asyncio.Event()
        self.received = 0

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport
        if self._accept is not None:
            transport.pause_reading()  # until there is another side
            self._accept(self)

    def data_received(self, data: bytes) -> None:
        self.received += len(data)
        if self.other is not None and not self.other.transport.is_closing():
            self.other.transport.write(data)

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 - of the protocol
        self.ended.set()
        if self.other is not None:
            self.other.transport.close()

    @property
    def unsent(self) -> int:
        """Bytes that wait for the peer."""
        return self.transport.get_write_buffer_size()


class _Client:
    """One client, with its own server of the SDK."""

    def __init__(
        self,
        side: _Side,
        *,
        topics: Iterable[Sample],
        states: dict[str, OrderedDict[str, Sample]],
        counters: Counter[str],
        session: str,
    ) -> None:
        self._side, self._topics, self._states, self._counters = side, topics, states, counters
        self._session = session
        self._context = foxglove.Context()
        self._channels = Channels(self._context)
        self._server: foxglove.websocket.WebSocketServer | None = None
        self._sdk = _Side()
        self._waits_for_key: set[str] = set()
        """Topics of which a picture was left out: those that follow cannot be decoded."""

    async def open(self) -> None:
        """Start the server, and connect it with the client. Raises `OSError`."""
        loop = asyncio.get_running_loop()
        for sample in list(self._topics):
            self._channels.channel(sample)

        def subscribed(topic: str) -> None:
            loop.call_soon_threadsafe(self._send_states, topic)

        self._server = await asyncio.to_thread(
            foxglove.start_server,
            name="jauspy",
            host=LOOPBACK,
            port=0,
            context=self._context,
            session_id=self._session,
            server_listener=_Listener(subscribed),
        )
        connection = self._side.transport.get_extra_info("socket")
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
        await loop.create_connection(lambda: self._sdk, LOOPBACK, self._server.port)
        self._sdk.other, self._side.other = self._side, self._sdk
        self._side.transport.resume_reading()

    async def watch(self) -> None:
        """Wait for the end of the connection, and cause it if the client does not read."""
        clock = asyncio.get_running_loop().time
        opened = read_at = clock()
        read_before = 0
        while not self._side.ended.is_set() and not self._sdk.ended.is_set():
            with suppress(TimeoutError):
                async with asyncio.timeout(CHECK_INTERVAL):
                    await self._side.ended.wait()
            now, unsent = clock(), self._side.unsent
            read = self._sdk.received - unsent
            if not unsent or read > read_before:
                read_at = now
            read_before = read
            is_silent = not self._sdk.received and now - opened > HANDSHAKE_TIME
            if now - read_at > STALL or unsent > MAX_BACKLOG or self._sdk.unsent > MAX_INBOUND or is_silent:
                self._counters["stalled"] += 1
                return

    async def close(self) -> None:
        """Disconnect at once: what was not sent is gone."""
        for side in (self._side, self._sdk):
            if hasattr(side, "transport"):
                side.transport.abort()
        if self._server is not None:
            await asyncio.to_thread(self._server.stop)

    def add(self, sample: Sample) -> None:
        """Send a sample, unless it is bulk and the client is behind."""
        if sample.is_bulk:
            is_behind = self._side.unsent > BULK_BACKLOG
            if is_behind or (sample.topic in self._waits_for_key and not sample.is_key):
                self._waits_for_key.add(sample.topic)
                self._counters["bulk_left_out"] += 1
                return
            self._waits_for_key.discard(sample.topic)
        self._channels.add(sample)

    def _send_states(self, topic: str) -> None:
        for sample in self._states.get(topic, {}).values():
            self._channels.add(sample)


class _Listener(ServerListener):
    """Tells which topics a client subscribes to; called in a thread of the SDK."""

    def __init__(self, subscribed: Callable[[str], None]) -> None:
        self._subscribed = subscribed

    def on_subscribe(self, client: Any, channel: Any) -> None:  # noqa: ARG002 - of the SDK
        """Tell the topic."""
        with suppress(RuntimeError):  # the loop has ended
            self._subscribed(channel.topic)
