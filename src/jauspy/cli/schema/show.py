"""`jauspy schema show`: one message or one service, readable."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jauspy.cli.options import Json
from jauspy.cli.schema.options import From, definitions, set_of

if TYPE_CHECKING:
    from rich.table import Table

    from jauspy.cli.schema.lookup import Match
    from jauspy.cli.schema.rows import Row
    from jauspy.schema.model import Message, Schema, Service

_NARROWEST_NAME = 24
_NARROWEST_VALUES = 12
_WIDEST_VALUES = 36
"""Columns of a table on a narrow terminal; what is longer is folded."""


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
        str | None, typer.Option("--version", metavar="V", help="Of the service; else the newest.")
    ] = None,
    sources: From = None,
    docs: Annotated[bool, typer.Option("--docs", help="Also what every field means.")] = False,
    as_json: Json = False,
) -> None:
    """Show a message (fields, bytes, units, ranges) or a service (messages, states, transitions).

    Offsets count from the message id: `≤6` if optional fields before may be absent, `≥6` behind something of varying
    length, `+2` from the start of a list's item. Optional fields have their bit in the presence vector.

    Examples:
      jauspy schema show SetWrenchEffort
      jauspy schema show 4403h --docs
      jauspy schema show mobility:PrimitiveDriver@1.1
    """
    import json

    from jauspy.cli.schema.lookup import find

    schema = definitions(sources)
    for number, match in enumerate(find(schema, name, version)):
        if as_json:
            print(json.dumps(_object(match), ensure_ascii=False))
            continue
        if number:
            print()
        if match.message is None:
            _show_service(match.service, schema)
        else:
            _show_message(match, match.message, docs=docs)


def _object(match: Match) -> dict[str, Any]:
    from jauspy.cli.schema.ls import as_object
    from jauspy.cli.schema.rows import rows
    from jauspy.schema.wire import sizes

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


def _show_message(match: Match, message: Message, *, docs: bool) -> None:
    from rich.text import Text

    from jauspy.cli import console
    from jauspy.cli.schema.rows import rows, size_text
    from jauspy.schema.wire import sizes

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


def _direction(service: Service, message: Message) -> str:
    goes_in = any(each.code == message.code for each in service.inputs)
    goes_out = any(each.code == message.code for each in service.outputs)
    return "input and output of" if goes_in and goes_out else "input of" if goes_in else "output of"


def _title(service: Service) -> str:
    return f"{set_of(service)} {service.name} {service.version}"


def _table(rows: list[Row], *, docs: bool) -> Table:
    """Names and values are folded where the terminal is too narrow, everything else is short."""
    from rich.table import Table
    from rich.text import Text

    from jauspy.cli import console

    has_bits = any(row.bit is not None for row in rows)
    table = Table(box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
    place = max(4, *(len(row.place) for row in rows))
    size = max(4, *(len(row.size) for row in rows))
    kind = max(4, *(len(row.type) for row in rows))
    name = max(5, *(2 * row.depth + len(row.name) for row in rows))
    left = console.stdout().width - place - size - kind - 2 * 4 - (5 if has_bits else 0)
    texts = [text for row in rows for text in (*row.notes, *([row.doc] if docs else []))]
    values = min(_WIDEST_VALUES, max(map(len, texts)))
    name = min(name, max(_NARROWEST_NAME, left - values))
    table.add_column("byte", justify="right", width=place)
    table.add_column("size", justify="right", width=size)
    table.add_column("field", overflow="fold", width=name)
    table.add_column("type", width=kind)
    if has_bits:
        table.add_column("bit", justify="right", width=3)
    table.add_column("values", overflow="fold", width=max(_NARROWEST_VALUES, left - name))
    for row in rows:
        bits = [Text("" if row.bit is None else str(row.bit))] if has_bits else []
        notes = Text("\n".join(row.notes))
        if docs and row.doc:
            notes.append(("\n" if row.notes else "") + row.doc, "dim italic")
        shown = Text("  " * row.depth).append(row.name, "cyan")
        table.add_row(Text(row.place, "dim"), Text(row.size), shown, Text(row.type), *bits, notes)
    return table


# --- a service ------------------------------------------------------------------------------------------------------


def _show_service(service: Service, schema: Schema) -> None:
    from rich.text import Text

    from jauspy.cli import console
    from jauspy.cli.schema.machines import machine_trees

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


def _relations(service: Service, schema: Schema) -> Iterator[tuple[str, str]]:
    from jauspy.schema import load_builtin
    from jauspy.schema.inheritance import lineage, parents_among

    ancestors = lineage(service, parents_among((*load_builtin().services, *schema.services)))[1:]
    if ancestors:
        yield "inherits from", ", ".join(f"{each.id.rpartition(':')[2]} {each.version}" for each in ancestors)
    if service.client_of:
        yield "client of", ", ".join(f"{each.id.rpartition(':')[2]} {each.version}" for each in service.client_of)


def _print_messages(what: str, messages: tuple[Message, ...]) -> None:
    from rich.table import Table
    from rich.text import Text

    from jauspy.cli import console
    from jauspy.cli.schema.rows import size_text
    from jauspy.schema.wire import sizes

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
