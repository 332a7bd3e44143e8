"""`jauspy new definition`: the JSIDL of a service that reports numbers, takes commands and has states."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli.new import write_new
from jauspy.cli.new.jsidl import PARENTS, Command, Field, Jsidl
from jauspy.codec.names import attribute, class_name, snake
from jauspy.codec.registry import MessageEntry
from jauspy.messages import registry
from jauspy.schema.loader import load_own

MAX_FIELDS: Final = 16
"""Most fields of a message: the bits of its presence vector."""
URN: Final = re.compile(r"urn(:[A-Za-z0-9][\w.-]*)+:([A-Za-z]\w*)", re.ASCII)
COMMAND: Final = re.compile(r"([A-Za-z]\w*)\s*(?:\(([^()]*)\))?\s*(?:(\w*)\s*->\s*(\w+))?", re.ASCII)


def definition(
    *,
    urn: Annotated[str, typer.Argument(metavar="URN", help="The service's name, as in urn:example:Battery.")],
    fields: Annotated[
        list[str] | None,
        typer.Argument(metavar="[FIELD:UNITS...]", help="The reported fields, as in charge:percent cycles:one."),
    ] = None,
    commands: Annotated[
        list[str] | None,
        typer.Option(
            "--command",
            metavar="NAME[(FIELD:UNITS, ...)] [[STATE]->STATE]",
            help="A command, with its fields and the states that it leads from and to; repeatable.",
        ),
    ] = None,
    states: Annotated[
        str, typer.Option("--states", metavar="NAME,...", help="States of the service; it starts in the first one.")
    ] = "",
    inherits: Annotated[
        str | None,
        typer.Option(
            "--inherits",
            metavar="SERVICE",
            help=f"{', '.join(PARENTS)}. Default: Management if there are commands, otherwise Events.",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Default: battery.xml, for a Battery."),
    ] = None,
    first_id: Annotated[
        str, typer.Option("--first-id", metavar="HEX", help="The id of the first message; the others have the next.")
    ] = "D001",
) -> None:
    r"""Write the definition (JSIDL) of a service that reports numbers, takes commands and has states.

    Fields are 64-bit floats. Those of the report are optional, so that a client can request some of them. UNITS are
    JSIDL's, as in percent, volt, ampere, meter, "meter per second", or one for none. Message ids D000 to FFFF are for
    users; ids that a public definition uses are rejected.

    Services that move something inherit from Management: their commands are taken from the client in control, in the
    state Ready. Commands without states are taken in each state.

    Examples:
      jauspy new definition urn:example:Battery charge:percent current:ampere
      jauspy new definition urn:example:Winch tension:newton --states Idle,Pulling,Locked \
        --command "PullCable(speed:meter per second) Idle->Pulling" --command "StopCable ->Idle" \
        --command "LockDrum Idle->Locked" --command "UnlockDrum Locked->Idle"
    """
    name = _name(urn)
    reported, given = _fields(fields or []), [_command(text) for text in commands or []]
    if not reported and not given:
        raise typer.BadParameter("a service needs fields to report, or commands", param_hint="FIELD:UNITS")
    parent = _parent(inherits or ("Management" if given else "Events"))
    own_states = _states(states, given)
    messages = _messages(name, reported, given)
    codes = free_codes(first_id, len(messages))
    path = output or Path(f"{snake(name)}.xml")
    jsidl = Jsidl(
        urn=urn,
        name=name,
        parent=parent,
        fields=reported,
        commands=given,
        states=own_states,
        codes=dict(zip(messages, codes, strict=True)),
    )
    write_new({path: jsidl.text()})
    _check(path)


def _parent(name: str) -> str:
    """The name of the parent, as it is written in `PARENTS`."""
    found = next((known for known in PARENTS if known.casefold() == name.rpartition(":")[2].casefold()), None)
    if found is None:
        raise typer.BadParameter(f"{name!r} is not one of {', '.join(PARENTS)}", param_hint="--inherits")
    return found


def _states(text: str, commands: Sequence[Command]) -> list[str]:
    """The names of the states; raises `BadParameter` for those that commands name and that are not among them."""
    states = [name.strip() for name in text.split(",")] if text else []
    for name in states:
        if not (name.isidentifier() and name.isascii()) or states.count(name) > 1:
            raise typer.BadParameter(
                f"{name!r} is not the name of a state, or it is there twice", param_hint="--states"
            )
    for command in commands:
        for name in filter(None, (command.start, command.target)):
            if name not in states:
                raise typer.BadParameter(
                    f"{command.name} names the state {name}, which is not in --states {text or '(none)'}",
                    param_hint="--command",
                )
    return states


def _command(text: str) -> Command:
    match = COMMAND.fullmatch(text.strip())
    if match is None:
        raise typer.BadParameter(
            f"{text!r} is not NAME[(FIELD:UNITS, ...)] [[STATE]->STATE], as in "
            "'PullCable(speed:meter per second) Idle->Pulling'",
            param_hint="--command",
        )
    name, fields, start, target = match.groups(default="")
    listed = [field.strip() for field in fields.split(",")] if fields.strip() else []
    return Command(_jaus_name(name), tuple(_fields(listed)), start, target)


def _messages(name: str, fields: Sequence[Field], commands: Sequence[Command]) -> list[str]:
    """The names of the messages, in the order of their ids."""
    names = [f"Query{name}", f"Report{name}"] if fields else []
    names += [command.name for command in commands]
    known = {entry.name for entry in registry.entries}
    for message in names:
        if names.count(message) > 1 or message in known:
            why = "there twice" if names.count(message) > 1 else "the name of a public message"
            raise typer.BadParameter(f"{message} is {why}; choose another name", param_hint="--command")
    return names


def _name(urn: str) -> str:
    """The service's name, which is the end of its URN."""
    match = URN.fullmatch(urn)
    if match is None:
        raise typer.BadParameter(
            f"{urn!r} is not the URN of a service: urn:, an organisation, and a name that begins with a letter, "
            "as in urn:example:Battery",
            param_hint="URN",
        )
    if any(entry.service == urn for entry in registry.entries):
        raise typer.BadParameter(f"{urn} is a public service; choose another name", param_hint="URN")
    return class_name(match[2])


