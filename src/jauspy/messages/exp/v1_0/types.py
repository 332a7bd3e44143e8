"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class UGVSeverityRec(rt.Struct):
    """UGVSeverityRec.

    severity: Severity. How serious it is
    """

    class Severity(IntEnum):
        """Values of Severity."""

        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    severity: UGVSeverityRec.Severity | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("severity", rt.Number("B", rt.Values(UGVSeverityRec.Severity))),
        )


@dataclass(slots=True, repr=False)
class SeverityRec(rt.Struct):
    """SeverityRec.

    severity: Severity. How serious it is
    """

    class Severity(IntEnum):
        """Values of Severity."""

        NONE = 0
        INFO = 1
        WARN = 2
        ERR = 3
        FAIL = 4

    severity: SeverityRec.Severity | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("severity", rt.Number("B", rt.Values(SeverityRec.Severity))),
        )


