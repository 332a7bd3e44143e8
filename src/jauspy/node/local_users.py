"""Decides which users may have components, also by UDP: those who may use the local socket.

Datagrams of UDP carry no credentials, but the kernel lists the user of each UDP port of this machine.
"""

from __future__ import annotations

import grp
import ipaddress
import math
import pwd
import stat
import sys
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final, TypeAlias

from jauspy.protocol.addressing import NetworkPort, UdpPort
from jauspy.protocol.sources import TokenBuckets
from jauspy.transport import multicast

PORT_LISTS: Final = (Path("/proc/net/udp"), Path("/proc/net/udp6"))
"""Lists of the network namespace of this process; see proc_net(5)."""
READ_RATE: Final = 100.0
"""Reads of the lists per second, each of about 0.1 ms. Without a read, no user is permitted, and none counts as
gone."""
LIST_LIFETIME: Final = 0.5
"""Seconds for which a liveness check may use the same reading."""
_ROOT: Final = 0

PortOwners: TypeAlias = Mapping[int, set[tuple[str, int]]]
"""Address and user id of the sockets at each UDP port."""


class LocalUsers:
    """Decides by the user of a UDP port; `may_use(user)` is true for users who may use the local socket."""

    def __init__(self, may_use: Callable[[int], bool], time: Callable[[], float] = time.monotonic) -> None:
        self._may_use = may_use
        self._time = time
        self._readings = TokenBuckets(READ_RATE, READ_RATE)
        self._last: tuple[float, PortOwners] | None = None
        self._own_addresses: tuple[float, frozenset[str]] = (-math.inf, frozenset())

    def may_connect(self, port: UdpPort) -> bool:
        """True when only users who may use the local socket have this port of this machine."""
        owners = self._read()
        return owners is not None and self._is_permitted(port, owners)

    def is_abandoned(self, port: NetworkPort) -> bool:
        """True for a port of this machine that no permitted user has open any more."""
        if not isinstance(port, UdpPort) or not self._is_own_address(port.host):
            return False
        owners = self._read()
        return owners is not None and not self._is_permitted(port, owners)

    def has_left(self, port: UdpPort) -> bool:
        """Same as `is_abandoned` for a port that is known to be of this machine; uses a cached list."""
        if self._last is None or self._time() - self._last[0] > LIST_LIFETIME:
            self._read()
        return self._last is not None and not self._is_permitted(port, self._last[1])

    def _is_own_address(self, host: str) -> bool:
        if host.startswith("127."):
            return True
        now = self._time()
        if now - self._own_addresses[0] > LIST_LIFETIME:
            self._own_addresses = (now, multicast.own_addresses())
        return host in self._own_addresses[1]

    def _is_permitted(self, port: UdpPort, owners: PortOwners) -> bool:
        users = {user for host, user in owners.get(port.port, ()) if host in (port.host, multicast.ANY, "::")}
        return bool(users) and all(map(self._may_use, users))

    def _read(self) -> PortOwners | None:
        now = self._time()
        if not self._readings.take(None, now):
            return None
        try:
            owners = read_port_owners()
        except OSError:
            self._last = None
            return None
        self._last = (now, owners)
        return owners


def users_of(path: Path) -> Callable[[int], bool]:
    """A function that is true for users who may use this socket: by its owner, group and mode.

    The members of the group are read once, because that may take time.
    """
    found = path.stat()
    if found.st_mode & stat.S_IWOTH:
        return lambda _: True
    allowed = {_ROOT}
    if found.st_mode & stat.S_IWUSR:
        allowed.add(found.st_uid)
    if found.st_mode & stat.S_IWGRP:
        allowed |= _members(found.st_gid)
    return allowed.__contains__


def read_port_owners() -> PortOwners:
    """The owners of all UDP ports; raises `OSError` where the system does not list them."""
    owners: dict[int, set[tuple[str, int]]] = {}
    for path in PORT_LISTS:
        try:
            lines = path.read_text().splitlines()[1:]
        except FileNotFoundError:  # no IPv6
            if path is PORT_LISTS[0]:
                raise
            continue
        for line in lines:
            _, local, *rest = line.split()
            address, _, number = local.partition(":")
            owners.setdefault(int(number, 16), set()).add((_parse_address(address), int(rest[5])))
    return owners


def _members(group: int) -> set[int]:
    members = {user.pw_uid for user in pwd.getpwall() if user.pw_gid == group}
    try:
        names = grp.getgrgid(group).gr_mem
    except KeyError:
        return members
    return members | {user.pw_uid for user in pwd.getpwall() if user.pw_name in names}


def _parse_address(text: str) -> str:
    """An address as the kernel prints it: words of 32 bits in the byte order of the machine."""
    words = (int(text[offset : offset + 8], 16).to_bytes(4, sys.byteorder) for offset in range(0, len(text), 8))
    address = ipaddress.ip_address(b"".join(words))
    mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
    return str(mapped or address)
