"""ForceTorqueSensor, and ManipulatorEndEffectorForceTorqueSensor, in the forms of IOP v3."""

from __future__ import annotations

from collections.abc import Sequence

from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform
from jauspy.geometry.vectors import cross, difference, rotated
from jauspy.messages.iop import ReportManipulatorEndEffectorForceTorque
from jauspy.messages.iop.v1_1.force_torque_sensor import (
    QueryForceTorque,
    QueryForceTorqueCapabilities,
    ReportForceTorque,
    ReportForceTorqueCapabilities,
)
from jauspy.platform.force_torque import ForceTorqueSensor as ForceTorqueSource
from jauspy.services.environment_sensing import MountedForceTorqueSensor
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.service import Service

_Frame = ReportForceTorque.CoordinateSystem
_Measured = ReportForceTorque.ReportForceTorqueRec
MAX_LOAD = 5000.0
"""N and N m; the greatest values of the messages."""


class ForceTorqueSensor(Service, urn="urn:jaus:jss:iop:ForceTorqueSensor"):
    """The same sensors, numbers and axes as in `environmentSensing:ForceTorqueSensor`."""

    def __init__(self, sensors: Sequence[MountedForceTorqueSensor]) -> None:
        self._sensors = dict(enumerate(sensors, start=1))

    def send_report_force_torque(self, query: QueryForceTorque) -> ReportForceTorque:
        """Return the last measurement of each requested sensor; unknown sensors are left out."""
        requested = requested_sensors(query.query_force_torque_list, self._sensors, known_only=True)
        return ReportForceTorque([self._measured(sensor, record.coordinate_system) for sensor, record in requested])

    def _measured(self, sensor: int, frame: int) -> _Measured:
        mounted = self._sensors[sensor]
        wrench = mounted.sensor.wrench
        in_vehicle = frame == _Frame.VEHICLE_COORDINATE_SYSTEMS
        axes = JAUS_FROM_REP_103 @ (mounted.frame() if in_vehicle else Transform())
        loads = (*axes.rotate(wrench.force), *axes.rotate(wrench.torque))
        x, y, z, about_x, about_y, about_z = (max(-MAX_LOAD, min(MAX_LOAD, value)) for value in loads)
        used = _Frame.VEHICLE_COORDINATE_SYSTEMS if in_vehicle else _Frame.NATIVE_COORDINATE_SYSTEMS
        return _Measured(sensor, used, x, y, z, about_x, about_y, about_z)

    def send_report_force_torque_capabilities(
        self, query: QueryForceTorqueCapabilities
    ) -> ReportForceTorqueCapabilities:
        """Return the measuring ranges of each sensor."""
        requested = requested_sensors(query.query_force_torque_capabilities_list, self._sensors, known_only=True)
        return ReportForceTorqueCapabilities([self._capabilities(sensor) for sensor, _ in requested])

    def _capabilities(self, sensor: int) -> ReportForceTorqueCapabilities.ReportForceTorqueCapabilityRec:
        setup = self._sensors[sensor].sensor.setup
        force, torque = min(setup.force, MAX_LOAD), min(setup.torque, MAX_LOAD)
        limits = (*(-force, force) * 3, *(-torque, torque) * 3)
        return ReportForceTorqueCapabilities.ReportForceTorqueCapabilityRec(sensor, setup.name, True, *limits)


class EndEffectorForceTorqueSensor(Service, urn="urn:jaus:jss:iop:ManipulatorEndEffectorForceTorqueSensor"):
    """Reports a sensor of force and torque that the tool is fixed to, at the tool.

    `tip` is the arm's tip link in the sensor's link; `axes` turns directions of the tip link into the end effector's
    (AS6057).
    """

    def __init__(self, sensor: ForceTorqueSource, tip: Transform, axes: Transform) -> None:
        self._sensor, self._tip, self._axes = sensor, tip, axes

    def send_report_manipulator_end_effector_force_torque(self) -> ReportManipulatorEndEffectorForceTorque:
        """Return the last measurement; torques are about the origin of the tip link."""
        wrench = self._sensor.wrench
        turn = (self._axes @ Transform(self._tip.rotation).inverse()).rotation
        torque = difference(wrench.torque, cross(self._tip.position, wrench.force))
        return ReportManipulatorEndEffectorForceTorque(*rotated(turn, wrench.force), *rotated(turn, torque))
