"""urn:jaus:jss:iop:DigitalResourceDiscoveryClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types
from jauspy.messages.iop.v1_1 import digital_resource_discovery as iop_v1_1_digital_resource_discovery

_SERVICE = jd.Service("urn:jaus:jss:iop:DigitalResourceDiscoveryClient", "1.1")

@jd.derived(_SERVICE)
class ReportDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.ReportDigitalResourceEndpoint): ...

@jd.derived(_SERVICE)
class ConfirmDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.ConfirmDigitalResourceEndpoint): ...

@jd.derived(_SERVICE)
class QueryDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.QueryDigitalResourceEndpoint):
    REPORT = ReportDigitalResourceEndpoint


@jd.message(_SERVICE, 0xE703)
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

@jd.derived(_SERVICE)
class RemoveDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.RemoveDigitalResourceEndpoint): ...
