"""The transport for a `connect=` argument of a component or an OCU."""

from __future__ import annotations

import asyncio
import socket
from pathlib import Path
from typing import Final
from urllib.parse import urlsplit

from jauspy.errors import ConfigError, TransportError
from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.address_book import IdBounds
from jauspy.transport import LocalTransport, TcpTransport, Transport, UdpTransport, local as local_socket

DEFAULT_ROOT: Final = Path("/tmp")  # noqa: S108 # nosec B108 # where every JAUS node manager has its sockets
FORMS: Final = (
    "'udp://HOST[:PORT]' or 'tcp://HOST[:PORT]' (a node manager elsewhere), "
    "'local:DIRECTORY' (the node manager of this machine with its "
    "sockets there, as in local:/tmp), or None (the one in /tmp if it runs, else multicast)"
)


async def transport_for(
    id: JausID,
    connect: str | None,
    bounds: IdBounds = IdBounds(),  # noqa: B008 - immutable
) -> Transport:
    """The transport for `connect`, not opened yet; `bounds` limits the addresses that one by UDP remembers.

    Raises `ConfigError` that lists the forms, and `TransportError` for an unknown host.
    """
    if connect is None:
        if local_socket.is_alive(DEFAULT_ROOT / junior.SOCKET_NAME):
            return LocalTransport(id, DEFAULT_ROOT)
        return UdpTransport(id, group=(judp.MULTICAST_GROUP, judp.PORT), bounds=bounds)
    if not isinstance(connect, str):
        raise ConfigError(f"connect={connect!r} is not supported; use {FORMS}")
    if connect.startswith("local:"):
        return LocalTransport(id, _directory(connect))
    if connect.startswith("udp://"):
        return UdpTransport(id, peer=await udp_address(connect), bounds=bounds)
    if connect.startswith("tcp://"):
        return TcpTransport(id, _address(connect))
    raise ConfigError(f"connect={connect!r} is not supported; use {FORMS}")


async def udp_address(connect: str) -> tuple[str, int]:
    """The address in `udp://HOST[:PORT]`; raises as `transport_for`."""
    return await _resolve(*_address(connect))


def _directory(connect: str) -> Path:
    name = connect.removeprefix("local:")
    if not name:
        raise ConfigError(f"connect={connect!r} has no directory; use {FORMS}")
    return Path(name)


def _address(connect: str) -> tuple[str, int]:
    try:
        parts = urlsplit(connect)
        host, port = parts.hostname, parts.port or judp.PORT
    except ValueError:
        host, port = None, 0
    if not host or parts.path or parts.query or parts.username is not None:
        raise ConfigError(f"connect={connect!r} is not an address; use {FORMS}")
    return host, port


async def _resolve(host: str, port: int) -> tuple[str, int]:
    try:
        found = await asyncio.get_running_loop().getaddrinfo(host, port, family=socket.AF_INET, type=socket.SOCK_DGRAM)
    except OSError as error:
        raise TransportError(f"the host {host!r} of the node manager is unknown: {error.strerror}") from error
    address = found[0][4]
    return str(address[0]), port
