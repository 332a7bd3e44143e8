"""Ids inside messages, as of who is in control or of a component in a list, changed to other ids."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import Any, Final, TypeAlias

from jauspy.codec.message import Message, Struct
from jauspy.ids import JausID

Change: TypeAlias = Callable[[JausID], JausID]

_SUBSYSTEM, _NODE, _COMPONENT = "subsystem_id", "node_id", "component_id"
_LONE_SUBSYSTEM: Final = "subsystem_rec"
"""The field of lists of subsystems, nodes and components, in which a subsystem has its number alone."""


def with_other_ids(message: Message, change: Change) -> Message:
    """A message with each id in it changed, also in the messages inside; the same object if none changes.

    An id is a structure, or a part of one, with a subsystem, a node and a component whose names begin alike, as
    `src_subsystem_id`, `src_node_id` and `src_component_id`. In lists of subsystems the number of the subsystem is
    changed, too.
    """
    changed: Message = _changed(message, "", change)
    return changed


def has_ids(kind: type[Struct], name: str = "") -> bool:
    """True if a structure has an id, not counting those of the structures in it; `name` is that of its field."""
    return bool(_prefixes(kind)) or (name == _LONE_SUBSYSTEM and _SUBSYSTEM in _names(kind))


def _changed(value: Any, name: str, change: Change) -> Any:
    if isinstance(value, Struct):
        return _changed_struct(value, name, change)
    if isinstance(value, Sequence) and not isinstance(value, str | bytes | bytearray | memoryview):
        found = [_changed(item, name, change) for item in value]
        if all(new is old for new, old in zip(found, value, strict=True)):
            return value
        return found if isinstance(value, list) else tuple(found)
    return value


def _changed_struct(value: Struct, name: str, change: Change) -> Struct:
    kind = type(value)
    new: dict[str, Any] = {}
    for field in _names(kind):
        inner = getattr(value, field)
        found = _changed(inner, field, change)
        if found is not inner:
            new[field] = found
    prefixes = _prefixes(kind)
    for prefix in prefixes:
        names = [prefix + part for part in (_SUBSYSTEM, _NODE, _COMPONENT)]
        before = _id([getattr(value, part) for part in names])
        if before is not None and (after := change(before)) != before:
            new.update(zip(names, (after.subsystem, after.node, after.component), strict=True))
    if not prefixes and has_ids(kind, name):
        before = _id([getattr(value, _SUBSYSTEM), 1, 1])
        if before is not None and (after := change(before)) != before:
            new[_SUBSYSTEM] = after.subsystem
    changed: Any = replace(value, **new) if new else value  # type: ignore[type-var]  # structures are dataclasses
    return changed  # type: ignore[no-any-return]


def _id(parts: list[Any]) -> JausID | None:
    try:
        return JausID(*map(int, parts))
    except (TypeError, ValueError):  # an absent part, or numbers that are no id, as 0.0.0 for nobody
        return None


def _names(kind: type[Struct]) -> tuple[str, ...]:
    return tuple(field.name for field in fields(kind))  # type: ignore[arg-type]  # structures are dataclasses


def _prefixes(kind: type[Struct]) -> tuple[str, ...]:
    names = set(_names(kind))
    starts = (name.removesuffix(_SUBSYSTEM) for name in names if name.endswith(_SUBSYSTEM))
    return tuple(sorted(start for start in starts if {start + _NODE, start + _COMPONENT} <= names))
