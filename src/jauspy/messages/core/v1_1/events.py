"""urn:jaus:jss:core:Events 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar

from jauspy.codec import runtime as rt
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import types as core_v1_0_types


@dataclass(slots=True, repr=False)
class CreateEvent(rt.Message):
    """CreateEvent (0x01F0): Subscribes to the report that answers a query.

    request_id: Chosen by the client; the answer repeats it
    event_type: EventType. When the report is sent
    requested_periodic_rate: 0..1092 hertz. Wanted rate of periodic events, in hertz; otherwise 0
    query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
    """

    CODE: ClassVar[int] = 0x01F0
    NAME: ClassVar[str] = "CreateEvent"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    class EventType(IntEnum):
        """Values of EventType."""

        PERIODIC = 0
        EVERY_CHANGE = 1

    request_id: int
    event_type: CreateEvent.EventType | int
    requested_periodic_rate: float
    query_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("event_type", "EventType", rt.Number("B", rt.Values(CreateEvent.EventType))),
                rt.Slot("requested_periodic_rate", "RequestedPeriodicRate", rt.Real("H", rt.Scaling(0.0, 1092.0, 65535), "hertz")),
                rt.Slot("query_message", "QueryMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
            ),
        )


@dataclass(slots=True, repr=False)
class CreateCommandEvent(rt.Message):
    """CreateCommandEvent (0x01F6): Sends a command whose completion the client wants to be told.

    request_id: Chosen by the client; the answer repeats it
    maximum_allowed_duration: in second. Time that the command may take, in seconds
    command_message: JAUS MESSAGE. The command, with its message id
    """

    CODE: ClassVar[int] = 0x01F6
    NAME: ClassVar[str] = "CreateCommandEvent"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    request_id: int
    maximum_allowed_duration: int
    command_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("maximum_allowed_duration", "MaximumAllowedDuration", rt.Number("I", rt.ANY, "second")),
                rt.Slot("command_message", "CommandMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
            ),
        )


@dataclass(slots=True, repr=False)
class UpdateEvent(rt.Message):
    """UpdateEvent (0x01F1): Changes type, rate or query of an existing event, or renews it.

    request_id: Repeated in the answer, to match it with its request
    event_type: EventType. When the report is sent
    requested_periodic_rate: 0..1092 hertz. Wanted rate of periodic events, in hertz; otherwise 0
    event_id: Identifies the event; chosen by the service
    query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
    """

    CODE: ClassVar[int] = 0x01F1
    NAME: ClassVar[str] = "UpdateEvent"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    class EventType(IntEnum):
        """Values of EventType."""

        PERIODIC = 0
        EVERY_CHANGE = 1

    request_id: int
    event_type: UpdateEvent.EventType | int
    requested_periodic_rate: float
    event_id: int
    query_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("event_type", "EventType", rt.Number("B", rt.Values(UpdateEvent.EventType))),
                rt.Slot("requested_periodic_rate", "RequestedPeriodicRate", rt.Real("H", rt.Scaling(0.0, 1092.0, 65535), "hertz")),
                rt.Slot("event_id", "EventID", rt.Number("B")),
                rt.Slot("query_message", "QueryMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
            ),
        )


@dataclass(slots=True, repr=False)
class CancelEvent(rt.Message):
    """CancelEvent (0x01F2): Ends an event.

    request_id: Repeated in the answer, to match it with its request
    event_id: Identifies the event; chosen by the service
    """

    CODE: ClassVar[int] = 0x01F2
    NAME: ClassVar[str] = "CancelEvent"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = True

    request_id: int
    event_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("event_id", "EventID", rt.Number("B")),
            ),
        )


@dataclass(slots=True, repr=False)
class QueryEvents(rt.Message):
    """QueryEvents (0x21F0): Asks for the events of the component, selected by message, type or identifier.

    query_events_var: How to select the events
    """

    CODE: ClassVar[int] = 0x21F0
    NAME: ClassVar[str] = "QueryEvents"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @dataclass(slots=True, repr=False)
    class MessageIDRec(rt.Struct):
        """Selects by message.

        message_code: Message id of the query of the events
        """

        message_code: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("message_code", "MessageCode", rt.Number("H")),
                ),
            )

    @dataclass(slots=True, repr=False)
    class EventIDRec(rt.Struct):
        """Selects one event.

        event_id: Identifies the event; chosen by the service
        """

        event_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("event_id", "EventID", rt.Number("B")),
                ),
            )

    query_events_var: QueryEvents.MessageIDRec | core_v1_0_types.EventTypeRec | QueryEvents.EventIDRec | core_v1_0_types.AllEventsRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("query_events_var", "QueryEventsVar", rt.Union("B", (QueryEvents.MessageIDRec.layout(), core_v1_0_types.EventTypeRec.layout(), QueryEvents.EventIDRec.layout(), core_v1_0_types.AllEventsRec.layout()))),
            ),
        )


@dataclass(slots=True, repr=False)
class QueryEventTimeout(rt.Message):
    """QueryEventTimeout (0x21F2): Asks after how long events end unless they are renewed."""

    CODE: ClassVar[int] = 0x21F2
    NAME: ClassVar[str] = "QueryEventTimeout"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())


@dataclass(slots=True, repr=False)
class ConfirmEventRequest(rt.Message):
    """ConfirmEventRequest (0x01F3): Answers a request about an event that has been carried out.

    request_id: Repeated in the answer, to match it with its request
    event_id: Identifies the event; chosen by the service
    confirmed_periodic_rate: 0..1092 hertz. Rate that will be kept, in hertz; 0 for events on change
    """

    CODE: ClassVar[int] = 0x01F3
    NAME: ClassVar[str] = "ConfirmEventRequest"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    request_id: int
    event_id: int
    confirmed_periodic_rate: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("event_id", "EventID", rt.Number("B")),
                rt.Slot("confirmed_periodic_rate", "ConfirmedPeriodicRate", rt.Real("H", rt.Scaling(0.0, 1092.0, 65535), "hertz")),
            ),
        )


@dataclass(slots=True, repr=False)
class RejectEventRequest(rt.Message):
    """RejectEventRequest (0x01F4): Answers a request about an event that has been refused, and why.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode, optional. The reason
    error_message: up to 80 characters, optional. An explanation for people
    """

    CODE: ClassVar[int] = 0x01F4
    NAME: ClassVar[str] = "RejectEventRequest"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        PERIODIC_NOT_SUPPORTED = 1
        EVERY_CHANGE_NOT_SUPPORTED = 2
        CONNECTION_REFUSED = 3
        INVALID_EVENT_SETUP = 4
        MESSAGE_NOT_SUPPORTED = 5
        INVALID_EVENT_ID = 6

    request_id: int
    response_code: RejectEventRequest.ResponseCode | int | None = None
    error_message: str | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("request_id", "RequestID", rt.Number("B")),
                rt.Slot("response_code", "ResponseCode", rt.Number("B", rt.Values(RejectEventRequest.ResponseCode)), optional=True),
                rt.Slot("error_message", "ErrorMessage", rt.Text(80), optional=True),
            ),
            "B",
        )


@dataclass(slots=True, repr=False)
class ReportEvents(rt.Message):
    """ReportEvents (0x41F0): Lists events of the component.

    event_list: 0..255 items. The events
    """

    CODE: ClassVar[int] = 0x41F0
    NAME: ClassVar[str] = "ReportEvents"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class EventType(IntEnum):
        """Values of EventType."""

        PERIODIC = 0
        EVERY_CHANGE = 1

    @dataclass(slots=True, repr=False)
    class ReportEventRec(rt.Struct):
        """One event.

        event_type: EventType. When the report is sent
        event_id: Identifies the event; chosen by the service
        query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
        """

        event_type: ReportEvents.EventType | int
        event_id: int
        query_message: rt.Message | bytes

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(
                cls,
                (
                    rt.Slot("event_type", "EventType", rt.Number("B", rt.Values(ReportEvents.EventType))),
                    rt.Slot("event_id", "EventID", rt.Number("B")),
                    rt.Slot("query_message", "QueryMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
                ),
            )

    event_list: list[ReportEvents.ReportEventRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("event_list", "EventList", rt.Repeat(rt.Count("B", 0, 255), ReportEvents.ReportEventRec.layout())),
            ),
        )


@dataclass(slots=True, repr=False)
class Event(rt.Message):
    """Event (0x41F1): Carries one report to a subscriber.

    event_id: Identifies the event; chosen by the service
    sequence_number: Counts the reports of this event; wraps around after 255
    report_message: JAUS MESSAGE. The report, with its message id
    """

    CODE: ClassVar[int] = 0x41F1
    NAME: ClassVar[str] = "Event"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    event_id: int
    sequence_number: int
    report_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("event_id", "EventID", rt.Number("B")),
                rt.Slot("sequence_number", "SequenceNumber", rt.Number("B")),
                rt.Slot("report_message", "ReportMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
            ),
        )


@dataclass(slots=True, repr=False)
class CommandEvent(rt.Message):
    """CommandEvent (0x41F6): Tells how a command has ended.

    event_id: Identifies the event; chosen by the service
    command_result: CommandResult. How the command ended
    """

    CODE: ClassVar[int] = 0x41F6
    NAME: ClassVar[str] = "CommandEvent"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class CommandResult(IntEnum):
        """Values of CommandResult."""

        SUCCESSFUL = 0
        UNSUCCESSFUL = 1

    event_id: int
    command_result: CommandEvent.CommandResult | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("event_id", "EventID", rt.Number("B")),
                rt.Slot("command_result", "CommandResult", rt.Number("B", rt.Values(CommandEvent.CommandResult))),
            ),
        )


@dataclass(slots=True, repr=False)
class ReportEventTimeout(rt.Message):
    """ReportEventTimeout (0x41F2): Tells after how long events end unless they are renewed.

    timeout: Timeout or 1..255 in minute. Time after the last renewal; 0 means that there is no timeout
    """

    CODE: ClassVar[int] = 0x41F2
    NAME: ClassVar[str] = "ReportEventTimeout"
    SERVICE: ClassVar[str] = "urn:jaus:jss:core:Events"
    VERSION: ClassVar[str] = "1.1"
    IS_COMMAND: ClassVar[bool] = False

    class Timeout(IntEnum):
        """Values of Timeout."""

        TIMEOUT_FEATURE_DISABLED = 0

    timeout: ReportEventTimeout.Timeout | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("timeout", "Timeout", rt.Number("B", rt.Values(ReportEventTimeout.Timeout, ((1, 255),)), "minute")),
            ),
        )
