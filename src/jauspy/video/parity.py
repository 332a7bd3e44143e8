"""Parity packets, which restore lost packets of a stream without asking for them again.

A parity packet is a linear combination, over GF(2^8) and with coefficients from a hash, of the last packets of the
stream (a sliding window, as in RFC 8681), which are sent as without it. Any parity packet replaces any lost one of its
window, so that random losses and bursts are restored alike.
"""

from __future__ import annotations

import struct
from collections import Counter, deque
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError
from jauspy.video.h264_payload import MAX_MISORDER, PARITY_OVERHEAD
from jauspy.video.rtp import PARITY_TYPE, RtpPacket

WINDOW: Final = 64
"""Packets that a parity packet combines at most: 5 pictures of 15 a second at 2 Mbit/s."""
MAX_AGE: Final = 0.45
"""Seconds of packets that are combined at most: an older one is of no use."""
HOLD: Final = 0.3
"""Seconds that packets wait for one that is missing."""
ACTIVE_TIME: Final = 2.0
"""Seconds after the last parity packet in which packets wait for a missing one."""
MAX_AHEAD: Final = 512
"""Packets that wait at most; a larger gap is a new beginning."""
KEPT: Final = 2 * WINDOW
"""Packets that are kept after they were handed out, for parity packets that combine them."""
MAX_ROWS: Final = WINDOW // 2
"""Combinations of lost packets that are kept; one of more lost packets is not used."""

_HEAD: Final = struct.Struct("!IHBBH")
"""SSRC of the stream, sequence number of the first packet, how many, 0, and the key of the coefficients."""
_SYMBOL: Final = struct.Struct("!HBI")
"""What is combined before the payload: its length, the marker bit with the payload type, and the time stamp."""
MAX_SYMBOL: Final = 1500
"""Bytes."""
assert _HEAD.size + _SYMBOL.size == PARITY_OVERHEAD
_POLYNOMIAL: Final = 0x11D


@cache
def _powers() -> tuple[bytes, bytes]:
    """Powers of the generator 2 of GF(2^8) twice over, and logarithms."""
    powers, logarithms, value = bytearray(510), bytearray(256), 1
    for exponent in range(255):
        powers[exponent] = powers[exponent + 255] = value
        logarithms[value] = exponent
        value = value << 1 ^ (_POLYNOMIAL if value & 0x80 else 0)
    return bytes(powers), bytes(logarithms)


@cache
def _products(factor: int) -> bytes:
    """The products of all 256 numbers with a factor that is not 0, for `bytes.translate`."""
    powers, logarithms = _powers()
    shift = logarithms[factor]
    return bytes([0] + [powers[logarithms[number] + shift] for number in range(1, 256)])


def _inverse(factor: int) -> int:
    powers, logarithms = _powers()
    return powers[255 - logarithms[factor]]


def _times(value: int, factor: int) -> int:
    """A row of bytes, as a number, times a factor."""
    if factor == 1:
        return value
    return int.from_bytes(value.to_bytes(MAX_SYMBOL, "little").translate(_products(factor)), "little")


def coefficient(key: int, sequence: int) -> int:
    """The coefficient, 1..255, of a packet in a parity packet with that key."""
    value = (key << 16 | sequence & 0xFFFF) * 0x9E3779B1 & 0xFFFFFFFF
    value = (value ^ value >> 15) * 0x85EBCA77 & 0xFFFFFFFF
    return 1 + (value ^ value >> 13) % 255


def _symbol(packet: RtpPacket) -> bytes:
    second = packet.payload_type | (0x80 if packet.marker else 0)
    return _SYMBOL.pack(len(packet.payload), second, packet.timestamp) + packet.payload


def _product(packet: RtpPacket, factor: int) -> int:
    return int.from_bytes(_symbol(packet).translate(_products(factor)), "little")


class ParityEncoder:
    """Makes the parity packets of one stream, which have a source (SSRC) and sequence numbers of their own."""

    def __init__(self, ssrc: int, sequence: int = 0) -> None:
        self._ssrc, self._sequence = ssrc, sequence
        self._window: deque[tuple[float, RtpPacket]] = deque(maxlen=WINDOW)
        self._since, self._owed = 0, 0.0

    def add(self, packet: RtpPacket, share: float, now: float) -> Iterator[bytes]:
        """A packet that is sent at `now` (monotonic seconds), and what follows it.

        `share` is the number of parity packets for each packet, which come at the end of a picture or of half a window.
        """
        self._window.append((now, packet))
        self._since += 1
        self._owed += share
        if packet.marker or self._since >= WINDOW // 2:
            while self._window[0][0] < now - MAX_AGE:
                self._window.popleft()
            count, self._since = int(self._owed), 0
            self._owed -= count
            for _ in range(count):
                yield self._parity(packet)

    def _parity(self, last: RtpPacket) -> bytes:
        key, value, size = self._sequence, 0, 0
        for _, packet in self._window:
            value ^= _product(packet, coefficient(key, packet.sequence))
            size = max(size, len(packet.payload))
        head = _HEAD.pack(last.ssrc, self._window[0][1].sequence, len(self._window), 0, key)
        payload = head + value.to_bytes(_SYMBOL.size + size, "little")
        self._sequence = (self._sequence + 1) & 0xFFFF
        return RtpPacket(key, last.timestamp, self._ssrc, payload, payload_type=PARITY_TYPE).encode()


