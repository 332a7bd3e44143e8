"""Test helpers: a network in memory on virtual time, a real node manager; `plugin` has the pytest fixtures."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.testing.assertions import until as until
    from jauspy.testing.node import LocalNode as LocalNode
    from jauspy.testing.recordings import replay as replay
    from jauspy.virtual.clock import VirtualClock as VirtualClock
    from jauspy.virtual.environment import Environment
    from jauspy.virtual.network import VirtualNetwork as VirtualNetwork

    TestEnvironment = Environment

_EXPORTS = {
    "LocalNode": "jauspy.testing.node:LocalNode",
    "TestEnvironment": "jauspy.virtual.environment:Environment",
    "replay": "jauspy.testing.recordings:replay",
    "until": "jauspy.testing.assertions:until",
    "VirtualClock": "jauspy.virtual.clock:VirtualClock",
    "VirtualNetwork": "jauspy.virtual.network:VirtualNetwork",
}
"""Public names, imported on first use: pytest loads this package in every project that has jauspy installed."""


def __getattr__(name: str) -> object:
    if name not in _EXPORTS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module, _, member = _EXPORTS[name].partition(":")
    return getattr(import_module(module), member)


def __dir__() -> list[str]:
    return sorted({*globals(), *_EXPORTS})
