"""urn:jaus:jss:mobility:InertialSensorControl 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class InertialSensorControl(rt.Message):
    """InertialSensorControl (0x0429): Switches the sensor off or on, or restarts it.

    command: Command. What to do with the sensor
    """

    CODE = 0x0429
    NAME = "InertialSensorControl"
    SERVICE = "urn:jaus:jss:mobility:InertialSensorControl"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class Command(IntEnum):
        """Values of Command."""

        OFF = 0
        ON = 1
        RESTART = 2

    command: InertialSensorControl.Command | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Command", rt.Number("B", rt.Values(InertialSensorControl.Command))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, command_ = _S_HB.unpack(data)
        if code != 0x0429: raise rt.Reject
        self.command = _E_InertialSensorControl_Command[command_]
        return self

    def _pack(self) -> bytes:
        command_ = self.command
        if command_ not in _E_InertialSensorControl_Command: raise rt.Reject
        return _S_HB.pack(0x0429, command_)


@dataclass(slots=True, repr=False)
class QueryInertialSensorStatus(rt.Message):
    """QueryInertialSensorStatus (0x2429): Asks for power and alignment of the sensor."""

    CODE = 0x2429
    NAME = "QueryInertialSensorStatus"
    SERVICE = "urn:jaus:jss:mobility:InertialSensorControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportInertialSensorStatus]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b')$': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2429)


@dataclass(slots=True, repr=False)
class ReportInertialSensorStatus(rt.Message):
    """ReportInertialSensorStatus (0x4429): Tells power and alignment of the sensor.

    power_state: PowerState. Whether the sensor is on
    operating_state: OperatingState. How far the alignment has got
    """

    CODE = 0x4429
    NAME = "ReportInertialSensorStatus"
    SERVICE = "urn:jaus:jss:mobility:InertialSensorControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class PowerState(IntEnum):
        """Values of PowerState."""

        OFF = 0
        ON = 1
        RESTARTING = 2

    class OperatingState(IntEnum):
        """Values of OperatingState."""

        INIT = 0
        OPERATIONAL = 1
        COARSE_STATIONARY_ALIGNMENT = 2
        COARSE_GPS_ALIGNMENT = 3
        FINE_STATIONARY_ALIGNMENT_STARTED = 4
        FINE_STATIONARY_ALIGNMENT_COMPLETE = 5
        FINE_GPS_ALIGNMENT_STARTED = 6
        FINE_GPS_ALIGNMENT_COMPLETE = 7
        INERTIAL_SENSOR_FAILURE = 8

    power_state: ReportInertialSensorStatus.PowerState | int
    operating_state: ReportInertialSensorStatus.OperatingState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PowerState", rt.Number("B", rt.Values(ReportInertialSensorStatus.PowerState))),
            ("OperatingState", rt.Number("B", rt.Values(ReportInertialSensorStatus.OperatingState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, power_state_, operating_state_ = _S_H2B.unpack(data)
        if code != 0x4429: raise rt.Reject
        self.power_state = _E_ReportInertialSensorStatus_PowerState[power_state_]
        self.operating_state = _E_ReportInertialSensorStatus_OperatingState[operating_state_]
        return self

    def _pack(self) -> bytes:
        power_state_ = self.power_state
        if power_state_ not in _E_ReportInertialSensorStatus_PowerState: raise rt.Reject
        operating_state_ = self.operating_state
        if operating_state_ not in _E_ReportInertialSensorStatus_OperatingState: raise rt.Reject
        return _S_H2B.pack(0x4429, power_state_, operating_state_)


_E_InertialSensorControl_Command = rt.members(InertialSensorControl.Command)
_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_E_ReportInertialSensorStatus_PowerState = rt.members(ReportInertialSensorStatus.PowerState)
_E_ReportInertialSensorStatus_OperatingState = rt.members(ReportInertialSensorStatus.OperatingState)
_S_H2B = rt.Packer("<H2B")
QueryInertialSensorStatus.REPORT = ReportInertialSensorStatus
