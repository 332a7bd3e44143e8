"""Reliable delivery (AS5669A): messages that need an ACK, or more than one packet, until they are sent or given up.

Large messages to one destination are sent one after the other; a small message does not wait for them.
"""

from __future__ import annotations

import math
from collections import OrderedDict, deque
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Final, NamedTuple

from jauspy.errors import ConfigError, ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import header
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Ack, DataFlag, Packet

MAX_MESSAGE_SIZE: Final = 64 << 20
"""Bytes: a quarter of all sequence numbers."""
MAX_TRANSFERS: Final = 256
FRAGMENTS_PER_BURST: Final = 16
"""Fragments of an unacknowledged large message that are sent in one burst."""
BURST_INTERVAL: Final = 0.005
"""Seconds between bursts: about 13 MB/s, which a local socket with a queue of ten datagrams can take."""


@dataclass(frozen=True, slots=True)
class Delivery:
    """Settings of reliable delivery. Times in seconds, sizes in bytes.

    `ack_timeout` and `resends` are those of other stacks. `max_message` is for messages sent and received.
    `source_memory` bounds the incomplete messages of one source, `total_memory` those of all; by default two and eight
    times `max_message`. Raises `ConfigError` for values out of range.
    """

    ack_timeout: float = 0.1
    resends: int = 3
    window: int = 8
    """Fragments of one large message that await their ACK at once; they fit the smallest buffer of known peers."""
    max_message: int = 1 << 20
    source_memory: int = 0
    total_memory: int = 0
    fragment_timeout: float = 3.0
    """Seconds that an incomplete message waits for its next fragment."""

    def __post_init__(self) -> None:
        if not (self.ack_timeout > 0 and self.fragment_timeout > 0 and self.resends >= 0 and 1 <= self.window <= 256):
            raise ConfigError("delivery needs ack_timeout and fragment_timeout above 0, resends from 0, window 1..256")
        if not 1 <= self.max_message <= MAX_MESSAGE_SIZE:
            raise ConfigError(f"delivery max_message = {self.max_message} is outside 1..{MAX_MESSAGE_SIZE}")
        object.__setattr__(self, "source_memory", self.source_memory or 2 * self.max_message)
        object.__setattr__(self, "total_memory", self.total_memory or 8 * self.max_message)

    @property
    def resend_period(self) -> float:
        """Seconds in which a packet may be resent because its ACK was lost, twice, to allow for network delay."""
        return 2 * self.ack_timeout * (self.resends + 1)


class DeliveryOutcome(NamedTuple):
    """The outcome of a message that requested an ACK; `ticket` is what `Endpoint.send` returned."""

    ticket: int
    delivered: bool
    unresponsive: JausID | None = None
    """The destination that did not acknowledge after all resends; None if the message was given up otherwise."""


