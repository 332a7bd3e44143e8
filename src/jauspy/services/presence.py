"""Presence vectors: a report carries what was asked for and what the service has, and nothing else."""

from __future__ import annotations

from dataclasses import MISSING, Field, fields, replace
from functools import cache
from typing import Any, Final

from jauspy.codec.base import Message

_SUFFIX: Final = "presence_vector"


def mask(report: Message, query: Message) -> Message:
    """The report without the optional fields that the query did not ask for.

    A query's `presence_vector` masks the report's body record. A field named after a part of the body, as
    `VelocityVarPresenceVector` is after `VelocityVar`, masks the record in that part.
    """
    for vector, part in _vectors(type(query)):
        asked = getattr(query, vector)
        if not part:
            report = _masked(report, asked)
        elif hasattr(report, part):
            report = replace(report, **{part: _masked(getattr(report, part), asked)})
    return report


@cache
def _vectors(query: type[Message]) -> tuple[tuple[str, str], ...]:
    """Each presence vector of a query, and the part of the report it is about (empty: all of it)."""
    names = (field.name for field in fields(query))
    return tuple((name, name.removesuffix(_SUFFIX).rstrip("_")) for name in names if name.endswith(_SUFFIX))


def _masked(record: Any, asked: int) -> Any:
    unasked = [name for bit, name in enumerate(_optional(type(record))) if not asked >> bit & 1]
    return replace(record, **dict.fromkeys(unasked)) if unasked else record


@cache
def _optional(record: type) -> tuple[str, ...]:
    """The optional fields of a generated record in wire order, which is the order of its bits: None when absent."""
    return tuple(field.name for field in fields(record) if _default(field) is None)


def _default(field: Field[Any]) -> object:
    return MISSING if field.default is MISSING else field.default
