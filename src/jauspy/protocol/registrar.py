"""Which component lives where: one connects, says goodbye, is found dead, or claims what is another's."""

from __future__ import annotations

import logging
from collections import OrderedDict
from collections.abc import Callable, Iterator
from typing import Final, TypeAlias

from jauspy.ids import JausID
from jauspy.protocol import addressing, junior
from jauspy.protocol.addressing import LocalPort, Port, UdpPort
from jauspy.protocol.counters import Counters
from jauspy.protocol.egress import EgressQueue
from jauspy.protocol.pending import PendingDestinations
from jauspy.protocol.sources import TokenBuckets

MAX_COMPONENTS: Final = 1024
MAX_UDP_COMPONENTS: Final = 256
"""Of these, by UDP: any user of this machine can send it, and must not fill the places of those with a socket."""

ComponentPort: TypeAlias = LocalPort | UdpPort
"""A component's Unix socket, or its UDP port on this machine, as ROS/IOP components have it."""


class ComponentDirectory:
    """Ids (32-bit numbers) and the ports they were last heard from. `changed` is told of an id that comes or goes."""

    def __init__(self, changed: Callable[[int], None] = lambda _: None) -> None:
        self._changed = changed
        self._ports: dict[int, ComponentPort] = {}
        self._ids: dict[ComponentPort, set[int]] = {}
        self._by_udp = 0

    def __len__(self) -> int:
        return len(self._ports)

    def __contains__(self, id: int) -> bool:
        return id in self._ports

    def __iter__(self) -> Iterator[tuple[int, ComponentPort]]:
        return iter(list(self._ports.items()))

    def port(self, id: int) -> ComponentPort | None:
        """Where exactly this id listens."""
        return self._ports.get(id)

    def has_port(self, port: ComponentPort) -> bool:
        """True when some component listens there."""
        return port in self._ids

    def register(self, id: int, port: ComponentPort) -> bool:
        """Note that `id` listens on `port`, the last one to say so wins; False when there is no room or no id."""
        known, by_udp = self._ports.get(id), isinstance(port, UdpPort)
        if id == 0 or (known is None and len(self._ports) >= MAX_COMPONENTS):
            return False
        if by_udp and not isinstance(known, UdpPort) and self._by_udp >= MAX_UDP_COMPONENTS:
            return False
        if known != port:
            self.remove(id)
            self._ports[id] = port
            self._by_udp += by_udp
            self._ids.setdefault(port, set()).add(id)
            self._changed(id)
        return True

    def remove(self, id: int) -> None:
        """Forget a component."""
        port = self._ports.pop(id, None)
        if port is not None:
            self._by_udp -= isinstance(port, UdpPort)
            self._ids[port].discard(id)
            if not self._ids[port]:
                del self._ids[port]
            self._changed(id)

    def remove_port(self, port: ComponentPort) -> list[int]:
        """Forget all that listen there; returns their ids."""
        gone = sorted(self._ids.get(port, ()))
        for id in gone:
            self.remove(id)
        return gone

    def reached_by(self, destination: int, *, besides: int | None = None) -> list[ComponentPort]:
        """The ports of all components that a broadcast addresses, except the one it comes from."""
        return [port for id, port in self._ports.items() if id != besides and addressing.reaches(destination, id)]


MAX_LOGGED_CASES: Final = 256
"""Cases to remember as told; an attacker who makes up more of them is told about again."""
LOG_RATE: Final = 0.1
LOG_BURST: Final = 16.0
"""Lines per second, and at once: what more is made up is only counted."""


class DuplicateIdLog:
    """Warnings about ids, each once per id and host, or local socket."""

    def __init__(self, logger: logging.Logger) -> None:
        self._logger = logger
        self._told: OrderedDict[tuple[int, str], None] = OrderedDict()
        self._lines = TokenBuckets(LOG_RATE, LOG_BURST)

    def twice(self, id: int, port: Port, now: float) -> None:
        """Somebody at `port` uses the id of a component that is registered here."""
        if self._is_news(id, port, now):
            self._logger.warning(
                "%s is used twice: a component has it here, and %s sends with it too; the latter is not heard",
                JausID.from_int(id),
                format_port(port),
            )

    def moved(self, id: int, port: Port, now: float) -> None:
        """A component has connected whose id was registered elsewhere."""
        if self._is_news(id, port, now):
            self._logger.info("component %s is now on %s", JausID.from_int(id), format_port(port))

    def _is_news(self, id: int, port: Port, now: float) -> bool:
        key = (id, port.path if isinstance(port, LocalPort) else port[0])
        if key in self._told or not self._lines.take(None, now):
            return False
        self._told[key] = None
        if len(self._told) > MAX_LOGGED_CASES:
            self._told.popitem(last=False)
        return True


def format_port(port: Port) -> str:
    """A port as people read it; the host of an IPv6 address is in brackets."""
    host, *rest = port[:2]
    return ":".join([f"[{host}]" if rest and ":" in host else host, *map(str, rest)])


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
        out: EgressQueue,
        waiting: PendingDestinations,
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
