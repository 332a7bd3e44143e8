"""urn:jaus:jss:core:Liveness 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.core.v1_0 import liveliness as core_v1_0_liveliness


class QueryHeartbeatPulse(core_v1_0_liveliness.QueryHeartbeatPulse):
    """QueryHeartbeatPulse (0x2202): Asks for a sign of life."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Liveness"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportHeartbeatPulse]]


class ReportHeartbeatPulse(core_v1_0_liveliness.ReportHeartbeatPulse):
    """ReportHeartbeatPulse (0x4202): The sign of life."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Liveness"
    VERSION = "1.1"


QueryHeartbeatPulse.REPORT = ReportHeartbeatPulse
