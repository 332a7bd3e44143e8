"""urn:jaus:jss:iop:DigitalResourceDiscovery 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types


@dataclass(slots=True, repr=False)
class QueryDigitalResourceEndpoint(rt.Message):
    """QueryDigitalResourceEndpoint (0xE702): Asks where streams and files are to be fetched."""

    CODE = 0xE702
    NAME = "QueryDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscovery"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalResourceEndpoint]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02\xe7': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xE702)


@dataclass(slots=True, repr=False)
class RegisterDigitalResourceEndpoint(rt.Message):
    """RegisterDigitalResourceEndpoint (0xE703): Enters a stream or file into the list.

    request_id_rec: The number of the request
    digital_resource_endpoint_rec: One stream or file
    """

    CODE = 0xE703
    NAME = "RegisterDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscovery"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

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


@dataclass(slots=True, repr=False)
class RemoveDigitalResourceEndpoint(rt.Message):
    """RemoveDigitalResourceEndpoint (0xE704): Removes a stream or file from the list.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """

    CODE = 0xE704
    NAME = "RemoveDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscovery"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    id: int
    request_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ID", rt.Number("B")),
            ("RequestID", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.id, self.request_id = _S_H2B.unpack(data)
        if code != 0xE704: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0xE704, self.id, self.request_id)


@dataclass(slots=True, repr=False)
class ReportDigitalResourceEndpoint(rt.Message):
    """ReportDigitalResourceEndpoint (0xF702): Tells where streams and files are to be fetched.

    digital_resource_endpoint_list: 0..255 items. The streams and files
    """

    CODE = 0xF702
    NAME = "ReportDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscovery"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    DigitalResourceEndpointRec = iop_v1_0_types.DigitalResourceEndpointRec

    digital_resource_endpoint_list: list[iop_v1_0_types.DigitalResourceEndpointRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalResourceEndpointList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.DigitalResourceEndpointRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0xF7: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        digital_resource_endpoint_list_count_ = data[2]
        if digital_resource_endpoint_list_count_ * 3 > size - 3: raise rt.Reject
        at = 3
        digital_resource_endpoint_list_ = []
        for _ in range(digital_resource_endpoint_list_count_):
            item_, at = iop_v1_0_types.DigitalResourceEndpointRec._read(data, at, nesting)
            digital_resource_endpoint_list_.append(item_)
        self.digital_resource_endpoint_list = digital_resource_endpoint_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\xf7")
        digital_resource_endpoint_list_ = self.digital_resource_endpoint_list
        if type(digital_resource_endpoint_list_) is not list: raise rt.Reject
        out.append(len(digital_resource_endpoint_list_))
        for item_ in digital_resource_endpoint_list_:
            if type(item_) is not iop_v1_0_types.DigitalResourceEndpointRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ConfirmDigitalResourceEndpoint(rt.Message):
    """ConfirmDigitalResourceEndpoint (0xF703): Tells the number under which a stream or file was entered.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """

    CODE = 0xF703
    NAME = "ConfirmDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscovery"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    id: int
    request_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ID", rt.Number("B")),
            ("RequestID", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.id, self.request_id = _S_H2B.unpack(data)
        if code != 0xF703: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0xF703, self.id, self.request_id)


_S_H = rt.Packer("<H")
_S_H2B = rt.Packer("<H2B")
QueryDigitalResourceEndpoint.REPORT = ReportDigitalResourceEndpoint
