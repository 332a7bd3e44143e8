"""urn:jaus:jss:exp:aeodrs:HealthMonitorClient 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.exp.v1_4 import health_monitor as exp_v1_4_health_monitor


class ReportUGVSummary(exp_v1_4_health_monitor.ReportUGVSummary):
    """ReportUGVSummary (0xFD10): Tells the health of the vehicle."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:exp:aeodrs:HealthMonitorClient"
    VERSION = "1.4"


class QueryUGVSummary(exp_v1_4_health_monitor.QueryUGVSummary):
    """QueryUGVSummary (0xED10): Asks for the health of the vehicle."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:exp:aeodrs:HealthMonitorClient"
    VERSION = "1.4"
    REPORT: ClassVar[type[ReportUGVSummary]]


class UpdateUGVSummary(exp_v1_4_health_monitor.UpdateUGVSummary):
    """UpdateUGVSummary (0xDD10): Asks for the health to be found out anew."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:exp:aeodrs:HealthMonitorClient"
    VERSION = "1.4"


QueryUGVSummary.REPORT = ReportUGVSummary
