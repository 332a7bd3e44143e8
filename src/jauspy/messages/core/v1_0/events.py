"""urn:jaus:jss:core:Events 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import types as core_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:core:Events", "1.0")


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
    query_message: jd.Message | bytes = jd.field("QueryMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))


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
    query_message: jd.Message | bytes = jd.field("QueryMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))


@jd.message(_SERVICE, 0x01F2, command=True)
class CancelEvent(jd.Message):
    """CancelEvent (0x01F2): Ends an event.

    request_id: Repeated in the answer, to match it with its request
    event_id: Identifies the event; chosen by the service
    """
    request_id: int = jd.field("RequestID", jd.Number("B"))
    event_id: int = jd.field("EventID", jd.Number("B"))


@jd.message(_SERVICE, 0x41F0)
class ReportEvents(jd.Message):
    """ReportEvents (0x41F0): Lists events of the component.

    event_list: 0..255 items. The events
    """

    class EventType(IntEnum):
        PERIODIC = 0
        EVERY_CHANGE = 1

    @jd.record()
    class ReportEventRec(jd.Struct):
        """One event.

        event_type: EventType. When the report is sent
        event_id: Identifies the event; chosen by the service
        query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
        """
        event_type: ReportEvents.EventType | int = jd.field("EventType", lambda: jd.Number("B", jd.Values(ReportEvents.EventType)))
        event_id: int = jd.field("EventID", jd.Number("B"))
        query_message: jd.Message | bytes = jd.field("QueryMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))

    event_list: list[ReportEvents.ReportEventRec] = jd.field("EventList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportEvents.ReportEventRec.layout()))


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


@jd.message(_SERVICE, 0x01F3)
class ConfirmEventRequest(jd.Message):
    """ConfirmEventRequest (0x01F3): Answers a request about an event that has been carried out.

    request_id: Repeated in the answer, to match it with its request
    event_id: Identifies the event; chosen by the service
    confirmed_periodic_rate: 0..1092 hertz. Rate that will be kept, in hertz; 0 for events on change
    """
    request_id: int = jd.field("RequestID", jd.Number("B"))
    event_id: int = jd.field("EventID", jd.Number("B"))
    confirmed_periodic_rate: float = jd.field("ConfirmedPeriodicRate", jd.real("H", 0.0, 1092.0, "hertz"))


@jd.message(_SERVICE, 0x01F4, presence="B")
class RejectEventRequest(jd.Message):
    """RejectEventRequest (0x01F4): Answers a request about an event that has been refused, and why.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode, optional. The reason
    error_message: up to 80 characters, optional. An explanation for people
    """

    class ResponseCode(IntEnum):
        PERIODIC_NOT_SUPPORTED = 1
        EVERY_CHANGE_NOT_SUPPORTED = 2
        CONNECTION_REFUSED = 3
        INVALID_EVENT_SETUP = 4
        MESSAGE_NOT_SUPPORTED = 5
        INVALID_EVENT_ID = 6

    request_id: int = jd.field("RequestID", jd.Number("B"))
    response_code: RejectEventRequest.ResponseCode | int | None = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(RejectEventRequest.ResponseCode)), default=None)
    error_message: str | None = jd.field("ErrorMessage", jd.Text(80), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x41F1)
class Event(jd.Message):
    """Event (0x41F1): Carries one report to a subscriber.

    event_id: Identifies the event; chosen by the service
    sequence_number: Counts the reports of this event; wraps around after 255
    report_message: JAUS MESSAGE. The report, with its message id
    """
    event_id: int = jd.field("EventID", jd.Number("B"))
    sequence_number: int = jd.field("SequenceNumber", jd.Number("B"))
    report_message: jd.Message | bytes = jd.field("ReportMessage", jd.Blob(jd.Count("I", 0, 4294967295), _registry))
