"""`jauspy.load`: message classes of a user's own JSIDL, made in memory."""

from __future__ import annotations

import logging
import sys
from importlib import import_module
from itertools import count
from pathlib import Path
from types import ModuleType
from typing import Final

from jauspy.codec.build import Package, build
from jauspy.codec.registry import Registry
from jauspy.schema.model import Schema
from jauspy.schema.own import load_own

_log = logging.getLogger(__name__)
_numbers: Final = count(1)


def load(*sources: str | Path) -> Registry:
    """The messages of JSIDL files, folders or patterns (`load("vendor/*.xml")`), in front of the built-in ones.

    The files may refer to each other and to everything built in, in any mix of versions. A service they define in a
    version that is built in replaces that one; message ids that mean several things are in `Registry.collisions` and in
    the log. When the registry decodes a built-in message, it finds its own messages inside. Raises `SchemaError` with
    file and line, `ConfigError` when there is no such file.
    """
    return load_schema(load_own(sources))


def load_schema(schema: Schema) -> Registry:
    """The messages of a model, in front of the built-in ones."""
    built_in = import_module("jauspy.messages").registry  # of the layer above, which no module here may import
    package = build(schema, f"jauspy_loaded_{next(_numbers)}", built_in)
    _register(package)
    registry = package.registry
    registry.schema = schema
    for code in sorted({message.code for service in schema.services for message in service.messages}):
        if collision := registry.collision(code):
            _log.warning("%s; decoding needs to know the %s", collision, collision.remedy)
    return registry


def _register(package: Package) -> None:
    """Make the modules known to `import`, which is how a registry finds classes, and pickle."""
    root = sys.modules[package.name] = ModuleType(package.name)
    root.__dict__["registry"] = package.registry
    for module in package.modules:
        name = package.name
        for part in module.name.split("."):
            name = f"{name}.{part}"
            sys.modules.setdefault(name, ModuleType(name))
        sys.modules[name].__doc__ = module.doc
        sys.modules[name].__dict__.update({cls.__name__: cls for cls in module.classes})
