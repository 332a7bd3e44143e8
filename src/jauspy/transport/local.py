"""A component's socket to its node manager: the Junior local protocol, which reconnects by itself."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import socket
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.protocol import junior
from jauspy.protocol.counters import Counters
from jauspy.transport import base, local_socket
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.local_sender import LocalSender

_LOGGER = logging.getLogger(__name__)

CONNECT_INTERVAL: Final = 0.025
"""Seconds between Connects until the node manager accepts; what its own clients use."""
RECONNECT_INTERVAL: Final = 0.25
"""Seconds between Connects once the node manager has been away for a while."""
KEEP_ALIVE_INTERVAL: Final = 1.0
"""Seconds between Connects while connected; node managers answer each, so silence means that ours is gone."""
MAX_UNANSWERED: Final = 2
"""Keep-alives without an answer after which the node manager counts as gone."""


class LocalTransport:
    """Sends to `<root>/JuniorRTE`, listens on `<root>/<id in decimal>`.

    `open` waits at most `patience` seconds for the node manager; `patience=None` does not wait for it at all.
    """

    def __init__(self, id: JausID, root: Path = Path("/tmp"), *, patience: float | None = 2.0) -> None:  # noqa: S108
        self.id = id
        self.received: Receiver = ignore
        self._root = Path(root)
        self._node = str(self._root / junior.SOCKET_NAME)
        self._patience = patience
        self._counters = Counters(_LOGGER)
        self._socket: socket.socket | None = None
        self._sender: LocalSender | None = None
        self._keeper: asyncio.Task[None] | None = None
        self._accepted = asyncio.Event()
        self._loss = asyncio.Event()
        self._unanswered = 0

    @property
    def path(self) -> Path:
        """The component's own socket."""
        return self._path(self.id)

    @property
    def connected(self) -> bool:
        """True while the node manager answers."""
        return self._accepted.is_set()

    @property
    def waiting(self) -> int:
        """Datagrams that the node manager has not taken yet."""
        return 0 if self._sender is None else self._sender.waiting(self._node)

    @property
    def counters(self) -> Mapping[str, int]:
        """What was sent, received and dropped, by reason."""
        return self._counters

    async def open(self) -> None:
        """Bind the component's socket and connect; raises `TransportError` when no node manager answers."""
        loop = asyncio.get_running_loop()
        self._listen(loop, self._bind(self.id))
        self._keeper = loop.create_task(self._keep_connected(), name=f"keep {self.id} connected")
        if self._patience is not None:
            try:
                await asyncio.wait_for(self._accepted.wait(), self._patience)
            except BaseException as error:
                await self.close()
                if not isinstance(error, TimeoutError):
                    raise
                raise TransportError(self._silence()) from None

    async def close(self) -> None:
        """Say goodbye, and remove the component's socket."""
        sock, sender, keeper = self._socket, self._sender, self._keeper
        self._socket = self._sender = self._keeper = None
        if sock is None or sender is None or keeper is None:
            return
        keeper.cancel()
        await asyncio.gather(keeper, return_exceptions=True)
        self._leave(sock, sender)
        self._accepted.clear()

    def move(self, id: JausID, goodbye: Callable[[], None]) -> None:
        """Listen on another socket and register with the new id; raises `TransportError` when it is taken."""
        old, sender = self._socket, self._sender
        if old is None or sender is None:
            self.id = id
            return
        new = self._bind(id)
        goodbye()
        self._leave(old, sender)
        self.id = id
        self._listen(asyncio.get_running_loop(), new).send(self._node, junior.connect(id))
        self._accepted.clear()
        self._loss.set()  # the keeper goes on until it is accepted

    def send(self, datagram: bytes) -> None:
        """Hand a datagram to the node manager; what it cannot take yet waits, in bounds."""
        if self._sender is None:
            self._counters.drop("closed")
            return
        self._counters["sent"] += 1
        self._sender.send(self._node, datagram)

    def _path(self, id: JausID) -> Path:
        return self._root / str(int(id))

    def _bind(self, id: JausID) -> socket.socket:
        path = self._path(id)
        return local_socket.bind(path, owner=f"another component {id}", advice="use another id for this one")

    def _listen(self, loop: asyncio.AbstractEventLoop, sock: socket.socket) -> LocalSender:
        self._socket = sock
        sender = self._sender = LocalSender(sock, self._counters, self._lost)
        base.start_reading(loop, sock, self._take, self._failed)
        return sender

    def _leave(self, sock: socket.socket, sender: LocalSender) -> None:
        sender.send(self._node, junior.cancel(self.id))
        sender.close()
        base.stop_reading(asyncio.get_running_loop(), sock)
        local_socket.clean_up(self.path)

    def _silence(self) -> str:
        """Why the node manager may not answer, and what to do."""
        if (why := local_socket.refusal(Path(self._node))) is not None:
            return why
        return (
            f"no node manager answers on {self._node}; start one with 'jauspy node-manager --local-root {self._root}', "
            "or name the directory with the local sockets of the one that runs"
        )

    def _lost(self, _path: str) -> None:
        if self.connected:
            self._accepted.clear()
            self._loss.set()

    def _take(self, datagram: bytes, _sender: object) -> None:
        control = junior.parse(datagram)
        if control is None:
            self._counters["received"] += 1
            self.received(datagram)
        elif control.kind is junior.ControlKind.ACCEPT:
            self._unanswered = 0
            if not self.connected:
                self._counters["connected"] += 1
                self._accepted.set()

    def _failed(self, error: OSError) -> None:
        self._counters.drop("socket_error", error)

    async def _keep_connected(self) -> None:
        interval = CONNECT_INTERVAL
        while self._sender is not None:
            if self.connected and self._unanswered >= MAX_UNANSWERED:
                self._accepted.clear()
            if self.connected:
                interval = CONNECT_INTERVAL
            self._unanswered += 1
            self._sender.send(self._node, junior.connect(self.id))
            self._loss.clear()
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._loss.wait(), KEEP_ALIVE_INTERVAL if self.connected else interval)
            if not self.connected:
                interval = min(interval * 1.3, RECONNECT_INTERVAL)
