"""urn:jaus:jss:iop:PathReporterClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.iop.v1_1 import path_reporter as iop_v1_1_path_reporter


class ReportPathReporterCapabilities(iop_v1_1_path_reporter.ReportPathReporterCapabilities):
    """ReportPathReporterCapabilities (0xDEF2): Tells which paths can be reported."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PathReporterClient"
    VERSION = "1.1"


class ReportPath(iop_v1_1_path_reporter.ReportPath):
    """ReportPath (0xDEF3): Tells a path."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PathReporterClient"
    VERSION = "1.1"


class QueryPathReporterCapabilities(iop_v1_1_path_reporter.QueryPathReporterCapabilities):
    """QueryPathReporterCapabilities (0xDEF0): Asks which paths can be reported."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PathReporterClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportPathReporterCapabilities]]


class QueryPath(iop_v1_1_path_reporter.QueryPath):
    """QueryPath (0xDEF1): Asks for a path."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PathReporterClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportPath]]


QueryPathReporterCapabilities.REPORT = ReportPathReporterCapabilities
QueryPath.REPORT = ReportPath
