"""urn:jaus:jss:core:EventsClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import events as core_v1_0_events
from jauspy.messages.core.v1_1 import events as core_v1_1_events

_SERVICE = jd.Service("urn:jaus:jss:core:EventsClient", "1.1")

@jd.derived(_SERVICE)
class ConfirmEventRequest(core_v1_0_events.ConfirmEventRequest): ...

@jd.derived(_SERVICE)
class RejectEventRequest(core_v1_0_events.RejectEventRequest): ...

@jd.derived(_SERVICE)
class ReportEvents(core_v1_1_events.ReportEvents): ...

@jd.derived(_SERVICE)
class Event(core_v1_1_events.Event): ...

@jd.derived(_SERVICE)
class CommandEvent(core_v1_1_events.CommandEvent): ...

@jd.derived(_SERVICE)
class ReportEventTimeout(core_v1_1_events.ReportEventTimeout): ...

@jd.derived(_SERVICE)
class CreateEvent(core_v1_1_events.CreateEvent): ...

@jd.derived(_SERVICE)
class CreateCommandEvent(core_v1_1_events.CreateCommandEvent): ...

@jd.derived(_SERVICE)
class UpdateEvent(core_v1_1_events.UpdateEvent): ...

@jd.derived(_SERVICE)
class CancelEvent(core_v1_0_events.CancelEvent): ...

@jd.derived(_SERVICE)
class QueryEvents(core_v1_1_events.QueryEvents):
    REPORT = ReportEvents

@jd.derived(_SERVICE)
class QueryEventTimeout(core_v1_1_events.QueryEventTimeout):
    REPORT = ReportEventTimeout
