"""Clouds in files: PCD of the Point Cloud Library, and PLY."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Final

from jauspy.cloud.message import XYZ_RGB, Cloud
from jauspy.errors import ConfigError

_SHADES: Final = 255.0


def save(cloud: Cloud, path: Path) -> None:
    """Write a cloud as the path's ending says, `.pcd` or `.ply`; `ConfigError` for another, or a wrong place."""
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
    """Binary little-endian PLY; colours are bytes."""
    colours = ["red", "green", "blue"] if cloud.values == XYZ_RGB else []
    header = (
        "ply",
        "format binary_little_endian 1.0",
        f"comment frame {cloud.frame}",
        f"element vertex {len(cloud)}",
        *(f"property float {name}" for name in "xyz"),
        *(f"property uchar {name}" for name in colours),
        "end_header",
    )
    body = b"".join(_coloured(row) for row in cloud.rows()) if colours else cloud.points
    return "".join(f"{line}\n" for line in header).encode() + body


def _coloured(row: tuple[float, ...]) -> bytes:
    shades = (round(_SHADES * min(1.0, max(0.0, value))) for value in row[3:])
    return struct.pack("<3f3B", *row[:3], *shades)
