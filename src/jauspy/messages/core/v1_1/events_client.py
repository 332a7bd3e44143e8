"""urn:jaus:jss:core:EventsClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import ClassVar

from jauspy.messages.core.v1_0 import events as core_v1_0_events
from jauspy.messages.core.v1_1 import events as core_v1_1_events


class ConfirmEventRequest(core_v1_0_events.ConfirmEventRequest):
    """ConfirmEventRequest (0x01F3): Answers a request about an event that has been carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class RejectEventRequest(core_v1_0_events.RejectEventRequest):
    """RejectEventRequest (0x01F4): Answers a request about an event that has been refused, and why."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class ReportEvents(core_v1_1_events.ReportEvents):
    """ReportEvents (0x41F0): Lists events of the component."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class Event(core_v1_1_events.Event):
    """Event (0x41F1): Carries one report to a subscriber."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class CommandEvent(core_v1_1_events.CommandEvent):
    """CommandEvent (0x41F6): Tells how a command has ended."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class ReportEventTimeout(core_v1_1_events.ReportEventTimeout):
    """ReportEventTimeout (0x41F2): Tells after how long events end unless they are renewed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class CreateEvent(core_v1_1_events.CreateEvent):
    """CreateEvent (0x01F0): Subscribes to the report that answers a query."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class CreateCommandEvent(core_v1_1_events.CreateCommandEvent):
    """CreateCommandEvent (0x01F6): Sends a command whose completion the client wants to be told."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class UpdateEvent(core_v1_1_events.UpdateEvent):
    """UpdateEvent (0x01F1): Changes type, rate or query of an existing event, or renews it."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class CancelEvent(core_v1_0_events.CancelEvent):
    """CancelEvent (0x01F2): Ends an event."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"


class QueryEvents(core_v1_1_events.QueryEvents):
    """QueryEvents (0x21F0): Asks for the events of the component, selected by message, type or identifier."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportEvents]]


class QueryEventTimeout(core_v1_1_events.QueryEventTimeout):
    """QueryEventTimeout (0x21F2): Asks after how long events end unless they are renewed."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:EventsClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportEventTimeout]]


QueryEvents.REPORT = ReportEvents
QueryEventTimeout.REPORT = ReportEventTimeout
