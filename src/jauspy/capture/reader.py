"""Reads recorded datagrams: UDP in pcap and pcapng files, and bytes written as hexadecimal text."""

from __future__ import annotations

import re
import socket
import struct
from collections import Counter, OrderedDict
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from io import BufferedReader
from typing import Any, Final, NamedTuple

import dpkt

from jauspy.errors import ConfigError

JAUS_PORT: Final = 3794  # registered for JAUS, used by JUDP

_PCAPNG: Final = b"\x0a\x0d\x0d\x0a"
_PCAP: Final = tuple(struct.pack(order + "I", magic) for magic in (0xA1B2C3D4, 0xA1B23C4D) for order in "<>")
MAX_OPEN_PACKETS: Final = 64
"""Maximal number of incomplete IP packets of a capture; the oldest is dropped first."""
MAX_PACKET: Final = 65535
_Key = tuple[bytes, bytes, int]
_IP: Final = struct.Struct(">xxHHHxBxx4s4s")
"""Length, identification, fragment flags and offset, protocol, source and destination of an IPv4 header."""
_OFFSET, _MORE_FRAGMENTS, _FRAGMENTED = 0x1FFF, 0x2000, 0x3FFF
_UDP: Final = struct.Struct(">HHHxx")
_SEPARATORS = re.compile(r"[\s:,_-]+|\b0[xX]")

# Link types as the pcap formats number them (https://www.tcpdump.org/linktypes.html). Raw IP has three numbers:
# the registered one, and two that some systems write instead.
NULL: Final = 0
ETHERNET: Final = 1
RAW: Final = (12, 14, 101)
LOOP: Final = 108
LINUX_SLL: Final = 113
IPV4: Final = 228
LINUX_SLL2: Final = 276

NAMES: Final = {
    NULL: "null/loopback",
    ETHERNET: "Ethernet",
    LOOP: "OpenBSD loopback",
    LINUX_SLL: "Linux cooked",
    IPV4: "raw IPv4",
    LINUX_SLL2: "Linux cooked v2",
    **dict.fromkeys(RAW, "raw IP"),
}

_IPV4_TYPE: Final = 0x0800
_VLAN_TYPES: Final = (0x8100, 0x88A8, 0x9100)
_AF_INET: Final = (2).to_bytes(4, "big"), (2).to_bytes(4, "little")


class Datagram(NamedTuple):
    """One captured UDP datagram.

    `number` is the frame's in the file, from 1, as Wireshark counts; `time` is in seconds since 1970, UTC.
    """

    number: int
    time: float
    source: tuple[str, int]
    destination: tuple[str, int]
    payload: bytes


class _CheckedFile:
    """A capture file for dpkt, which ignores short reads: here they are an error, except between records.

    Both formats are read in pairs: a header, and the rest of its record.
    """

    def __init__(self, file: BufferedReader[Any]) -> None:
        self._file = file
        self._between = False

    def record_follows(self) -> None:
        """The next read is that of a header, or the end of the file."""
        self._between = True

    def read(self, count: int) -> bytes:
        """Exactly `count` bytes; none at the end of the file."""
        data = self._file.read(max(count, 0))
        if len(data) < count and (data or not self._between):
            raise dpkt.NeedData("the file ends in the middle of a record")
        self._between = not self._between
        return data


def is_capture(head: bytes) -> bool:
    """True when a file that begins with these (at least four) bytes is a pcap or pcapng file."""
    return head[:4] == _PCAPNG or head[:4] in _PCAP


