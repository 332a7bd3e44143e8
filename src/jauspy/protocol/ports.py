"""Where a node manager gets bytes from and sends them to."""

from __future__ import annotations

from typing import Final, NamedTuple, TypeAlias


class LocalPort(NamedTuple):
    """The socket of a component on this machine; an empty path when the sender had none."""

    path: str


class UdpPort(NamedTuple):
    """The address of another node manager, or of a component that speaks JUDP itself."""

    host: str
    port: int


class GroupPort(NamedTuple):
    """The multicast group."""

    name: str = "multicast"


Port: TypeAlias = LocalPort | UdpPort | GroupPort
GROUP: Final = GroupPort()
