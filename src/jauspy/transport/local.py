"""Local sockets: a component's transport to the node manager of its machine (the Junior local protocol)."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import grp
import os
import pwd
import shutil
import socket
import stat
from collections.abc import Callable, Collection, Mapping
from pathlib import Path
from typing import Final, Self

from jauspy.beats import next_beat
from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import junior
from jauspy.protocol.addressing import Location
from jauspy.protocol.counters import Counters
from jauspy.transport import base, node_status
from jauspy.transport.age import MAX_AGE, DatagramReader
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.node_status import Locator
from jauspy.transport.send_queue import SendQueue
from jauspy.transport.socket_filter import set_filter

_LOG = get_logger(__name__)

CONNECT_INTERVAL: Final = 0.025
"""Seconds between Connects until the node manager accepts, as in its own clients."""
RECONNECT_INTERVAL: Final = 0.25
"""Seconds between Connects when the node manager has not answered for a while."""
KEEP_ALIVE_INTERVAL: Final = 1.0
"""Seconds between Connects while connected; node managers answer each, so that a dead one is detected."""
MAX_UNANSWERED: Final = 2
"""Unanswered keep-alives after which the node manager is regarded as dead."""
REFUSED_AFTER: Final = 5.0
"""Seconds without an Accept of a node manager that is alive, after which the log gives possible reasons."""
SEND_RETRY_INTERVAL: Final = 0.002
"""Seconds until sending to a full socket is retried; a datagram socket does not signal when its peer has room."""
MAX_PATH: Final = 107
"""Longest path of a Unix socket on Linux, in bytes."""
OTHER_DIRECTORY: Final = "choose another directory for the local sockets"
_NO_LISTENER: Final = (errno.ENOENT, errno.ECONNREFUSED)


class LocalTransport:
    """Sends to `<root>/JuniorRTE`, listens on `<root>/<id in decimal>`.

    It reconnects when the node manager restarts. `open` waits at most `timeout` seconds for the node manager, or not at
    all with None.
    """

    def __init__(self, id: JausID, root: Path = Path("/tmp"), *, timeout: float | None = 2.0) -> None:  # noqa: S108 # nosec B108
        self.id = id
        self.received: Receiver = ignore
        self.max_age = MAX_AGE
        self._root = Path(root)
        self._node = str(self._root / junior.SOCKET_NAME)
        self._timeout = timeout
        self._counters = Counters(_LOG)
        self._socket: socket.socket | None = None
        self._sender: LocalSender | None = None
        self._keep_alive: asyncio.Task[None] | None = None
        self._locator = Locator(self._root)
        self._accepted = asyncio.Event()
        self._loss = asyncio.Event()
        self._unanswered = 0
        self._left_out: Collection[int] = ()

    @property
    def path(self) -> Path:
        """The path of the component's socket."""
        return self._path(self.id)

    @property
    def connected(self) -> bool:
        """True while the node manager answers."""
        return self._accepted.is_set()

    @property
    def waiting(self) -> int:
        """Datagrams that the node manager has not read yet."""
        return 0 if self._sender is None else self._sender.waiting(self._node)

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""
        return self._counters

    async def open(self) -> None:
        """Bind the component's socket and connect; raises `TransportError` when no node manager answers."""
        loop = asyncio.get_running_loop()
        self._listen(loop, self._bind(self.id))
        self._keep_alive = loop.create_task(self._keep_connected(), name=f"keep {self.id} connected")
        if self._timeout is not None:
            try:
                async with asyncio.timeout(self._timeout):
                    await self._accepted.wait()
            except BaseException as error:
                await self.close()
                if not isinstance(error, TimeoutError):
                    raise
                raise TransportError(self._no_answer()) from None

    async def close(self) -> None:
        """Send Cancel, and remove the component's socket."""
        self._locator.close()
        sock, sender, keep_alive = self._socket, self._sender, self._keep_alive
        self._socket = self._sender = self._keep_alive = None
        if sock is None or sender is None or keep_alive is None:
            return
        keep_alive.cancel()
        await asyncio.gather(keep_alive, return_exceptions=True)
        self._disconnect(sock, sender)
        self._accepted.clear()

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Listen on another socket and register with the new id; raises `TransportError` when it is in use."""
        old, sender = self._socket, self._sender
        if old is None or sender is None:
            self.id = id
            return
        new = self._bind(id)
        on_leave()
        self._disconnect(old, sender)
        self.id = id
        self._listen(asyncio.get_running_loop(), new).send(self._node, junior.connect(id))
        self._accepted.clear()
        self._loss.set()  # the keep-alive task continues until it is accepted

    def send(self, datagram: bytes) -> None:
        """Send a datagram to the node manager; while its socket is full, datagrams wait in a bounded queue."""
        if self._sender is None:
            self._counters.drop("closed")
            return
        self._counters["sent"] += 1
        self._sender.send(self._node, datagram)

    def locate(self, id: JausID, found: Callable[[Location], None]) -> None:
        """Call `found`, now or later, with the machine of a component, from the node manager's status."""
        self._locator.locate(id, found, is_here=is_alive(self._path(id)))

    def leave_out_broadcasts(self, codes: Collection[int]) -> None:
        """Let the kernel drop broadcasts with these message ids, on Linux; they are not counted."""
        self._left_out = codes
        if self._socket is not None:
            set_filter(self._socket, codes)

    async def id_clash(self) -> str | None:
        """The address of another machine that uses this id, from the node manager's status."""
        try:
            status = await node_status.read(self._root)
        except TransportError:  # a node manager of others, or none
            return None
        return next((str(clash["address"]) for clash in status.get("clashes", ()) if clash["id"] == str(self.id)), None)

    def _path(self, id: JausID) -> Path:
        return self._root / str(int(id))

    def _bind(self, id: JausID) -> socket.socket:
        path = self._path(id)
        return bind(path, owner=f"another component {id}", advice="use another id for this one")

    def _listen(self, loop: asyncio.AbstractEventLoop, sock: socket.socket) -> LocalSender:
        self._socket = sock
        if self._left_out:
            set_filter(sock, self._left_out)
        sender = self._sender = LocalSender(sock, self._counters, self._lost, self.max_age)
        reader = DatagramReader(sock, self._counters, self.max_age)
        base.start_reading(loop, reader, self._take, self._failed)
        return sender

    def _disconnect(self, sock: socket.socket, sender: LocalSender) -> None:
        sender.send(self._node, junior.cancel(self.id))
        sender.close()
        base.stop_reading(asyncio.get_running_loop(), sock)
        clean_up(self.path)

    def _no_answer(self) -> str:
        """Explain why the node manager may not have answered, and what to do."""
        if (why := refusal(Path(self._node))) is not None:
            return why
        if is_alive(Path(self._node)):
            return (
                f"the node manager on {self._node} does not accept {self.id}: another host uses this id, it has no "
                "room for more components, or the processors are too busy; its log and 'jauspy node-manager --status "
                f"--local-root {self._root}' tell"
            )
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
        loop = asyncio.get_running_loop()
        accepted_at, is_logged = loop.time(), False
        while self._sender is not None:
            if self.connected:
                accepted_at, is_logged = loop.time(), False
            elif not is_logged and loop.time() - accepted_at > REFUSED_AFTER and is_alive(Path(self._node)):
                is_logged = True
                _LOG.warning("%s", self._no_answer())
            if self.connected and self._unanswered >= MAX_UNANSWERED:
                self._accepted.clear()
            if self.connected:
                interval = CONNECT_INTERVAL
            self._unanswered += 1
            self._sender.send(self._node, junior.connect(self.id))
            self._loss.clear()
            now = loop.time()
            due = next_beat(now, KEEP_ALIVE_INTERVAL, self.id.subsystem) if self.connected else now + interval
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout_at(due):
                    await self._loss.wait()
            if not self.connected:
                interval = min(interval * 1.3, RECONNECT_INTERVAL)


