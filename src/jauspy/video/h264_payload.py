"""H.264 in RTP payloads (RFC 6184): packetising and reassembly of NAL units (ITU-T H.264, 7.4.1 and annex B)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.video.rtp import RtpPacket

IDR: Final = 5
SPS: Final = 7
PPS: Final = 8
"""Types of NAL units: a slice of an IDR picture, and the parameter sets that decoders need first."""

START_CODE: Final = b"\x00\x00\x00\x01"

MAX_PACKET: Final = 1400
"""Bytes of an RTP packet with its header; with UDP, IP and a tunnel it fits into an Ethernet frame of 1500 bytes."""
PARITY_OVERHEAD: Final = 17
"""Bytes by which a parity packet is longer than the longest packet that it protects."""
MAX_PAYLOAD: Final = MAX_PACKET - 12 - PARITY_OVERHEAD
STAP_A: Final = 24
FU_A: Final = 28
"""Types of payloads that are not a single NAL unit: an aggregation packet and a fragmentation unit."""
FU_START: Final = 0x80
FU_END: Final = 0x40
_NRI: Final = 0x60
MAX_PICTURE_SIZE: Final = 8 << 20
"""Bytes of one picture; larger ones are dropped."""
MAX_MISORDER: Final = 100
"""Packets by which one may be late; one that is further behind is the first after a long gap (RFC 3550, A.1)."""

_STARTS: Final = re.compile(rb"\x00\x00\x01")


def nal_type(nal: bytes) -> int:
    """The type of a NAL unit, 0..31."""
    return nal[0] & 0x1F


def split_nals(stream: bytes) -> list[bytes]:
    """The NAL units of a byte stream (annex B), without start codes and the zeros that may follow a unit."""
    marks = [match.span() for match in _STARTS.finditer(stream)]
    ends = [start for start, _ in marks[1:]] + [len(stream)]
    units = [stream[begin:end].rstrip(b"\x00") for (_, begin), end in zip(marks, ends, strict=True)]
    return [unit for unit in units if unit]


def join_nals(nals: Iterable[bytes]) -> bytes:
    """A byte stream (annex B) of NAL units."""
    return b"".join(START_CODE + nal for nal in nals)


def packetise(nals: Sequence[bytes], limit: int = MAX_PAYLOAD) -> list[bytes]:
    """The payloads, in order, that carry the NAL units of one picture; none is longer than `limit` bytes."""
    made: list[bytes] = []
    for group in _payload_groups(nals, limit):
        if len(group) > 1:
            made.append(_aggregate(group))
        elif len(group[0]) <= limit:
            made.append(group[0])
        else:
            made.extend(_fragments(group[0], limit))
    return made


def _payload_groups(nals: Sequence[bytes], limit: int) -> Iterator[list[bytes]]:
    """Groups of consecutive NAL units that fit into one payload."""
    group: list[bytes] = []
    size = 1
    for nal in nals:
        if group and size + 2 + len(nal) > limit:
            yield group
            group, size = [], 1
        group.append(nal)
        size += 2 + len(nal)
    if group:
        yield group


def _aggregate(nals: Sequence[bytes]) -> bytes:
    importance = max(nal[0] & _NRI for nal in nals)
    return bytes([importance | STAP_A]) + b"".join(len(nal).to_bytes(2, "big") + nal for nal in nals)


def _fragments(nal: bytes, limit: int) -> Iterator[bytes]:
    indicator, kind = nal[0] & _NRI | FU_A, nal[0] & 0x1F
    room = limit - 2
    for begin in range(1, len(nal), room):
        place = (FU_START if begin == 1 else 0) | (FU_END if begin + room >= len(nal) else 0)
        yield bytes([indicator, place | kind]) + nal[begin : begin + room]


@dataclass(frozen=True, slots=True)
class Picture:
    """The NAL units of one picture; `whole` when none of its packets was lost; `source` is the SSRC of its clock."""

    timestamp: int
    nals: tuple[bytes, ...]
    whole: bool
    source: int = 0

    @property
    def is_idr(self) -> bool:
        """True when a decoder can start with it."""
        return any(nal_type(unit) == IDR for unit in self.nals)


class Depacketiser:
    """Reassembles pictures from the packets of one source. Late packets count as lost: nothing waits for them.

    Counters: `packets`, `lost` (numbers left out), `late` (numbers passed already), `malformed`, `pictures`, `damaged`
    (incomplete pictures), `oversize`, `sources` (changes of the source).
    """

    def __init__(self) -> None:
        self.counters: Counter[str] = Counter()
        self._ssrc = -1  # no source
        self._expected = 0
        self._timestamp = 0
        self._nals: list[bytes] = []
        self._size = 0
        self._fragment: bytearray | None = None
        self._whole = True
        self._started = False

    def feed(self, packet: RtpPacket) -> list[Picture]:
        """Take a packet; returns the pictures that it completes: none, one, or two when the end of one was lost."""
        if packet.ssrc != self._ssrc:
            self._start_source(packet)
        ahead = (packet.sequence - self._expected) & 0xFFFF
        if 0x10000 - ahead <= MAX_MISORDER:
            self.counters["late"] += 1
            return []
        self.counters["packets"] += 1
        done = self._end_without_marker() if self._started and packet.timestamp != self._timestamp else []
        if ahead:
            self.counters["lost"] += ahead
            self._whole, self._fragment = False, None
        self._expected = (packet.sequence + 1) & 0xFFFF
        self._timestamp, self._started = packet.timestamp, True
        self._take(packet.payload)
        return done + self._finish() if packet.marker else done

    def _start_source(self, packet: RtpPacket) -> None:
        self.counters["sources"] += 1
        self._ssrc, self._expected = packet.ssrc, packet.sequence
        self._clear(packet.timestamp)

    def _clear(self, timestamp: int) -> None:
        self._timestamp = timestamp
        self._nals = []
        self._size = 0
        self._fragment = None
        self._whole = True
        self._started = False

    def _take(self, payload: bytes) -> None:
        self._size += len(payload)
        if self._size > MAX_PICTURE_SIZE:
            self.counters["oversize"] += 1
            self._nals, self._fragment, self._whole = [], None, False
            return
        try:
            self._unpack(payload)
        except ProtocolError:
            self.counters["malformed"] += 1
            self._whole = False

    def _unpack(self, payload: bytes) -> None:
        match nal_type(payload):
            case kind if 1 <= kind < STAP_A:
                self._nals.append(payload)
            case kind if kind == STAP_A:
                self._nals.extend(_disaggregate(payload))
            case kind if kind == FU_A:
                self._add_fragment(payload)
            case kind:
                raise ProtocolError("payload", f"type {kind}")

    def _add_fragment(self, payload: bytes) -> None:
        if len(payload) < 3:
            raise ProtocolError("payload", "a fragment without content")
        if payload[1] & FU_START:
            self._fragment = bytearray([payload[0] & 0xE0 | payload[1] & 0x1F])
        if self._fragment is None:  # its beginning was lost
            self._whole = False
            return
        self._fragment += payload[2:]
        if payload[1] & FU_END:
            self._nals.append(bytes(self._fragment))
            self._fragment = None

    def _end_without_marker(self) -> list[Picture]:
        self._whole = False
        return self._finish()

    def _finish(self) -> list[Picture]:
        """The picture that ends here, as a list; empty without a NAL unit."""
        whole = self._whole and self._fragment is None
        picture = Picture(self._timestamp, tuple(self._nals), whole, self._ssrc)
        self._clear(self._timestamp)
        self.counters["damaged"] += not whole
        if not picture.nals:
            return []
        self.counters["pictures"] += 1
        return [picture]


def _disaggregate(payload: bytes) -> list[bytes]:
    found, offset = [], 1
    while offset < len(payload):
        length = int.from_bytes(payload[offset : offset + 2], "big")
        unit = payload[offset + 2 : offset + 2 + length]
        if not unit or len(unit) < length:
            raise ProtocolError("payload", "units that do not add up")
        found.append(unit)
        offset += 2 + length
    return found
