"""One cloud as bytes: a header, the name of the frame, and float32 values row by row. All little-endian.

| offset | type | what |
|---|---|---|
| 0 | 4 bytes | `JPC1` |
| 4 | uint16 | values of a point: 3 are x, y, z in metres; 6 are these and red, green, blue from 0 to 1 |
| 6 | uint16 | bytes of the frame's name |
| 8 | uint32 | points |
| 12 | uint32 | of the stream: chosen anew each time a publisher starts |
| 16 | uint64 | number of the message in its stream, from 0, one more each time |
| 24 | float64 | seconds since 1970 (UTC) at which the points were measured |
| 32 | UTF-8 | name of the frame that the points are in: x forward, y left, z up |
| then | float32 | the points |
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Final

from jauspy.errors import DecodeError

MAGIC: Final = b"JPC1"
MAX_POINTS: Final = 1_000_000
"""Of one message."""
XYZ: Final = 3
XYZ_RGB: Final = 6
_HEADER: Final = struct.Struct("<4sHHIIQd")
_FLOAT: Final = 4


@dataclass(frozen=True, slots=True)
class Cloud:
    """Points that were measured together."""

    points: bytes
    """float32, little-endian, `values` for each point."""
    frame: str
    time: float
    """Seconds since 1970 (UTC)."""
    values: int = XYZ
    stream: int = 0
    number: int = 0

    def __len__(self) -> int:
        return len(self.points) // (_FLOAT * self.values)

    def rows(self) -> list[tuple[float, ...]]:
        """The points as numbers."""
        return list(struct.iter_unpack(f"<{self.values}f", self.points))

    def encode(self) -> bytes:
        """As bytes; `ValueError` for points that are not whole, or too many."""
        if self.values not in (XYZ, XYZ_RGB) or len(self.points) != len(self) * _FLOAT * self.values:
            raise ValueError(f"{len(self.points)} bytes are no points of {self.values} float32 values (3 or 6)")
        if len(self) > MAX_POINTS:
            raise ValueError(f"{len(self)} points are too many for one message; {MOST_POINTS} are possible")
        name = self.frame.encode()
        header = _HEADER.pack(MAGIC, self.values, len(name), len(self), self.stream, self.number, self.time)
        return header + name + self.points


def decode(data: bytes) -> Cloud:
    """The cloud of a message; `DecodeError` says what is wrong with it."""
    if len(data) < _HEADER.size or data[:4] != MAGIC:
        raise DecodeError("not a point cloud: it does not begin with JPC1 and a header of 32 bytes")
    _, values, length, points, stream, number, time = _HEADER.unpack_from(data)
    if values not in (XYZ, XYZ_RGB) or points > MAX_POINTS:
        raise DecodeError(f"{points} points of {values} values; there may be {MOST_POINTS}, of 3 or 6")
    start = _HEADER.size + length
    if len(data) != start + points * values * _FLOAT:
        raise DecodeError(f"{len(data)} bytes; the header says {start + points * values * _FLOAT}")
    try:
        frame = data[_HEADER.size : start].decode()
    except UnicodeDecodeError as error:
        raise DecodeError("the frame's name is not UTF-8") from error
    return Cloud(data[start:], frame, time, values, stream, number)
