"""Numbers drawn into images as black and white squares, which survive coding: for counting and timing images."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from jauspy.platform.camera import Image


BITS: Final = 32
"""Squares of a row, most significant bit on the left; a row takes the whole width of the image."""

_BLACK, _WHITE = 16, 235


def draw(image: Image, *numbers: int) -> None:
    """Draw each number modulo 2**32 as a row of squares, from the top edge of the image down."""
    side = image.shape[1] // BITS
    for row, number in enumerate(numbers):
        bits = np.array([number >> shift & 1 for shift in reversed(range(BITS))], dtype=np.uint8)
        line = np.where(np.repeat(bits, side), _WHITE, _BLACK).astype(np.uint8)
        image[row * side : (row + 1) * side, : BITS * side] = line[None, :, None]


def read(image: Image, rows: int = 1) -> list[int]:
    """The numbers of the first rows; `image` has the shape (height, width) or (height, width, channels)."""
    side = image.shape[1] // BITS
    grey = image if image.ndim == 2 else image.mean(axis=2)
    tops = grey[: rows * side, : BITS * side].reshape(rows, side, BITS, side)
    edge = side // 4
    middles = tops[:, edge : side - edge, :, edge : side - edge].mean(axis=(1, 3)) > (_BLACK + _WHITE) / 2
    return [int("".join("01"[bit] for bit in row.astype(int)), 2) for row in middles]
