"""Paths of the fields in a message, as in `joint_position_list[0].joint_position.value`, with their values.

Names of nested fields are joined by dots, elements of lists have their numbers in brackets, and an alternative of a
variant has its name: the paths of errors (`EncodeError.path`) and explanations are written in the same way.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields
from functools import cache
from typing import Any, Final

from jauspy.codec.items import Item, join
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Struct

_NO_ARMS: Final[Mapping[type, str]] = {}
_RESERVED: Final = "reserved_presence"
"""Bits of a presence vector without a field; like `to_dict`, paths have it only if there are any."""
_PLAIN: Final = (float, int, str)
_NUMBER: Final = re.compile(r"\[\d+\]")


def leaves(value: object, path: str = "") -> Iterator[tuple[str, Any]]:
    """Path and value of each field without fields of its own, in a message or its JSON form; absent ones are left out.

    Values in a message are numbers, enumerations, texts and bytes; those in JSON are what `to_dict` makes of them.
    """
    return _leaves(value, path, _NO_ARMS)


def path_pattern(end: str) -> re.Pattern[str]:
    """A pattern of the paths that end with these names; names of lists without a number stand for all elements."""
    names = r"\.".join(re.escape(name) + r"(?:\[\d+\])*" for name in end.split("."))
    return re.compile(rf"(?:^|\.){names}$")


def without_numbers(path: str) -> str:
    """The path without the numbers of elements, which is the same for all elements of a list."""
    return _NUMBER.sub("", path) if "[" in path else path


def _leaves(value: object, path: str, arms: Mapping[type, str]) -> Iterator[tuple[str, Any]]:
    if isinstance(value, Struct):
        kind: Any = type(value)
        if kind in arms:
            path = join(path, arms[kind])
        for name, inner_arms in _members(kind):
            inner = getattr(value, name)
            if inner is None or (not inner and name == _RESERVED):
                continue
            inner_path = f"{path}.{name}" if path else name
            if isinstance(inner, _PLAIN):  # nearly always; saves a generator
                yield inner_path, inner
            else:
                yield from _leaves(inner, inner_path, inner_arms)
    elif isinstance(value, Mapping):
        for name, inner in value.items():
            yield from _leaves(inner, f"{path}.{name}" if path else str(name), _NO_ARMS)
    elif isinstance(value, list | tuple):
        for number, inner in enumerate(value):
            yield from _leaves(inner, f"{path}[{number}]", arms)
    elif value is not None:
        yield path, value


@cache
def _members(kind: Any) -> tuple[tuple[str, Mapping[type, str]], ...]:
    """The fields of a class of messages or of their parts, with the names of a variant's alternatives by class."""
    layout = kind.layout()
    items = {slot.name: slot.item for slot in layout.slots} if isinstance(layout, Composite) else {}
    return tuple((field.name, _arms(items.get(field.name))) for field in fields(kind))


def _arms(item: Item | None) -> Mapping[type, str]:
    while isinstance(item, Repeat | Grid):
        item = item.item
    return {arm.cls: name for name, arm in item.arms.items()} if isinstance(item, Union) else _NO_ARMS
