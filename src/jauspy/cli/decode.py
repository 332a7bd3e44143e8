"""`jauspy decode`: print the messages in capture files, hex files, hex text or standard input."""

from __future__ import annotations

import heapq
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, lru_cache, partial
from io import BufferedReader, BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal, NamedTuple, Protocol, cast

import typer

from jauspy.capture.dissect import (
    STANDARD,
    Content,
    Dissection,
    Part,
    dissect,
    is_old_header,
    local_control,
    read_message,
)
from jauspy.capture.dissector import Dissector
from jauspy.capture.reader import CaptureReader, Datagram, from_hex, from_lines, is_capture
from jauspy.cli import console
from jauspy.cli.can_log import CanFrame, can_frames, changes, is_can_log
from jauspy.cli.definitions import Definitions, SchemasOption, ServiceName, ServiceVersion, definitions
from jauspy.cli.options import FilterOption
from jauspy.cli.render import Styled, styled_fields
from jauspy.codec.message import Message
from jauspy.codec.registry import NO_HINTS, Hints, MessageEntry, Registry
from jauspy.codec.rounding import rounded_dict
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.peers import PeerRecogniser
from jauspy.messages import registry
from jauspy.printable import printable
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority
from jauspy.protocol.jserial import FrameDecoder
from jauspy.recording.mcap_capture import MAGIC, McapCapture, open_capture_file
from jauspy.schema import model

if TYPE_CHECKING:
    from jauspy.capture.filters import Filter
    from jauspy.codec import reference


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


_BYTES_SHOWN: Final = 8


def explanation(content: Content, model_of: Callable[[type[Message]], model.MessageDefinition]) -> Iterator[Styled]:
    """A table of the fields of a message, a line each, up to the damage; empty if the message is unknown."""
    rows = rows_of(content, model_of)
    if not rows:
        return
    cells = [("offset", "bytes", "field", "raw", "value")]
    cells += [
        (
            f"{row.offset}",
            _short_hex(content.payload[row.offset :][: row.length]),
            row.path,
            _raw_value(row.raw),
            _explained_value(row.value),
        )
        for row in rows
    ]
    widths = [max(len(line[column]) for line in cells) for column in range(4)]
    for number, (offset, data, path, raw, value) in enumerate(cells):
        rest = "" if number else "dim"
        yield [
            (f"{offset:>{widths[0]}}  ", "dim"),
            (f"{data:<{widths[1]}}  ", rest),
            (f"{path:<{widths[2]}}  ", "cyan" if number else "dim"),
            (f"{raw:>{widths[3]}}  ", rest),
            (value, rest),
            _problem(rows[number - 1]) if number else ("", ""),
        ]


def rows_of(
    content: Content, model_of: Callable[[type[Message]], model.MessageDefinition]
) -> list[reference.ExplainedValue]:
    """The fields of a message, up to the damage; none if the message is unknown."""
    if content.message is None:
        return []
    from jauspy.codec import reference  # loads construct, which only explanations need

    return reference.explain(model_of(type(content.message)), content.payload)


def _problem(row: reference.ExplainedValue) -> tuple[str, str]:
    """The deviation from the definition, behind the value."""
    if not row.problem:
        return ("", "")
    return (row.problem, "bold red") if row.damaged else (f"  ({row.problem})", "yellow")


def _short_hex(data: bytes) -> str:
    return data[:_BYTES_SHOWN].hex(" ") + (" ..." if len(data) > _BYTES_SHOWN else "")


def _raw_value(raw: float | bytes) -> str:
    """A number as it is encoded; strings are shown in the column of bytes."""
    return "" if isinstance(raw, bytes) else str(raw) if isinstance(raw, int) else f"{raw:.9g}"


def _explained_value(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.9g}"
    if isinstance(value, list | tuple):
        return ", ".join(map(_explained_value, value)) or "none"
    return "" if value is None else printable(str(value))


