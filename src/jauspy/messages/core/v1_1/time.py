"""urn:jaus:jss:core:Time 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import time as core_v1_0_time

_SERVICE = jd.Service("urn:jaus:jss:core:Time", "1.1")

@jd.derived(_SERVICE)
class SetTime(core_v1_0_time.SetTime): ...

@jd.derived(_SERVICE)
class ReportTime(core_v1_0_time.ReportTime): ...

@jd.derived(_SERVICE)
class QueryTime(core_v1_0_time.QueryTime):
    REPORT = ReportTime
