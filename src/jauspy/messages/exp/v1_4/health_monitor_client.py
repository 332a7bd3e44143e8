"""urn:jaus:jss:exp:aeodrs:HealthMonitorClient 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_4 import health_monitor as exp_v1_4_health_monitor

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:HealthMonitorClient", "1.4")

@jd.derived(_SERVICE)
class ReportUGVSummary(exp_v1_4_health_monitor.ReportUGVSummary): ...

@jd.derived(_SERVICE)
class QueryUGVSummary(exp_v1_4_health_monitor.QueryUGVSummary):
    REPORT = ReportUGVSummary

@jd.derived(_SERVICE)
class UpdateUGVSummary(exp_v1_4_health_monitor.UpdateUGVSummary): ...