class LocalSender:
    """Sends on one socket to any path, with a bounded queue per path.

    `on_unbound(path)` is called when nobody listens on a path.
    """

    def __init__(
        self, sock: socket.socket, counters: Counters, on_unbound: Callable[[str], None], max_age: float = MAX_AGE
    ) -> None:
        self._socket = sock
        self._max_age = max_age
        self._counters = counters
        self._on_unbound = on_unbound
        self._queues: dict[str, SendQueue] = {}
        self._retry: asyncio.TimerHandle | None = None

    def send(self, path: str, datagram: bytes) -> None:
        """Send now, or as soon as there is room. Never blocks, never raises; dropped datagrams are counted."""
        queue = self._queues.get(path)
        if queue is None:
            if self._try(path, datagram):
                return
            queue = self._queues[path] = SendQueue(max_age=self._max_age)
        for _ in queue.push(datagram):
            self._counters.drop("queue_full", path)
        self._retry_later()

    def waiting(self, path: str) -> int:
        """The number of queued datagrams."""
        return len(self._queues.get(path, ()))

    def close(self) -> None:
        """Drop the queued datagrams; the socket belongs to the caller."""
        if self._retry is not None:
            self._retry.cancel()
            self._retry = None
        for path, queue in self._queues.items():
            for _ in range(len(queue)):
                self._counters.drop("closed", path)
        self._queues.clear()

    def _try(self, path: str, datagram: bytes) -> bool:
        try:
            self._socket.sendto(datagram, path)
        except BlockingIOError:
            return False
        except OSError as error:
            self._counters.drop("nobody_listens" if error.errno in _NO_LISTENER else "not_sent", f"{path}: {error}")
            if error.errno in _NO_LISTENER:
                self._on_unbound(path)
        return True

    def _retry_later(self) -> None:
        if self._retry is None:
            self._retry = asyncio.get_running_loop().call_later(SEND_RETRY_INTERVAL, self._retry_all)

    def _retry_all(self) -> None:
        self._retry = None
        for path, queue in list(self._queues.items()):
            for _ in range(queue.drop_stale()):
                self._counters.drop("stale", path)
            while len(queue) and self._try(path, queue.peek()):
                queue.pop()
            if not len(queue):
                del self._queues[path]
        if self._queues:
            self._retry_later()


