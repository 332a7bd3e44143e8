"""urn:jaus:jss:core:Management 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import management as core_v1_0_management

_SERVICE = jd.Service("urn:jaus:jss:core:Management", "1.1")

@jd.derived(_SERVICE)
class Shutdown(core_v1_0_management.Shutdown): ...

@jd.derived(_SERVICE)
class Standby(core_v1_0_management.Standby): ...

@jd.derived(_SERVICE)
class Resume(core_v1_0_management.Resume): ...

@jd.derived(_SERVICE)
class Reset(core_v1_0_management.Reset): ...

@jd.derived(_SERVICE)
class SetEmergency(core_v1_0_management.SetEmergency): ...

@jd.derived(_SERVICE)
class ClearEmergency(core_v1_0_management.ClearEmergency): ...

@jd.derived(_SERVICE)
class ReportStatus(core_v1_0_management.ReportStatus): ...

@jd.derived(_SERVICE)
class QueryStatus(core_v1_0_management.QueryStatus):
    REPORT = ReportStatus
