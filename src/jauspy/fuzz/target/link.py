"""The UDP socket to a target, and the datagrams that were sent since the target started."""

from __future__ import annotations

import select
import socket
import time
from collections import deque
from typing import Final

from jauspy.conformance.link import MAX_FIRST_SEQUENCE, Arrival
from jauspy.errors import TransportError
from jauspy.fuzz.target.address import Address
from jauspy.ids import JausID
from jauspy.transport import multicast

BUFFER: Final = 65536
MAX_HISTORY: Final = 20_000
"""Datagrams that are kept for minimising; the oldest are forgotten first."""


class RecordingLink:
    """A `TesterLink` to one UDP address. Nothing is sent to, or received from, any other one.

    The socket is connected, so that the kernel reports a port that nobody listens on: `is_refused`.
    """

    features = ()

    def __init__(self, address: Address, seed: int) -> None:
        self.first_sequence = seed * 7919 % MAX_FIRST_SEQUENCE
        self.history: deque[bytes] = deque(maxlen=MAX_HISTORY)
        self.is_refused = False
        """True if the last datagram met a closed port."""
        self.is_recording = True
        """False for queries of liveness, which are no part of what makes a target fail."""
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        multicast.set_receive_buffer(self._socket)
        try:
            self._socket.connect(address)
        except OSError as error:
            self._socket.close()
            raise TransportError(f"cannot send to UDP {address[0]}:{address[1]}: {error.strerror}") from error

    @property
    def own_address(self) -> Address:
        """The address that datagrams come from."""
        host, port = self._socket.getsockname()[:2]
        return host, port

    def now(self) -> float:
        """Seconds of the monotonic clock."""
        return time.monotonic()

    def join(self, id: JausID) -> None:
        """Answers go to the address that a message came from, so nothing needs to be announced."""

    def send(self, datagram: bytes, source: JausID, *, other_port: bool = False) -> None:  # noqa: ARG002 - of TesterLink
        """Send, and keep the datagram in the history if it is recorded."""
        if self.is_recording:
            self.history.append(datagram)
        for _ in range(2):  # the kernel reports the refusal of an earlier datagram instead of sending this one
            try:
                self._socket.send(datagram)
            except ConnectionRefusedError:
                self.is_refused = True
            except BlockingIOError:
                select.select([], [self._socket], [], 1.0)
            except OSError as error:
                raise TransportError(f"cannot send {len(datagram)} bytes to the target: {error.strerror}") from error
            else:
                return

    def receive(self, until: float) -> Arrival | None:
        """The next datagram; None if none arrives before the time is `until`."""
        while True:
            ready, _, _ = select.select([self._socket], [], [], max(0.0, until - time.monotonic()))
            if not ready:
                return None
            try:
                datagram = self._socket.recv(BUFFER)
            except ConnectionRefusedError:
                self.is_refused = True
            except BlockingIOError:  # a datagram with a wrong checksum
                continue
            else:
                self.is_refused = False
                return Arrival(datagram)

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()
