"""Multicast: socket options, and memberships of a group on interfaces that appear and disappear."""

from __future__ import annotations

import contextlib
import errno
import logging
import os
import socket
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.logs import get_logger

_LOG = get_logger(__name__)

ANY: Final = "0.0.0.0"  # noqa: S104 # nosec B104 # the standard's node managers listen on every interface

RECEIVE_BUFFER: Final = 4 * 1024 * 1024
"""Bytes requested of the kernel, so that a burst is not lost before it is read; the kernel may grant less."""
_IP_MULTICAST_ALL: Final = 49
_IPV6_MULTICAST_ALL: Final = 29
"""Socket option of linux/in.h and in6.h; with 0 a socket receives only groups that it has joined itself."""
ALL_INTERFACES: Final = "all"
"""Every interface that has an IPv4 address, except the loopback interface."""
WATCH_INTERVAL: Final = 5.0
"""Seconds between checks of the interfaces; a robot may start before its network."""


def prepare_sender(sock: socket.socket, interface: str, ttl: int) -> None:
    """Send multicasts by `interface` (an IPv4 address; `ANY` lets the kernel choose), with loopback to this host."""
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, ttl)
    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_LOOP, 1)
    if interface != ANY:
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(interface))


def set_receive_buffer(sock: socket.socket) -> None:
    """Enlarge the receive buffer, up to the kernel's limit."""
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)


def prepare_ipv6(sock: socket.socket, hops: int) -> None:
    """Send multicasts with loopback to this host; receive only groups that this socket has joined."""
    sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_HOPS, hops)
    sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_LOOP, 1)
    sock.setsockopt(socket.IPPROTO_IPV6, _IPV6_MULTICAST_ALL, 0)


def receive_only_joined(sock: socket.socket) -> None:
    """Do not receive groups that other sockets of this machine have joined."""
    sock.setsockopt(socket.IPPROTO_IP, _IP_MULTICAST_ALL, 0)


def share_group(sock: socket.socket) -> None:
    """Allow `receiver` sockets of the same user on this port; unicasts still arrive at this socket only.

    Call it after `bind`: a socket that has the option before would also share its unicasts.
    """
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)


