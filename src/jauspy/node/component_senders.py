"""Sends to components: a socket and a bounded queue for each, so that a slow one does not delay others."""

from __future__ import annotations

import asyncio
import errno
import os
import socket
import stat
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Final

from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.node import back_pressure
from jauspy.node.back_pressure import BackPressure
from jauspy.node.liveness import MAX_ID, ComponentSockets
from jauspy.protocol import junior
from jauspy.protocol.address_book import ComponentPort
from jauspy.protocol.addressing import LocalPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.routing import Router
from jauspy.transport import local
from jauspy.transport.age import MAX_AGE
from jauspy.transport.send_queue import QueueMemory, SendQueue

_LOG = get_logger(__name__)

SEND_BURST: Final = 64
"""Datagrams sent from a queue before others get their turn."""
RETRY_EVERY: Final = 8
"""Queued datagrams after which sending is tried without waiting for a writable socket. In a flood that would take too
long: the ten datagrams that a component's socket holds are read long before the event loop gets its turn."""

_NOT_LISTENING: Final = (errno.ECONNREFUSED, errno.ENOENT, errno.ENOTCONN)


def not_writable(path: Path) -> str:
    """An error text for a component whose socket this user may not write to."""
    name = JausID.from_int(int(path.name)) if path.name.isdecimal() and int(path.name) <= MAX_ID else path
    me = local.user_name(os.geteuid())
    try:
        found = path.stat()
    except OSError:
        whose, owner = "", "its user"
    else:
        owner = local.user_name(found.st_uid)
        whose = f" (user {owner}, group {local.group_name(found.st_gid)}, mode {stat.S_IMODE(found.st_mode):03o})"
    return (
        f"component {name} receives nothing: this node manager, which runs as {me}, may not write to its socket "
        f"{path}{whose}; start the component with `umask 002` in a group of {me}, or with `umask 000`, or run the "
        f"node manager as {owner}; until then, `chmod o+w {path}` helps"
    )


class ComponentSender:
    """Sends to one component by a connected socket, with a queue for datagrams that the component has no room for.

    An unread datagram occupies the receive queue of the component and the send buffer of its sender. With one socket
    for all, a component that stops reading would block the others as soon as that buffer is full.
    `on_unbound(path)` is called when nobody listens on the socket any more. While the queue is long, `back_pressure`
    may have those who send wait.
    """

    def __init__(
        self,
        path: str,
        counters: Counters,
        on_unbound: Callable[[str], None],
        *,
        max_age: float = MAX_AGE,
        memory: QueueMemory | None = None,
        back_pressure: BackPressure | None = None,
    ) -> None:
        self._path = path
        self._back_pressure = back_pressure
        self._counters = counters
        self._on_unbound = on_unbound
        self._loop = asyncio.get_running_loop()
        self._socket: socket.socket | None = None
        self.fast_path: Callable[[bytes], object] | None = None
        """The socket's `send`; only while it is connected and the queue is empty. After an error, call `slow_path`."""
        self._queue = SendQueue(max_age=max_age, memory=memory)
        self._watched = False
        self._since_attempt = 0
        self._is_refusal_logged = False

    def __len__(self) -> int:
        return len(self._queue)

    def send(self, datagram: bytes) -> None:
        """Send now, or as soon as the component reads; what the queue has no room for is dropped and counted."""
        if self.fast_path is not None:
            try:
                self.fast_path(datagram)
            except OSError:
                self.slow_path(datagram)
        else:
            self.slow_path(datagram)

    def reconnect(self) -> None:
        """Connect again: a new component may have a new socket of the same name."""
        self._disconnect()
        if self._queue:
            self._drain()

    @property
    def queued_bytes(self) -> int:
        """The bytes of the queued datagrams."""
        return self._queue.bytes

    def close(self) -> None:
        """Close the socket, and count queued datagrams as dropped; a second call does nothing."""
        self._disconnect()
        for _ in range(self._queue.clear()):
            self._counters.drop("component_gone", self._path)
        if self._back_pressure is not None:
            self._back_pressure.forget(self._path)

    def slow_path(self, datagram: bytes) -> None:
        """Send by the queue, or by a new connection."""
        if not self._queue:
            if self._try(datagram):
                return
            self._wait_until_writable()
        for _ in self._queue.push(datagram):
            self._counters.drop("queue_full", self._path)
        self._since_attempt += 1
        if self._since_attempt == RETRY_EVERY:
            self._drain()
        if self._back_pressure is not None and len(self._queue) > back_pressure.HIGH_WATER:
            self._back_pressure.congested(self._path)

    def _drain(self) -> None:
        self._since_attempt = 0
        for _ in range(self._queue.drop_stale()):
            self._counters.drop("stale", self._path)
        try:
            if self._socket is not None:
                self._queue.drain(self._socket.send, SEND_BURST)
        except BlockingIOError:
            self._report_relief()
            return
        except OSError:
            self._disconnect()
        if self._queue and self._socket is None and self._try(self._queue.peek()) and self._queue:
            self._queue.pop()
        if self._queue:
            self._wait_until_writable()
        elif self._socket is not None:
            self._stop_watching(self._socket)
            self.fast_path = self._socket.send
        self._report_relief()

    def _report_relief(self) -> None:
        if self._back_pressure is not None and len(self._queue) <= back_pressure.LOW_WATER:
            self._back_pressure.relieved(self._path)

    def _wait_until_writable(self) -> None:
        self.fast_path, self._since_attempt = None, 0
        if self._socket is not None and not self._watched:
            self._loop.add_writer(self._socket.fileno(), self._drain)
            self._watched = True

    def _stop_watching(self, sock: socket.socket) -> None:
        if self._watched:
            self._loop.remove_writer(sock.fileno())
            self._watched = False

    def _try(self, datagram: bytes) -> bool:
        """False when the socket is full; true when it was sent, or is lost because the component is dead."""
        try:
            self._attempt(datagram)
        except BlockingIOError:
            return False
        except OSError as error:
            self._lost(error)
        return True

    def _attempt(self, datagram: bytes) -> None:
        if self._socket is not None:
            try:
                self._socket.send(datagram)
            except OSError as error:
                if error.errno not in _NOT_LISTENING:
                    raise
                self._disconnect()
            else:
                return
        self._connect().send(datagram)

    def _lost(self, error: OSError) -> None:
        if error.errno in (errno.EACCES, errno.EPERM) and not self._is_refusal_logged:
            self._is_refusal_logged = True
            _LOG.warning("%s", not_writable(Path(self._path)))
        no_component = error.errno in (*_NOT_LISTENING, errno.ELOOP)
        self._counters.drop("component_gone" if no_component else "local_send", error)
        if no_component:
            if self._queue:
                self._queue.pop()  # which was counted just now
            self.close()
            self._on_unbound(self._path)

    def _connect(self) -> socket.socket:
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        try:
            sock.setblocking(False)
            local.connect(sock, self._path)
        except OSError:
            sock.close()
            raise
        self._socket = sock
        if not self._queue:
            self.fast_path = sock.send
        return sock

    def _disconnect(self) -> None:
        sock, self._socket, self.fast_path = self._socket, None, None
        if sock is not None:
            self._stop_watching(sock)
            sock.close()


