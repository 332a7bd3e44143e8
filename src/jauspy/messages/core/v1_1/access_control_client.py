"""urn:jaus:jss:core:AccessControlClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import access_control as core_v1_0_access_control

_SERVICE = jd.Service("urn:jaus:jss:core:AccessControlClient", "1.1")

@jd.derived(_SERVICE)
class ReportControl(core_v1_0_access_control.ReportControl): ...

@jd.derived(_SERVICE)
class RejectControl(core_v1_0_access_control.RejectControl): ...

@jd.derived(_SERVICE)
class ConfirmControl(core_v1_0_access_control.ConfirmControl): ...

@jd.derived(_SERVICE)
class ReportAuthority(core_v1_0_access_control.ReportAuthority): ...

@jd.derived(_SERVICE)
class ReportTimeout(core_v1_0_access_control.ReportTimeout): ...

@jd.derived(_SERVICE)
class RequestControl(core_v1_0_access_control.RequestControl): ...

@jd.derived(_SERVICE)
class ReleaseControl(core_v1_0_access_control.ReleaseControl): ...

@jd.derived(_SERVICE)
class QueryControl(core_v1_0_access_control.QueryControl):
    REPORT = ReportControl

@jd.derived(_SERVICE)
class QueryAuthority(core_v1_0_access_control.QueryAuthority):
    REPORT = ReportAuthority

@jd.derived(_SERVICE)
class SetAuthority(core_v1_0_access_control.SetAuthority): ...

@jd.derived(_SERVICE)
class QueryTimeout(core_v1_0_access_control.QueryTimeout):
    REPORT = ReportTimeout
