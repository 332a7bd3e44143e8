"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages import registry as _registry


@jd.record()
class QueriedNodeRec(jd.Struct):
    """node_id: NodeID or 1..254. Node number"""

    class NodeID(IntEnum):
        RESERVED = 0
        ALL_NODES = 255

    node_id: QueriedNodeRec.NodeID | int = jd.field("NodeID", lambda: jd.Number("B", jd.Values(QueriedNodeRec.NodeID, ((1, 254),))))


@jd.record()
class QueriedComponentRec(jd.Struct):
    """component_id: ComponentID or 1..254. Component number"""

    class ComponentID(IntEnum):
        RESERVED = 0
        ALL_COMPONENTS = 255

    component_id: QueriedComponentRec.ComponentID | int = jd.field("ComponentID", lambda: jd.Number("B", jd.Values(QueriedComponentRec.ComponentID, ((1, 254),))))


@jd.record()
class ServiceRec(jd.Struct):
    """uri: up to 255 characters. Name of the service, as in urn:jaus:jss:core:Liveness
    major_version_number: Version of the service before the point
    minor_version_number: Version of the service after the point
    """
    uri: str = jd.field("URI", jd.Text(count=jd.Count("B", 0, 255)))
    major_version_number: int = jd.field("MajorVersionNumber", jd.Number("B"))
    minor_version_number: int = jd.field("MinorVersionNumber", jd.Number("B"))


@jd.record()
class ComponentRec(jd.Struct):
    """component_id: Component number
    instance_id: Tells components of the same kind apart
    """
    component_id: int = jd.field("ComponentID", jd.Number("B"))
    instance_id: int = jd.field("InstanceID", jd.Number("B"))


@jd.record()
class SubsystemRec(jd.Struct):
    """subsystem_id: Subsystem number
    node_id: Node of the component that answers for the subsystem
    component_id: Component that answers for the subsystem
    """
    subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))
    node_id: int = jd.field("NodeID", jd.Number("B"))
    component_id: int = jd.field("ComponentID", jd.Number("B"))


@jd.record()
class EventTypeRec(jd.Struct):
    """event_type: EventType. When the report is sent"""

    class EventType(IntEnum):
        PERIODIC = 0
        EVERY_CHANGE = 1

    event_type: EventTypeRec.EventType | int = jd.field("EventType", lambda: jd.Number("B", jd.Values(EventTypeRec.EventType)))


@jd.record()
class AllEventsRec(jd.Struct):
    """all_events: 0..0. Always 0; selects all events"""
    all_events: int = jd.field("AllEvents", jd.Number("B", jd.Values(None, ((0, 0),))))


@jd.bit_field("I")
class TimeStamp(jd.Struct):
    """milliseconds: bits 0..9. Milliseconds of the second.
    seconds: bits 10..15. Seconds of the minute.
    minutes: bits 16..21. Minutes of the hour.
    hour: bits 22..26. Hour of the day.
    day: bits 27..31. Day of the month.
    """
    milliseconds: int = jd.bits(0, 0x3FF, jd.Values(None, ((0, 999),)))
    seconds: int = jd.bits(10, 0x3F, jd.Values(None, ((0, 59),)))
    minutes: int = jd.bits(16, 0x3F, jd.Values(None, ((0, 59),)))
    hour: int = jd.bits(22, 0x1F, jd.Values(None, ((0, 23),)))
    day: int = jd.bits(27, 0x1F, jd.Values(None, ((1, 31),)))


@jd.bit_field("H")
class DateStamp(jd.Struct):
    """day: bits 0..4. Day of the month.
    month: bits 5..8. Month of the year.
    year: bits 9..15. Years since 2000.
    """
    day: int = jd.bits(0, 0x1F, jd.Values(None, ((1, 31),)))
    month: int = jd.bits(5, 0xF, jd.Values(None, ((1, 12),)))
    year: int = jd.bits(9, 0x7F, jd.Values(None, ((0, 127),)))


@jd.record()
class ReportEventRec(jd.Struct):
    """event_type: EventType. When the report is sent
    event_id: Identifies the event; chosen by the service
    query_message: JAUS MESSAGE. The query, with its message id, whose report is wanted
    """

    class EventType(IntEnum):
        PERIODIC = 0
        EVERY_CHANGE = 1

    event_type: ReportEventRec.EventType | int = jd.field("EventType", lambda: jd.Number("B", jd.Values(ReportEventRec.EventType)))
    event_id: int = jd.field("EventID", jd.Number("B"))
    query_message: jd.Message | bytes = jd.field("QueryMessage", jd.Blob(jd.Count("I", 0, 2147483647), _registry))


@jd.record()
class ElementRec(jd.Struct):
    """element_uid: Identifies the element
    previous_uid: The element before this one; 0 when it is the first
    next_uid: The element after this one; 0 when it is the last
    element_data: What the element carries
    """

    class ElementDataFormat(IntEnum):
        JAUS_MESSAGE = 0
        USER_DEFINED = 1

    @jd.variable(lambda cls: jd.Formatted(cls, jd.Values(ElementRec.ElementDataFormat), jd.Count("H", 0, 65535), _registry, frozenset({0})))
    class ElementData(jd.Struct):
        """What the element carries."""
        format: ElementRec.ElementDataFormat | int
        data: jd.Message | bytes

    element_uid: int = jd.field("ElementUID", jd.Number("H"))
    previous_uid: int = jd.field("PreviousUID", jd.Number("H"))
    next_uid: int = jd.field("NextUID", jd.Number("H"))
    element_data: ElementRec.ElementData = jd.field("ElementData", lambda: ElementRec.ElementData.layout())


@jd.bit_field("I")
class SourceID(jd.Struct):
    """component_id: bits 0..7. Component number.
    node_id: bits 8..15. Node number.
    subsystem_id: bits 16..31. Subsystem number.
    """
    component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 255),)))
    node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 255),)))
    subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65535),)))


@jd.bit_field("I")
class DestinationID(jd.Struct):
    """component_id: bits 0..7. Component number.
    node_id: bits 8..15. Node number.
    subsystem_id: bits 16..31. Subsystem number.
    """
    component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 255),)))
    node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 255),)))
    subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65535),)))