class Item(NamedTuple):
    """One thing to show: a datagram (captured or pasted) or a bare message. `number` is 0 when there is only one."""

    number: int
    captured: Datagram | None = None
    dissection: Dissection | None = None
    bare: Content | None = None

    @property
    def failed(self) -> bool:
        """True if something could not be decoded; unknown messages in a capture do not count."""
        if self.dissection is not None:
            return bool(self.dissection.errors)
        return self.bare is not None and (bool(self.bare.problem) or not self.bare.reencodes)


class Printer(Protocol):
    """Prints items; `failed` is true once one of them could not be decoded."""

    failed: bool

    def show(self, item: Item) -> None:
        """Print one item."""

    def show_frame(self, frame: CanFrame) -> None:
        """Print one CAN frame."""


# --- JSON lines -----------------------------------------------------------------------------------------------------


def make_printer(output_format: OutputFormat, explain: Definitions | None) -> Printer:
    """The printer of a format; `explain` are the definitions with which messages are explained."""
    if output_format is OutputFormat.TEXT:
        return HumanPrinter(explain)
    if output_format is OutputFormat.JSON:
        return DataPrinter(partial(console.print_json, flush=False), explain)
    from jauspy.cli.decode_formats import CsvRows, print_yaml

    return DataPrinter(print_yaml if output_format is OutputFormat.YAML else CsvRows().add, explain)


class DataPrinter:
    """Prints the JSON form of each item by a function; with `explain`, each message has its rows."""

    def __init__(self, show: Callable[[dict[str, Any]], None], explain: Definitions | None = None) -> None:
        self.failed = False
        self._show = show
        self._explain = explain

    def show(self, item: Item) -> None:
        """Print one item, without flushing."""
        self.failed |= item.failed
        made = as_json(item)
        if self._explain is not None:
            for shown, content in zip(made["messages"], contents(item), strict=True):
                shown["explained"] = [_row_json(row) for row in rows_of(content, self._explain.model_of)]
        self._show(made)

    def show_frame(self, frame: CanFrame) -> None:
        """Print one CAN frame."""
        self._show(frame.as_json())


def contents(item: Item) -> list[Content]:
    """The messages of an item."""
    if item.dissection is not None:
        return [part.content for part in item.dissection.parts]
    return [item.bare] if item.bare is not None else []


def _row_json(row: reference.ExplainedValue) -> dict[str, Any]:
    raw = row.raw.hex() if isinstance(row.raw, bytes) else row.raw
    shown = {"offset": row.offset, "length": row.length, "field": row.path, "raw": raw, "value": row.value}
    return shown | {"problem": row.problem or None, "damaged": row.damaged}


def as_json(item: Item) -> dict[str, Any]:
    """An item as a JSON object; all objects have the same keys. `time` is in seconds since 1970, UTC."""
    captured, dissection, bare = item.captured, item.dissection, item.bare
    data = dissection.data if dissection else bare.payload if bare else b""
    if dissection is None:
        messages = [_content_json(bare)] if bare else []
        errors = [bare.problem] if bare and bare.broken else []
    else:
        messages = [part_json(part) for part in dissection.parts]
        errors = list(dissection.errors)
    shown = {
        "n": item.number,
        "time": captured.time if captured else None,
        "source": _address(captured.source) if captured else None,
        "destination": _address(captured.destination) if captured else None,
        "hex": data.hex(),
        "messages": messages,
        "errors": errors,
        "reencodes": dissection.reencodes if dissection else bool(bare and bare.reencodes),
    }
    if dissection and dissection.note:
        shown["note"] = dissection.note
    return shown


def part_json(part: Part) -> dict[str, Any]:
    """A message as a JSON object; all objects have the same keys."""
    packet = part.packet
    return {
        "source": _id_text(packet.source),
        "destination": _id_text(packet.destination),
        "sequence": packet.sequence,
        "priority": _PRIORITIES[packet.priority],
        "broadcast": _BROADCASTS[packet.broadcast],
        "ack": _ACKS[packet.ack],
        "data_flag": _DATA_FLAGS[packet.data_flag],
        **_content_json(part.content),
    }


