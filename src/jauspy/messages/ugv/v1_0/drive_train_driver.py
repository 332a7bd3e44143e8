"""urn:jaus:jss:ugv:DriveTrainDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SetTransmissionState(rt.Message):
    """SetTransmissionState (0x0509): Sets the gear.

    transmission_state: TransmissionState. Gear to engage
    """

    CODE = 0x0509
    NAME = "SetTransmissionState"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class TransmissionState(IntEnum):
        """Values of TransmissionState."""

        DEFAULT = 0
        PARK = 1
        NEUTRAL = 2
        REVERSE = 3
        DRIVE = 4
        OVERDRIVE = 5
        L1 = 6
        L2 = 7
        L3 = 8
        L4 = 9
        L5 = 10
        L6 = 11
        L7 = 12
        L8 = 13
        L9 = 14
        L10 = 15

    transmission_state: SetTransmissionState.TransmissionState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("TransmissionState", rt.Number("B", rt.Values(SetTransmissionState.TransmissionState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, transmission_state_ = _S_HB.unpack(data)
        if code != 0x0509: raise rt.Reject
        self.transmission_state = _E_SetTransmissionState_TransmissionState[transmission_state_]
        return self

    def _pack(self) -> bytes:
        transmission_state_ = self.transmission_state
        if transmission_state_ not in _E_SetTransmissionState_TransmissionState: raise rt.Reject
        return _S_HB.pack(0x0509, transmission_state_)


@dataclass(slots=True, repr=False)
class QueryTransmissionState(rt.Message):
    """QueryTransmissionState (0x2509): Asks for the gear."""

    CODE = 0x2509
    NAME = "QueryTransmissionState"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTransmissionState]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\t%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2509)


@dataclass(slots=True, repr=False)
class SetTransferCaseState(rt.Message):
    """SetTransferCaseState (0x0510): Sets which wheels are driven.

    transfer_case_state: TransferCaseState. Which wheels are driven, and how
    """

    CODE = 0x0510
    NAME = "SetTransferCaseState"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class TransferCaseState(IntEnum):
        """Values of TransferCaseState."""

        DEFAULT = 0
        FWD = 1
        AUTO_4_WD = 2
        MANUAL_LOW_4_WD = 3
        MANUAL_HIGH_4_WD = 4
        LOW_AWD = 5
        HIGH_AWD = 6

    transfer_case_state: SetTransferCaseState.TransferCaseState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("TransferCaseState", rt.Number("B", rt.Values(SetTransferCaseState.TransferCaseState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, transfer_case_state_ = _S_HB.unpack(data)
        if code != 0x0510: raise rt.Reject
        self.transfer_case_state = _E_SetTransferCaseState_TransferCaseState[transfer_case_state_]
        return self

    def _pack(self) -> bytes:
        transfer_case_state_ = self.transfer_case_state
        if transfer_case_state_ not in _E_SetTransferCaseState_TransferCaseState: raise rt.Reject
        return _S_HB.pack(0x0510, transfer_case_state_)


@dataclass(slots=True, repr=False)
class QueryTransferCaseState(rt.Message):
    """QueryTransferCaseState (0x2510): Asks which wheels are driven."""

    CODE = 0x2510
    NAME = "QueryTransferCaseState"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTransferCaseState]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x10%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2510)


@dataclass(slots=True, repr=False)
class QueryTransmissionCapabilities(rt.Message):
    """QueryTransmissionCapabilities (0x2511): Asks which gears there are."""

    CODE = 0x2511
    NAME = "QueryTransmissionCapabilities"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTransmissionCapabilities]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x11%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2511)


@dataclass(slots=True, repr=False)
class ReportTransmissionState(rt.Message):
    """ReportTransmissionState (0x4509): Tells the commanded and the engaged gear.

    requested_transmission_state: RequestedTransmissionState. Gear that was commanded
    actual_transmission_state: ActualTransmissionState. Gear that is engaged
    """

    CODE = 0x4509
    NAME = "ReportTransmissionState"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class RequestedTransmissionState(IntEnum):
        """Values of RequestedTransmissionState."""

        DEFAULT = 0
        PARK = 1
        NEUTRAL = 2
        REVERSE = 3
        DRIVE = 4
        OVERDRIVE = 5
        L1 = 6
        L2 = 7
        L3 = 8
        L4 = 9
        L5 = 10
        L6 = 11
        L7 = 12
        L8 = 13
        L9 = 14
        L10 = 15

    class ActualTransmissionState(IntEnum):
        """Values of ActualTransmissionState."""

        DEFAULT = 0
        PARK = 1
        NEUTRAL = 2
        REVERSE = 3
        DRIVE = 4
        OVERDRIVE = 5
        L1 = 6
        L2 = 7
        L3 = 8
        L4 = 9
        L5 = 10
        L6 = 11
        L7 = 12
        L8 = 13
        L9 = 14
        L10 = 15

    requested_transmission_state: ReportTransmissionState.RequestedTransmissionState | int
    actual_transmission_state: ReportTransmissionState.ActualTransmissionState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestedTransmissionState", rt.Number("B", rt.Values(ReportTransmissionState.RequestedTransmissionState))),
            ("ActualTransmissionState", rt.Number("B", rt.Values(ReportTransmissionState.ActualTransmissionState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, requested_transmission_state_, actual_transmission_state_ = _S_H2B.unpack(data)
        if code != 0x4509: raise rt.Reject
        self.requested_transmission_state = _E_ReportTransmissionState_RequestedTransmissionState[requested_transmission_state_]
        self.actual_transmission_state = _E_ReportTransmissionState_ActualTransmissionState[actual_transmission_state_]
        return self

    def _pack(self) -> bytes:
        requested_transmission_state_ = self.requested_transmission_state
        if requested_transmission_state_ not in _E_ReportTransmissionState_RequestedTransmissionState: raise rt.Reject
        actual_transmission_state_ = self.actual_transmission_state
        if actual_transmission_state_ not in _E_ReportTransmissionState_ActualTransmissionState: raise rt.Reject
        return _S_H2B.pack(0x4509, requested_transmission_state_, actual_transmission_state_)


@dataclass(slots=True, repr=False)
class ReportTransferCaseState(rt.Message):
    """ReportTransferCaseState (0x4510): Tells which wheels are driven.

    transfer_case_state: TransferCaseState. Which wheels are driven, and how
    """

    CODE = 0x4510
    NAME = "ReportTransferCaseState"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class TransferCaseState(IntEnum):
        """Values of TransferCaseState."""

        DEFAULT = 0
        FWD = 1
        AUTO_4_WD = 2
        MANUAL_LOW_4_WD = 3
        MANUAL_HIGH_4_WD = 4
        LOW_AWD = 5
        HIGH_AWD = 6

    transfer_case_state: ReportTransferCaseState.TransferCaseState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("TransferCaseState", rt.Number("B", rt.Values(ReportTransferCaseState.TransferCaseState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, transfer_case_state_ = _S_HB.unpack(data)
        if code != 0x4510: raise rt.Reject
        self.transfer_case_state = _E_ReportTransferCaseState_TransferCaseState[transfer_case_state_]
        return self

    def _pack(self) -> bytes:
        transfer_case_state_ = self.transfer_case_state
        if transfer_case_state_ not in _E_ReportTransferCaseState_TransferCaseState: raise rt.Reject
        return _S_HB.pack(0x4510, transfer_case_state_)


@dataclass(slots=True, repr=False)
class ReportTransmissionCapabilities(rt.Message):
    """ReportTransmissionCapabilities (0x4511): Tells which gears and drives there are.

    transmission_bf: Gears that the platform has
    transfer_case_bf: Drives that the platform has
    """

    CODE = 0x4511
    NAME = "ReportTransmissionCapabilities"
    SERVICE = "urn:jaus:jss:ugv:DriveTrainDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class PARK(IntEnum):
        """Values of PARK."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class NEUTRAL(IntEnum):
        """Values of NEUTRAL."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class REVERSE(IntEnum):
        """Values of REVERSE."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class DRIVE(IntEnum):
        """Values of DRIVE."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class OVERDRIVE(IntEnum):
        """Values of OVERDRIVE."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L1(IntEnum):
        """Values of L1."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L2(IntEnum):
        """Values of L2."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L3(IntEnum):
        """Values of L3."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L4(IntEnum):
        """Values of L4."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L5(IntEnum):
        """Values of L5."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L6(IntEnum):
        """Values of L6."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L7(IntEnum):
        """Values of L7."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L8(IntEnum):
        """Values of L8."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L9(IntEnum):
        """Values of L9."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class L10(IntEnum):
        """Values of L10."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Reserved(IntEnum):
        """Values of Reserved."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class TransmissionBF(rt.Struct):
        """Gears that the platform has.

        park: bit 0. Park.
        neutral: bit 1. Neutral.
        reverse: bit 2. Reverse.
        drive: bit 3. Drive.
        overdrive: bit 4. Overdrive.
        l1: bit 5. Forward gear 1.
        l2: bit 6. Forward gear 2.
        l3: bit 7. Forward gear 3.
        l4: bit 8. Forward gear 4.
        l5: bit 9. Forward gear 5.
        l6: bit 10. Forward gear 6.
        l7: bit 11. Forward gear 7.
        l8: bit 12. Forward gear 8.
        l9: bit 13. Forward gear 9.
        l10: bit 14. Forward gear 10.
        reserved: bit 15. Sent as 0, ignored when received.
        """

        park: ReportTransmissionCapabilities.PARK | int
        neutral: ReportTransmissionCapabilities.NEUTRAL | int
        reverse: ReportTransmissionCapabilities.REVERSE | int
        drive: ReportTransmissionCapabilities.DRIVE | int
        overdrive: ReportTransmissionCapabilities.OVERDRIVE | int
        l1: ReportTransmissionCapabilities.L1 | int
        l2: ReportTransmissionCapabilities.L2 | int
        l3: ReportTransmissionCapabilities.L3 | int
        l4: ReportTransmissionCapabilities.L4 | int
        l5: ReportTransmissionCapabilities.L5 | int
        l6: ReportTransmissionCapabilities.L6 | int
        l7: ReportTransmissionCapabilities.L7 | int
        l8: ReportTransmissionCapabilities.L8 | int
        l9: ReportTransmissionCapabilities.L9 | int
        l10: ReportTransmissionCapabilities.L10 | int
        reserved: ReportTransmissionCapabilities.Reserved | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "H",
                (
                    rt.Bit("park", 0, 0x1, rt.Values(ReportTransmissionCapabilities.PARK)),
                    rt.Bit("neutral", 1, 0x1, rt.Values(ReportTransmissionCapabilities.NEUTRAL)),
                    rt.Bit("reverse", 2, 0x1, rt.Values(ReportTransmissionCapabilities.REVERSE)),
                    rt.Bit("drive", 3, 0x1, rt.Values(ReportTransmissionCapabilities.DRIVE)),
                    rt.Bit("overdrive", 4, 0x1, rt.Values(ReportTransmissionCapabilities.OVERDRIVE)),
                    rt.Bit("l1", 5, 0x1, rt.Values(ReportTransmissionCapabilities.L1)),
                    rt.Bit("l2", 6, 0x1, rt.Values(ReportTransmissionCapabilities.L2)),
                    rt.Bit("l3", 7, 0x1, rt.Values(ReportTransmissionCapabilities.L3)),
                    rt.Bit("l4", 8, 0x1, rt.Values(ReportTransmissionCapabilities.L4)),
                    rt.Bit("l5", 9, 0x1, rt.Values(ReportTransmissionCapabilities.L5)),
                    rt.Bit("l6", 10, 0x1, rt.Values(ReportTransmissionCapabilities.L6)),
                    rt.Bit("l7", 11, 0x1, rt.Values(ReportTransmissionCapabilities.L7)),
                    rt.Bit("l8", 12, 0x1, rt.Values(ReportTransmissionCapabilities.L8)),
                    rt.Bit("l9", 13, 0x1, rt.Values(ReportTransmissionCapabilities.L9)),
                    rt.Bit("l10", 14, 0x1, rt.Values(ReportTransmissionCapabilities.L10)),
                    rt.Bit("reserved", 15, 0x1, rt.Values(ReportTransmissionCapabilities.Reserved)),
                ),
            )

    class FWD(IntEnum):
        """Values of FWD."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class AUTO_4WD(IntEnum):
        """Values of AUTO_4WD."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class MANUAL_LOW_4WD(IntEnum):
        """Values of MANUAL_LOW_4WD."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class MANUAL_HIGH_4WD(IntEnum):
        """Values of MANUAL_HIGH_4WD."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class LOW_AWD(IntEnum):
        """Values of LOW_AWD."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class HIGH_AWD(IntEnum):
        """Values of HIGH_AWD."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Reserved_For_Future_Use(IntEnum):
        """Values of Reserved_For_Future_Use."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Reserved_For_User_Defined_Use(IntEnum):
        """Values of Reserved_For_User_Defined_Use."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class TransferCaseBF(rt.Struct):
        """Drives that the platform has.

        fwd: bit 0. Front wheels.
        auto_4_wd: bit 1. Four wheels when needed.
        manual_low_4_wd: bit 2. Four wheels, low range.
        manual_high_4_wd: bit 3. Four wheels, high range.
        low_awd: bit 4. All wheels, low range.
        high_awd: bit 5. All wheels, high range.
        reserved_for_future_use: bit 6. Sent as 0, ignored when received.
        reserved_for_user_defined_use: bit 7. Of meaning to the maker alone.
        """

        fwd: ReportTransmissionCapabilities.FWD | int
        auto_4_wd: ReportTransmissionCapabilities.AUTO_4WD | int
        manual_low_4_wd: ReportTransmissionCapabilities.MANUAL_LOW_4WD | int
        manual_high_4_wd: ReportTransmissionCapabilities.MANUAL_HIGH_4WD | int
        low_awd: ReportTransmissionCapabilities.LOW_AWD | int
        high_awd: ReportTransmissionCapabilities.HIGH_AWD | int
        reserved_for_future_use: ReportTransmissionCapabilities.Reserved_For_Future_Use | int
        reserved_for_user_defined_use: ReportTransmissionCapabilities.Reserved_For_User_Defined_Use | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "B",
                (
                    rt.Bit("fwd", 0, 0x1, rt.Values(ReportTransmissionCapabilities.FWD)),
                    rt.Bit("auto_4_wd", 1, 0x1, rt.Values(ReportTransmissionCapabilities.AUTO_4WD)),
                    rt.Bit("manual_low_4_wd", 2, 0x1, rt.Values(ReportTransmissionCapabilities.MANUAL_LOW_4WD)),
                    rt.Bit("manual_high_4_wd", 3, 0x1, rt.Values(ReportTransmissionCapabilities.MANUAL_HIGH_4WD)),
                    rt.Bit("low_awd", 4, 0x1, rt.Values(ReportTransmissionCapabilities.LOW_AWD)),
                    rt.Bit("high_awd", 5, 0x1, rt.Values(ReportTransmissionCapabilities.HIGH_AWD)),
                    rt.Bit("reserved_for_future_use", 6, 0x1, rt.Values(ReportTransmissionCapabilities.Reserved_For_Future_Use)),
                    rt.Bit("reserved_for_user_defined_use", 7, 0x1, rt.Values(ReportTransmissionCapabilities.Reserved_For_User_Defined_Use)),
                ),
            )

    transmission_bf: ReportTransmissionCapabilities.TransmissionBF
    transfer_case_bf: ReportTransmissionCapabilities.TransferCaseBF

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("transmissionBF", ReportTransmissionCapabilities.TransmissionBF.layout()),
            ("transferCaseBF", ReportTransmissionCapabilities.TransferCaseBF.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, transmission_bf_, transfer_case_bf_ = _S_2HB.unpack(data)
        if code != 0x4511: raise rt.Reject
        self.transmission_bf = ReportTransmissionCapabilities.TransmissionBF(_E_ReportTransmissionCapabilities_PARK.get(transmission_bf_ & 0x1, transmission_bf_ & 0x1), _E_ReportTransmissionCapabilities_NEUTRAL.get(transmission_bf_ >> 1 & 0x1, transmission_bf_ >> 1 & 0x1), _E_ReportTransmissionCapabilities_REVERSE.get(transmission_bf_ >> 2 & 0x1, transmission_bf_ >> 2 & 0x1), _E_ReportTransmissionCapabilities_DRIVE.get(transmission_bf_ >> 3 & 0x1, transmission_bf_ >> 3 & 0x1), _E_ReportTransmissionCapabilities_OVERDRIVE.get(transmission_bf_ >> 4 & 0x1, transmission_bf_ >> 4 & 0x1), _E_ReportTransmissionCapabilities_L1.get(transmission_bf_ >> 5 & 0x1, transmission_bf_ >> 5 & 0x1), _E_ReportTransmissionCapabilities_L2.get(transmission_bf_ >> 6 & 0x1, transmission_bf_ >> 6 & 0x1), _E_ReportTransmissionCapabilities_L3.get(transmission_bf_ >> 7 & 0x1, transmission_bf_ >> 7 & 0x1), _E_ReportTransmissionCapabilities_L4.get(transmission_bf_ >> 8 & 0x1, transmission_bf_ >> 8 & 0x1), _E_ReportTransmissionCapabilities_L5.get(transmission_bf_ >> 9 & 0x1, transmission_bf_ >> 9 & 0x1), _E_ReportTransmissionCapabilities_L6.get(transmission_bf_ >> 10 & 0x1, transmission_bf_ >> 10 & 0x1), _E_ReportTransmissionCapabilities_L7.get(transmission_bf_ >> 11 & 0x1, transmission_bf_ >> 11 & 0x1), _E_ReportTransmissionCapabilities_L8.get(transmission_bf_ >> 12 & 0x1, transmission_bf_ >> 12 & 0x1), _E_ReportTransmissionCapabilities_L9.get(transmission_bf_ >> 13 & 0x1, transmission_bf_ >> 13 & 0x1), _E_ReportTransmissionCapabilities_L10.get(transmission_bf_ >> 14 & 0x1, transmission_bf_ >> 14 & 0x1), _E_ReportTransmissionCapabilities_Reserved.get(transmission_bf_ >> 15 & 0x1, transmission_bf_ >> 15 & 0x1))
        self.transfer_case_bf = ReportTransmissionCapabilities.TransferCaseBF(_E_ReportTransmissionCapabilities_FWD.get(transfer_case_bf_ & 0x1, transfer_case_bf_ & 0x1), _E_ReportTransmissionCapabilities_AUTO_4WD.get(transfer_case_bf_ >> 1 & 0x1, transfer_case_bf_ >> 1 & 0x1), _E_ReportTransmissionCapabilities_MANUAL_LOW_4WD.get(transfer_case_bf_ >> 2 & 0x1, transfer_case_bf_ >> 2 & 0x1), _E_ReportTransmissionCapabilities_MANUAL_HIGH_4WD.get(transfer_case_bf_ >> 3 & 0x1, transfer_case_bf_ >> 3 & 0x1), _E_ReportTransmissionCapabilities_LOW_AWD.get(transfer_case_bf_ >> 4 & 0x1, transfer_case_bf_ >> 4 & 0x1), _E_ReportTransmissionCapabilities_HIGH_AWD.get(transfer_case_bf_ >> 5 & 0x1, transfer_case_bf_ >> 5 & 0x1), _E_ReportTransmissionCapabilities_Reserved_For_Future_Use.get(transfer_case_bf_ >> 6 & 0x1, transfer_case_bf_ >> 6 & 0x1), _E_ReportTransmissionCapabilities_Reserved_For_User_Defined_Use.get(transfer_case_bf_ >> 7 & 0x1, transfer_case_bf_ >> 7 & 0x1))
        return self

    def _pack(self) -> bytes:
        transmission_bf_ = self.transmission_bf
        if type(transmission_bf_) is not ReportTransmissionCapabilities.TransmissionBF: raise rt.Reject
        park_ = transmission_bf_.park
        if not 0 <= park_ <= 1: raise rt.Reject
        neutral_ = transmission_bf_.neutral
        if not 0 <= neutral_ <= 1: raise rt.Reject
        reverse_ = transmission_bf_.reverse
        if not 0 <= reverse_ <= 1: raise rt.Reject
        drive_ = transmission_bf_.drive
        if not 0 <= drive_ <= 1: raise rt.Reject
        overdrive_ = transmission_bf_.overdrive
        if not 0 <= overdrive_ <= 1: raise rt.Reject
        l1_ = transmission_bf_.l1
        if not 0 <= l1_ <= 1: raise rt.Reject
        l2_ = transmission_bf_.l2
        if not 0 <= l2_ <= 1: raise rt.Reject
        l3_ = transmission_bf_.l3
        if not 0 <= l3_ <= 1: raise rt.Reject
        l4_ = transmission_bf_.l4
        if not 0 <= l4_ <= 1: raise rt.Reject
        l5_ = transmission_bf_.l5
        if not 0 <= l5_ <= 1: raise rt.Reject
        l6_ = transmission_bf_.l6
        if not 0 <= l6_ <= 1: raise rt.Reject
        l7_ = transmission_bf_.l7
        if not 0 <= l7_ <= 1: raise rt.Reject
        l8_ = transmission_bf_.l8
        if not 0 <= l8_ <= 1: raise rt.Reject
        l9_ = transmission_bf_.l9
        if not 0 <= l9_ <= 1: raise rt.Reject
        l10_ = transmission_bf_.l10
        if not 0 <= l10_ <= 1: raise rt.Reject
        reserved_ = transmission_bf_.reserved
        if not 0 <= reserved_ <= 1: raise rt.Reject
        transfer_case_bf_ = self.transfer_case_bf
        if type(transfer_case_bf_) is not ReportTransmissionCapabilities.TransferCaseBF: raise rt.Reject
        fwd_ = transfer_case_bf_.fwd
        if not 0 <= fwd_ <= 1: raise rt.Reject
        auto_4_wd_ = transfer_case_bf_.auto_4_wd
        if not 0 <= auto_4_wd_ <= 1: raise rt.Reject
        manual_low_4_wd_ = transfer_case_bf_.manual_low_4_wd
        if not 0 <= manual_low_4_wd_ <= 1: raise rt.Reject
        manual_high_4_wd_ = transfer_case_bf_.manual_high_4_wd
        if not 0 <= manual_high_4_wd_ <= 1: raise rt.Reject
        low_awd_ = transfer_case_bf_.low_awd
        if not 0 <= low_awd_ <= 1: raise rt.Reject
        high_awd_ = transfer_case_bf_.high_awd
        if not 0 <= high_awd_ <= 1: raise rt.Reject
        reserved_for_future_use_ = transfer_case_bf_.reserved_for_future_use
        if not 0 <= reserved_for_future_use_ <= 1: raise rt.Reject
        reserved_for_user_defined_use_ = transfer_case_bf_.reserved_for_user_defined_use
        if not 0 <= reserved_for_user_defined_use_ <= 1: raise rt.Reject
        return _S_2HB.pack(0x4511, park_ | neutral_ << 1 | reverse_ << 2 | drive_ << 3 | overdrive_ << 4 | l1_ << 5 | l2_ << 6 | l3_ << 7 | l4_ << 8 | l5_ << 9 | l6_ << 10 | l7_ << 11 | l8_ << 12 | l9_ << 13 | l10_ << 14 | reserved_ << 15, fwd_ | auto_4_wd_ << 1 | manual_low_4_wd_ << 2 | manual_high_4_wd_ << 3 | low_awd_ << 4 | high_awd_ << 5 | reserved_for_future_use_ << 6 | reserved_for_user_defined_use_ << 7)


_E_SetTransmissionState_TransmissionState = rt.members(SetTransmissionState.TransmissionState)
_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_E_SetTransferCaseState_TransferCaseState = rt.members(SetTransferCaseState.TransferCaseState)
_E_ReportTransmissionState_RequestedTransmissionState = rt.members(ReportTransmissionState.RequestedTransmissionState)
_E_ReportTransmissionState_ActualTransmissionState = rt.members(ReportTransmissionState.ActualTransmissionState)
_S_H2B = rt.Packer("<H2B")
_E_ReportTransferCaseState_TransferCaseState = rt.members(ReportTransferCaseState.TransferCaseState)
_E_ReportTransmissionCapabilities_PARK = rt.members(ReportTransmissionCapabilities.PARK)
_E_ReportTransmissionCapabilities_NEUTRAL = rt.members(ReportTransmissionCapabilities.NEUTRAL)
_E_ReportTransmissionCapabilities_REVERSE = rt.members(ReportTransmissionCapabilities.REVERSE)
_E_ReportTransmissionCapabilities_DRIVE = rt.members(ReportTransmissionCapabilities.DRIVE)
_E_ReportTransmissionCapabilities_OVERDRIVE = rt.members(ReportTransmissionCapabilities.OVERDRIVE)
_E_ReportTransmissionCapabilities_L1 = rt.members(ReportTransmissionCapabilities.L1)
_E_ReportTransmissionCapabilities_L2 = rt.members(ReportTransmissionCapabilities.L2)
_E_ReportTransmissionCapabilities_L3 = rt.members(ReportTransmissionCapabilities.L3)
_E_ReportTransmissionCapabilities_L4 = rt.members(ReportTransmissionCapabilities.L4)
_E_ReportTransmissionCapabilities_L5 = rt.members(ReportTransmissionCapabilities.L5)
_E_ReportTransmissionCapabilities_L6 = rt.members(ReportTransmissionCapabilities.L6)
_E_ReportTransmissionCapabilities_L7 = rt.members(ReportTransmissionCapabilities.L7)
_E_ReportTransmissionCapabilities_L8 = rt.members(ReportTransmissionCapabilities.L8)
_E_ReportTransmissionCapabilities_L9 = rt.members(ReportTransmissionCapabilities.L9)
_E_ReportTransmissionCapabilities_L10 = rt.members(ReportTransmissionCapabilities.L10)
_E_ReportTransmissionCapabilities_Reserved = rt.members(ReportTransmissionCapabilities.Reserved)
_E_ReportTransmissionCapabilities_FWD = rt.members(ReportTransmissionCapabilities.FWD)
_E_ReportTransmissionCapabilities_AUTO_4WD = rt.members(ReportTransmissionCapabilities.AUTO_4WD)
_E_ReportTransmissionCapabilities_MANUAL_LOW_4WD = rt.members(ReportTransmissionCapabilities.MANUAL_LOW_4WD)
_E_ReportTransmissionCapabilities_MANUAL_HIGH_4WD = rt.members(ReportTransmissionCapabilities.MANUAL_HIGH_4WD)
_E_ReportTransmissionCapabilities_LOW_AWD = rt.members(ReportTransmissionCapabilities.LOW_AWD)
_E_ReportTransmissionCapabilities_HIGH_AWD = rt.members(ReportTransmissionCapabilities.HIGH_AWD)
_E_ReportTransmissionCapabilities_Reserved_For_Future_Use = rt.members(ReportTransmissionCapabilities.Reserved_For_Future_Use)
_E_ReportTransmissionCapabilities_Reserved_For_User_Defined_Use = rt.members(ReportTransmissionCapabilities.Reserved_For_User_Defined_Use)
_S_2HB = rt.Packer("<2HB")
QueryTransmissionState.REPORT = ReportTransmissionState
QueryTransferCaseState.REPORT = ReportTransferCaseState
QueryTransmissionCapabilities.REPORT = ReportTransmissionCapabilities
