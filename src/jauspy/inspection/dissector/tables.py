"""Tables of a Lua dissector: what the layouts of messages say, as Lua source.

Text of a definition becomes source through `quoted` only, numbers through `number`, names of filters through `_Paths`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any, Final, TypeAlias

from jauspy.codec import items, layout
from jauspy.codec.items import ANY, Item, Values
from jauspy.codec.message import Message
from jauspy.codec.names import set_package, snake, unique, unit_symbol
from jauspy.printable import printable

Node: TypeAlias = dict[Any, Any]
"""A table of Lua: keys are names of fields, `items` are its array part."""

_ESCAPED: Final = re.compile(rb"[^ !#-\[\]-~]")
"""Bytes that a Lua string in double quotes does not have as they are."""
_PATH: Final = re.compile(r"[a-z0-9_.]+")
ARRAY: Final = ""
"""The key of a table's array part."""
_OWN_NAMES: Final = frozenset(
    {"data", "destination", "failed", "fragment", "header", "limit", "malformed", "message", "old_header"}
    | {"reassembled", "source", "unknown"}
)
"""Names behind `jaus.` that the dissector itself uses."""


def quoted(text: str) -> str:
    r"""A Lua string literal; all but plain ASCII characters is written as `\ddd`."""
    data = _ESCAPED.sub(lambda found: b"\\%03d" % found[0][0], printable(text).encode("utf-8", "replace"))
    return f'"{data.decode("ascii")}"'


def number(value: float) -> str:
    """A Lua number."""
    if isinstance(value, int):
        return str(int(value))
    if math.isnan(value):
        return "(0/0)"
    return repr(float(value)) if math.isfinite(value) else f"{'-' if value < 0 else ''}math.huge"


def source(value: Any) -> str:
    """A value as a Lua expression: texts, numbers, true, lists, tables. Keys are ours or numbers."""
    match value:
        case True:
            return "true"
        case int() | float():
            return number(value)
        case str():
            return quoted(value)
        case list() | tuple():
            return "{" + ",".join(map(source, value)) + "}"
        case dict():
            parts = [f"{_key(key)}={source(part)}" for key, part in value.items() if key != ARRAY]
            return "{" + ",".join([*parts, *map(source, value.get(ARRAY, ()))]) + "}"
    raise TypeError(type(value).__name__)


def _key(key: str | int) -> str:
    return key if isinstance(key, str) else f"[{number(key)}]"


class Tables:
    """The tables of all messages; equal enumerations are written once."""

    def __init__(self) -> None:
        self.enums: dict[tuple[tuple[int, str], ...], int] = {}
        """Numbers of the enumerations, from 1."""
        self.fields = 0
        """Fields that filters can name."""
        self._prefixes: set[str] = set()

    def message(self, kind: type[Message]) -> Node:
        """The table of a message."""
        package = set_package(kind.SERVICE)
        package = f"{package}_set" if package in _OWN_NAMES else package
        prefix = unique(f"jaus.{package}.{snake(kind.NAME) or 'unnamed'}", self._prefixes.__contains__)
        self._prefixes.add(prefix)
        body = _Body(self, prefix).node(kind.layout(), kind.NAME, prefix)
        body["inline"] = True
        return {"name": kind.NAME, "service": kind.SERVICE, "version": kind.VERSION, "body": body}

    def enum(self, names: Mapping[int, str]) -> int:
        """The number of an enumeration."""
        return self.enums.setdefault(tuple(sorted(names.items())), len(self.enums) + 1)


