"""Reads recorded datagrams: in pcap and pcapng files, and bytes written as hexadecimal text."""

from __future__ import annotations

import re
import struct
from collections import Counter
from collections.abc import Iterator, Sequence
from io import BufferedReader
from typing import Any, Final, NamedTuple

import dpkt

from jauspy.capture.ip import IP_LINKS, JAUS_PORT, OTHER_PROTOCOL, DatagramAssembler, Udp, ip_packet
from jauspy.errors import ConfigError
from jauspy.protocol.jserial import FrameDecoder

_PCAPNG: Final = b"\x0a\x0d\x0d\x0a"
_PCAP: Final = tuple(struct.pack(order + "I", magic) for magic in (0xA1B2C3D4, 0xA1B23C4D) for order in "<>")
_SEPARATORS = re.compile(r"[\s:,_-]+|\b0[xX]")

SERIAL: Final = 147
"""The link type DLT_USER0; its frames are taken for bytes of a JSerial line."""
NAMES: Final = {**IP_LINKS, SERIAL: "JSerial (USER0)"}
SERIAL_LINE: Final = ("serial", JAUS_PORT)
"""Source and destination of datagrams from a JSerial line, which has no addresses."""


class Datagram(NamedTuple):
    """One captured UDP datagram, or a packet of a JTCP stream or JSerial line in the form of one.

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
        self._assembler = DatagramAssembler(JAUS_PORT if port is None else port)
        self._serial = FrameDecoder()
        self._read = file.read
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
        datagrams = self._from_line if self._link_type == SERIAL else self._from_network
        self._file.record_follows()
        is_pcapng = isinstance(self._frames, dpkt.pcapng.Reader)
        frames = self._pcapng_frames(self._frames.idb) if is_pcapng else iter(self._frames)
        number = 0
        while True:
            try:
                time, frame = next(frames)
            except StopIteration:
                break
            except (dpkt.Error, struct.error, ValueError):
                raise ConfigError(f"{self._name} is damaged or cut off after frame {number}") from None
            number += 1
            for source, destination, payload in datagrams(bytes(frame)):
                yield Datagram(number, float(time), source, destination, payload)
        self._assembler.finish()

    def _from_network(self, frame: bytes) -> Sequence[Udp]:
        packet = ip_packet(self._link_type, frame)
        if packet is None:
            self.skipped[OTHER_PROTOCOL] += 1
            return ()
        found = self._assembler.add(packet)
        if found and self._port not in (None, found[0].source[1], found[0].destination[1]):
            self.skipped[f"other UDP port than {self._port}"] += 1
            return ()
        return found

    def _from_line(self, data: bytes) -> Sequence[Udp]:
        datagrams, errors = self._serial.feed(data)
        if errors:
            self.skipped["damaged JSerial frame"] += len(errors)
        return [Udp(SERIAL_LINE, SERIAL_LINE, datagram) for datagram in datagrams]

    def _pcapng_frames(self, interface: dpkt.pcapng.InterfaceDescriptionBlock) -> Iterator[tuple[float, bytes]]:
        """Time and bytes of the packet blocks that follow; dpkt takes three times as long, for it makes objects.

        Raises `ValueError` or `struct.error` for a damaged block.
        """
        read, order = self._read, "<" if isinstance(interface, dpkt.pcapng.InterfaceDescriptionBlockLE) else ">"
        ticks, offset = 1e6, 0
        for option in interface.opts:
            if option.code == _TIME_RESOLUTION:
                exponent = option.data[0]
                ticks = float((2 if exponent & 0x80 else 10) ** (exponent & 0x7F))
            elif option.code == _TIME_OFFSET:
                (offset,) = struct.unpack(order + "q", option.data)
        head, packet = struct.Struct(order + "II"), struct.Struct(order + "4xIII")
        while header := read(8):
            kind, length = head.unpack(header)
            if not 12 <= length <= MAX_BLOCK or length % 4:
                raise ValueError(f"a block of {length} bytes")
            body = read(length - 8)
            if len(body) != length - 8 or body[-4:] != header[4:]:
                raise ValueError("a block is cut off, or its length differs at its end")
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
