"""A stream of clouds: PUB and SUB sockets of nanomsg, by `pynng`, and one cloud as bytes.

A message has a header, the name of the frame, and float32 values row by row. All little-endian.

| offset | type | what |
|---|---|---|
| 0 | 4 bytes | `JPC1` |
| 4 | uint16 | values of a point: 3 are x, y, z in metres; 6 are these and red, green, blue from 0 to 1 |
| 6 | uint16 | bytes of the frame's name |
| 8 | uint32 | points |
| 12 | uint32 | stream id: random, new each time a publisher starts |
| 16 | uint64 | number of the message in its stream, counted from 0 |
| 24 | float64 | seconds since 1970 (UTC) at which the points were measured |
| 32 | UTF-8 | name of the frame that the points are in: x forward, y left, z up |
| then | float32 | the points |
"""

from __future__ import annotations

import importlib
import secrets
import struct
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType, TracebackType
from typing import Any, Final, Self

from jauspy.errors import ConfigError, DecodeError, TransportError

MAGIC: Final = b"JPC1"
MAX_POINTS: Final = 1_000_000
"""Points of one message."""
XYZ: Final = 3
XYZ_RGB: Final = 6
_HEADER: Final = struct.Struct("<4sHHIIQd")
_FLOAT: Final = 4


@dataclass(frozen=True, slots=True)
class Cloud:
    """A point cloud, measured at one time."""

    points: bytes
    """float32, little-endian, `values` per point: shape (points, values)."""
    frame: str
    time: float
    """Seconds since 1970 (UTC)."""
    values: int = XYZ
    stream: int = 0
    number: int = 0

    def __len__(self) -> int:
        return len(self.points) // (_FLOAT * self.values)

    def rows(self) -> list[tuple[float, ...]]:
        """The points as tuples of `values` numbers."""
        return list(struct.iter_unpack(f"<{self.values}f", self.points))

    def encode(self) -> bytes:
        """Encode the message; raises `ValueError` for incomplete or too many points."""
        if self.values not in (XYZ, XYZ_RGB) or len(self.points) != len(self) * _FLOAT * self.values:
            raise ValueError(f"{len(self.points)} bytes are no points of {self.values} float32 values (3 or 6)")
        if len(self) > MAX_POINTS:
            raise ValueError(f"{len(self)} points are too many for one message; {MAX_POINTS} are possible")
        name = self.frame.encode()
        header = _HEADER.pack(MAGIC, self.values, len(name), len(self), self.stream, self.number, self.time)
        return header + name + self.points


def decode(data: bytes) -> Cloud:
    """Decode a message; raises `DecodeError` with what is wrong with it."""
    if len(data) < _HEADER.size or data[:4] != MAGIC:
        raise DecodeError("not a point cloud: it does not begin with JPC1 and a header of 32 bytes")
    _, values, length, points, stream, number, time = _HEADER.unpack_from(data)
    if values not in (XYZ, XYZ_RGB) or points > MAX_POINTS:
        raise DecodeError(f"{points} points of {values} values; there may be {MAX_POINTS}, of 3 or 6")
    start = _HEADER.size + length
    if len(data) != start + points * values * _FLOAT:
        raise DecodeError(f"{len(data)} bytes; the header says {start + points * values * _FLOAT}")
    try:
        frame = data[_HEADER.size : start].decode()
    except UnicodeDecodeError as error:
        raise DecodeError("the frame's name is not UTF-8") from error
    return Cloud(points=data[start:], frame=frame, time=time, values=values, stream=stream, number=number)


_MAX_COLOUR: Final = 255.0


def save(cloud: Cloud, path: Path) -> None:
    """Write a cloud as `.pcd` or `.ply`, by the suffix of the path; raises `ConfigError` when that is not possible."""
    formats = {".pcd": pcd, ".ply": ply}
    if path.suffix not in formats:
        raise ConfigError(f"{path}: clouds are written as .pcd or .ply")
    try:
        path.write_bytes(formats[path.suffix](cloud))
    except OSError as error:
        raise ConfigError(f"{path}: the cloud cannot be written: {error.strerror}") from error


def pcd(cloud: Cloud) -> bytes:
    """Binary PCD 0.7; colours are float fields r, g, b from 0 to 1."""
    names = ["x", "y", "z", "r", "g", "b"][: cloud.values]
    header = (
        "# .PCD v0.7 - Point Cloud Data file format",
        "VERSION 0.7",
        f"FIELDS {' '.join(names)}",
        f"SIZE {' '.join('4' for _ in names)}",
        f"TYPE {' '.join('F' for _ in names)}",
        f"COUNT {' '.join('1' for _ in names)}",
        f"WIDTH {len(cloud)}",
        "HEIGHT 1",
        "VIEWPOINT 0 0 0 1 0 0 0",
        f"POINTS {len(cloud)}",
        "DATA binary",
    )
    return "".join(f"{line}\n" for line in header).encode() + cloud.points


