"""urn:jaus:jss:core:Liveliness 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryHeartbeatPulse(rt.Message):
    """QueryHeartbeatPulse (0x2202): Asks for a sign of life."""

    CODE = 0x2202
    NAME = "QueryHeartbeatPulse"
    SERVICE = "urn:jaus:jss:core:Liveliness"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportHeartbeatPulse]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02"': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2202)


@dataclass(slots=True, repr=False)
class ReportHeartbeatPulse(rt.Message):
    """ReportHeartbeatPulse (0x4202): The sign of life."""

    CODE = 0x4202
    NAME = "ReportHeartbeatPulse"
    SERVICE = "urn:jaus:jss:core:Liveliness"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x02B': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x4202)


_S_H = rt.Packer("<H")
QueryHeartbeatPulse.REPORT = ReportHeartbeatPulse
