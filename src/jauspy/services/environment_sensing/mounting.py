"""Where a sensor sits on the vehicle."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from jauspy.messages.environment_sensing.v1_0.types import SensorIdRec, StaticGeometricPropertiesRec
from jauspy.messages.environment_sensing.v2_0.range_sensor import ReportSensorGeometricProperties as Report
from jauspy.platform.ranging import RangeFinder
from jauspy.platform.vectors import Transform
from jauspy.services.axes import jaus_frame
from jauspy.services.manipulator.quaternion import quaternion


@dataclass(frozen=True, slots=True)
class Mounted:
    """A lidar of the vehicle."""

    lidar: RangeFinder
    frame: Callable[[], Transform]
    """Its frame in the vehicle's now, both as in REP-103."""
    is_fixed: bool = True
    """The frame never changes."""

    @property
    def in_vehicle(self) -> Transform:
        """Its frame in the vehicle's now, both with JAUS's axes."""
        return jaus_frame(self.frame())


def geometric_properties(sensor: int, mounted: Mounted) -> Report.GeometricPropertiesSequence:
    """Position and attitude of a sensor that is fixed to the vehicle; of one that moves nothing is told."""
    found: Report.NoGeometricPropertiesVariant | StaticGeometricPropertiesRec
    if mounted.is_fixed:
        frame = mounted.in_vehicle
        found = StaticGeometricPropertiesRec(list(frame.position), list(quaternion(frame.rotation)))
    else:
        found = Report.NoGeometricPropertiesVariant(Report.Empty0())
    return Report.GeometricPropertiesSequence(SensorIdRec(sensor), found)
