"""`jauspy schema show`: a message as a table of fields, or a service with its state machines."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Annotated, Any

import typer
from rich.table import Table
from rich.text import Text
from rich.tree import Tree

from jauspy.cli import console
from jauspy.cli.definitions import definitions as message_definitions
from jauspy.cli.fields import example
from jauspy.cli.options import Json
from jauspy.cli.schema.ls import Match, SchemasOption, as_object, definitions, find, set_of
from jauspy.codec.names import unit_symbol
from jauspy.codec.scalars import CODES, FLOATS, limits
from jauspy.errors import ConfigError
from jauspy.schema import load_builtin, model as m
from jauspy.schema.differences import trigger
from jauspy.schema.digest import Sizes, can_be_there, scalar_size, sizes
from jauspy.schema.fields import BITS
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.model import ActionCall, Behavior, MessageDefinition, Schema, ServiceDefinition, State, Transition
from jauspy.schema.state_tree import short_name

MIN_NAME_WIDTH = 24
MIN_VALUES_WIDTH = 12
MAX_VALUES_WIDTH = 36
"""Columns of a table on a narrow terminal; longer text is folded."""


def show(
    *,
    name: Annotated[
        str,
        typer.Argument(
            metavar="NAME",
            help="A message or a service: its name, its URN, or a message id (0x4405); also NAME@1.0 or URN:1.0.",
        ),
    ],
    version: Annotated[
        str | None, typer.Option("--version", metavar="V", help="The service's version. Default: the newest.")
    ] = None,
    sources: SchemasOption = None,
    docs: Annotated[bool, typer.Option("--docs", help="Include the description of every field.")] = False,
    as_json: Json = False,
) -> None:
    """Show a message (fields, bytes, units, ranges) or a service (messages, states, transitions).

    Offsets count from the message id: `≤6` if optional fields before may be absent, `≥6` behind something of variable
    length, `+2` from the start of a list's item. Optional fields have their bit in the presence vector.

    Examples:
      jauspy schema show SetWrenchEffort
      jauspy schema show 4403h --docs
      jauspy schema show mobility:PrimitiveDriver@1.1
    """
    schema = definitions(sources)
    for number, match in enumerate(find(schema, name, version)):
        if as_json:
            console.print_json(_object(match))
            continue
        if number:
            console.print_lines("")
        if match.message is None:
            _show_service(match.service, schema)
        else:
            _show_message(match, match.message, docs=docs)
            _show_example(match, match.message, sources)


def _object(match: Match) -> dict[str, Any]:

    if match.message is None:
        return {"kind": "service", **as_object(match.service), "doc": match.service.doc}
    message = match.message
    least, most = sizes(message.body)
    return {
        "kind": "message",
        "code": f"{message.code:04X}",
        "name": message.name,
        "is_command": message.is_command,
        "service": match.service.id,
        "version": match.service.version,
        "also_in": [other.id for other in match.others],
        "doc": message.doc,
        "bytes": [least + 2, most + 2],
        "layout": [row.as_object() for row in rows(message)],
    }


# --- a message ------------------------------------------------------------------------------------------------------


def _show_message(match: Match, message: MessageDefinition, *, docs: bool) -> None:

    out = console.stdout()
    least, most = sizes(message.body)
    length = size_text((least + 2, most + 2)).replace("..", " to ")
    length = f"at least {length[: -len(' to ')]}" if length.endswith(" to ") else length
    facts = [f"{message.code:04X}h", *(["command"] if message.is_command else []), f"{length} bytes"]
    out.print(Text.assemble((message.name, "bold"), f"  {', '.join(facts)}"), soft_wrap=False)
    out.print(Text(f"{_direction(match.service, message)} {_title(match.service)}", style="dim"), soft_wrap=False)
    for other in match.others:
        out.print(Text(f"also in {_title(other)}", style="dim"), soft_wrap=False)
    if message.doc:
        out.print(Text(message.doc), soft_wrap=False)
    out.print()
    out.print(_table(rows(message), docs=docs), soft_wrap=False)


def _show_example(match: Match, message: MessageDefinition, sources: list[str] | None) -> None:
    """The command line that sends it, for messages that components take."""
    if not any(received.code == message.code for received in match.service.inputs):
        return
    registry = message_definitions(sources).registry
    with suppress(ConfigError):
        kind = registry.by_name(message.name, service=match.service.id, version=match.service.version)
        words = example(registry, kind)
        if not words:
            return
        out, text = console.stdout(), f"example:  {shlex.join(words)}"
        if len(text) > out.width:  # lines within quotes may be broken at spaces
            text = f"example:  {shlex.join(words[:4])}" + "".join(f" \\\n  {shlex.quote(word)}" for word in words[4:])
        out.print()
        out.print(Text(text), soft_wrap=False)


def _direction(service: ServiceDefinition, message: MessageDefinition) -> str:
    goes_in = any(received.code == message.code for received in service.inputs)
    goes_out = any(output.code == message.code for output in service.outputs)
    return "input and output of" if goes_in and goes_out else "input of" if goes_in else "output of"


def _title(service: ServiceDefinition) -> str:
    return f"{set_of(service)} {service.name} {service.version}"


def _table(rows: list[Row], *, docs: bool) -> Table:
    """The table of fields; names and values are folded if the terminal is too narrow."""
    has_bits = any(row.bit is not None for row in rows)
    table = Table(box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
    place = max(4, *(len(row.place) for row in rows))
    size = max(4, *(len(row.size) for row in rows))
    kind = max(4, *(len(row.type) for row in rows))
    name = max(5, *(2 * row.depth + len(row.name) for row in rows))
    left = console.stdout().width - place - size - kind - 2 * 4 - (5 if has_bits else 0)
    texts = [text for row in rows for text in (*row.notes, *([row.doc] if docs else []))]
    values = min(MAX_VALUES_WIDTH, max(map(len, texts)))
    name = min(name, max(MIN_NAME_WIDTH, left - values))
    table.add_column("byte", justify="right", width=place)
    table.add_column("size", justify="right", width=size)
    table.add_column("field", overflow="fold", width=name)
    table.add_column("type", width=kind)
    if has_bits:
        table.add_column("bit", justify="right", width=3)
    table.add_column("values", overflow="fold", width=max(MIN_VALUES_WIDTH, left - name))
    for row in rows:
        bits = [Text("" if row.bit is None else str(row.bit))] if has_bits else []
        notes = Text("\n".join(row.notes))
        if docs and row.doc:
            notes.append(("\n" if row.notes else "") + row.doc, "dim italic")
        shown = Text("  " * row.depth).append(row.name, "cyan")
        table.add_row(Text(row.place, "dim"), Text(row.size), shown, Text(row.type), *bits, notes)
    return table


# --- a service ------------------------------------------------------------------------------------------------------


def _show_service(service: ServiceDefinition, schema: Schema) -> None:

    out = console.stdout()
    out.print(Text.assemble((f"{service.name} {service.version}", "bold"), f"  {service.id}"), soft_wrap=False)
    for line in (service.doc, service.assumptions):
        if line:
            out.print(Text(line), soft_wrap=False)
    for what, names in _relations(service, schema):
        out.print(Text.assemble((f"{what} ", "dim"), names), soft_wrap=False)
    for what, messages in (("inputs", service.inputs), ("outputs", service.outputs)):
        _print_messages(what, messages)
    if service.internal_events:
        events = ", ".join(event.name for event in service.internal_events)
        out.print(Text.assemble("\n", ("internal events ", "dim"), events), soft_wrap=False)
    for tree in machine_trees(service.behavior) if service.behavior else ():
        out.print()
        out.print(tree, soft_wrap=False)


def _relations(service: ServiceDefinition, schema: Schema) -> Iterator[tuple[str, str]]:

    ancestors = lineage(service, parents_among((*load_builtin().services, *schema.services)))[1:]
    if ancestors:
        yield (
            "inherits from",
            ", ".join(f"{ancestor.id.rpartition(':')[2]} {ancestor.version}" for ancestor in ancestors),
        )
    if service.client_of:
        yield "client of", ", ".join(f"{server.id.rpartition(':')[2]} {server.version}" for server in service.client_of)


def _print_messages(what: str, messages: tuple[MessageDefinition, ...]) -> None:

    if not messages:
        return
    table = Table(box=None, pad_edge=False, show_header=False, padding=(0, 2, 0, 0))
    for message in messages:
        least, most = sizes(message.body)
        size = f"{size_text((least + 2, most + 2))} bytes"
        kind = "command" if message.is_command else ""
        table.add_row(Text(f"  {message.code:04X}h"), Text(message.name, "cyan"), Text(size), Text(kind, "dim"))
    console.stdout().print(Text(f"\n{what}", style="dim"))
    console.stdout().print(table, soft_wrap=False)


_LARGE = 100_000
"""Sizes above this are shown as unlimited."""


@dataclass(frozen=True, slots=True)
class Offset:
    """Minimal and maximal offset of a field, in bytes; `varies` if it depends on lengths and not on presence only."""

    low: int
    high: int
    varies: bool = False
    inside: bool = False

    def __str__(self) -> str:
        sign = "≥" if self.varies else "≤" if self.low < self.high else ""
        return f"{'+' if self.inside else ''}{sign}{self.low if self.varies else self.high}"

    def after(self, node: m.Node, *, optional: bool) -> Offset:
        """The offset after a member."""
        low, high = sizes(node)
        varies = self.varies or (low < high and not _only_presence(node))
        return replace(self, low=self.low + (0 if optional else low), high=self.high + high, varies=varies)

    def later(self, size: int) -> Offset:
        """The offset `size` bytes later."""
        return replace(self, low=self.low + size, high=self.high + size)


def _only_presence(node: m.Node) -> bool:
    """True when nothing but presence vectors makes the size of a node vary."""
    if isinstance(node, m.Record | m.Sequence):
        return all(map(_only_presence, node.fields if isinstance(node, m.Record) else node.items))
    low, high = sizes(node)
    return low == high


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a layout; `depth` is the nesting level, `bit` the bit in the presence vector."""

    depth: int
    name: str
    place: str
    size: str
    type: str
    bit: int | None = None
    notes: tuple[str, ...] = ()
    doc: str = ""

    def as_object(self) -> dict[str, Any]:
        """The row as a JSON object."""
        shown = {"depth": self.depth, "name": self.name, "offset": self.place, "size": self.size, "type": self.type}
        return {**shown, "presence_bit": self.bit, "values": list(self.notes), "doc": self.doc}


