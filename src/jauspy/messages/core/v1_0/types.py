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
        return rt.Composite(
            cls,
            (
                rt.Slot("node_id", "NodeID", rt.Number("B", rt.Values(QueriedNodeRec.NodeID, ((1, 254),)))),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        node_id_ = data[at]
        at += 1
        node_id_ = _E_QueriedNodeRec_NodeID.get(node_id_, node_id_)
        return cls(node_id_), at

    def _write(self, out: bytearray) -> None:
        node_id_ = self.node_id
        out += _S_B.pack(node_id_)


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
        return rt.Composite(
            cls,
            (
                rt.Slot("component_id", "ComponentID", rt.Number("B", rt.Values(QueriedComponentRec.ComponentID, ((1, 254),)))),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        component_id_ = data[at]
        at += 1
        component_id_ = _E_QueriedComponentRec_ComponentID.get(component_id_, component_id_)
        return cls(component_id_), at

    def _write(self, out: bytearray) -> None:
        component_id_ = self.component_id
        out += _S_B.pack(component_id_)


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
        return rt.Composite(
            cls,
            (
                rt.Slot("uri", "URI", rt.Text(count=rt.Count("B", 0, 255))),
                rt.Slot("major_version_number", "MajorVersionNumber", rt.Number("B")),
                rt.Slot("minor_version_number", "MinorVersionNumber", rt.Number("B")),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        size = len(data)
        uri_end = data[at]
        at += 1
        uri_end += at
        if uri_end > size:
            raise rt.Reject
        uri_ = data[at:uri_end].decode("latin-1")
        at = uri_end
        major_version_number_, minor_version_number_ = _S_2B.unpack_from(data, at)
        at += 2
        return cls(uri_, major_version_number_, minor_version_number_), at

    def _write(self, out: bytearray) -> None:
        uri_ = self.uri
        uri_raw = uri_.encode("latin-1")
        out.append(len(uri_raw))
        out += uri_raw
        major_version_number_ = self.major_version_number
        minor_version_number_ = self.minor_version_number
        out += _S_2B.pack(major_version_number_, minor_version_number_)


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
        return rt.Composite(
            cls,
            (
                rt.Slot("component_id", "ComponentID", rt.Number("B")),
                rt.Slot("instance_id", "InstanceID", rt.Number("B")),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        component_id_, instance_id_ = _S_2B.unpack_from(data, at)
        at += 2
        return cls(component_id_, instance_id_), at

    def _write(self, out: bytearray) -> None:
        component_id_ = self.component_id
        instance_id_ = self.instance_id
        out += _S_2B.pack(component_id_, instance_id_)


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
        return rt.Composite(
            cls,
            (
                rt.Slot("subsystem_id", "SubsystemID", rt.Number("H")),
                rt.Slot("node_id", "NodeID", rt.Number("B")),
                rt.Slot("component_id", "ComponentID", rt.Number("B")),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        subsystem_id_, node_id_, component_id_ = _S_H2B.unpack_from(data, at)
        at += 4
        return cls(subsystem_id_, node_id_, component_id_), at

    def _write(self, out: bytearray) -> None:
        subsystem_id_ = self.subsystem_id
        node_id_ = self.node_id
        component_id_ = self.component_id
        out += _S_H2B.pack(subsystem_id_, node_id_, component_id_)


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
        return rt.Composite(
            cls,
            (
                rt.Slot("event_type", "EventType", rt.Number("B", rt.Values(EventTypeRec.EventType))),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        event_type_ = data[at]
        at += 1
        event_type_ = _E_EventTypeRec_EventType[event_type_]
        return cls(event_type_), at

    def _write(self, out: bytearray) -> None:
        event_type_ = self.event_type
        if event_type_ not in _E_EventTypeRec_EventType:
            raise rt.Reject
        out += _S_B.pack(event_type_)


@dataclass(slots=True, repr=False)
class AllEventsRec(rt.Struct):
    """AllEventsRec.

    all_events: 0..0. Always 0; selects all events
    """

    all_events: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("all_events", "AllEvents", rt.Number("B", rt.Values(None, ((0, 0),)))),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        all_events_ = data[at]
        at += 1
        if all_events_ > 0:
            raise rt.Reject
        return cls(all_events_), at

    def _write(self, out: bytearray) -> None:
        all_events_ = self.all_events
        if not 0 <= all_events_ <= 0:
            raise rt.Reject
        out += _S_B.pack(all_events_)


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
        def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
            size = len(data)
            format = data[at]
            at += 1
            (data_end,) = _S_H.unpack_from(data, at)
            at += 2
            data_end += at
            if data_end > size:
                raise rt.Reject
            chunk = data[at:data_end]
            content: rt.Message | bytes = chunk
            if format == 0:
                content = _registry.nested(chunk, depth)
            return cls(_E_ElementRec_ElementDataFormat[format], content), data_end

        def _write(self, out: bytearray) -> None:
            format = self.format
            if format not in _E_ElementRec_ElementDataFormat:
                raise rt.Reject
            raw = rt.message_bytes(self.data) if format == 0 else rt.plain_bytes(self.data)
            out.append(format)
            out += _S_H.pack(len(raw))
            out += raw

    element_uid: int
    previous_uid: int
    next_uid: int
    element_data: ElementRec.ElementData

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(
            cls,
            (
                rt.Slot("element_uid", "ElementUID", rt.Number("H")),
                rt.Slot("previous_uid", "PreviousUID", rt.Number("H")),
                rt.Slot("next_uid", "NextUID", rt.Number("H")),
                rt.Slot("element_data", "ElementData", ElementRec.ElementData.layout()),
            ),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:
        element_uid_, previous_uid_, next_uid_ = _S_3H.unpack_from(data, at)
        at += 6
        element_data_, at = ElementRec.ElementData._read(data, at, depth)
        return cls(element_uid_, previous_uid_, next_uid_, element_data_), at

    def _write(self, out: bytearray) -> None:
        element_uid_ = self.element_uid
        previous_uid_ = self.previous_uid
        next_uid_ = self.next_uid
        out += _S_3H.pack(element_uid_, previous_uid_, next_uid_)
        element_data_ = self.element_data
        if type(element_data_) is not ElementRec.ElementData:
            raise rt.Reject
        element_data_._write(out)


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


_E_QueriedNodeRec_NodeID = {member.value: member for member in QueriedNodeRec.NodeID}
_S_B = rt.Packer("<B")
_E_QueriedComponentRec_ComponentID = {member.value: member for member in QueriedComponentRec.ComponentID}
_S_2B = rt.Packer("<2B")
_S_H2B = rt.Packer("<H2B")
_E_EventTypeRec_EventType = {member.value: member for member in EventTypeRec.EventType}
_S_H = rt.Packer("<H")
_E_ElementRec_ElementDataFormat = {member.value: member for member in ElementRec.ElementDataFormat}
_S_3H = rt.Packer("<3H")
