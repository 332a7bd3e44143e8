"""urn:jaus:jss:core:AccessControl 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.core.v1_0 import access_control as core_v1_0_access_control


class RequestControl(core_v1_0_access_control.RequestControl):
    """RequestControl (0x000D): Asks for exclusive control, or renews it."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class ReleaseControl(core_v1_0_access_control.ReleaseControl):
    """ReleaseControl (0x000E): Gives up exclusive control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class QueryControl(core_v1_0_access_control.QueryControl):
    """QueryControl (0x200D): Asks who controls the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportControl]]


class QueryAuthority(core_v1_0_access_control.QueryAuthority):
    """QueryAuthority (0x2001): Asks for the authority of the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportAuthority]]


class SetAuthority(core_v1_0_access_control.SetAuthority):
    """SetAuthority (0x0001): Sets the authority of the controlling client."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class QueryTimeout(core_v1_0_access_control.QueryTimeout):
    """QueryTimeout (0x2003): Asks after how long control ends unless it is renewed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportTimeout]]


class ReportControl(core_v1_0_access_control.ReportControl):
    """ReportControl (0x400D): Tells who controls the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class RejectControl(core_v1_0_access_control.RejectControl):
    """RejectControl (0x0010): Tells a client that it has lost or released control, or that releasing is not
    possible.
    """

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class ConfirmControl(core_v1_0_access_control.ConfirmControl):
    """ConfirmControl (0x000F): Answers a request for control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class ReportAuthority(core_v1_0_access_control.ReportAuthority):
    """ReportAuthority (0x4001): Tells the authority of the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


class ReportTimeout(core_v1_0_access_control.ReportTimeout):
    """ReportTimeout (0x4003): Tells after how long control ends unless it is renewed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.1"


QueryControl.REPORT = ReportControl
QueryAuthority.REPORT = ReportAuthority
QueryTimeout.REPORT = ReportTimeout
