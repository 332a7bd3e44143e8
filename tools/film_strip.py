"""Put pictures of a film side by side, for the documentation.

python tools/film_strip.py FILM FILE.jpg [--times SECONDS ...] [--columns N] [--width PIXELS]
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

import av
from PIL import Image

COMPRESSION: Final[dict[str, Any]] = {"quality": 86, "optimize": True, "progressive": True}
"""Of the JPEG files of the documentation."""

GAP: Final = 8
"""Pixels between two pictures."""


def pictures(film: Path, times: Sequence[float]) -> list[Image.Image]:
    """The picture that is shown at each of these times (s); the last one for times after the end."""
    found: list[Image.Image] = []
    with av.open(str(film)) as container:
        last = None
        for frame in container.decode(video=0):
            while len(found) < len(times) and frame.time >= times[len(found)]:
                found.append(Image.fromarray(frame.to_ndarray(format="rgb24")))
            last = frame
    if last is None:
        raise SystemExit(f"{film} has no pictures")
    return found + [Image.fromarray(last.to_ndarray(format="rgb24"))] * (len(times) - len(found))


def side_by_side(pictures: Sequence[Image.Image], columns: int, width: int) -> Image.Image:
    """One picture of all, row by row, each `width` pixels wide."""
    height = round(width * pictures[0].height / pictures[0].width)
    rows = -(-len(pictures) // columns)
    strip = Image.new("RGB", ((width + GAP) * columns - GAP, (height + GAP) * rows - GAP), "white")
    for number, picture in enumerate(pictures):
        row, column = divmod(number, columns)
        smaller = picture.resize((width, height), Image.Resampling.LANCZOS)
        strip.paste(smaller, (column * (width + GAP), row * (height + GAP)))
    return strip


def main() -> None:
    """Write the strip."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("film", type=Path)
    parser.add_argument("file", type=Path)
    parser.add_argument("--times", type=float, nargs="+", default=[0.0, 5.0, 10.0], metavar="SECONDS")
    parser.add_argument("--columns", type=int, default=3, metavar="N")
    parser.add_argument("--width", type=int, default=480, metavar="PIXELS", help="of each picture")
    options = parser.parse_args()
    found = pictures(options.film, sorted(options.times))
    side_by_side(found, options.columns, options.width).save(options.file, **COMPRESSION)
    print(f"{options.file}: {options.file.stat().st_size // 1000} kB")


if __name__ == "__main__":
    main()
