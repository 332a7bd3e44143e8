"""urn:jaus:jss:core:Time 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

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
