"""urn:jaus:jss:iop:StabilityControlService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:StabilityControlService", "1.1")


@jd.message(_SERVICE, 0xD7CB)
class ReportStabilityControlCapabilities(jd.Message):
    """ReportStabilityControlCapabilities (0xD7CB): Driving aids that can be switched.

    stability_control_status: Bit set: the aid exists; clear: it is missing or cannot be switched
    """

    @jd.bit_field("H")
    class StabilityControlStatus(jd.Struct):
        """Bit set: the aid exists; clear: it is missing or cannot be switched.

        antilock_brake_system: bit 0. Antilock brake system.
        traction_control: bit 1. Traction control.
        electronic_stability_control: bit 2. Electronic stability control.
        differential_lock: bit 3. Differential lock.
        front_suspension_lock: bit 4. Front suspension lock.
        rear_suspension_lock: bit 5. Rear suspension lock.
        active_pitchover_control: bit 6. Active pitchover control.
        active_rollover_control: bit 7. Active rollover control.
        reserved_for_future_use: bits 8..11. Sent as 0, ignored when received.
        user_defined_capability1: bit 12. User defined capability 1.
        user_defined_capability2: bit 13. User defined capability 2.
        user_defined_capability3: bit 14. User defined capability 3.
        user_defined_capability4: bit 15. User defined capability 4.
        """
        antilock_brake_system: int = jd.bits(0, 0x1)
        traction_control: int = jd.bits(1, 0x1)
        electronic_stability_control: int = jd.bits(2, 0x1)
        differential_lock: int = jd.bits(3, 0x1)
        front_suspension_lock: int = jd.bits(4, 0x1)
        rear_suspension_lock: int = jd.bits(5, 0x1)
        active_pitchover_control: int = jd.bits(6, 0x1)
        active_rollover_control: int = jd.bits(7, 0x1)
        reserved_for_future_use: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        user_defined_capability1: int = jd.bits(12, 0x1)
        user_defined_capability2: int = jd.bits(13, 0x1)
        user_defined_capability3: int = jd.bits(14, 0x1)
        user_defined_capability4: int = jd.bits(15, 0x1)

    stability_control_status: ReportStabilityControlCapabilities.StabilityControlStatus = jd.field("StabilityControlStatus", lambda: ReportStabilityControlCapabilities.StabilityControlStatus.layout())


@jd.message(_SERVICE, 0xD7C8, query=True)
class QueryStabilityControlCapabilities(jd.Message):
    """QueryStabilityControlCapabilities (0xD7C8): Asks which driving aids exist."""
    REPORT = ReportStabilityControlCapabilities


@jd.message(_SERVICE, 0xD7CC)
class ReportStabilityControlStatus(jd.Message):
    """ReportStabilityControlStatus (0xD7CC): Present state of the driving aids.

    stability_control_status: Bit set: the aid is on; clear: off
    """

    @jd.bit_field("H")
    class StabilityControlStatus(jd.Struct):
        """Bit set: the aid is on; clear: off.

        antilock_brake_system: bit 0. Antilock brake system.
        traction_control: bit 1. Traction control.
        electronic_stability_control: bit 2. Electronic stability control.
        differential_lock: bit 3. Differential lock.
        front_suspension_lock: bit 4. Front suspension lock.
        rear_suspension_lock: bit 5. Rear suspension lock.
        active_pitchover_control: bit 6. Active pitchover control.
        active_rollover_control: bit 7. Active rollover control.
        reserved_for_future_use: bits 8..11. Sent as 0, ignored when received.
        user_defined_capability1: bit 12. User defined capability 1.
        user_defined_capability2: bit 13. User defined capability 2.
        user_defined_capability3: bit 14. User defined capability 3.
        user_defined_capability4: bit 15. User defined capability 4.
        """
        antilock_brake_system: int = jd.bits(0, 0x1)
        traction_control: int = jd.bits(1, 0x1)
        electronic_stability_control: int = jd.bits(2, 0x1)
        differential_lock: int = jd.bits(3, 0x1)
        front_suspension_lock: int = jd.bits(4, 0x1)
        rear_suspension_lock: int = jd.bits(5, 0x1)
        active_pitchover_control: int = jd.bits(6, 0x1)
        active_rollover_control: int = jd.bits(7, 0x1)
        reserved_for_future_use: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        user_defined_capability1: int = jd.bits(12, 0x1)
        user_defined_capability2: int = jd.bits(13, 0x1)
        user_defined_capability3: int = jd.bits(14, 0x1)
        user_defined_capability4: int = jd.bits(15, 0x1)

    stability_control_status: ReportStabilityControlStatus.StabilityControlStatus = jd.field("StabilityControlStatus", lambda: ReportStabilityControlStatus.StabilityControlStatus.layout())


@jd.message(_SERVICE, 0xD7C9, query=True)
class QueryStabilityControlStatus(jd.Message):
    """QueryStabilityControlStatus (0xD7C9): Asks which driving aids are on."""
    REPORT = ReportStabilityControlStatus


@jd.message(_SERVICE, 0xD7CA, command=True)
class SetStabilityControlStatus(jd.Message):
    """SetStabilityControlStatus (0xD7CA): Switches the driving aids; may be ignored if it names one the vehicle lacks. All bits are written, so read the status first.

    stability_control_status: Bit set: switch the aid on; clear: switch it off
    """

    @jd.bit_field("H")
    class StabilityControlStatus(jd.Struct):
        """Bit set: switch the aid on; clear: switch it off.

        antilock_brake_system: bit 0. Antilock brake system.
        traction_control: bit 1. Traction control.
        electronic_stability_control: bit 2. Electronic stability control.
        differential_lock: bit 3. Differential lock.
        front_suspension_lock: bit 4. Front suspension lock.
        rear_suspension_lock: bit 5. Rear suspension lock.
        active_pitchover_control: bit 6. Active pitchover control.
        active_rollover_control: bit 7. Active rollover control.
        reserved_for_future_use: bits 8..11. Sent as 0, ignored when received.
        user_defined_capability1: bit 12. User defined capability 1.
        user_defined_capability2: bit 13. User defined capability 2.
        user_defined_capability3: bit 14. User defined capability 3.
        user_defined_capability4: bit 15. User defined capability 4.
        """
        antilock_brake_system: int = jd.bits(0, 0x1)
        traction_control: int = jd.bits(1, 0x1)
        electronic_stability_control: int = jd.bits(2, 0x1)
        differential_lock: int = jd.bits(3, 0x1)
        front_suspension_lock: int = jd.bits(4, 0x1)
        rear_suspension_lock: int = jd.bits(5, 0x1)
        active_pitchover_control: int = jd.bits(6, 0x1)
        active_rollover_control: int = jd.bits(7, 0x1)
        reserved_for_future_use: int = jd.bits(8, 0xF, jd.Values(None, ((0, 15),)))
        user_defined_capability1: int = jd.bits(12, 0x1)
        user_defined_capability2: int = jd.bits(13, 0x1)
        user_defined_capability3: int = jd.bits(14, 0x1)
        user_defined_capability4: int = jd.bits(15, 0x1)

    stability_control_status: SetStabilityControlStatus.StabilityControlStatus = jd.field("StabilityControlStatus", lambda: SetStabilityControlStatus.StabilityControlStatus.layout())
