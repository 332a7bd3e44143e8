"""urn:jaus:jss:exp:aeodrs:AEODRSDigitalVideo 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:AEODRSDigitalVideo", "1.4")


@jd.message(_SERVICE, 0xF805)
class ReportAimpointParameters(jd.Message):
    """ReportAimpointParameters (0xF805): Picture size and place of the aiming mark of one camera."""

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the camera"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    @jd.record()
    class ResolutionRec(jd.Struct):
        """x_resolution: Picture width in pixels
        y_resolution: Picture height in pixels
        """
        x_resolution: int = jd.field("XResolution", jd.Number("H"))
        y_resolution: int = jd.field("YResolution", jd.Number("H"))

    @jd.record()
    class ReticlePositionRec(jd.Struct):
        """x_reticle_position: Column of the aiming mark, in pixels from the left
        y_reticle_position: Row of the aiming mark, in pixels from the top
        """
        x_reticle_position: int = jd.field("XReticlePosition", jd.Number("H"))
        y_reticle_position: int = jd.field("YReticlePosition", jd.Number("H"))

    sensor_id_rec: ReportAimpointParameters.SensorIdRec = jd.field("SensorIdRec", lambda: ReportAimpointParameters.SensorIdRec.layout())
    resolution_rec: ReportAimpointParameters.ResolutionRec = jd.field("ResolutionRec", lambda: ReportAimpointParameters.ResolutionRec.layout())
    reticle_position_rec: ReportAimpointParameters.ReticlePositionRec = jd.field("ReticlePositionRec", lambda: ReportAimpointParameters.ReticlePositionRec.layout())


@jd.message(_SERVICE, 0xE805, query=True)
class QueryAimpointParameters(jd.Message):
    """QueryAimpointParameters (0xE805): Asks where the aiming mark lies in a camera's picture.

    sensor_id: Number of the camera
    """
    REPORT = ReportAimpointParameters
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xF802)
class ReportDigitalVideoEndpoint(jd.Message):
    """ReportDigitalVideoEndpoint (0xF802): Network address one camera's RTP stream goes to.

    endpoint_record: Endpoint
    """
    EndpointRecord = exp_v1_0_types.EndpointRecord

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the camera"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    sensor_id_rec: ReportDigitalVideoEndpoint.SensorIdRec = jd.field("SensorIdRec", lambda: ReportDigitalVideoEndpoint.SensorIdRec.layout())
    endpoint_record: exp_v1_0_types.EndpointRecord = jd.field("EndpointRecord", lambda: exp_v1_0_types.EndpointRecord.layout())


@jd.message(_SERVICE, 0xE802, query=True)
class QueryDigitalVideoEndpoint(jd.Message):
    """QueryDigitalVideoEndpoint (0xE802): Asks where a camera's RTP stream goes.

    sensor_id: Number of the camera
    """
    REPORT = ReportDigitalVideoEndpoint
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xD802, command=True)
class SetDigitalVideoEndpoint(jd.Message):
    """SetDigitalVideoEndpoint (0xD802): Sets the network address one camera's RTP stream goes to.

    endpoint_record: Endpoint
    """
    EndpointRecord = exp_v1_0_types.EndpointRecord

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the camera"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    sensor_id_rec: SetDigitalVideoEndpoint.SensorIdRec = jd.field("SensorIdRec", lambda: SetDigitalVideoEndpoint.SensorIdRec.layout())
    endpoint_record: exp_v1_0_types.EndpointRecord = jd.field("EndpointRecord", lambda: exp_v1_0_types.EndpointRecord.layout())
