"""`jauspy decode`: print the messages in capture files, hex files, hex text or standard input."""

from __future__ import annotations

import gc
import heapq
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from functools import partial
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.capture.dissect import Part
from jauspy.cli import console
from jauspy.cli.can_log import CanFrame, can_frames, changes, is_can_log
from jauspy.cli.decode_formats import CsvRows, DataPrinter, Printer, print_yaml
from jauspy.cli.decode_sources import DecodeOptions, Item, items
from jauspy.cli.decode_text import HumanPrinter
from jauspy.cli.definitions import Definitions, SchemasOption, ServiceName, ServiceVersion, definitions
from jauspy.cli.options import FilterOption
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.peers import PeerRecogniser
from jauspy.protocol.header import Packet

if TYPE_CHECKING:
    from jauspy.capture.filters import Filter


class HexKind(StrEnum):
    """How to interpret hex text, or a file of bytes."""

    DATAGRAM = "datagram"
    MESSAGE = "message"
    SERIAL = "serial"


class OutputFormat(StrEnum):
    """How to print."""

    TEXT = "text"
    JSON = "json"
    YAML = "yaml"
    CSV = "csv"


def decode(
    *,
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE|HEX|-",
            help="A pcap, pcapng or MCAP file, a log of CAN frames, a file of hex lines, hex text, or - for standard "
            "input; several captures and logs are listed together, by time.",
        ),
    ],
    as_json: Annotated[bool, typer.Option("--json", help="One JSON object per datagram per line.")] = False,
    output_format: Annotated[
        OutputFormat,
        typer.Option("--format", help="yaml has a document per datagram, csv a row per value."),
    ] = OutputFormat.TEXT,
    explain: Annotated[
        bool,
        typer.Option("--explain", help="Show every field's offset, bytes and raw value, up to the damage."),
    ] = False,
    port: Annotated[
        str, typer.Option("--port", metavar="N|any", help="Only datagrams from or to this UDP port.")
    ] = "3794",
    what: Annotated[
        HexKind | None,
        typer.Option(
            "--as",
            help="What the hex text is: a datagram (default if 01 or 02 is first), a bare message, or bytes of a "
            "JSerial line; a file of such bytes need not be hex text.",
        ),
    ] = None,
    schemas: SchemasOption = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    robot: Annotated[
        str, typer.Option("--robot", metavar="ROBOT", help="The robot whose drives are in a log of CAN frames.")
    ] = "inc1",
    only_changes: Annotated[
        bool,
        typer.Option(
            "--changes", help="Print only CAN frames whose state, command or mode, or the sign of a value, is new."
        ),
    ] = False,
    message: Annotated[
        str | None,
        typer.Option("--message", metavar="NAME", help="Which message, if a service has several with one id."),
    ] = None,
    only: FilterOption = None,
) -> None:
    """Print the JAUS messages in a capture file or in hex text.

    Values are in SI units and radians. Yellow lines describe deviations from the definition. The exit status is 1 if
    something could not be decoded. Frames of logs of candump are named by the drives of --robot.

    --filter compares src, dst, msg, code, service, size and others (docs/filters.md), and fields of messages by their
    names, with ==, !=, <, <=, >, >=, contains and in, joined by and, or, not.

    Notes at the end, on stderr, name senders that are recognised as JTS, FKIE or OpenJAUS, and what is known of them.

    A message id is decoded by the newest version of its service; a line names the other definitions of the id.
    --service, --version and --message select one; they do not affect ids that the selected definitions lack.

    Examples:
      jauspy decode run.pcap --json
      jauspy decode run.pcap --format csv --filter 'msg == ReportLocalPose'
      jauspy decode run.pcap --filter 'src == 42.* and msg == SetWrenchEffort'
      jauspy decode --explain 02001000010a017e0014017e0002200200
      tcpdump -w - udp | jauspy decode -
      jauspy decode arm.pcap --schemas vendor/ --version 1.0
      jauspy decode run.pcapng candump-2026-11-22.log --robot inc1 --changes
    """
    known = definitions(schemas)
    wanted = known.hints(service, version, message)
    options = DecodeOptions(known.registry, wanted, _port(port), None if what is None else what.value)
    explained = known if explain else None
    printer = make_printer(OutputFormat.JSON if as_json else output_format, explained)
    fits = None if only is None else message_filter(only, known.registry)

    def listed(source: str) -> Iterator[Item | CanFrame]:
        if not is_can_log(source):
            found = items(source, options)
            return found if fits is None else filtered(found, fits)
        if output_format is OutputFormat.CSV:
            raise ConfigError(f"{source} is a log of CAN frames, and CSV has only JAUS messages; print it as --json")
        frames = can_frames(source, robot)
        return changes(frames) if only_changes else frames

    peers = PeerRecogniser()
    is_live = "-" in sources or sys.stdout.isatty()
    shown = listed(sources[0]) if len(sources) == 1 else by_time(map(listed, sources))
    with collected_rarely():
        for batch in batches(shown, 1 if is_live else BATCH):
            for item in batch:
                if isinstance(item, CanFrame):
                    printer.show_frame(item)
                else:
                    printer.show(item)
                    seen = item.captured
                    if seen is not None and item.dissection is not None and peers.looks_at(seen.source[0]):
                        packets = [part.packet for part in item.dissection.parts]
                        peers.see(seen.payload, seen.source, seen.destination, packets)
            if is_live:
                sys.stdout.flush()
        sys.stdout.flush()
    for note in peers.notes():
        console.note(note)
    if printer.failed:
        raise typer.Exit(1)


