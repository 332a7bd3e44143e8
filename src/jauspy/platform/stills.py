"""Still images: what is asked of a camera, and what comes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final

MAX_REPORT: Final = 8 << 20
"""Bytes of a report with an image: the largest that cameras offer fits without any compression."""


class StillFormat(Enum):
    """Of an image: the ending of its file's name."""

    JPEG = ".jpg"
    PNG = ".png"


@dataclass(frozen=True, slots=True)
class StillSettings:
    """Size in pixels, and format."""

    width: int
    height: int
    format: StillFormat


@dataclass(frozen=True, slots=True)
class Still:
    """An image as a file's content; the robot was as it shows `age` seconds ago."""

    content: bytes
    age: float
