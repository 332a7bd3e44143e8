"""urn:jaus:jss:iop:PlatformStateClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.iop.v1_1 import platform_state as iop_v1_1_platform_state


class ConfirmPlatformStateRequest(iop_v1_1_platform_state.ConfirmPlatformStateRequest):
    """ConfirmPlatformStateRequest (0xFF27): Tells whether the state of the platform is changing."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PlatformStateClient"
    VERSION = "1.1"


class ReportPlatformState(iop_v1_1_platform_state.ReportPlatformState):
    """ReportPlatformState (0xFF28): Tells the state of the platform."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PlatformStateClient"
    VERSION = "1.1"


class SetPlatformState(iop_v1_1_platform_state.SetPlatformState):
    """SetPlatformState (0xFF25): Sets the state of the platform."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PlatformStateClient"
    VERSION = "1.1"


class QueryPlatformState(iop_v1_1_platform_state.QueryPlatformState):
    """QueryPlatformState (0xFF26): Asks for the state of the platform."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PlatformStateClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportPlatformState]]


QueryPlatformState.REPORT = ReportPlatformState
