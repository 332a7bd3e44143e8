"""Presence vectors: a report carries what was asked for and what the service has, and nothing else."""

from __future__ import annotations

from copy import copy
from typing import Final, TypeVar

from jauspy.codec.base import Message, Struct
from jauspy.codec.layout import Composite, Slot

_SUFFIX: Final = "presence_vector"
_VECTORS: Final[dict[type[Message], tuple[tuple[str, str], ...]]] = {}
_OPTIONAL: Final[dict[type[Struct], tuple[str, ...]]] = {}

S = TypeVar("S", bound=Struct)


def mask(report: Message, query: Message) -> Message:
    """The report without the optional fields that the query did not ask for.

    A query's `presence_vector` masks the report's body record. A field named after a part of the body, as
    `VelocityVarPresenceVector` is after `VelocityVar`, masks the record in that part.
    """
    found = report
    for vector, part in _vectors(type(query)):
        asked = getattr(query, vector)
        if not part:
            found = masked(found, asked)
        elif hasattr(found, part):
            found = copy(found)
            setattr(found, part, masked(getattr(found, part), asked))
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


def masked(record: S, asked: int) -> S:
    """The record without the optional fields that were not asked for: bit i asks for the i-th of them."""
    optional = enumerate(_optional(type(record)))
    unasked = [name for bit, name in optional if not asked >> bit & 1 and getattr(record, name) is not None]
    if unasked:
        record = copy(record)
        for name in unasked:
            setattr(record, name, None)
    return record
