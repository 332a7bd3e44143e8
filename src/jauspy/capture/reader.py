"""Reads recorded datagrams: in pcap and pcapng files, and bytes written as hexadecimal text."""

from __future__ import annotations

import re
import struct
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from io import BufferedReader
from typing import Any, Final, NamedTuple

import dpkt

from jauspy.capture.ip import IP_LINKS, JAUS_PORT, OTHER_PROTOCOL, DatagramAssembler, Udp, ip_packet
from jauspy.capture.pcapng import MAX_BLOCK, Frame, PcapngFrames
from jauspy.errors import ConfigError
from jauspy.protocol.jserial import FrameDecoder

_PCAPNG: Final = b"\x0a\x0d\x0d\x0a"
_PCAP: Final = tuple(struct.pack(order + "I", magic) for magic in (0xA1B2C3D4, 0xA1B23C4D) for order in "<>")
_LINK_TYPE: Final = 0x03FFFFFF
"""Bits of the link type in a pcap file; the others tell of checksums behind frames."""
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
    """A pcap file for dpkt, which ignores short reads: here they are an error, except between records.

    It is read in pairs: a header, and the rest of its record, which may not be larger than `MAX_BLOCK`.
    """

    def __init__(self, file: BufferedReader[Any]) -> None:
        self._file = file
        self._between = False

    def record_follows(self) -> None:
        """The next read is that of a header, or the end of the file."""
        self._between = True

    def read(self, count: int) -> bytes:
        """Exactly `count` bytes; none at the end of the file."""
        if count > MAX_BLOCK:
            raise dpkt.NeedData(f"a record of {count} bytes")
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
    In a pcapng file, frames of further interfaces with such a link type are among them.

    Raises:
        ConfigError: not a capture file, or a link type without IP in it; while iterating: damaged or cut off here.
    """

    def __init__(self, file: BufferedReader[Any], *, name: str, port: int | None = JAUS_PORT) -> None:
        self._name = name
        self._port = port
        self._assembler = DatagramAssembler(JAUS_PORT if port is None else port)
        self._serial = FrameDecoder()
        self._frames = _open(file, name)
        self._link_type = self._frames.link_type
        if self._link_type not in NAMES:
            known = ", ".join(dict.fromkeys(NAMES.values()))
            raise ConfigError(f"{name}: link type {self._link_type} is not supported; these are: {known}")

    @property
    def skipped(self) -> Counter[str]:
        """Number of skipped frames, by reason."""
        return self._assembler.skipped

    @property
    def lost(self) -> int:
        """Packets that whoever wrote a pcapng file has lost so far, as its statistics tell."""
        return self._frames.lost

    def __iter__(self) -> Iterator[Datagram]:
        frames = iter(self._frames)
        number = 0
        while True:
            try:
                link_type, time, frame = next(frames)
            except StopIteration:
                break
            except (dpkt.Error, struct.error, ValueError):
                raise ConfigError(f"{self._name} is damaged or cut off after frame {number}") from None
            number += 1
            for source, destination, payload in self._datagrams(link_type, frame):
                yield Datagram(number, time, source, destination, payload)
        self._assembler.finish()

    def _datagrams(self, link_type: int, frame: bytes) -> Sequence[Udp]:
        if link_type == SERIAL:
            return self._from_line(frame)
        if link_type not in IP_LINKS:
            self.skipped[f"link type {link_type}, which is not supported"] += 1
            return ()
        packet = ip_packet(link_type, frame)
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


class _PcapFrames:
    """The frames of a pcap file. Raises `ValueError`, `struct.error` or `dpkt.Error` for a damaged one."""

    lost = 0
    """The format does not tell."""

    def __init__(self, file: BufferedReader[Any]) -> None:
        self._file = _CheckedFile(file)
        self._reader = dpkt.pcap.Reader(self._file)
        self.link_type: int = self._reader.datalink() & _LINK_TYPE

    def __iter__(self) -> Iterator[Frame]:
        self._file.record_follows()
        return ((self.link_type, float(time), bytes(frame)) for time, frame in self._reader)


def _open(file: BufferedReader[Any], name: str) -> _PcapFrames | PcapngFrames:
    try:
        return PcapngFrames(file.read) if file.peek(4)[:4] == _PCAPNG else _PcapFrames(file)
    except (dpkt.Error, struct.error, ValueError) as error:
        raise ConfigError(f"{name} is not a readable pcap or pcapng file ({error})") from None


def up_to_damage(datagrams: Iterable[Datagram], tell: Callable[[str], None]) -> Iterator[Datagram]:
    """The datagrams before the place where a capture is damaged or cut off, as after a crash; `tell` is told of it.

    Raises `ConfigError` if there are none before it.
    """
    last: Datagram | None = None
    try:
        for last in datagrams:
            yield last
    except ConfigError as error:
        if last is None:
            raise
        tell(f"{error}; what is before that was read")


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
