"""The contract between a component and the way its datagrams travel."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol, TypeAlias

from jauspy.ids import JausID

Receiver: TypeAlias = Callable[[bytes], None]


class Transport(Protocol):
    """Carries JUDP datagrams of one component, one packet each.

    The owner sets `received` before `open`; it is called in the event loop with each datagram that arrives.
    """

    id: JausID
    received: Receiver

    async def open(self) -> None:
        """Be ready to send and receive; raises `TransportError` when that is not possible."""

    async def close(self) -> None:
        """Give everything back; a second call does nothing."""

    def send(self, datagram: bytes) -> None:
        """Send, or drop and count; never blocks and never raises."""

    def move(self, id: JausID, goodbye: Callable[[], None]) -> None:
        """Be the component of this id from now on; raises `TransportError` when it is taken, and then stays.

        `goodbye` is called before the old id is given up, and not at all when the new one is taken.
        """

    @property
    def connected(self) -> bool:
        """True while datagrams can be expected to arrive."""

    @property
    def waiting(self) -> int:
        """Datagrams that it was given and has not sent yet; of what can wait, large messages wait with their sender."""

    @property
    def counters(self) -> Mapping[str, int]:
        """What was sent, received and dropped, by reason."""


def ignore(datagram: bytes) -> None:
    """The receiver of a transport that nobody owns yet."""
