"""urn:jaus:jss:core:Events 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages import registry as _registry
from jauspy.messages.core.v1_0 import events as core_v1_0_events
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
    VERSION = "1.1"
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
            ("QueryMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
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
        if query_message_end_ > 2147483647: raise rt.Reject
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
        if len(query_message_raw_) > 2147483647: raise rt.Reject
        out += _S_I.pack(len(query_message_raw_))
        out += query_message_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class CreateCommandEvent(rt.Message):
    """CreateCommandEvent (0x01F6): Sends a command whose completion the client wants to be told.

    request_id: Chosen by the client; the answer repeats it
    maximum_allowed_duration: in second. Time that the command may take, in seconds
    command_message: JAUS MESSAGE. The command, with its message id
    """

    CODE = 0x01F6
    NAME = "CreateCommandEvent"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    request_id: int
    maximum_allowed_duration: int
    command_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("B")),
            ("MaximumAllowedDuration", rt.Number("I", rt.ANY, "second")),
            ("CommandMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF6 or data[1] != 0x01: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.request_id, self.maximum_allowed_duration = _S_BI.unpack_from(data, 2)
        (command_message_end_,) = _S_I.unpack_from(data, 7)
        if command_message_end_ > 2147483647: raise rt.Reject
        command_message_end_ += 11
        self.command_message = (nesting or _registry.nesting).message(data[11:command_message_end_])
        if command_message_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf6\x01")
        out += _S_BI.pack(self.request_id, self.maximum_allowed_duration)
        command_message_raw_ = rt.message_bytes(self.command_message)
        if len(command_message_raw_) > 2147483647: raise rt.Reject
        out += _S_I.pack(len(command_message_raw_))
        out += command_message_raw_
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
    VERSION = "1.1"
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
            ("QueryMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
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
        if query_message_end_ > 2147483647: raise rt.Reject
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
        if len(query_message_raw_) > 2147483647: raise rt.Reject
        out += _S_I.pack(len(query_message_raw_))
        out += query_message_raw_
        return bytes(out)


class CancelEvent(core_v1_0_events.CancelEvent):
    """CancelEvent (0x01F2): Ends an event."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class QueryEvents(rt.Message):
    """QueryEvents (0x21F0): Asks for the events of the component, selected by message, type or identifier.

    query_events_var: How to select the events
    """

    CODE = 0x21F0
    NAME = "QueryEvents"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"
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
class QueryEventTimeout(rt.Message):
    """QueryEventTimeout (0x21F2): Asks after how long events end unless they are renewed."""

    CODE = 0x21F2
    NAME = "QueryEventTimeout"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEventTimeout]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\xf2!': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x21F2)


