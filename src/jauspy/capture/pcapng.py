"""Packets of pcapng files: of several interfaces, also with different link types and times, and of several sections."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from typing import Final, NamedTuple, TypeAlias

MAX_BLOCK: Final = 16 << 20
"""Bytes of a block, above which the file counts as damaged."""
MAX_INTERFACES: Final = 1024
"""Interfaces of a section; more count as damage."""
MAX_TIME: Final = float(1 << 33)
"""Seconds since 1970 (the year 2242), above which the time of a packet counts as damage."""
_SECTION: Final = b"\x0a\x0d\x0d\x0a"
"""Type of a section header, which is the same in both byte orders."""
_INTERFACE, _OBSOLETE_PACKET, _STATISTICS, _PACKET = 1, 2, 5, 6
_PACKETS: Final = (_OBSOLETE_PACKET, _PACKET)
_ORDERS: Final[dict[bytes, str]] = {b"\x4d\x3c\x2b\x1a": "<", b"\x1a\x2b\x3c\x4d": ">"}
"""Byte order of a section by the magic number in its header."""
_TIME_RESOLUTION, _TIME_OFFSET = 9, 14
_DROPPED: Final = 5
"""Code of the option `isb_ifdrop`."""


Frame: TypeAlias = tuple[int, float, bytes]
"""The link type of a frame, its time (s since 1970, UTC) and its bytes."""


class _Interface(NamedTuple):
    link_type: int
    ticks: float
    """Units of time in a second."""
    offset: int
    """Seconds to be added to times."""


class PcapngFrames:
    """The frames of a file from its first byte on; `read` gives as many bytes as there are.

    dpkt takes three times as long, for it makes objects of blocks, and applies the first interface to all packets.

    Raises:
        ValueError, struct.error: no section with an interface; while iterating: a block that is damaged or cut off.
    """

    def __init__(self, read: Callable[[int], bytes]) -> None:
        self._read = read
        self._set_order("<")
        self._interfaces: list[_Interface] = []
        self.lost = 0
        """Packets that whoever wrote the file has lost so far, as its statistics tell."""
        while not self._interfaces:
            if not (header := read(8)):
                raise ValueError("no interface is described")
            self._take(header)

    @property
    def link_type(self) -> int:
        """The link type of the first interface."""
        return self._interfaces[0].link_type

    def __iter__(self) -> Iterator[Frame]:
        read, interfaces = self._read, self._interfaces
        head, packet, number = self._head.unpack, self._packet.unpack_from, self._number.unpack_from
        while header := read(8):
            kind, length = head(header)
            if kind not in _PACKETS:
                self._take(header)
                interfaces = self._interfaces
                head, packet, number = self._head.unpack, self._packet.unpack_from, self._number.unpack_from
                continue
            body = self._body(header, length)
            high, low, size = packet(body, 4)
            if 24 + size > len(body):
                raise ValueError("a packet is longer than its block")
            (which,) = number(body) if kind == _PACKET else self._short_number.unpack_from(body)
            if which >= len(interfaces):
                raise ValueError(f"a packet of interface {which}, which is not described")
            link_type, ticks, offset = interfaces[which]
            time = offset + (high << 32 | low) / ticks
            if not 0.0 <= time < MAX_TIME:
                raise ValueError(f"a packet at {time:g} s")
            yield link_type, time, body[20 : 20 + size]

    def _set_order(self, order: str) -> None:
        """Read numbers in the byte order of a section."""
        self._order = order
        self._head, self._packet = struct.Struct(order + "II"), struct.Struct(order + "III")
        self._number, self._short_number = struct.Struct(order + "I"), struct.Struct(order + "H")

    def _take(self, header: bytes) -> None:
        """Read a block without packets, after its header."""
        if header[:4] == _SECTION:
            magic = self._read(4)
            if magic not in _ORDERS:
                raise ValueError("a section in no byte order")
            self._set_order(_ORDERS[magic])
            self._interfaces = []
            self._body(header, self._head.unpack(header)[1], taken=len(magic))
            return
        kind, length = self._head.unpack(header)
        body = self._body(header, length)
        if kind == _INTERFACE:
            if len(self._interfaces) >= MAX_INTERFACES:
                raise ValueError(f"more than {MAX_INTERFACES} interfaces")
            self._interfaces.append(_interface(body, self._order))
        elif kind == _STATISTICS:
            self.lost = max(self.lost, _dropped(body, self._order))

    def _body(self, header: bytes, length: int, taken: int = 0) -> bytes:
        """What follows the header of a block, with its length at the end; `taken` bytes of it were read before."""
        if not 12 + taken <= length <= MAX_BLOCK or length % 4:
            raise ValueError(f"a block of {length} bytes")
        body = self._read(length - 8 - taken)
        if len(body) != length - 8 - taken or body[-4:] != header[4:]:
            raise ValueError("a block is cut off, or its length differs at its end")
        return body


def _interface(body: bytes, order: str) -> _Interface:
    """The interface that a block describes."""
    (link_type,) = struct.unpack_from(order + "H", body)
    ticks, offset = 1e6, 0
    for code, value in _options(body, 8, order):
        if code == _TIME_RESOLUTION and value:
            ticks = float((2 if value[0] & 0x80 else 10) ** (value[0] & 0x7F))
        elif code == _TIME_OFFSET and len(value) == 8:
            (offset,) = struct.unpack(order + "q", value)
    return _Interface(link_type, ticks, offset)


def _dropped(body: bytes, order: str) -> int:
    """The packets that an interface has dropped, in the options of a statistics block."""
    for code, value in _options(body, 12, order):
        if code == _DROPPED and len(value) == 8:
            (count,) = struct.unpack(order + "Q", value)
            return int(count)
    return 0


def _options(body: bytes, start: int, order: str) -> Iterator[tuple[int, bytes]]:
    """Codes and values of the options of a block, which end before the length at its end."""
    option = struct.Struct(order + "HH")
    while start + option.size <= len(body) - 4:
        code, length = option.unpack_from(body, start)
        start += option.size
        if start + length > len(body) - 4:
            return
        yield code, body[start : start + length]
        start += length + -length % 4
