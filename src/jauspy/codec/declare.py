"""The vocabulary of message declarations: class decorators, fields, and the parts of layouts.

`@message`, `@record` and `@bit_field` make dataclasses with slots, whose layout is that of their fields. Type checkers
see all fields (`typing.dataclass_transform`). Items of a layout that refer to classes are functions, called at first
use.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar, cast, dataclass_transform

from jauspy.codec.items import ANY, Bit, Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values, real
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import Message, Struct

__all__ = [
    "ANY",
    "Bit",
    "Bits",
    "Blob",
    "Choice",
    "Composite",
    "Count",
    "Formatted",
    "Grid",
    "Item",
    "Message",
    "Number",
    "Real",
    "Repeat",
    "Service",
    "Slot",
    "Struct",
    "Text",
    "Union",
    "Values",
    "bit_field",
    "bits",
    "derived",
    "field",
    "message",
    "real",
    "record",
    "variable",
]

S = TypeVar("S", bound=Struct)
M = TypeVar("M", bound=Message)

_PART = "jauspy"
"""Key of the wire layout in the metadata of a dataclass field."""


class Service(NamedTuple):
    """A service version that messages belong to."""

    urn: str
    version: str


def field(jaus: str, item: Item | Callable[[], Item], *, default: Any = dataclasses.MISSING) -> Any:
    """A field of a message or record, with its name in the standard; one whose default is None is optional."""
    return dataclasses.field(default=default, metadata={_PART: (jaus, item)})


def bits(shift: int, mask: int, values: Callable[[], Values] | Values = ANY) -> Any:
    """A sub-field of a bit field: its value is `raw >> shift & mask`."""
    return dataclasses.field(metadata={_PART: (shift, mask, values)})


@dataclass_transform(field_specifiers=(field,))
def record(presence: str | None = None, *, kw_only: bool = False) -> Callable[[type[S]], type[S]]:
    """Make a class a record or sequence; `presence` is the `struct` code of its presence vector."""

    def declared(cls: type[S]) -> type[S]:
        made = dataclasses.dataclass(slots=True, repr=False, kw_only=kw_only)(cls)
        return _with_layout(made, lambda cls: Composite(cls, tuple(_slots(cls)), presence))

    return declared


@dataclass_transform(field_specifiers=(field,))
def message(
    service: Service,
    code: int,
    name: str | None = None,
    *,
    presence: str | None = None,
    command: bool = False,
    query: bool = False,
    kw_only: bool = False,
) -> Callable[[type[M]], type[M]]:
    """Make a class a message of a service; `name` is its name in the standard where the class has another one."""

    def declared(cls: type[M]) -> type[M]:
        cls.CODE, cls.NAME = code, name or cls.__name__
        cls.SERVICE, cls.VERSION = service
        cls.IS_COMMAND, cls.IS_QUERY = command, query
        return record(presence, kw_only=kw_only)(cls)

    return declared


@dataclass_transform(field_specifiers=(bits,))
def bit_field(code: str) -> Callable[[type[S]], type[S]]:
    """Make a class a bit field of this `struct` code."""

    def declared(cls: type[S]) -> type[S]:
        made = dataclasses.dataclass(slots=True, repr=False)(cls)
        return _with_layout(made, lambda cls: Bits(cls, code, tuple(_bits(cls))))

    return declared


@dataclass_transform()
def variable(layout: Callable[[type[S]], Item]) -> Callable[[type[S]], type[S]]:
    """Make a class a variable field or variable-format field of this layout."""

    def declared(cls: type[S]) -> type[S]:
        return _with_layout(dataclasses.dataclass(slots=True, repr=False)(cls), layout)

    return declared


def derived(service: Service) -> Callable[[type[M]], type[M]]:
    """Make a class the message of another service or version that has the same fields."""

    def declared(cls: type[M]) -> type[M]:
        names = {name: value for name, value in cls.__dict__.items() if name not in ("__dict__", "__weakref__")}
        names |= {"__slots__": (), "SERVICE": service.urn, "VERSION": service.version}
        names["__doc__"] = cls.__doc__ or cls.__mro__[1].__doc__
        made: Any = type(cls.__name__, cls.__bases__, names)
        return cast("type[M]", made)

    return declared


def _with_layout(cls: type[S], layout: Callable[[type[S]], Item]) -> type[S]:
    cls._layout = classmethod(layout)  # type: ignore[assignment]  # the method is given to the class here
    return cls


def _slots(cls: Any) -> list[Slot]:
    found = []
    for one in dataclasses.fields(cls):
        if _PART in one.metadata:
            jaus, item = one.metadata[_PART]
            found.append(Slot(one.name, jaus, item if isinstance(item, Item) else item(), one.default is None))
    return found


def _bits(cls: Any) -> list[Bit]:
    found = []
    for one in dataclasses.fields(cls):
        if _PART in one.metadata:
            shift, mask, values = one.metadata[_PART]
            found.append(Bit(one.name, shift, mask, values if isinstance(values, Values) else values()))
    return found
