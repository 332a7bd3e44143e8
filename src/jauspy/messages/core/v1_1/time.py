"""urn:jaus:jss:core:Time 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class SetTime(rt.Message):
    """SetTime (0x0011): Sets time, date or both.

    time_stamp: optional. Time within the month, in UTC
    date_stamp: optional. Date, in UTC
    """

    CODE: ClassVar[int] = 0x0011
    NAME: ClassVar[str] = "SetTime"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Time"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    TimeStamp = core_v1_0_types.TimeStamp
    DateStamp = core_v1_0_types.DateStamp

    time_stamp: core_v1_0_types.TimeStamp | None = None
    date_stamp: core_v1_0_types.DateStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
                rt.Slot("date_stamp", "DateStamp", core_v1_0_types.DateStamp.layout(), optional=True),
            ),
            "B",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0011:
            raise rt.Reject
        raw = iter(_M_SetTime[mask & 0x3].unpack(data)).__next__
        if mask & 1:
            time_stamp_ = raw()
            part = time_stamp_ & 0x3FF
            if part > 999:
                raise rt.Reject
            part = time_stamp_ >> 10 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 16 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 22 & 0x1F
            if part > 23:
                raise rt.Reject
            part = time_stamp_ >> 27 & 0x1F
            if part < 1:
                raise rt.Reject
            time_stamp_ = core_v1_0_types.TimeStamp(time_stamp_ & 0x3FF, time_stamp_ >> 10 & 0x3F, time_stamp_ >> 16 & 0x3F, time_stamp_ >> 22 & 0x1F, time_stamp_ >> 27 & 0x1F)
        else:
            time_stamp_ = None
        if mask & 2:
            date_stamp_ = raw()
            part = date_stamp_ & 0x1F
            if part < 1:
                raise rt.Reject
            part = date_stamp_ >> 5 & 0xF
            if not 1 <= part <= 12:
                raise rt.Reject
            date_stamp_ = core_v1_0_types.DateStamp(date_stamp_ & 0x1F, date_stamp_ >> 5 & 0xF, date_stamp_ >> 9 & 0x7F)
        else:
            date_stamp_ = None
        return cls(time_stamp_, date_stamp_, mask & 0xFC)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 1
            if type(time_stamp_) is not core_v1_0_types.TimeStamp:
                raise rt.Reject
            time_stamp_milliseconds_ = time_stamp_.milliseconds
            if not 0 <= time_stamp_milliseconds_ <= 999:
                raise rt.Reject
            time_stamp_seconds_ = time_stamp_.seconds
            if not 0 <= time_stamp_seconds_ <= 59:
                raise rt.Reject
            time_stamp_minutes_ = time_stamp_.minutes
            if not 0 <= time_stamp_minutes_ <= 59:
                raise rt.Reject
            time_stamp_hour_ = time_stamp_.hour
            if not 0 <= time_stamp_hour_ <= 23:
                raise rt.Reject
            time_stamp_day_ = time_stamp_.day
            if not 1 <= time_stamp_day_ <= 31:
                raise rt.Reject
            raw.append(time_stamp_milliseconds_ | time_stamp_seconds_ << 10 | time_stamp_minutes_ << 16 | time_stamp_hour_ << 22 | time_stamp_day_ << 27)
        date_stamp_ = self.date_stamp
        if date_stamp_ is not None:
            mask |= 2
            if type(date_stamp_) is not core_v1_0_types.DateStamp:
                raise rt.Reject
            date_stamp_day_ = date_stamp_.day
            if not 1 <= date_stamp_day_ <= 31:
                raise rt.Reject
            date_stamp_month_ = date_stamp_.month
            if not 1 <= date_stamp_month_ <= 12:
                raise rt.Reject
            date_stamp_year_ = date_stamp_.year
            if not 0 <= date_stamp_year_ <= 127:
                raise rt.Reject
            raw.append(date_stamp_day_ | date_stamp_month_ << 5 | date_stamp_year_ << 9)
        return _M_SetTime_pack[mask & 0x3].pack(0x0011, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryTime(rt.Message):
    """QueryTime (0x2011): Asks for time, date or both.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE: ClassVar[int] = 0x2011
    NAME: ClassVar[str] = "QueryTime"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Time"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("presence_vector", "PresenceVector", rt.Number("B")),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, presence_vector_ = _S_HB.unpack(data)
        if code != 0x2011:
            raise rt.Reject
        return cls(presence_vector_)

    def _pack(self) -> bytes:
        presence_vector_ = self.presence_vector
        return _S_HB.pack(0x2011, presence_vector_)


