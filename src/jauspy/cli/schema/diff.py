"""`jauspy schema diff`: compare definitions."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.text import Text

from jauspy.cli import console
from jauspy.cli.options import Json
from jauspy.cli.schema.ls import is_set, split_version
from jauspy.errors import ConfigError
from jauspy.ids import is_called
from jauspy.schema import load_builtin
from jauspy.schema.differences import Change, MessageDiff, ServiceDiff, compare
from jauspy.schema.loader import load_own
from jauspy.schema.model import MessageDefinition, Schema, ServiceDefinition
from jauspy.schema.services import version_key

_WHAT = "A file, folder or pattern, or NAME@VERSION of a built-in service or set."


def diff(
    *,
    one: Annotated[str, typer.Argument(metavar="A", help=_WHAT)],
    other: Annotated[str, typer.Argument(metavar="B", help=_WHAT)],
    references: Annotated[
        list[str] | None,
        typer.Option(
            "--schemas", metavar="FILE", help="Further definitions that A and B refer to; they are not compared."
        ),
    ] = None,
    as_json: Json = False,
) -> None:
    """Compare definitions: messages, fields, values and behaviour.

    For every message, the output states whether it is identical on the wire: same bytes, numbers and limits.
    Differences of units and names are listed, too; descriptions are not compared.

    The exit status is 0 without differences, 1 with differences, 2 if A or B cannot be read.

    Examples:
      jauspy schema diff old/Lamp.xml new/Lamp.xml --schemas types/
      jauspy schema diff mobility:PrimitiveDriver@1.0 mobility:PrimitiveDriver@1.1
      jauspy schema diff mobility@1.1 vendor/ --json | jq -r '.messages[] | select(.wire == "different") | .name'
    """
    found = compare(_schema(one, references or []), _schema(other, references or []))
    for number, service in enumerate(found):
        if as_json:
            console.print_json(_object(service))
            continue
        if number:
            console.print_lines("")
        for line in _lines(service):
            console.stdout().print(line)
    if not all(service.same for service in found):
        raise typer.Exit(1)
    if not as_json:
        console.note("no differences")


def _schema(what: str, references: list[str]) -> Schema:
    """The services of an argument."""
    return (None if _is_file(what) else _builtin(*split_version(what))) or load_own([what], references)


def _is_file(what: str) -> bool:

    return Path(what).exists()


def _builtin(name: str, version: str | None) -> Schema | None:
    """The built-in services of this name, URN, end of a URN, or set; None if there is none."""
    wanted = name.casefold()
    called = [
        service
        for service in load_builtin().services
        if wanted == service.name.casefold() or is_set(service, wanted) or is_called(service.id, wanted)
    ]
    if not called:
        return None
    versions = sorted({service.version for service in called}, key=version_key)
    if version and version not in versions:
        raise ConfigError(f"{name} {version} is not built in; the versions are {', '.join(versions)}")
    return Schema(services=tuple(service for service in called if service.version == (version or versions[-1])))


# --- text -----------------------------------------------------------------------------------------------------


def _lines(service: ServiceDiff) -> Iterator[Text]:

    if service.one is None or service.other is None:
        changed = service.one or service.other
        assert changed is not None
        done = "removed" if service.other is None else "added"
        yield Text(f"{_title(changed)}: service {done}", style="red" if service.other is None else "green")
        return
    yield Text(f"{_title(service.one)} -> {_title(service.other)}", style="bold")
    for message in service.messages:
        yield from _message_lines(message)
    for sign, messages, style in (("-", service.removed, "red"), ("+", service.added, "green")):
        done = "removed" if sign == "-" else "added"
        yield from (Text(f"{sign} {_message(message)}: {done}", style=style) for message in messages)
    yield Text(f"{'~' if service.behavior else '='} behaviour: {'differs' if service.behavior else 'identical'}")
    yield from map(_change, service.behavior)


def _message_lines(diff: MessageDiff) -> Iterator[Text]:

    if diff.same_wire:
        kinds = {"names" if change.kind == "name" else change.kind for change in diff.changes}
        names = f", {' and '.join(sorted(kinds))} differ" if kinds else ""
        yield Text.assemble(f"= {_message(diff.one)}: ", ("identical on the wire", "green"), names)
    else:
        yield Text.assemble(f"~ {_message(diff.one)}: ", ("differs on the wire", "yellow"))
    yield from map(_change, diff.changes)


def _change(change: Change) -> Text:

    return Text.assemble("    ", (f"{change.path}: " if change.path else "", "cyan"), change.text)


def _message(message: MessageDefinition) -> str:
    return f"{message.code:04X}h {message.name}"


def _title(service: ServiceDefinition) -> str:
    return f"{service.id} {service.version}"


# --- JSON ---------------------------------------------------------------------------------------------------


def _object(service: ServiceDiff) -> dict[str, Any]:
    return {
        "a": _key(service.one),
        "b": _key(service.other),
        "same": service.same,
        "removed": [_named(message) for message in service.removed],
        "added": [_named(message) for message in service.added],
        "messages": [
            {
                **_named(message.one),
                "wire": "identical" if message.same_wire else "different",
                "changes": _changes(message.changes),
            }
            for message in service.messages
        ],
        "behavior": _changes(service.behavior),
    }


def _key(service: ServiceDefinition | None) -> dict[str, str] | None:
    return {"urn": service.id, "version": service.version} if service else None


def _named(message: MessageDefinition) -> dict[str, str]:
    return {"code": f"{message.code:04X}", "name": message.name}


def _changes(changes: tuple[Change, ...]) -> list[dict[str, str]]:
    return [{"kind": change.kind, "path": change.path, "change": change.text} for change in changes]
