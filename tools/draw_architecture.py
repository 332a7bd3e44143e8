"""Draw the packages and their layers to docs/assets/architecture.svg.

The layers are those of the import contracts in pyproject.toml, the descriptions those of ARCHITECTURE.md.

python tools/draw_architecture.py [-o FILE]
"""

from __future__ import annotations

import argparse
import re
import textwrap
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final
from xml.sax.saxutils import escape

ROOT: Final = Path(__file__).parents[1]
TARGET: Final = ROOT / "docs" / "assets" / "architecture.svg"

LAYERS: Final = "Layers: each package imports only what is below it"
NO_IO: Final = "No I/O, no clock, no threads and no chance in the core"
SIMULATOR_LAYERS: Final = "Layers of the simulator"
SIMULATOR_LIMITS: Final = "The simulator knows only the platform contract and geometry"
"""Names of the contracts that are drawn."""

WIDTH: Final = 1000
"""Width of the packages of jauspy, pixels; so are the following."""
SIMULATOR_WIDTH: Final = 230
MARGIN: Final = 16
GAP: Final = 8
TITLE_HEIGHT: Final = 34
LINE_HEIGHT: Final = 16
CHARACTER_WIDTH: Final = 6.9
"""Mean width of a character of the descriptions."""

FONT: Final = "font-family='Helvetica, Arial, sans-serif'"
SHELL_FILL: Final = "#e8f0f8"
CORE_FILL: Final = "#e9f4ea"
SIMULATOR_FILL: Final = "#f7efe1"


@dataclass(frozen=True)
class Row:
    """The packages of one layer, which do not import each other, and where they are drawn."""

    names: tuple[str, ...]
    top: float
    height: float


def contracts() -> dict[str, dict[str, Any]]:
    """The import contracts of pyproject.toml by name."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    return {contract["name"]: contract for contract in settings["tool"]["importlinter"]["contracts"]}


def layers(contract: dict[str, Any]) -> list[tuple[str, ...]]:
    """The layers of a contract from the highest to the lowest, each with its packages."""
    return [tuple(re.split(r"\s*[|:]\s*", layer)) for layer in contract["layers"]]


def descriptions() -> dict[str, str]:
    """What ARCHITECTURE.md says of each package, up to the first semicolon, without parentheses."""
    page = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    rows = re.findall(r"^ {4}([a-z_]+) {2,}(\S.*)$", page, re.MULTILINE)
    return {name: re.sub(r" *\([^)]*\)|`", "", text.split(";")[0]) for name, text in rows}


def draw() -> str:
    """The drawing as SVG."""
    known = contracts()
    texts = descriptions()
    core = {module.removeprefix("jauspy.") for module in known[NO_IO]["source_modules"]}
    used = {"platform", "geometry"} - _forbidden(known)
    # what the simulator imports is at the right end of its row, where the arrows arrive
    rows = _placed([tuple(sorted(names, key=used.__contains__)) for names in layers(known[LAYERS])], texts)
    bottom = rows[-1].top + rows[-1].height
    height = bottom + MARGIN + LINE_HEIGHT + 6
    width = WIDTH + SIMULATOR_WIDTH + 3 * MARGIN + 30
    shapes = [
        f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height:g}' {FONT}>",
        f"<rect width='{width}' height='{height:g}' fill='white'/>",
        _text(MARGIN, 23, "jauspy", "16", "#1b2631", bold=True),
    ]
    for row in rows:
        box = (WIDTH - GAP * (len(row.names) - 1)) / len(row.names)
        for number, name in enumerate(row.names):
            left = MARGIN + number * (box + GAP)
            fill = CORE_FILL if name in core else SHELL_FILL
            shapes += _box(left, row.top, box, row.height, fill=fill, name=name, text=texts.get(name, ""))
    shapes += [
        _text(MARGIN, bottom + LINE_HEIGHT + 6, "A package imports only packages below it.", "12", "#566573"),
        _text(
            MARGIN + 290,
            bottom + LINE_HEIGHT + 6,
            "Green: no sockets, clocks, threads, random numbers.",
            "12",
            "#1e8449",
        ),
    ]
    shapes += _simulator(layers(known[SIMULATOR_LAYERS]), [row for row in rows if used & set(row.names)])
    return "\n".join([*shapes, "</svg>"]) + "\n"


def _placed(found: list[tuple[str, ...]], texts: dict[str, str]) -> list[Row]:
    top = float(TITLE_HEIGHT)
    rows = []
    for names in found:
        box = (WIDTH - GAP * (len(names) - 1)) / len(names)
        lines = max(len(_wrapped(texts.get(name, ""), box)) for name in names)
        height = 27 + LINE_HEIGHT * lines
        rows.append(Row(names, top, height))
        top += height + GAP
    return rows


def _forbidden(known: dict[str, dict[str, Any]]) -> set[str]:
    """The packages of jauspy that the simulator may not import."""
    return {module.removeprefix("jauspy.") for module in known[SIMULATOR_LIMITS]["forbidden_modules"]}


def _simulator(found: list[tuple[str, ...]], imported: list[Row]) -> Iterator[str]:
    """The column of jauspy_sim, and arrows to the rows of the packages that it imports."""
    left = MARGIN + WIDTH + MARGIN + 30
    yield _text(left, 23, "jauspy_sim", "16", "#1b2631", bold=True)
    for number, names in enumerate(found):
        box = (SIMULATOR_WIDTH - GAP * (len(names) - 1)) / len(names)
        for place, name in enumerate(names):
            x, y = left + place * (box + GAP), TITLE_HEIGHT + 35 * number
            yield from _box(x, y, box, 27, fill=SIMULATOR_FILL, name=name)
    bottom = TITLE_HEIGHT + 35 * len(found) - GAP
    for number, row in enumerate(imported):
        level = row.top + row.height / 2
        x = left + 30 + 14 * number
        line = f"M{x:g} {bottom} V{level:g} H{MARGIN + WIDTH + 3}"
        yield f"<path d='{line}' fill='none' stroke='#935116' stroke-width='1.4' marker-end='url(#arrow)'/>"
    yield (
        "<marker id='arrow' viewBox='0 0 10 10' refX='9' refY='5' markerWidth='8' markerHeight='8' orient='auto'>"
        "<path d='M0 0 L10 5 L0 10 z' fill='#935116'/></marker>"
    )


def _box(
    left: float, top: float, width: float, height: float, *, fill: str, name: str, text: str = ""
) -> Iterator[str]:
    yield (
        f"<rect x='{left:g}' y='{top:g}' width='{width:g}' height='{height:g}' rx='5' fill='{fill}' stroke='#aab7b8'/>"
    )
    yield _text(left + 9, top + 18, name, "13", "#1b2631", bold=True)
    for number, line in enumerate(_wrapped(text, width)):
        yield _text(left + 9, top + 34 + LINE_HEIGHT * number, line, "12", "#566573")


def _wrapped(text: str, width: float) -> list[str]:
    return textwrap.wrap(text, max(12, int((width - 18) / CHARACTER_WIDTH)))


def _text(x: float, y: float, text: str, size: str, fill: str, *, bold: bool = False) -> str:
    weight = " font-weight='bold'" if bold else ""
    return f"<text x='{x:g}' y='{y:g}' font-size='{size}' fill='{fill}'{weight}>{escape(text)}</text>"


def main() -> None:
    """Write the drawing."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=TARGET, help="the file that is written")
    arguments = parser.parse_args()
    arguments.output.write_text(draw(), encoding="utf-8")


if __name__ == "__main__":
    main()
