"""urn:jaus:jss:ugv:OdometryService 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class ResetOdometry(rt.Message):
    """ResetOdometry (0x0515): Sets a trip to zero.

    odometry_type: OdometryType. Which trip to set to zero
    """

    CODE = 0x0515
    NAME = "ResetOdometry"
    SERVICE = "urn:jaus:jss:ugv:OdometryService"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    class OdometryType(IntEnum):
        """Values of OdometryType."""

        TRIP_A = 2
        TRIP_B = 3
        TRIP_C = 4

    odometry_type: ResetOdometry.OdometryType | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("OdometryType", rt.Number("B", rt.Values(ResetOdometry.OdometryType))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, odometry_type_ = _S_HB.unpack(data)
        if code != 0x0515: raise rt.Reject
        self.odometry_type = _E_ResetOdometry_OdometryType[odometry_type_]
        return self

    def _pack(self) -> bytes:
        odometry_type_ = self.odometry_type
        if odometry_type_ not in _E_ResetOdometry_OdometryType: raise rt.Reject
        return _S_HB.pack(0x0515, odometry_type_)


@dataclass(slots=True, repr=False)
class QueryOdometry(rt.Message):
    """QueryOdometry (0x2515): Asks for a distance travelled.

    odom: Odom. Which distance; that of the platform cannot be reset
    """

    CODE = 0x2515
    NAME = "QueryOdometry"
    SERVICE = "urn:jaus:jss:ugv:OdometryService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportOdometry]]

    class Odom(IntEnum):
        """Values of Odom."""

        PLATFORM = 1
        TRIP_A = 2
        TRIP_B = 3
        TRIP_C = 4

    odom: QueryOdometry.Odom | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("odom", rt.Number("B", rt.Values(QueryOdometry.Odom))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, odom_ = _S_HB.unpack(data)
        if code != 0x2515: raise rt.Reject
        self.odom = _E_QueryOdometry_Odom[odom_]
        return self

    def _pack(self) -> bytes:
        odom_ = self.odom
        if odom_ not in _E_QueryOdometry_Odom: raise rt.Reject
        return _S_HB.pack(0x2515, odom_)


@dataclass(slots=True, repr=False)
class ReportOdometry(rt.Message):
    """ReportOdometry (0x4515): Tells a distance travelled.

    odom: Odom. Which distance; that of the platform cannot be reset
    odometry: in meter. Distance, in metres
    """

    CODE = 0x4515
    NAME = "ReportOdometry"
    SERVICE = "urn:jaus:jss:ugv:OdometryService"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Odom(IntEnum):
        """Values of Odom."""

        PLATFORM = 1
        TRIP_A = 2
        TRIP_B = 3
        TRIP_C = 4

    odom: ReportOdometry.Odom | int
    odometry: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("odom", rt.Number("B", rt.Values(ReportOdometry.Odom))),
            ("odometry", rt.Number("I", rt.ANY, "meter")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, odom_, self.odometry = _S_HBI.unpack(data)
        if code != 0x4515: raise rt.Reject
        self.odom = _E_ReportOdometry_Odom[odom_]
        return self

    def _pack(self) -> bytes:
        odom_ = self.odom
        if odom_ not in _E_ReportOdometry_Odom: raise rt.Reject
        return _S_HBI.pack(0x4515, odom_, self.odometry)


_E_ResetOdometry_OdometryType = rt.members(ResetOdometry.OdometryType)
_S_HB = rt.Packer("<HB")
_E_QueryOdometry_Odom = rt.members(QueryOdometry.Odom)
_E_ReportOdometry_Odom = rt.members(ReportOdometry.Odom)
_S_HBI = rt.Packer("<HBI")
QueryOdometry.REPORT = ReportOdometry