_id_text: Final = lru_cache(maxsize=1024)(str)


@lru_cache(maxsize=1024)
def _code_text(code: int) -> str:
    return f"{code:04X}"


_PRIORITIES, _BROADCASTS, _ACKS, _DATA_FLAGS = (
    tuple(member.name for member in kind) for kind in (Priority, Broadcast, Ack, DataFlag)
)
"""Names of the values from 0 on; asking a member for its name takes longer."""


def _content_json(content: Content) -> dict[str, Any]:
    message, code, others = content.message, content.code, content.others
    return {
        "code": None if code is None else _code_text(code),
        "message": message.NAME if message else None,
        "service": message.SERVICE if message else None,
        "version": message.VERSION if message else None,
        "also": [{"message": entry.name, "service": entry.service, "version": entry.version} for entry in others],
        "fields": rounded_dict(message) if message else None,
        "deviations": list(content.deviations),
        "problem": content.problem or None,
        "reencodes": content.reencodes,
    }


@lru_cache(maxsize=1024)
def _address(address: tuple[str, int]) -> str:
    return f"{address[0]}:{address[1]}"


# --- text -----------------------------------------------------------------------------------------------------


class HumanPrinter:
    """Prints a line for each datagram and message, and its fields below; with `explain`, a line for every byte."""

    def __init__(self, explain: Definitions | None = None) -> None:
        self.failed = False
        self._explain = explain
        self._print = console.styled_printer()
        self._width = console.stdout().width if console.stdout().is_terminal else 0
        """Columns of the terminal; 0 if the output is none."""
        self._start: float | None = None
        self._noted: set[int] = set()

    def show(self, item: Item) -> None:
        """Print one item."""
        self.failed |= item.failed
        if item.dissection is not None:
            self._print(self._datagram(item, item.dissection))
        elif item.bare is not None:
            self._print(self._heading(item, _title(item.bare)) + self._content(item.bare))

    def show_frame(self, frame: CanFrame) -> None:
        """Print one CAN frame in a line."""
        head = f"      {self._elapsed(frame.time)}  {frame.channel or 'CAN'} {frame.identifier:03X}  "
        self._print([[(head, ""), (frame.text, "magenta")]])

    def _elapsed(self, time: float) -> str:
        if self._start is None:
            self._start = time
        return f"{time - self._start:+12.6f} s"

    def _datagram(self, item: Item, dissection: Dissection) -> list[Styled]:
        lines: list[Styled] = []
        if dissection.note:
            lines += self._heading(item, [(f"{dissection.note} ({len(dissection.data)} bytes)", "yellow")])
        for part in dissection.parts:
            title = [_route(part.packet), ("  ", ""), *_title(part.content), _flags(part.packet)]
            lines += [[("   + ", ""), *title]] if lines else self._heading(item, title)
            lines += self._content(part.content)
        if not lines:
            lines += self._heading(item, [(f"{len(dissection.data)} bytes", "red")])
        lines += [_remark(error, "red") for error in dissection.errors]
        return lines

    def _heading(self, item: Item, title: Styled) -> list[Styled]:
        head = f"{item.number:>4}" if item.number else ""
        if item.captured is not None:
            _, time, source, destination, _ = item.captured
            head += f"  {self._elapsed(time)}  {_short(source)} → {_short(destination)}"
        if self._width and len(head) + 2 + sum(len(text) for text, _ in title) > self._width:
            return [[(head, "dim")], [("     ", ""), *title]]
        return [[(head, "dim"), ("  ", ""), *title] if head else title]

    def _content(self, content: Content) -> list[Styled]:
        message = content.message
        lines: list[Styled] = []
        if content.problem and not content.broken:
            lines.append(_remark(content.problem))
        lines += self._others(content)
        if message is None and content.payload:
            lines.append(_remark(_hex(content.payload), "dim"))
        if self._explain:
            lines += [[("     ", ""), *row] for row in explanation(content, self._explain.model_of)]
        elif message is not None:
            lines += styled_fields(message, margin="     ")
        lines += [_remark(deviation) for deviation in content.deviations]
        if not content.reencodes:
            again = content.reencoded()
            lines.append(_remark(f"encodes to {_hex(again)}" if again is not None else "does not encode again"))
        return lines

    def _others(self, content: Content) -> list[Styled]:
        """The other definitions of a message id, the first time that it occurs."""
        message = content.message
        if message is None or not content.others or message.CODE in self._noted:
            return []
        self._noted.add(message.CODE)
        others = ", ".join(f"{other.name} in {_place(other)} ({_option(other, message)})" for other in content.others)
        service_version = f"{_service(message.SERVICE)} {message.VERSION}"
        return [_remark(f"decoded as in {service_version}; also {others}", "dim")]


