"""urn:jaus:jss:environmentSensing:DigitalResourceDiscovery 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@dataclass(slots=True, repr=False)
class QueryDigitalResourceEndpoint(rt.Message):
    """QueryDigitalResourceEndpoint (0x2816): Asks where streams and files are to be fetched."""

    CODE = 0x2816
    NAME = "QueryDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalResourceEndpoint]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x16(': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2816)


@dataclass(slots=True, repr=False)
class RegisterDigitalResourceEndpoint(rt.Message):
    """RegisterDigitalResourceEndpoint (0x0808): Enters a stream or file into the list.

    request_id_rec: The number of the request
    digital_resource_endpoint_rec: One stream or file
    """

    CODE = 0x0808
    NAME = "RegisterDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    JAUS_ID = environment_sensing_v1_0_types.JAUS_ID

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

    class ServerType(IntEnum):
        """Values of ServerType."""

        RTSP = 0
        MPEG2_TS = 1
        FTP = 2
        SFTP = 3
        FTP_OVER_SSH = 4
        HTTP = 5
        HTTPS = 6
        SCP = 7
        CCSI = 8

    @dataclass(slots=True, repr=False)
    class DigitalResourceEndpointRec(rt.Struct):
        """One stream or file.

        server_type: ServerType or 9..200 or 201..255. Protocol for fetching it
        server_url: up to 255 characters. Where to fetch it
        jaus_id: optional. The component that the stream or file belongs to
        resource_id: optional. Number of the resource in its component, as a sensor has one
        """

        server_type: RegisterDigitalResourceEndpoint.ServerType | int
        server_url: str
        jaus_id: environment_sensing_v1_0_types.JAUS_ID | None = None
        resource_id: int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("ServerType", rt.Number("B", rt.Values(RegisterDigitalResourceEndpoint.ServerType, ((9, 200), (201, 255))))),
                ("ServerURL", rt.Text(count=rt.Count("B", 0, 255))),
                ("JAUS_ID", environment_sensing_v1_0_types.JAUS_ID.layout(), True),
                ("ResourceID", rt.Number("H"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            server_type_ = data[at + 1]
            self.server_type = _E_RegisterDigitalResourceEndpoint_ServerType.get(server_type_, server_type_)
            server_url_end_ = at + 3 + data[at + 2]
            self.server_url = data[at + 3:server_url_end_].decode("latin-1")
            packer = _M_RegisterDigitalResourceEndpoint_DigitalResourceEndpointRec_2[mask & 0x3]
            raw = iter(packer.unpack_from(data, server_url_end_)).__next__
            at = server_url_end_ + packer.size
            if mask & 1:
                jaus_id_ = raw()
                self.jaus_id = environment_sensing_v1_0_types.JAUS_ID(jaus_id_ & 0xFF, jaus_id_ >> 8 & 0xFF, jaus_id_ >> 16 & 0xFFFF)
            else: self.jaus_id = None
            self.resource_id = raw() if mask & 2 else None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            out.append(self.server_type)
            server_url_raw_ = self.server_url.encode("latin-1")
            out.append(len(server_url_raw_))
            out += server_url_raw_
            raw: list[int | float | bytes] = []
            jaus_id_ = self.jaus_id
            if jaus_id_ is not None:
                mask |= 1
                if type(jaus_id_) is not environment_sensing_v1_0_types.JAUS_ID: raise rt.Reject
                component_id_ = jaus_id_.component_id
                if not 0 <= component_id_ <= 255: raise rt.Reject
                node_id_ = jaus_id_.node_id
                if not 0 <= node_id_ <= 255: raise rt.Reject
                subsystem_id_ = jaus_id_.subsystem_id
                if not 0 <= subsystem_id_ <= 65535: raise rt.Reject
                raw.append(component_id_ | node_id_ << 8 | subsystem_id_ << 16)
            resource_id_ = self.resource_id
            if resource_id_ is not None:
                mask |= 2
                raw.append(resource_id_)
            out += _M_RegisterDigitalResourceEndpoint_DigitalResourceEndpointRec_2[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    request_id_rec: RegisterDigitalResourceEndpoint.RequestIDRec
    digital_resource_endpoint_rec: RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIDRec", RegisterDigitalResourceEndpoint.RequestIDRec.layout()),
            ("DigitalResourceEndpointRec", RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x08 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = RegisterDigitalResourceEndpoint.RequestIDRec(request_id_)
        at = 3
        self.digital_resource_endpoint_rec, at = RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x08\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not RegisterDigitalResourceEndpoint.RequestIDRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        digital_resource_endpoint_rec_ = self.digital_resource_endpoint_rec
        if type(digital_resource_endpoint_rec_) is not RegisterDigitalResourceEndpoint.DigitalResourceEndpointRec: raise rt.Reject
        digital_resource_endpoint_rec_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class RemoveDigitalResourceEndpoint(rt.Message):
    """RemoveDigitalResourceEndpoint (0x0809): Removes a stream or file from the list.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """

    CODE = 0x0809
    NAME = "RemoveDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"
    VERSION = "2.0"
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
        if code != 0x0809: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0x0809, self.id, self.request_id)


@dataclass(slots=True, repr=False)
class ReportDigitalResourceEndpoint(rt.Message):
    """ReportDigitalResourceEndpoint (0x4816): Tells where streams and files are to be fetched.

    digital_resource_endpoint_list: 0..255 items. The streams and files
    """

    CODE = 0x4816
    NAME = "ReportDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    JAUS_ID = environment_sensing_v1_0_types.JAUS_ID

    class ServerType(IntEnum):
        """Values of ServerType."""

        RTSP = 0
        MPEG2_TS = 1
        FTP = 2
        SFTP = 3
        FTP_OVER_SSH = 4
        HTTP = 5
        HTTPS = 6
        SCP = 7
        CCSI = 8

    @dataclass(slots=True, repr=False)
    class DigitalResourceEndpointRec(rt.Struct):
        """One stream or file.

        server_type: ServerType or 9..200 or 201..255. Protocol for fetching it
        server_url: up to 255 characters. Where to fetch it
        jaus_id: optional. The component that the stream or file belongs to
        resource_id: optional. Number of the resource in its component, as a sensor has one
        """

        server_type: ReportDigitalResourceEndpoint.ServerType | int
        server_url: str
        jaus_id: environment_sensing_v1_0_types.JAUS_ID | None = None
        resource_id: int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("ServerType", rt.Number("B", rt.Values(ReportDigitalResourceEndpoint.ServerType, ((9, 200), (201, 255))))),
                ("ServerURL", rt.Text(count=rt.Count("B", 0, 255))),
                ("JAUS_ID", environment_sensing_v1_0_types.JAUS_ID.layout(), True),
                ("ResourceID", rt.Number("H"), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            server_type_ = data[at + 1]
            self.server_type = _E_ReportDigitalResourceEndpoint_ServerType.get(server_type_, server_type_)
            server_url_end_ = at + 3 + data[at + 2]
            self.server_url = data[at + 3:server_url_end_].decode("latin-1")
            packer = _M_RegisterDigitalResourceEndpoint_DigitalResourceEndpointRec_2[mask & 0x3]
            raw = iter(packer.unpack_from(data, server_url_end_)).__next__
            at = server_url_end_ + packer.size
            if mask & 1:
                jaus_id_ = raw()
                self.jaus_id = environment_sensing_v1_0_types.JAUS_ID(jaus_id_ & 0xFF, jaus_id_ >> 8 & 0xFF, jaus_id_ >> 16 & 0xFFFF)
            else: self.jaus_id = None
            self.resource_id = raw() if mask & 2 else None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            out.append(self.server_type)
            server_url_raw_ = self.server_url.encode("latin-1")
            out.append(len(server_url_raw_))
            out += server_url_raw_
            raw: list[int | float | bytes] = []
            jaus_id_ = self.jaus_id
            if jaus_id_ is not None:
                mask |= 1
                if type(jaus_id_) is not environment_sensing_v1_0_types.JAUS_ID: raise rt.Reject
                component_id_ = jaus_id_.component_id
                if not 0 <= component_id_ <= 255: raise rt.Reject
                node_id_ = jaus_id_.node_id
                if not 0 <= node_id_ <= 255: raise rt.Reject
                subsystem_id_ = jaus_id_.subsystem_id
                if not 0 <= subsystem_id_ <= 65535: raise rt.Reject
                raw.append(component_id_ | node_id_ << 8 | subsystem_id_ << 16)
            resource_id_ = self.resource_id
            if resource_id_ is not None:
                mask |= 2
                raw.append(resource_id_)
            out += _M_RegisterDigitalResourceEndpoint_DigitalResourceEndpointRec_2[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    digital_resource_endpoint_list: list[ReportDigitalResourceEndpoint.DigitalResourceEndpointRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalResourceEndpointList", rt.Repeat(rt.Count("B", 0, 255), ReportDigitalResourceEndpoint.DigitalResourceEndpointRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x16 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        digital_resource_endpoint_list_count_ = data[2]
        if digital_resource_endpoint_list_count_ * 3 > size - 3: raise rt.Reject
        at = 3
        digital_resource_endpoint_list_ = []
        for _ in range(digital_resource_endpoint_list_count_):
            item_, at = ReportDigitalResourceEndpoint.DigitalResourceEndpointRec._read(data, at, nesting)
            digital_resource_endpoint_list_.append(item_)
        self.digital_resource_endpoint_list = digital_resource_endpoint_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x16\x48")
        digital_resource_endpoint_list_ = self.digital_resource_endpoint_list
        if type(digital_resource_endpoint_list_) is not list: raise rt.Reject
        out.append(len(digital_resource_endpoint_list_))
        for item_ in digital_resource_endpoint_list_:
            if type(item_) is not ReportDigitalResourceEndpoint.DigitalResourceEndpointRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ConfirmDigitalResourceEndpoint(rt.Message):
    """ConfirmDigitalResourceEndpoint (0x080A): Tells the number under which a stream or file was entered.

    id: Number under which the stream or file was entered
    request_id: Repeated in the answer, to match it with its request
    """

    CODE = 0x080A
    NAME = "ConfirmDigitalResourceEndpoint"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalResourceDiscovery"
    VERSION = "2.0"
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
        if code != 0x080A: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0x080A, self.id, self.request_id)


_S_H = rt.Packer("<H")
_E_RegisterDigitalResourceEndpoint_ServerType = rt.members(RegisterDigitalResourceEndpoint.ServerType)
_M_RegisterDigitalResourceEndpoint_DigitalResourceEndpointRec_2 = rt.Masks("", ((1, "I"), (2, "H")))
_S_B = rt.Packer("<B")
_S_H2B = rt.Packer("<H2B")
_E_ReportDigitalResourceEndpoint_ServerType = rt.members(ReportDigitalResourceEndpoint.ServerType)
QueryDigitalResourceEndpoint.REPORT = ReportDigitalResourceEndpoint
