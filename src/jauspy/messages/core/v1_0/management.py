"""urn:jaus:jss:core:Management 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class Shutdown(rt.Message):
    """Shutdown (0x0002): Makes the component release its resources and stop."""

    CODE = 0x0002
    NAME = "Shutdown"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02\x00': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x0002)


@dataclass(slots=True, repr=False)
class Standby(rt.Message):
    """Standby (0x0003): Moves the component from Ready to Standby."""

    CODE = 0x0003
    NAME = "Standby"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x03\x00': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x0003)


@dataclass(slots=True, repr=False)
class Resume(rt.Message):
    """Resume (0x0004): Moves the component from Standby to Ready."""

    CODE = 0x0004
    NAME = "Resume"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x04\x00': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x0004)


@dataclass(slots=True, repr=False)
class Reset(rt.Message):
    """Reset (0x0005): Makes the component initialise again."""

    CODE = 0x0005
    NAME = "Reset"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x05\x00': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x0005)


@dataclass(slots=True, repr=False)
class SetEmergency(rt.Message):
    """SetEmergency (0x0006): Puts the component into the Emergency state; needs no control.

    emergency_code: EmergencyCode. The kind of emergency
    """

    CODE = 0x0006
    NAME = "SetEmergency"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class EmergencyCode(IntEnum):
        """Values of EmergencyCode."""

        STOP = 1

    emergency_code: SetEmergency.EmergencyCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EmergencyCode", rt.Number("H", rt.Values(SetEmergency.EmergencyCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, emergency_code_ = _S_2H.unpack(data)
        if code != 0x0006: raise rt.Reject
        self.emergency_code = _E_SetEmergency_EmergencyCode[emergency_code_]
        return self

    def _pack(self) -> bytes:
        emergency_code_ = self.emergency_code
        if emergency_code_ not in _E_SetEmergency_EmergencyCode: raise rt.Reject
        return _S_2H.pack(0x0006, emergency_code_)


@dataclass(slots=True, repr=False)
class ClearEmergency(rt.Message):
    """ClearEmergency (0x0007): Ends the emergency that the same client has set.

    emergency_code: EmergencyCode. The kind of emergency
    """

    CODE = 0x0007
    NAME = "ClearEmergency"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class EmergencyCode(IntEnum):
        """Values of EmergencyCode."""

        STOP = 1

    emergency_code: ClearEmergency.EmergencyCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EmergencyCode", rt.Number("H", rt.Values(ClearEmergency.EmergencyCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, emergency_code_ = _S_2H.unpack(data)
        if code != 0x0007: raise rt.Reject
        self.emergency_code = _E_ClearEmergency_EmergencyCode[emergency_code_]
        return self

    def _pack(self) -> bytes:
        emergency_code_ = self.emergency_code
        if emergency_code_ not in _E_ClearEmergency_EmergencyCode: raise rt.Reject
        return _S_2H.pack(0x0007, emergency_code_)


@dataclass(slots=True, repr=False)
class QueryStatus(rt.Message):
    """QueryStatus (0x2002): Asks for the state of the component."""

    CODE = 0x2002
    NAME = "QueryStatus"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStatus]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02 ': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2002)


@dataclass(slots=True, repr=False)
class ReportStatus(rt.Message):
    """ReportStatus (0x4002): Tells the state of the component.

    status: Status. The state of the component
    reserved: Sent as 0, ignored when received
    """

    CODE = 0x4002
    NAME = "ReportStatus"
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Status(IntEnum):
        """Values of Status."""

        INITIALIZE = 0
        READY = 1
        STANDBY = 2
        SHUTDOWN = 3
        FAILURE = 4
        EMERGENCY = 5

    status: ReportStatus.Status | int
    reserved: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Status", rt.Number("B", rt.Values(ReportStatus.Status))),
            ("Reserved", rt.Number("I")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, status_, self.reserved = _S_HBI.unpack(data)
        if code != 0x4002: raise rt.Reject
        self.status = _E_ReportStatus_Status[status_]
        return self

    def _pack(self) -> bytes:
        status_ = self.status
        if status_ not in _E_ReportStatus_Status: raise rt.Reject
        return _S_HBI.pack(0x4002, status_, self.reserved)


_S_H = rt.Packer("<H")
_E_SetEmergency_EmergencyCode = rt.members(SetEmergency.EmergencyCode)
_S_2H = rt.Packer("<2H")
_E_ClearEmergency_EmergencyCode = rt.members(ClearEmergency.EmergencyCode)
_E_ReportStatus_Status = rt.members(ReportStatus.Status)
_S_HBI = rt.Packer("<HBI")
QueryStatus.REPORT = ReportStatus
