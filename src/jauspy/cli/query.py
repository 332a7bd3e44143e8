"""`jauspy query`: ask a component, print its answer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.definitions import Beside, ServiceName, ServiceVersion
from jauspy.cli.options import Connect, OwnId, Timeout

if TYPE_CHECKING:
    from jauspy.codec.message import Message
    from jauspy.ids import JausID
    from jauspy.ocu import OCU

Destination = Annotated[
    str, typer.Argument(metavar="ID", help="The component, as in 101.1.102; 65535, 255 and 255 stand for all.")
]
MessageName = Annotated[str, typer.Argument(metavar="MESSAGE", help="The message's JAUS name; case does not matter.")]
Fields = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="[FIELD=VALUE]...",
        help="Numbers (12, 0x1ff, 1.5e3) in the field's units, names of enumerations, text, JSON or YAML for lists and "
        "mappings; a dot reaches into mappings. A wrong field name lists the right ones with units.",
    ),
]


def query(
    *,
    destination: Destination,
    message: MessageName,
    fields: Fields = None,
    sources: Beside = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 2.0,
) -> None:
    """Ask a component and print its answer.

    The answer is YAML on a terminal, one JSON object per line in a pipe. Of an id with wildcards, as in 101.1.255, all
    who answer within the timeout are shown. A presence vector that is not given asks
    for every field. Lengths are in metres, angles in radians, times in seconds.

    Examples:
      jauspy query 101.1.102 QueryStatus
      jauspy query 101.1.102 QueryLocalPose presence_vector=0x43
      jauspy query 65535.255.255 QueryIdentification query_type=2
    """
    from jauspy.cli import addresses
    from jauspy.cli.definitions import definitions
    from jauspy.cli.fields import message_from
    from jauspy.cli.run import run
    from jauspy.errors import ConfigError

    to = addresses.destination(destination)
    known = definitions(sources)
    question = message_from(known.registry, message, fields or [], known.hints(service, version))
    if not question.IS_QUERY:
        raise ConfigError(f"{question.NAME} is no query, nothing would answer it; use `jauspy send`")
    ocu = addresses.client(own_id, connect, timeout, known.registry)
    run(_ask_all(ocu, to, question, timeout) if to.is_wildcard else _ask(ocu, to, question))


async def _ask(ocu: OCU, to: JausID, question: Message) -> None:
    """One answer."""
    async with ocu:
        answer = await ocu.query(to, question)
    _show(answer, to)


async def _ask_all(ocu: OCU, to: JausID, question: Message, patience: float) -> None:
    """All answers, as they come."""
    from jauspy.errors import ResponseTimeout

    count = 0
    async with ocu:
        async for source, answer in ocu.query_each(to, question, within=patience):
            _show(answer, source, first=not count)
            count += 1
    if not count:
        raise ResponseTimeout(f"nobody that {to} stands for answered {question.NAME} within {patience:g} s")


def _show(answer: Message, source: JausID, *, first: bool = True) -> None:
    import json

    from rich.text import Text

    from jauspy.cli import console
    from jauspy.cli.render import field_lines

    if not console.is_terminal():
        shown = {
            "source": str(source),
            "message": answer.NAME,
            "code": f"{answer.CODE:04X}",
            "fields": answer.to_dict(),
        }
        print(json.dumps(shown, ensure_ascii=False), flush=True)
        return
    if not first:
        console.stdout().print(Text("---", style="dim"))
    console.stdout().print(Text(f"# {answer.NAME} ({answer.CODE:04X}h) from {source}", style="dim"))
    for line in list(field_lines(answer, yaml=True)) or [Text("{}")]:
        console.stdout().print(line)
