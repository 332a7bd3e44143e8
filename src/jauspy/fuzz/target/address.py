"""The UDP address of a target, and the networks on which one may be fuzzed."""

from __future__ import annotations

import ipaddress
import re
import socket
from pathlib import Path
from typing import Final

from jauspy.errors import ConfigError
from jauspy.protocol import judp

Address = tuple[str, int]

_OWN_NAMESPACE: Final = Path("/proc/self/ns/net")
_FIRST_NAMESPACE: Final = Path("/proc/1/ns/net")
_ROUTES: Final = Path("/proc/net/route")
_ANYWHERE: Final = "00000000"
"""Destination and mask of a default route in /proc/net/route."""


def target_address(text: str, *, is_own_network: bool = False) -> Address:
    """The address in HOST or HOST:PORT; port 0 is one that is free now.

    Raises `ConfigError` for another text, and for an address that is neither a loopback address nor in a network
    namespace without a default route, unless `is_own_network`.
    """
    found = re.fullmatch(r"(?:udp://)?([\w.-]+)(?::(\d{1,5}))?", text, re.ASCII)
    if found is None or int(found[2] or 0) > 0xFFFF:
        raise ConfigError(f"{text!r} is not the UDP address of a target; write HOST:PORT, as in 127.0.0.1:3794")
    try:
        host = socket.gethostbyname(found[1])
    except OSError as error:
        raise ConfigError(f"the host {found[1]} is not known: {error.strerror}") from error
    if not is_own_network and not ipaddress.ip_address(host).is_loopback and not is_isolated():
        raise ConfigError(
            f"{host} is neither a loopback address, nor in a network namespace without a default route: damaged "
            "messages may stop or move what receives them. If all of that network is yours, add --i-own-this-network"
        )
    port = judp.PORT if found[2] is None else int(found[2])
    return host, port or free_port(host)


def is_isolated(routes: Path = _ROUTES, own: Path = _OWN_NAMESPACE, first: Path = _FIRST_NAMESPACE) -> bool:
    """True in a network namespace other than that of process 1, without a default route; false if that is unknown."""
    try:
        if own.stat().st_ino == first.stat().st_ino:
            return False
        rows = [line.split() for line in routes.read_text(encoding="ascii").splitlines()[1:]]
    except OSError:
        return False
    return not any((row[1], row[7]) == (_ANYWHERE, _ANYWHERE) for row in rows)


def free_port(host: str) -> int:
    """A UDP port that nobody uses at this local address."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        try:
            sock.bind((host, 0))
        except OSError as error:
            raise ConfigError(
                f"a free port is taken from this machine only, and {host} is not one of its addresses"
            ) from error
        port: int = sock.getsockname()[1]
        return port
