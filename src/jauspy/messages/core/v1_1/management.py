"""urn:jaus:jss:core:Management 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.core.v1_0 import management as core_v1_0_management


class Shutdown(core_v1_0_management.Shutdown):
    """Shutdown (0x0002): Makes the component release its resources and stop."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


class Standby(core_v1_0_management.Standby):
    """Standby (0x0003): Moves the component from Ready to Standby."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


class Resume(core_v1_0_management.Resume):
    """Resume (0x0004): Moves the component from Standby to Ready."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


class Reset(core_v1_0_management.Reset):
    """Reset (0x0005): Makes the component initialise again."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


class SetEmergency(core_v1_0_management.SetEmergency):
    """SetEmergency (0x0006): Puts the component into the Emergency state; needs no control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


class ClearEmergency(core_v1_0_management.ClearEmergency):
    """ClearEmergency (0x0007): Ends the emergency that the same client has set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


class QueryStatus(core_v1_0_management.QueryStatus):
    """QueryStatus (0x2002): Asks for the state of the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportStatus]]


class ReportStatus(core_v1_0_management.ReportStatus):
    """ReportStatus (0x4002): Tells the state of the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Management"
    VERSION = "1.1"


QueryStatus.REPORT = ReportStatus
