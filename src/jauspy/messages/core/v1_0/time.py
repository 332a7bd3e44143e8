"""urn:jaus:jss:core:Time 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:core:Time", "1.0")


@jd.message(_SERVICE, 0x0011, presence="B", command=True)
class SetTime(jd.Message):
    """SetTime (0x0011): Sets time, date or both.

    time_stamp: optional. Time within the month, in UTC
    date_stamp: optional. Date, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    DateStamp = core_v1_0_types.DateStamp
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    date_stamp: core_v1_0_types.DateStamp | None = jd.field("DateStamp", lambda: core_v1_0_types.DateStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4011, presence="B")
class ReportTime(jd.Message):
    """ReportTime (0x4011): Tells time, date or both.

    time_stamp: optional. Time within the month, in UTC
    date_stamp: optional. Date, in UTC
    """
    TimeStamp = core_v1_0_types.TimeStamp
    DateStamp = core_v1_0_types.DateStamp
    time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
    date_stamp: core_v1_0_types.DateStamp | None = jd.field("DateStamp", lambda: core_v1_0_types.DateStamp.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2011, query=True)
class QueryTime(jd.Message):
    """QueryTime (0x2011): Asks for time, date or both.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportTime
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x3)
