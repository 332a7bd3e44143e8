"""Message classes of a schema, made in memory: names, nested classes, shared types, layouts.

`jauspy.load` uses the result as it is; `jauspy.codec.source` writes it as Python modules. A class at module
level (its owner) is a message or a composite of a declared type set; composites and enumerations inside it are its
nested classes, flat, with names that are unique in it.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from enum import IntEnum
from importlib import import_module
from itertools import count
from pathlib import Path
from types import GenericAlias, ModuleType
from typing import Any, Final

from jauspy.codec import declare
from jauspy.codec.codegen import keywords_only
from jauspy.codec.items import ANY, Bit, Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values, real
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import Message, Struct
from jauspy.codec.names import (
    attributes,
    class_name,
    members,
    service_module,
    set_package,
    unique,
    version_package,
)
from jauspy.codec.registry import MessageEntry, Registry
from jauspy.codec.scalars import CODES, FLOATS, as_sent
from jauspy.errors import SchemaError
from jauspy.logs import get_logger
from jauspy.schema import model as m
from jauspy.schema.digest import digest
from jauspy.schema.loader import load_own
from jauspy.schema.model import Schema
from jauspy.schema.state_tree import walk_states

JAUS_MESSAGE: Final = "jaus message"
"""The format of bytes that are a message."""

QUERIES: Final = range(0x2000, 0x4000)
REPORTS: Final = range(0x4000, 0x6000)
ANSWERS: Final = ("Report", "Confirm", "Reject")

MAX_LOOPS: Final = 16
"""Maximal nesting of lists and arrays; Python allows 20 nested blocks."""

PRESENCE_VECTOR: Final = "presence_vector"
"""The field of queries that selects the optional fields of the report."""
NO_DEFAULTS: Final[Mapping[str, int]] = {}

_OWN_NAMES: Final = frozenset({"CODE", "NAME", "SERVICE", "VERSION", "IS_COMMAND", "IS_QUERY", "REPORT"})


@dataclass(slots=True)
class MessageModule:
    """One module of a package: a service, or the declared types of a set that several messages share."""

    name: str
    """Dotted name relative to the package."""
    doc: str
    service: str = ""
    version: str = ""
    classes: list[type[Struct]] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Package:
    """The message classes of a schema, and their registry."""

    name: str
    modules: tuple[MessageModule, ...]
    registry: Registry


def build(schema: m.Schema, package: str, base: Registry | None = None) -> Package:
    """The classes of all messages of a schema, as of modules of `package`; the registry is layered over `base`.

    Raises `SchemaError` for what cannot be decoded in bounded time, and for lists that are nested too deeply.
    """
    planned = _planned(schema)
    entries = (one.entry(package) for one in planned)
    files = {service.key: service.where.file for service in schema.services if service.where}
    registry = Registry(entries, base, files)
    shared = _SharedTypes(package, {service.id for service in schema.services}, registry)
    modules = {
        p.module: MessageModule(p.module, f"{p.service.id} {p.service.version}.", *p.service.key) for p in planned
    }
    made: dict[object, type[Message]] = {}
    for one in sorted(planned, key=lambda one: one.module):
        key = _sharing_key(one, shared.services)
        original = made.get(key)
        if original is None or original.__module__ == f"{package}.{one.module}":
            cls = _located(_Owner(one.name, f"{package}.{one.module}", shared), one)
            made.setdefault(key, cls)
        else:
            cls = _derived(original, one, f"{package}.{one.module}")
        modules[one.module].classes.append(cls)
    for one in planned:
        if one.answer is not None:
            by_name = {cls.__name__: cls for cls in modules[one.module].classes}
            by_name[one.name].REPORT = by_name[one.answer.name]  # type: ignore[attr-defined]  # of queries only
    return Package(package, (*modules.values(), *shared.modules.values()), registry)


@dataclass(slots=True)
class _Planned:
    """A message, the name of its class, and the message that answers it."""

    module: str
    name: str
    service: m.ServiceDefinition
    message: m.MessageDefinition
    is_query: bool
    answer: _Planned | None = None

    def entry(self, package: str) -> MessageEntry:
        """The entry of the registry."""
        message, module = self.message, f"{package}.{self.module}"
        service, version = self.service.key
        return MessageEntry(
            message.code, message.name, service, version, module, cls=self.name, digest=digest(message.body)
        )


def _planned(schema: m.Schema) -> list[_Planned]:
    found: list[_Planned] = []
    names: set[str] = set()
    for service in schema.services:
        if not service.messages:
            continue
        # Services of two vendors may have one set, name and version; their URNs differ.
        module = unique(_module_name(service), names.__contains__)
        names.add(module)
        taken: dict[str, str] = {}
        for message in service.messages:
            if message.name not in taken:
                taken[message.name] = unique(class_name(message.name), list(taken.values()).__contains__)
                found.append(_Planned(module, taken[message.name], service, message, asks(message, service)))
    for one in found:
        if one.is_query:
            same_module = (other for other in found if other.module == one.module)
            named = {other.message.name: other for other in same_module}
            by_rule = (other for other in named.values() if answers(one.message, other.message))
            one.answer = next(by_rule, None) or named.get(_sent_for(one.message, one.service))
    return found


def _sent_for(query: m.MessageDefinition, service: m.ServiceDefinition) -> str:
    """The one output that the behaviour sends for a query; empty if there is none, or if there are several."""
    outputs = [message.name for message in service.outputs]
    sent = {
        name
        for machine in (service.behavior.machines if service.behavior else ())
        for _, state in walk_states(machine.states)
        for transition in (*state.transitions, *state.default_transitions)
        if transition.parameters and transition.parameters[0].type == query.name
        for action in transition.actions
        for name in outputs
        if action.name.endswith(f"send{name}") or (action.name.endswith("Send") and f"'{name}'" in action.arguments)
    }
    return sent.pop() if len(sent) == 1 else ""


def _module_name(service: m.ServiceDefinition) -> str:
    return f"{set_package(service.id)}.{version_package(service.version)}.{service_module(service.name)}"


def asks(message: m.MessageDefinition, service: m.ServiceDefinition) -> bool:
    """True for a query: by its id if below 6000h (AS5710), else for an input that is not a command.

    Clients of a service have its outputs as inputs, so names such as `Query...` take precedence.
    """
    if message.code < REPORTS.stop:
        return message.code in QUERIES
    if message.is_command or message.name.startswith(ANSWERS):
        return False
    is_input = message in service.inputs and message not in service.outputs
    return is_input or message.name.startswith("Query")


def answers(query: m.MessageDefinition, report: m.MessageDefinition) -> bool:
    """True for the report on a query of its service: by its id below 6000h (AS5710), else by its name."""
    if query.code in QUERIES:
        return report.code - query.code == REPORTS.start - QUERIES.start
    return query.name.startswith("Query") and report.name == f"Report{query.name.removeprefix('Query')}"


def _sharing_key(one: _Planned, services: set[str]) -> object:
    """A key that is equal for messages of several services or versions that share a class; they derive from the first.

    Queries are equal when the reports on them are. The first module by name has the class, so that the imports of
    written modules have no cycles.
    """
    answer = one.answer and _message_key(one.answer.message, services)
    return (_message_key(one.message, services), one.is_query, answer)


def _message_key(message: m.MessageDefinition, services: set[str]) -> object:
    return (message.name, message.code, message.is_command, _without_services(message.body, services))


def _without_services(value: Any, services: set[str]) -> Any:
    """A node without the names of services that declare parts of it, which do not affect a class."""
    if isinstance(value, tuple):
        return tuple(_without_services(part, services) for part in value)
    if not isinstance(value, m.Node):
        return value
    parts = {field.name: _without_services(getattr(value, field.name), services) for field in fields(value)}
    if value.declared is not None and value.declared.set_id in services:
        parts["declared"] = None
    return replace(value, **parts)


def _located(owner: _Owner, one: _Planned) -> type[Message]:
    """The class of a message; adds the location of the message to a `SchemaError`."""
    message = one.message
    try:
        return owner.message(one)
    except SchemaError as error:
        file, line = (message.where.file, message.where.line) if message.where else (None, None)
        raise SchemaError(f"message {message.name}: {error.reason}", file=file, line=line) from None


def _derived(original: type[Message], one: _Planned, module: str) -> type[Message]:
    summary, known = _doc(_summary(one.message)), original.__doc__ or ""
    names = {"__module__": module, "__doc__": known if known.startswith(summary) else summary}
    return declare.derived(declare.Service(*one.service.key))(type(one.name, (original,), names))


def _summary(message: m.MessageDefinition) -> str:
    title = f"{message.name} (0x{message.code:04X})"
    return f"{title}: {message.doc}" if message.doc else f"{title}."


class _SharedTypes:
    """The classes of declared type sets, made when they are first needed."""

    def __init__(self, package: str, services: set[str], registry: Registry) -> None:
        self.services = services
        self.registry = registry
        self.modules: dict[str, MessageModule] = {}
        self._package = package
        self._classes: dict[m.Node, type[Struct]] = {}

    def owns(self, node: m.Node) -> bool:
        """True if a node is declared in a type set, not by a service itself.

        A list or variant in an arm of a variant gets a class that is named after its use, so it is never shared.
        """
        if isinstance(node, (m.List, m.Variant)):
            return False
        return node.declared is not None and node.declared.set_id not in self.services

    def use(self, node: m.Node) -> type[Struct]:
        """The class of a declared node."""
        assert node.declared is not None
        key = _bare(replace(node, name=node.declared.name))
        name = f"{set_package(node.declared.set_id)}.{version_package(node.declared.version)}.types"
        module = self.modules.setdefault(name, MessageModule(name, "Declared types that several messages share."))
        if key not in self._classes:
            taken = {cls.__name__ for cls in module.classes}
            free = unique(class_name(node.declared.name), taken.__contains__)
            self._classes[key] = _Owner(free, f"{self._package}.{name}", self).declared(key)
            module.classes.append(self._classes[key])
        return self._classes[key]


def _defaults(one: _Planned, parts: _Parts) -> Mapping[str, int]:
    """The presence vector of a query that asks for all fields of its report, where that is its last required field."""
    required = [slot.name for slot in parts.slots if not slot.optional]
    body = one.answer.message.body if one.answer is not None else None
    if not isinstance(body, m.Record | m.Sequence) or body.presence is None or required[-1:] != [PRESENCE_VECTOR]:
        return NO_DEFAULTS
    nodes: Sequence[m.Node] = body.fields if isinstance(body, m.Record) else body.items
    return {PRESENCE_VECTOR: (1 << sum(node.optional for node in nodes)) - 1}


def _bare(node: m.Node) -> m.Node:
    return replace(node, optional=False, doc="")


class _Owner:
    """Builds one class at module level with everything nested in it."""

    def __init__(self, name: str, module: str, shared: _SharedTypes) -> None:
        self.name = name
        self._module = module
        self._shared = shared
        self._nested: dict[str, type] = {}
        self._known: dict[object, type] = {}
        self._taken: set[str] = {*_OWN_NAMES, name}

    def message(self, one: _Planned) -> type[Message]:
        """The class of a message; its body's fields become its own attributes."""
        message = one.message
        parts = self._parts(message.body) if message.body is not None else _Parts()
        names = self._composite(parts, self.name, _summary(message), _defaults(one, parts))
        made = declare.message(
            declare.Service(*one.service.key),
            message.code,
            message.name,
            presence=parts.presence,
            command=message.is_command,
            query=one.is_query,
            kw_only=keywords_only(parts.slots),
        )
        return made(type(self.name, (Message,), names))

    def declared(self, node: m.Node) -> type[Struct]:
        """The class of a declared record, sequence, bit field, variable field or variable-format field."""
        return self._class_of(node, self.name)

    def _names(self, name: str, doc: str, kinds: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
        """The names that a class with these annotations and values defines; nested classes belong to the owner."""
        is_owner = name == self.name
        place = {"__module__": self._module, "__qualname__": name if is_owner else f"{self.name}.{name}"}
        nested = self._nested if is_owner else {}
        return {**place, "__doc__": doc, "__annotations__": dict(kinds), **nested, **values}

    def _composite(
        self, parts: _Parts, name: str, doc: str, defaults: Mapping[str, int] = NO_DEFAULTS
    ) -> dict[str, Any]:
        """The names of a message, record or sequence."""
        kinds, values = {}, {}
        for slot in parts.slots:
            given: Any = {"default": defaults[slot.name]} if slot.name in defaults else {}
            kinds[slot.name] = type_of(slot.item) | None if slot.optional else type_of(slot.item)
            values[slot.name] = declare.field(slot.jaus, slot.item, **({"default": None} if slot.optional else given))
        if Composite(Struct, tuple(parts.slots), parts.presence).undefined:
            kinds["reserved_presence"], values["reserved_presence"] = int, 0
        return self._names(name, _doc(doc, parts.rows, name), kinds, values)

    def _parts(self, node: m.Composite) -> _Parts:
        presence = None
        if isinstance(node, m.Record | m.Sequence):
            nodes: Sequence[m.Node] = node.fields if isinstance(node, m.Record) else node.items
            presence = CODES[node.presence] if node.presence else None
        elif isinstance(node, m.Variant) and not node.arms:
            return _Parts([Slot("tag", "", Number(CODES[node.tag.type]))])
        else:
            nodes = (replace(node, optional=False),)
        names = attributes((node.name for node in nodes), "reserved_presence")
        slots = [
            Slot(name, node.name, self._item(node), node.optional and presence is not None)
            for name, node in zip(names, nodes, strict=True)
        ]
        return _Parts(slots, [_slot_row(slot, node) for slot, node in zip(slots, nodes, strict=True)], presence)

    def _item(self, node: m.Node) -> Item:
        match node:
            case m.FixedField():
                return self._number(node.type, node.units, node.scale, node.values, node.name)
            case m.FixedString():
                return Text(length=node.length)
            case m.VariableString():
                return Text(count=_count(node.count))
            case m.VariableLengthField():
                return self._blob(node)
            case m.Array():
                return _shallow(node, Grid(self._item(node.element), tuple(d.size for d in node.dimensions)))
            case m.List():
                item = self._item(node.element)
                if not item.minimum:
                    raise SchemaError(f"list {node.name} repeats an item without content; the data cannot bound it")
                return _shallow(node, Repeat(_count(node.count), item))
            case m.Variant() if node.arms:
                return self._union(node)
            case _:
                return self._class(node).layout()

    def _blob(self, node: m.VariableLengthField) -> Blob:
        if node.format.lower() != JAUS_MESSAGE:
            return Blob(_count(node.count))
        # deployed systems send a missing message as a count of 0, whatever the lower limit in the definition
        return Blob(_count(replace(node.count, minimum=0)), self._shared.registry)

    def _union(self, node: m.Variant) -> Union:
        arms: list[type[Struct]] = []
        for arm in node.arms:
            made = self._class(arm)
            if made in arms:
                made = self._nest(replace(arm, declared=None), key=(arm, len(arms)))
            arms.append(made)
        names = attributes((arm.name for arm in node.arms), "code")
        return Union.of(CODES[node.tag.type], **dict(zip(names, arms, strict=True)))

    def _class(self, node: m.Node) -> type[Struct]:
        if self._shared.owns(node):
            return self._alias(self._shared.use(node))
        return self._nest(node, key=_bare(node))

    def _alias(self, made: type[Struct]) -> type[Struct]:
        """Offer a shared class under the message that uses it, too."""
        if made.__name__ not in self._taken:
            self._taken.add(made.__name__)
            self._nested[made.__name__] = made
        return made

    def _nest(self, node: m.Node, key: object) -> type[Struct]:
        known = self._known.get(key)
        if known is None:
            name = self._free(class_name(node.name))
            known = self._known[key] = self._nested[name] = self._class_of(node, name)
        assert issubclass(known, Struct)
        return known

    def _free(self, name: str) -> str:
        name = unique(name, self._taken.__contains__)
        self._taken.add(name)
        return name

    def _class_of(self, node: m.Node, name: str) -> type[Struct]:
        match node:
            case m.BitField():
                return self._bits(node, name)
            case m.VariableField():
                return self._choice(node, name)
            case m.VariableFormatField():
                return self._format(node, name)
            case m.Record() | m.Sequence() | m.List() | m.Variant():
                parts = self._parts(node)
                names = self._composite(parts, name, node.doc)
                return declare.record(parts.presence, kw_only=keywords_only(parts.slots))(type(name, (Struct,), names))
            case _:
                raise SchemaError(f"{node.name}: a {type(node).__name__} cannot stand here")

    def _bits(self, node: m.BitField, name: str) -> type[Struct]:
        code = CODES[node.type]
        attrs = attributes((sub.name for sub in node.subfields), "reserved_bits")
        bits = []
        for attr, sub in zip(attrs, node.subfields, strict=True):
            mask = (1 << (sub.last - sub.first + 1)) - 1
            values = self._values(sub.values, sub.name, code)
            clipped = tuple((max(low, 0), min(high, mask)) for low, high in values.intervals if low <= mask)
            bits.append(Bit(attr, sub.first, mask, replace(values, intervals=clipped)))
        kinds = {bit.name: _integer(bit.values) for bit in bits}
        defaults: dict[str, Any] = {bit.name: declare.bits(bit.shift, bit.mask, bit.values) for bit in bits}
        if Bits(Struct, code, tuple(bits)).reserved:
            kinds["reserved_bits"], defaults["reserved_bits"] = int, 0
        rows = (_bit_row(bit, sub.doc) for bit, sub in zip(bits, node.subfields, strict=True))
        names = self._names(name, _doc(node.doc, rows, name), kinds, defaults)
        return declare.bit_field(code)(type(name, (Struct,), names))

    def _choice(self, node: m.VariableField, name: str) -> type[Struct]:
        enum = self._enum(self._part(name, "Choice"), [(c.index, c.name or c.units) for c in node.choices])
        items = {
            c.index: self._number(c.type, c.units, c.scale, c.values, f"{name}{class_name(c.name)}")
            for c in node.choices
        }
        kinds = {type_of(item) for item in items.values()}
        value = type_union(sorted(kinds, key=lambda kind: getattr(kind, "__name__", ""), reverse=True))
        rows = (f"{index}: {item.units}, {describe(item)}".rstrip(", ") for index, item in items.items())
        doc = _doc(node.doc, rows, name)
        names = self._names(name, doc, {"choice": _integer(Values(enum)), "value": value}, {})
        return declare.variable(lambda cls: Choice(cls, items, Values(enum)))(type(name, (Struct,), names))

    def _format(self, node: m.VariableFormatField, name: str) -> type[Struct]:
        formats = Values(self._enum(self._part(name, "Format"), [(f.index, f.name) for f in node.formats]))
        nested = frozenset(f.index for f in node.formats if f.name.lower() == JAUS_MESSAGE)
        inside = self._shared.registry if nested else None
        count = _count(node.count)
        kinds = {"format": _integer(formats), "data": Message | bytes if nested else bytes}
        names = self._names(name, _doc(node.doc, (), name), kinds, {})
        made = declare.variable(lambda cls: Formatted(cls, formats, count, inside, nested))
        return made(type(name, (Struct,), names))

    def _part(self, name: str, part: str) -> str:
        """The name of a nested class: `Choice` in a declared class, `ZPositionChoice` beside other classes."""
        return part if name == self.name else f"{name}{part}"

    def _number(
        self, scalar: m.Scalar, units: str, scale: m.Scale | None, values: m.ValueSet | None, name: str
    ) -> Number | Real:
        code = CODES[scalar]
        if scale is None or code in FLOATS:
            return Number(code, self._values(values, name, code), units)
        if not float(scale.lower) < float(scale.upper):
            raise SchemaError(f"{name}: the range {scale.lower}..{scale.upper} is empty")
        return real(code, float(scale.lower), float(scale.upper), units, scale.function)

    def _values(self, values: m.ValueSet | None, name: str, code: str) -> Values:
        if values is None or not (values.enums or values.ranges):
            return ANY
        enum = self._enum(class_name(name), [(e.value, e.name) for e in values.enums])
        return Values(enum, intervals(values, code))

    def _enum(self, name: str, values: Iterable[tuple[int, str]]) -> type[IntEnum] | None:
        key = (name, tuple(values))
        if not key[1]:
            return None
        if key not in self._known:
            free = self._free(name)
            make: Any = IntEnum
            made = make(free, members(key[1]), module=self._module, qualname=f"{self.name}.{free}")
            self._known[key] = self._nested[free] = made
        known = self._known[key]
        assert issubclass(known, IntEnum)
        return known


@dataclass(slots=True)
class _Parts:
    """The parts of a composite."""

    slots: list[Slot] = field(default_factory=list)
    rows: list[str] = field(default_factory=list)
    """Lines of the docstring."""
    presence: str | None = None


def _count(count: m.Count) -> Count:
    return Count(CODES[count.type], count.minimum, count.maximum)


def intervals(values: m.ValueSet, code: str) -> tuple[tuple[float, float], ...]:
    """The ranges with both ends included, integers for integer codes."""
    made: list[tuple[float, float]] = []
    for r in values.ranges:
        if code in FLOATS:
            lower, upper = as_sent(r.lower, code), as_sent(r.upper, code)
            low = lower if r.lower_inclusive else math.nextafter(lower, math.inf)
            high = upper if r.upper_inclusive else math.nextafter(upper, -math.inf)
        else:
            low = math.ceil(r.lower) if r.lower_inclusive else math.floor(r.lower) + 1
            high = math.floor(r.upper) if r.upper_inclusive else math.ceil(r.upper) - 1
        if low <= high:
            made.append((low, high))
    return tuple(made)


def loops(item: Item) -> int:
    """The number of nested loops in its code; items with a separate method count from zero."""
    match item:
        case Repeat():
            return 1 + loops(item.item)
        case Grid():
            return len(item.sizes) + loops(item.item)
        case Composite(presence=None):
            return max((loops(slot.item) for slot in item.slots), default=0)
        case _:
            return 0


def _shallow(node: m.Node, item: Item) -> Item:
    """Return the item; raises `SchemaError` if its code has too many nested loops for Python."""
    if loops(item) > MAX_LOOPS:
        raise SchemaError(f"'{node.name}' has more than {MAX_LOOPS} lists and arrays one inside the other; flatten it")
    return item


def type_of(item: Item) -> Any:
    """The type of an attribute."""
    match item:
        case Real():
            return float
        case Number():
            return float if item.code in FLOATS else _integer(item.values)
        case Text():
            return str
        case Blob():
            return Message | bytes if item.nested else bytes
        case Composite() | Bits() | Choice() | Formatted():
            return item.cls
        case Repeat():
            return GenericAlias(list, (type_of(item.item),))
        case Union():
            return type_union(arm.cls for arm in item.arms.values())
        case Grid():
            kind = type_of(item.item)
            for _ in item.sizes:
                kind = GenericAlias(list, (kind,))
            return kind
        case _:
            raise AssertionError(item)


def type_union(kinds: Iterable[Any]) -> Any:
    """`A | B | C`."""
    first, *others = kinds
    for other in others:
        first = first | other
    return first


def _integer(values: Values) -> Any:
    return values.enum | int if values.enum else int


def describe(item: Item) -> str:
    """Units, range and size of an attribute, for a docstring."""
    match item:
        case Real():
            units = "" if item.units == "one" else f" {item.units}"
            return f"{item.scaling.lower:.12g}..{item.scaling.upper:.12g}{units}"
        case Number():
            units = "" if item.units == "one" else f" in {item.units}"
            ranges = [f"{low:.12g}..{high:.12g}" for low, high in item.values.intervals]
            return " or ".join(([item.values.enum.__name__] if item.values.enum else []) + ranges) + units
        case Text():
            return f"up to {item.count.maximum if item.count else item.length} characters"
        case Repeat():
            return f"{item.count.minimum}..{item.count.maximum} items"
        case Grid():
            inner = describe(item.item)
            return " x ".join(map(str, item.sizes)) + (f" of {inner}" if inner else "")
        case _:
            return ""


def _slot_row(slot: Slot, node: m.Node) -> str:
    what = node.format if isinstance(node, m.VariableLengthField) else describe(slot.item)
    facts = ", ".join(part for part in (what, "optional" if slot.optional else "") if part)
    text = ". ".join(part.rstrip(".") for part in (facts, node.doc) if part)
    return f"{slot.name}: {text}" if text else ""


def _bit_row(bit: Bit, doc: str) -> str:
    last = bit.shift + bit.mask.bit_length() - 1
    where = f"bit {bit.shift}" if last == bit.shift else f"bits {bit.shift}..{last}"
    return f"{bit.name}: {where}{'. ' + doc if doc else ''}"


def _doc(summary: str, rows: Iterable[str] = (), name: str = "") -> str:
    """A docstring: the description, or else the name, and a row for each attribute."""
    head, *listed = (" ".join(text.split()) for text in (summary, *rows))
    listed = [row for row in listed if row]
    lines = [*([head] if head else []), *([""] if head and listed else []), *listed] or [f"{name}."]
    return "\n".join(lines if len(lines) == 1 else [*lines, ""])


_LOG = get_logger(__name__)
_numbers: Final = count(1)


def load(*sources: str | Path) -> Registry:
    """The messages of JSIDL files, folders or patterns (`load("vendor/*.xml")`), in front of the built-in ones.

    The files may refer to each other and to everything built in, in any mix of versions. A service that they define in
    a built-in version replaces the built-in one; ambiguous message ids are listed in `Registry.collisions` and logged.
    The registry also decodes its own messages inside built-in ones. Raises `SchemaError` with
    file and line, `ConfigError` when there is no such file.
    """
    return load_schema(load_own(sources))


def load_schema(schema: Schema) -> Registry:
    """The messages of a model, in front of the built-in ones."""
    built_in = import_module("jauspy.messages").registry  # of the layer above, which no module here may import
    package = build(schema, f"jauspy_loaded_{next(_numbers)}", built_in)
    _register(package)
    registry = package.registry
    registry.schema = schema
    for code in sorted({message.code for service in schema.services for message in service.messages}):
        if collision := registry.collision(code):
            _LOG.warning("%s; decoding needs the %s", collision, collision.remedy)
    return registry


def _register(package: Package) -> None:
    """Register the modules for `import`, which the registry and pickle use to find classes."""
    root = sys.modules[package.name] = ModuleType(package.name)
    root.__dict__["registry"] = package.registry
    for module in package.modules:
        name = package.name
        for part in module.name.split("."):
            name = f"{name}.{part}"
            sys.modules.setdefault(name, ModuleType(name))
        sys.modules[name].__doc__ = module.doc
        sys.modules[name].__dict__.update({cls.__name__: cls for cls in module.classes})
