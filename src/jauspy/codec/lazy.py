"""Names that a package offers and imports when they are first used."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from importlib import import_module


def lazy(
    package: str, modules: Mapping[str, str]
) -> tuple[list[str], Callable[[str], object], Callable[[], list[str]]]:
    """`__all__`, `__getattr__` and `__dir__` of a package, from the names (with blanks between them) of each module."""
    names = {name: module for module, listed in modules.items() for name in listed.split()}

    def load(name: str) -> object:
        if name not in names:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value: object = getattr(import_module(names[name]), name)
        setattr(sys.modules[package], name, value)
        return value

    return sorted(names), load, lambda: sorted({*vars(sys.modules[package]), *names})