class CaptureReader:
    """Iterates over the datagrams from or to `port` (None: any port) in an open capture file.

    `skipped` counts, by reason, the frames that held no such datagram; it is complete after the iteration.
    In a pcapng file, the link type of the first interface applies to all.

    Raises:
        ConfigError: not a capture file, or a link type without IP in it; while iterating: damaged or cut off here.
    """

    def __init__(self, file: BufferedReader[Any], *, name: str, port: int | None = JAUS_PORT) -> None:
        self._name = name
        self._port = port
        self._assembler = DatagramAssembler()
        self._file = _CheckedFile(file)
        self._frames = _open(file.peek(4)[:4], self._file, name)
        self._link_type: int = self._frames.datalink()
        self.lost = 0
        """Packets that whoever wrote a pcapng file has lost so far, as its statistics tell."""
        if self._link_type not in NAMES:
            known = ", ".join(dict.fromkeys(NAMES.values()))
            raise ConfigError(f"{name}: link type {self._link_type} is not supported; these are: {known}")

    @property
    def skipped(self) -> Counter[str]:
        """Number of skipped frames, by reason."""
        return self._assembler.skipped

    def __iter__(self) -> Iterator[Datagram]:
        for number, (time, frame) in enumerate(self._each_frame(), 1):
            packet = ip_packet(self._link_type, frame)
            if packet is None:
                self.skipped["not UDP over IPv4"] += 1
                continue
            udp = self._assembler.add(packet)
            if udp is None:
                continue
            if self._port not in (None, udp.source[1], udp.destination[1]):
                self.skipped[f"other UDP port than {self._port}"] += 1
                continue
            yield Datagram(number, time, udp.source, udp.destination, udp.payload)
        self._assembler.finish()

    def _each_frame(self) -> Iterator[tuple[float, bytes]]:
        number = 0
        self._file.record_follows()
        is_pcapng = isinstance(self._frames, dpkt.pcapng.Reader)
        frames = self._pcapng_frames(self._frames.idb) if is_pcapng else self._frames
        try:
            for number, (time, frame) in enumerate(frames, 1):  # noqa: B007 - for the error below
                yield float(time), bytes(frame)
        except (dpkt.Error, struct.error, ValueError):
            raise ConfigError(f"{self._name} is damaged or cut off after frame {number}") from None

    def _pcapng_frames(self, interface: dpkt.pcapng.InterfaceDescriptionBlock) -> Iterator[tuple[float, bytes]]:
        """Time and bytes of the packet blocks that follow; dpkt takes three times as long, for it makes objects.

        Raises `ValueError` or `struct.error` for a damaged block.
        """
        file, order = self._file, "<" if isinstance(interface, dpkt.pcapng.InterfaceDescriptionBlockLE) else ">"
        ticks, offset = 1e6, 0
        for option in interface.opts:
            if option.code == _TIME_RESOLUTION:
                exponent = option.data[0]
                ticks = float((2 if exponent & 0x80 else 10) ** (exponent & 0x7F))
            elif option.code == _TIME_OFFSET:
                (offset,) = struct.unpack(order + "q", option.data)
        head, packet = struct.Struct(order + "II"), struct.Struct(order + "4xIII")
        while header := file.read(head.size):
            kind, length = head.unpack(header)
            if not 12 <= length <= MAX_BLOCK or length % 4:
                raise ValueError(f"a block of {length} bytes")
            body = file.read(length - head.size)
            if body[-4:] != header[4:]:
                raise ValueError("the length of a block differs at its end")
            if kind in _PACKET_BLOCKS:
                high, low, size = packet.unpack_from(body)
                if 20 + size + 4 > len(body):
                    raise ValueError("a packet is longer than its block")
                yield offset + (high << 32 | low) / ticks, body[20 : 20 + size]
            elif kind == _STATISTICS:
                self.lost = max(self.lost, _dropped(body, order))


def _dropped(body: bytes, order: str) -> int:
    """The packets that an interface has dropped, in the options of a statistics block."""
    at, option = 12, struct.Struct(order + "HH")
    while at + option.size <= len(body) - 4:
        code, length = option.unpack_from(body, at)
        at += option.size
        if code == _DROPPED and length == 8 and at + 8 <= len(body):
            (count,) = struct.unpack_from(order + "Q", body, at)
            return int(count)
        at += length + -length % 4
    return 0


def _open(head: bytes, file: _CheckedFile, name: str) -> dpkt.pcap.Reader | dpkt.pcapng.Reader:
    kind = dpkt.pcapng.Reader if head == _PCAPNG else dpkt.pcap.Reader
    try:
        return kind(file)
    except (dpkt.Error, struct.error, ValueError) as error:
        raise ConfigError(f"{name} is not a readable pcap or pcapng file ({error})") from None