BATCH: Final = 100
"""Items that are decoded before they are printed: a tenth quicker than one after the other."""


OBJECTS: Final = 50_000
"""Objects of a batch and what is kept, after which cyclic garbage is looked for: some batches. By default, 700."""


@contextmanager
def collected_rarely() -> Iterator[None]:
    """Look for cyclic garbage rarely: items have no cycles, and a batch of them is searched four times by default."""
    thresholds = gc.get_threshold()
    gc.set_threshold(OBJECTS, *thresholds[1:])
    try:
        yield
    finally:
        gc.set_threshold(*thresholds)


def batches(listed: Iterable[Item | CanFrame], size: int) -> Iterator[list[Item | CanFrame]]:
    """Lists of up to `size` items; those before an error come before it."""
    batch: list[Item | CanFrame] = []
    error = None
    try:
        for item in listed:
            batch.append(item)
            if len(batch) == size:
                yield batch
                batch = []
    except ConfigError as raised:
        error = raised
    if batch:
        yield batch
    if error is not None:
        raise error


def by_time(listings: Iterable[Iterator[Item | CanFrame]]) -> Iterator[Item | CanFrame]:
    """The items of several captures and logs in order of time; raises `ConfigError` for inputs without times."""
    return heapq.merge(*listings, key=_time)


def _time(item: Item | CanFrame) -> float:
    if isinstance(item, CanFrame):
        return item.time
    if item.captured is None:
        raise ConfigError("hex text has no times; list only captures (pcap, pcapng) and logs of CAN frames together")
    return item.captured.time


def message_filter(text: str, registry: Registry) -> Filter:
    """The filter of a command line; its parser is loaded only for one."""
    from jauspy.capture.filters import Filter

    return Filter(text, registry)


def filtered(items: Iterable[Item], fits: Filter) -> Iterator[Item]:
    """The items with a message that fits, without their other messages."""
    for item in items:
        if item.dissection is not None:
            parts = tuple(part for part in item.dissection.parts if fits(part))
            if parts:
                yield item._replace(dissection=item.dissection._replace(parts=parts))
        elif item.bare is not None and fits(Part(_NO_PACKET, item.bare)):
            yield item


_NO_PACKET: Final = Packet(JausID(0, 0, 0), JausID(0, 0, 0), b"")
"""Header of a bare message: no filter of ids fits it but `0.0.0`."""


def _port(text: str) -> int | None:
    if text == "any":
        return None
    if text.isdigit() and 0 < int(text) < 65536:
        return int(text)
    raise typer.BadParameter(f"{text!r} is neither a UDP port (1..65535) nor 'any'", param_hint="--port")


def make_printer(output_format: OutputFormat, explain: Definitions | None) -> Printer:
    """The printer of a format; `explain` are the definitions with which messages are explained."""
    if output_format is OutputFormat.TEXT:
        return HumanPrinter(explain)
    if output_format is OutputFormat.JSON:
        return DataPrinter(partial(console.print_json, flush=False), explain)
    return DataPrinter(print_yaml if output_format is OutputFormat.YAML else CsvRows().add, explain)
