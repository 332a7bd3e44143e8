"""urn:jaus:jss:HMI:DigitalControl 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryDCM(rt.Message):
    """QueryDCM (0x2706): Asks for the control that was used."""

    CODE = 0x2706
    NAME = "QueryDCM"
    SERVICE = "urn:jaus:jss:HMI:DigitalControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDCM]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x06'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2706)


@dataclass(slots=True, repr=False)
class SetDCM(rt.Message):
    """SetDCM (0x0706): Sets how a control looks.

    dcm_reference: Which control is meant
    dcm_state_code: How the control is to look
    """

    CODE = 0x0706
    NAME = "SetDCM"
    SERVICE = "urn:jaus:jss:HMI:DigitalControl"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class Updown(IntEnum):
        """Values of Updown."""

        RELEASED = 0
        PRESSED = 1

    class Active(IntEnum):
        """Values of Active."""

        INACTIVE = 0
        ACTIVE = 1

    class Flash(IntEnum):
        """Values of Flash."""

        STEADY = 0
        FLASHING = 1

    @dataclass(slots=True, repr=False)
    class DCMStateCode(rt.Struct):
        """How the control is to look.

        updown: bit 0. Whether it looks pressed.
        active: bit 1. Whether it can be used.
        flash: bit 2. Whether it flashes.
        flash_rate: bits 3..4. How fast it flashes, from 0 to 3.
        """

        updown: SetDCM.Updown | int
        active: SetDCM.Active | int
        flash: SetDCM.Flash | int
        flash_rate: int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "B",
                (
                    rt.Bit("updown", 0, 0x1, rt.Values(SetDCM.Updown)),
                    rt.Bit("active", 1, 0x1, rt.Values(SetDCM.Active)),
                    rt.Bit("flash", 2, 0x1, rt.Values(SetDCM.Flash)),
                    rt.Bit("flash_rate", 3, 0x3, rt.Values(None, ((0, 3),))),
                ),
            )

    dcm_reference: int
    dcm_state_code: SetDCM.DCMStateCode

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DCMReference", rt.Number("H")),
            ("DCMStateCode", SetDCM.DCMStateCode.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.dcm_reference, dcm_state_code_ = _S_2HB.unpack(data)
        if code != 0x0706: raise rt.Reject
        self.dcm_state_code = SetDCM.DCMStateCode(_E_SetDCM_Updown.get(dcm_state_code_ & 0x1, dcm_state_code_ & 0x1), _E_SetDCM_Active.get(dcm_state_code_ >> 1 & 0x1, dcm_state_code_ >> 1 & 0x1), _E_SetDCM_Flash.get(dcm_state_code_ >> 2 & 0x1, dcm_state_code_ >> 2 & 0x1), dcm_state_code_ >> 3 & 0x3, dcm_state_code_ & 0xE0)
        return self

    def _pack(self) -> bytes:
        dcm_state_code_ = self.dcm_state_code
        if type(dcm_state_code_) is not SetDCM.DCMStateCode: raise rt.Reject
        updown_ = dcm_state_code_.updown
        if not 0 <= updown_ <= 1: raise rt.Reject
        active_ = dcm_state_code_.active
        if not 0 <= active_ <= 1: raise rt.Reject
        flash_ = dcm_state_code_.flash
        if not 0 <= flash_ <= 1: raise rt.Reject
        flash_rate_ = dcm_state_code_.flash_rate
        if not 0 <= flash_rate_ <= 3: raise rt.Reject
        reserved_bits_ = dcm_state_code_.reserved_bits
        if reserved_bits_ & 0x1F: raise rt.Reject
        return _S_2HB.pack(0x0706, self.dcm_reference, updown_ | active_ << 1 | flash_ << 2 | flash_rate_ << 3 | reserved_bits_)


@dataclass(slots=True, repr=False)
class ReportDCM(rt.Message):
    """ReportDCM (0x4706): Tells that a control was pressed or released.

    dcm_reference: Which control was used
    dcm_state_code: DCMStateCode. Whether the control was pressed or released
    """

    CODE = 0x4706
    NAME = "ReportDCM"
    SERVICE = "urn:jaus:jss:HMI:DigitalControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class DCMStateCode(IntEnum):
        """Values of DCMStateCode."""

        PRESSED = 0
        RELEASED = 1

    dcm_reference: int
    dcm_state_code: ReportDCM.DCMStateCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DCMReference", rt.Number("H")),
            ("DCMStateCode", rt.Number("b", rt.Values(ReportDCM.DCMStateCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.dcm_reference, dcm_state_code_ = _S_2Hb.unpack(data)
        if code != 0x4706: raise rt.Reject
        self.dcm_state_code = _E_ReportDCM_DCMStateCode[dcm_state_code_]
        return self

    def _pack(self) -> bytes:
        dcm_state_code_ = self.dcm_state_code
        if dcm_state_code_ not in _E_ReportDCM_DCMStateCode: raise rt.Reject
        return _S_2Hb.pack(0x4706, self.dcm_reference, dcm_state_code_)


_S_H = rt.Packer("<H")
_E_SetDCM_Updown = rt.members(SetDCM.Updown)
_E_SetDCM_Active = rt.members(SetDCM.Active)
_E_SetDCM_Flash = rt.members(SetDCM.Flash)
_S_2HB = rt.Packer("<2HB")
_E_ReportDCM_DCMStateCode = rt.members(ReportDCM.DCMStateCode)
_S_2Hb = rt.Packer("<2Hb")
QueryDCM.REPORT = ReportDCM
