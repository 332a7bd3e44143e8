"""`jauspy new component`: a package with a component, ready to run, and its tests."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from jauspy.schema.model import Schema, Service


def component(
    *,
    name: Annotated[str, typer.Argument(metavar="NAME", help="The package and its folder, as in winch.")],
    service: Annotated[
        str,
        typer.Option("--service", metavar="URN", help="The service, or the end of its name: ugv:ParkingBrakeDriver."),
    ],
    version: Annotated[str | None, typer.Option("--version", metavar="X.Y", help="Default: the newest.")] = None,
    source: Annotated[
        Path | None, typer.Option("--from", metavar="FILE", help="A JSIDL file of your own; it is copied.")
    ] = None,
    id: Annotated[str, typer.Option("--id", metavar="ID", help="The component's id.")] = "101.1.120",
) -> None:
    """Write a start for a component that offers a service: its methods, a program, tests and a README.

    It runs, and its tests pass, at once; what it does is for you to fill in.

    Examples:
      jauspy new component brake --service ugv:ParkingBrakeDriver
      jauspy new component battery --service urn:example:Battery --from battery.xml
    """
    from jauspy.cli.new import stubs
    from jauspy.cli.new.files import write_new_folder
    from jauspy.ids import component_id

    _check(name)
    me = component_id(id)
    schema = _schema(source)
    definition = _find(schema, service, version, source)
    write_new_folder(Path(name), stubs.package(name, definition, schema, source, me))
    print(f"run it with `python -m {name}`, test it with `pytest {name}` (pip install pytest-asyncio)")


def _check(name: str) -> None:
    """Raise `ConfigError` unless a package of this name can be imported, and hides none."""
    import keyword

    from jauspy.errors import ConfigError

    if not name.isidentifier() or name != name.lower() or keyword.iskeyword(name):
        raise ConfigError(f"{name!r} is no name of a Python package; use lower-case letters, digits and _")
    if _is_installed(name):
        raise ConfigError(f"{name} is a module already, which yours would hide; choose another name, as in my_{name}")


def _is_installed(name: str) -> bool:
    """A module of this name is found, also without looking where the user is."""
    import sys
    from importlib.machinery import PathFinder

    elsewhere = [each for each in sys.path if Path(each).resolve() != Path.cwd()]
    known = {*sys.stdlib_module_names, "pytest", "pytest_asyncio", "conftest"}  # the tests need these, installed or not
    return name in known or PathFinder.find_spec(name, elsewhere) is not None


def _schema(source: Path | None) -> Schema:
    from jauspy.schema import load_builtin
    from jauspy.schema.loader import load_beside_builtin

    return load_builtin() if source is None else load_beside_builtin([source])


def _find(schema: Schema, name: str, version: str | None, source: Path | None) -> Service:
    """The definition of this name, or end of it; raises `ConfigError` that says what there is."""
    from difflib import get_close_matches

    from jauspy.errors import ConfigError

    wanted = name.casefold()
    urns = {
        each.id for each in schema.services if each.id.casefold() == wanted or each.id.casefold().endswith(f":{wanted}")
    }
    if len(urns) > 1:
        raise ConfigError(f"several services are called {name}: {', '.join(sorted(urns))}; say which")
    if not urns:
        known = sorted({each.id for each in schema.services})
        close = get_close_matches(name.rpartition(":")[2], [each.rpartition(":")[2] for each in known], 3)
        more = "--from reads your own" if source is None else f"{source} has none of this name"
        hint = f"did you mean {' or '.join(close)}?" if close else f"`jauspy schema ls` lists them; {more}"
        raise ConfigError(f"no service {name!r} is known; {hint}")
    (urn,) = urns
    versions = [each.version for each in schema.services if each.id == urn]
    if version is not None and version not in versions:
        raise ConfigError(f"{urn} has no version {version}; it has {', '.join(versions)}")
    return schema.service(urn, version)
