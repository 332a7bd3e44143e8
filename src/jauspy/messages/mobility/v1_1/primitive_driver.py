"""urn:jaus:jss:mobility:PrimitiveDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import primitive_driver as mobility_v1_0_primitive_driver


class SetWrenchEffort(mobility_v1_0_primitive_driver.SetWrenchEffort):
    """SetWrenchEffort (0x0405): Sets propulsive and resistive efforts."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION = "1.1"


class QueryWrenchEffort(mobility_v1_0_primitive_driver.QueryWrenchEffort):
    """QueryWrenchEffort (0x2405): Asks for the efforts in use."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportWrenchEffort]]


class ReportWrenchEffort(mobility_v1_0_primitive_driver.ReportWrenchEffort):
    """ReportWrenchEffort (0x4405): Tells the efforts in use."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:PrimitiveDriver"
    VERSION = "1.1"


QueryWrenchEffort.REPORT = ReportWrenchEffort
