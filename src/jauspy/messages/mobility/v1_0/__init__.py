"""Messages of mobility, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from jauspy.messages.mobility.v1_0.types import (
        ReportVelocityStateExtRec as ReportVelocityStateExtRec,
        VelocityLocalXYZRec as VelocityLocalXYZRec,
        VelocityNEDRec as VelocityNEDRec,
        VelocityVehicleXYZRec as VelocityVehicleXYZRec,
        ZPosition as ZPosition,
    )

_MODULES = {
    "ReportVelocityStateExtRec": "jauspy.messages.mobility.v1_0.types",
    "VelocityLocalXYZRec": "jauspy.messages.mobility.v1_0.types",
    "VelocityNEDRec": "jauspy.messages.mobility.v1_0.types",
    "VelocityVehicleXYZRec": "jauspy.messages.mobility.v1_0.types",
    "ZPosition": "jauspy.messages.mobility.v1_0.types",
}

__all__ = ("ReportVelocityStateExtRec", "VelocityLocalXYZRec", "VelocityNEDRec", "VelocityVehicleXYZRec", "ZPosition")


def __getattr__(name: str) -> object:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value: object = getattr(import_module(_MODULES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_MODULES})
