"""Presence vectors (AS5710): a report carries the optional fields that its query requests and the service has."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any, Final, TypeVar

from jauspy.codec.layout import Composite, Repeat, Slot
from jauspy.codec.message import Message, Struct
from jauspy.services.state_machine import Trigger

_SUFFIX: Final = "presence_vector"
_SENSOR_VECTOR: Final = "query_presence_vector"
"""Field of the records of a query about several sensors (AS6060): for the record with the same SensorID; 0 is all."""
_VECTORS: Final[dict[type[Message], tuple[tuple[str, str], ...]]] = {}
_OPTIONAL: Final[dict[type[Struct], tuple[str, ...]]] = {}
_SENSOR_LISTS: Final[dict[type[Message], tuple[str, ...]]] = {}

S = TypeVar("S", bound=Struct)


def requested_report(report: Message, trigger: Trigger) -> Message:
    """The report with the fields that its query requests; all of it when no query triggered it."""
    query = trigger.msg
    return apply_presence_vectors(report, query) if isinstance(query, Message) and not query.IS_COMMAND else report


def apply_presence_vectors(report: Message, query: Message) -> Message:
    """The report without the optional fields that the query does not request.

    A query's `presence_vector` applies to the report's body, or, when nothing in that is optional, to the first record
    in it that has optional fields, or, in a report that is a list, to its records. A vector named after a part of the
    body, as `VelocityVarPresenceVector` is after `VelocityVar` and `LocalPosePresenceVector` after
    `ReportLocalPoseExtRec`, applies to the record in that part, and to all records in it when it requests nothing; one
    of a sensor applies to the records of that sensor.
    """
    for vector, part in _vectors(type(query)):
        requested = getattr(query, vector)
        if not part and _optional(type(report)):
            report = requested_fields(report, requested)
        else:
            report = _requested_in(report, part, requested) or _requested_in_list(report, requested)
    for name in _sensor_lists(type(query)):
        report = _sensors_requested(report, getattr(query, name))
    return report


def _requested_in(whole: S, part: str, requested: int) -> S | None:
    """`whole` with the vector applied to its first record with optional fields in `part`.

    None if there is no such record.
    """
    for slot in _slots(type(whole)):
        member = getattr(whole, slot.name)
        if part in slot.name and isinstance(member, Struct):
            changed = (
                requested_fields(member, requested)
                if _optional(type(member))
                else _requested_inside(member, part, requested)
            )
            if changed is not None:
                whole = copy(whole)
                setattr(whole, slot.name, changed)
                return whole
    return None


def _requested_in_list(report: S, requested: int) -> S:
    """The report with the vector applied to the records of its lists, for a report that has nothing else."""
    slots = _slots(type(report))
    if not all(isinstance(slot.item, Repeat) and isinstance(slot.item.item, Composite) for slot in slots):
        return report
    report = copy(report)
    for slot in slots:
        setattr(report, slot.name, [requested_fields(record, requested) for record in getattr(report, slot.name)])
    return report


def _requested_inside(whole: S, part: str, requested: int) -> S | None:
    if requested or not part:
        return _requested_in(whole, part, requested)
    whole = copy(whole)
    for slot in _slots(type(whole)):
        if isinstance(member := getattr(whole, slot.name), Struct):
            setattr(whole, slot.name, requested_fields(member, 0))
    return whole


def _sensors_requested(report: Message, records: Sequence[Any]) -> Message:
    """The report with the first vector that is for its sensor applied to each record of its lists."""
    report = copy(report)
    for slot in _slots(type(report)):
        if isinstance(slot.item, Repeat):
            setattr(report, slot.name, [_sensor_requested(record, records) for record in getattr(report, slot.name)])
    return report


def _sensor_requested(record: Any, requested: Sequence[Any]) -> Any:
    sensor = getattr(record, "sensor_id", None)
    found = next((record for record in requested if record.sensor_id in (0, sensor)), None)
    return record if sensor is None or found is None else requested_fields(record, found.query_presence_vector)


def _sensor_lists(query: type[Message]) -> tuple[str, ...]:
    """The lists of a query whose records have a vector for each sensor."""
    if (found := _SENSOR_LISTS.get(query)) is None:
        lists = {slot.name: slot.item.item for slot in _slots(query) if isinstance(slot.item, Repeat)}
        found = _SENSOR_LISTS[query] = tuple(
            name
            for name, record in lists.items()
            if isinstance(record, Composite) and any(slot.name == _SENSOR_VECTOR for slot in record.slots)
        )
    return found


def _vectors(query: type[Message]) -> tuple[tuple[str, str], ...]:
    """Each presence vector of a query, and the part of the report it is about (empty: all of it)."""
    if (found := _VECTORS.get(query)) is None:
        names = [slot.name for slot in _slots(query) if slot.name.endswith(_SUFFIX)]
        found = _VECTORS[query] = tuple((name, name.removesuffix(_SUFFIX).rstrip("_")) for name in names)
    return found


def _optional(record: type[Struct]) -> tuple[str, ...]:
    """The optional fields of a record in wire order, which is the order of their bits."""
    if (found := _OPTIONAL.get(record)) is None:
        found = _OPTIONAL[record] = tuple(slot.name for slot in _slots(record) if slot.optional)
    return found


def _slots(kind: type[Struct]) -> tuple[Slot, ...]:
    layout = kind.layout()
    return layout.slots if isinstance(layout, Composite) else ()


def requested_fields(record: S, requested: int) -> S:
    """The record without the optional fields that were not requested: bit i requests the i-th of them."""
    optional = enumerate(_optional(type(record)))
    unrequested = [name for bit, name in optional if not requested >> bit & 1 and getattr(record, name) is not None]
    if unrequested:
        record = copy(record)
        for name in unrequested:
            setattr(record, name, None)
    return record
