"""Which component lives where: one connects, says goodbye, is found dead, or claims what is another's."""

from __future__ import annotations

import logging
from collections.abc import Callable

from jauspy.ids import JausID
from jauspy.protocol import junior
from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.directory import ComponentDirectory, ComponentPort
from jauspy.protocol.outward import Outward
from jauspy.protocol.reports import DuplicateIdLog
from jauspy.protocol.waiting import WaitingRoom

_LOGGER = logging.getLogger(__name__)


class Registrar:
    """Keeps the directory of components; what waited for a new one is delivered.

    `root` is the folder of their sockets; `is_dead` says whether nobody listens on one any more. With `local_udp`,
    components may connect by UDP.
    """

    def __init__(
        self,
        root: str,
        components: ComponentDirectory,
        out: Outward,
        waiting: WaitingRoom,
        counters: Counters,
        *,
        reports: DuplicateIdLog,
        is_dead: Callable[[str], bool],
        local_udp: bool,
    ) -> None:
        self._root = root.rstrip("/")
        self._components = components
        self._out = out
        self._waiting = waiting
        self._counters = counters
        self._reports = reports
        self._is_dead = is_dead
        self._local_udp = local_udp

    def is_local(self, data: bytes, port: UdpPort) -> bool:
        """True for a component of this machine that speaks UDP with its node manager, or begins to."""
        if self._components.has_port(port):
            return True
        return (
            self._local_udp and data[:1] == b"\x01" and port.host.startswith("127.") and junior.parse(data) is not None
        )

    def named(self, port: ComponentPort, id: int) -> ComponentPort:
        """A component without a socket of its own name is answered at its usual path."""
        return port if port[0] else LocalPort(f"{self._root}/{id}")

    def is_taken(self, id: int, *, besides: ComponentPort | None = None) -> bool:
        """True when a component with this id lives elsewhere; one that died without goodbye gives its id up."""
        port = self._components.port(id)
        if port is None or port == besides:
            return False
        if isinstance(port, LocalPort) and self._is_dead(port.path):
            self.unreachable(port)
            return False
        return True

    def unreachable(self, port: ComponentPort) -> None:
        """Nobody listens there any more: its components are gone until they are heard again."""
        for id in self._components.remove_port(port):
            self._counters["components.lost"] += 1
            _LOGGER.info("component %s is gone", JausID.from_int(id))

    def register(self, id: int, port: ComponentPort, *greeting: bytes) -> bool:
        """A component is there; false when there are too many."""
        news = id not in self._components
        if not self._components.register(id, port):
            self._counters.drop("component_refused", JausID.from_int(id))
            return False
        for datagram in greeting:
            self._out.send(port, datagram)
        if news:
            for datagram in self._waiting.found(id):
                self._out.deliver(port, datagram)
        return True

    def control(self, control: junior.Control, port: ComponentPort, now: float) -> None:
        """A component connects, or cancels that."""
        id = int(control.id)
        own = self.named(port, id)
        if control.kind is junior.ControlKind.CONNECT:
            self._connect(control.id, id, own, now)
        elif control.kind is junior.ControlKind.CANCEL and self._components.port(id) == own:
            self._components.remove(id)
            self._counters["cancels"] += 1

    def _connect(self, name: JausID, id: int, own: ComponentPort, now: float) -> None:
        known = self._components.port(id)
        if (
            isinstance(own, UdpPort) and isinstance(known, LocalPort) and self.is_taken(id)
        ):  # any user may send UDP, not any use a socket
            self._counters.drop("duplicate_id", f"{name} from {own}")
            self._reports.twice(id, own, now)
            return
        if known not in (None, own):
            self._reports.moved(id, own, now)
        if self.register(id, own, junior.accept(name)):
            self._counters["connects"] += 1
