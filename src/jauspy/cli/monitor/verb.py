"""`jauspy monitor`: watch components and their messages on a full screen."""

from __future__ import annotations

import asyncio
import shlex
import sys
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer
from rich.text import Text

from jauspy.capture.filters import Filter
from jauspy.cli import console
from jauspy.cli.definitions import Definitions, SchemasOption, definitions
from jauspy.cli.fields import message_class, message_from
from jauspy.cli.monitor import texts
from jauspy.cli.monitor.app import Ask, MonitorApp
from jauspy.cli.monitor.sources import CaptureSource, LiveSource
from jauspy.cli.options import DEFAULT_ROOT, FilterOption, LocalRoot, OwnId
from jauspy.cli.traffic import open_capture
from jauspy.codec.registry import NO_HINTS
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.inspection.timeline import Timeline
from jauspy.printable import printable_lines

if TYPE_CHECKING:
    from jauspy.ocu import OCU

ANSWER_SECONDS: Final = 2.0


def monitor(
    *,
    capture: Annotated[
        Path | None,
        typer.Argument(metavar="[CAPTURE]", help="A pcap, pcapng or MCAP file instead of what is routed now."),
    ] = None,
    only: FilterOption = None,
    own_id: OwnId = None,
    root: LocalRoot = DEFAULT_ROOT,
    schemas: SchemasOption = None,
) -> None:
    """Watch subsystems, components and their messages on a full screen, live or from a capture.

    It only listens, unless a query is typed: names, services, states and who controls whom are inferred from messages
    that others exchange. A capture has a slider of its time. The key ? lists the keys.

    Examples:
      jauspy monitor
      jauspy monitor run.pcap
      jauspy monitor --filter 'src == 101.* and not msg == ReportHeartbeatPulse'
    """
    known = definitions(schemas)
    if only is not None:
        Filter(only, known.registry)  # an error is a sentence before the screen is taken
    screen = (sys.stdin, sys.stdout, sys.__stderr__ or sys.stderr)  # textual draws on the last
    if not all(stream.isatty() for stream in screen):
        raise ConfigError("the monitor needs a terminal; `jauspy echo`, `hz` and `graph` print the same in a pipe")
    if capture is not None:
        console.note(f"reading {capture}")
        with open_capture(capture, root) as opened:
            timeline = Timeline(opened, known.registry)
        MonitorApp(CaptureSource(timeline), known.registry, capture.name, None, only).run()
        return
    with closing(LiveSource(root, known.registry)) as source:
        MonitorApp(source, known.registry, f"live {root}", asking(root, own_id, known), only).run()


def asking(root: Path, own_id: str | None, known: Definitions) -> Ask:
    """The function that sends a typed query as a client of the node manager of a local root."""

    async def ask(to: JausID, line: str) -> Text:
        try:
            name, *fields = shlex.split(line) or [""]
            cls = message_class(known.registry, name, NO_HINTS)
            if not cls.IS_QUERY:
                raise ConfigError(f"{cls.NAME} is not a query; `jauspy send` sends commands")
            query = message_from(known.registry, name, fields)
            ocu = await asyncio.to_thread(_made, root, own_id, known)
            async with ocu:
                answer = await ocu.query(to, query)
        except (JausError, ValueError) as error:  # ValueError: quotes that do not end
            return Text(printable_lines(str(error)), style=texts.RED)
        return Text.assemble((f"{answer.NAME}\n", "bold"), texts.fields_text(answer))

    return ask


def _made(root: Path, own_id: str | None, known: Definitions) -> OCU:
    from jauspy.cli import client  # takes seconds, which the first query waits for, and not the screen

    return client.make_ocu(own_id, f"local:{root}", ANSWER_SECONDS, known.registry)