@dataclass(slots=True, repr=False)
class ReportTime(rt.Message):
    """ReportTime (0x4011): Tells time, date or both.

    time_stamp: optional. Time within the month, in UTC
    date_stamp: optional. Date, in UTC
    """

    CODE: ClassVar[int] = 0x4011
    NAME: ClassVar[str] = "ReportTime"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Time"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    TimeStamp = core_v1_0_types.TimeStamp
    DateStamp = core_v1_0_types.DateStamp

    time_stamp: core_v1_0_types.TimeStamp | None = None
    date_stamp: core_v1_0_types.DateStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("time_stamp", "TimeStamp", core_v1_0_types.TimeStamp.layout(), optional=True),
                rt.Slot("date_stamp", "DateStamp", core_v1_0_types.DateStamp.layout(), optional=True),
            ),
            "B",
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4011:
            raise rt.Reject
        raw = iter(_M_SetTime[mask & 0x3].unpack(data)).__next__
        if mask & 1:
            time_stamp_ = raw()
            part = time_stamp_ & 0x3FF
            if part > 999:
                raise rt.Reject
            part = time_stamp_ >> 10 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 16 & 0x3F
            if part > 59:
                raise rt.Reject
            part = time_stamp_ >> 22 & 0x1F
            if part > 23:
                raise rt.Reject
            part = time_stamp_ >> 27 & 0x1F
            if part < 1:
                raise rt.Reject
            time_stamp_ = core_v1_0_types.TimeStamp(time_stamp_ & 0x3FF, time_stamp_ >> 10 & 0x3F, time_stamp_ >> 16 & 0x3F, time_stamp_ >> 22 & 0x1F, time_stamp_ >> 27 & 0x1F)
        else:
            time_stamp_ = None
        if mask & 2:
            date_stamp_ = raw()
            part = date_stamp_ & 0x1F
            if part < 1:
                raise rt.Reject
            part = date_stamp_ >> 5 & 0xF
            if not 1 <= part <= 12:
                raise rt.Reject
            date_stamp_ = core_v1_0_types.DateStamp(date_stamp_ & 0x1F, date_stamp_ >> 5 & 0xF, date_stamp_ >> 9 & 0x7F)
        else:
            date_stamp_ = None
        return cls(time_stamp_, date_stamp_, mask & 0xFC)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 1
            if type(time_stamp_) is not core_v1_0_types.TimeStamp:
                raise rt.Reject
            time_stamp_milliseconds_ = time_stamp_.milliseconds
            if not 0 <= time_stamp_milliseconds_ <= 999:
                raise rt.Reject
            time_stamp_seconds_ = time_stamp_.seconds
            if not 0 <= time_stamp_seconds_ <= 59:
                raise rt.Reject
            time_stamp_minutes_ = time_stamp_.minutes
            if not 0 <= time_stamp_minutes_ <= 59:
                raise rt.Reject
            time_stamp_hour_ = time_stamp_.hour
            if not 0 <= time_stamp_hour_ <= 23:
                raise rt.Reject
            time_stamp_day_ = time_stamp_.day
            if not 1 <= time_stamp_day_ <= 31:
                raise rt.Reject
            raw.append(time_stamp_milliseconds_ | time_stamp_seconds_ << 10 | time_stamp_minutes_ << 16 | time_stamp_hour_ << 22 | time_stamp_day_ << 27)
        date_stamp_ = self.date_stamp
        if date_stamp_ is not None:
            mask |= 2
            if type(date_stamp_) is not core_v1_0_types.DateStamp:
                raise rt.Reject
            date_stamp_day_ = date_stamp_.day
            if not 1 <= date_stamp_day_ <= 31:
                raise rt.Reject
            date_stamp_month_ = date_stamp_.month
            if not 1 <= date_stamp_month_ <= 12:
                raise rt.Reject
            date_stamp_year_ = date_stamp_.year
            if not 0 <= date_stamp_year_ <= 127:
                raise rt.Reject
            raw.append(date_stamp_day_ | date_stamp_month_ << 5 | date_stamp_year_ << 9)
        return _M_SetTime_pack[mask & 0x3].pack(0x4011, mask, *raw)


_S_HB = rt.Packer("<HB")
_M_SetTime = rt.Masks("3x", ((1, "I"), (2, "H")))
_M_SetTime_pack = rt.Masks("HB", ((1, "I"), (2, "H")))
