"""urn:jaus:jss:iop:PlatformMode 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetPlatformMode(rt.Message):
    """SetPlatformMode (0xFF20): Sets the mode.

    platform_mode: PlatformMode or 175..255. The mode
    """

    CODE = 0xFF20
    NAME = "SetPlatformMode"
    SERVICE = "urn:jaus:jss:iop:PlatformMode"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class PlatformMode(IntEnum):
        """Values of PlatformMode."""

        STANDARD_OPERATING = 0
        TRAINING = 1
        MAINTENANCE = 2

    platform_mode: SetPlatformMode.PlatformMode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PlatformMode", rt.Number("B", rt.Values(SetPlatformMode.PlatformMode, ((175, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, platform_mode_ = _S_HB.unpack(data)
        if code != 0xFF20: raise rt.Reject
        if platform_mode_ not in _E_SetPlatformMode_PlatformMode and platform_mode_ < 175: raise rt.Reject
        self.platform_mode = _E_SetPlatformMode_PlatformMode.get(platform_mode_, platform_mode_)
        return self

    def _pack(self) -> bytes:
        platform_mode_ = self.platform_mode
        if platform_mode_ not in _E_SetPlatformMode_PlatformMode and not 175 <= platform_mode_ <= 255: raise rt.Reject
        return _S_HB.pack(0xFF20, platform_mode_)


@dataclass(slots=True, repr=False)
class QueryPlatformMode(rt.Message):
    """QueryPlatformMode (0xFF21): Asks for the mode."""

    CODE = 0xFF21
    NAME = "QueryPlatformMode"
    SERVICE = "urn:jaus:jss:iop:PlatformMode"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPlatformMode]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'!\xff': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xFF21)


@dataclass(slots=True, repr=False)
class QuerySupportedPlatformModes(rt.Message):
    """QuerySupportedPlatformModes (0xFF22): Asks which modes there are."""

    CODE = 0xFF22
    NAME = "QuerySupportedPlatformModes"
    SERVICE = "urn:jaus:jss:iop:PlatformMode"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportSupportedPlatformModes]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'"\xff': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xFF22)


@dataclass(slots=True, repr=False)
class ReportPlatformMode(rt.Message):
    """ReportPlatformMode (0xFF23): Tells the mode and whether it is changing.

    platform_mode: PlatformMode. The mode
    status: Status. Whether the mode is being entered, active or being left
    """

    CODE = 0xFF23
    NAME = "ReportPlatformMode"
    SERVICE = "urn:jaus:jss:iop:PlatformMode"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class PlatformMode(IntEnum):
        """Values of PlatformMode."""

        STANDARD_OPERATING = 0
        TRAINING = 1
        MAINTENANCE = 2

    class Status(IntEnum):
        """Values of Status."""

        INITIALIZING = 0
        ACTIVE = 1
        EXITING = 2

    platform_mode: ReportPlatformMode.PlatformMode | int
    status: ReportPlatformMode.Status | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PlatformMode", rt.Number("B", rt.Values(ReportPlatformMode.PlatformMode))),
            ("Status", rt.Number("B", rt.Values(ReportPlatformMode.Status))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, platform_mode_, status_ = _S_H2B.unpack(data)
        if code != 0xFF23: raise rt.Reject
        self.platform_mode = _E_ReportPlatformMode_PlatformMode[platform_mode_]
        self.status = _E_ReportPlatformMode_Status[status_]
        return self

    def _pack(self) -> bytes:
        platform_mode_ = self.platform_mode
        if platform_mode_ not in _E_ReportPlatformMode_PlatformMode: raise rt.Reject
        status_ = self.status
        if status_ not in _E_ReportPlatformMode_Status: raise rt.Reject
        return _S_H2B.pack(0xFF23, platform_mode_, status_)


@dataclass(slots=True, repr=False)
class ReportSupportedPlatformModes(rt.Message):
    """ReportSupportedPlatformModes (0xFF24): Tells which modes there are.

    supported_platform_modes_list: 0..255 items. The modes
    """

    CODE = 0xFF24
    NAME = "ReportSupportedPlatformModes"
    SERVICE = "urn:jaus:jss:iop:PlatformMode"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class PlatformMode(IntEnum):
        """Values of PlatformMode."""

        STANDARD_OPERATING = 0
        TRAINING = 1
        MAINTENANCE = 2

    @dataclass(slots=True, repr=False)
    class PlatformModeRec(rt.Struct):
        """One mode.

        platform_mode: PlatformMode or 175..255. The mode
        """

        platform_mode: ReportSupportedPlatformModes.PlatformMode | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PlatformMode", rt.Number("B", rt.Values(ReportSupportedPlatformModes.PlatformMode, ((175, 255),)))),
            )

    supported_platform_modes_list: list[ReportSupportedPlatformModes.PlatformModeRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SupportedPlatformModesList", rt.Repeat(rt.Count("B", 0, 255), ReportSupportedPlatformModes.PlatformModeRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x24 or data[1] != 0xFF: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        supported_platform_modes_list_count_ = data[2]
        supported_platform_modes_list_end_ = 3 + supported_platform_modes_list_count_ * 1
        supported_platform_modes_list_ = []
        for platform_mode_ in _L_B[supported_platform_modes_list_count_].unpack_from(data, 3):
            if platform_mode_ not in _E_ReportSupportedPlatformModes_PlatformMode and platform_mode_ < 175: raise rt.Reject
            supported_platform_modes_list_.append(ReportSupportedPlatformModes.PlatformModeRec(_E_ReportSupportedPlatformModes_PlatformMode.get(platform_mode_, platform_mode_)))
        self.supported_platform_modes_list = supported_platform_modes_list_
        if supported_platform_modes_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x24\xff")
        supported_platform_modes_list_ = self.supported_platform_modes_list
        if type(supported_platform_modes_list_) is not list: raise rt.Reject
        out.append(len(supported_platform_modes_list_))
        raw_: list[int | float] = []
        for item_ in supported_platform_modes_list_:
            if type(item_) is not ReportSupportedPlatformModes.PlatformModeRec: raise rt.Reject
            platform_mode_ = item_.platform_mode
            if platform_mode_ not in _E_ReportSupportedPlatformModes_PlatformMode and not 175 <= platform_mode_ <= 255: raise rt.Reject
            raw_.append(platform_mode_)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


_E_SetPlatformMode_PlatformMode = rt.members(SetPlatformMode.PlatformMode)
_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_E_ReportPlatformMode_PlatformMode = rt.members(ReportPlatformMode.PlatformMode)
_E_ReportPlatformMode_Status = rt.members(ReportPlatformMode.Status)
_S_H2B = rt.Packer("<H2B")
_E_ReportSupportedPlatformModes_PlatformMode = rt.members(ReportSupportedPlatformModes.PlatformMode)
_L_B = rt.Rows("B")
QueryPlatformMode.REPORT = ReportPlatformMode
QuerySupportedPlatformModes.REPORT = ReportSupportedPlatformModes
