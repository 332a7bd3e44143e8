"""urn:jaus:jss:core:Liveness 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryHeartbeatPulse(rt.Message):
    """QueryHeartbeatPulse (0x2202): Asks for a sign of life."""

    CODE: ClassVar[int] = 0x2202
    NAME: ClassVar[str] = "QueryHeartbeatPulse"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Liveness"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, = _S_H.unpack(data)
        if code != 0x2202:
            raise rt.Reject
        return cls()

    def _pack(self) -> bytes:
        return _S_H.pack(0x2202)


@dataclass(slots=True, repr=False)
class ReportHeartbeatPulse(rt.Message):
    """ReportHeartbeatPulse (0x4202): The sign of life."""

    CODE: ClassVar[int] = 0x4202
    NAME: ClassVar[str] = "ReportHeartbeatPulse"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Liveness"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, = _S_H.unpack(data)
        if code != 0x4202:
            raise rt.Reject
        return cls()

    def _pack(self) -> bytes:
        return _S_H.pack(0x4202)


_S_H = rt.Packer("<H")
