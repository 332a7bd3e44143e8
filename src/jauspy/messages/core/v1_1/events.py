"""urn:jaus:jss:core:Events 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import events as core_v1_0_events
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:core:Events", "1.1")


@jd.message(_SERVICE, 0x01F0, command=True)
class CreateEvent(jd.Message):
    """CreateEvent (0x01F0): Subscribes to the report that answers a query.

    request_id: Chosen by the client; the answer repeats it
    event_type: EventType. When the report is sent
    requested_periodic_rate: 0..1092 hertz. Wanted rate of periodic events, in hertz; otherwise 0
    query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
    """

    class EventType(IntEnum):
        PERIODIC = 0
        EVERY_CHANGE = 1

    request_id: int = jd.field("RequestID", jd.Number("B"))
    event_type: CreateEvent.EventType | int = jd.field("EventType", lambda: jd.Number("B", jd.Values(CreateEvent.EventType)))
    requested_periodic_rate: float = jd.field("RequestedPeriodicRate", jd.real("H", 0.0, 1092.0, "hertz"))
    query_message: jd.Message | bytes = jd.field("QueryMessage", jd.Blob(jd.Count("I", 0, 2147483647), _registry))


@jd.message(_SERVICE, 0x01F6, command=True)
class CreateCommandEvent(jd.Message):
    """CreateCommandEvent (0x01F6): Sends a command whose completion the client wants to be told.

    request_id: Chosen by the client; the answer repeats it
    maximum_allowed_duration: in second. Time that the command may take, in seconds
    command_message: JAUS MESSAGE. The command, with its message id
    """
    request_id: int = jd.field("RequestID", jd.Number("B"))
    maximum_allowed_duration: int = jd.field("MaximumAllowedDuration", jd.Number("I", jd.ANY, "second"))
    command_message: jd.Message | bytes = jd.field("CommandMessage", jd.Blob(jd.Count("I", 0, 2147483647), _registry))


@jd.message(_SERVICE, 0x01F1, command=True)
class UpdateEvent(jd.Message):
    """UpdateEvent (0x01F1): Changes type, rate or query of an existing event, or renews it.

    request_id: Repeated in the answer, to match it with its request
    event_type: EventType. When the report is sent
    requested_periodic_rate: 0..1092 hertz. Wanted rate of periodic events, in hertz; otherwise 0
    event_id: Identifies the event; chosen by the service
    query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
    """

    class EventType(IntEnum):
        PERIODIC = 0
        EVERY_CHANGE = 1

    request_id: int = jd.field("RequestID", jd.Number("B"))
    event_type: UpdateEvent.EventType | int = jd.field("EventType", lambda: jd.Number("B", jd.Values(UpdateEvent.EventType)))
    requested_periodic_rate: float = jd.field("RequestedPeriodicRate", jd.real("H", 0.0, 1092.0, "hertz"))
    event_id: int = jd.field("EventID", jd.Number("B"))
    query_message: jd.Message | bytes = jd.field("QueryMessage", jd.Blob(jd.Count("I", 0, 2147483647), _registry))

@jd.derived(_SERVICE)
class CancelEvent(core_v1_0_events.CancelEvent): ...


@jd.message(_SERVICE, 0x41F0)
class ReportEvents(jd.Message):
    """ReportEvents (0x41F0): Lists events of the component.

    event_list: 0..255 items. The events
    """
    ReportEventRec = core_v1_0_types.ReportEventRec
    event_list: list[core_v1_0_types.ReportEventRec] = jd.field("EventList", lambda: jd.Repeat(jd.Count("B", 0, 255), core_v1_0_types.ReportEventRec.layout()))


@jd.message(_SERVICE, 0x21F0, query=True)
class QueryEvents(jd.Message):
    """QueryEvents (0x21F0): Asks for the events of the component, selected by message, type or identifier.

    query_events_var: How to select the events
    """
    REPORT = ReportEvents
    EventTypeRec = core_v1_0_types.EventTypeRec
    AllEventsRec = core_v1_0_types.AllEventsRec

    @jd.record()
    class MessageIDRec(jd.Struct):
        """Selects by message.

        message_code: Message id of the query of the events
        """
        message_code: int = jd.field("MessageCode", jd.Number("H"))

    @jd.record()
    class EventIDRec(jd.Struct):
        """Selects one event.

        event_id: Identifies the event; chosen by the service
        """
        event_id: int = jd.field("EventID", jd.Number("B"))

    query_events_var: QueryEvents.MessageIDRec | core_v1_0_types.EventTypeRec | QueryEvents.EventIDRec | core_v1_0_types.AllEventsRec = jd.field("QueryEventsVar", lambda: jd.Union.of("B", message_id_rec=QueryEvents.MessageIDRec, event_type_rec=core_v1_0_types.EventTypeRec, event_id_rec=QueryEvents.EventIDRec, all_events_rec=core_v1_0_types.AllEventsRec))


@jd.message(_SERVICE, 0x41F2)
class ReportEventTimeout(jd.Message):
    """ReportEventTimeout (0x41F2): Tells after how long events end unless they are renewed.

    timeout: Timeout or 1..255 in minute. Time after the last renewal; 0 means that there is no timeout
    """

    class Timeout(IntEnum):
        TIMEOUT_FEATURE_DISABLED = 0

    timeout: ReportEventTimeout.Timeout | int = jd.field("Timeout", lambda: jd.Number("B", jd.Values(ReportEventTimeout.Timeout, ((1, 255),)), "minute"))


@jd.message(_SERVICE, 0x21F2, query=True)
class QueryEventTimeout(jd.Message):
    """QueryEventTimeout (0x21F2): Asks after how long events end unless they are renewed."""
    REPORT = ReportEventTimeout

@jd.derived(_SERVICE)
class ConfirmEventRequest(core_v1_0_events.ConfirmEventRequest): ...

@jd.derived(_SERVICE)
class RejectEventRequest(core_v1_0_events.RejectEventRequest): ...


@jd.message(_SERVICE, 0x41F1)
class Event(jd.Message):
    """Event (0x41F1): Carries one report to a subscriber.

    event_id: Identifies the event; chosen by the service
    sequence_number: Counts the reports of this event; wraps around after 255
    report_message: JAUS MESSAGE. The report, with its message id
    """
    event_id: int = jd.field("EventID", jd.Number("B"))
    sequence_number: int = jd.field("SequenceNumber", jd.Number("B"))
    report_message: jd.Message | bytes = jd.field("ReportMessage", jd.Blob(jd.Count("I", 0, 2147483647), _registry))


@jd.message(_SERVICE, 0x41F6)
class CommandEvent(jd.Message):
    """CommandEvent (0x41F6): Tells how a command has ended.

    event_id: Identifies the event; chosen by the service
    command_result: CommandResult. How the command ended
    """

    class CommandResult(IntEnum):
        SUCCESSFUL = 0
        UNSUCCESSFUL = 1

    event_id: int = jd.field("EventID", jd.Number("B"))
    command_result: CommandEvent.CommandResult | int = jd.field("CommandResult", lambda: jd.Number("B", jd.Values(CommandEvent.CommandResult)))