def rows(message: m.MessageDefinition) -> list[Row]:
    """The layout of a message from its id on; offsets include all optional fields before (`≤`)."""
    head = Row(0, "message id", "0", "2", "u16", notes=(f"{message.code:04X}h",))
    if message.body is None:
        return [head]
    place = Offset(2, 2)
    if isinstance(message.body, m.Record | m.Sequence):
        return [head, *_members(message.body, 0, place)]
    return [head, *_row(message.body, 0, place, None)]


def _members(node: m.Record | m.Sequence, depth: int, place: Offset) -> Iterator[Row]:
    members: Sequence[m.Node] = node.fields if isinstance(node, m.Record) else node.items
    if node.presence:
        size = scalar_size(node.presence)
        optional = sum(member.optional for member in members)
        notes = (f"{optional} optional" if optional <= 8 * size else f"{8 * size} bits for {optional} optional",)
        yield Row(depth, "presence vector", str(place), str(size), node.presence, notes=notes)
        place = place.later(size)
    bit = 0
    for member, possible in zip(members, can_be_there(node.presence, members), strict=True):
        has_bit = member.optional and node.presence is not None
        if not possible:
            yield Row(depth, member.name, "", "0", _type(member), notes=("never present: no presence bit is left",))
            continue
        yield from _row(member, depth, place, bit if has_bit else None)
        place = place.after(member, optional=has_bit)
        bit += has_bit


