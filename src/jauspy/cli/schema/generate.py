"""`jauspy schema generate`: write message classes of your own definitions as a Python package, or their types."""

from __future__ import annotations

import keyword
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli import console
from jauspy.codec.source import generate as make
from jauspy.codec.stubs import make_stubs
from jauspy.errors import ConfigError
from jauspy.schema import Schema
from jauspy.schema.loader import find_files, load_own

_MARK = "; do not edit."
"""End of the first line of every generated file."""


def generate(
    *,
    files: Annotated[list[str], typer.Argument(metavar="FILE...", help="JSIDL files, folders or patterns.")],
    output: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="DIR", help="The package's folder; with --stubs the module's file."),
    ],
    package: Annotated[
        str | None,
        typer.Option(
            "--package",
            metavar="NAME",
            help="The package's name, as in acme or acme.messages; created in DIR unless DIR ends in it. "
            "Default: the name of DIR.",
        ),
    ] = None,
    stubs: Annotated[
        bool,
        typer.Option(
            "--stubs", help="Write a module that loads the files on import, and a stub (.pyi) with its types."
        ),
    ] = False,
    force: Annotated[bool, typer.Option("--force", help="Overwrite files that were not generated.")] = False,
) -> None:
    """Write message classes as a Python package: typed, byte-exact, like `jauspy.messages`.

    Definitions may refer to built-in ones, which are in the package's registry, too. Generated files are overwritten,
    other files only with --force. `jauspy.load()` does the same without writing files.

    With --stubs, the definitions stay the source: the module makes the classes when it is imported, and type checkers
    and editors read the stub. After a change of the definitions, write both again.

    Examples:
      jauspy schema generate vendor/*.xml -o acme_messages
      jauspy schema generate vendor/ -o src --package acme.messages
      jauspy schema generate battery.xml --stubs -o battery_messages.py
    """
    if stubs:
        _generate_stubs(files, output, package, force=force)
        return
    name, folder = _place(output, package)
    schema = load_own(files)
    sources = make(schema, name, "jauspy.messages")
    _refuse_foreign(folder, sources, force=force)
    _write(folder, {**sources, "py.typed": ""})
    _report_empty(schema)
    _report(folder, name, len(sources))


def _generate_stubs(files: Sequence[str], output: Path, package: str | None, *, force: bool) -> None:

    name = output.stem
    if package is not None:
        raise typer.BadParameter("--stubs writes a module, which has no package; leave it out", param_hint="--package")
    if output.suffix not in ("", ".py") or output.is_dir() or not name.isidentifier() or keyword.iskeyword(name):
        raise typer.BadParameter(
            f"{str(output)!r} is not the file of a Python module; name it as in battery_messages.py",
            param_hint="--output",
        )
    folder = output.parent.resolve()
    schema = load_own(files)
    sources = [path for file in files for path in ([Path(file)] if Path(file).is_dir() else find_files([file]))]
    made = make_stubs(schema, [os.path.relpath(path.resolve(), folder) for path in dict.fromkeys(sources)])
    texts = {f"{name}.py": made.module, f"{name}.pyi": made.stub}
    _refuse_foreign(folder, texts, force=force)
    _write(folder, texts)
    _report_empty(schema)
    console.print_lines(
        f"{len(made.names)} messages. Import with {_shown(folder)} in PYTHONPATH: from {name} import registry"
    )


def _place(output: Path, package: str | None) -> tuple[str, Path]:
    """The package's name and its folder."""
    folder = output.resolve()
    name = folder.name if package is None else package
    parts = name.split(".")
    for part in parts:
        if not part.isidentifier() or keyword.iskeyword(part):
            hint = "give it one with --package" if package is None else "use letters, digits, _ and dots"
            raise typer.BadParameter(f"{name!r} is not the name of a Python package; {hint}", param_hint="--package")
    if package is not None and list(folder.parts[-len(parts) :]) != parts:
        folder = folder.joinpath(*parts)
    return name, folder


def _refuse_foreign(folder: Path, names: Iterable[str], *, force: bool) -> None:

    foreign = [folder / name for name in names if not force and _is_foreign(folder / name)]
    if foreign:
        more = f" and {len(foreign) - 1} more" if len(foreign) > 1 else ""
        raise ConfigError(f"{foreign[0]}{more} would be overwritten and was not generated; use --force, or another DIR")


def _is_foreign(path: Path) -> bool:
    if not path.exists():
        return False
    if not path.is_file():
        return True
    with path.open(encoding="utf-8", errors="replace") as file:
        return _MARK not in file.readline()


def _write(folder: Path, sources: Mapping[str, str]) -> None:

    try:
        for name, text in sources.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            console.print_lines(_shown(path))
    except OSError as error:
        raise ConfigError(f"{error.filename} cannot be written: {error.strerror}") from None


def _shown(path: Path) -> str:
    return str(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)


def _report_empty(schema: Schema) -> None:

    empty = [service.name for service in schema.services if not service.messages]
    if empty:
        console.note(f"no messages in {', '.join(empty)}")


def _report(folder: Path, name: str, number: int) -> None:

    above = folder
    for _ in name.split("."):
        above = above.parent
    console.print_lines(f"{number} files. Import with {_shown(above)} in PYTHONPATH: from {name} import registry")
