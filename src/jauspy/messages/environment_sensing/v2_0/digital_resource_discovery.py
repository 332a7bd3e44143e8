"""urn:jaus:jss:environmentSensing:DigitalResourceDiscovery 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:DigitalResourceDiscovery", "2.0")


@jd.message(_SERVICE, 0x4816)
class ReportDigitalResourceEndpoint(jd.Message):
    """ReportDigitalResourceEndpoint (0x4816): Tells where streams and files are to be fetched.

    digital_resource_endpoint_list: 0..255 items. The streams and files
    """
    JAUS_ID = environment_sensing_v1_0_types.JAUS_ID

    class ServerType(IntEnum):
        RTSP = 0
        MPEG2_TS = 1
        FTP = 2
        SFTP = 3
        FTP_OVER_SSH = 4
        HTTP = 5
        HTTPS = 6
        SCP = 7
        CCSI = 8

    @jd.record("B")
    class DigitalResourceEndpointRec(jd.Struct):
        """One stream or file.

        server_type: ServerType or 9..200 or 201..255. Protocol for fetching it
        server_url: up to 255 characters. Where to fetch it
        jaus_id: optional. The component that the stream or file belongs to
        resource_id: optional. Number of the resource in its component, as a sensor has one
        """
        server_type: ReportDigitalResourceEndpoint.ServerType | int = jd.field("ServerType", lambda: jd.Number("B", jd.Values(ReportDigitalResourceEndpoint.ServerType, ((9, 200), (201, 255)))))
        server_url: str = jd.field("ServerURL", jd.Text(count=jd.Count("B", 0, 255)))
        jaus_id: environment_sensing_v1_0_types.JAUS_ID | None = jd.field("JAUS_ID", lambda: environment_sensing_v1_0_types.JAUS_ID.layout(), default=None)
        resource_id: int | None = jd.field("ResourceID", jd.Number("H"), default=None)
        reserved_presence: int = 0

    digital_resource_endpoint_list: list[ReportDigitalResourceEndpoint.DigitalResourceEndpointRec] = jd.field("DigitalResourceEndpointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDigitalResourceEndpoint.DigitalResourceEndpointRec.layout()))


@jd.message(_SERVICE, 0x2816, query=True)
class QueryDigitalResourceEndpoint(jd.Message):
    """QueryDigitalResourceEndpoint (0x2816): Asks where streams and files are to be fetched."""
    REPORT = ReportDigitalResourceEndpoint


@jd.message(_SERVICE, 0x0808, command=True)
class RegisterDigitalResourceEndpoint(jd.Message):
    """RegisterDigitalResourceEndpoint (0x0808): Enters a stream or file into the list.

    request_id_rec: The number of the request
    digital_resource_endpoint_rec: One stream or file
    """
    JAUS_ID = environment_sensing_v1_0_types.JAUS_ID

    @jd.record()
    class RequestIDRec(jd.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class ServerType(IntEnum):
        RTSP = 0
        MPEG2_TS = 1
        FTP = 2
        SFTP = 3
        FTP_OVER_SSH = 4
        HTTP = 5
        HTTPS = 6
        SCP = 7
        CCSI = 8

    @jd.record("B")
    class DigitalResourceEndpointRec(jd.Struct):
        """One stream or file.

        server_type: ServerType or 9..200 or 201..255. Protocol for fetching it
        server_url: up to 255 characters. Where to fetch it
        jaus_id: optional. The component that the stream or file belongs to
        resource_id: optional. Number of the resource in its component, as a sensor has one
        """
        server_type: RegisterDigitalResourceEndpoint.ServerType | int = jd.field("ServerType", lambda: jd.Number("B", jd.Values(RegisterDigitalResourceEndpoint.ServerType, ((9, 200), (201, 255)))))
        server_url: str = jd.field("ServerURL", jd.Text(count=jd.Count("B", 0, 255)))
        jaus_id: environment_sensing_v1_0_types.JAUS_ID | None = jd.field("JAUS_ID", lambda: environment_sensing_v1_0_types.JAUS_ID.layout(), default=None)
        resource_id: int | None = jd.field("ResourceID", jd.Number("H"), default=None)
        reserved_presence: int = 0

    request_id_rec: RegisterDigitalResourceEndpoint.RequestIDRec = jd.field("RequestIDRec", lambda: RegisterDigitalResourceEndpoint.RequestIDRec.layout())
    digital_resource_endpoint_rec: RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec = jd.field("DigitalResourceEndpointRec", lambda: RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec.layout())


@jd.message(_SERVICE, 0x0809, command=True)
class RemoveDigitalResourceEndpoint(jd.Message):
    """RemoveDigitalResourceEndpoint (0x0809): Removes a stream or file from the list.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """
    id: int = jd.field("ID", jd.Number("B"))
    request_id: int = jd.field("RequestID", jd.Number("B"))


@jd.message(_SERVICE, 0x080A)
class ConfirmDigitalResourceEndpoint(jd.Message):
    """ConfirmDigitalResourceEndpoint (0x080A): Tells the number under which a stream or file was entered.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """
    id: int = jd.field("ID", jd.Number("B"))
    request_id: int = jd.field("RequestID", jd.Number("B"))
