"""From IPv4 packets to UDP datagrams: fragments put together, padding cut off, nothing believed unchecked."""

from __future__ import annotations

import socket
from collections import Counter, OrderedDict
from dataclasses import dataclass, field
from typing import Final

import dpkt

# A capture is a peer, too: fragments of packets that never complete must not fill the memory.
MAX_OPEN_PACKETS: Final = 64
MAX_PACKET: Final = 65535

_Key = tuple[bytes, bytes, int]


@dataclass(frozen=True, slots=True)
class Udp:
    """One UDP datagram: `source` and `destination` are (address, port)."""

    source: tuple[str, int]
    destination: tuple[str, int]
    payload: bytes


@dataclass(slots=True)
class _Parts:
    pieces: dict[int, bytes] = field(default_factory=dict)
    size: int = 0
    total: int | None = None

    def add(self, offset: int, data: bytes, *, last: bool) -> None:
        if offset not in self.pieces:
            self.pieces[offset] = data
            self.size += len(data)
        if last:
            self.total = offset + len(data)

    def whole(self) -> bytes | None:
        """All bytes in order, once there is no gap; where pieces overlap, the earlier one counts."""
        if self.total is None:
            return None
        data = bytearray()
        for offset in sorted(self.pieces):
            if offset > len(data):
                return None
            data += self.pieces[offset][len(data) - offset :]
        return bytes(data[: self.total]) if len(data) >= self.total else None


class Assembler:
    """Turns IPv4 packets, in the order of the capture, into UDP datagrams; `skipped` counts what it leaves out."""

    def __init__(self) -> None:
        self.skipped: Counter[str] = Counter()
        self._open: OrderedDict[_Key, _Parts] = OrderedDict()

    def add(self, packet: bytes) -> Udp | None:
        """The datagram that this packet is, or completes; None when it is neither."""
        if not packet or packet[0] >> 4 != 4:
            self.skipped["not UDP over IPv4"] += 1
            return None
        try:
            header = dpkt.ip.IP(packet)
        except dpkt.UnpackError:
            self.skipped["malformed IP packet"] += 1
            return None
        if header.p != dpkt.ip.IP_PROTO_UDP:
            self.skipped["not UDP over IPv4"] += 1
            return None
        data = packet[header.hl * 4 : header.len or len(packet)]
        if header.mf or header.offset:
            whole = self._collect(header, data)
            if whole is None:
                return None
            data = whole
        return self._udp(header, data)

    def finish(self) -> None:
        """Count the packets whose fragments never all came."""
        if self._open:
            self.skipped["IP packet with missing fragments"] += len(self._open)
            self._open.clear()

    def _collect(self, header: dpkt.ip.IP, data: bytes) -> bytes | None:
        key = (header.src, header.dst, header.id)
        offset = header.offset * 8
        if offset + len(data) > MAX_PACKET:
            self.skipped["malformed IP packet"] += 1
            return None
        parts = self._open.setdefault(key, _Parts())
        parts.add(offset, data, last=not header.mf)
        whole = parts.whole()
        if whole is not None:
            del self._open[key]
        elif parts.size > 2 * MAX_PACKET:
            del self._open[key]
            self.skipped["malformed IP packet"] += 1
        elif len(self._open) > MAX_OPEN_PACKETS:
            self._open.popitem(last=False)
            self.skipped["IP packet with missing fragments"] += 1
        return whole

    def _udp(self, header: dpkt.ip.IP, data: bytes) -> Udp | None:
        try:
            udp = dpkt.udp.UDP(data)
        except dpkt.UnpackError:
            self.skipped["malformed UDP datagram"] += 1
            return None
        length = udp.ulen or len(data)
        if length < 8:
            self.skipped["malformed UDP datagram"] += 1
            return None
        if length > len(data):
            self.skipped["UDP datagram cut short by the capture"] += 1
            return None
        source, destination = socket.inet_ntoa(header.src), socket.inet_ntoa(header.dst)
        return Udp((source, udp.sport), (destination, udp.dport), data[8:length])