def ply(cloud: Cloud) -> bytes:
    """Binary little-endian PLY; colours are bytes. Line breaks and other controls in the frame's name are escaped."""
    colours = ["red", "green", "blue"] if cloud.values == XYZ_RGB else []
    header = (
        "ply",
        "format binary_little_endian 1.0",
        f"comment frame {cloud.frame.encode('unicode_escape').decode()}",
        f"element vertex {len(cloud)}",
        *(f"property float {name}" for name in "xyz"),
        *(f"property uchar {name}" for name in colours),
        "end_header",
    )
    body = b"".join(_coloured(row) for row in cloud.rows()) if colours else cloud.points
    return "".join(f"{line}\n" for line in header).encode() + body


def _coloured(row: tuple[float, ...]) -> bytes:
    shades = (round(_MAX_COLOUR * min(1.0, max(0.0, value))) for value in row[3:])
    return struct.pack("<3f3B", *row[:3], *shades)


SEND_QUEUE_SIZE: Final = 8
"""Messages queued for a slow subscriber; further ones are lost, which shows as gaps in the numbers."""
MAX_MESSAGE_SIZE: Final = 32_000_000
"""Bytes of a message that a subscriber accepts; a million coloured points are 24 MB."""


def _pynng() -> ModuleType:
    try:
        return importlib.import_module("pynng")
    except ImportError as error:
        raise ConfigError("point clouds need pynng: pip install 'jauspy[cloud]'") from error


class _Socket:
    _socket: Any

    def close(self) -> None:
        """Close the socket; without effect when closed."""
        self._socket.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


class CloudPublisher(_Socket):
    """Listens at an address such as `tcp://127.0.0.1:5565` or `ipc:///tmp/cloud` for any number of subscribers.

    Raises `ConfigError` without pynng, `TransportError` when it cannot listen there.
    """

    def __init__(self, address: str) -> None:
        nng = _pynng()
        self._socket = nng.Pub0(send_buffer_size=SEND_QUEUE_SIZE)
        try:
            self._socket.listen(address)
        except nng.NNGException as error:
            self._socket.close()
            raise TransportError(f"{address}: cannot publish there: {error}") from error
        self._stream = secrets.randbits(32)
        self._number = 0

    def publish(self, points: bytes, frame: str, at: float, values: int = 3) -> None:
        """Send to all subscribers without waiting; `points` and `values` as in `Cloud`, `at` is its time."""
        self._socket.send(
            Cloud(points=points, frame=frame, time=at, values=values, stream=self._stream, number=self._number).encode()
        )
        self._number += 1


class CloudSubscriber(_Socket):
    """Receives the clouds published at an address; reconnects when the publisher was away."""

    def __init__(self, address: str) -> None:
        nng = _pynng()
        self._timeout = nng.Timeout
        self._socket = nng.Sub0(topics=b"", recv_buffer_size=SEND_QUEUE_SIZE, recv_max_size=MAX_MESSAGE_SIZE)
        try:
            self._socket.dial(address, block=False)
        except nng.NNGException as error:
            self._socket.close()
            raise ConfigError(f"{address}: no address to subscribe to, as in tcp://127.0.0.1:5565: {error}") from error
        self._last: Cloud | None = None
        self.counters: Counter[str] = Counter()
        """Clouds `received`; those `lost` by their numbers; `malformed` messages; `restarts` of the publisher."""

    def receive(self, timeout: float) -> Cloud | None:
        """The next cloud; None after `timeout` seconds. Malformed messages are counted and skipped."""
        until = time.monotonic() + timeout
        while True:
            self._socket.recv_timeout = max(1, round((until - time.monotonic()) * 1000.0))
            try:
                cloud = decode(self._socket.recv())
            except self._timeout:
                return None
            except (DecodeError, RuntimeError):  # pynng raises RuntimeError for an empty message
                self.counters["malformed"] += 1
                if time.monotonic() >= until:
                    return None
            else:
                self._count(cloud)
                return cloud

    def _count(self, cloud: Cloud) -> None:
        last, self._last = self._last, cloud
        self.counters["received"] += 1
        if last is not None and last.stream != cloud.stream:
            self.counters["restarts"] += 1
        elif last is not None:
            self.counters["lost"] += max(0, cloud.number - last.number - 1)