def _fields(texts: Sequence[str]) -> list[Field]:
    if len(texts) > MAX_FIELDS:
        raise typer.BadParameter(f"{len(texts)} fields; a message has up to {MAX_FIELDS}")
    fields = []
    for text in texts:
        name, colon, units = text.partition(":")
        if not colon or not name.isidentifier() or not name[0].isalpha() or not units.replace(" ", "").isalpha():
            raise typer.BadParameter(f"{text!r} is not NAME:UNITS, as in charge:percent")
        fields.append(Field(_jaus_name(name), units))
    if len({attribute(field.name) for field in fields}) != len(fields):
        raise typer.BadParameter("two fields have the same name")
    return fields


def _jaus_name(name: str) -> str:
    """`FlowRate` for `flow_rate`, and `V_2` for `v_2`, which Python would name `v2`."""
    words = [part[:1].upper() + part[1:] for part in name.split("_")]
    return "".join(words) if snake("".join(words)) == name else "_".join(words)


def _check(path: Path) -> None:
    """Read the written file, which raises an error if it is invalid."""
    load_own([path])


USER_IDS: Final = range(0xD000, 0xFFFF)
"""Message ids for users (AS5684); some public definitions use ids of this range, too."""


def free_codes(text: str, count: int) -> range:
    """The message ids from `text`, in hexadecimal digits; so many must be free."""
    try:
        code = int(text, 16)
    except ValueError:
        code = 0
    if not 0 < code <= USER_IDS.stop - count:
        last = f"{USER_IDS.stop - count:04X}"
        raise typer.BadParameter(f"{text!r} is not a message id; use D000 to {last}", param_hint="--first-id")
    codes = range(code, code + count)
    user = next((entry for taken in codes if (entry := _user(taken)) is not None), None)
    if user is not None:
        raise typer.BadParameter(
            f"{user.code:04X} is {user.name} of {user.service}; {_free_from(code, count)}", param_hint="--first-id"
        )
    return codes


def _user(code: int) -> MessageEntry | None:
    return next(iter(registry.entries_of(code)), None)


def _free_from(code: int, count: int) -> str:
    """The next free ids, at least `count`; those from D000 if there are no higher ones."""
    starts = [
        first for first in USER_IDS[: len(USER_IDS) - count + 1] if not any(map(_user, range(first, first + count)))
    ]
    first = next((start for start in starts if start > code), starts[0])
    last = next(end for end in USER_IDS if end >= first and (_user(end + 1) is not None or end + 1 not in USER_IDS))
    return f"{first:04X} to {last:04X} are free"