def _row(node: m.Node, depth: int, place: Offset, bit: int | None) -> Iterator[Row]:
    notes, inside = _notes(node)
    yield Row(
        depth=depth,
        name=node.name,
        place=str(place),
        size=size_text(sizes(node)),
        type=_type(node),
        bit=bit,
        notes=notes,
        doc=node.doc,
    )
    for name, type_, more, doc in inside:
        yield Row(depth + 1, name, "", "", type_, notes=more, doc=doc)
    match node:
        case m.Record() | m.Sequence():
            yield from _members(node, depth + 1, place)
        case m.List():
            yield from _row(node.element, depth + 1, Offset(0, 0, inside=True), None)
        case m.Variant():
            for number, arm in enumerate(node.arms):
                first, *rest = _row(arm, depth + 1, place.later(scalar_size(node.tag.type)), None)
                yield replace(first, notes=(f"tag {number}", *first.notes))
                yield from rest


def size_text(found: Sizes) -> str:
    """`4`, `4..26`, `4..` when there is no useful limit."""
    low, high = found
    return str(low) if low == high else f"{low}..{high if high < _LARGE else ''}"


def _type(node: m.Node) -> str:
    match node:
        case m.FixedField():
            return node.type
        case m.BitField():
            return f"{node.type} bits"
        case m.FixedString() | m.VariableString():
            return "text"
        case m.VariableLengthField():
            return "bytes"
        case m.VariableField():
            return "choice"
        case m.VariableFormatField():
            return "format"
        case m.Array():
            return _type(node.element) + "".join(f"[{dimension.size}]" for dimension in node.dimensions)
        case _:
            return type(node).__name__.lower()


_Inside = tuple[str, str, tuple[str, ...], str]
"""Name, type, notes and doc of a part without an offset, such as a bit."""


def _notes(node: m.Node) -> tuple[tuple[str, ...], list[_Inside]]:
    match node:
        case m.FixedField():
            return tuple(_values(node.type, node.units, node.scale, node.values)), []
        case m.BitField():
            return _reserved(node), [_bits(part) for part in node.subfields]
        case m.FixedString():
            return ("NUL padded",), []
        case m.VariableString():
            return (_count(node.count, "characters"),), []
        case m.VariableLengthField():
            return (node.format, _count(node.count, "bytes")), []
        case m.VariableField():
            return ("u8 index, then",), [_choice(part) for part in node.choices]
        case m.VariableFormatField():
            formats = [(f"{part.index} {part.name}", "", (), "") for part in node.formats]
            return ("u8 index", _count(node.count, "bytes")), list[_Inside](formats)
        case m.Array():
            return _notes(node.element)
        case m.List():
            return (_count(node.count, "items"),), []
        case m.Variant():
            return (f"{node.tag.type} tag, then one of",), []
        case _:
            return (), []


