"""Names of colours for what cameras and depth cameras see."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

HUES: Final[Mapping[str, tuple[tuple[int, int], ...]]] = {
    "red": ((0, 8), (172, 180)),
    "orange": ((9, 19),),
    "yellow": ((20, 34),),
    "green": ((35, 85),),
    "blue": ((95, 130),),
    "purple": ((131, 165),),
}
"""First and last hue of each colour, in units of 2 degrees, as OpenCV has them."""
MIN_SATURATION: Final = 140
MIN_VALUE: Final = 40
"""Of 255; what is paler or darker has no colour. Bricks are paler."""


def is_coloured(colours: Array, name: str) -> Flags:
    """For each colour, shape (n, 3) from 0 to 1: True if it has that name; `KeyError` for an unknown name."""
    most, least = colours.max(axis=1), colours.min(axis=1)
    chroma = most - least
    safe = np.maximum(chroma, 1e-9)
    red, green, blue = colours.T
    sixth = np.where(
        most == red,
        (green - blue) / safe,
        np.where(most == green, 2.0 + (blue - red) / safe, 4.0 + (red - green) / safe),
    )
    hue = np.round(30.0 * sixth) % 180
    vivid = (255.0 * chroma >= MIN_SATURATION * most) & (255.0 * most >= MIN_VALUE)
    within = np.zeros(len(colours), np.bool_)
    for low, high in HUES[name]:
        within |= (hue >= low) & (hue <= high)
    found: Flags = vivid & within
    return found


def main_colour(colours: Array) -> str:
    """The colour that more than a third of them have, shape (n, 3); empty if there is none."""
    counts = {name: int(is_coloured(colours, name).sum()) for name in HUES}
    name = max(counts, key=lambda one: counts[one])
    return name if 3 * counts[name] > len(colours) else ""
