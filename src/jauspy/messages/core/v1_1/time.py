"""urn:jaus:jss:core:Time 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.core.v1_0 import time as core_v1_0_time


class SetTime(core_v1_0_time.SetTime):
    """SetTime (0x0011): Sets time, date or both."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Time"
    VERSION = "1.1"


class QueryTime(core_v1_0_time.QueryTime):
    """QueryTime (0x2011): Asks for time, date or both."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Time"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTime]]


class ReportTime(core_v1_0_time.ReportTime):
    """ReportTime (0x4011): Tells time, date or both."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Time"
    VERSION = "1.1"


QueryTime.REPORT = ReportTime
