"""A component's side of AS5669A: numbers what it sends, acknowledges what asks for it, hands up what is for it."""

from __future__ import annotations

import logging
from collections import deque
from typing import Final, TypeVar

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import addressing, header, judp, junior
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority

_LOGGER = logging.getLogger(__name__)
_Item = TypeVar("_Item", bytes, Packet)

MAX_QUEUED: Final = 1024
"""Packets that may wait in either direction; the oldest is dropped first, and counted."""


class Endpoint:
    """Sans-I/O endpoint of one component.

    `first_sequence` should be random: peers drop a restarted component's first messages as duplicates when it
    starts at the same number again.
    """

    def __init__(self, id: JausID, *, first_sequence: int) -> None:
        self.id = id
        self.counters = Counters(_LOGGER)
        self._sequence = first_sequence & 0xFFFF
        self._output: deque[bytes] = deque()
        self._input: deque[Packet] = deque()

    def send(
        self,
        destination: JausID,
        payload: bytes,
        *,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> None:
        """Queue one message; raises `ProtocolError` when it does not fit one packet."""
        if len(payload) > header.MAX_PAYLOAD:
            raise ProtocolError("oversize", f"{len(payload)} bytes; one packet carries {header.MAX_PAYLOAD}")
        if destination.is_wildcard:
            ack = Ack.NONE
            if broadcast is Broadcast.NONE:
                broadcast = Broadcast.GLOBAL
        packet = Packet(self.id, destination, payload, self._sequence, priority, broadcast, ack)
        self._sequence = (self._sequence + 1) & 0xFFFF
        self._emit(packet)
        self.counters["sent"] += 1

    def receive(self, datagram: bytes | memoryview) -> None:
        """Take one datagram; malformed ones are counted by reason, never raised."""
        if junior.parse(datagram) is not None:
            return
        packets, errors = judp.unpack_all(datagram)
        for packet in packets:
            self._take(packet)
        for error in errors:
            self.counters.drop(f"malformed.{error.reason}", error)

    def poll_output(self) -> list[bytes]:
        """The datagrams to send now, in order."""
        out = list(self._output)
        self._output.clear()
        return out

    def next_event(self) -> Packet | None:
        """The next received packet that carries a message, or None."""
        return self._input.popleft() if self._input else None

    def _take(self, packet: Packet) -> None:
        if not addressing.reaches(int(packet.destination), int(self.id)):
            self.counters.drop("not_for_us", packet.destination)
        elif packet.ack in (Ack.ACK, Ack.NAK):
            self.counters["received.ack" if packet.ack is Ack.ACK else "received.nak"] += 1
        elif packet.data_flag is not DataFlag.SINGLE:
            self.counters.drop("fragment", "a piece of a large message")
        else:
            self._acknowledge(packet)
            self._hand_up(packet)

    def _hand_up(self, packet: Packet) -> None:
        if packet.payload:
            self._push(self._input, packet, "input_full")
            self.counters["received"] += 1
        else:
            self.counters["received.empty"] += 1

    def _acknowledge(self, packet: Packet) -> None:
        if packet.ack is Ack.REQUIRED and packet.destination == self.id:
            self._emit(Packet(self.id, packet.source, b"", packet.sequence, packet.priority, ack=Ack.ACK))
            self.counters["sent.ack"] += 1

    def _emit(self, packet: Packet) -> None:
        self._push(self._output, judp.pack(packet), "output_full")

    def _push(self, queue: deque[_Item], item: _Item, reason: str) -> None:
        if len(queue) >= MAX_QUEUED:
            queue.popleft()
            self.counters.drop(reason)
        queue.append(item)
