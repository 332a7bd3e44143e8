"""UDP datagrams of a pcap or pcapng file, one after the other, without reading the file into memory."""

from __future__ import annotations

import struct
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from io import BufferedReader
from typing import Final

import dpkt

from jauspy.capture import link
from jauspy.capture.ip import Assembler
from jauspy.errors import ConfigError

JAUS_PORT: Final = 3794  # registered for JAUS; AS5669A puts JUDP there

_PCAPNG: Final = b"\x0a\x0d\x0d\x0a"
_PCAP: Final = tuple(struct.pack(order + "I", magic) for magic in (0xA1B2C3D4, 0xA1B23C4D) for order in "<>")


@dataclass(frozen=True, slots=True)
class Datagram:
    """One captured UDP datagram.

    `number` is the frame's in the file, from 1, as Wireshark counts; `time` is in seconds since 1970, UTC.
    """

    number: int
    time: float
    source: tuple[str, int]
    destination: tuple[str, int]
    payload: bytes


class _Whole:
    """A capture file for dpkt, which takes what is there for whole: a short read is an error, except between records.

    Both formats are read in pairs, a header and the rest of its record.
    """

    def __init__(self, file: BufferedReader) -> None:
        self._file = file
        self._between = False

    def record_follows(self) -> None:
        """The next read is of a header, or of the file's end."""
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
    Of a pcapng file the first interface's link type is taken for all.

    Raises:
        ConfigError: not a capture file, or a link type without IP in it; while iterating: damaged or cut off here.
    """

    def __init__(self, file: BufferedReader, *, name: str, port: int | None = JAUS_PORT) -> None:
        self._name = name
        self._port = port
        self._assembler = Assembler()
        self._file = _Whole(file)
        self._frames = _open(file.peek(4)[:4], self._file, name)
        self._link_type: int = self._frames.datalink()
        if self._link_type not in link.NAMES:
            known = ", ".join(dict.fromkeys(link.NAMES.values()))
            raise ConfigError(f"{name}: link type {self._link_type} is not supported; these are: {known}")

    @property
    def skipped(self) -> Counter[str]:
        """How many frames were left out, by reason."""
        return self._assembler.skipped

    def __iter__(self) -> Iterator[Datagram]:
        for number, (time, frame) in enumerate(self._each_frame(), 1):
            packet = link.ip_packet(self._link_type, frame)
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
        try:
            for number, (time, frame) in enumerate(self._frames, 1):  # noqa: B007 - for the error below
                yield float(time), bytes(frame)
        except (dpkt.Error, struct.error, ValueError):
            raise ConfigError(f"{self._name} is damaged or cut off after frame {number}") from None


def _open(head: bytes, file: _Whole, name: str) -> dpkt.pcap.Reader | dpkt.pcapng.Reader:
    kind = dpkt.pcapng.Reader if head == _PCAPNG else dpkt.pcap.Reader
    try:
        return kind(file)
    except (dpkt.Error, struct.error, ValueError) as error:
        raise ConfigError(f"{name} is not a readable pcap or pcapng file ({error})") from None
