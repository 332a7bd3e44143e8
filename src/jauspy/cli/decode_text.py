"""Lines of `jauspy decode` for people: each datagram and message with its fields, or a row for every byte."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import TYPE_CHECKING, Any, Final

from jauspy.capture.dissect import STANDARD, Content, Dissection
from jauspy.cli import console
from jauspy.cli.can_log import CanFrame
from jauspy.cli.decode_formats import address_text, id_text, rows_of
from jauspy.cli.decode_sources import Item
from jauspy.cli.definitions import Definitions
from jauspy.cli.render import Styled, styled_fields
from jauspy.codec.message import Message
from jauspy.codec.registry import MessageEntry
from jauspy.printable import printable
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority
from jauspy.schema import model

if TYPE_CHECKING:
    from jauspy.codec import reference


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
    return f"{id_text(packet.source)} → {id_text(packet.destination)}", "green"


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
    return address[0] if address[1] == 3794 else address_text(address)


def _hex(data: bytes, limit: int = 64) -> str:
    return data[:limit].hex(" ") + (f" ... ({len(data)} bytes)" if len(data) > limit else "")


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
