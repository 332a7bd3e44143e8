"""urn:jaus:jss:ugv:DriveTrainDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:DriveTrainDriver", "1.0")


@jd.message(_SERVICE, 0x0509, command=True)
class SetTransmissionState(jd.Message):
    """SetTransmissionState (0x0509): Sets the gear.

    transmission_state: TransmissionState. Gear to engage
    """

    class TransmissionState(IntEnum):
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

    transmission_state: SetTransmissionState.TransmissionState | int = jd.field("TransmissionState", lambda: jd.Number("B", jd.Values(SetTransmissionState.TransmissionState)))


@jd.message(_SERVICE, 0x4509)
class ReportTransmissionState(jd.Message):
    """ReportTransmissionState (0x4509): Tells the commanded and the engaged gear.

    requested_transmission_state: RequestedTransmissionState. Gear that was commanded
    actual_transmission_state: ActualTransmissionState. Gear that is engaged
    """

    class RequestedTransmissionState(IntEnum):
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

    requested_transmission_state: ReportTransmissionState.RequestedTransmissionState | int = jd.field("RequestedTransmissionState", lambda: jd.Number("B", jd.Values(ReportTransmissionState.RequestedTransmissionState)))
    actual_transmission_state: ReportTransmissionState.ActualTransmissionState | int = jd.field("ActualTransmissionState", lambda: jd.Number("B", jd.Values(ReportTransmissionState.ActualTransmissionState)))


@jd.message(_SERVICE, 0x2509, query=True)
class QueryTransmissionState(jd.Message):
    """QueryTransmissionState (0x2509): Asks for the gear."""
    REPORT = ReportTransmissionState


@jd.message(_SERVICE, 0x0510, command=True)
class SetTransferCaseState(jd.Message):
    """SetTransferCaseState (0x0510): Sets which wheels are driven.

    transfer_case_state: TransferCaseState. Which wheels are driven, and how
    """

    class TransferCaseState(IntEnum):
        DEFAULT = 0
        FWD = 1
        AUTO_4_WD = 2
        MANUAL_LOW_4_WD = 3
        MANUAL_HIGH_4_WD = 4
        LOW_AWD = 5
        HIGH_AWD = 6

    transfer_case_state: SetTransferCaseState.TransferCaseState | int = jd.field("TransferCaseState", lambda: jd.Number("B", jd.Values(SetTransferCaseState.TransferCaseState)))


@jd.message(_SERVICE, 0x4510)
class ReportTransferCaseState(jd.Message):
    """ReportTransferCaseState (0x4510): Tells which wheels are driven.

    transfer_case_state: TransferCaseState. Which wheels are driven, and how
    """

    class TransferCaseState(IntEnum):
        DEFAULT = 0
        FWD = 1
        AUTO_4_WD = 2
        MANUAL_LOW_4_WD = 3
        MANUAL_HIGH_4_WD = 4
        LOW_AWD = 5
        HIGH_AWD = 6

    transfer_case_state: ReportTransferCaseState.TransferCaseState | int = jd.field("TransferCaseState", lambda: jd.Number("B", jd.Values(ReportTransferCaseState.TransferCaseState)))


@jd.message(_SERVICE, 0x2510, query=True)
class QueryTransferCaseState(jd.Message):
    """QueryTransferCaseState (0x2510): Asks which wheels are driven."""
    REPORT = ReportTransferCaseState


@jd.message(_SERVICE, 0x4511)
class ReportTransmissionCapabilities(jd.Message):
    """ReportTransmissionCapabilities (0x4511): Tells which gears and drives there are.

    transmission_bf: Gears that the platform has
    transfer_case_bf: Drives that the platform has
    """

    class PARK(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class NEUTRAL(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class REVERSE(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class DRIVE(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class OVERDRIVE(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L1(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L2(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L3(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L4(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L5(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L6(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L7(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L8(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L9(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class L10(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Reserved(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("H")
    class TransmissionBF(jd.Struct):
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
        park: ReportTransmissionCapabilities.PARK | int = jd.bits(0, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.PARK))
        neutral: ReportTransmissionCapabilities.NEUTRAL | int = jd.bits(1, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.NEUTRAL))
        reverse: ReportTransmissionCapabilities.REVERSE | int = jd.bits(2, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.REVERSE))
        drive: ReportTransmissionCapabilities.DRIVE | int = jd.bits(3, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.DRIVE))
        overdrive: ReportTransmissionCapabilities.OVERDRIVE | int = jd.bits(4, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.OVERDRIVE))
        l1: ReportTransmissionCapabilities.L1 | int = jd.bits(5, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L1))
        l2: ReportTransmissionCapabilities.L2 | int = jd.bits(6, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L2))
        l3: ReportTransmissionCapabilities.L3 | int = jd.bits(7, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L3))
        l4: ReportTransmissionCapabilities.L4 | int = jd.bits(8, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L4))
        l5: ReportTransmissionCapabilities.L5 | int = jd.bits(9, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L5))
        l6: ReportTransmissionCapabilities.L6 | int = jd.bits(10, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L6))
        l7: ReportTransmissionCapabilities.L7 | int = jd.bits(11, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L7))
        l8: ReportTransmissionCapabilities.L8 | int = jd.bits(12, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L8))
        l9: ReportTransmissionCapabilities.L9 | int = jd.bits(13, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L9))
        l10: ReportTransmissionCapabilities.L10 | int = jd.bits(14, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.L10))
        reserved: ReportTransmissionCapabilities.Reserved | int = jd.bits(15, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.Reserved))

    class FWD(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class AUTO_4WD(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class MANUAL_LOW_4WD(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class MANUAL_HIGH_4WD(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class LOW_AWD(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class HIGH_AWD(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Reserved_For_Future_Use(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Reserved_For_User_Defined_Use(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("B")
    class TransferCaseBF(jd.Struct):
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
        fwd: ReportTransmissionCapabilities.FWD | int = jd.bits(0, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.FWD))
        auto_4_wd: ReportTransmissionCapabilities.AUTO_4WD | int = jd.bits(1, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.AUTO_4WD))
        manual_low_4_wd: ReportTransmissionCapabilities.MANUAL_LOW_4WD | int = jd.bits(2, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.MANUAL_LOW_4WD))
        manual_high_4_wd: ReportTransmissionCapabilities.MANUAL_HIGH_4WD | int = jd.bits(3, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.MANUAL_HIGH_4WD))
        low_awd: ReportTransmissionCapabilities.LOW_AWD | int = jd.bits(4, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.LOW_AWD))
        high_awd: ReportTransmissionCapabilities.HIGH_AWD | int = jd.bits(5, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.HIGH_AWD))
        reserved_for_future_use: ReportTransmissionCapabilities.Reserved_For_Future_Use | int = jd.bits(6, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.Reserved_For_Future_Use))
        reserved_for_user_defined_use: ReportTransmissionCapabilities.Reserved_For_User_Defined_Use | int = jd.bits(7, 0x1, lambda: jd.Values(ReportTransmissionCapabilities.Reserved_For_User_Defined_Use))

    transmission_bf: ReportTransmissionCapabilities.TransmissionBF = jd.field("transmissionBF", lambda: ReportTransmissionCapabilities.TransmissionBF.layout())
    transfer_case_bf: ReportTransmissionCapabilities.TransferCaseBF = jd.field("transferCaseBF", lambda: ReportTransmissionCapabilities.TransferCaseBF.layout())


@jd.message(_SERVICE, 0x2511, query=True)
class QueryTransmissionCapabilities(jd.Message):
    """QueryTransmissionCapabilities (0x2511): Asks which gears there are."""
    REPORT = ReportTransmissionCapabilities
