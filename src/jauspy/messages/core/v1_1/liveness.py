"""urn:jaus:jss:core:Liveness 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import liveliness as core_v1_0_liveliness

_SERVICE = jd.Service("urn:jaus:jss:core:Liveness", "1.1")

@jd.derived(_SERVICE)
class ReportHeartbeatPulse(core_v1_0_liveliness.ReportHeartbeatPulse): ...

@jd.derived(_SERVICE)
class QueryHeartbeatPulse(core_v1_0_liveliness.QueryHeartbeatPulse):
    REPORT = ReportHeartbeatPulse