def receiver(group: tuple[str, int]) -> socket.socket:
    """A socket that receives only the group, once it has joined it; several may exist.

    Raises `OSError`, for example when another program has the port on all addresses without `share_group`.
    """
    family = socket.AF_INET6 if ":" in group[0] else socket.AF_INET
    sock = socket.socket(family, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        set_receive_buffer(sock)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        sock.bind(group)
        if family == socket.AF_INET:
            receive_only_joined(sock)
        else:
            sock.setsockopt(socket.IPPROTO_IPV6, _IPV6_MULTICAST_ALL, 0)
    except OSError:
        sock.close()
        raise
    return sock


@dataclass(frozen=True, slots=True)
class AddressFamily:
    """Means to join groups with sockets of one address family; `present` resolves configured interfaces."""

    level: int
    join: int
    leave: int
    present: Callable[[Sequence[str]], tuple[str, ...]]
    membership: Callable[[str, str], bytes]


def addresses(chosen: Sequence[str]) -> tuple[str, ...]:
    """The present IPv4 addresses of interfaces given by address, by name, or as `ALL_INTERFACES`."""
    present = _present(socket.AF_INET)
    found: dict[str, None] = {}
    for interface in chosen:
        if interface == ALL_INTERFACES:
            selected = [address for name in present for address in present[name] if not address.startswith("127.")]
        elif interface in present:
            selected = present[interface]
        elif (
            interface == ANY
            or interface.startswith("127.")
            or any(interface in addresses for addresses in present.values())
        ):
            selected = [interface]
        else:
            selected = []
        found.update(dict.fromkeys(selected))
    return tuple(found)


def own_addresses() -> frozenset[str]:
    """All addresses of this machine, IPv4 and IPv6."""
    families = (socket.AF_INET, socket.AF_INET6)
    return frozenset(address for family in families for addresses in _present(family).values() for address in addresses)


def names(chosen: Sequence[str]) -> tuple[str, ...]:
    """The names of the present interfaces with IPv6; `ANY` is kept, for the kernel's choice."""
    present = _present(socket.AF_INET6)
    addressed = _present(socket.AF_INET)
    found: dict[str, None] = {}
    for interface in chosen:
        if interface == ALL_INTERFACES:
            selected = [name for name in present if "::1" not in present[name]]
        elif interface == ANY:
            selected = [interface]
        else:
            selected = [name for name in present if interface in (name, *present[name], *addressed.get(name, ()))]
        found.update(dict.fromkeys(selected))
    return tuple(found)


def index(name: str) -> int:
    """The kernel's index of an interface, 0 for `ANY`; raises `OSError` when it does not exist."""
    return 0 if name == ANY else socket.if_nametoindex(name)


def _present(family: socket.AddressFamily) -> dict[str, list[str]]:
    """Addresses by interface name, for interfaces that have any; link-local addresses without their scope."""
    import psutil  # noqa: PLC0415 - a component without multicasts does not need it

    found = {
        name: [entry.address.partition("%")[0] for entry in entries if entry.family == family]
        for name, entries in psutil.net_if_addrs().items()
    }
    return {name: addresses for name, addresses in found.items() if addresses}


IPV4: Final = AddressFamily(
    socket.IPPROTO_IP,
    socket.IP_ADD_MEMBERSHIP,
    socket.IP_DROP_MEMBERSHIP,
    addresses,
    lambda group, address: socket.inet_aton(group) + socket.inet_aton(address),
)
IPV6: Final = AddressFamily(
    socket.IPPROTO_IPV6,
    socket.IPV6_JOIN_GROUP,
    socket.IPV6_LEAVE_GROUP,
    names,
    lambda group, name: socket.inet_pton(socket.AF_INET6, group) + index(name).to_bytes(4, sys.byteorder),
)


class Memberships:
    """Keeps a socket in a group on all configured interfaces.

    `current` are the present ones, to send by: IPv4 addresses or names.
    """

    def __init__(self, sock: socket.socket, group: str, chosen: Sequence[str], family: AddressFamily = IPV4) -> None:
        self.current: tuple[str, ...] = ()
        self._socket = sock
        self._group = group
        self._chosen = tuple(chosen)
        self._family = family
        self._joined: set[str] = set()
        self._warned: set[str] = set()
        self.refresh()

    @property
    def joined(self) -> int:
        """The number of interfaces on which multicasts are received."""
        return len(self._joined)

    def refresh(self) -> None:
        """Join on all interfaces again: to the kernel, an interface that was removed and added is a new one."""
        found = {interface: self._family.present([interface]) for interface in self._chosen}
        self.current = tuple(dict.fromkeys(interface for addresses in found.values() for interface in addresses))
        for gone in self._joined.difference(self.current):
            self._leave(gone)
        for item, addresses in found.items():
            if not addresses:
                self._failed(item, os.strerror(errno.ENODEV))
        for interface in self.current:
            error = self._join(interface)
            if error is None:
                self._succeeded(interface)
            else:
                self._failed(interface, error.strerror)

    def _join(self, interface: str) -> OSError | None:
        family = self._family
        try:
            self._socket.setsockopt(family.level, family.join, family.membership(self._group, interface))
        except OSError as error:
            return None if error.errno == errno.EADDRINUSE else error  # in use: joined before
        return None

    def _succeeded(self, interface: str) -> None:
        if interface not in self._joined:
            level = logging.WARNING if interface in self._warned else logging.DEBUG
            _LOG.log(level, "joined %s on %s", self._group, interface)
        self._joined.add(interface)
        self._warned.discard(interface)

    def _failed(self, interface: str, reason: str | None) -> None:
        self._joined.discard(interface)
        if interface not in self._warned:
            self._warned.add(interface)
            _LOG.warning(
                "no multicasts on interface %s: %s; is its network up? Trying again every %g s",
                interface,
                reason,
                WATCH_INTERVAL,
            )

    def _leave(self, interface: str) -> None:
        self._joined.discard(interface)
        family = self._family
        with contextlib.suppress(OSError):  # the kernel has left by itself with the interface
            self._socket.setsockopt(family.level, family.leave, family.membership(self._group, interface))


def address_towards(host: str) -> str | None:
    """The address of this machine from which packets to `host` are sent; None without a route. Nothing is sent."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.socket(family, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect((host, 9))
        except OSError:
            return None
        return str(probe.getsockname()[0])
