"""urn:jaus:jss:iop:PathReporterClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_1 import path_reporter as iop_v1_1_path_reporter

_SERVICE = jd.Service("urn:jaus:jss:iop:PathReporterClient", "1.1")

@jd.derived(_SERVICE)
class ReportPathReporterCapabilities(iop_v1_1_path_reporter.ReportPathReporterCapabilities): ...

@jd.derived(_SERVICE)
class ReportPath(iop_v1_1_path_reporter.ReportPath): ...

@jd.derived(_SERVICE)
class QueryPathReporterCapabilities(iop_v1_1_path_reporter.QueryPathReporterCapabilities):
    REPORT = ReportPathReporterCapabilities

@jd.derived(_SERVICE)
class QueryPath(iop_v1_1_path_reporter.QueryPath):
    REPORT = ReportPath
