"""UDP datagrams, and packets of JTCP streams, in captured frames: link layers, IPv4 and IPv6 with fragments."""

from __future__ import annotations

import socket
import struct
from collections import Counter, OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Final, NamedTuple

from jauspy.capture.tcp_streams import TcpStreams

JAUS_PORT: Final = 3794
"""The port that IANA registered for JAUS: JUDP and JTCP."""
MAX_OPEN_PACKETS: Final = 64
"""Maximal number of incomplete IP packets of a capture; the oldest is dropped first."""
MAX_PACKET: Final = 65535

# Link types as the pcap formats number them (https://www.tcpdump.org/linktypes.html). Raw IP has three numbers:
# the registered one, and two that some systems write instead.
NULL: Final = 0
ETHERNET: Final = 1
RAW: Final = (12, 14, 101)
LOOP: Final = 108
LINUX_SLL: Final = 113
IPV4: Final = 228
IPV6: Final = 229
LINUX_SLL2: Final = 276

IP_LINKS: Final = {
    NULL: "null/loopback",
    ETHERNET: "Ethernet",
    LOOP: "OpenBSD loopback",
    LINUX_SLL: "Linux cooked",
    IPV4: "raw IPv4",
    IPV6: "raw IPv6",
    LINUX_SLL2: "Linux cooked v2",
    **dict.fromkeys(RAW, "raw IP"),
}

_IP_TYPES: Final = (0x0800, 0x86DD)
_VLAN_TYPES: Final = (0x8100, 0x88A8, 0x9100)
_FAMILIES: Final = frozenset(number.to_bytes(4, order) for number in (2, 10, 24, 28, 30) for order in ("big", "little"))
"""Address families of IPv4, and of IPv6 as Linux, NetBSD, FreeBSD and macOS number it."""

_V4: Final = struct.Struct(">xxHHHxBxx4s4s")
"""Length, identification, fragment flags and offset, protocol, source and destination of an IPv4 header."""
_OFFSET, _MORE_FRAGMENTS, _FRAGMENTED = 0x1FFF, 0x2000, 0x3FFF
_V6: Final = struct.Struct(">4xHBx16s16s")
"""Length, next header, source and destination of an IPv6 header."""
_V6_OPTIONS: Final = (socket.IPPROTO_HOPOPTS, socket.IPPROTO_ROUTING, socket.IPPROTO_DSTOPTS)
_V6_FRAGMENT: Final = struct.Struct(">BxHI")
_MAX_EXTENSIONS: Final = 8
_UDP: Final = struct.Struct(">HHHxx")
_TCP: Final = struct.Struct(">HHI4xBB")
_TCP_SIZE: Final = 20

MALFORMED_IP: Final = "malformed IP packet"
OTHER_PROTOCOL: Final = "neither UDP nor TCP over IP"
INCOMPLETE: Final = "IP packet with missing fragments"

_Key = tuple[bytes, bytes, int]


class Udp(NamedTuple):
    """One UDP datagram: `source` and `destination` are (address, port)."""

    source: tuple[str, int]
    destination: tuple[str, int]
    payload: bytes


@dataclass(slots=True)
class _Parts:
    fragments: dict[int, bytes] = field(default_factory=dict)
    size: int = 0
    total: int | None = None

    def add(self, offset: int, data: bytes, *, last: bool) -> None:
        if offset not in self.fragments:
            self.fragments[offset] = data
            self.size += len(data)
        if last:
            self.total = offset + len(data)

    def joined(self) -> bytes | None:
        """All bytes in order, or None while some are missing; where fragments overlap, the lower offset wins."""
        if self.total is None:
            return None
        data = bytearray()
        for offset in sorted(self.fragments):
            if offset > len(data):
                return None
            data += self.fragments[offset][len(data) - offset :]
        return bytes(data[: self.total]) if len(data) >= self.total else None


