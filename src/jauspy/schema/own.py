"""A user's own definitions: which files they are, and the services in them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from glob import glob
from pathlib import Path

from lxml.etree import _Element as Element

from jauspy.errors import ConfigError
from jauspy.schema.document import identity, is_jsidl, parse
from jauspy.schema.loader import builtin_paths, load_builtin, load_files
from jauspy.schema.model import Schema

Identity = tuple[str, str, str]
"""The kind of a definition (the tag of its root), its id and its version."""


def find_files(sources: Iterable[str | Path]) -> list[Path]:
    """The files of these files, folders and patterns; other XML in a folder, such as a manifest, is left out.

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
    return [path for path in sorted(folder.rglob("*.xml")) if is_jsidl(path)]


def _matching(pattern: str) -> list[Path]:
    if Path(pattern).exists():
        return [Path(pattern)]
    return [Path(name) for name in sorted(glob(pattern, recursive=True))]  # noqa: PTH207 - patterns may be absolute


def load_own(sources: Iterable[str | Path], beside: Iterable[str | Path] = ()) -> Schema:
    """The services defined in files, folders or patterns; they may refer to what is `beside` them, or built in.

    Their states are not checked, see `load_files`. Raises `SchemaError` with file and line, `ConfigError` when there
    is no such file.
    """
    own = find_files(sources)
    keys = {identity_of(path) for path in own}
    more = find_files(beside) if beside else []
    others = [path for path in more if identity_of(path) not in keys]
    schema = load_beside_builtin([*own, *others], states=False)
    return Schema(services=tuple(s for s in schema.services if ("service_def", *s.key) in keys))


def load_beside_builtin(paths: Iterable[Path], *, states: bool = True) -> Schema:
    """These files and all services that are built in; what the files define again replaces what is built in."""
    own = list(paths)
    return load_files([*own, *_builtin_sets(own)], base=load_builtin(), states=states)


def _builtin_sets(own: Iterable[Path]) -> list[Path]:
    """The shipped type sets that files refer to, directly or through each other."""
    roots = [parse(path)[0] for path in own]
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
    """The shipped definitions as they are written, read once per process; nobody changes them."""
    found = ((path, parse(path)[0]) for path in builtin_paths())
    return {(str(root.tag), *identity(root)): (path, root) for path, root in found}


def identity_of(path: Path) -> Identity:
    """What a file defines."""
    root, _ = parse(path)
    return (str(root.tag), *identity(root))
