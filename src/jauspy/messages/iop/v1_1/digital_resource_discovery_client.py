"""urn:jaus:jss:iop:DigitalResourceDiscoveryClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types
from jauspy.messages.iop.v1_1 import digital_resource_discovery as iop_v1_1_digital_resource_discovery


class ReportDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.ReportDigitalResourceEndpoint):
    """ReportDigitalResourceEndpoint (0xF702): Tells where streams and files are to be fetched."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


class ConfirmDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.ConfirmDigitalResourceEndpoint):
    """ConfirmDigitalResourceEndpoint (0xF703): Tells the number under which a stream or file was entered."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


class QueryDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.QueryDigitalResourceEndpoint):
    """QueryDigitalResourceEndpoint (0xE702): Asks where streams and files are to be fetched."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportDigitalResourceEndpoint]]


@dataclass(slots=True, repr=False)
class RegisterDigitalResourceEndpoint(rt.Message):
    """RegisterDigitalResourceEndpoint (0xE703): Enters a stream or file into the list.

    request_id_rec: The number of the request
    digital_resource_endpoint_rec: One stream or file
    """

    CODE = 0xE703
    NAME = "RegisterDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    DigitalResourceEndpointRec = iop_v1_0_types.DigitalResourceEndpointRec

    @dataclass(slots=True, repr=False)
    class RequestIDRec(rt.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("B")),
            )

    request_id_rec: RegisterDigitalResourceEndpoint.RequestIDRec
    digital_resource_endpoint_rec: iop_v1_0_types.DigitalResourceEndpointRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIDRec", RegisterDigitalResourceEndpoint.RequestIDRec.layout()),
            ("DigitalResourceEndpointRec", iop_v1_0_types.DigitalResourceEndpointRec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0xE7: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = RegisterDigitalResourceEndpoint.RequestIDRec(request_id_)
        at = 3
        self.digital_resource_endpoint_rec, at = iop_v1_0_types.DigitalResourceEndpointRec._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\xe7")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not RegisterDigitalResourceEndpoint.RequestIDRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        digital_resource_endpoint_rec_ = self.digital_resource_endpoint_rec
        if type(digital_resource_endpoint_rec_) is not iop_v1_0_types.DigitalResourceEndpointRec: raise rt.Reject
        digital_resource_endpoint_rec_._write(out)
        return bytes(out)


class RemoveDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.RemoveDigitalResourceEndpoint):
    """RemoveDigitalResourceEndpoint (0xE704): Removes a stream or file from the list."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


QueryDigitalResourceEndpoint.REPORT = ReportDigitalResourceEndpoint
