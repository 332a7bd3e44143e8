"""`jauspy query`: query a component and print its answer."""

from __future__ import annotations

import asyncio
import itertools
from collections.abc import Awaitable, Callable
from typing import Annotated, Final, Protocol

import typer
from rich.text import Text

from jauspy.cli import client, console
from jauspy.cli.definitions import SchemasOption, ServiceName, ServiceVersion, definitions
from jauspy.cli.fields import message_class, message_from
from jauspy.cli.options import Connect, Json, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.cli.render import field_lines
from jauspy.codec.layout import Composite
from jauspy.codec.message import Message
from jauspy.codec.rounding import rounded_dict
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.ocu import OCU

_WITH_SIDES: Final = frozenset(
    {"y", "yaw", "heading", "velocity_y", "yaw_rate", "acceleration_y", "yaw_acceleration"}
    | {"propulsive_linear_effort_y", "propulsive_rotational_effort_z"}
)
"""Fields whose sign distinguishes left and right."""

Destination = Annotated[
    str, typer.Argument(metavar="ID", help="The component, as in 101.1.102; 65535, 255 and 255 are wildcards.")
]
MessageName = Annotated[str, typer.Argument(metavar="MESSAGE", help="The message's JAUS name, in any case.")]
Fields = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="[FIELD=VALUE]...",
        help="Numbers (12, 0x1ff, 1.5e3) in the field's units, names of enumerations, text, JSON or YAML for lists and "
        "mappings; a dot separates nested names. An unknown field name is answered with a list of the fields.",
    ),
]


def query(
    *,
    destination: Destination,
    message: MessageName,
    fields: Fields = None,
    sources: SchemasOption = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    connect: Connect = None,
    own_id: OwnId = None,
    every: Annotated[
        float | None,
        typer.Option("--every", min=0.01, metavar="SECONDS", help="Query again at this interval, until Ctrl-C."),
    ] = None,
    count: Annotated[
        int | None, typer.Option("--count", min=1, metavar="N", help="With --every: end after this many queries.")
    ] = None,
    timeout: Timeout = 2.0,
    as_json: Json = False,
) -> None:
    """Query a component and print its answer.

    The answer is YAML on a terminal, and one JSON object per line in a pipe or with --json. For an id with wildcards,
    as in 101.1.255, all answers within the timeout are printed. Without a presence vector, every field is requested.
    Lengths are in metres, angles in radians, times in seconds. Poses and velocities of messages have the axes of JAUS:
    x forward, y right, z down; `jauspy tf` shows poses with y to the left (REP-103). With --every, a missing answer is
    noted on stderr, and the next query is sent all the same; the exit status is 1 if none was answered.

    Examples:
      jauspy query 101.1.102 QueryStatus
      jauspy query 101.1.102 QueryLocalPose presence_vector=0x43
      jauspy query 65535.255.255 QueryIdentification query_type=2
      jauspy query 101.1.102 QueryLocalPose --every 0.5 --count 10

    `jauspy schema show MESSAGE` prints an example of any message, lists and records included.
    """
    recipient = client.destination(destination)
    known = definitions(sources)
    hints = known.hints(service, version)
    cls = message_class(known.registry, message, hints)
    if not cls.IS_QUERY:  # before its fields, which nobody needs to give
        raise ConfigError(f"{cls.NAME} {_no_query(cls)}")
    query_message = message_from(known.registry, message, fields or [], hints)
    if count is not None and every is None:
        raise typer.BadParameter("it requires --every", param_hint="--count")
    ocu = client.make_ocu(own_id, connect, timeout, known.registry)
    show = _show_yaml if console.shows_yaml(as_json=as_json) else _show_json

    async def ask(first: bool) -> None:
        if recipient.is_wildcard:
            await _ask_all(ocu, recipient, query_message, timeout, show, first=first)
        else:
            await _ask(ocu, recipient, query_message, show, first=first)

    run(repeated(ocu, ask, every, count))


def _no_query(message: type[Message]) -> str:
    """Explain what a message that is no query is, and which verb is meant."""
    if message.IS_COMMAND or not message.NAME.startswith("Report"):
        return "is not a query and has no answer; use `jauspy send`"
    query_name = message.NAME.replace("Report", "Query", 1)
    return f"is not a query but the answer to one; `jauspy query ID {query_name}` asks for it"


async def repeated(ocu: OCU, ask: Callable[[bool], Awaitable[None]], every: float | None, count: int | None) -> None:
    """Call `ask` once, or at an interval in seconds; `count` times, or until cancelled.

    Its argument is true the first time. Raises `ResponseTimeout` if none of several queries was answered.
    """
    async with ocu:
        if every is None:
            await ask(True)
            return
        clock = asyncio.get_running_loop().time
        due = clock()
        answered = 0
        for number in range(count) if count is not None else itertools.count():
            due = max(due, clock())
            await asyncio.sleep(due - clock())
            due += every
            try:
                await ask(number == 0)
                answered += 1
            except ResponseTimeout as error:
                console.note(str(error))
        if not answered:
            raise ResponseTimeout(f"none of {count} queries was answered")


async def _ask(ocu: OCU, to: JausID, query_message: Message, show: Show, *, first: bool) -> None:
    """Print the answer of one component."""
    try:
        answer = await ocu.query(to, query_message)
    except ResponseTimeout as error:
        reason = await ocu.explain(to, query_message)
        if reason and not reason.startswith(f"{to} does not answer"):
            raise ResponseTimeout(f"{query_message.NAME} was not answered: {reason}") from error
        raise
    show(answer, to, first=first)


async def _ask_all(ocu: OCU, to: JausID, query_message: Message, max_wait: float, show: Show, *, first: bool) -> None:
    """Print all answers as they arrive."""
    count = 0
    async for source, answer in ocu.query_each(to, query_message, within=max_wait):
        show(answer, source, first=first and not count)
        count += 1
    if not count:
        raise ResponseTimeout(f"no component of {to} answered {query_message.NAME} within {max_wait:g} s")


class Show(Protocol):
    """Prints answers."""

    def __call__(self, answer: Message, source: JausID, *, first: bool) -> None:
        """Print an answer; `first` is true for the first one."""


def _show_json(answer: Message, source: JausID, *, first: bool) -> None:  # noqa: ARG001 - of `Show`
    shown = {
        "source": str(source),
        "message": answer.NAME,
        "code": f"{answer.CODE:04X}",
        "fields": rounded_dict(answer),
    }
    if has_axes(answer):
        shown["axes"] = "JAUS"
    console.print_json(shown)


def _show_yaml(answer: Message, source: JausID, *, first: bool) -> None:
    if not first:
        console.stdout().print(Text("---", style="dim"))
    axes = "; axes of JAUS: x forward, y right, z down" if has_axes(answer) else ""
    console.stdout().print(Text(f"# {answer.NAME} ({answer.CODE:04X}h) from {source}{axes}", style="dim"))
    for line in list(field_lines(answer, yaml=True)) or [Text("{}")]:
        console.stdout().print(line)


def has_axes(message: Message) -> bool:
    """True for poses, velocities and efforts of the platform, whose axes are easily taken for those of REP-103."""
    layout = message.layout()
    names = {slot.name for slot in layout.slots} if isinstance(layout, Composite) else set()
    return ":mobility:" in message.SERVICE and not names.isdisjoint(_WITH_SIDES)
