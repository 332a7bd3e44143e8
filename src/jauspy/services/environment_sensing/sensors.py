"""Which sensors a query or command is about."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from typing import Final, Protocol, TypeVar

from jauspy.geometry.poses import Transform, jaus_frame
from jauspy.geometry.vectors import quaternion
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v1_0.types import (
    ManipulatorGeometricPropertiesRec,
    SensorIdRec,
    StaticGeometricPropertiesRec,
)
from jauspy.messages.environment_sensing.v2_0.range_sensor import ReportSensorGeometricProperties as Report
from jauspy.platform.ranging import RangeFinder

ALL_SENSORS: Final = 0
"""The id that stands for all sensors."""

MAX_SENSORS: Final = 64
"""Sensors that one answer is about: a query may name 65535, and one of them may be all of them."""


class SensorRecord(Protocol):
    """What a query says of a sensor."""

    @property
    def sensor_id(self) -> int:
        """Its id, or 0 for all."""
        ...


RecordT = TypeVar("RecordT", bound=SensorRecord)


def requested_sensors(
    records: Sequence[RecordT], sensors: Collection[int], *, known_only: bool = False
) -> list[tuple[int, RecordT]]:
    """Each sensor that is asked for, once, with the first record about it; unknown ones too unless `known_only`."""
    found: dict[int, RecordT] = {}
    for record in records:
        for sensor in sensors if record.sensor_id == ALL_SENSORS else (record.sensor_id,):
            if sensor in sensors or not known_only:
                found.setdefault(sensor, record)
        if len(found) >= MAX_SENSORS:
            break
    return list(found.items())[:MAX_SENSORS]


@dataclass(frozen=True, slots=True)
class OnJoint:
    """The joint of a manipulator, or of a pan-tilt unit, that a sensor moves with."""

    manipulator: JausID
    number: int
    """Of the joint, from 1."""
    frame: Transform
    """The sensor's frame, with JAUS's axes, in that of the joint, which is the manipulator's own."""


@dataclass(frozen=True, slots=True)
class OnVehicle:
    """A sensor of the vehicle, and where it is mounted."""

    frame: Callable[[], Transform]
    """Its frame in the vehicle's now, both as in REP-103."""
    is_fixed: bool = True
    """The frame never changes."""
    carrier: OnJoint | None = None
    """What it moves with, if JAUS knows it."""

    @property
    def in_vehicle(self) -> Transform:
        """Its frame in the vehicle's now, both with JAUS's axes."""
        return jaus_frame(self.frame())


@dataclass(frozen=True, slots=True)
class Mounted(OnVehicle):
    """A lidar of the vehicle."""

    lidar: RangeFinder = field(kw_only=True)


def geometric_properties(sensor: int, mounted: OnVehicle) -> Report.GeometricPropertiesSequence:
    """Where a sensor is on the vehicle, or on the joint that moves it; nothing where that is unknown."""
    found: Report.NoGeometricPropertiesVariant | StaticGeometricPropertiesRec | ManipulatorGeometricPropertiesRec
    if mounted.is_fixed:
        found = StaticGeometricPropertiesRec(*_place(mounted.in_vehicle))
    elif (joint := mounted.carrier) is not None:
        id = joint.manipulator
        found = ManipulatorGeometricPropertiesRec(
            id.subsystem, id.node, id.component, joint.number, *_place(joint.frame)
        )
    else:
        found = Report.NoGeometricPropertiesVariant(Report.Empty0())
    return Report.GeometricPropertiesSequence(SensorIdRec(sensor), found)


def _place(frame: Transform) -> tuple[list[float], list[float]]:
    return list(frame.position), list(quaternion(frame.rotation))
