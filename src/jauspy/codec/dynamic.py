"""`jauspy.load`: message classes of a user's own JSIDL, made by the generator and executed in memory."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping, Sequence
from glob import glob
from importlib import import_module
from importlib.abc import InspectLoader, MetaPathFinder
from importlib.machinery import ModuleSpec
from itertools import count
from pathlib import Path
from types import ModuleType

from jauspy.codec.generator import generate
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.schema import builtin_paths, load_files
from jauspy.schema.model import Schema
from jauspy.schema.reading import required
from jauspy.schema.source import read

_numbers = count(1)


def load(*sources: str | Path) -> Registry:
    """The messages of JSIDL files, folders or patterns (`load("vendor/*.xml")`), in front of the built-in ones.

    The files may refer to each other and to everything built in; a service they define again replaces the built-in
    one. Raises `SchemaError` with file and line, `ConfigError` when there is no such file.
    """
    own = _files(sources)
    keys = {_key(path) for path in own}
    schema = load_files([*own, *(path for path in builtin_paths() if _key(path) not in keys)])
    services = tuple(s for s in schema.services if ("service_def", s.id, s.version) in keys)
    return load_schema(Schema(services=services))


def load_schema(schema: Schema) -> Registry:
    """The messages of a model, in front of the built-in ones."""
    package = f"jauspy_loaded_{next(_numbers)}"
    sources = {_module_name(package, path): text for path, text in generate(schema, package, "jauspy.messages").items()}
    sys.meta_path.append(_Finder(sources))
    registry = import_module(package).registry
    assert isinstance(registry, Registry)
    return registry


def _files(sources: Iterable[str | Path]) -> list[Path]:
    found: list[Path] = []
    for source in sources:
        path = Path(source)
        matches = sorted(path.rglob("*.xml")) if path.is_dir() else [Path(name) for name in sorted(glob(str(source)))]
        if not matches:
            raise ConfigError(f"no JSIDL file matches {str(source)!r}")
        found += [match for match in matches if match not in found]
    if not found:
        raise ConfigError("name at least one JSIDL file, folder or pattern")
    return found


def _key(path: Path) -> tuple[str, str, str]:
    root, _ = read(path)
    return str(root.tag), required(root, "id"), required(root, "version")


def _module_name(package: str, path: str) -> str:
    parts = [package, *path.removesuffix(".py").split("/")]
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


class _Finder(MetaPathFinder, InspectLoader):
    """Imports modules from memory; their source stays available to tracebacks and debuggers."""

    def __init__(self, sources: Mapping[str, str]) -> None:
        self._sources = sources

    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if fullname not in self._sources:
            return None
        return ModuleSpec(fullname, self, origin=f"<{fullname}>", is_package=self.is_package(fullname))

    def is_package(self, fullname: str) -> bool:
        return any(name.startswith(f"{fullname}.") for name in self._sources)

    def get_source(self, fullname: str) -> str:
        return self._sources[fullname]

    def exec_module(self, module: ModuleType) -> None:
        code = self.source_to_code(self.get_source(module.__name__), f"<{module.__name__}>")
        exec(code, module.__dict__)  # noqa: S102 - our own generator wrote this source
