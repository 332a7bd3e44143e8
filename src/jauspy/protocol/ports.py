"""Where a node manager gets bytes from and sends them to."""

from __future__ import annotations

from typing import Final, NamedTuple, TypeAlias

DEFAULT_NETWORK: Final = "lan"
"""The name of the first network, unless the configuration gives it another."""


class LocalPort(NamedTuple):
    """The socket of a component on this machine; an empty path when the sender had none."""

    path: str


class UdpPort(NamedTuple):
    """The address of another node manager, or of a component that speaks JUDP itself, and the network it is on."""

    host: str
    port: int
    network: str = DEFAULT_NETWORK


class GroupPort(NamedTuple):
    """The multicast group of a network."""

    network: str = DEFAULT_NETWORK


class TcpPort(NamedTuple):
    """The other end of a JTCP connection. `kind` keeps it from being equal to a UDP address."""

    host: str
    port: int
    network: str = DEFAULT_NETWORK
    kind: str = "tcp"


class SerialPort(NamedTuple):
    """A serial line; `host` is its device and `port` means nothing."""

    host: str
    port: int = 0
    network: str = DEFAULT_NETWORK
    kind: str = "serial"


NetworkPort: TypeAlias = UdpPort | TcpPort | SerialPort
"""Where one peer is reached; all have `host`, `port` and `network`."""

Port: TypeAlias = LocalPort | NetworkPort | GroupPort
GROUP: Final = GroupPort()
