"""Converts `field=value` of the command line to messages, describes fields, and writes example commands."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from difflib import get_close_matches
from typing import Any, Final

import yaml

from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import Message
from jauspy.codec.names import members, unit_symbol
from jauspy.codec.registry import NO_HINTS, Hints, Registry
from jauspy.codec.scalars import FLOATS, limits
from jauspy.errors import ConfigError, EncodeError
from jauspy.messages import registry as public

_PRESENCE: Final = "presence_vector"
_BOOL: Final = "tag:yaml.org,2002:bool"


def _without_bool(cls: Any) -> Any:
    return {first: [kind for kind in found if kind[0] != _BOOL] for first, found in cls.yaml_implicit_resolvers.items()}


class _Loader(yaml.SafeLoader):
    """Reads ON, OFF, YES and NO as names of enumerations, as YAML 1.2 does."""

    yaml_implicit_resolvers = _without_bool(yaml.SafeLoader)


class _Dumper(yaml.SafeDumper):
    """Writes them without quotes."""

    yaml_implicit_resolvers = _without_bool(yaml.SafeDumper)


for _each in (_Loader, _Dumper):
    _each.add_implicit_resolver(_BOOL, re.compile("true|True|false|False"), list("tTfF"))


def message_from(registry: Registry, name: str, assignments: Sequence[str], hints: Hints = NO_HINTS) -> Message:
    """The message with this JAUS name and these fields, of the service and version in `hints`.

    A query without a presence vector requests every field, and bits that are not named are 0. Raises `ConfigError`,
    which lists the fields with types, ranges and units.
    """
    cls = message_class(registry, name, hints)
    layout = cls.layout()
    assert isinstance(layout, Composite)
    data: dict[str, Any] = {}
    for assignment in assignments:
        path, sign, text = assignment.partition("=")
        if not sign:
            raise ConfigError(f"{assignment!r} is not FIELD=VALUE.\n{describe(cls)}")
        _assign(data, path.strip(), text, layout, cls)
    for slot in layout.slots:
        if slot.name == _PRESENCE and slot.name not in data:
            data[slot.name] = everything(registry, cls)
    try:
        message = cls.from_dict(_with_bits(layout, data))
    except EncodeError as error:
        raise ConfigError(f"{cls.NAME}: {error}.\n{describe(cls)}") from None
    try:
        message.encode()
    except EncodeError as error:
        raise ConfigError(f"{cls.NAME}: {error}") from None
    return message


def message_class(registry: Registry, name: str, hints: Hints) -> type[Message]:
    """The class with this JAUS name, of the service and version in `hints`; raises `ConfigError`."""
    try:
        return registry.by_name(name, service=hints.service, version=hints.version)
    except ConfigError as error:
        more = " (`--schemas` reads your own definitions)" if registry is public else ""
        raise ConfigError(f"{error}{more}") from None


def everything(registry: Registry, query: type[Message]) -> int:
    """The presence vector that requests every field of the report."""
    layout = query.layout()
    assert isinstance(layout, Composite)
    item = next(slot.item for slot in layout.slots if slot.name == _PRESENCE)
    every = limits(item.code)[1] if isinstance(item, Number) else 0xFF
    report = _report_of(registry, query)
    if report is None:
        return every
    assert isinstance(report, Composite)
    optional = sum(slot.optional for slot in report.slots)
    return (1 << optional) - 1 if optional else every


def _report_of(registry: Registry, query: type[Message]) -> Item | None:
    """The layout of the report to a query: that of the same service and version, else the newest."""
    name = query.NAME.replace("Query", "Report", 1)
    for which in ({"service": query.SERVICE, "version": query.VERSION}, {}):
        with suppress(ConfigError):
            return registry.by_name(name, **which).layout()
    return None


def describe(cls: type[Message]) -> str:
    """The fields of a message, one per line under a heading."""
    layout = cls.layout()
    assert isinstance(layout, Composite)
    if not layout.slots:
        return f"{cls.NAME} has no fields."
    width = max(len(slot.name) for slot in layout.slots)
    lines = [f"  {slot.name:<{width}}  {_slot_kind(slot)}" for slot in layout.slots]
    return "\n".join([f"Fields of {cls.NAME}:", *lines])


def _assign(data: dict[str, Any], path: str, text: str, layout: Item, cls: type[Message]) -> None:
    """Set the field of a dotted path to a value parsed by the field's type."""
    *parents, last = path.split(".")
    for name in parents:
        layout = _inside(layout, name, cls)
        data = data.setdefault(name, {})
        if not isinstance(data, dict):
            raise ConfigError(f"{path!r} is set twice")
    if last in data:
        raise ConfigError(f"{path!r} is set twice")
    data[last] = _value(_inside(layout, last, cls), text, path)


