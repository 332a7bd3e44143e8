"""The settings of reliable delivery and large messages, and how a message that asked for an answer ended."""

from __future__ import annotations

import math
from collections import OrderedDict, deque
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Final, NamedTuple

from jauspy.errors import ConfigError, ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import reassembly
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Ack, Packet

MAX_MESSAGE_SIZE: Final = 64 << 20
"""Bytes of a message at most: a quarter of all sequence numbers."""


@dataclass(frozen=True, slots=True)
class Delivery:
    """Times in seconds, sizes in bytes. `ack_timeout` and `resends` are what other stacks use.

    `max_message` is for messages sent and received. `source_memory` bounds the incomplete messages of one source,
    `total_memory` those of all; by default two and eight times `max_message`.
    """

    ack_timeout: float = 0.1
    resends: int = 3
    window: int = 8
    """Pieces of one large message that wait for their ACK at once; they fit the smallest buffer of known peers."""
    max_message: int = 1 << 20
    source_memory: int = 0
    total_memory: int = 0
    patience: float = 3.0
    """How long the missing pieces of a message may stay out."""

    def __post_init__(self) -> None:
        if not (self.ack_timeout > 0 and self.patience > 0 and self.resends >= 0 and 1 <= self.window <= 256):
            raise ConfigError("delivery needs ack_timeout and patience above 0, resends from 0, window 1..256")
        if not 1 <= self.max_message <= MAX_MESSAGE_SIZE:
            raise ConfigError(f"delivery max_message = {self.max_message} is outside 1..{LARGEST}")
        object.__setattr__(self, "source_memory", self.source_memory or 2 * self.max_message)
        object.__setattr__(self, "total_memory", self.total_memory or 8 * self.max_message)

    @property
    def memory_of_resends(self) -> float:
        """Seconds in which a packet may come again because its ACK was lost; as much again for the network's delay."""
        return 2 * self.ack_timeout * (self.resends + 1)


class DeliveryOutcome(NamedTuple):
    """How a message that wanted to be acknowledged ended; `ticket` is what `send` returned."""

    ticket: int
    delivered: bool
    silent: JausID | None = None
    """Who did not acknowledge after all resends; None when it was given up for another reason."""


MAX_TRANSFERS: Final = 256
FRAGMENTS_PER_BURST: Final = 16
"""Pieces of a large message that nobody acknowledges, sent at once."""
BURST_INTERVAL: Final = 0.005
"""Seconds from one such burst to the next: about 13 MB/s, which a local socket with a queue of ten datagrams takes."""


@dataclass(slots=True, eq=False)
class _Transfer:
    """One message; `packet` carries all of its payload."""

    ticket: int
    packet: Packet
    pieces: int
    sent: int = 0
    under_way: int = 0

    @property
    def reliable(self) -> bool:
        """True when each piece is to be acknowledged."""
        return self.packet.ack is Ack.REQUIRED

    def piece(self, index: int) -> Packet:
        """One of its packets."""
        payload, flag = reassembly.fragment_at(self.packet.payload, index)
        number = (self.packet.sequence + index) & 0xFFFF
        return replace(self.packet, payload=payload, data_flag=flag, sequence=number)


@dataclass(slots=True)
class _LargeMessageQueue:
    """The large messages for one destination; only the first one is being sent. `budget` is what is left of a turn."""

    waiting: deque[_Transfer] = field(default_factory=deque)
    next_turn: float = -math.inf
    budget: int = 0

    @property
    def timed(self) -> bool:
        """True when it goes on by time, not by ACKs."""
        return not self.waiting or not self.waiting[0].reliable


class _PendingAck(NamedTuple):
    """A packet that waits for its ACK; `piece` is its number within the message."""

    transfer: _Transfer
    piece: int
    deadline: float
    resends: int


