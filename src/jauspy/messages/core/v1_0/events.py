"""urn:jaus:jss:core:Events 1.0. Generated from schemas/; do not edit."""

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

    CODE = 0x01F0
    NAME = "CreateEvent"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

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
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
            ("EventType", rt.Number("B", rt.Values(CreateEvent.EventType))),
            ("RequestedPeriodicRate", rt.real("H", 0.0, 1092.0, "hertz")),
            ("QueryMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF0 or data[1] != 0x01: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.request_id, event_type_, requested_periodic_rate_ = _S_2BH.unpack_from(data, 2)
        self.event_type = _E_CreateEvent_EventType[event_type_]
        self.requested_periodic_rate = requested_periodic_rate_ * 0.016662851911192492
        (query_message_end_,) = _S_I.unpack_from(data, 6)
        query_message_end_ += 10
        self.query_message = (nesting or _registry.nesting).message(data[10:query_message_end_])
        if query_message_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf0\x01")
        event_type_ = self.event_type
        if event_type_ not in _E_CreateEvent_EventType: raise rt.Reject
        requested_periodic_rate_ = self.requested_periodic_rate
        if not 0.0 <= requested_periodic_rate_ <= 1092.0: raise rt.Reject
        near = requested_periodic_rate_ * 60.01373626373626 + 0.5
        requested_periodic_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - requested_periodic_rate_raw_ < 0.9999847412109375: requested_periodic_rate_raw_ = rt.exact_raw(requested_periodic_rate_, _R_3)
        out += _S_2BH.pack(self.request_id, event_type_, requested_periodic_rate_raw_)
        query_message_raw_ = rt.message_bytes(self.query_message)
        out += _S_I.pack(len(query_message_raw_))
        out += query_message_raw_
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

    CODE = 0x01F1
    NAME = "UpdateEvent"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

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
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
            ("EventType", rt.Number("B", rt.Values(UpdateEvent.EventType))),
            ("RequestedPeriodicRate", rt.real("H", 0.0, 1092.0, "hertz")),
            ("EventID", rt.Number("B")),
            ("QueryMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF1 or data[1] != 0x01: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.request_id, event_type_, requested_periodic_rate_, self.event_id = _S_2BHB.unpack_from(data, 2)
        self.event_type = _E_UpdateEvent_EventType[event_type_]
        self.requested_periodic_rate = requested_periodic_rate_ * 0.016662851911192492
        (query_message_end_,) = _S_I.unpack_from(data, 7)
        query_message_end_ += 11
        self.query_message = (nesting or _registry.nesting).message(data[11:query_message_end_])
        if query_message_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf1\x01")
        event_type_ = self.event_type
        if event_type_ not in _E_UpdateEvent_EventType: raise rt.Reject
        requested_periodic_rate_ = self.requested_periodic_rate
        if not 0.0 <= requested_periodic_rate_ <= 1092.0: raise rt.Reject
        near = requested_periodic_rate_ * 60.01373626373626 + 0.5
        requested_periodic_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - requested_periodic_rate_raw_ < 0.9999847412109375: requested_periodic_rate_raw_ = rt.exact_raw(requested_periodic_rate_, _R_3)
        out += _S_2BHB.pack(self.request_id, event_type_, requested_periodic_rate_raw_, self.event_id)
        query_message_raw_ = rt.message_bytes(self.query_message)
        out += _S_I.pack(len(query_message_raw_))
        out += query_message_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class CancelEvent(rt.Message):
    """CancelEvent (0x01F2): Ends an event.

    request_id: Repeated in the answer, to match it with its request
    event_id: Identifies the event; chosen by the service
    """

    CODE = 0x01F2
    NAME = "CancelEvent"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    request_id: int
    event_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
            ("EventID", rt.Number("B")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.request_id, self.event_id = _S_H2B.unpack(data)
        if code != 0x01F2: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_H2B.pack(0x01F2, self.request_id, self.event_id)


@dataclass(slots=True, repr=False)
class QueryEvents(rt.Message):
    """QueryEvents (0x21F0): Asks for the events of the component, selected by message, type or identifier.

    query_events_var: How to select the events
    """

    CODE = 0x21F0
    NAME = "QueryEvents"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEvents]]

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
            return rt.composite(
                cls, None,
                ("MessageCode", rt.Number("H")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.message_code,) = _S_H.unpack_from(data, at)
            return self, at + 2

        def _write(self, out: bytearray) -> None:
            out += _S_H.pack(self.message_code)

    @dataclass(slots=True, repr=False)
    class EventIDRec(rt.Struct):
        """Selects one event.

        event_id: Identifies the event; chosen by the service
        """

        event_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("EventID", rt.Number("B")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.event_id = data[at]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            out.append(self.event_id)

    query_events_var: QueryEvents.MessageIDRec | core_v1_0_types.EventTypeRec | QueryEvents.EventIDRec | core_v1_0_types.AllEventsRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryEventsVar", rt.Union.of("B", message_id_rec=QueryEvents.MessageIDRec, event_type_rec=core_v1_0_types.EventTypeRec, event_id_rec=QueryEvents.EventIDRec, all_events_rec=core_v1_0_types.AllEventsRec)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF0 or data[1] != 0x21: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        tag = data[2]
        at = 3
        self.query_events_var, at = _U_8[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf0\x21")
        query_events_var_ = self.query_events_var
        out.append(_T_9[type(query_events_var_)])
        query_events_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ConfirmEventRequest(rt.Message):
    """ConfirmEventRequest (0x01F3): Answers a request about an event that has been carried out.

    request_id: Repeated in the answer, to match it with its request
    event_id: Identifies the event; chosen by the service
    confirmed_periodic_rate: 0..1092 hertz. Rate that will be kept, in hertz; 0 for events on change
    """

    CODE = 0x01F3
    NAME = "ConfirmEventRequest"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    request_id: int
    event_id: int
    confirmed_periodic_rate: float

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
            ("EventID", rt.Number("B")),
            ("ConfirmedPeriodicRate", rt.real("H", 0.0, 1092.0, "hertz")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.request_id, self.event_id, confirmed_periodic_rate_ = _S_H2BH.unpack(data)
        if code != 0x01F3: raise rt.Reject
        self.confirmed_periodic_rate = confirmed_periodic_rate_ * 0.016662851911192492
        return self

    def _pack(self) -> bytes:
        confirmed_periodic_rate_ = self.confirmed_periodic_rate
        if not 0.0 <= confirmed_periodic_rate_ <= 1092.0: raise rt.Reject
        near = confirmed_periodic_rate_ * 60.01373626373626 + 0.5
        confirmed_periodic_rate_raw_ = int(near)
        if not 1.52587890625e-05 < near - confirmed_periodic_rate_raw_ < 0.9999847412109375: confirmed_periodic_rate_raw_ = rt.exact_raw(confirmed_periodic_rate_, _R_3)
        return _S_H2BH.pack(0x01F3, self.request_id, self.event_id, confirmed_periodic_rate_raw_)


@dataclass(slots=True, repr=False)
class RejectEventRequest(rt.Message):
    """RejectEventRequest (0x01F4): Answers a request about an event that has been refused, and why.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode, optional. The reason
    error_message: up to 80 characters, optional. An explanation for people
    """

    CODE = 0x01F4
    NAME = "RejectEventRequest"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

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
        return rt.composite(
            cls, "B",
            ("RequestID", rt.Number("B")),
            ("ResponseCode", rt.Number("B", rt.Values(RejectEventRequest.ResponseCode)), True),
            ("ErrorMessage", rt.Text(80), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0x01F4: raise rt.Reject
        raw = iter(_M_RejectEventRequest[mask & 0x3].unpack(data)).__next__
        self = rt.new(cls)
        self.request_id = raw()
        if mask & 1:
            response_code_ = raw()
            self.response_code = _E_RejectEventRequest_ResponseCode[response_code_]
        else: self.response_code = None
        if mask & 2:
            error_message_ = raw()
            self.error_message = error_message_.rstrip(b"\0").decode("latin-1")
        else: self.error_message = None
        self.reserved_presence = mask & 0xFC
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        raw: list[int | float | bytes] = []
        raw.append(self.request_id)
        response_code_ = self.response_code
        if response_code_ is not None:
            mask |= 1
            if response_code_ not in _E_RejectEventRequest_ResponseCode: raise rt.Reject
            raw.append(response_code_)
        error_message_ = self.error_message
        if error_message_ is not None:
            mask |= 2
            error_message_raw_ = error_message_.encode("latin-1")
            if len(error_message_raw_) > 80: raise rt.Reject
            raw.append(error_message_raw_)
        return _M_RejectEventRequest_pack[mask & 0x3].pack(0x01F4, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportEvents(rt.Message):
    """ReportEvents (0x41F0): Lists events of the component.

    event_list: 0..255 items. The events
    """

    CODE = 0x41F0
    NAME = "ReportEvents"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

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
            return rt.composite(
                cls, None,
                ("EventType", rt.Number("B", rt.Values(ReportEvents.EventType))),
                ("EventID", rt.Number("B")),
                ("QueryMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
            )

    event_list: list[ReportEvents.ReportEventRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EventList", rt.Repeat(rt.Count("B", 0, 255), ReportEvents.ReportEventRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF0 or data[1] != 0x41: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        event_list_count_ = data[2]
        if event_list_count_ * 6 > size - 3: raise rt.Reject
        at = 3
        event_list_ = []
        for _ in range(event_list_count_):
            item_ = rt.new(ReportEvents.ReportEventRec)
            event_type_ = data[at]
            item_.event_id = data[at + 1]
            item_.event_type = _E_ReportEvents_EventType[event_type_]
            (query_message_end_,) = _S_I.unpack_from(data, at + 2)
            query_message_end_ += at + 6
            item_.query_message = (nesting or _registry.nesting).message(data[at + 6:query_message_end_])
            at = query_message_end_
            event_list_.append(item_)
        self.event_list = event_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf0\x41")
        event_list_ = self.event_list
        if type(event_list_) is not list: raise rt.Reject
        out.append(len(event_list_))
        for item_ in event_list_:
            if type(item_) is not ReportEvents.ReportEventRec: raise rt.Reject
            event_type_ = item_.event_type
            if event_type_ not in _E_ReportEvents_EventType: raise rt.Reject
            out.append(event_type_)
            out.append(item_.event_id)
            query_message_raw_ = rt.message_bytes(item_.query_message)
            out += _S_I.pack(len(query_message_raw_))
            out += query_message_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class Event(rt.Message):
    """Event (0x41F1): Carries one report to a subscriber.

    event_id: Identifies the event; chosen by the service
    sequence_number: Counts the reports of this event; wraps around after 255
    report_message: JAUS MESSAGE. The report, with its message id
    """

    CODE = 0x41F1
    NAME = "Event"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    event_id: int
    sequence_number: int
    report_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EventID", rt.Number("B")),
            ("SequenceNumber", rt.Number("B")),
            ("ReportMessage", rt.Blob(rt.Count("I", 0, 4294967295), _registry)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF1 or data[1] != 0x41: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.event_id = data[2]
        self.sequence_number = data[3]
        (report_message_end_,) = _S_I.unpack_from(data, 4)
        report_message_end_ += 8
        self.report_message = (nesting or _registry.nesting).message(data[8:report_message_end_])
        if report_message_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf1\x41")
        out.append(self.event_id)
        out.append(self.sequence_number)
        report_message_raw_ = rt.message_bytes(self.report_message)
        out += _S_I.pack(len(report_message_raw_))
        out += report_message_raw_
        return bytes(out)


_E_CreateEvent_EventType = rt.members(CreateEvent.EventType)
_S_2BH = rt.Packer("<2BH")
_S_I = rt.Packer("<I")
_R_3 = rt.Scaling(0.0, 1092.0, 65535)
_E_UpdateEvent_EventType = rt.members(UpdateEvent.EventType)
_S_2BHB = rt.Packer("<2BHB")
_S_H2B = rt.Packer("<H2B")
_S_H = rt.Packer("<H")
_U_8: tuple[type[QueryEvents.MessageIDRec] | type[core_v1_0_types.EventTypeRec] | type[QueryEvents.EventIDRec] | type[core_v1_0_types.AllEventsRec], ...] = (QueryEvents.MessageIDRec, core_v1_0_types.EventTypeRec, QueryEvents.EventIDRec, core_v1_0_types.AllEventsRec)
_T_9: dict[type[rt.Struct], int] = {QueryEvents.MessageIDRec: 0, core_v1_0_types.EventTypeRec: 1, QueryEvents.EventIDRec: 2, core_v1_0_types.AllEventsRec: 3}
_S_H2BH = rt.Packer("<H2BH")
_S_HB = rt.Packer("<HB")
_M_RejectEventRequest = rt.Masks("3x", ((0, "B"), (1, "B"), (2, "80s")))
_E_RejectEventRequest_ResponseCode = rt.members(RejectEventRequest.ResponseCode)
_M_RejectEventRequest_pack = rt.Masks("HB", ((0, "B"), (1, "B"), (2, "80s")))
_E_ReportEvents_EventType = rt.members(ReportEvents.EventType)
QueryEvents.REPORT = ReportEvents
