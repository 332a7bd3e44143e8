"""Messages of core, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.messages.core.v1_0.types import (
        AllEventsRec as AllEventsRec,
        ComponentRec as ComponentRec,
        DateStamp as DateStamp,
        ElementRec as ElementRec,
        EventTypeRec as EventTypeRec,
        QueriedComponentRec as QueriedComponentRec,
        QueriedNodeRec as QueriedNodeRec,
        ServiceRec as ServiceRec,
        SubsystemRec as SubsystemRec,
        TimeStamp as TimeStamp,
    )

_MODULES = {
    "AllEventsRec": "jauspy.messages.core.v1_0.types",
    "ComponentRec": "jauspy.messages.core.v1_0.types",
    "DateStamp": "jauspy.messages.core.v1_0.types",
    "ElementRec": "jauspy.messages.core.v1_0.types",
    "EventTypeRec": "jauspy.messages.core.v1_0.types",
    "QueriedComponentRec": "jauspy.messages.core.v1_0.types",
    "QueriedNodeRec": "jauspy.messages.core.v1_0.types",
    "ServiceRec": "jauspy.messages.core.v1_0.types",
    "SubsystemRec": "jauspy.messages.core.v1_0.types",
    "TimeStamp": "jauspy.messages.core.v1_0.types",
}

__all__ = ("AllEventsRec", "ComponentRec", "DateStamp", "ElementRec", "EventTypeRec", "QueriedComponentRec", "QueriedNodeRec", "ServiceRec", "SubsystemRec", "TimeStamp")


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module(_MODULES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