def _remark(text: str, style: str = "yellow") -> Styled:
    return [(f"     {text}", style)]


def _option(entry: MessageEntry, shown: Message) -> str:
    """The option that selects this definition."""
    if entry.version != shown.VERSION:
        return f"--version {entry.version}"
    return f"--service {_service(entry.service)}"


def _place(entry: MessageEntry) -> str:
    return f"{_service(entry.service)} {entry.version}"


def _service(urn: str) -> str:
    return urn.removeprefix(STANDARD)


def _title(content: Content) -> Styled:
    if content.message is not None:
        return [(content.message.NAME, "bold cyan"), (f" ({content.code:04X}h)", "")]
    if not content.payload:
        return [("no message", "")]
    return [(f"message {content.code:04X}h" if content.code is not None else "message", "bold")]


def _route(packet: Packet) -> tuple[str, str]:
    return f"{_id_text(packet.source)} → {_id_text(packet.destination)}", "green"


def _flags(packet: Packet) -> tuple[str, str]:
    """Header fields that are not standard priority, unicast, unacknowledged, unfragmented; and the sequence number."""
    words = _unusual(packet.priority, packet.broadcast, packet.ack, packet.data_flag)
    return f"  {words}seq {packet.sequence}", "dim"


@cache
def _unusual(priority: Priority, broadcast: Broadcast, ack: Ack, data_flag: DataFlag) -> str:
    words = []
    if priority != Priority.STANDARD:
        words.append(priority.name.lower().replace("_", " ") + " priority")
    if broadcast != Broadcast.NONE:
        words.append(f"{broadcast.name.lower()} broadcast")
    if ack != Ack.NONE:
        words.append({Ack.REQUIRED: "ack required", Ack.ACK: "ACK", Ack.NAK: "NAK"}[ack])
    if data_flag != DataFlag.SINGLE:
        words.append(f"{data_flag.name.lower()} fragment")
    return "".join(f"{word}, " for word in words)


def _short(address: tuple[str, int]) -> str:
    """The address, with the port unless it is 3794."""
    return address[0] if address[1] == 3794 else _address(address)


def _hex(data: bytes, limit: int = 64) -> str:
    return data[:limit].hex(" ") + (f" ... ({len(data)} bytes)" if len(data) > limit else "")


HexKindName = Literal["datagram", "message", "serial"] | None

_VERSION: Final = b"\x02"  # first byte of an AS5669A datagram
_UNCOMPRESSED: Final = b"\x00"  # its second byte
READ_SIZE: Final = 65536
"""Bytes of a JSerial line that are read at once."""
_MIN_DATAGRAM: Final = 15  # bytes of a datagram without payload


@dataclass(frozen=True, slots=True)
class DecodeOptions:
    """Definitions for decoding, the UDP port to select, and how to interpret hex text."""

    registry: Registry = registry
    wanted: Hints = NO_HINTS
    port: int | None = None
    what: HexKindName = None

    def datagram(self, data: bytes) -> Dissection:
        """Decode a UDP payload."""
        return dissect(data, self.registry, self.wanted)

    def message(self, data: bytes) -> Content:
        """Decode a message without header."""
        return read_message(data, self.registry, self.wanted)


