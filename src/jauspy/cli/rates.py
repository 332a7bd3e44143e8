"""`jauspy hz`, `jauspy bw` and `jauspy graph`: how often messages come, how much they take, who talks to whom."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Annotated, NamedTuple

import typer

from jauspy.cli import console
from jauspy.cli.definitions import Definitions, SchemasOption, definitions
from jauspy.cli.options import DEFAULT_ROOT, FilterOption, Json, LocalRoot
from jauspy.cli.traffic import (
    CaptureFile,
    Interface,
    MessageName,
    Multicast,
    Network,
    NetworkPort,
    Sender,
    chosen_network,
    combined,
    traffic,
)
from jauspy.errors import ConfigError
from jauspy.inspection.graph import Graph
from jauspy.inspection.rates import Rate, Rates, Route

Seconds = Annotated[
    float, typer.Option("--for", min=0.1, metavar="SECONDS", help="How long to listen. A file is read to its end.")
]


class Listening(NamedTuple):
    """Where messages are looked for, and for how many seconds."""

    file: Path | None
    root: Path
    network: Network | None
    seconds: float

    def rates(self, known: Definitions, only: str | None) -> Rates:
        """The rates of the messages that fit a filter. Raises `ConfigError` or `TransportError`."""
        found = Rates()
        with traffic(self.file, self.root, known, only, self.seconds, network=self.network) as messages:
            if self.file is None:
                console.note(f"listening for {self.seconds:g} s")
            for seen in messages:
                found.add(seen)
        return found


def hz(
    *,
    source: Sender = None,
    message: MessageName = None,
    only: FilterOption = None,
    seconds: Seconds = 5.0,
    json: Json = False,
    file: CaptureFile = None,
    interface: Interface = None,
    multicast: Multicast = None,
    port: NetworkPort = None,
    root: LocalRoot = DEFAULT_ROOT,
    schemas: SchemasOption = None,
) -> None:
    """Measure how often messages come: rate, shortest and longest interval, and their standard deviation.

    Examples:
      jauspy hz
      jauspy hz 101.1.102 'Report*' --for 10
      jauspy hz --capture run.pcap --json
    """
    listening = Listening(file, root, chosen_network(interface, multicast, port, file), seconds)
    rates = listening.rates(definitions(schemas), combined(source, message, only))
    rows = sorted(rates.routes.items(), key=lambda row: (-(row[1].frequency or 0.0), row[0]))
    if json:
        _print_json(rows, rates.seconds)
        return
    _print_table(
        ("message", "from", "to", "count", "Hz", "shortest ms", "longest ms", "deviation ms"),
        rows,
        lambda rate: (
            _digits(rate.frequency, 1.0),
            _digits(rate.shortest if rate.count > 1 else None, 1e3),
            _digits(rate.longest if rate.count > 1 else None, 1e3),
            _digits(rate.jitter, 1e3),
        ),
        rates,
    )


def bw(
    *,
    source: Sender = None,
    message: MessageName = None,
    only: FilterOption = None,
    seconds: Seconds = 5.0,
    json: Json = False,
    file: CaptureFile = None,
    interface: Interface = None,
    multicast: Multicast = None,
    port: NetworkPort = None,
    root: LocalRoot = DEFAULT_ROOT,
    schemas: SchemasOption = None,
) -> None:
    """Measure how many bytes a second messages take: packets with their headers, without those of UDP and IP.

    Examples:
      jauspy bw
      jauspy bw 101.* --for 10
      jauspy bw --capture run.pcap
    """
    listening = Listening(file, root, chosen_network(interface, multicast, port, file), seconds)
    rates = listening.rates(definitions(schemas), combined(source, message, only))
    rows = sorted(rates.routes.items(), key=lambda row: (-row[1].bytes, row[0]))
    if json:
        _print_json(rows, rates.seconds)
        return
    per_second = 1.0 / max(rates.seconds, 1e-3)
    _print_table(
        ("message", "from", "to", "count", "bytes/s", "mean bytes"),
        rows,
        lambda rate: (f"{rate.bytes * per_second:.0f}", f"{rate.bytes / rate.count:.0f}"),
        rates,
    )
    total = sum(rate.bytes for rate in rates.routes.values())
    console.print_lines(f"{total * per_second:.0f} bytes/s in all")


def graph(
    *,
    source: Sender = None,
    message: MessageName = None,
    only: FilterOption = None,
    seconds: Seconds = 5.0,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write a drawing (.svg), or Graphviz's language (.dot)."),
    ] = None,
    json: Json = False,
    file: CaptureFile = None,
    interface: Interface = None,
    multicast: Multicast = None,
    port: NetworkPort = None,
    root: LocalRoot = DEFAULT_ROOT,
    schemas: SchemasOption = None,
) -> None:
    """Show who talks to whom: the messages between components, with their rates.

    Examples:
      jauspy graph
      jauspy graph --capture run.pcap -o talks.svg
    """
    if output is not None and output.suffix not in (".svg", ".dot"):
        raise ConfigError(f"{output} is neither a .svg nor a .dot file")
    listening = Listening(file, root, chosen_network(interface, multicast, port, file), seconds)
    rates = listening.rates(definitions(schemas), combined(source, message, only))
    found = Graph(rates)
    if output is not None:
        try:
            output.write_text(found.svg() if output.suffix == ".svg" else found.dot(), encoding="utf-8")
        except OSError as error:
            raise ConfigError(f"{output} cannot be written: {error.strerror}") from None
    elif json:
        _print_json(rates.routes.items(), rates.seconds)
    else:
        console.print_lines(*found.lines())
    if not found.arrows:
        console.note("no messages")


def _print_table(
    header: tuple[str, ...],
    rows: Iterable[tuple[Route, Rate]],
    cells: Callable[[Rate], tuple[str, ...]],
    rates: Rates,
) -> None:
    table = [(route.message, route.source, route.destination, str(rate.count), *cells(rate)) for route, rate in rows]
    if not table:
        console.note("no messages")
        return
    console.print_table(header, table)
    console.note(f"{sum(rate.count for rate in rates.routes.values())} messages in {rates.seconds:.1f} s")


def _print_json(rows: Iterable[tuple[Route, Rate]], seconds: float) -> None:
    for route, rate in rows:
        several = rate.count > 1
        console.print_json(
            {
                **route._asdict(),
                "count": rate.count,
                "bytes": rate.bytes,
                "seconds": round(seconds, 6),
                "hz": rate.frequency,
                "shortest": rate.shortest if several else None,
                "longest": rate.longest if several else None,
                "deviation": rate.jitter,
            }
        )


def _digits(value: float | None, scale: float) -> str:
    return "-" if value is None else f"{value * scale:.2f}"
