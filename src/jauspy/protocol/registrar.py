"""Registration of components: Connect and Cancel of the Junior protocol, dead components, ids that are used twice."""

from __future__ import annotations

import logging
from collections import OrderedDict
from collections.abc import Callable
from typing import Final

from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import junior
from jauspy.protocol.addressing import LocalPort, NetworkPort, Port, UdpPort, format_port
from jauspy.protocol.component_ports import ComponentDirectory, ComponentPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.egress import EgressQueue
from jauspy.protocol.pending import PendingDestinations
from jauspy.protocol.sources import MOVE_TIMEOUT

_LOGGER = get_logger(__name__)

MAX_LOGGED_CASES: Final = 256
"""Cases remembered as logged; when an attacker forges more, the oldest are logged again."""


class Registrar:
    """Keeps the directory of components; messages that were pending for a new component are delivered.

    `root` is the directory of their sockets; `is_dead(path)` is true when nobody listens on a socket any more. With
    `local_udp`, components may connect by UDP, from ports for which `may_connect(port)` is true. `holder(id, now)` is
    the address on a network that has this id.
    """

    def __init__(
        self,
        root: str,
        components: ComponentDirectory,
        egress: EgressQueue,
        pending: PendingDestinations,
        counters: Counters,
        *,
        duplicate_ids: DuplicateIdLog,
        is_dead: Callable[[str], bool],
        local_udp: bool,
        may_connect: Callable[[UdpPort], bool],
        holder: Callable[[int, float], NetworkPort | None],
    ) -> None:
        self._root = root.rstrip("/")
        self._components = components
        self._egress = egress
        self._pending = pending
        self._counters = counters
        self._duplicate_ids = duplicate_ids
        self._is_dead = is_dead
        self._local_udp = local_udp
        self._may_connect = may_connect
        self._holder = holder

    def is_local(self, port: UdpPort, control: junior.Control | None) -> bool:
        """True for a component of this machine that uses UDP, or connects by it."""
        if self._components.has_port(port):
            return True
        return control is not None and self._local_udp and port.host.startswith("127.")

    def reply_port(self, port: ComponentPort, id: int) -> ComponentPort:
        """The port of a component; one that sends from an unnamed socket listens on its usual path."""
        return port if port[0] else LocalPort(f"{self._root}/{id}")

    def is_in_use(self, id: int, *, elsewhere_than: ComponentPort | None = None) -> bool:
        """True when a live component has this id; one that ended without Cancel is removed."""
        port = self._components.port(id)
        if port is None or port == elsewhere_than:
            return False
        if isinstance(port, LocalPort) and self._is_dead(port.path):
            self.remove_dead(port)
            return False
        return True

    def remove_dead(self, port: ComponentPort) -> None:
        """Remove the components of a port where nobody listens any more."""
        for id in self._components.remove_port(port):
            self._counters["components.lost"] += 1
            _LOGGER.info("component %s is gone", JausID.from_int(id))

    def register(self, id: int, port: ComponentPort, now: float, reply: bytes | None = None) -> bool:
        """Register a component and send it `reply`; false, and counted, when it is not accepted.

        The Junior protocol has no negative answer: its clients take any message of a node manager for an Accept.
        """
        is_new = id not in self._components
        if is_new and (holder := self._holder(id, now)) is not None:
            self._counters.drop("id_taken", f"{JausID.from_int(id)} at {format_port(port)}")
            self._duplicate_ids.warn_taken(id, port, holder)
            return False
        if not self._components.register(id, port):
            self._counters.drop("component_refused", JausID.from_int(id))
            return False
        if reply is not None:
            self._egress.send(port, reply)
        if is_new:
            for datagram in self._pending.pop(id, now):
                self._egress.deliver(port, datagram)
        return True

    def handle_control(self, control: junior.Control, port: ComponentPort, now: float) -> None:
        """Handle a Connect or a Cancel."""
        id = int(control.id)
        own = self.reply_port(port, id)
        if control.kind is junior.ControlKind.CONNECT:
            self._connect(control.id, id, own, now)
        elif control.kind is junior.ControlKind.CANCEL and self._components.port(id) == own:
            self._components.remove(id)
            self._counters["cancels"] += 1

    def _connect(self, name: JausID, id: int, own: ComponentPort, now: float) -> None:
        known = self._components.port(id)
        if isinstance(own, UdpPort) and not self._may_connect(own):
            self._counters.drop("not_permitted", f"{name} from {format_port(own)}")
            self._duplicate_ids.warn_not_permitted(id, own)
            return
        if (
            isinstance(own, UdpPort) and isinstance(known, LocalPort) and self.is_in_use(id)
        ):  # any user may send UDP, not any use a socket
            self._counters.drop("duplicate_id", f"{name} from {own}")
            self._duplicate_ids.warn_duplicate(id, own)
            return
        if known not in (None, own):
            self._duplicate_ids.log_move(id, own)
        if self.register(id, own, now, junior.accept(name)):
            self._counters["connects"] += 1


class DuplicateIdLog:
    """Log lines about ids in use twice: one per id and host or local socket."""

    def __init__(self, logger: logging.Logger) -> None:
        self._logger = logger
        self._logged: OrderedDict[tuple[int, str], None] = OrderedDict()

    def warn_duplicate(self, id: int, port: Port) -> None:
        """A packet from `port` has the id of a component that is registered here."""
        if self._is_new(id, port):
            self._logger.warning(
                "duplicate id %s: it belongs to a component of this machine, and packets from %s have it too; "
                "these packets are dropped",
                JausID.from_int(id),
                format_port(port),
            )

    def warn_taken(self, id: int, port: Port, holder: Port) -> None:
        """A program of this machine wants to be a component with the id of one on a network."""
        if self._is_new(id, port):
            self._logger.warning(
                "id %s is in use at %s; %s is not accepted with it until that is silent for %d s",
                JausID.from_int(id),
                format_port(holder),
                format_port(port),
                MOVE_TIMEOUT,
            )

    def warn_not_permitted(self, id: int, port: Port) -> None:
        """A user who may not use the local socket tries to connect by UDP."""
        if self._is_new(id, port):
            self._logger.warning(
                "component %s may not connect from %s: its user may not use the local socket (local_mode, local_group)",
                JausID.from_int(id),
                format_port(port),
            )

    def log_move(self, id: int, port: Port) -> None:
        """A component has connected whose id was registered elsewhere."""
        if self._is_new(id, port):
            self._logger.info("component %s is now on %s", JausID.from_int(id), format_port(port))

    def _is_new(self, id: int, port: Port) -> bool:
        key = (id, port.path if isinstance(port, LocalPort) else port[0])
        if key in self._logged:
            return False
        self._logged[key] = None
        if len(self._logged) > MAX_LOGGED_CASES:
            self._logged.popitem(last=False)
        return True
