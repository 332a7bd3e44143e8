"""`jauspy new example`: the programs of examples/, which are part of the installed package."""

from __future__ import annotations

import ast
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import console
from jauspy.cli.new import write_new
from jauspy.cli.options import Json
from jauspy.errors import ConfigError

COMPANIONS: Final = {"backend.py": ("tracked.toml", "tracked.urdf"), "own_service.py": ("winch.xml",)}
"""Files that an example reads from its own folder."""
PARTS: Final = frozenset({"README.md", *(name for names in COMPANIONS.values() for name in names)})
"""Files that are no examples by themselves."""


def example(
    name: Annotated[
        str | None, typer.Argument(metavar="NAME", help="As in `verbs`. Without a name, the examples are listed.")
    ] = None,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Where to write it. Default: the current directory.")
    ] = Path(),
    as_json: Json = False,
) -> None:
    """Write an example program to begin with, or list the examples.

    Files that it needs are written beside it. Existing files are not overwritten.

    Example:
      jauspy new example verbs
    """
    examples = _examples()
    if name is None:
        width = max(map(len, examples))
        for stem, program in examples.items():
            if as_json:
                console.print_json({"name": stem, "title": _title(program)})
            else:
                console.print_lines(f"{stem:{width}}  {_title(program)}")
        return
    path = examples.get(name) or examples.get(Path(name).stem)
    if path is None:
        raise ConfigError(f"there is no example {name!r}; there are: {', '.join(examples)}")
    sources = [path, *(path.with_name(companion) for companion in COMPANIONS.get(path.name, ()))]
    write_new({output / source.name: source.read_text() for source in sources})


def _examples() -> dict[str, Path]:
    """The path of each example by its name: inside the installed package, or in `examples/` of the source tree."""
    inside = Path(str(files("jauspy"))) / "examples"
    folder = inside if inside.is_dir() else Path(__file__).parents[4] / "examples"
    paths = sorted(path for path in folder.iterdir() if path.is_file() and path.name not in PARTS)
    return {path.stem: path for path in paths}


def _title(path: Path) -> str:
    """The first sentence of a program's docstring, or of the comment that a file begins with."""
    text = path.read_text()
    title = ast.get_docstring(ast.parse(text)) or "" if path.suffix == ".py" else text.lstrip("# ")
    return title.partition("\n")[0]