class SocketProbe:
    """Finds out whether somebody listens on a local socket; needs no further descriptor, and never blocks."""

    def __init__(self) -> None:
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def error(self, path: Path) -> int:
        """The error number of an attempt to connect; 0 for success."""
        try:
            self._socket.connect(str(path))
        except OSError as error:
            return error.errno or errno.ENAMETOOLONG
        return 0

    def is_dead(self, path: Path) -> bool:
        """True when nobody listens on this socket; false when that cannot be found out."""
        return self.error(path) in _NO_LISTENER

    def clean_up(self, path: Path) -> None:
        """Remove a socket that nobody listens on; one that cannot be removed remains."""
        if path.is_socket() and self.is_dead(path):
            with contextlib.suppress(OSError):
                path.unlink()

    def close(self) -> None:
        """Give up the descriptor; a second call does nothing."""
        self._socket.close()


def is_alive(path: Path) -> bool:
    """True when a process listens on this socket, and this user may send to it."""
    return _probe(path) == 0


def is_dead(path: Path) -> bool:
    """Same as `SocketProbe.is_dead`."""
    return _probe(path) in _NO_LISTENER


def refusal(path: Path) -> str | None:
    """Sentence that says why this user cannot send to `path`; None when nothing prevents it."""
    return _refusal(path, _probe(path))


def _refusal(path: Path, error: int) -> str | None:
    match error:
        case errno.ENOTDIR:
            return f"{path.parent} is not a directory; {OTHER_DIRECTORY}"
        case errno.EACCES | errno.EPERM:
            return f"this user may not use {path}; run as its owner or in its group, or {OTHER_DIRECTORY}"
        case errno.EPROTOTYPE:
            return f"{path} is a socket of another kind; move it, or {OTHER_DIRECTORY}"
        case errno.EMFILE | errno.ENFILE:
            return f"cannot find out who uses {path}: {os.strerror(error)}; raise the limit (ulimit -n)"
        case _:
            return None


