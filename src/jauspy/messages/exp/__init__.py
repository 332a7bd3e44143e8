"""Messages of exp, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.lazy import exports, load

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_0.types import (
        SeverityRec as SeverityRec,
        UGVSeverityRec as UGVSeverityRec,
    )
    from jauspy.messages.exp.v1_4.health_monitor import (
        QueryUGVSummary as QueryUGVSummary,
        ReportUGVSummary as ReportUGVSummary,
        UpdateUGVSummary as UpdateUGVSummary,
    )

_MODULES = exports({
    "jauspy.messages.exp.v1_0.types": "SeverityRec UGVSeverityRec",
    "jauspy.messages.exp.v1_4.health_monitor": "QueryUGVSummary ReportUGVSummary UpdateUGVSummary",
})

__all__ = sorted(_MODULES)


def __getattr__(name: str) -> object:
    globals()[name] = value = load(name, _MODULES, __name__)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