class ConfirmEventRequest(core_v1_0_events.ConfirmEventRequest):
    """ConfirmEventRequest (0x01F3): Answers a request about an event that has been carried out."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"


class RejectEventRequest(core_v1_0_events.RejectEventRequest):
    """RejectEventRequest (0x01F4): Answers a request about an event that has been refused, and why."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportEvents(rt.Message):
    """ReportEvents (0x41F0): Lists events of the component.

    event_list: 0..255 items. The events
    """

    CODE = 0x41F0
    NAME = "ReportEvents"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    ReportEventRec = core_v1_0_types.ReportEventRec

    event_list: list[core_v1_0_types.ReportEventRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EventList", rt.Repeat(rt.Count("B", 0, 255), core_v1_0_types.ReportEventRec.layout())),
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
            item_ = rt.new(core_v1_0_types.ReportEventRec)
            event_type_ = data[at]
            item_.event_id = data[at + 1]
            item_.event_type = _E_ReportEventRec_EventType[event_type_]
            (query_message_end_,) = _S_I.unpack_from(data, at + 2)
            if query_message_end_ > 2147483647: raise rt.Reject
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
            if type(item_) is not core_v1_0_types.ReportEventRec: raise rt.Reject
            event_type_ = item_.event_type
            if event_type_ not in _E_ReportEventRec_EventType: raise rt.Reject
            out.append(event_type_)
            out.append(item_.event_id)
            query_message_raw_ = rt.message_bytes(item_.query_message)
            if len(query_message_raw_) > 2147483647: raise rt.Reject
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
    VERSION = "1.1"
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
            ("ReportMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF1 or data[1] != 0x41: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.event_id = data[2]
        self.sequence_number = data[3]
        (report_message_end_,) = _S_I.unpack_from(data, 4)
        if report_message_end_ > 2147483647: raise rt.Reject
        report_message_end_ += 8
        self.report_message = (nesting or _registry.nesting).message(data[8:report_message_end_])
        if report_message_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf1\x41")
        out.append(self.event_id)
        out.append(self.sequence_number)
        report_message_raw_ = rt.message_bytes(self.report_message)
        if len(report_message_raw_) > 2147483647: raise rt.Reject
        out += _S_I.pack(len(report_message_raw_))
        out += report_message_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class CommandEvent(rt.Message):
    """CommandEvent (0x41F6): Tells how a command has ended.

    event_id: Identifies the event; chosen by the service
    command_result: CommandResult. How the command ended
    """

    CODE = 0x41F6
    NAME = "CommandEvent"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class CommandResult(IntEnum):
        """Values of CommandResult."""

        SUCCESSFUL = 0
        UNSUCCESSFUL = 1

    event_id: int
    command_result: CommandEvent.CommandResult | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EventID", rt.Number("B")),
            ("CommandResult", rt.Number("B", rt.Values(CommandEvent.CommandResult))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.event_id, command_result_ = _S_H2B.unpack(data)
        if code != 0x41F6: raise rt.Reject
        self.command_result = _E_CommandEvent_CommandResult[command_result_]
        return self

    def _pack(self) -> bytes:
        command_result_ = self.command_result
        if command_result_ not in _E_CommandEvent_CommandResult: raise rt.Reject
        return _S_H2B.pack(0x41F6, self.event_id, command_result_)


@dataclass(slots=True, repr=False)
class ReportEventTimeout(rt.Message):
    """ReportEventTimeout (0x41F2): Tells after how long events end unless they are renewed.

    timeout: Timeout or 1..255 in minute. Time after the last renewal; 0 means that there is no timeout
    """

    CODE = 0x41F2
    NAME = "ReportEventTimeout"
    SERVICE = "urn:jaus:jss:core:Events"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class Timeout(IntEnum):
        """Values of Timeout."""

        TIMEOUT_FEATURE_DISABLED = 0

    timeout: ReportEventTimeout.Timeout | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Timeout", rt.Number("B", rt.Values(ReportEventTimeout.Timeout, ((1, 255),)), "minute")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, timeout_ = _S_HB.unpack(data)
        if code != 0x41F2: raise rt.Reject
        self.timeout = _E_ReportEventTimeout_Timeout.get(timeout_, timeout_)
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x41F2, self.timeout)


_E_CreateEvent_EventType = rt.members(CreateEvent.EventType)
_S_2BH = rt.Packer("<2BH")
_S_I = rt.Packer("<I")
_R_3 = rt.Scaling(0.0, 1092.0, 65535)
_S_BI = rt.Packer("<BI")
_E_UpdateEvent_EventType = rt.members(UpdateEvent.EventType)
_S_2BHB = rt.Packer("<2BHB")
_S_H = rt.Packer("<H")
_U_8: tuple[type[QueryEvents.MessageIDRec] | type[core_v1_0_types.EventTypeRec] | type[QueryEvents.EventIDRec] | type[core_v1_0_types.AllEventsRec], ...] = (QueryEvents.MessageIDRec, core_v1_0_types.EventTypeRec, QueryEvents.EventIDRec, core_v1_0_types.AllEventsRec)
_T_9: dict[type[rt.Struct], int] = {QueryEvents.MessageIDRec: 0, core_v1_0_types.EventTypeRec: 1, QueryEvents.EventIDRec: 2, core_v1_0_types.AllEventsRec: 3}
_E_ReportEventRec_EventType = rt.members(core_v1_0_types.ReportEventRec.EventType)
_E_CommandEvent_CommandResult = rt.members(CommandEvent.CommandResult)
_S_H2B = rt.Packer("<H2B")
_E_ReportEventTimeout_Timeout = rt.members(ReportEventTimeout.Timeout)
_S_HB = rt.Packer("<HB")
QueryEvents.REPORT = ReportEvents
QueryEventTimeout.REPORT = ReportEventTimeout
