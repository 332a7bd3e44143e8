"""Shared by all sensor services: the sensors that a message names, and the mounting of sensors."""

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
"""Sensors in one report; a query may have 65535 records, each of which may name all sensors."""


class SensorRecord(Protocol):
    """A record of a query or command about one sensor, or about all."""

    @property
    def sensor_id(self) -> int:
        """Sensor id; `ALL_SENSORS` for all."""
        ...


RecordT = TypeVar("RecordT", bound=SensorRecord)


def requested_sensors(
    records: Sequence[RecordT], sensors: Collection[int], *, known_only: bool = False
) -> list[tuple[int, RecordT]]:
    """Return each requested sensor once, with the first record about it; unknown ones too unless `known_only`."""
    found: dict[int, RecordT] = {}
    for record in records:
        for sensor in sensors if record.sensor_id == ALL_SENSORS else (record.sensor_id,):
            if sensor in sensors or not known_only:
                found.setdefault(sensor, record)
        if len(found) >= MAX_SENSORS:
            break
    return list(found.items())[:MAX_SENSORS]


@dataclass(frozen=True, slots=True)
class JointMount:
    """The joint of a manipulator, or of a pan-tilt unit, that a sensor moves with."""

    manipulator: JausID
    number: int
    """Number of the joint, from 1."""
    frame: Transform
    """The sensor's frame, with JAUS's axes, in the joint's frame as the manipulator defines it."""


@dataclass(frozen=True, slots=True)
class MountedSensor:
    """A sensor of the vehicle with its mounting."""

    frame: Callable[[], Transform]
    """Returns the sensor's present frame in the vehicle's frame, both with the axes of REP-103."""
    is_fixed: bool = True
    """True if the frame never changes."""
    joint: JointMount | None = None
    """The joint that moves the sensor; None if the sensor is fixed or no JAUS component moves the joint."""

    @property
    def in_vehicle(self) -> Transform:
        """The sensor's present frame in the vehicle's frame, both with JAUS's axes."""
        return jaus_frame(self.frame())


@dataclass(frozen=True, slots=True)
class MountedLidar(MountedSensor):
    """A lidar of the vehicle."""

    lidar: RangeFinder = field(kw_only=True)


def geometric_properties(sensor: int, mounted: MountedSensor) -> Report.GeometricPropertiesSequence:
    """Return the sensor's pose on the vehicle, or on the joint that moves it; no properties if the joint is unknown."""
    found: Report.NoGeometricPropertiesVariant | StaticGeometricPropertiesRec | ManipulatorGeometricPropertiesRec
    if mounted.is_fixed:
        found = StaticGeometricPropertiesRec(*_position_and_rotation(mounted.in_vehicle))
    elif (joint := mounted.joint) is not None:
        id = joint.manipulator
        found = ManipulatorGeometricPropertiesRec(
            id.subsystem, id.node, id.component, joint.number, *_position_and_rotation(joint.frame)
        )
    else:
        found = Report.NoGeometricPropertiesVariant(Report.Empty0())
    return Report.GeometricPropertiesSequence(SensorIdRec(sensor), found)


def _position_and_rotation(frame: Transform) -> tuple[list[float], list[float]]:
    return list(frame.position), list(quaternion(frame.rotation))
