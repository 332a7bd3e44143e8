"""urn:jaus:jss:environmentSensing:ForceTorqueSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:ForceTorqueSensor", "2.0")


@jd.message(_SERVICE, 0x480B)
class ReportForceTorqueCapabilities(jd.Message):
    """ReportForceTorqueCapabilities (0x480B): Tells the limits of measurement.

    report_force_torque_capabilities_list: 0..65535 items. The sensors
    """

    class CoordinateTransformSupported(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("H")
    class ReportForceTorqueCapabilitiesRec(jd.Struct):
        """sensor_id: Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        coordinate_transform_supported: CoordinateTransformSupported, optional. Whether the sensor can report in the frame of the vehicle
        min_force_x: -5000..5000 newton, optional. Smallest force along X, in newtons
        max_force_x: -5000..5000 newton, optional. Largest force along X, in newtons
        min_force_y: -5000..5000 newton, optional. Smallest force along Y, in newtons
        max_force_y: -5000..5000 newton, optional. Largest force along Y, in newtons
        min_force_z: -5000..5000 newton, optional. Smallest force along Z, in newtons
        max_force_z: -5000..5000 newton, optional. Largest force along Z, in newtons
        min_torque_x: -5000..5000 newton meter, optional. Smallest torque about X, in newton metres
        max_torque_x: -5000..5000 newton meter, optional. Largest torque about X, in newton metres
        min_torque_y: -5000..5000 newton meter, optional. Smallest torque about Y, in newton metres
        max_torque_y: -5000..5000 newton meter, optional. Largest torque about Y, in newton metres
        min_torque_z: -5000..5000 newton meter, optional. Smallest torque about Z, in newton metres
        max_torque_z: -5000..5000 newton meter, optional. Largest torque about Z, in newton metres
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        sensor_name: str = jd.field("SensorName", jd.Text(count=jd.Count("B", 0, 255)))
        coordinate_transform_supported: ReportForceTorqueCapabilities.CoordinateTransformSupported | int | None = jd.field("CoordinateTransformSupported", lambda: jd.Number("B", jd.Values(ReportForceTorqueCapabilities.CoordinateTransformSupported)), default=None)
        min_force_x: float | None = jd.field("MinForceX", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        max_force_x: float | None = jd.field("MaxForceX", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        min_force_y: float | None = jd.field("MinForceY", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        max_force_y: float | None = jd.field("MaxForceY", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        min_force_z: float | None = jd.field("MinForceZ", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        max_force_z: float | None = jd.field("MaxForceZ", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        min_torque_x: float | None = jd.field("MinTorqueX", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        max_torque_x: float | None = jd.field("MaxTorqueX", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        min_torque_y: float | None = jd.field("MinTorqueY", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        max_torque_y: float | None = jd.field("MaxTorqueY", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        min_torque_z: float | None = jd.field("MinTorqueZ", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        max_torque_z: float | None = jd.field("MaxTorqueZ", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        reserved_presence: int = 0

    report_force_torque_capabilities_list: list[ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec] = jd.field("ReportForceTorqueCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportForceTorqueCapabilities.ReportForceTorqueCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x280B, query=True)
class QueryForceTorqueCapabilities(jd.Message):
    """QueryForceTorqueCapabilities (0x280B): Asks for the limits of measurement.

    query_force_torque_capabilities_list: 0..65535 items. The sensors
    """
    REPORT = ReportForceTorqueCapabilities

    @jd.record()
    class QueryForceTorqueCapabilitiesRec(jd.Struct):
        """sensor_id: Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    query_force_torque_capabilities_list: list[QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec] = jd.field("QueryForceTorqueCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryForceTorqueCapabilities.QueryForceTorqueCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x480C)
class ReportForceTorque(jd.Message):
    """ReportForceTorque (0x480C): Tells forces and torques.

    report_force_torque_list: 0..65535 items. The sensors
    """

    class CoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    @jd.record("B")
    class ReportForceTorqueRec(jd.Struct):
        """sensor_id: Identifies the sensor
        coordinate_system: CoordinateSystem. Frame of the report
        force_x: -5000..5000 newton, optional. Force along X, in newtons
        force_y: -5000..5000 newton, optional. Force along Y, in newtons
        force_z: -5000..5000 newton, optional. Force along Z, in newtons
        torque_x: -5000..5000 newton meter, optional. Torque about X, in newton metres
        torque_y: -5000..5000 newton meter, optional. Torque about Y, in newton metres
        torque_z: -5000..5000 newton meter, optional. Torque about Z, in newton metres
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        coordinate_system: ReportForceTorque.CoordinateSystem | int = jd.field("CoordinateSystem", lambda: jd.Number("B", jd.Values(ReportForceTorque.CoordinateSystem)))
        force_x: float | None = jd.field("ForceX", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        force_y: float | None = jd.field("ForceY", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        force_z: float | None = jd.field("ForceZ", jd.real("H", -5000.0, 5000.0, "newton"), default=None)
        torque_x: float | None = jd.field("TorqueX", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        torque_y: float | None = jd.field("TorqueY", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        torque_z: float | None = jd.field("TorqueZ", jd.real("H", -5000.0, 5000.0, "newton meter"), default=None)
        reserved_presence: int = 0

    report_force_torque_list: list[ReportForceTorque.ReportForceTorqueRec] = jd.field("ReportForceTorqueList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportForceTorque.ReportForceTorqueRec.layout()))


@jd.message(_SERVICE, 0x280C, query=True)
class QueryForceTorque(jd.Message):
    """QueryForceTorque (0x280C): Asks for forces and torques.

    query_force_torque_list: 0..65535 items. The sensors
    """
    REPORT = ReportForceTorque

    class CoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    @jd.record()
    class QueryForceTorqueRec(jd.Struct):
        """sensor_id: Which sensor is meant; 0 is all
        coordinate_system: CoordinateSystem. Frame of the report
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        coordinate_system: QueryForceTorque.CoordinateSystem | int = jd.field("CoordinateSystem", lambda: jd.Number("B", jd.Values(QueryForceTorque.CoordinateSystem)))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_force_torque_list: list[QueryForceTorque.QueryForceTorqueRec] = jd.field("QueryForceTorqueList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryForceTorque.QueryForceTorqueRec.layout()))
