"""Addressing: wildcards in destination ids, and the ports that a node manager receives from and sends to.

Ids are 32-bit numbers, as in headers.
"""

from __future__ import annotations

import ipaddress
from typing import Final, NamedTuple, TypeAlias

DEFAULT_NETWORK: Final = "lan"
"""The name of the first network, unless the configuration sets another."""

ID_REQUESTS: Final = frozenset({0xDB01, 0xDB03})
"""RequestSubsystemID and RequestNodeID, whose senders have no id yet; some have wildcards in its place."""


def is_wildcard(id: int) -> bool:
    """True when any part of the id is a wildcard: all subsystems, nodes or components."""
    return id & 0xFF == 0xFF or id & 0xFF00 == 0xFF00 or id >= 0xFFFF0000


def is_unassigned(id: int) -> bool:
    """True when some part is zero: a component that has not been assigned its id yet."""
    return not (id >> 16 and id & 0xFF00 and id & 0xFF)


def is_incomplete(id: int) -> bool:
    """True when the id has a wildcard or a zero, so that no address can be learned for it."""
    return not (0 < id >> 16 < 0xFFFF and 0 < id >> 8 & 0xFF < 0xFF and 0 < id & 0xFF < 0xFF)


def reaches(destination: int, id: int) -> bool:
    """True when `destination` addresses the component `id`, part by part.

    A part of `id` that is zero or a wildcard is not assigned yet, so any broadcast may be meant for it; 100.1.2
    and 356.1.2 are different subsystems.
    """
    return (
        _part_matches(destination >> 16, id >> 16, 0xFFFF)
        and _part_matches(destination >> 8 & 0xFF, id >> 8 & 0xFF, 0xFF)
        and _part_matches(destination & 0xFF, id & 0xFF, 0xFF)
    )


def _part_matches(wanted: int, part: int, wildcard: int) -> bool:
    return wanted in (part, wildcard) or part in (0, wildcard)


class LocalPort(NamedTuple):
    """The socket of a component on this machine; the path is empty when the sender's socket has no name."""

    path: str


class UdpPort(NamedTuple):
    """The UDP address of another node manager, or of a component that uses JUDP, and its network."""

    host: str
    port: int
    network: str = DEFAULT_NETWORK


class GroupPort(NamedTuple):
    """The multicast group of a network."""

    network: str = DEFAULT_NETWORK


class TcpPort(NamedTuple):
    """The remote end of a JTCP connection. `kind` makes it differ from a UDP address."""

    host: str
    port: int
    network: str = DEFAULT_NETWORK
    kind: str = "tcp"


class SerialPort(NamedTuple):
    """A serial line; `host` is its device, `port` is unused."""

    host: str
    port: int = 0
    network: str = DEFAULT_NETWORK
    kind: str = "serial"


NetworkPort: TypeAlias = UdpPort | TcpPort | SerialPort
"""The address of one peer; all have `host`, `port` and `network`."""

Port: TypeAlias = LocalPort | NetworkPort | GroupPort
GROUP: Final = GroupPort()


class Location(NamedTuple):
    """The machine that a component is on: this one, or another one with these IP addresses; without any: unknown."""

    is_here: bool = False
    hosts: frozenset[str] = frozenset()
    ports: frozenset[int] = frozenset()
    """UDP ports of JAUS, as far as they are known: of the node manager here, and of the component's machine."""

    sent: int | None = None
    """Bytes that the node manager here has sent to that machine; None if it does not count them."""
    waiting: int | None = None
    """Bytes that wait in its queue to the component, or in the kernel's to the network; None if that is unknown."""
    left_out: tuple[tuple[str, int], ...] = ()
    """Messages that the limits of the link to that machine have left out so far, and how many."""

    def has(self, host: str) -> bool:
        """True when this is an address of the machine; loopback addresses are those of this one only."""
        address = _ip_address(host)
        if address is None:
            return False
        return self.is_here if address.is_loopback else any(_ip_address(host) == address for host in self.hosts)


def _ip_address(host: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    """An address without its scope; None for anything else, such as a serial line."""
    try:
        return ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return None


HERE: Final = Location(is_here=True)
UNKNOWN_LOCATION: Final = Location()


def format_port(port: Port) -> str:
    """A port as `HOST:PORT`, with an IPv6 host in brackets, or a path."""
    host, *rest = port[:2]
    return ":".join([f"[{host}]" if rest and ":" in host else host, *map(str, rest)])
