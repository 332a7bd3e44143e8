"""urn:jaus:jss:iop:ForceTorqueSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:ForceTorqueSensor", "1.1")


@jd.message(_SERVICE, 0xD993)
class ReportForceTorque(jd.Message):
    """ReportForceTorque (0xD993): Gives measured values.

    report_force_torque_list: 0..65535 items. Values of each sensor
    """

    class CoordinateSystem(IntEnum):
        NATIVE_COORDINATE_SYSTEMS = 0
        VEHICLE_COORDINATE_SYSTEMS = 1

    @jd.record("B")
    class ReportForceTorqueRec(jd.Struct):
        """sensor_id: Number of the sensor; never 0
        coordinate_system: CoordinateSystem. Frame of the values: that of the sensor or of the vehicle
        force_x: -5000..5000 newton, optional. Present force along X
        force_y: -5000..5000 newton, optional. Present force along Y
        force_z: -5000..5000 newton, optional. Present force along Z
        torque_x: -5000..5000 newton meter, optional. Present torque about X
        torque_y: -5000..5000 newton meter, optional. Present torque about Y
        torque_z: -5000..5000 newton meter, optional. Present torque about Z
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


@jd.message(_SERVICE, 0xD991, query=True)
class QueryForceTorque(jd.Message):
    """QueryForceTorque (0xD991): Asks for measured values; the wanted frame is honoured only if the service can transform.

    query_force_torque_list: 0..65535 items. Sensors asked for
    """
    REPORT = ReportForceTorque

    class CoordinateSystem(IntEnum):
        NATIVE_COORDINATE_SYSTEMS = 0
        VEHICLE_COORDINATE_SYSTEMS = 1

    @jd.record()
    class QueryForceTorqueRec(jd.Struct):
        """sensor_id: Number of the sensor; 0 stands for every sensor
        coordinate_system: CoordinateSystem. Frame of the values: that of the sensor or of the vehicle
        query_presence_vector: Mask of the fields wanted (vector of the list element in D993)
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        coordinate_system: QueryForceTorque.CoordinateSystem | int = jd.field("CoordinateSystem", lambda: jd.Number("B", jd.Values(QueryForceTorque.CoordinateSystem)))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_force_torque_list: list[QueryForceTorque.QueryForceTorqueRec] = jd.field("QueryForceTorqueList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryForceTorque.QueryForceTorqueRec.layout()))


@jd.message(_SERVICE, 0xD992)
class ReportForceTorqueCapabilities(jd.Message):
    """ReportForceTorqueCapabilities (0xD992): Gives the measuring ranges.

    report_force_torque_capabilities_list: 0..65535 items. Range of each sensor
    """

    class CoordinateTransformSupported(IntEnum):
        COORDINATE_TRANSFORM_SUPPORTED_FALSE = 0
        COORDINATE_TRANSFORM_SUPPORTED_TRUE = 1

    @jd.record("H")
    class ReportForceTorqueCapabilityRec(jd.Struct):
        """sensor_id: Number of the sensor
        sensor_name: up to 255 characters. Name of the sensor
        coordinate_transform_supported: CoordinateTransformSupported, optional. Whether values can be given in the frame of the vehicle
        min_force_x: -5000..5000 newton, optional. Lowest (most negative) force along X that the sensor can take
        max_force_x: -5000..5000 newton, optional. Highest force along X that the sensor can take
        min_force_y: -5000..5000 newton, optional. Lowest (most negative) force along Y that the sensor can take
        max_force_y: -5000..5000 newton, optional. Highest force along Y that the sensor can take
        min_force_z: -5000..5000 newton, optional. Lowest (most negative) force along Z that the sensor can take
        max_force_z: -5000..5000 newton, optional. Highest force along Z that the sensor can take
        min_torque_x: -5000..5000 newton meter, optional. Lowest (most negative) torque about X that the sensor can take
        max_torque_x: -5000..5000 newton meter, optional. Highest torque about X that the sensor can take
        min_torque_y: -5000..5000 newton meter, optional. Lowest (most negative) torque about Y that the sensor can take
        max_torque_y: -5000..5000 newton meter, optional. Highest torque about Y that the sensor can take
        min_torque_z: -5000..5000 newton meter, optional. Lowest (most negative) torque about Z that the sensor can take
        max_torque_z: -5000..5000 newton meter, optional. Highest torque about Z that the sensor can take
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

    report_force_torque_capabilities_list: list[ReportForceTorqueCapabilities.ReportForceTorqueCapabilityRec] = jd.field("ReportForceTorqueCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportForceTorqueCapabilities.ReportForceTorqueCapabilityRec.layout()))


@jd.message(_SERVICE, 0xD990, query=True)
class QueryForceTorqueCapabilities(jd.Message):
    """QueryForceTorqueCapabilities (0xD990): Asks for the measuring ranges.

    query_force_torque_capabilities_list: 0..65535 items. Sensors asked for
    """
    REPORT = ReportForceTorqueCapabilities

    @jd.record()
    class QueryForceTorqueCapabilityRec(jd.Struct):
        """sensor_id: Number of the sensor; 0 stands for every sensor
        query_presence_vector: Mask of the fields wanted (vector of the list element in D992)
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    query_force_torque_capabilities_list: list[QueryForceTorqueCapabilities.QueryForceTorqueCapabilityRec] = jd.field("QueryForceTorqueCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryForceTorqueCapabilities.QueryForceTorqueCapabilityRec.layout()))
