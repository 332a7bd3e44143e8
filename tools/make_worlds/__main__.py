"""Make the included worlds that are not written by hand: `python -m tools.make_worlds [NAME ...]`."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import Final

from .house import house
from .rubble import rubble
from .scene import Scene
from .street import street
from .yard import yard

MADE: Final[dict[str, Callable[[], Scene]]] = {"house": house, "rubble": rubble, "street": street, "yard": yard}


def main() -> None:
    """Write the worlds."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"worlds: {', '.join(MADE)} (default: all)")
    for name in parser.parse_args().names or MADE:
        triangles, size = MADE[name]().write()
        print(f"{name}: {triangles} triangles, {size / 1e6:.1f} MB of meshes")


if __name__ == "__main__":
    main()
