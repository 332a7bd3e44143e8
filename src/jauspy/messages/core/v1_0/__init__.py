"""Messages of core, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.lazy import exports, load

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

_MODULES = exports({
    "jauspy.messages.core.v1_0.types": "AllEventsRec ComponentRec DateStamp ElementRec EventTypeRec QueriedComponentRec QueriedNodeRec ServiceRec SubsystemRec TimeStamp",
})

__all__ = sorted(_MODULES)


def __getattr__(name: str) -> object:
    globals()[name] = value = load(name, _MODULES, __name__)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