def bind(path: Path, *, owner: str, advice: str = OTHER_DIRECTORY, mode: int | None = None) -> socket.socket:
    """A non-blocking socket bound to `path`; raises `TransportError`.

    `owner` names the program that may already listen there, `advice` is what to do to keep that program running.
    """
    if len(str(path).encode()) > MAX_PATH:
        raise TransportError(
            f"the socket path {path} is longer than {MAX_PATH} bytes; "
            "choose a directory with a shorter name for the local sockets"
        )
    found = _probe(path)
    if found == 0:
        raise TransportError(f"{owner} is already running on {path}; stop it, or {advice}")
    if (why := _refusal(path, found)) is not None:
        raise TransportError(why)
    if path.exists() and not path.is_socket():
        raise TransportError(f"{path} exists and is not a socket; move it, or {OTHER_DIRECTORY}")
    with contextlib.ExitStack() as stack:
        try:
            sock = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
            sock.setblocking(False)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.unlink(missing_ok=True)
            sock.bind(str(path))
            if mode is not None:
                path.chmod(mode)
        except OSError as error:
            raise TransportError(f"cannot open the socket {path}: {error.strerror}; {OTHER_DIRECTORY}") from error
        stack.pop_all()
    return sock


def check_directory(root: Path) -> None:
    """Make the directory, if it does not exist; raises `TransportError` if another user could replace its sockets."""
    with contextlib.suppress(OSError):  # which `bind` reports
        root.mkdir(parents=True, exist_ok=True)
    try:
        link, found = root.lstat(), root.stat()
    except OSError:
        return
    for status in (link, found):
        if status.st_uid not in (os.geteuid(), 0):
            raise TransportError(
                f"{root} belongs to another user ({user_name(status.st_uid)}), who could replace the local sockets; "
                f"{OTHER_DIRECTORY}, or run as this user"
            )
    if found.st_mode & stat.S_IWOTH and not found.st_mode & stat.S_ISVTX:
        raise TransportError(f"all users could replace the local sockets in {root}; do: chmod +t {root}")


def connect(sock: socket.socket, path: str) -> None:
    """Connect to the socket that was bound as `path`; raises `OSError`, with `ELOOP` if a link leads to another one.

    Only the directory of a component's usual path, which ends in its id, may be written differently.
    """
    sock.connect(path)
    bound, name = sock.getpeername(), Path(path).name
    if bound != path and not (name.isdecimal() and isinstance(bound, str) and Path(bound).name == name):
        raise OSError(errno.ELOOP, f"{path} leads to the socket of another program")


def give_to_group(path: Path, group: str | None) -> None:
    """Change the group of the socket; raises `TransportError` if this user may not."""
    if group is None:
        return
    try:
        shutil.chown(path, group=group)
    except LookupError:
        raise TransportError(f"local_group: there is no group {group!r} on this machine") from None
    except OSError as error:
        raise TransportError(f"local_group: cannot give {path} to {group!r}: {error.strerror}") from error


def listen(path: Path, mode: int, group: str | None, *, setting: str) -> socket.socket:
    """A listening stream socket at a path, for its group; the error names the setting that does without it."""
    with contextlib.ExitStack() as stack:
        try:
            sock = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_STREAM))
            path.unlink(missing_ok=True)
            sock.bind(str(path))
            path.chmod(mode)
            sock.listen()
        except OSError as error:
            problem = f"cannot open the socket {path}: {error.strerror}"
            raise TransportError(f"{problem}; {OTHER_DIRECTORY}, or set `{setting}` to false") from error
        give_to_group(path, group)
        stack.pop_all()
    return sock


def clean_up(path: Path) -> None:
    """Same as `SocketProbe.clean_up`; does nothing without a descriptor for the probe."""
    with contextlib.suppress(OSError), SocketProbe() as probe:
        probe.clean_up(path)


def user_name(user: int) -> str:
    """The name of a user, or the number of one without a name."""
    try:
        return pwd.getpwuid(user).pw_name
    except KeyError:
        return str(user)


def group_name(group: int) -> str:
    """The name of a group, or the number of one without a name."""
    try:
        return grp.getgrgid(group).gr_name
    except KeyError:
        return str(group)


def _probe(path: Path) -> int:
    """The error number of an attempt to connect, or to make a socket for it; 0 for success."""
    try:
        with SocketProbe() as probe:
            return probe.error(path)
    except OSError as error:
        return error.errno or errno.EMFILE
