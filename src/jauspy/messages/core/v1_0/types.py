"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt
from jauspy.messages import registry as _registry


@dataclass(slots=True, repr=False)
class QueriedNodeRec(rt.Struct):
    """QueriedNodeRec.

    node_id: NodeID or 1..254. Node number
    """

    class NodeID(IntEnum):
        """Values of NodeID."""

        RESERVED = 0
        ALL_NODES = 255

    node_id: QueriedNodeRec.NodeID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NodeID", rt.Number("B", rt.Values(QueriedNodeRec.NodeID, ((1, 254),)))),
        )


@dataclass(slots=True, repr=False)
class QueriedComponentRec(rt.Struct):
    """QueriedComponentRec.

    component_id: ComponentID or 1..254. Component number
    """

    class ComponentID(IntEnum):
        """Values of ComponentID."""

        RESERVED = 0
        ALL_COMPONENTS = 255

    component_id: QueriedComponentRec.ComponentID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ComponentID", rt.Number("B", rt.Values(QueriedComponentRec.ComponentID, ((1, 254),)))),
        )


@dataclass(slots=True, repr=False)
class ServiceRec(rt.Struct):
    """ServiceRec.

    uri: up to 255 characters. Name of the service, as in urn:jaus:jss:core:Liveness
    major_version_number: Version of the service before the point
    minor_version_number: Version of the service after the point
    """

    uri: str
    major_version_number: int
    minor_version_number: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("URI", rt.Text(count=rt.Count("B", 0, 255))),
            ("MajorVersionNumber", rt.Number("B")),
            ("MinorVersionNumber", rt.Number("B")),
        )


@dataclass(slots=True, repr=False)
class ComponentRec(rt.Struct):
    """ComponentRec.

    component_id: Component number
    instance_id: Tells components of the same kind apart
    """

    component_id: int
    instance_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ComponentID", rt.Number("B")),
            ("InstanceID", rt.Number("B")),
        )


@dataclass(slots=True, repr=False)
class SubsystemRec(rt.Struct):
    """SubsystemRec.

    subsystem_id: Subsystem number
    node_id: Node of the component that answers for the subsystem
    component_id: Component that answers for the subsystem
    """

    subsystem_id: int
    node_id: int
    component_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SubsystemID", rt.Number("H")),
            ("NodeID", rt.Number("B")),
            ("ComponentID", rt.Number("B")),
        )


@dataclass(slots=True, repr=False)
class EventTypeRec(rt.Struct):
    """EventTypeRec.

    event_type: EventType. When the report is sent
    """

    class EventType(IntEnum):
        """Values of EventType."""

        PERIODIC = 0
        EVERY_CHANGE = 1

    event_type: EventTypeRec.EventType | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EventType", rt.Number("B", rt.Values(EventTypeRec.EventType))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        event_type_ = data[at]
        self.event_type = _E_EventTypeRec_EventType[event_type_]
        return self, at + 1

    def _write(self, out: bytearray) -> None:
        event_type_ = self.event_type
        if event_type_ not in _E_EventTypeRec_EventType: raise rt.Reject
        out.append(event_type_)


@dataclass(slots=True, repr=False)
class AllEventsRec(rt.Struct):
    """AllEventsRec.

    all_events: 0..0. Always 0; selects all events
    """

    all_events: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AllEvents", rt.Number("B", rt.Values(None, ((0, 0),)))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        all_events_ = data[at]
        if all_events_ > 0: raise rt.Reject
        self.all_events = all_events_
        return self, at + 1

    def _write(self, out: bytearray) -> None:
        all_events_ = self.all_events
        if not 0 <= all_events_ <= 0: raise rt.Reject
        out.append(all_events_)


@dataclass(slots=True, repr=False)
class ReportEventRec(rt.Struct):
    """ReportEventRec.

    event_type: EventType. When the report is sent
    event_id: Identifies the event; chosen by the service
    query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
    """

    class EventType(IntEnum):
        """Values of EventType."""

        PERIODIC = 0
        EVERY_CHANGE = 1

    event_type: ReportEventRec.EventType | int
    event_id: int
    query_message: rt.Message | bytes

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("EventType", rt.Number("B", rt.Values(ReportEventRec.EventType))),
            ("EventID", rt.Number("B")),
            ("QueryMessage", rt.Blob(rt.Count("I", 0, 2147483647), _registry)),
        )