class _Combination(NamedTuple):
    """The payload of a parity packet."""

    source: int
    first: int
    length: int
    key: int
    value: int

    @classmethod
    def decode(cls, payload: bytes) -> _Combination:
        if not _HEAD.size + _SYMBOL.size < len(payload) <= _HEAD.size + MAX_SYMBOL:
            raise ProtocolError("malformed", "a parity packet of that length")
        source, first, count, _, key = _HEAD.unpack_from(payload)
        if not 0 < count <= WINDOW:
            raise ProtocolError("malformed", f"parity of {count} packets")
        return cls(source, first, count, key, int.from_bytes(payload[_HEAD.size :], "little"))


def parity_source(packet: RtpPacket) -> int | None:
    """The stream (SSRC) that a parity packet is for; None for other packets."""
    if packet.payload_type != PARITY_TYPE or len(packet.payload) < _HEAD.size:
        return None
    return int(_HEAD.unpack_from(packet.payload)[0])


@dataclass(slots=True)
class _Row:
    """A combination of missing packets, by their numbers."""

    coefficients: dict[int, int]
    value: int

    def subtract(self, other: _Row, factor: int) -> None:
        for number, coefficient_ in other.coefficients.items():
            product = _products(factor)[coefficient_]
            left = self.coefficients.get(number, 0) ^ product
            if left:
                self.coefficients[number] = left
            else:
                del self.coefficients[number]
        self.value ^= _times(other.value, factor)


