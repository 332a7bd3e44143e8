"""The contract of transports, and how they read datagram sockets."""

from __future__ import annotations

import asyncio
import socket
import time
from collections.abc import Callable, Collection, Mapping
from typing import Any, Final, Protocol, TypeAlias, runtime_checkable

from jauspy.ids import JausID
from jauspy.protocol.addressing import Location
from jauspy.transport.age import MAX_DATAGRAM, DatagramReader

Receiver: TypeAlias = Callable[[bytes], None]

DATAGRAMS_PER_WAKEUP: Final = 64


class Transport(Protocol):
    """Carries JUDP datagrams of one component, one packet each.

    The owner sets `received` before `open`; it is called in the event loop with each received datagram. Datagrams that
    waited longer than `max_age` seconds to be read are dropped unless they are acknowledged.
    """

    id: JausID
    received: Receiver
    max_age: float

    async def open(self) -> None:
        """Open sockets or devices; raises `TransportError`."""

    async def close(self) -> None:
        """Close everything; a second call does nothing."""

    def send(self, datagram: bytes) -> None:
        """Send, or drop and count; never blocks and never raises."""

    def move(self, id: JausID, on_leave: Callable[[], None]) -> None:
        """Change the id; raises `TransportError` when the new one is in use, and keeps the old one.

        `on_leave` is called before the old id is given up, unless the new one is in use.
        """

    @property
    def connected(self) -> bool:
        """True while sent datagrams can be expected to arrive."""

    @property
    def waiting(self) -> int:
        """The number of queued datagrams; while there are many, the endpoint holds back large messages."""

    @property
    def counters(self) -> Mapping[str, int]:
        """Counters of sent, received and dropped datagrams, by reason."""


@runtime_checkable
class LocatingTransport(Transport, Protocol):
    """A transport that knows where other components are."""

    def locate(self, id: JausID, found: Callable[[Location], None]) -> None:
        """Call `found`, now or later, with the machine of a component, which may be unknown."""


@runtime_checkable
class AddressedTransport(Transport, Protocol):
    """A transport that sends to addresses of hosts."""

    def host_towards(self, id: JausID) -> str | None:
        """The host to which datagrams for a component go; None if it is not known yet."""


@runtime_checkable
class FilteringTransport(Transport, Protocol):
    """A transport that can leave out broadcasts before they wake the program."""

    def leave_out_broadcasts(self, codes: Collection[int]) -> None:
        """Leave out broadcasts with these message ids from now on, where that is possible, and no others."""


@runtime_checkable
class ClashAwareTransport(Transport, Protocol):
    """A transport that knows whether another machine uses the id of its component."""

    async def id_clash(self) -> str | None:
        """The address of a machine or program that used this id in the last seconds; None if there is none."""


def ignore(datagram: bytes) -> None:
    """The receiver of a transport without an owner."""


def start_reading(
    loop: asyncio.AbstractEventLoop,
    reader: DatagramReader,
    take: Callable[[bytes, Any], None],
    failed: Callable[[OSError], None],
    *,
    take_is_fast: bool = False,
) -> Callable[[], None]:
    """Call `take(datagram, sender)` for each datagram of a non-blocking socket until `stop_reading`.

    Returns the function that goes on reading after `loop.remove_reader`, as this one begins it.

    `failed` is called with the error of an earlier sent datagram; reading continues. What the reader finds too old is
    dropped; unless `take_is_fast`, this holds for what waits during `take`, too.
    """

    def drain() -> None:
        now, receive = 0.0, reader.receive
        for count in range(DATAGRAMS_PER_WAKEUP):
            try:
                if not (count and take_is_fast):
                    now = time.monotonic()
                    receive = reader.receiver(now)
                datagram, sender = receive(MAX_DATAGRAM)
            except (BlockingIOError, InterruptedError):
                reader.was_empty(now)
                return
            except OSError as error:
                failed(error)
                return
            take(datagram, sender)

    def resume() -> None:
        loop.add_reader(reader.socket, drain)

    resume()
    return resume


def stop_reading(loop: asyncio.AbstractEventLoop, sock: socket.socket) -> None:
    """Stop reading, and close the socket."""
    loop.remove_reader(sock)
    sock.close()
