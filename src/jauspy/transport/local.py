"""A component's socket to its node manager: the Junior local protocol, which reconnects by itself."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import logging
import shutil
import socket
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.protocol import junior
from jauspy.protocol.counters import Counters
from jauspy.transport import base
from jauspy.transport.base import Receiver, SendQueue, ignore

SEND_RETRY_INTERVAL: Final = 0.002
"""Seconds until a full queue is tried again; a datagram socket tells nobody when its queue has room."""
_NOT_LISTENING: Final = (errno.ECONNREFUSED, errno.ENOENT)


class LocalSender:
    """Sends on one socket to any path; per path a bounded queue. `gone(path)` is told when nobody listens there."""

    def __init__(self, sock: socket.socket, counters: Counters, gone: Callable[[str], None]) -> None:
        self._socket = sock
        self._counters = counters
        self._gone = gone
        self._outboxes: dict[str, SendQueue] = {}
        self._retry: asyncio.TimerHandle | None = None

    def send(self, path: str, datagram: bytes) -> None:
        """Send now, or as soon as there is room; never blocks, never raises, counts what it drops."""
        outbox = self._outboxes.get(path)
        if outbox is None:
            if self._try(path, datagram):
                return
            outbox = self._outboxes[path] = SendQueue()
        for _ in range(outbox.push(datagram)):
            self._counters.drop("queue_full", path)
        self._retry_later()

    def waiting(self, path: str) -> int:
        """Datagrams that there was no room for yet."""
        return len(self._outboxes.get(path, ()))

    def close(self) -> None:
        """Forget what waits; the socket belongs to the caller."""
        if self._retry is not None:
            self._retry.cancel()
            self._retry = None
        for path, outbox in self._outboxes.items():
            for _ in range(len(outbox)):
                self._counters.drop("closed", path)
        self._outboxes.clear()

    def _try(self, path: str, datagram: bytes) -> bool:
        try:
            self._socket.sendto(datagram, path)
        except BlockingIOError:
            return False
        except OSError as error:
            self._counters.drop("nobody_listens" if error.errno in _NOT_LISTENING else "not_sent", f"{path}: {error}")
            if error.errno in _NOT_LISTENING:
                self._gone(path)
        return True

    def _retry_later(self) -> None:
        if self._retry is None:
            self._retry = asyncio.get_running_loop().call_later(SEND_RETRY_INTERVAL, self._retry_all)

    def _retry_all(self) -> None:
        self._retry = None
        for path, outbox in list(self._outboxes.items()):
            while len(outbox) and self._try(path, outbox.peek()):
                outbox.pop()
            if not len(outbox):
                del self._outboxes[path]
        if self._outboxes:
            self._retry_later()


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
        return bind(path, owner=f"another component {id}", advice="use another id for this one")

    def _listen(self, loop: asyncio.AbstractEventLoop, sock: socket.socket) -> LocalSender:
        self._socket = sock
        sender = self._sender = LocalSender(sock, self._counters, self._lost)
        base.start_reading(loop, sock, self._take, self._failed)
        return sender

    def _leave(self, sock: socket.socket, sender: LocalSender) -> None:
        sender.send(self._node, junior.cancel(self.id))
        sender.close()
        base.stop_reading(asyncio.get_running_loop(), sock)
        clean_up(self.path)

    def _silence(self) -> str:
        """Why the node manager may not answer, and what to do."""
        if (why := refusal(Path(self._node))) is not None:
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


MAX_PATH: Final = 107
"""Longest path of a Unix socket on Linux, in bytes."""


OTHER_DIRECTORY: Final = "choose another directory for the local sockets"

_NO_LISTENER: Final = (errno.ENOENT, errno.ECONNREFUSED)


def is_alive(path: Path) -> bool:
    """True when somebody listens on this socket, and lets this user in."""
    return _probe(path) == 0


def is_dead(path: Path) -> bool:
    """True when nobody listens on this socket; what cannot be found out is false, as with `is_alive`."""
    return _probe(path) in _NO_LISTENER


def refusal(path: Path) -> str | None:
    """One sentence on why this user cannot speak to whoever may listen on `path`; None when nothing stands between."""
    match _probe(path):
        case errno.ENOTDIR:
            return f"{path.parent} is no directory, so it has no local sockets; {OTHER_DIRECTORY}"
        case errno.EACCES | errno.EPERM:
            return f"this user may not use {path}; run as its owner or in its group, or {OTHER_DIRECTORY}"
        case errno.EPROTOTYPE:
            return f"{path} is a socket of another kind; move it, or {OTHER_DIRECTORY}"
        case _:
            return None


def bind(path: Path, *, owner: str, advice: str = OTHER_DIRECTORY, mode: int | None = None) -> socket.socket:
    """A non-blocking socket bound to `path`; raises `TransportError` when it cannot be.

    `owner` is a phrase for who else may be there, and `advice` for what to do then if it shall go on running.
    """
    if len(str(path).encode()) > MAX_PATH:
        raise TransportError(
            f"the socket path {path} is longer than {MAX_PATH} bytes; "
            "choose a directory with a shorter name for the local sockets"
        )
    if is_alive(path):
        raise TransportError(f"{owner} is already running on {path}; stop it, or {advice}")
    if (why := refusal(path)) is not None:
        raise TransportError(why)
    if path.exists() and not path.is_socket():
        raise TransportError(f"{path} is in the way and is no socket; move it, or {OTHER_DIRECTORY}")
    sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        sock.bind(str(path))
        if mode is not None:
            path.chmod(mode)
    except OSError as error:
        sock.close()
        raise TransportError(f"cannot open the socket {path}: {error.strerror}; {OTHER_DIRECTORY}") from error
    return sock


def give_to_group(path: Path, group: str | None) -> None:
    """Let another group own the socket; raises `TransportError` when this user may not."""
    if group is None:
        return
    try:
        shutil.chown(path, group=group)
    except LookupError:
        raise TransportError(f"local_group: there is no group {group!r} on this machine") from None
    except OSError as error:
        raise TransportError(f"local_group: cannot give {path} to {group!r}: {error.strerror}") from error


def clean_up(path: Path) -> None:
    """Remove a socket that nobody listens on; what cannot be removed stays, for whoever binds next."""
    if path.is_socket() and is_dead(path):
        with contextlib.suppress(OSError):
            path.unlink()


def _probe(path: Path) -> int:
    """The error number of an attempt to connect, 0 when it worked."""
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as probe:
            probe.connect(str(path))
    except OSError as error:
        return error.errno or errno.ENAMETOOLONG
    return 0
