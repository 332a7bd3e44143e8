"""Loads JSIDL files into a `Schema`: a user's files, the shipped ones, or those that some services need.

All reading of files in this package is done here.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from glob import glob
from importlib.resources import files
from pathlib import Path
from typing import Final, TypeAlias

from lxml.etree import _Element as Element

from jauspy.errors import ConfigError, SchemaError
from jauspy.schema.document import DECLARED, identity, is_jsidl, parse, read, wrong
from jauspy.schema.fields import read_composite, read_content, read_field, read_value_set
from jauspy.schema.library import Key, Library, NameScope
from jauspy.schema.model import Schema, ServiceDefinition
from jauspy.schema.services import read_event, read_message, read_service, resolve_parents, version_key
from jauspy.schema.state_tree import check_behavior

MAX_FILE_SIZE: Final = 4 * 1024 * 1024
"""Bytes; the largest public definition has less than a tenth of it."""

Identity: TypeAlias = tuple[str, str, str]
"""The kind of a definition (the tag of its root), its id and its version."""

Wanted: TypeAlias = tuple[str, str | None]
"""The URN of a service and its version, None for the newest."""

# Shipped files are formatted alike, so tags can be found without parsing, which takes longer.
_HEAD: Final = 1024
"""Bytes within which the start tag of the root ends."""
_ROOT: Final = re.compile(rb"<(?:service_def|declared_type_set|declared_const_set)\s([^>]*)>")
_SERVICE: Final = re.compile(rb"<service_def\s([^>]*)>")
_REFERENCE: Final = re.compile(rb"<(?:inherits_from|declared_type_set_ref|declared_const_set_ref)\s([^>]*)>")
_ID: Final = re.compile(rb'\bid="([^"]*)"')
_VERSION: Final = re.compile(rb'\bversion="([^"]*)"')


def read_bytes(path: Path) -> bytes:
    """The content of a file. Raises `SchemaError` if it cannot be read or has more than `MAX_FILE_SIZE` bytes."""
    try:
        with path.open("rb") as file:
            data = file.read(MAX_FILE_SIZE + 1)
    except OSError as error:
        raise SchemaError(f"cannot be read: {error.strerror}", file=path) from error
    if len(data) > MAX_FILE_SIZE:
        raise SchemaError(f"larger than {MAX_FILE_SIZE} bytes", file=path)
    return data


def parse_file(path: Path) -> Element:
    """The root element of a JSIDL file; only the root is checked against the grammar."""
    return parse(read_bytes(path), path)[0]


def load_files(paths: Iterable[str | Path], *, base: Schema | None = None, states: bool = True) -> Schema:
    """Read JSIDL files, in any order, that may refer to each other. Raises `SchemaError` with file and line.

    New services may inherit from those of `base`, which are part of the result except where a file defines the
    same id and version. Type sets are those of the files alone. Without `states`, the
    references of behaviour are not checked, so that messages can be used although a state is misspelt.
    """
    library = Library()
    versions: dict[Key, str] = {}
    roots: dict[Key, Element] = {}
    for path in paths:
        root, jsidl = read(read_bytes(Path(path)), Path(path))
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


def _order(service: ServiceDefinition) -> tuple[str, tuple[int, ...]]:
    return service.id, version_key(service.version)


def _read_all_types(scope: NameScope) -> None:
    """Read all types, including unused ones, so that errors in them are found now."""
    for name, element in scope.types.items():
        try:
            scope.once(name, element, _reader(element, scope))
        except RecursionError as error:
            raise wrong(element, f"'{name}' refers to declared types too deeply") from error


def _reader(element: Element, scope: NameScope) -> Callable[[], object]:
    kind = DECLARED.get(str(element.tag), str(element.tag))
    read_type = _READERS.get(kind, read_field)
    return lambda: read_type(element, scope)


_READERS: Mapping[str, Callable[[Element, NameScope], object]] = {
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


def find_files(sources: Iterable[str | Path]) -> list[Path]:
    """The files that paths and patterns select; other XML in a folder, such as a manifest, is left out.

    Raises `ConfigError` for a source that gives no file.
    """
    found: list[Path] = []
    for source in sources:
        path = Path(source)
        matches = _in_folder(path) if path.is_dir() else _matching(str(source))
        if not matches:
            raise ConfigError(f"no JSIDL file matches {str(source)!r}")
        found += [match for match in matches if match not in found]
    if not found:
        raise ConfigError("name at least one JSIDL file, folder or pattern")
    return found


def _in_folder(folder: Path) -> list[Path]:
    return [path for path in sorted(folder.rglob("*.xml")) if _is_jsidl_file(path)]


def _is_jsidl_file(path: Path) -> bool:
    try:
        return is_jsidl(read_bytes(path), path)
    except SchemaError:
        return True  # reading it raises the error


def _matching(pattern: str) -> list[Path]:
    if Path(pattern).exists():
        return [Path(pattern)]
    return [Path(name) for name in sorted(glob(pattern, recursive=True))]  # noqa: PTH207 - patterns may be absolute


def load_own(sources: Iterable[str | Path], references: Iterable[str | Path] = ()) -> Schema:
    """The services defined in files, folders or patterns; they may refer to those of `references`, or built-in ones.

    Their states are not checked, see `load_files`. Raises `SchemaError` with file and line, `ConfigError` when there
    is no such file.
    """
    given = find_files(sources)
    keys = {identity_of(path) for path in given}
    more = find_files(references) if references else []
    others = [path for path in more if identity_of(path) not in keys]
    schema = load_beside_builtin([*given, *others], states=False)
    own = tuple(s for s in schema.services if ("service_def", *s.key) in keys)
    return Schema(services=own, files=tuple(map(str, (*given, *others))))


def load_beside_builtin(paths: Iterable[Path], *, states: bool = True) -> Schema:
    """Load these files and all built-in services; definitions in the files replace built-in ones."""
    given = list(paths)
    return load_files([*given, *_builtin_sets(given)], base=load_builtin(), states=states)


def _builtin_sets(given: Iterable[Path]) -> list[Path]:
    """The shipped type sets that files refer to, directly or through each other."""
    roots = [parse_file(path) for path in given]
    known = {(str(root.tag), *identity(root)) for root in roots}
    found = []
    for root in roots:
        for reference in root.iter("declared_type_set_ref", "declared_const_set_ref"):
            key: Identity = (str(reference.tag).removesuffix("_ref"), *identity(reference))
            if key not in known and key in builtin_roots():
                known.add(key)
                path, other = builtin_roots()[key]
                found.append(path)
                roots.append(other)
    return found


@cache
def builtin_roots() -> Mapping[Identity, tuple[Path, Element]]:
    """The shipped definitions as XML, read once per process; not to be modified."""
    found = ((path, parse_file(path)) for path in builtin_paths())
    return {(str(root.tag), *identity(root)): (path, root) for path, root in found}


def identity_of(path: Path) -> Identity:
    """The kind, id and version that a file defines."""
    root = parse_file(path)
    return (str(root.tag), *identity(root))


@cache
def load_needed(wanted: frozenset[Wanted]) -> Schema:
    """Load these shipped services with all ancestors, the same as in `load_builtin()`.

    For a service without the wanted version all versions are loaded, for an unknown service none.
    """
    loaded = _shipped_services()
    services: dict[Key, Path] = {}
    sets: set[Path] = set()
    seen: set[Path] = set()
    waiting = [path for pattern in wanted for path in _files(*pattern)]
    while waiting:
        path = waiting.pop()
        if path in seen:
            continue
        seen.add(path)
        data = read_bytes(path)
        key = next(_keys(_SERVICE, data[:_HEAD]), None)
        if key is None:
            sets.add(path)
        else:
            services[key] = path
        waiting += [other for referred in _keys(_REFERENCE, data) for other in _files(*referred)]
    missing = [path for key, path in services.items() if key not in loaded]
    if missing:
        schema = load_files(sorted([*missing, *sets]), base=Schema(services=tuple(loaded.values())))
        loaded |= {service.key: service for service in schema.services}
    return Schema(services=tuple(sorted((loaded[key] for key in services), key=_order)))


@cache
def _shipped_services() -> dict[Key, ServiceDefinition]:
    """The shipped services that `load_needed` has loaded so far: modules of a robot have many in common."""
    return {}


def versions_of(id: str) -> tuple[str, ...]:
    """The shipped versions of a service, newest first; none when it is not built in."""
    return tuple(sorted(_index().get(id, ()), key=version_key, reverse=True))


def _files(id: str, version: str | None) -> Iterable[Path]:
    versions = _index().get(id, {})
    if version is None:
        version = max(versions, key=version_key, default="")
    return [versions[version]] if version in versions else versions.values()


@cache
def _index() -> Mapping[str, Mapping[str, Path]]:
    """The shipped files by the id and version of what they define."""
    found: dict[str, dict[str, Path]] = {}
    for path in builtin_paths():
        with path.open("rb") as file:
            head = file.read(_HEAD)
        for id, version in _keys(_ROOT, head):
            found.setdefault(id, {})[version] = path
    return found


def _keys(tag: re.Pattern[bytes], text: bytes) -> Iterator[Key]:
    for attributes in tag.findall(text):
        id, version = _ID.search(attributes), _VERSION.search(attributes)
        if id and version:
            yield id[1].decode(), version[1].decode()
