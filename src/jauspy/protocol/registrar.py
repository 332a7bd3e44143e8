"""Registration of components: Connect and Cancel of the Junior protocol, dead components, ids that are used twice."""

from __future__ import annotations

import logging
from collections import OrderedDict
from collections.abc import Callable, Iterator
from typing import Final, NamedTuple

from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import judp, junior
from jauspy.protocol.address_book import ComponentDirectory, ComponentPort
from jauspy.protocol.addressing import LocalPort, NetworkPort, Port, UdpPort, format_port
from jauspy.protocol.counters import Counters
from jauspy.protocol.egress import EgressQueue
from jauspy.protocol.header import Ack, Packet
from jauspy.protocol.pending import PendingDestinations
from jauspy.protocol.sources import MOVE_TIMEOUT, TokenBuckets

_LOG = get_logger(__name__)

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

    def is_local(self, port: UdpPort, control: junior.ControlMessage | None) -> bool:
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
            _LOG.info("component %s has ended without Cancel", JausID.from_int(id))

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

    def handle_control(self, control: junior.ControlMessage, port: ComponentPort, now: float) -> None:
        """Handle a Connect or a Cancel."""
        id = int(control.id)
        component = self.reply_port(port, id)
        if control.kind is junior.ControlKind.CONNECT:
            self._connect(control.id, id, component, now)
        elif control.kind is junior.ControlKind.CANCEL and self._components.port(id) == component:
            self._components.remove(id)
            self._counters["cancels"] += 1

    def _connect(self, name: JausID, id: int, component: ComponentPort, now: float) -> None:
        known = self._components.port(id)
        if isinstance(component, UdpPort) and not self._may_connect(component):
            self._counters.drop("not_permitted", f"{name} from {format_port(component)}")
            self._duplicate_ids.warn_not_permitted(id, component)
            return
        if (
            isinstance(component, UdpPort) and isinstance(known, LocalPort) and self.is_in_use(id)
        ):  # any user may send UDP, not any use a socket
            self._counters.drop("duplicate_id", f"{name} from {component}")
            self._duplicate_ids.warn_duplicate(id, component)
            return
        if known not in (None, component):
            self._duplicate_ids.log_move(id, component)
        if self.register(id, component, now, junior.accept(name)):
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
        """A program of this machine tries to register an id that a component on a network uses."""
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


MAX_CLASHES: Final = 64
"""Ids that are remembered; the oldest is forgotten."""
CLASH_LIFETIME: Final = 30.0
"""Seconds after its last packet for which the other machine is remembered."""
NOTICE_INTERVAL: Final = 2.0
"""Seconds between two notices about one id."""
NOTICES_PER_SECOND: Final = 10.0
"""Notices about all ids together, so that forged packets cause few."""


class _Clash(NamedTuple):
    port: NetworkPort
    last: float
    notified: float


class IdClashes:
    """Sans-I/O; ids are 32-bit numbers. Both machines note a clash as soon as one hears the other."""

    def __init__(self) -> None:
        self._clashes: OrderedDict[int, _Clash] = OrderedDict()
        self._notices = TokenBuckets(NOTICES_PER_SECOND, NOTICES_PER_SECOND)

    def note(self, id: int, port: NetworkPort, now: float, *, is_notice: bool = False) -> bytes | None:
        """Note a packet from `port` with the id of a component of this machine; returns a notice for that machine.

        The notice is an ACK of the id to itself, which has no effect but that the other machine notes the clash, too.
        With `is_notice` the packet is one, and is not answered.
        """
        known = self._clashes.pop(id, None)
        is_due = known is None or now - known.notified >= NOTICE_INTERVAL
        is_sent = is_due and not is_notice and self._notices.take(None, now)
        self._clashes[id] = _Clash(port, now, now if is_sent or known is None else known.notified)
        if len(self._clashes) > MAX_CLASHES:
            self._clashes.popitem(last=False)
        jaus_id = JausID.from_int(id)
        return judp.pack(Packet(jaus_id, jaus_id, b"", 0, ack=Ack.ACK)) if is_sent else None

    def recent(self, now: float) -> Iterator[tuple[int, NetworkPort, float]]:
        """Each id in use elsewhere, where, and the seconds since its last packet from there."""
        for id, clash in list(self._clashes.items()):
            if now - clash.last <= CLASH_LIFETIME:
                yield id, clash.port, now - clash.last
            else:
                del self._clashes[id]
