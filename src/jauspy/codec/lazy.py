"""Names that a package offers and imports when they are first used."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module


def exports(modules: Mapping[str, str]) -> dict[str, str]:
    """The module of every name, out of the names (with blanks between them) of every module."""
    return {name: module for module, names in modules.items() for name in names.split()}


def load(name: str, modules: Mapping[str, str], package: str) -> object:
    """What a package has under a name; raises `AttributeError`."""
    if name not in modules:
        raise AttributeError(f"module {package!r} has no attribute {name!r}")
    value: object = getattr(import_module(modules[name]), name)
    return value
