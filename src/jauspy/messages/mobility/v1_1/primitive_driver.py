"""urn:jaus:jss:mobility:PrimitiveDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import primitive_driver as mobility_v1_0_primitive_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:PrimitiveDriver", "1.1")

@jd.derived(_SERVICE)
class SetWrenchEffort(mobility_v1_0_primitive_driver.SetWrenchEffort): ...

@jd.derived(_SERVICE)
class ReportWrenchEffort(mobility_v1_0_primitive_driver.ReportWrenchEffort): ...

@jd.derived(_SERVICE)
class QueryWrenchEffort(mobility_v1_0_primitive_driver.QueryWrenchEffort):
    REPORT = ReportWrenchEffort