@dataclass(slots=True, repr=False)
class ElementRec(rt.Struct):
    """ElementRec.

    element_uid: Identifies the element
    previous_uid: The element before this one; 0 when it is the first
    next_uid: The element after this one; 0 when it is the last
    element_data: What the element carries
    """

    class ElementDataFormat(IntEnum):
        """Values of ElementDataFormat."""

        JAUS_MESSAGE = 0
        USER_DEFINED = 1

    @dataclass(slots=True, repr=False)
    class ElementData(rt.Struct):
        """What the element carries."""

        format: ElementRec.ElementDataFormat | int
        data: rt.Message | bytes

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Formatted(cls, rt.Values(ElementRec.ElementDataFormat), rt.Count("H", 0, 65535), _registry, frozenset({0}))

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            format = data[at]
            self.format = _E_ElementRec_ElementDataFormat[format]
            (data_end_,) = _S_H.unpack_from(data, at + 1)
            data_end_ += at + 3
            self.data = (nesting or _registry.nesting).message(data[at + 3:data_end_]) if format in {0} else data[at + 3:data_end_]
            return self, data_end_

        def _write(self, out: bytearray) -> None:
            format = self.format
            if format not in _E_ElementRec_ElementDataFormat: raise rt.Reject
            out.append(format)
            data_raw_ = rt.message_bytes(self.data) if format in {0} else rt.plain_bytes(self.data)
            out += _S_H.pack(len(data_raw_))
            out += data_raw_

    element_uid: int
    previous_uid: int
    next_uid: int
    element_data: ElementRec.ElementData

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ElementUID", rt.Number("H")),
            ("PreviousUID", rt.Number("H")),
            ("NextUID", rt.Number("H")),
            ("ElementData", ElementRec.ElementData.layout()),
        )


@dataclass(slots=True, repr=False)
class TimeStamp(rt.Struct):
    """TimeStamp.

    milliseconds: bits 0..9. Milliseconds of the second.
    seconds: bits 10..15. Seconds of the minute.
    minutes: bits 16..21. Minutes of the hour.
    hour: bits 22..26. Hour of the day.
    day: bits 27..31. Day of the month.
    """

    milliseconds: int
    seconds: int
    minutes: int
    hour: int
    day: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "I",
            (
                rt.Bit("milliseconds", 0, 0x3FF, rt.Values(None, ((0, 999),))),
                rt.Bit("seconds", 10, 0x3F, rt.Values(None, ((0, 59),))),
                rt.Bit("minutes", 16, 0x3F, rt.Values(None, ((0, 59),))),
                rt.Bit("hour", 22, 0x1F, rt.Values(None, ((0, 23),))),
                rt.Bit("day", 27, 0x1F, rt.Values(None, ((1, 31),))),
            ),
        )


@dataclass(slots=True, repr=False)
class DateStamp(rt.Struct):
    """DateStamp.

    day: bits 0..4. Day of the month.
    month: bits 5..8. Month of the year.
    year: bits 9..15. Years since 2000.
    """

    day: int
    month: int
    year: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "H",
            (
                rt.Bit("day", 0, 0x1F, rt.Values(None, ((1, 31),))),
                rt.Bit("month", 5, 0xF, rt.Values(None, ((1, 12),))),
                rt.Bit("year", 9, 0x7F, rt.Values(None, ((0, 127),))),
            ),
        )


@dataclass(slots=True, repr=False)
class SourceID(rt.Struct):
    """SourceID.

    component_id: bits 0..7. Component number.
    node_id: bits 8..15. Node number.
    subsystem_id: bits 16..31. Subsystem number.
    """

    component_id: int
    node_id: int
    subsystem_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "I",
            (
                rt.Bit("component_id", 0, 0xFF, rt.Values(None, ((1, 255),))),
                rt.Bit("node_id", 8, 0xFF, rt.Values(None, ((1, 255),))),
                rt.Bit("subsystem_id", 16, 0xFFFF, rt.Values(None, ((1, 65535),))),
            ),
        )


@dataclass(slots=True, repr=False)
class DestinationID(rt.Struct):
    """DestinationID.

    component_id: bits 0..7. Component number.
    node_id: bits 8..15. Node number.
    subsystem_id: bits 16..31. Subsystem number.
    """

    component_id: int
    node_id: int
    subsystem_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "I",
            (
                rt.Bit("component_id", 0, 0xFF, rt.Values(None, ((1, 255),))),
                rt.Bit("node_id", 8, 0xFF, rt.Values(None, ((1, 255),))),
                rt.Bit("subsystem_id", 16, 0xFFFF, rt.Values(None, ((1, 65535),))),
            ),
        )


_E_EventTypeRec_EventType = rt.members(EventTypeRec.EventType)
_E_ElementRec_ElementDataFormat = rt.members(ElementRec.ElementDataFormat)
_S_H = rt.Packer("<H")