class Transfers:
    """Sans-I/O. `emit` sends a packet now, `reserve(n)` gives the first of n consecutive sequence numbers."""

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
        self._stuck = False
        self._lanes: dict[int, _LargeMessageQueue] = {}
        self._flights: OrderedDict[tuple[int, int], _PendingAck] = OrderedDict()
        self._outcomes: deque[DeliveryOutcome] = deque(maxlen=4 * MAX_TRANSFERS)

    def __len__(self) -> int:
        return self._count

    def start(self, packet: Packet, now: float) -> int:
        """Begin; its number is given later. Returns the ticket; raises `ProtocolError` when too much is under way."""
        size = len(packet.payload)
        if self._stuck and self._is_full(size):
            self._give_way(size)
        if self._is_full(size):
            raise ProtocolError("too_much_under_way", f"{self._count} messages wait to be sent or acknowledged")
        self._ticket += 1
        self._count += 1
        self._bytes += size
        transfer = _Transfer(self._ticket, packet, reassembly.fragment_count(size))
        if transfer.pieces == 1:
            self._send_pieces(transfer, 1, now)
        else:
            lane = self._lanes.setdefault(int(packet.destination), _LargeMessageQueue())
            lane.waiting.append(transfer)
            if len(lane.waiting) == 1:
                self._pump(lane, now)
        return self._ticket

    def _is_full(self, size: int) -> bool:
        return self._count >= MAX_TRANSFERS or self._bytes + size > self._settings.total_memory

    def _give_way(self, size: int) -> None:
        """While nothing gets out, what nobody acknowledges gives way to what is newer; it is counted."""
        for lane in self._lanes.values():
            while lane.waiting and lane.timed and self._is_full(size):
                self._forget(lane.waiting.popleft())
                self._counters["dropped.large_message.stuck"] += 1

    def acknowledge(self, source: int, sequence: int, now: float) -> bool:
        """An ACK has come; false when nothing waits for it."""
        flight = self._flights.pop((source, sequence), None)
        if flight is None:
            return False
        transfer = flight.transfer
        transfer.under_way -= 1
        if transfer.sent < transfer.pieces:
            self._send_pieces(transfer, 1, now)
        elif not transfer.under_way:
            self._end(transfer, now, delivered=True)
        return True

    def reject(self, source: int, sequence: int, now: float) -> bool:
        """A NAK has come: send the packet again at once; false when nothing waits for it."""
        flight = self._flights.get((source, sequence))
        if flight is not None:
            self._again(flight, now)
        return flight is not None

    def abandon(self) -> None:
        """Give up everything under way."""
        under_way = {each.transfer.ticket: each.transfer for each in self._flights.values()}
        under_way |= {each.ticket: each for lane in self._lanes.values() for each in lane.waiting}
        for transfer in under_way.values():
            self._forget(transfer)
            if transfer.reliable:
                self._counters["undelivered"] += 1
                self._outcomes.append(DeliveryOutcome(transfer.ticket, delivered=False))
        self._flights.clear()
        self._lanes.clear()

    def next_outcome(self) -> DeliveryOutcome | None:
        """How the next message ended, or None."""
        return self._outcomes.popleft() if self._outcomes else None

    def next_timeout(self) -> float | None:
        """When `handle_timeout` wants to be called, or None."""
        times = [lane.next_turn for lane in self._lanes.values() if lane.timed]
        if self._flights:
            times.append(next(iter(self._flights.values())).deadline)
        return min(times, default=None)

    def handle_timeout(self, now: float, *, room: bool = True) -> None:
        """Send again what was not acknowledged, and, if there is room, further pieces of what nobody acknowledges."""
        self._stuck = not room
        while self._flights:
            flight = next(iter(self._flights.values()))
            if now < flight.deadline:
                break
            self._again(flight, now)
        for destination, lane in list(self._lanes.items()):
            if now >= lane.next_turn:
                if not lane.waiting:
                    del self._lanes[destination]
                elif lane.timed and room:
                    self._pump(lane, now)
                elif lane.timed:
                    lane.next_turn = now + BURST_INTERVAL

    def _pump(self, lane: _LargeMessageQueue, now: float) -> None:
        """Send what may be sent now of the large messages for one destination."""
        if now >= lane.next_turn:
            lane.budget, lane.next_turn = FRAGMENTS_PER_BURST, now + BURST_INTERVAL
        while lane.waiting and lane.budget:
            transfer = lane.waiting[0]
            if transfer.reliable:
                self._send_pieces(transfer, self._settings.window - transfer.under_way, now)
                return
            lane.budget -= self._send_pieces(transfer, lane.budget, now)
            if transfer.sent == transfer.pieces:
                lane.waiting.popleft()
                self._forget(transfer)

    def _send_pieces(self, transfer: _Transfer, limit: int, now: float) -> int:
        """Send up to so many further pieces; returns how many."""
        if not transfer.sent:
            transfer.packet = replace(transfer.packet, sequence=self._reserve(transfer.pieces))
        count = min(limit, transfer.pieces - transfer.sent)
        for index in range(transfer.sent, transfer.sent + count):
            packet = transfer.piece(index)
            self._emit(packet)
            if transfer.reliable:
                transfer.under_way += 1
                self._expect(transfer, index, packet, now)
        transfer.sent += count
        return count

    def _expect(self, transfer: _Transfer, piece: int, packet: Packet, now: float, resends: int = 0) -> None:
        """All wait equally long, so the flights are in the order of their deadlines."""
        key = (int(packet.destination), packet.sequence)
        self._flights[key] = _PendingAck(transfer, piece, now + self._settings.ack_timeout, resends)
        self._flights.move_to_end(key)

    def _again(self, flight: _PendingAck, now: float) -> None:
        if flight.resends >= self._settings.resends:
            for each in [each for each, other in self._flights.items() if other.transfer is flight.transfer]:
                del self._flights[each]
            self._end(flight.transfer, now, delivered=False)
            return
        self._counters["resent"] += 1
        packet = flight.transfer.piece(flight.piece)
        self._expect(flight.transfer, flight.piece, packet, now, flight.resends + 1)
        self._emit(packet)

    def _end(self, transfer: _Transfer, now: float, *, delivered: bool) -> None:
        self._counters["delivered" if delivered else "undelivered"] += 1
        silent = None if delivered else transfer.packet.destination
        self._outcomes.append(DeliveryOutcome(transfer.ticket, delivered, silent))
        self._forget(transfer)
        lane = self._lanes.get(int(transfer.packet.destination))
        if lane is not None and lane.waiting and lane.waiting[0] is transfer:
            lane.waiting.popleft()
            self._pump(lane, now)

    def _forget(self, transfer: _Transfer) -> None:
        self._count -= 1
        self._bytes -= len(transfer.packet.payload)