def _count(count: m.Count, what: str) -> str:
    return f"{count.type} count, {count.minimum}..{count.maximum} {what}"


def _reserved(node: m.BitField) -> tuple[str, ...]:
    used = sum(part.last - part.first + 1 for part in node.subfields)
    left = BITS[node.type] - used
    return (f"{left} reserved bit{'s' if left > 1 else ''}",) if left > 0 else ()


def _bits(part: m.SubField) -> _Inside:
    bits = f"bit {part.first}" if part.first == part.last else f"{part.first}..{part.last}"
    return part.name, bits, tuple(_value_set(part.values)), part.doc


def _choice(part: m.TypeChoice) -> _Inside:
    name = f"{part.index} {part.name or part.units}"
    return name, part.type, tuple(_values(part.type, part.units, part.scale, part.values)), part.doc


def _values(kind: m.Scalar, units: str, scale: m.Scale | None, values: m.ValueSet | None) -> Iterator[str]:
    symbol = unit_symbol(units)
    unit = f" {symbol}" if symbol else ""
    if scale is not None and CODES[kind] not in FLOATS:
        step = (scale.upper - scale.lower) / limits(CODES[kind])[1]
        how = "" if scale.function == "round" else f", {scale.function}"
        yield f"{scale.lower:.9g}..{scale.upper:.9g}{unit}, step {step:.3g}{how}"
        return
    found = list(_value_set(values, unit))
    yield from found
    if symbol and not found:
        yield symbol


def _value_set(values: m.ValueSet | None, unit: str = "") -> Iterator[str]:
    if values is None:
        return
    yield from (f"{enum.value} {enum.name}" for enum in values.enums)
    for part in values.ranges:
        low, high = ("" if part.lower_inclusive else ">", "" if part.upper_inclusive else "<")
        yield f"{low}{_limit(part.lower)}..{high}{_limit(part.upper)}{unit}"


def _limit(value: float) -> str:
    return f"{value}" if isinstance(value, int) else f"{value:.9g}"


def machine_trees(behavior: Behavior) -> Iterator[Tree]:
    """One tree per state machine."""
    starts = {start.machine: start.state for start in behavior.start}
    for machine in behavior.machines:
        start = starts.get(machine.name)
        label = Text.assemble((short_name(machine.name), "bold"), f" starts in {start}" if start else "")
        tree = Tree(label, guide_style="dim")
        _add_transitions(tree, machine.default_transitions, "by default ")
        for state in machine.states:
            _add_state(tree, state)
        yield tree


def _add_state(tree: Tree, state: State) -> None:
    initial = state.initial if state.initial != state.name else None
    branch = tree.add(Text.assemble((state.name, "cyan"), (f"  starts in {initial}" if initial else "", "dim")))
    for what, actions in (("entry", state.entry), ("exit", state.exit)):
        if actions:
            branch.add(Text.assemble((f"on {what}: ", "dim"), _actions(actions)))
    _add_transitions(branch, state.transitions, "")
    _add_transitions(branch, state.default_transitions, "by default ")
    for child in state.states:
        _add_state(branch, child)


def _add_transitions(tree: Tree, transitions: Iterable[Transition], prefix: str) -> None:
    for transition in transitions:
        tree.add(transition_text(transition, prefix))


def transition_text(transition: Transition, prefix: str = "") -> Text:
    """`RequestControl [isDefaultAuthorityGreater]: Send RejectControl -> Ready.Controlled`."""
    text = Text.assemble((prefix, "dim"), (trigger(transition), "bold"))
    if transition.guard:
        text.append(f" [{transition.guard}]", "yellow")
    if transition.actions:
        text.append(f": {_actions(transition.actions)}")
    if transition.kind == "pop":
        text.append(" -> back", "green")
    if transition.end_state is not None:
        text.append(f" -> {'push ' if transition.kind == 'push' else ''}{transition.end_state}", "green")
    return text


def _actions(actions: Sequence[ActionCall]) -> str:
    return ", ".join(map(_action, actions))


def _action(action: ActionCall) -> str:
    name = short_name(action.name)
    if name == "Send" and action.arguments:
        what, *rest = (argument.strip("'") for argument in action.arguments if argument != "transportData")
        return f"send {what}" + (f" {' '.join(rest)}" if rest else "")
    return f"{name}({', '.join(action.arguments)})"