class ComponentSenders:
    """The senders of all components, by the path of their socket; the router removes dead components.

    A sender is made when it is first needed, and closed when its component has ended.
    """

    def __init__(self, sockets: ComponentSockets, router: Router, max_age: float, memory: QueueMemory) -> None:
        self._sockets = sockets
        self._router = router
        self._max_age = max_age
        self._memory = memory
        self.back_pressure: BackPressure | None = None
        """Has components wait for others; None for none. To be set before senders are made."""
        self._senders: dict[str, ComponentSender] = {}

    @property
    def queued(self) -> Mapping[str, int]:
        """The number of queued datagrams of each component."""
        return {path: len(sender) for path, sender in self._senders.items()}

    @property
    def queued_bytes(self) -> Mapping[str, int]:
        """The bytes of these datagrams."""
        return {path: sender.queued_bytes for path, sender in self._senders.items()}

    def send(self, path: str, datagram: bytes) -> None:
        """Send to a component; a control message of the Junior protocol goes to a socket that may be new."""
        sender = self.sender_for(path)
        if junior.parse(datagram) is not None:
            sender.reconnect()
        sender.send(datagram)

    def sender_for(self, path: str) -> ComponentSender:
        """The sender for this path."""
        sender = self._senders.get(path)
        if sender is None:
            self._remove_cancelled()
            sender = self._senders[path] = ComponentSender(
                path,
                self._router.counters,
                self._on_unbound,
                max_age=self._max_age,
                memory=self._memory,
                back_pressure=self.back_pressure,
            )
        return sender

    def group(self, paths: Iterable[str]) -> Callable[[bytes], None]:
        """A function that sends to all of these components; valid until one of them is removed."""
        senders = tuple(map(self.sender_for, paths))

        def send(datagram: bytes) -> None:
            for sender in senders:
                fast_path = sender.fast_path
                if fast_path is None:
                    sender.slow_path(datagram)
                    continue
                try:
                    fast_path(datagram)
                except OSError:
                    sender.slow_path(datagram)

        return send

    def remove_dead(self, port: ComponentPort) -> None:
        """Remove a component that is dead and whose socket is removed."""
        if isinstance(port, LocalPort) and (sender := self._senders.pop(port.path, None)) is not None:
            sender.close()
        self._router.remove_dead(port)

    def close(self) -> None:
        """Close all senders; a second call does nothing."""
        for sender in self._senders.values():
            sender.close()
        self._senders.clear()

    def _on_unbound(self, path: str) -> None:
        self._senders.pop(path, None)
        self._router.remove_dead(LocalPort(path))
        self._sockets.remove(path)

    def _remove_cancelled(self) -> None:
        alive = {port.path for _, port in self._router.components if isinstance(port, LocalPort)}
        for path in [path for path in self._senders if path not in alive]:
            self._senders.pop(path).close()
