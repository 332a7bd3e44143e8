"""AS5669A at a component: sequence numbers, acknowledgement, resends, fragmentation, reassembly, duplicates."""

from __future__ import annotations

from collections import deque
from typing import Final, TypeVar

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol import addressing, header, judp
from jauspy.protocol.counters import Counters
from jauspy.protocol.delivery import Delivery, DeliveryOutcome, Transfers
from jauspy.protocol.duplicates import Duplicates
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority
from jauspy.protocol.reassembly import Reassembly

_LOG = get_logger(__name__)
_Item = TypeVar("_Item", bytes, Packet)

MAX_QUEUED: Final = 1024
"""Packets that may wait in each direction; the oldest is dropped first, and counted."""


class Endpoint:
    """Sans-I/O endpoint of one component.

    `first_sequence` should be random: peers drop the first messages of a restarted component as duplicates when it
    starts at the same number again.
    """

    def __init__(self, id: JausID, *, first_sequence: int, delivery: Delivery | None = None) -> None:
        self.id = id
        self.counters = Counters(_LOG)
        self._settings = delivery or Delivery()
        self._sequence = first_sequence & 0xFFFF
        self._output: deque[bytes] = deque()
        self._input: deque[Packet] = deque()
        self._duplicates = Duplicates(self._settings.resend_period)
        self._reassembly = Reassembly(self._settings, self.counters)
        self._transfers = Transfers(self._settings, self.counters, self._emit, self._reserve)

    def send(
        self,
        destination: JausID,
        payload: bytes,
        *,
        now: float,
        priority: Priority = Priority.STANDARD,
        broadcast: Broadcast = Broadcast.NONE,
        ack: Ack = Ack.NONE,
    ) -> int | None:
        """Queue one message; returns a ticket if it needs an ACK, else None.

        With `Ack.REQUIRED` it is resent until acknowledged; `next_outcome` then returns its ticket. Raises
        `ProtocolError` for a message that is too large, and when too many messages are being sent.
        """
        large = len(payload) > header.MAX_PAYLOAD
        if len(payload) > self._settings.max_message:
            raise ProtocolError("oversize", f"{len(payload)} bytes; messages have up to {self._settings.max_message}")
        if destination.is_wildcard:
            if large:
                raise ProtocolError("oversize", f"{len(payload)} bytes; a broadcast has up to {header.MAX_PAYLOAD}")
            ack = Ack.NONE
            if broadcast is Broadcast.NONE:
                broadcast = Broadcast.GLOBAL
        ticket = None
        if large or ack is Ack.REQUIRED:
            ticket = self._transfers.start(
                Packet(self.id, destination, payload, 0, priority, broadcast=broadcast, ack=ack), now
            )
        else:
            control = priority | broadcast << 2 | ack << 4
            datagram = header.pack_alone(int(self.id), int(destination), control, payload, self._reserve(1))
            self._push(self._output, datagram, "output_full")
        self.counters["sent"] += 1
        return ticket if ack is Ack.REQUIRED else None

    def receive(self, datagram: bytes | memoryview, now: float) -> None:
        """Process one datagram; malformed ones are counted by reason. Never raises."""
        packets, errors = judp.unpack_all(datagram)
        for packet in packets:
            self._receive_packet(packet, now)
        for error in errors:
            self.counters.drop(f"malformed.{error.reason}", error)

    def change_id(self, id: JausID) -> None:
        """Change the id; messages that are not acknowledged yet count as not delivered."""
        self._transfers.abandon()
        self.id = id

    def poll_output(self) -> list[bytes]:
        """The datagrams to send now, in order."""
        out = list(self._output)
        self._output.clear()
        return out

    def next_event(self) -> Packet | None:
        """The next received message, reassembled if it was fragmented, or None."""
        return self._input.popleft() if self._input else None

    def next_outcome(self) -> DeliveryOutcome | None:
        """The next outcome of a message that requested an ACK, or None."""
        return self._transfers.next_outcome()

    def next_timeout(self) -> float | None:
        """Time at which `handle_timeout` is to be called, or None."""
        times = (self._transfers.next_timeout(), self._reassembly.next_timeout())
        return min((time for time in times if time is not None), default=None)

    def handle_timeout(self, now: float, *, room: bool = True) -> None:
        """Resend or give up packets, drop incomplete messages, and send more fragments if the transport has `room`."""
        self._transfers.handle_timeout(now, room=room)
        self._reassembly.handle_timeout(now)

    def _receive_packet(self, packet: Packet, now: float) -> None:
        if not addressing.reaches(int(packet.destination), int(self.id)):
            self.counters.drop("not_for_us", packet.destination)
        elif packet.ack is Ack.REQUIRED and packet.source.is_wildcard:
            self.counters.drop("wildcard_source", f"{packet.source}: an ACK would go to all")
        elif packet.ack is Ack.ACK:
            known = self._transfers.acknowledge(int(packet.source), packet.sequence, now)
            self.counters["received.ack" if known else "received.ack_unexpected"] += 1
        elif packet.ack is Ack.NAK:
            known = self._transfers.reject(int(packet.source), packet.sequence, now)
            self.counters["received.nak" if known else "received.nak_unexpected"] += 1
        elif self._accept(packet, now):
            self._acknowledge(packet)

    def _accept(self, packet: Packet, now: float) -> bool:
        """True when the packet, or an earlier copy of it, was accepted."""
        source, content = int(packet.source), hash((packet.payload, packet.destination))
        if self._duplicates.seen(source, packet.sequence, content, now, resent=packet.ack is Ack.REQUIRED):
            self.counters.drop("duplicate", packet.source)
            return True
        if packet.ack is Ack.REQUIRED and len(self._input) >= MAX_QUEUED:
            self.counters.drop("input_full_not_acknowledged", packet.source)
            return False
        message: Packet | None = packet
        if packet.data_flag is not DataFlag.SINGLE:
            kept, message = self._reassembly.add(packet, content, now)
            if not kept:
                return False
        if message is not None:
            self._queue_message(message)
        self._duplicates.add(source, packet.sequence, content, now)
        return True

    def _queue_message(self, packet: Packet) -> None:
        if packet.payload:
            self._push(self._input, packet, "input_full")
            self.counters["received"] += 1
        else:
            self.counters["received.empty"] += 1

    def _acknowledge(self, packet: Packet) -> None:
        if packet.ack is Ack.REQUIRED and packet.destination == self.id:
            self._emit(Packet(self.id, packet.source, b"", packet.sequence, packet.priority, ack=Ack.ACK))
            self.counters["sent.ack"] += 1

    def _reserve(self, count: int) -> int:
        """The first of `count` sequence numbers."""
        first = self._sequence
        self._sequence = (first + count) & 0xFFFF
        return first

    def _emit(self, packet: Packet) -> None:
        self._push(self._output, judp.pack(packet), "output_full")

    def _push(self, queue: deque[_Item], item: _Item, reason: str) -> None:
        if len(queue) >= MAX_QUEUED:
            queue.popleft()
            self.counters.drop(reason)
        queue.append(item)