def items(source: str, options: DecodeOptions) -> Iterator[Item]:
    """Everything in a file, in standard input (`-`) or in hex text; raises `ConfigError`."""
    if source == "-":
        yield from _from_file(cast("BufferedReader", sys.stdin.buffer), "standard input", options)
    elif _exists(Path(source)):
        with _open(Path(source)) as file:
            yield from _from_file(file, source, options)
    elif options.what == "serial":
        yield from _from_line(BytesIO(_from_text(source)), options)
    else:
        yield _from_hex(0, _from_text(source), options)


def _from_line(line: BufferedReader | BytesIO, options: DecodeOptions) -> Iterator[Item]:
    """The datagrams in bytes of a JSerial line, as they come."""
    decoder, dissector, number = FrameDecoder(), Dissector(options.registry, options.wanted), 0
    damaged = 0
    while data := line.read1(READ_SIZE):
        datagrams, errors = decoder.feed(data)
        damaged += len(errors)
        for datagram in datagrams:
            number += 1
            yield Item(number, dissection=dissector.dissect(datagram, 0.0))
    if damaged or not number:
        console.note(f"{damaged} damaged frames, {number} whole ones")


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # hex text is easily longer than a file name may be
        return False


def _open(path: Path) -> BufferedReader:
    try:
        return path.open("rb")
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None


def _from_text(text: str) -> bytes:
    try:
        return from_hex(text)
    except ConfigError as error:
        raise ConfigError(f"there is no file {text!r}, and as hex text it is wrong: {error}") from None


def _from_file(file: BufferedReader, name: str, options: DecodeOptions) -> Iterator[Item]:
    if is_capture(file.peek(4)) or file.peek(len(MAGIC)).startswith(MAGIC):
        yield from _from_capture(open_capture_file(file, name=name, port=options.port), options)
        return
    if options.what == "serial":
        yield from _from_line(file, options)
        return
    try:
        lines = from_lines(file.read().decode("ascii"))
    except (UnicodeDecodeError, ConfigError) as error:
        reason = f": {error}" if isinstance(error, ConfigError) else ""
        raise ConfigError(f"{name} is neither a pcap, pcapng or MCAP file nor hex text{reason}") from None
    if not lines:
        raise ConfigError(f"{name} is empty")
    for number, data in lines:
        yield _from_hex(number, data, options)


def _from_capture(reader: CaptureReader | McapCapture, options: DecodeOptions) -> Iterator[Item]:
    count = 0
    dissector = Dissector(options.registry, options.wanted)
    for count, datagram in enumerate(reader, 1):  # noqa: B007 - for the note below
        control = local_control(datagram.payload) if _is_local(datagram) else None
        dissection = control or dissector.dissect(datagram.payload, datagram.time)
        yield Item(datagram.number, captured=datagram, dissection=dissection)
    if not count and not reader.skipped:
        console.note("the capture has no packets")
    if reader.skipped:
        console.note("skipped: " + ", ".join(f"{count} {reason}" for reason, count in reader.skipped.items()))


def _is_local(datagram: Datagram) -> bool:
    """True for an answer of the node manager to a component of its machine, as its mirror writes it."""
    host, port = datagram.source
    return datagram.source == datagram.destination and host.startswith("127.") and port == judp.PORT


def _from_hex(number: int, data: bytes, options: DecodeOptions) -> Item:
    """A datagram if the bytes are a whole one, or long enough for one; else a message."""
    if options.what == "message":
        return Item(number, bare=options.message(data))
    control = local_control(data)
    if control is not None and options.what is None:
        return Item(number, dissection=control)
    datagram = Item(number, dissection=options.datagram(data))
    if options.what == "datagram" or (data[:1] == _VERSION and not datagram.failed):
        return datagram
    message = options.message(data)
    is_version_2 = data[:1] == _VERSION and (len(data) >= _MIN_DATAGRAM or data[1:2] == _UNCOMPRESSED)
    looks_like_datagram = is_version_2 or is_old_header(data)
    return datagram if looks_like_datagram and not message.exact else Item(number, bare=message)