_PACKET_BLOCKS: Final = (2, 6)
"""Types of pcapng blocks with a packet: the obsolete one, and the enhanced one."""
MAX_BLOCK: Final = 16 << 20
"""Bytes of a pcapng block, above which the file counts as damaged."""
_STATISTICS: Final = 5
_DROPPED: Final = 5
"""Code of the option `isb_ifdrop`."""
_TIME_RESOLUTION: Final = 9
_TIME_OFFSET: Final = 14


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
    """Reassembles UDP datagrams from IPv4 packets in the order of the capture; `skipped` counts packets left out."""

    def __init__(self) -> None:
        self.skipped: Counter[str] = Counter()
        self._open: OrderedDict[_Key, _Parts] = OrderedDict()

    def add(self, packet: bytes) -> Udp | None:
        """The datagram that this packet contains or completes, or None."""
        if not packet or packet[0] >> 4 != 4:
            self.skipped["not UDP over IPv4"] += 1
            return None
        start = (packet[0] & 0x0F) * 4
        if len(packet) < _IP.size or not _IP.size <= start <= len(packet):
            self.skipped["malformed IP packet"] += 1
            return None
        length, identification, fragment, protocol, source, destination = _IP.unpack_from(packet)
        if protocol != socket.IPPROTO_UDP:
            self.skipped["not UDP over IPv4"] += 1
            return None
        data = packet[start : length or len(packet)]
        if fragment & _FRAGMENTED:
            key = (source, destination, identification)
            whole = self._collect(key, (fragment & _OFFSET) * 8, data, last=not fragment & _MORE_FRAGMENTS)
            if whole is None:
                return None
            data = whole
        return self._udp(source, destination, data)

    def finish(self) -> None:
        """Count the packets with missing fragments."""
        if self._open:
            self.skipped["IP packet with missing fragments"] += len(self._open)
            self._open.clear()

    def _collect(self, key: _Key, offset: int, data: bytes, *, last: bool) -> bytes | None:
        if offset + len(data) > MAX_PACKET:
            self.skipped["malformed IP packet"] += 1
            return None
        parts = self._open.setdefault(key, _Parts())
        parts.add(offset, data, last=last)
        whole = parts.joined()
        if whole is not None:
            del self._open[key]
        elif parts.size > 2 * MAX_PACKET:
            del self._open[key]
            self.skipped["malformed IP packet"] += 1
        elif len(self._open) > MAX_OPEN_PACKETS:
            self._open.popitem(last=False)
            self.skipped["IP packet with missing fragments"] += 1
        return whole

    def _udp(self, source: bytes, destination: bytes, data: bytes) -> Udp | None:
        if len(data) < _UDP.size:
            self.skipped["malformed UDP datagram"] += 1
            return None
        source_port, destination_port, given = _UDP.unpack_from(data)
        length = given or len(data)
        if length < _UDP.size:
            self.skipped["malformed UDP datagram"] += 1
            return None
        if length > len(data):
            self.skipped["UDP datagram cut short by the capture"] += 1
            return None
        return Udp((_address(source), source_port), (_address(destination), destination_port), data[8:length])


_address: Final = lru_cache(maxsize=1024)(socket.inet_ntoa)


def ip_packet(link_type: int, frame: bytes) -> bytes | None:
    """The IPv4 packet in a frame of this link type, with padding; None for any other protocol."""
    if link_type == ETHERNET:
        return _after_ethertype(frame, 12)
    if link_type == LINUX_SLL:
        return _after_ethertype(frame, 14)
    if link_type == LINUX_SLL2:
        return frame[20:] if frame[:2] == _IPV4_TYPE.to_bytes(2, "big") else None
    if link_type in (NULL, LOOP):
        return frame[4:] if frame[:4] in _AF_INET else None
    return frame


def _after_ethertype(frame: bytes, offset: int) -> bytes | None:
    while len(frame) >= offset + 2:
        (kind,) = struct.unpack_from(">H", frame, offset)
        if kind == _IPV4_TYPE:
            return frame[offset + 2 :]
        if kind not in _VLAN_TYPES:
            return None
        offset += 4
    return None


def from_hex(text: str) -> bytes:
    """The bytes of `"02 00:11"`, `"0x02, 0x00"` or `"020011"`; `ConfigError` says what is wrong."""
    digits = _SEPARATORS.sub("", text)
    wrong = re.search(r"[^0-9a-fA-F]", digits)
    if wrong:
        raise ConfigError(f"{wrong.group()!r} in {_short(text)!r} is not a hexadecimal digit")
    if not digits:
        raise ConfigError("there are no hexadecimal digits")
    if len(digits) % 2:
        raise ConfigError(f"{_short(text)!r} has an odd number of hexadecimal digits ({len(digits)}); a byte has two")
    return bytes.fromhex(digits)


def from_lines(text: str) -> list[tuple[int, bytes]]:
    """Number and bytes of each line; empty lines and comments (`#`) are skipped."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        content = line.partition("#")[0].strip()
        if not content:
            continue
        try:
            found.append((number, from_hex(content)))
        except ConfigError as error:
            raise ConfigError(f"line {number}: {error}") from None
    return found


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:37] + "..."