def _inside(layout: Item, name: str, cls: type[Message]) -> Item:
    parts = dict(_parts(layout))
    if name not in parts:
        close = get_close_matches(name, parts, 1)
        hint = f"; did you mean {close[0]!r}?" if close else "."
        raise ConfigError(f"{cls.NAME} has no field {name!r}{hint}\n{describe(cls)}")
    return parts[name]


def _parts(layout: Item) -> Iterator[tuple[str, Item]]:
    if isinstance(layout, Composite):
        yield from ((slot.name, slot.item) for slot in layout.slots)
    elif isinstance(layout, Bits):
        yield from ((bit.name, Number("B", bit.values)) for bit in layout.bits)
    elif isinstance(layout, Union):
        yield from layout.arms.items()
    elif isinstance(layout, Choice):
        yield "choice", Number("B", layout.index)
        yield "value", next(iter(layout.items.values()))
    elif isinstance(layout, Formatted):
        yield "format", Number("B", layout.formats)
        yield "data", Blob(layout.count)


def _value(item: Item, text: str, path: str) -> Any:
    if isinstance(item, Text):
        return text
    if isinstance(item, (Number, Real)) and (number := _number(text)) is not None:
        return number
    if isinstance(item, Number) and item.values.enum:
        return _enumerated(text)
    try:
        value = yaml.load(text, _Loader)  # noqa: S506 # nosec B506 # a SafeLoader
    except yaml.YAMLError:
        raise ConfigError(f"{path}={text!r} is neither a number, a name, nor JSON or YAML") from None
    if isinstance(item, Blob) and isinstance(value, (str, int)):
        return {"hex": text.strip().removeprefix("0x")}
    return _with_names(item, value)


def _with_names(item: Item, value: Any) -> Any:
    """The value with names of enumerations as messages have them; `schema show` prints those of the definition."""
    if isinstance(item, Number) and item.values.enum and isinstance(value, str):
        return _enumerated(value)
    if isinstance(item, Repeat | Grid) and isinstance(value, list):
        return [_with_names(item.item, entry) for entry in value]
    if isinstance(value, dict):
        parts = dict(_parts(item))
        return {name: _with_names(parts[name], entry) if name in parts else entry for name, entry in value.items()}
    return value


def _with_bits(item: Item, value: Any) -> Any:
    """The value with 0 for bits that are left out, where 0 is allowed."""
    if isinstance(item, Repeat | Grid) and isinstance(value, list):
        return [_with_bits(item.item, entry) for entry in value]
    if not isinstance(value, dict):
        return value
    parts = dict(_parts(item))
    given = {name: _with_bits(parts[name], entry) if name in parts else entry for name, entry in value.items()}
    if isinstance(item, Bits):
        return {bit.name: 0 for bit in item.bits if bit.values.allows(0)} | given
    return given


def _enumerated(text: str) -> str | int:
    """A member of an enumeration: `STOP`, `Stop`, `1 STOP`, `EmergencyCode.STOP` or `<EmergencyCode.STOP: 1>`."""
    number, _, name = text.strip().partition(" ")
    if name and number.isdecimal():
        return int(number)
    found = re.fullmatch(r"<?(?:\w+\.)*([^<>:]+?)(?:: *\d+>)?", text.strip())
    (member,) = members([(0, found[1] if found else text)])
    return member


def _number(text: str) -> float | None:
    """`12`, `0x1ff`, `1.5e3`; YAML 1.1 parses some of these as text."""
    for read in (lambda: int(text, 0), lambda: float(text)):
        try:
            return read()
        except ValueError:
            continue
    return None