def fragment_count(size: int) -> int:
    """The number of packets that a payload of `size` bytes needs."""
    return max(1, -(-size // header.MAX_PAYLOAD))


def fragment_at(payload: bytes, index: int) -> tuple[bytes, DataFlag]:
    """One fragment of a payload, and its data flag."""
    last = fragment_count(len(payload)) - 1
    part = payload[index * header.MAX_PAYLOAD : (index + 1) * header.MAX_PAYLOAD]
    if last == 0:
        return part, DataFlag.SINGLE
    if index == 0:
        return part, DataFlag.FIRST
    return part, DataFlag.LAST if index == last else DataFlag.MIDDLE


@dataclass(slots=True, eq=False)
class _Transfer:
    """One message; `packet` has all of its payload. `unacknowledged` counts fragments that await their ACK."""

    ticket: int
    packet: Packet
    fragments: int
    sent: int = 0
    unacknowledged: int = 0

    @property
    def reliable(self) -> bool:
        """True when each fragment is to be acknowledged."""
        return self.packet.ack is Ack.REQUIRED

    def fragment(self, index: int) -> Packet:
        payload, flag = fragment_at(self.packet.payload, index)
        number = (self.packet.sequence + index) & 0xFFFF
        return replace(self.packet, payload=payload, data_flag=flag, sequence=number)


@dataclass(slots=True)
class _LargeMessages:
    """The large messages to one destination; only the first is being sent. `budget` is what is left of a burst."""

    queue: deque[_Transfer] = field(default_factory=deque)
    next_burst: float = -math.inf
    budget: int = 0

    @property
    def timed(self) -> bool:
        """True when sending continues with time, not with ACKs."""
        return not self.queue or not self.queue[0].reliable


class _PendingAck(NamedTuple):
    """A packet that awaits its ACK; `fragment` is its index within the message."""

    transfer: _Transfer
    fragment: int
    deadline: float
    resends: int


class Transfers:
    """Sends messages that need an ACK or fragments. Sans-I/O.

    `emit` sends a packet, `reserve(n)` returns the first of n consecutive sequence numbers.
    """

    def __init__(
        self, settings: Delivery, counters: Counters, emit: Callable[[Packet], None], reserve: Callable[[int], int]
    ) -> None:
        self._settings = settings
        self._counters = counters
        self._emit = emit
        self._reserve = reserve
        self._ticket = 0
        self._count = 0
        self._bytes = 0
        self._congested = False
        self._large: dict[int, _LargeMessages] = {}
        self._pending: OrderedDict[tuple[int, int], _PendingAck] = OrderedDict()
        self._outcomes: deque[DeliveryOutcome] = deque(maxlen=4 * MAX_TRANSFERS)

    def __len__(self) -> int:
        return self._count

    def start(self, packet: Packet, now: float) -> int:
        """Start sending; the sequence number is assigned later. Returns a ticket.

        Raises `ProtocolError` when the limits of messages or bytes are reached.
        """
        size = len(packet.payload)
        if self._congested and self._is_full(size):
            self._drop_unreliable(size)
        if self._is_full(size):
            raise ProtocolError("too_much_under_way", f"{self._count} messages wait to be sent or acknowledged")
        self._ticket += 1
        self._count += 1
        self._bytes += size
        transfer = _Transfer(self._ticket, packet, fragment_count(size))
        if transfer.fragments == 1:
            self._send_fragments(transfer, 1, now)
        else:
            large = self._large.setdefault(int(packet.destination), _LargeMessages())
            large.queue.append(transfer)
            if len(large.queue) == 1:
                self._continue(large, now)
        return self._ticket

    def acknowledge(self, source: int, sequence: int, now: float) -> bool:
        """Handle an ACK; false when no packet awaits it."""
        pending = self._pending.pop((source, sequence), None)
        if pending is None:
            return False
        transfer = pending.transfer
        transfer.unacknowledged -= 1
        if transfer.sent < transfer.fragments:
            self._send_fragments(transfer, 1, now)
        elif not transfer.unacknowledged:
            self._finish(transfer, now, delivered=True)
        return True

    def reject(self, source: int, sequence: int, now: float) -> bool:
        """Handle a NAK by resending the packet immediately; false when no packet awaits it."""
        pending = self._pending.get((source, sequence))
        if pending is not None:
            self._resend(pending, now)
        return pending is not None

    def abandon(self) -> None:
        """Give up all messages."""
        transfers = {pending.transfer.ticket: pending.transfer for pending in self._pending.values()}
        transfers |= {fragment.ticket: fragment for large in self._large.values() for fragment in large.queue}
        for transfer in transfers.values():
            self._forget(transfer)
            if transfer.reliable:
                self._counters["undelivered"] += 1
                self._outcomes.append(DeliveryOutcome(transfer.ticket, delivered=False))
        self._pending.clear()
        self._large.clear()

    def next_outcome(self) -> DeliveryOutcome | None:
        """The next outcome, or None."""
        return self._outcomes.popleft() if self._outcomes else None

    def next_timeout(self) -> float | None:
        """Time at which `handle_timeout` is to be called, or None."""
        times = [large.next_burst for large in self._large.values() if large.timed]
        if self._pending:
            times.append(next(iter(self._pending.values())).deadline)
        return min(times, default=None)

    def handle_timeout(self, now: float, *, room: bool = True) -> None:
        """Resend unacknowledged packets, and, if there is room, send more fragments of unreliable large messages."""
        self._congested = not room
        while self._pending:
            pending = next(iter(self._pending.values()))
            if now < pending.deadline:
                break
            self._resend(pending, now)
        for destination, large in list(self._large.items()):
            if now >= large.next_burst:
                if not large.queue:
                    del self._large[destination]
                elif large.timed and room:
                    self._continue(large, now)
                elif large.timed:
                    large.next_burst = now + BURST_INTERVAL

    def _is_full(self, size: int) -> bool:
        return self._count >= MAX_TRANSFERS or self._bytes + size > self._settings.total_memory

    def _drop_unreliable(self, size: int) -> None:
        """While the transport is congested, large messages without ACK make room for newer ones; they are counted."""
        for large in self._large.values():
            while large.queue and large.timed and self._is_full(size):
                self._forget(large.queue.popleft())
                self._counters["dropped.large_message.stuck"] += 1

    def _continue(self, large: _LargeMessages, now: float) -> None:
        """Send what may be sent now of the large messages to one destination."""
        if now >= large.next_burst:
            large.budget, large.next_burst = FRAGMENTS_PER_BURST, now + BURST_INTERVAL
        while large.queue and large.budget:
            transfer = large.queue[0]
            if transfer.reliable:
                self._send_fragments(transfer, self._settings.window - transfer.unacknowledged, now)
                return
            large.budget -= self._send_fragments(transfer, large.budget, now)
            if transfer.sent == transfer.fragments:
                large.queue.popleft()
                self._forget(transfer)

    def _send_fragments(self, transfer: _Transfer, limit: int, now: float) -> int:
        """Send up to `limit` more fragments; returns their number."""
        if not transfer.sent:
            transfer.packet = replace(transfer.packet, sequence=self._reserve(transfer.fragments))
        count = min(limit, transfer.fragments - transfer.sent)
        for index in range(transfer.sent, transfer.sent + count):
            packet = transfer.fragment(index)
            self._emit(packet)
            if transfer.reliable:
                transfer.unacknowledged += 1
                self._expect_ack(transfer, index, packet, now)
        transfer.sent += count
        return count

    def _expect_ack(self, transfer: _Transfer, index: int, packet: Packet, now: float, resends: int = 0) -> None:
        """All packets have the same timeout, so `_pending` is in the order of the deadlines."""
        key = (int(packet.destination), packet.sequence)
        self._pending[key] = _PendingAck(transfer, index, now + self._settings.ack_timeout, resends)
        self._pending.move_to_end(key)

    def _resend(self, pending: _PendingAck, now: float) -> None:
        if pending.resends >= self._settings.resends:
            for key in [item for item, other in self._pending.items() if other.transfer is pending.transfer]:
                del self._pending[key]
            self._finish(pending.transfer, now, delivered=False)
            return
        self._counters["resent"] += 1
        packet = pending.transfer.fragment(pending.fragment)
        self._expect_ack(pending.transfer, pending.fragment, packet, now, pending.resends + 1)
        self._emit(packet)

    def _finish(self, transfer: _Transfer, now: float, *, delivered: bool) -> None:
        self._counters["delivered" if delivered else "undelivered"] += 1
        destination = transfer.packet.destination
        self._outcomes.append(DeliveryOutcome(transfer.ticket, delivered, None if delivered else destination))
        self._forget(transfer)
        large = self._large.get(int(destination))
        if large is not None and large.queue and large.queue[0] is transfer:
            large.queue.popleft()
            self._continue(large, now)

    def _forget(self, transfer: _Transfer) -> None:
        self._count -= 1
        self._bytes -= len(transfer.packet.payload)
