"""JAUS for Python."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.codec.base import Message as Message
    from jauspy.codec.dynamic import load as load
    from jauspy.codec.registry import Registry as Registry

__version__ = "0.1.0"

_EXPORTS = {
    "Message": "jauspy.codec.base",
    "Registry": "jauspy.codec.registry",
    "load": "jauspy.codec.dynamic",
}
"""Public names and where they live; imported on first use, so that `import jauspy` stays light."""


def __getattr__(name: str) -> object:
    if name not in _EXPORTS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module(_EXPORTS[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_EXPORTS})
