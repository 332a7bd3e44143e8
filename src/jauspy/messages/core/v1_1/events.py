"""urn:jaus:jss:core:Events 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xF0 or data[1] != 0x01:
            raise rt.Reject
        at = 2
        size = len(data)
        request_id_, event_type_, requested_periodic_rate_ = _S_2BH.unpack_from(data, at)
        at += 4
        event_type_ = _E_CreateEvent_EventType[event_type_]
        requested_periodic_rate_ = requested_periodic_rate_ * 0.016662851911192492
        (query_message_end,) = _S_I.unpack_from(data, at)
        at += 4
        if query_message_end > 2147483647:
            raise rt.Reject
        query_message_end += at
        if query_message_end > size:
            raise rt.Reject
        query_message_ = _registry.nested(data[at:query_message_end], depth)
        at = query_message_end
        if at != len(data):
            raise rt.Reject
        return cls(request_id_, event_type_, requested_periodic_rate_, query_message_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xf0\x01")
        request_id_ = self.request_id
        event_type_ = self.event_type
        if event_type_ not in _E_CreateEvent_EventType:
            raise rt.Reject
        requested_periodic_rate_ = self.requested_periodic_rate
        if not 0.0 <= requested_periodic_rate_ <= 1092.0:
            raise rt.Reject
        requested_periodic_rate_pos = requested_periodic_rate_ * 60.01373626373626 + 0.5
        requested_periodic_rate_raw = int(requested_periodic_rate_pos)
        if not 1.52587890625e-05 < requested_periodic_rate_pos - requested_periodic_rate_raw < 0.9999847412109375:
            requested_periodic_rate_raw = rt.exact_raw(requested_periodic_rate_, _R_3)
        out += _S_2BH.pack(request_id_, event_type_, requested_periodic_rate_raw)
        query_message_ = self.query_message
        query_message_raw = rt.message_bytes(query_message_)
        if len(query_message_raw) > 2147483647:
            raise rt.Reject
        out += _S_I.pack(len(query_message_raw))
        out += query_message_raw
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xF6 or data[1] != 0x01:
            raise rt.Reject
        at = 2
        size = len(data)
        request_id_, maximum_allowed_duration_ = _S_BI.unpack_from(data, at)
        at += 5
        (command_message_end,) = _S_I.unpack_from(data, at)
        at += 4
        if command_message_end > 2147483647:
            raise rt.Reject
        command_message_end += at
        if command_message_end > size:
            raise rt.Reject
        command_message_ = _registry.nested(data[at:command_message_end], depth)
        at = command_message_end
        if at != len(data):
            raise rt.Reject
        return cls(request_id_, maximum_allowed_duration_, command_message_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xf6\x01")
        request_id_ = self.request_id
        maximum_allowed_duration_ = self.maximum_allowed_duration
        out += _S_BI.pack(request_id_, maximum_allowed_duration_)
        command_message_ = self.command_message
        command_message_raw = rt.message_bytes(command_message_)
        if len(command_message_raw) > 2147483647:
            raise rt.Reject
        out += _S_I.pack(len(command_message_raw))
        out += command_message_raw
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xF1 or data[1] != 0x01:
            raise rt.Reject
        at = 2
        size = len(data)
        request_id_, event_type_, requested_periodic_rate_, event_id_ = _S_2BHB.unpack_from(data, at)
        at += 5
        event_type_ = _E_UpdateEvent_EventType[event_type_]
        requested_periodic_rate_ = requested_periodic_rate_ * 0.016662851911192492
        (query_message_end,) = _S_I.unpack_from(data, at)
        at += 4
        if query_message_end > 2147483647:
            raise rt.Reject
        query_message_end += at
        if query_message_end > size:
            raise rt.Reject
        query_message_ = _registry.nested(data[at:query_message_end], depth)
        at = query_message_end
        if at != len(data):
            raise rt.Reject
        return cls(request_id_, event_type_, requested_periodic_rate_, event_id_, query_message_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xf1\x01")
        request_id_ = self.request_id
        event_type_ = self.event_type
        if event_type_ not in _E_UpdateEvent_EventType:
            raise rt.Reject
        requested_periodic_rate_ = self.requested_periodic_rate
        if not 0.0 <= requested_periodic_rate_ <= 1092.0:
            raise rt.Reject
        requested_periodic_rate_pos = requested_periodic_rate_ * 60.01373626373626 + 0.5
        requested_periodic_rate_raw = int(requested_periodic_rate_pos)
        if not 1.52587890625e-05 < requested_periodic_rate_pos - requested_periodic_rate_raw < 0.9999847412109375:
            requested_periodic_rate_raw = rt.exact_raw(requested_periodic_rate_, _R_3)
        event_id_ = self.event_id
        out += _S_2BHB.pack(request_id_, event_type_, requested_periodic_rate_raw, event_id_)
        query_message_ = self.query_message
        query_message_raw = rt.message_bytes(query_message_)
        if len(query_message_raw) > 2147483647:
            raise rt.Reject
        out += _S_I.pack(len(query_message_raw))
        out += query_message_raw
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, request_id_, event_id_ = _S_H2B.unpack(data)
        if code != 0x01F2:
            raise rt.Reject
        return cls(request_id_, event_id_)

    def _pack(self) -> bytes:
        request_id_ = self.request_id
        event_id_ = self.event_id
        return _S_H2B.pack(0x01F2, request_id_, event_id_)


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

    EventTypeRec = core_v1_0_types.EventTypeRec
    AllEventsRec = core_v1_0_types.AllEventsRec

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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            (message_code_,) = _S_H.unpack_from(data, at)
            at += 2
            return cls(message_code_), at

        def _write(self, out: bytearray) -> None:
            message_code_ = self.message_code
            out += _S_H.pack(message_code_)

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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            event_id_ = data[at]
            at += 1
            return cls(event_id_), at

        def _write(self, out: bytearray) -> None:
            event_id_ = self.event_id
            out += _S_B.pack(event_id_)

    query_events_var: QueryEvents.MessageIDRec | core_v1_0_types.EventTypeRec | QueryEvents.EventIDRec | core_v1_0_types.AllEventsRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("query_events_var", "QueryEventsVar", rt.Union.of("B", message_id_rec=QueryEvents.MessageIDRec, event_type_rec=core_v1_0_types.EventTypeRec, event_id_rec=QueryEvents.EventIDRec, all_events_rec=core_v1_0_types.AllEventsRec)),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xF0 or data[1] != 0x21:
            raise rt.Reject
        at = 2
        tag = data[at]
        at += 1
        query_events_var_: QueryEvents.MessageIDRec | core_v1_0_types.EventTypeRec | QueryEvents.EventIDRec | core_v1_0_types.AllEventsRec
        if tag == 0:
            query_events_var_, at = QueryEvents.MessageIDRec._read(data, at, depth)
        elif tag == 1:
            query_events_var_, at = core_v1_0_types.EventTypeRec._read(data, at, depth)
        elif tag == 2:
            query_events_var_, at = QueryEvents.EventIDRec._read(data, at, depth)
        elif tag == 3:
            query_events_var_, at = core_v1_0_types.AllEventsRec._read(data, at, depth)
        else:
            raise rt.Reject
        if at != len(data):
            raise rt.Reject
        return cls(query_events_var_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xf0\x21")
        query_events_var_ = self.query_events_var
        query_events_var_kind = type(query_events_var_)
        if query_events_var_kind is QueryEvents.MessageIDRec:
            out.append(0)
        elif query_events_var_kind is core_v1_0_types.EventTypeRec:
            out.append(1)
        elif query_events_var_kind is QueryEvents.EventIDRec:
            out.append(2)
        elif query_events_var_kind is core_v1_0_types.AllEventsRec:
            out.append(3)
        else:
            raise rt.Reject
        query_events_var_._write(out)
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, = _S_H.unpack(data)
        if code != 0x21F2:
            raise rt.Reject
        return cls()

    def _pack(self) -> bytes:
        return _S_H.pack(0x21F2)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, request_id_, event_id_, confirmed_periodic_rate_ = _S_H2BH.unpack(data)
        if code != 0x01F3:
            raise rt.Reject
        return cls(request_id_, event_id_, confirmed_periodic_rate_ * 0.016662851911192492)

    def _pack(self) -> bytes:
        request_id_ = self.request_id
        event_id_ = self.event_id
        confirmed_periodic_rate_ = self.confirmed_periodic_rate
        if not 0.0 <= confirmed_periodic_rate_ <= 1092.0:
            raise rt.Reject
        confirmed_periodic_rate_pos = confirmed_periodic_rate_ * 60.01373626373626 + 0.5
        confirmed_periodic_rate_raw = int(confirmed_periodic_rate_pos)
        if not 1.52587890625e-05 < confirmed_periodic_rate_pos - confirmed_periodic_rate_raw < 0.9999847412109375:
            confirmed_periodic_rate_raw = rt.exact_raw(confirmed_periodic_rate_, _R_3)
        return _S_H2BH.pack(0x01F3, request_id_, event_id_, confirmed_periodic_rate_raw)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x01F4:
            raise rt.Reject
        raw = iter(_M_RejectEventRequest[mask & 0x3].unpack(data)).__next__
        request_id_ = raw()
        if mask & 1:
            response_code_ = raw()
            response_code_ = _E_RejectEventRequest_ResponseCode[response_code_]
        else:
            response_code_ = None
        if mask & 2:
            error_message_ = raw()
            error_message_ = error_message_.rstrip(b"\0").decode("latin-1")
        else:
            error_message_ = None
        return cls(request_id_, response_code_, error_message_, mask & 0xFC)

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3:
            raise rt.Reject
        raw: list[int | float | bytes] = []
        request_id_ = self.request_id
        raw.append(request_id_)
        response_code_ = self.response_code
        if response_code_ is not None:
            mask |= 1
            if response_code_ not in _E_RejectEventRequest_ResponseCode:
                raise rt.Reject
            raw.append(response_code_)
        error_message_ = self.error_message
        if error_message_ is not None:
            mask |= 2
            error_message_raw = error_message_.encode("latin-1")
            if len(error_message_raw) > 80:
                raise rt.Reject
            raw.append(error_message_raw)
        return _M_RejectEventRequest_pack[mask & 0x3].pack(0x01F4, mask, *raw)


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

        @classmethod
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            event_type_, event_id_ = _S_2B.unpack_from(data, at)
            at += 2
            event_type_ = _E_ReportEvents_EventType[event_type_]
            (query_message_end,) = _S_I.unpack_from(data, at)
            at += 4
            if query_message_end > 2147483647:
                raise rt.Reject
            query_message_end += at
            if query_message_end > size:
                raise rt.Reject
            query_message_ = _registry.nested(data[at:query_message_end], depth)
            at = query_message_end
            return cls(event_type_, event_id_, query_message_), at

        def _write(self, out: bytearray) -> None:
            event_type_ = self.event_type
            if event_type_ not in _E_ReportEvents_EventType:
                raise rt.Reject
            event_id_ = self.event_id
            out += _S_2B.pack(event_type_, event_id_)
            query_message_ = self.query_message
            query_message_raw = rt.message_bytes(query_message_)
            if len(query_message_raw) > 2147483647:
                raise rt.Reject
            out += _S_I.pack(len(query_message_raw))
            out += query_message_raw

    event_list: list[ReportEvents.ReportEventRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("event_list", "EventList", rt.Repeat(rt.Count("B", 0, 255), ReportEvents.ReportEventRec.layout())),
            ),
        )

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xF0 or data[1] != 0x41:
            raise rt.Reject
        at = 2
        size = len(data)
        event_list_count = data[at]
        at += 1
        if event_list_count * 6 > size - at:
            raise rt.Reject
        event_list_ = []
        for _ in range(event_list_count):
            event_list_item_event_type_, event_list_item_event_id_ = _S_2B.unpack_from(data, at)
            at += 2
            (event_list_item_query_message_end,) = _S_I.unpack_from(data, at)
            at += 4
            if event_list_item_query_message_end > 2147483647:
                raise rt.Reject
            event_list_item_query_message_end += at
            if event_list_item_query_message_end > size:
                raise rt.Reject
            event_list_item_query_message_ = _registry.nested(data[at:event_list_item_query_message_end], depth)
            at = event_list_item_query_message_end
            event_list_item_ = ReportEvents.ReportEventRec(_E_ReportEvents_EventType[event_list_item_event_type_], event_list_item_event_id_, event_list_item_query_message_)
            event_list_.append(event_list_item_)
        if at != len(data):
            raise rt.Reject
        return cls(event_list_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xf0\x41")
        event_list_ = self.event_list
        if type(event_list_) is not list:
            raise rt.Reject
        out.append(len(event_list_))
        for event_list_item_ in event_list_:
            if type(event_list_item_) is not ReportEvents.ReportEventRec:
                raise rt.Reject
            event_list_item_event_type_ = event_list_item_.event_type
            if event_list_item_event_type_ not in _E_ReportEvents_EventType:
                raise rt.Reject
            event_list_item_event_id_ = event_list_item_.event_id
            out += _S_2B.pack(event_list_item_event_type_, event_list_item_event_id_)
            event_list_item_query_message_ = event_list_item_.query_message
            event_list_item_query_message_raw = rt.message_bytes(event_list_item_query_message_)
            if len(event_list_item_query_message_raw) > 2147483647:
                raise rt.Reject
            out += _S_I.pack(len(event_list_item_query_message_raw))
            out += event_list_item_query_message_raw
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        if data[0] != 0xF1 or data[1] != 0x41:
            raise rt.Reject
        at = 2
        size = len(data)
        event_id_, sequence_number_ = _S_2B.unpack_from(data, at)
        at += 2
        (report_message_end,) = _S_I.unpack_from(data, at)
        at += 4
        if report_message_end > 2147483647:
            raise rt.Reject
        report_message_end += at
        if report_message_end > size:
            raise rt.Reject
        report_message_ = _registry.nested(data[at:report_message_end], depth)
        at = report_message_end
        if at != len(data):
            raise rt.Reject
        return cls(event_id_, sequence_number_, report_message_)

    def _pack(self) -> bytes:
        out = bytearray(b"\xf1\x41")
        event_id_ = self.event_id
        sequence_number_ = self.sequence_number
        out += _S_2B.pack(event_id_, sequence_number_)
        report_message_ = self.report_message
        report_message_raw = rt.message_bytes(report_message_)
        if len(report_message_raw) > 2147483647:
            raise rt.Reject
        out += _S_I.pack(len(report_message_raw))
        out += report_message_raw
        return bytes(out)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, event_id_, command_result_ = _S_H2B.unpack(data)
        if code != 0x41F6:
            raise rt.Reject
        return cls(event_id_, _E_CommandEvent_CommandResult[command_result_])

    def _pack(self) -> bytes:
        event_id_ = self.event_id
        command_result_ = self.command_result
        if command_result_ not in _E_CommandEvent_CommandResult:
            raise rt.Reject
        return _S_H2B.pack(0x41F6, event_id_, command_result_)


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

    @classmethod
    def _unpack(cls, data: bytes, depth: int) -> Self:
        code, timeout_ = _S_HB.unpack(data)
        if code != 0x41F2:
            raise rt.Reject
        return cls(_E_ReportEventTimeout_Timeout.get(timeout_, timeout_))

    def _pack(self) -> bytes:
        timeout_ = self.timeout
        return _S_HB.pack(0x41F2, timeout_)


_E_CreateEvent_EventType = {member.value: member for member in CreateEvent.EventType}
_S_2BH = rt.Packer("<2BH")
_S_I = rt.Packer("<I")
_R_3 = rt.Scaling(0.0, 1092.0, 65535)
_S_BI = rt.Packer("<BI")
_E_UpdateEvent_EventType = {member.value: member for member in UpdateEvent.EventType}
_S_2BHB = rt.Packer("<2BHB")
_S_H2B = rt.Packer("<H2B")
_S_H = rt.Packer("<H")
_S_B = rt.Packer("<B")
_S_H2BH = rt.Packer("<H2BH")
_S_HB = rt.Packer("<HB")
_M_RejectEventRequest = rt.Masks("3x", ((0, "B"), (1, "B"), (2, "80s")))
_E_RejectEventRequest_ResponseCode = {member.value: member for member in RejectEventRequest.ResponseCode}
_M_RejectEventRequest_pack = rt.Masks("HB", ((0, "B"), (1, "B"), (2, "80s")))
_E_ReportEvents_EventType = {member.value: member for member in ReportEvents.EventType}
_S_2B = rt.Packer("<2B")
_E_CommandEvent_CommandResult = {member.value: member for member in CommandEvent.CommandResult}
_E_ReportEventTimeout_Timeout = {member.value: member for member in ReportEventTimeout.Timeout}
