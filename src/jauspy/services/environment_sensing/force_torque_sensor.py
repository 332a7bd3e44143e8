"""ForceTorqueSensor: forces and torques at points of the vehicle, such as the wrist of its arm (AS6060)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.messages.environment_sensing.v2_0.force_torque_sensor import (
    QueryForceTorque,
    QueryForceTorqueCapabilities,
    ReportForceTorque,
    ReportForceTorqueCapabilities,
)
from jauspy.platform.force_torque import ForceTorqueSensor as ForceTorqueSource
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.service import Service

_Frame = ReportForceTorque.CoordinateSystem


@dataclass(frozen=True, slots=True)
class MountedForceTorqueSensor:
    """A force-torque sensor, and where it is mounted."""

    sensor: ForceTorqueSource
    frame: Callable[[], Transform]
    """Returns the sensor's present frame in the vehicle's frame, both with the axes of REP-103."""


class ForceTorqueSensorService(Service, urn="urn:jaus:jss:environmentSensing:ForceTorqueSensor"):
    """The sensors of a vehicle; their ids count from 1 in the order they are given.

    Newtons and newton metres that the tool, and all it carries and touches, does to the sensor: x forward, y right, z
    down, of the sensor or of the vehicle. Torques are about the sensor, whichever axes are record for. The weight of a
    tool that is held level is a positive force along z.
    """

    def __init__(self, sensors: Sequence[MountedForceTorqueSensor]) -> None:
        self._sensors = dict(enumerate(sensors, start=1))

    def send_report_force_torque(self, query: QueryForceTorque) -> ReportForceTorque:
        """Return the last measurement of each requested sensor; unknown sensors are left out."""
        requested = requested_sensors(query.query_force_torque_list, self._sensors, known_only=True)
        return ReportForceTorque([self._measured(sensor, record) for sensor, record in requested])

    def _measured(
        self, sensor: int, record: QueryForceTorque.QueryForceTorqueRec
    ) -> ReportForceTorque.ReportForceTorqueRec:
        mounted = self._sensors[sensor]
        wrench = mounted.sensor.wrench
        in_vehicle = record.coordinate_system == _Frame.VEHICLE
        axes = JAUS_FROM_REP_103 @ (mounted.frame() if in_vehicle else Transform())
        return ReportForceTorque.ReportForceTorqueRec(
            sensor,
            _Frame.VEHICLE if in_vehicle else _Frame.NATIVE,
            *axes.rotate(wrench.force),
            *axes.rotate(wrench.torque),
        )

    def send_report_force_torque_capabilities(
        self, query: QueryForceTorqueCapabilities
    ) -> ReportForceTorqueCapabilities:
        """Return the measuring ranges of each sensor (N, N m)."""
        requested = requested_sensors(query.query_force_torque_capabilities_list, self._sensors, known_only=True)
        return ReportForceTorqueCapabilities([self._capabilities(sensor) for sensor, _ in requested])

    def _capabilities(self, sensor: int) -> ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec:
        setup = self._sensors[sensor].sensor.setup
        limits = (*(-setup.force, setup.force) * 3, *(-setup.torque, setup.torque) * 3)
        return ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec(sensor, setup.name, True, *limits)
