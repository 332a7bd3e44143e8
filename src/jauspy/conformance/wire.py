"""The contract between a run and the network: datagrams out, datagrams in, and the time."""

from __future__ import annotations

from collections.abc import Collection
from typing import Final, NamedTuple, Protocol

from jauspy.ids import JausID

RAW: Final = "raw"
"""The bytes of a datagram reach the target as they are, several packets and garbage included."""
PORTS: Final = "ports"
"""A client can speak from another UDP port."""


class Arrival(NamedTuple):
    """A datagram, and whether it came to the strange port."""

    data: bytes
    strange_port: bool = False


class Wire(Protocol):
    """Carries the datagrams of all clients of a tester. Time is in seconds, real or virtual."""

    @property
    def features(self) -> Collection[str]:
        """What this wire can do beside the usual: `RAW`, `PORTS`."""

    def now(self) -> float:
        """The time."""

    def join(self, id: JausID) -> None:
        """From now on be reachable as `id`; raises `TransportError` when that is not possible."""

    def send(self, datagram: bytes, source: JausID, *, strange_port: bool = False) -> None:
        """Send as `source`; with `strange_port` from another UDP port than usual, and what comes there is heard."""

    def receive(self, until: float) -> Arrival | None:
        """The next datagram; None when none came before the time was `until`."""

    def close(self) -> None:
        """Give everything back; twice is fine."""
