"""Messages of exp, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.lazy import exports, load

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_0.types import (
        SeverityRec as SeverityRec,
        UGVSeverityRec as UGVSeverityRec,
    )

_MODULES = exports({
    "jauspy.messages.exp.v1_0.types": "SeverityRec UGVSeverityRec",
})

__all__ = sorted(_MODULES)


def __getattr__(name: str) -> object:
    globals()[name] = value = load(name, _MODULES, __name__)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
