"""Write `src/jauspy/messages/` from `schemas/`, or check that it is up to date.

python tools/generate_messages.py [--check] [-o DIR]
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from jauspy.codec.source import generate
from jauspy.schema import load_builtin

TARGET = Path(__file__).parents[1] / "src" / "jauspy" / "messages"


def existing(folder: Path) -> dict[str, str]:
    """The Python files below a folder, by relative path."""
    return {path.relative_to(folder).as_posix(): path.read_text("utf-8") for path in sorted(folder.rglob("*.py"))}


def write(files: dict[str, str], folder: Path) -> None:
    """Make the Python files below `folder` exactly these."""
    for name in existing(folder).keys() - files.keys():
        (folder / name).unlink()
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")


def main() -> int:
    """Exit status 1 when `--check` finds differences."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing, name the files that differ")
    parser.add_argument("-o", "--output", type=Path, default=TARGET, help="folder of the package (%(default)s)")
    options = parser.parse_args()
    files, present = generate(load_builtin()), existing(options.output)
    changed = sorted(name for name in files.keys() | present.keys() if files.get(name) != present.get(name))
    if options.check:
        for name in changed:
            print(f"{options.output / name} is not what schemas/ gives; run {Path(__file__).name}")
        return 1 if changed else 0
    write(files, options.output)
    print(f"{len(files)} files, {len(changed)} changed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