def _slot_kind(slot: Slot) -> str:
    return _kind(slot.item) + (", optional" if slot.optional else "")


def _kind(item: Item) -> str:
    """The type, range and unit of a field."""
    if isinstance(item, Real):
        return f"{item.scaling.lower:g}..{item.scaling.upper:g} {unit_symbol(item.units)}".strip()
    if isinstance(item, Number):
        return _number_kind(item)
    if isinstance(item, Text):
        return "text"
    if isinstance(item, Blob):
        return "a message or hex bytes" if item.nested else "hex bytes"
    if isinstance(item, (Repeat, Grid)):
        return f"list of {_kind(item.item)}"
    return "mapping of " + ", ".join(name for name, _ in _parts(item))


def _number_kind(item: Number) -> str:
    allowed = str(item.values)
    if not allowed:
        lowest, highest = (0, 0) if item.code in FLOATS else limits(item.code)
        allowed = "number" if item.code in FLOATS else f"{lowest}..{highest}"
    return f"{allowed} {unit_symbol(item.units)}".strip()


SAMPLES: Final = (0.5, 0.05, 0.0, 1.0)
"""Candidates for the value of a number; the first in range is used."""
WIDTH: Final = 100_000
"""Columns of YAML, so that it is one line."""


def example(registry: Registry, kind: type[Message], target: str = "ID") -> list[str]:
    """The words of a command that sends or queries such a message; empty if no example of it can be encoded."""
    layout = kind.layout()
    if not isinstance(layout, Composite):
        return []
    fields = [
        f"{name}={_example_text(value)}" for name, value in _example_fields(layout).items() if name != "presence_vector"
    ]
    try:
        message_from(registry, kind.NAME, fields, Hints(kind.SERVICE, kind.VERSION))
    except ConfigError:
        return []
    verb = "query" if kind.IS_QUERY else "send"
    return ["jauspy", verb, target, kind.NAME, *fields]


def _example_text(value: Any) -> str:
    if isinstance(value, dict | list):
        return yaml.dump(value, Dumper=_Dumper, default_flow_style=True, width=WIDTH, sort_keys=False).strip()
    return str(value)


def _example_fields(layout: Composite) -> dict[str, Any]:
    """Required fields, or the first optional one when there is none."""
    required = [slot for slot in layout.slots if not slot.optional]
    return {slot.name: _example_value(slot.item) for slot in required or layout.slots[:1]}


def _example_value(item: Item) -> Any:
    match item:
        case Composite():
            return _example_fields(item)
        case Repeat():
            return [_example_value(item.item)] * max(1, item.count.minimum)
        case Grid():
            return _example_grid(item.sizes, _example_value(item.item))
        case Union():
            name, arm = next(iter(item.arms.items()))
            return {name: _example_fields(arm)}
        case Choice():
            index, number = next(iter(item.items.items()))
            return {"choice": _example_named(item.index, index), "value": _example_value(number)}
        case Bits():
            return {bit.name: _example_number(bit.values) for bit in item.bits}
        case Formatted():
            nested = next(iter(sorted(item.nested_formats)), None)
            if nested is not None:
                return {"format": _example_named(item.formats, nested), "data": {"message": "QueryStatus"}}
            return {"format": _example_number(item.formats), "data": {"hex": "00"}}
        case Blob():
            return {"message": "QueryStatus"} if item.nested else {"hex": "00" * max(1, item.count.minimum)}
        case Text():
            return "name"[: item.length or None]
        case Real():
            low, high = item.scaling.lower, item.scaling.upper
            return next((sample for sample in SAMPLES if low <= sample <= high), low)
        case Number():
            return _example_number(item.values)
    raise AssertionError(item)


def _example_grid(sizes: Sequence[int], value: Any) -> Any:
    return [_example_grid(sizes[1:], value) for _ in range(sizes[0])] if sizes else value


def _example_number(values: Values) -> Any:
    if values.enum:
        return next(iter(values.enum)).name
    return next((int(low) for low, _ in values.intervals), 1)


def _example_named(values: Values, number: int) -> Any:
    return next((constant.name for constant in values.enum or () if constant == number), number)
