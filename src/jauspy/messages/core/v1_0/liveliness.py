"""urn:jaus:jss:core:Liveliness 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:core:Liveliness", "1.0")


@jd.message(_SERVICE, 0x4202)
class ReportHeartbeatPulse(jd.Message):
    """ReportHeartbeatPulse (0x4202): The sign of life."""


@jd.message(_SERVICE, 0x2202, query=True)
class QueryHeartbeatPulse(jd.Message):
    """QueryHeartbeatPulse (0x2202): Asks for a sign of life."""
    REPORT = ReportHeartbeatPulse
