"""urn:jaus:jss:core:Time 1.0. Generated from schemas/; do not edit."""

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

    CODE = 0x0011
    NAME = "SetTime"
    SERVICE = "urn:jaus:jss:core:Time"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp
    DateStamp = core_v1_0_types.DateStamp

    time_stamp: core_v1_0_types.TimeStamp | None = None
    date_stamp: core_v1_0_types.DateStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
            ("DateStamp", core_v1_0_types.DateStamp.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x0011: raise rt.Reject
        raw = iter(_M_SetTime[mask & 0x3].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            time_stamp_ = raw()
            milliseconds_ = time_stamp_ & 0x3FF
            if milliseconds_ > 999: raise rt.Reject
            seconds_ = time_stamp_ >> 10 & 0x3F
            if seconds_ > 59: raise rt.Reject
            minutes_ = time_stamp_ >> 16 & 0x3F
            if minutes_ > 59: raise rt.Reject
            hour_ = time_stamp_ >> 22 & 0x1F
            if hour_ > 23: raise rt.Reject
            day_ = time_stamp_ >> 27 & 0x1F
            if day_ < 1: raise rt.Reject
            self.time_stamp = core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_)
        else: self.time_stamp = None
        if mask & 2:
            date_stamp_ = raw()
            day_2_ = date_stamp_ & 0x1F
            if day_2_ < 1: raise rt.Reject
            month_ = date_stamp_ >> 5 & 0xF
            if not 1 <= month_ <= 12: raise rt.Reject
            self.date_stamp = core_v1_0_types.DateStamp(day_2_, month_, date_stamp_ >> 9 & 0x7F)
        else: self.date_stamp = None
        self.reserved_presence = mask & 0xFC
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 1
            if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
            milliseconds_ = time_stamp_.milliseconds
            if not 0 <= milliseconds_ <= 999: raise rt.Reject
            seconds_ = time_stamp_.seconds
            if not 0 <= seconds_ <= 59: raise rt.Reject
            minutes_ = time_stamp_.minutes
            if not 0 <= minutes_ <= 59: raise rt.Reject
            hour_ = time_stamp_.hour
            if not 0 <= hour_ <= 23: raise rt.Reject
            day_ = time_stamp_.day
            if not 1 <= day_ <= 31: raise rt.Reject
            raw.append(milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27)
        date_stamp_ = self.date_stamp
        if date_stamp_ is not None:
            mask |= 2
            if type(date_stamp_) is not core_v1_0_types.DateStamp: raise rt.Reject
            day_2_ = date_stamp_.day
            if not 1 <= day_2_ <= 31: raise rt.Reject
            month_ = date_stamp_.month
            if not 1 <= month_ <= 12: raise rt.Reject
            year_ = date_stamp_.year
            if not 0 <= year_ <= 127: raise rt.Reject
            raw.append(day_2_ | month_ << 5 | year_ << 9)
        return _M_SetTime_pack[mask & 0x3].pack(0x0011, mask, *raw)


@dataclass(slots=True, repr=False)
class QueryTime(rt.Message):
    """QueryTime (0x2011): Asks for time, date or both.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """

    CODE = 0x2011
    NAME = "QueryTime"
    SERVICE = "urn:jaus:jss:core:Time"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTime]]

    presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector = _S_HB.unpack(data)
        if code != 0x2011: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x2011, self.presence_vector)


@dataclass(slots=True, repr=False)
class ReportTime(rt.Message):
    """ReportTime (0x4011): Tells time, date or both.

    time_stamp: optional. Time within the month, in UTC
    date_stamp: optional. Date, in UTC
    """

    CODE = 0x4011
    NAME = "ReportTime"
    SERVICE = "urn:jaus:jss:core:Time"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp
    DateStamp = core_v1_0_types.DateStamp

    time_stamp: core_v1_0_types.TimeStamp | None = None
    date_stamp: core_v1_0_types.DateStamp | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
            ("DateStamp", core_v1_0_types.DateStamp.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x4011: raise rt.Reject
        raw = iter(_M_SetTime[mask & 0x3].unpack(data)).__next__
        self = rt.new(cls)
        if mask & 1:
            time_stamp_ = raw()
            milliseconds_ = time_stamp_ & 0x3FF
            if milliseconds_ > 999: raise rt.Reject
            seconds_ = time_stamp_ >> 10 & 0x3F
            if seconds_ > 59: raise rt.Reject
            minutes_ = time_stamp_ >> 16 & 0x3F
            if minutes_ > 59: raise rt.Reject
            hour_ = time_stamp_ >> 22 & 0x1F
            if hour_ > 23: raise rt.Reject
            day_ = time_stamp_ >> 27 & 0x1F
            if day_ < 1: raise rt.Reject
            self.time_stamp = core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_)
        else: self.time_stamp = None
        if mask & 2:
            date_stamp_ = raw()
            day_2_ = date_stamp_ & 0x1F
            if day_2_ < 1: raise rt.Reject
            month_ = date_stamp_ >> 5 & 0xF
            if not 1 <= month_ <= 12: raise rt.Reject
            self.date_stamp = core_v1_0_types.DateStamp(day_2_, month_, date_stamp_ >> 9 & 0x7F)
        else: self.date_stamp = None
        self.reserved_presence = mask & 0xFC
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        time_stamp_ = self.time_stamp
        if time_stamp_ is not None:
            mask |= 1
            if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
            milliseconds_ = time_stamp_.milliseconds
            if not 0 <= milliseconds_ <= 999: raise rt.Reject
            seconds_ = time_stamp_.seconds
            if not 0 <= seconds_ <= 59: raise rt.Reject
            minutes_ = time_stamp_.minutes
            if not 0 <= minutes_ <= 59: raise rt.Reject
            hour_ = time_stamp_.hour
            if not 0 <= hour_ <= 23: raise rt.Reject
            day_ = time_stamp_.day
            if not 1 <= day_ <= 31: raise rt.Reject
            raw.append(milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27)
        date_stamp_ = self.date_stamp
        if date_stamp_ is not None:
            mask |= 2
            if type(date_stamp_) is not core_v1_0_types.DateStamp: raise rt.Reject
            day_2_ = date_stamp_.day
            if not 1 <= day_2_ <= 31: raise rt.Reject
            month_ = date_stamp_.month
            if not 1 <= month_ <= 12: raise rt.Reject
            year_ = date_stamp_.year
            if not 0 <= year_ <= 127: raise rt.Reject
            raw.append(day_2_ | month_ << 5 | year_ << 9)
        return _M_SetTime_pack[mask & 0x3].pack(0x4011, mask, *raw)


_S_HB = rt.Packer("<HB")
_M_SetTime = rt.Masks("3x", ((1, "I"), (2, "H")))
_M_SetTime_pack = rt.Masks("HB", ((1, "I"), (2, "H")))
QueryTime.REPORT = ReportTime
