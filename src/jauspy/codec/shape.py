"""Whether two layouts are the same on the wire: same bytes, same numbers, whatever their parts are called."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import IntEnum
from typing import Any, Final

from jauspy.codec.items import Item

_NAMES: Final = frozenset(("cls", "name", "jaus", "units"))


def same_layout(one: Item, other: Item) -> bool:
    """True when the same bytes are the same values."""
    return bool(_shape(one) == _shape(other))


def _shape(part: Any) -> Any:
    if is_dataclass(part):
        inside = (_shape(getattr(part, field.name)) for field in fields(part) if field.name not in _NAMES)
        return (type(part).__name__, *inside)
    if isinstance(part, type) and issubclass(part, IntEnum):
        return tuple(map(int, part))
    if isinstance(part, Mapping):
        return tuple((key if isinstance(key, int) else "", _shape(value)) for key, value in part.items())
    if isinstance(part, tuple):
        return tuple(map(_shape, part))
    if part is None or isinstance(part, (str, int, float, frozenset)):
        return part
    return type(part).__name__  # a registry: the one of whoever made the layout
