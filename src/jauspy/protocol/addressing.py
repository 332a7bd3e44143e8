"""Wildcards and unassigned parts of destination ids, on 32-bit numbers as they stand in headers."""

from __future__ import annotations

from typing import Final, NamedTuple, TypeAlias


def is_wildcard(id: int) -> bool:
    """True when the id addresses all of some level."""
    return id & 0xFF == 0xFF or id & 0xFF00 == 0xFF00 or id >= 0xFFFF0000


def is_unassigned(id: int) -> bool:
    """True when some part is zero: a component that waits to be given its id."""
    return not (id >> 16 and id & 0xFF00 and id & 0xFF)


def is_vague(id: int) -> bool:
    """True when the id does not name one component: nobody's address can be told from it."""
    return not (0 < id >> 16 < 0xFFFF and 0 < id >> 8 & 0xFF < 0xFF and 0 < id & 0xFF < 0xFF)


def reaches(destination: int, id: int) -> bool:
    """True when `destination` addresses the component `id`, field by field.

    A part of `id` that is zero or a wildcard is not assigned yet, so any broadcast may be meant for it; 100.1.2
    and 356.1.2 are different subsystems.
    """
    return (
        _part(destination >> 16, id >> 16, 0xFFFF)
        and _part(destination >> 8 & 0xFF, id >> 8 & 0xFF, 0xFF)
        and _part(destination & 0xFF, id & 0xFF, 0xFF)
    )


def _part(wanted: int, own: int, any_value: int) -> bool:
    return wanted in (own, any_value) or own in (0, any_value)


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
