"""The ways to all components with local sockets: made when first needed, closed when the component is gone."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from jauspy.node.mailbox import Mailbox
from jauspy.protocol import junior
from jauspy.protocol.addressing import LocalPort
from jauspy.transport import local_socket

if TYPE_CHECKING:
    from jauspy.protocol.directory import ComponentPort
    from jauspy.protocol.routing import Router


class Mailboxes:
    """By the path of the component's socket. The core is told of components that nobody listens for any more."""

    def __init__(self, root: Path, core: Router) -> None:
        self._root = root
        self._core = core
        self._by_path: dict[str, Mailbox] = {}

    @property
    def waiting(self) -> Mapping[str, int]:
        """Datagrams that wait for each component."""
        return {path: len(mailbox) for path, mailbox in self._by_path.items()}

    def send(self, path: str, datagram: bytes) -> None:
        """To this component; a message of Junior itself goes to a socket that may be a new one."""
        mailbox = self.of(path)
        if junior.parse(datagram) is not None:
            mailbox.refresh()
        mailbox.send(datagram)

    def of(self, path: str) -> Mailbox:
        """The way to this component."""
        mailbox = self._by_path.get(path)
        if mailbox is None:
            self._forget_cancelled()
            mailbox = self._by_path[path] = Mailbox(path, self._core.counters, self._gone)
        return mailbox

    def buried(self, port: ComponentPort) -> None:
        """The component is dead, and its socket gone."""
        if isinstance(port, LocalPort) and (mailbox := self._by_path.pop(port.path, None)) is not None:
            mailbox.close()
        self._core.remove_dead(port)

    def close(self) -> None:
        """Close all; twice is fine."""
        for mailbox in self._by_path.values():
            mailbox.close()
        self._by_path.clear()

    def _gone(self, path: str) -> None:
        self._by_path.pop(path, None)
        self._core.remove_dead(LocalPort(path))
        bury(self._root, path)

    def _forget_cancelled(self) -> None:
        alive = {port.path for _, port in self._core.components if isinstance(port, LocalPort)}
        for path in [path for path in self._by_path if path not in alive]:
            self._by_path.pop(path).close()


def is_dead(root: Path, path: str) -> bool:
    """True when nobody listens there any more; what is left of the socket is removed."""
    if not local_socket.is_dead(Path(path)):
        return False
    bury(root, path)
    return True


def bury(root: Path, path: str) -> None:
    """Remove the socket that a component has left behind, when its name says that it is one's."""
    socket_path = Path(path)
    if socket_path.parent == root and socket_path.name.isdecimal():
        local_socket.clean_up(socket_path)
