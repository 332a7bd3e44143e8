"""The kinds of capability modules, one file for each."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from .audio import Audio, AudioContext
from .cell import Connector, ConveyorBelt, ModularArmKind, PartSensors, Servo
from .end_effector import EndEffector, EndEffectorContext
from .kind import Context, Kind, Module, ModuleBuild, ServiceEntry, Shared, Stoppable
from .manipulator import ManipulatorContext, ManipulatorKind
from .master import Master, MasterContext
from .mobility import Mobility, MobilityContext
from .sensing import Sensing, SensorContext
from .vision import Vision, VisionContext

__all__ = [
    "KINDS",
    "AudioContext",
    "Context",
    "EndEffectorContext",
    "Kind",
    "ManipulatorContext",
    "MasterContext",
    "MobilityContext",
    "Module",
    "ModuleBuild",
    "SensorContext",
    "ServiceEntry",
    "Shared",
    "Stoppable",
    "VisionContext",
]

_KINDS: Final[tuple[Kind[Any], ...]] = (
    Mobility(),
    Master(),
    ManipulatorKind(),
    EndEffector(),
    Sensing(),
    Audio(),
    Vision(),
    Servo(),
    Connector(),
    ConveyorBelt(),
    PartSensors(),
    ModularArmKind(),
)

KINDS: Final[Mapping[str, Kind[Any]]] = {kind.type: kind for kind in _KINDS}
"""Kinds by the `type` of a module."""
