"""`jauspy echo`: print messages as they are routed, or from a capture."""

from __future__ import annotations

import sys
import time
from collections.abc import AsyncGenerator
from contextlib import aclosing
from typing import Annotated, Any

import typer

from jauspy.capture.filters import Filter, printed_values
from jauspy.cli import console
from jauspy.cli.decode_formats import part_json
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import DEFAULT_ROOT, Connect, FilterOption, Json, LocalRoot, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.cli.render import Styled, styled_fields
from jauspy.cli.traffic import (
    CaptureFile,
    Interface,
    MessageName,
    Multicast,
    NetworkPort,
    Sender,
    chosen_network,
    combined,
    traffic,
)
from jauspy.errors import ConfigError
from jauspy.inspection.rates import Route
from jauspy.inspection.traffic import SeenMessage
from jauspy.printable import printable


def echo(
    *,
    source: Sender = None,
    message: MessageName = None,
    only: FilterOption = None,
    rate: Annotated[
        float | None,
        typer.Option("--rate", min=0.001, metavar="HZ", help="At most so many a second of one name from one sender."),
    ] = None,
    field: Annotated[
        list[str] | None, typer.Option("--field", metavar="NAME", help="Print only this field; may be repeated.")
    ] = None,
    count: Annotated[int | None, typer.Option("--count", min=1, help="End after so many messages.")] = None,
    json: Json = False,
    file: CaptureFile = None,
    interface: Interface = None,
    multicast: Multicast = None,
    port: NetworkPort = None,
    subscribe: Annotated[
        bool,
        typer.Option(
            "--subscribe",
            help="Create an event at the component instead of listening, with --rate a periodic one, and print its "
            "reports.",
        ),
    ] = False,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 2.0,
    root: LocalRoot = DEFAULT_ROOT,
    schemas: SchemasOption = None,
) -> None:
    """Print messages as the node manager of this machine routes them, until Ctrl-C.

    It only listens: it sends nothing, and components do not notice it. A message to several receivers is printed once.
    With --subscribe it is a client: it creates an event for one report, and cancels it at the end.

    Examples:
      jauspy echo
      jauspy echo 101.1.102 ReportLocalPose --rate 2
      jauspy echo '*' 'Report*' --filter 'x > 5' --field x --field y
      jauspy echo 42.* --capture run.pcap --json
      jauspy echo 101.1.102 ReportLocalPose --subscribe --rate 5
    """
    known = definitions(schemas)
    if subscribe:
        if file is not None or interface is not None or multicast is not None:
            raise ConfigError("--subscribe creates an event at a component; it does not read a capture or a network")
        from jauspy.cli import client  # this and the next take seconds, and listening needs neither
        from jauspy.cli.event_reports import event_query, event_reports

        component, query = event_query(source, message, known)
        fits = None if only is None else Filter(only, known.registry)
        ocu = client.make_ocu(own_id, connect, timeout, known.registry)
        run(_print_reports(event_reports(ocu, component, query, rate), _Printer(_paths(field), json), fits, count))
        return
    due: dict[Route, float] = {}
    printer = _Printer(_paths(field), json)
    network = chosen_network(interface, multicast, port, file)
    with traffic(file, root, known, combined(source, message, only), network=network) as found:
        for seen in found:
            if rate is not None:
                route = Route(str(seen.part.packet.source), "", seen.name)
                if seen.time < due.get(route, seen.time):
                    continue
                due[route] = seen.time + 1.0 / rate
            if not printer.show(seen):
                continue
            sys.stdout.flush()
            if count is not None:
                count -= 1
                if not count:
                    break


def _paths(fields: list[str] | None) -> tuple[str, ...]:
    return tuple(name.lower() for name in fields or ())


async def _print_reports(
    reports: AsyncGenerator[SeenMessage, None], printer: _Printer, fits: Filter | None, count: int | None
) -> None:
    """Print reports that fit, `count` of them or until cancelled; the event is cancelled then."""
    async with aclosing(reports):
        async for seen in reports:
            if (fits is not None and not fits(seen.part)) or not printer.show(seen):
                continue
            sys.stdout.flush()
            if count is not None:
                count -= 1
                if not count:
                    return


class _Printer:
    def __init__(self, fields: tuple[str, ...], as_json: bool) -> None:
        self._fields = fields
        self._as_json = as_json
        self._print = console.styled_printer()

    def show(self, seen: SeenMessage) -> bool:
        """Print a message; false if it has none of the fields."""
        part = seen.part
        values = [(path, list(printed_values(part.content.message, path))) for path in self._fields]
        if self._fields and not any(found for _, found in values):
            return False
        if self._as_json:
            shown: dict[str, Any] = {"time": seen.time}
            if self._fields:
                shown |= {"source": str(part.packet.source), "message": seen.name}
                shown |= {name: found[0] if len(found) == 1 else found for name, found in values}
            else:
                shown |= part_json(part)
            console.print_json(shown, flush=False)
            return True
        stamp = f"{time.strftime('%H:%M:%S', time.localtime(seen.time))}.{round(seen.time % 1.0 * 1e3) % 1000:03d}"
        route = f"{part.packet.source} → {part.packet.destination}"
        head: Styled = [(f"{stamp}  ", "dim"), (f"{route}  ", ""), (seen.name, "bold")]
        if self._fields:
            text = "  ".join(f"{name}: {', '.join(map(_shown, found))}" for name, found in values if found)
            self._print([[*head, (f"  {text}", "")]])
            return True
        lines = [head]
        if part.content.message is not None:
            lines += styled_fields(part.content.message, margin="     ")
        elif part.content.problem:
            lines.append([(f"     {part.content.problem}", "yellow")])
        lines += [[(f"     {deviation}", "yellow")] for deviation in part.content.deviations]
        self._print(lines)
        return True


def _shown(value: object) -> str:
    name = getattr(value, "name", None)
    if isinstance(name, str):
        return name
    return f"{value:.9g}" if isinstance(value, float) else printable(str(value))
