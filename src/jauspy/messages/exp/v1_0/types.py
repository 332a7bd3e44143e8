"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd


@jd.record()
class UGVSeverityRec(jd.Struct):
    """severity: Severity. How serious it is"""

    class Severity(IntEnum):
        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    severity: UGVSeverityRec.Severity | int = jd.field("severity", lambda: jd.Number("B", jd.Values(UGVSeverityRec.Severity)))


@jd.record()
class SeverityRec(jd.Struct):
    """severity: Severity. How serious it is"""

    class Severity(IntEnum):
        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    severity: SeverityRec.Severity | int = jd.field("severity", lambda: jd.Number("B", jd.Values(SeverityRec.Severity)))
