"""From files to a `Schema`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.composites import read_composite, read_content
from jauspy.schema.fields import read_field
from jauspy.schema.grammar import DECLARED
from jauspy.schema.library import Key, Library, Scope
from jauspy.schema.messages import read_event, read_message
from jauspy.schema.model import Schema, Service
from jauspy.schema.reading import identity, wrong
from jauspy.schema.services import read_service, resolve_parents, version_key
from jauspy.schema.source import read
from jauspy.schema.state_tree import check_behavior
from jauspy.schema.values import read_value_set


def load_files(paths: Iterable[str | Path], *, base: Schema | None = None, states: bool = True) -> Schema:
    """Read JSIDL files that may refer to each other, in any order; `SchemaError` says what is wrong where.

    New services may inherit from those of `base`, which are part of the result except where a file defines the
    same id and version. Type sets are those of the files alone. Without `states`, what behaviour refers to is
    not checked: for whoever wants messages, and would lose them all to one misspelt state.
    """
    library = Library()
    versions: dict[Key, str] = {}
    roots: dict[Key, Element] = {}
    for path in paths:
        root, jsidl = read(Path(path))
        key = identity(root)
        if library.add(root) and root.tag == "service_def":
            roots[key] = root
            versions[key] = jsidl
    library.link()
    for scope in library.scopes.values():
        _read_all_types(scope)
    services = [read_service(root, versions[key], library.scopes["service_def", key]) for key, root in roots.items()]
    kept = [service for service in base.services if service.key not in roots] if base else []
    resolved = resolve_parents(services, kept, roots)
    if states:
        check_behavior(resolved, kept)
    return Schema(services=tuple(sorted((*kept, *resolved), key=_order)))


def _order(service: Service) -> tuple[str, tuple[int, ...]]:
    return service.id, version_key(service.version)


def _read_all_types(scope: Scope) -> None:
    """Also those that no message uses: an error in them would otherwise wait for its first user."""
    for name, element in scope.types.items():
        try:
            scope.once(name, element, _reader(element, scope))
        except RecursionError as error:
            raise wrong(element, f"'{name}' refers to declared types too deeply") from error


def _reader(element: Element, scope: Scope) -> Callable[[], object]:
    kind = DECLARED.get(str(element.tag), str(element.tag))
    read_type = _READERS.get(kind, read_field)
    return lambda: read_type(element, scope)


_READERS: Mapping[str, Callable[[Element, Scope], object]] = {
    "header": read_content,
    "body": read_content,
    "footer": read_content,
    "message_def": read_message,
    "event_def": read_event,
    "value_set": read_value_set,
    "record": read_composite,
    "list": read_composite,
    "sequence": read_composite,
    "variant": read_composite,
}


def builtin_paths() -> list[Path]:
    """The shipped definitions: inside the installed package, or `schemas/` of the source tree."""
    inside = Path(str(files("jauspy"))) / "schemas"
    folder = inside if inside.is_dir() else Path(__file__).parents[3] / "schemas"
    paths = sorted(folder.rglob("*.xml"))
    if not paths:
        raise SchemaError("the shipped definitions are missing; reinstall jauspy", file=folder)
    return paths


@cache
def load_builtin() -> Schema:
    """The shipped definitions, read once per process."""
    return load_files(builtin_paths())
