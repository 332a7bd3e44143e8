"""urn:jaus:jss:iop:PlatformStateClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_1 import platform_state as iop_v1_1_platform_state

_SERVICE = jd.Service("urn:jaus:jss:iop:PlatformStateClient", "1.1")

@jd.derived(_SERVICE)
class ConfirmPlatformStateRequest(iop_v1_1_platform_state.ConfirmPlatformStateRequest): ...

@jd.derived(_SERVICE)
class ReportPlatformState(iop_v1_1_platform_state.ReportPlatformState): ...

@jd.derived(_SERVICE)
class SetPlatformState(iop_v1_1_platform_state.SetPlatformState): ...

@jd.derived(_SERVICE)
class QueryPlatformState(iop_v1_1_platform_state.QueryPlatformState):
    REPORT = ReportPlatformState
