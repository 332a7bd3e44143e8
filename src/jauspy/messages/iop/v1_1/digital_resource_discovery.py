"""urn:jaus:jss:iop:DigitalResourceDiscovery 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:DigitalResourceDiscovery", "1.1")


@jd.message(_SERVICE, 0xF702)
class ReportDigitalResourceEndpoint(jd.Message):
    """ReportDigitalResourceEndpoint (0xF702): Tells where streams and files are to be fetched.

    digital_resource_endpoint_list: 0..255 items. The streams and files
    """
    DigitalResourceEndpointRec = iop_v1_0_types.DigitalResourceEndpointRec
    digital_resource_endpoint_list: list[iop_v1_0_types.DigitalResourceEndpointRec] = jd.field("DigitalResourceEndpointList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.DigitalResourceEndpointRec.layout()))


@jd.message(_SERVICE, 0xE702, query=True)
class QueryDigitalResourceEndpoint(jd.Message):
    """QueryDigitalResourceEndpoint (0xE702): Asks where streams and files are to be fetched."""
    REPORT = ReportDigitalResourceEndpoint


@jd.message(_SERVICE, 0xE703, query=True)
class RegisterDigitalResourceEndpoint(jd.Message):
    """RegisterDigitalResourceEndpoint (0xE703): Enters a stream or file into the list.

    request_id_rec: The number of the request
    digital_resource_endpoint_rec: One stream or file
    """
    DigitalResourceEndpointRec = iop_v1_0_types.DigitalResourceEndpointRec

    @jd.record()
    class RequestIDRec(jd.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """
        request_id: int = jd.field("RequestID", jd.Number("B"))

    request_id_rec: RegisterDigitalResourceEndpoint.RequestIDRec = jd.field("RequestIDRec", lambda: RegisterDigitalResourceEndpoint.RequestIDRec.layout())
    digital_resource_endpoint_rec: iop_v1_0_types.DigitalResourceEndpointRec = jd.field("DigitalResourceEndpointRec", lambda: iop_v1_0_types.DigitalResourceEndpointRec.layout())


@jd.message(_SERVICE, 0xE704, command=True)
class RemoveDigitalResourceEndpoint(jd.Message):
    """RemoveDigitalResourceEndpoint (0xE704): Removes a stream or file from the list.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """
    id: int = jd.field("ID", jd.Number("B"))
    request_id: int = jd.field("RequestID", jd.Number("B"))


@jd.message(_SERVICE, 0xF703)
class ConfirmDigitalResourceEndpoint(jd.Message):
    """ConfirmDigitalResourceEndpoint (0xF703): Tells the number under which a stream or file was entered.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """
    id: int = jd.field("ID", jd.Number("B"))
    request_id: int = jd.field("RequestID", jd.Number("B"))