@dataclass(slots=True)
class PacketRepair:
    """Hands out the packets of one stream in order, with lost ones restored; until parity comes it holds none back.

    Counters: `parity` packets, `repaired` packets, `missing` ones (not there when the next one came, repaired or not),
    `malformed`.
    """

    counters: Counter[str] = field(default_factory=Counter)
    _next: int = -1
    """The number of the packet to hand out next: its sequence number, and 2**16 for each round."""
    _held: dict[int, RtpPacket] = field(default_factory=dict)
    _known: dict[int, RtpPacket] = field(default_factory=dict)
    _rows: dict[int, _Row] = field(default_factory=dict)
    """By the first number of each, which is in no other."""
    _highest: int = -1
    _parity_at: float = float("-inf")
    _gap_at: float | None = None

    def feed(self, packet: RtpPacket, now: float) -> list[RtpPacket]:
        """Take a packet of the stream at `now` (monotonic seconds); returns those that are next."""
        if self._next < 0:
            self._restart(packet.sequence)
        ahead = (packet.sequence - self._next) & 0xFFFF
        if 0x10000 - ahead <= MAX_MISORDER:
            return [packet]  # too late: counted where pictures are put together
        if ahead > MAX_AHEAD:
            rest = self._flush()
            self._restart(packet.sequence)
            return [*rest, *self.feed(packet, now)]
        number = self._next + ahead
        if number > self._highest:
            self.counters["missing"] += number - self._highest - 1
            self._highest = number
        elif number not in self._known:
            self.counters["missing"] -= 1  # it was only late
        if number not in self._held:
            self._learn(number, packet)
        return self._hand_out(now)

    def feed_parity(self, packet: RtpPacket, now: float) -> list[RtpPacket]:
        """Take a parity packet of the stream; returns the packets that are next."""
        self.counters["parity"] += 1
        try:
            combination = _Combination.decode(packet.payload)
        except ProtocolError:
            self.counters["malformed"] += 1
            return []
        self._parity_at = now
        if self._next < 0:
            return []
        off = (combination.first - self._next + 0x8000) % 0x10000 - 0x8000
        if -KEPT <= off <= MAX_AHEAD:
            self._combine(combination, self._next + off)
        return self._hand_out(now)

    def _combine(self, combination: _Combination, first: int) -> None:
        """Use a combination of the packets from this number on, if one of them is missing."""
        numbers = range(first, first + combination.length)
        missing = [number for number in numbers if number not in self._known]
        if not 0 < len(missing) <= MAX_ROWS:
            return
        row = _Row({number: coefficient(combination.key, number) for number in missing}, combination.value)
        for number in numbers:
            if (known := self._known.get(number)) is not None:
                row.value ^= _product(known, coefficient(combination.key, number))
        self._solve(row)
        self._take_solved()

    def _restart(self, sequence: int) -> None:
        self._held.clear()
        self._known.clear()
        self._rows.clear()
        self._next, self._highest, self._gap_at = sequence, sequence - 1, None

    def _flush(self) -> list[RtpPacket]:
        return [self._held[number] for number in sorted(self._held)]

    def _learn(self, number: int, packet: RtpPacket) -> None:
        """Note a packet that has arrived, or was restored, and use it in the rows."""
        self._held[number] = packet
        if len(packet.payload) > MAX_SYMBOL - _SYMBOL.size:
            self._parity_at = float("-inf")  # of a sender that makes no parity: none of its packets waits
            return
        self._known[number] = packet
        for first in [first for first, row in self._rows.items() if number in row.coefficients]:
            row = self._rows[first]
            row.value ^= _product(packet, row.coefficients.pop(number))
            if first == number:
                del self._rows[first]
                self._solve(row)
        self._take_solved()

    def _solve(self, row: _Row) -> None:
        """Add a row: none has the first number of another."""
        for first in [number for number in row.coefficients if number in self._rows]:
            row.subtract(self._rows[first], row.coefficients[first])
        if not row.coefficients:
            return
        first = min(row.coefficients)
        inverse = _inverse(row.coefficients[first])
        products = _products(inverse)
        row.coefficients = {number: products[factor] for number, factor in row.coefficients.items()}
        row.value = _times(row.value, inverse)
        for other in self._rows.values():
            if first in other.coefficients:
                other.subtract(row, other.coefficients[first])
        self._rows[first] = row
        if len(self._rows) > MAX_ROWS:
            del self._rows[min(self._rows)]

    def _take_solved(self) -> None:
        for number in [first for first, row in self._rows.items() if len(row.coefficients) == 1]:
            packet = self._restored(number, self._rows.pop(number).value)
            if packet is None:
                self.counters["malformed"] += 1
                continue
            self._known[number] = packet
            if number >= self._next and number not in self._held:
                self._held[number] = packet
                self.counters["repaired"] += 1

    def _restored(self, number: int, value: int) -> RtpPacket | None:
        symbol = value.to_bytes(MAX_SYMBOL, "little")
        length, second, timestamp = _SYMBOL.unpack_from(symbol)
        like = next(iter(self._known.values()), None)
        if like is None or not 0 < length <= MAX_SYMBOL - _SYMBOL.size or any(symbol[_SYMBOL.size + length :]):
            return None
        return replace(
            like,
            sequence=number & 0xFFFF,
            timestamp=timestamp,
            payload=symbol[_SYMBOL.size : _SYMBOL.size + length],
            marker=bool(second & 0x80),
            payload_type=second & 0x7F,
        )

    def _hand_out(self, now: float) -> list[RtpPacket]:
        """The packets that are next; a missing one is given up after `HOLD`, at once without parity."""
        done: list[RtpPacket] = []
        is_active = now - self._parity_at < ACTIVE_TIME
        while self._held:
            if (packet := self._held.pop(self._next, None)) is not None:
                done.append(packet)
                self._next += 1
                self._gap_at = None
            elif not is_active or (self._gap_at is not None and now - self._gap_at >= HOLD):
                self._next, self._gap_at = min(self._held), None
            else:
                self._gap_at = now if self._gap_at is None else self._gap_at
                break
        oldest = self._next - KEPT
        for number in [number for number in self._known if number < oldest]:
            del self._known[number]
        for first in [first for first in self._rows if first < oldest]:
            del self._rows[first]
        return done


STEPS: Final = ((0.002, 0.0), (0.015, 0.25), (0.08, 0.5), (1.0, 1.0))
"""Parity packets for each packet, up to these parts of missing packets: more than enough for random losses."""
MEASURED_TIME: Final = 30.0
"""Seconds over which losses are counted: bursts are rare."""
MEASURE_INTERVAL: Final = 0.25
MIN_PACKETS: Final = 100
"""Packets of which a part is taken at least, so that one that is lost at the start is no 5 %."""


@dataclass(slots=True)
class ShareControl:
    """How much parity a receiver needs, by what was missing lately, and a step more when not all was repaired."""

    _samples: deque[tuple[float, int, int, int]] = field(default_factory=deque)
    """Time, packets of the stream, packets that were missing, and those that remained so."""
    _share: float = 0.0

    def share(self, now: float, packets: int, missing: int, lost: int) -> float:
        """Parity packets for each packet; the counts are since the beginning."""
        samples = self._samples
        if not samples or now - samples[-1][0] >= MEASURE_INTERVAL:
            samples.append((now, packets, missing, lost))
            while now - samples[0][0] > MEASURED_TIME:
                samples.popleft()
            _, first_packets, first_missing, first_lost = samples[0]
            part = (missing - first_missing) / max(MIN_PACKETS, packets - first_packets)
            step = next(number for number, (most, _) in enumerate(STEPS) if part <= most)
            self._share = STEPS[min(len(STEPS) - 1, step + (lost > first_lost))][1]
        return self._share