class _Body:
    """Makes the tables of one message, in which each field has a path of its own."""

    def __init__(self, tables: Tables, prefix: str) -> None:
        self._tables = tables
        self._taken = {prefix}

    def _path(self, wanted: str) -> str:
        path = unique(wanted, self._taken.__contains__)
        if not _PATH.fullmatch(path):
            raise ValueError(f"{path!r} is not the name of a filter")
        self._taken.add(path)
        self._tables.fields += 1
        return path

    def node(self, item: Item, name: str, path: str) -> Node:
        """The table of an item that is shown by `name`, and filtered by `path`."""
        match item:
            case layout.Composite():
                return self._record(item, name, path)
            case layout.Repeat():
                return self._list(item, name, path)
            case layout.Union():
                arms = [self.node(arm, arm_name, f"{path}.{arm_name}") for arm_name, arm in item.arms.items()]
                names = dict(enumerate(item.arms))
                made = {"kind": "union", "name": name, "code": item.code, "names": names, ARRAY: arms}
                return made | {"tag_path": self._path(f"{path}.tag")}
            case layout.Grid():
                return {"kind": "grid", "name": name, "sizes": item.sizes, "item": self.node(item.item, name, path)}
            case items.Bits():
                made = {"kind": "bits", "name": name, "code": item.code, "path": self._path(path)}
                return made | {ARRAY: [self._bit(bit, path) for bit in item.bits]}
            case items.Choice():
                made = {
                    "kind": "choice",
                    "name": name,
                    "path": self._path(f"{path}.choice"),
                    **self._values(item.index),
                }
                made["value_path"] = self._path(f"{path}.value")
                return made | {"items": {index: self._number(part) for index, part in item.items.items()}}
            case items.Text():
                made = {"kind": "text", "name": name, "path": self._path(path)}
                if item.count is None:
                    return made | {"length": item.length}
                return made | _count(item.count) | {"count_path": self._path(f"{path}.count")}
            case items.Blob():
                made = {"kind": "blob", "name": name, "path": self._path(path), **_count(item.count)}
                made["count_path"] = self._path(f"{path}.count")
                return made | ({"nested": True} if item.nested else {})
            case items.Formatted():
                made = {"kind": "blob", "name": name, "path": self._path(f"{path}.data"), **_count(item.count)}
                made |= {"format_path": self._path(f"{path}.format"), **self._values(item.formats)}
                made["count_path"] = self._path(f"{path}.data.count")
                nested = dict.fromkeys(sorted(item.nested_formats), True) if item.nested else {}
                return made | ({"nested": nested} if nested else {})
            case items.Number() | items.Real():
                return {**self._number(item), "name": name, "path": self._path(path)}
        raise TypeError(type(item).__name__)

    def _record(self, item: layout.Composite, name: str, path: str) -> Node:
        parts = []
        for slot in item.slots:
            part = self.node(slot.item, slot.jaus or slot.name, f"{path}.{slot.name}")
            parts.append(part | ({"optional": True} if slot.optional else {}))
        made: Node = {"kind": "record", "name": name, ARRAY: parts}
        if item.presence:
            made |= {"presence": item.presence, "presence_path": self._path(f"{path}.presence_vector")}
        return made

    def _list(self, item: layout.Repeat, name: str, path: str) -> Node:
        """A list in a list has the same path; of the two counts the outer one gets the plain name.

        In other lists the fields of the elements come first, so that one called `count` keeps its name.
        """
        made: Node = {"kind": "list", "name": name, **_count(item.count)}
        if isinstance(item.item, layout.Repeat):
            made["count_path"] = self._path(f"{path}.count")
        made["item"] = {**self.node(item.item, name, path), "inline": True}
        if "count_path" not in made:
            made["count_path"] = self._path(f"{path}.count")
        return made

    def _number(self, item: items.Number | items.Real) -> Node:
        """What a number says without its place: type, range, units."""
        units = unit_symbol(item.units)
        made: Node = {"code": item.code, **({"units": units} if units else {})}
        if isinstance(item, items.Number):
            return made | {"kind": "number"} | self._values(item.values)
        scaling = item.scaling
        made |= {"kind": "real", "lower": scaling.lower, "upper": scaling.upper}
        return made | {"step": scaling.step, "top": scaling.top}

    def _bit(self, bit: items.Bit, path: str) -> Node:
        place = {"shift": bit.shift, "mask": bit.mask, "width": bit.mask.bit_length()}
        return {"name": bit.name, "path": self._path(f"{path}.{bit.name}"), **place, **self._values(bit.values)}

    def _values(self, values: Values) -> Node:
        if values is ANY or values.anything:
            return {}
        made: Node = {}
        if values.enum is not None:
            names = {int(value): member.name for value, member in values.enum._value2member_map_.items()}
            made["enum"] = self._tables.enum(names)
        if values.intervals:
            made["ranges"] = [end for interval in values.intervals for end in interval]
        return made


def _count(count: items.Count) -> Node:
    return {"count": count.code, "minimum": count.minimum, "maximum": count.maximum}
