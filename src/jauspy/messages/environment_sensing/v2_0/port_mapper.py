"""urn:jaus:jss:environmentSensing:PortMapper 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class CancelPortMapping(rt.Message):
    """CancelPortMapping (0x080B): Asks for a port to be closed.

    socket_type: SocketType. Transport protocol
    ip_addr: IPv4 address to be reached
    port: Port to be reached
    """

    CODE = 0x080B
    NAME = "CancelPortMapping"
    SERVICE = "urn:jaus:jss:environmentSensing:PortMapper"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class SocketType(IntEnum):
        """Values of SocketType."""

        UDP = 0
        TCP = 1

    socket_type: CancelPortMapping.SocketType | int
    ip_addr: int
    port: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SocketType", rt.Number("B", rt.Values(CancelPortMapping.SocketType))),
            ("IPAddr", rt.Number("I")),
            ("Port", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, socket_type_, self.ip_addr, self.port = _S_HBIH.unpack(data)
        if code != 0x080B: raise rt.Reject
        self.socket_type = _E_CancelPortMapping_SocketType[socket_type_]
        return self

    def _pack(self) -> bytes:
        socket_type_ = self.socket_type
        if socket_type_ not in _E_CancelPortMapping_SocketType: raise rt.Reject
        return _S_HBIH.pack(0x080B, socket_type_, self.ip_addr, self.port)


@dataclass(slots=True, repr=False)
class RequestPortMapping(rt.Message):
    """RequestPortMapping (0x080C): Asks for a port to be opened.

    socket_type: SocketType. Transport protocol
    ip_addr: IPv4 address to be reached
    port: Port to be reached
    """

    CODE = 0x080C
    NAME = "RequestPortMapping"
    SERVICE = "urn:jaus:jss:environmentSensing:PortMapper"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class SocketType(IntEnum):
        """Values of SocketType."""

        UDP = 0
        TCP = 1

    socket_type: RequestPortMapping.SocketType | int
    ip_addr: int
    port: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SocketType", rt.Number("B", rt.Values(RequestPortMapping.SocketType))),
            ("IPAddr", rt.Number("I")),
            ("Port", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, socket_type_, self.ip_addr, self.port = _S_HBIH.unpack(data)
        if code != 0x080C: raise rt.Reject
        self.socket_type = _E_RequestPortMapping_SocketType[socket_type_]
        return self

    def _pack(self) -> bytes:
        socket_type_ = self.socket_type
        if socket_type_ not in _E_RequestPortMapping_SocketType: raise rt.Reject
        return _S_HBIH.pack(0x080C, socket_type_, self.ip_addr, self.port)


@dataclass(slots=True, repr=False)
class QueryPortMappings(rt.Message):
    """QueryPortMappings (0x2815): Asks for the open ports."""

    CODE = 0x2815
    NAME = "QueryPortMappings"
    SERVICE = "urn:jaus:jss:environmentSensing:PortMapper"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPortMappings]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x15(': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2815)


@dataclass(slots=True, repr=False)
class GrantPortMapping(rt.Message):
    """GrantPortMapping (0x080E): Tells which address and port stand for the requested ones.

    request_port_mapping_rec: Address and port to be reached
    grant_port_mapping_rec: Address and port that stand for the requested ones
    """

    CODE = 0x080E
    NAME = "GrantPortMapping"
    SERVICE = "urn:jaus:jss:environmentSensing:PortMapper"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class SocketType(IntEnum):
        """Values of SocketType."""

        UDP = 0
        TCP = 1

    @dataclass(slots=True, repr=False)
    class RequestPortMappingRec(rt.Struct):
        """Address and port to be reached.

        socket_type: SocketType. Transport protocol
        ip_addr: IPv4 address to be reached
        port: Port to be reached
        """

        socket_type: GrantPortMapping.SocketType | int
        ip_addr: int
        port: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SocketType", rt.Number("B", rt.Values(GrantPortMapping.SocketType))),
                ("IPAddr", rt.Number("I")),
                ("Port", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class GrantPortMappingRec(rt.Struct):
        """Address and port that stand for the requested ones.

        ip_addr: IPv4 address that stands for the requested one
        port: Port that stands for the requested one
        """

        ip_addr: int
        port: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IPAddr", rt.Number("I")),
                ("Port", rt.Number("H")),
            )

    request_port_mapping_rec: GrantPortMapping.RequestPortMappingRec
    grant_port_mapping_rec: GrantPortMapping.GrantPortMappingRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestPortMappingRec", GrantPortMapping.RequestPortMappingRec.layout()),
            ("GrantPortMappingRec", GrantPortMapping.GrantPortMappingRec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, socket_type_, ip_addr_, port_, ip_addr_2_, port_2_ = _S_HBIHIH.unpack(data)
        if code != 0x080E: raise rt.Reject
        self.request_port_mapping_rec = GrantPortMapping.RequestPortMappingRec(_E_GrantPortMapping_SocketType[socket_type_], ip_addr_, port_)
        self.grant_port_mapping_rec = GrantPortMapping.GrantPortMappingRec(ip_addr_2_, port_2_)
        return self

    def _pack(self) -> bytes:
        request_port_mapping_rec_ = self.request_port_mapping_rec
        if type(request_port_mapping_rec_) is not GrantPortMapping.RequestPortMappingRec: raise rt.Reject
        socket_type_ = request_port_mapping_rec_.socket_type
        if socket_type_ not in _E_GrantPortMapping_SocketType: raise rt.Reject
        grant_port_mapping_rec_ = self.grant_port_mapping_rec
        if type(grant_port_mapping_rec_) is not GrantPortMapping.GrantPortMappingRec: raise rt.Reject
        return _S_HBIHIH.pack(0x080E, socket_type_, request_port_mapping_rec_.ip_addr, request_port_mapping_rec_.port, grant_port_mapping_rec_.ip_addr, grant_port_mapping_rec_.port)


@dataclass(slots=True, repr=False)
class ReportPortMappings(rt.Message):
    """ReportPortMappings (0x4815): Tells the open ports.

    request_port_mapping_rec: Address and port to be reached
    grant_port_mapping_rec: Address and port that stand for the requested ones
    """

    CODE = 0x4815
    NAME = "ReportPortMappings"
    SERVICE = "urn:jaus:jss:environmentSensing:PortMapper"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class SocketType(IntEnum):
        """Values of SocketType."""

        UDP = 0
        TCP = 1

    @dataclass(slots=True, repr=False)
    class RequestPortMappingRec(rt.Struct):
        """Address and port to be reached.

        socket_type: SocketType. Transport protocol
        ip_addr: IPv4 address to be reached
        port: Port to be reached
        """

        socket_type: ReportPortMappings.SocketType | int
        ip_addr: int
        port: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SocketType", rt.Number("B", rt.Values(ReportPortMappings.SocketType))),
                ("IPAddr", rt.Number("I")),
                ("Port", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class GrantPortMappingRec(rt.Struct):
        """Address and port that stand for the requested ones.

        ip_addr: IPv4 address that stands for the requested one
        port: Port that stands for the requested one
        """

        ip_addr: int
        port: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IPAddr", rt.Number("I")),
                ("Port", rt.Number("H")),
            )

    request_port_mapping_rec: ReportPortMappings.RequestPortMappingRec
    grant_port_mapping_rec: ReportPortMappings.GrantPortMappingRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestPortMappingRec", ReportPortMappings.RequestPortMappingRec.layout()),
            ("GrantPortMappingRec", ReportPortMappings.GrantPortMappingRec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, socket_type_, ip_addr_, port_, ip_addr_2_, port_2_ = _S_HBIHIH.unpack(data)
        if code != 0x4815: raise rt.Reject
        self.request_port_mapping_rec = ReportPortMappings.RequestPortMappingRec(_E_ReportPortMappings_SocketType[socket_type_], ip_addr_, port_)
        self.grant_port_mapping_rec = ReportPortMappings.GrantPortMappingRec(ip_addr_2_, port_2_)
        return self

    def _pack(self) -> bytes:
        request_port_mapping_rec_ = self.request_port_mapping_rec
        if type(request_port_mapping_rec_) is not ReportPortMappings.RequestPortMappingRec: raise rt.Reject
        socket_type_ = request_port_mapping_rec_.socket_type
        if socket_type_ not in _E_ReportPortMappings_SocketType: raise rt.Reject
        grant_port_mapping_rec_ = self.grant_port_mapping_rec
        if type(grant_port_mapping_rec_) is not ReportPortMappings.GrantPortMappingRec: raise rt.Reject
        return _S_HBIHIH.pack(0x4815, socket_type_, request_port_mapping_rec_.ip_addr, request_port_mapping_rec_.port, grant_port_mapping_rec_.ip_addr, grant_port_mapping_rec_.port)


_E_CancelPortMapping_SocketType = rt.members(CancelPortMapping.SocketType)
_S_HBIH = rt.Packer("<HBIH")
_E_RequestPortMapping_SocketType = rt.members(RequestPortMapping.SocketType)
_S_H = rt.Packer("<H")
_E_GrantPortMapping_SocketType = rt.members(GrantPortMapping.SocketType)
_S_HBIHIH = rt.Packer("<HBIHIH")
_E_ReportPortMappings_SocketType = rt.members(ReportPortMappings.SocketType)
QueryPortMappings.REPORT = ReportPortMappings
