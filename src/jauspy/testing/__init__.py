"""Test helpers: a network in memory on virtual time, a real node manager; `plugin` has the pytest fixtures."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.testing.assertions import until as until
    from jauspy.testing.clock import VirtualClock as VirtualClock
    from jauspy.testing.environment import TestEnvironment as TestEnvironment
    from jauspy.testing.network import VirtualNetwork as VirtualNetwork
    from jauspy.testing.node import LocalNode as LocalNode

_EXPORTS = {
    "LocalNode": "jauspy.testing.node",
    "TestEnvironment": "jauspy.testing.environment",
    "until": "jauspy.testing.assertions",
    "VirtualClock": "jauspy.testing.clock",
    "VirtualNetwork": "jauspy.testing.network",
}
"""Public names, imported on first use: pytest loads this package in every project that has jauspy installed."""


def __getattr__(name: str) -> object:
    if name not in _EXPORTS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_EXPORTS[name]), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *_EXPORTS})