class DatagramAssembler:
    """Reassembles datagrams from IP packets in the order of the capture; `skipped` counts packets left out.

    The packets of a JTCP stream from or to `stream_port` are datagrams, too, as a node manager would send them by UDP.
    """

    def __init__(self, stream_port: int = JAUS_PORT) -> None:
        self.skipped: Counter[str] = Counter()
        self._open: OrderedDict[_Key, _Parts] = OrderedDict()
        self._stream_port = stream_port
        self._streams = TcpStreams(self.skipped)

    def add(self, packet: bytes) -> Sequence[Udp]:
        """The datagrams that this packet contains or completes."""
        version = packet[0] >> 4 if packet else 0
        if version == 4:
            return self._add_v4(packet)
        if version == 6:
            return self._add_v6(packet)
        self.skipped[OTHER_PROTOCOL] += 1
        return ()

    def finish(self) -> None:
        """Count the packets with missing fragments."""
        if self._open:
            self.skipped[INCOMPLETE] += len(self._open)
            self._open.clear()

    def _add_v4(self, packet: bytes) -> Sequence[Udp]:
        start = (packet[0] & 0x0F) * 4
        if len(packet) < _V4.size or not _V4.size <= start <= len(packet):
            self.skipped[MALFORMED_IP] += 1
            return ()
        length, identification, fragment, protocol, source, destination = _V4.unpack_from(packet)
        data = packet[start : length or len(packet)]
        if fragment & _FRAGMENTED and protocol in (socket.IPPROTO_UDP, socket.IPPROTO_TCP):
            key = (source, destination, identification)
            last = not fragment & _MORE_FRAGMENTS
            whole = self._collect(key, (fragment & _OFFSET) * 8, data, last=last)
            if whole is None:
                return ()
            data = whole
        return self._content(protocol, source, destination, data)

    def _add_v6(self, packet: bytes) -> Sequence[Udp]:
        if len(packet) < _V6.size:
            self.skipped[MALFORMED_IP] += 1
            return ()
        length, protocol, source, destination = _V6.unpack_from(packet)
        data = packet[_V6.size : _V6.size + length] if length else packet[_V6.size :]
        for _ in range(_MAX_EXTENSIONS):
            if protocol in _V6_OPTIONS and len(data) >= 8:
                protocol, data = data[0], data[(data[1] + 1) * 8 :]
            elif protocol == socket.IPPROTO_FRAGMENT and len(data) >= _V6_FRAGMENT.size:
                protocol, offset, identification = _V6_FRAGMENT.unpack_from(data)
                key = (source, destination, identification)
                whole = self._collect(key, offset & 0xFFF8, data[_V6_FRAGMENT.size :], last=not offset & 1)
                if whole is None:
                    return ()
                data = whole
            else:
                break
        return self._content(protocol, source, destination, data)

    def _collect(self, key: _Key, offset: int, data: bytes, *, last: bool) -> bytes | None:
        if offset + len(data) > MAX_PACKET:
            self.skipped[MALFORMED_IP] += 1
            return None
        parts = self._open.setdefault(key, _Parts())
        parts.add(offset, data, last=last)
        whole = parts.joined()
        if whole is not None:
            del self._open[key]
        elif parts.size > 2 * MAX_PACKET:
            del self._open[key]
            self.skipped[MALFORMED_IP] += 1
        elif len(self._open) > MAX_OPEN_PACKETS:
            self._open.popitem(last=False)
            self.skipped[INCOMPLETE] += 1
        return whole

    def _content(self, protocol: int, source: bytes, destination: bytes, data: bytes) -> Sequence[Udp]:
        if protocol == socket.IPPROTO_UDP:
            return self._udp(source, destination, data)
        if protocol == socket.IPPROTO_TCP:
            return self._tcp(source, destination, data)
        self.skipped[OTHER_PROTOCOL] += 1
        return ()

    def _udp(self, source: bytes, destination: bytes, data: bytes) -> Sequence[Udp]:
        if len(data) < _UDP.size:
            self.skipped["malformed UDP datagram"] += 1
            return ()
        source_port, destination_port, given = _UDP.unpack_from(data)
        length = given or len(data)
        if length < _UDP.size:
            self.skipped["malformed UDP datagram"] += 1
            return ()
        if length > len(data):
            self.skipped["UDP datagram cut short by the capture"] += 1
            return ()
        return (Udp((_address(source), source_port), (_address(destination), destination_port), data[8:length]),)

    def _tcp(self, source: bytes, destination: bytes, data: bytes) -> Sequence[Udp]:
        if len(data) < _TCP_SIZE:
            self.skipped["malformed TCP segment"] += 1
            return ()
        source_port, destination_port, sequence, offset, flags = _TCP.unpack_from(data)
        start = (offset >> 4) * 4
        if not _TCP_SIZE <= start <= len(data):
            self.skipped["malformed TCP segment"] += 1
            return ()
        if self._stream_port not in (source_port, destination_port):
            self.skipped[f"other TCP port than {self._stream_port}"] += 1
            return ()
        sender, receiver = (_address(source), source_port), (_address(destination), destination_port)
        packets = self._streams.add((sender, receiver), sequence, flags, data[start:])
        return [Udp(sender, receiver, packet) for packet in packets]


@lru_cache(maxsize=1024)
def _address(packed: bytes) -> str:
    return socket.inet_ntop(socket.AF_INET if len(packed) == 4 else socket.AF_INET6, packed)


def ip_packet(link_type: int, frame: bytes) -> bytes | None:
    """The IP packet in a frame of this link type, with padding; None for any other protocol."""
    if link_type == ETHERNET:
        return _after_ethertype(frame, 12)
    if link_type == LINUX_SLL:
        return _after_ethertype(frame, 14)
    if link_type == LINUX_SLL2:
        return frame[20:] if int.from_bytes(frame[:2], "big") in _IP_TYPES else None
    if link_type in (NULL, LOOP):
        return frame[4:] if frame[:4] in _FAMILIES else None
    return frame


def _after_ethertype(frame: bytes, offset: int) -> bytes | None:
    while len(frame) >= offset + 2:
        (kind,) = struct.unpack_from(">H", frame, offset)
        if kind in _IP_TYPES:
            return frame[offset + 2 :]
        if kind not in _VLAN_TYPES:
            return None
        offset += 4
    return None
