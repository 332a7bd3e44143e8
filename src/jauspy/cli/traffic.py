"""Datagrams and messages on paper: for people, and as JSON lines."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from typing import Any, Protocol

from rich.text import Text

from jauspy.capture.dissect import STANDARD, Content, Dissection, Part
from jauspy.capture.reader import Datagram
from jauspy.cli import console
from jauspy.cli.definitions import Definitions
from jauspy.cli.explain import explanation
from jauspy.cli.render import field_lines
from jauspy.codec.message import Message
from jauspy.codec.registry import MessageEntry
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority


@dataclass(frozen=True, slots=True)
class Item:
    """One thing to show: a datagram (captured or pasted) or a bare message. `number` is 0 when there is only one."""

    number: int
    captured: Datagram | None = None
    dissection: Dissection | None = None
    bare: Content | None = None

    @property
    def failed(self) -> bool:
        """True when something in it could not be read; in a capture, messages of others may be unknown."""
        if self.dissection is not None:
            return bool(self.dissection.errors)
        return self.bare is not None and (bool(self.bare.problem) or not self.bare.reencodes)


class Printer(Protocol):
    """Shows items one after the other; `failed` is true once one of them could not be read."""

    failed: bool

    def show(self, item: Item) -> None:
        """Print one item."""


# --- JSON lines -----------------------------------------------------------------------------------------------------


class JsonPrinter:
    """One object per line."""

    def __init__(self) -> None:
        self.failed = False

    def show(self, item: Item) -> None:
        """Print one item."""
        self.failed |= item.failed
        sys.stdout.write(json.dumps(as_json(item), ensure_ascii=False) + "\n")


def as_json(item: Item) -> dict[str, Any]:
    """The object that stands for an item, with the same keys for each; `time` is in seconds since 1970, UTC."""
    captured, dissection, bare = item.captured, item.dissection, item.bare
    data = dissection.data if dissection else bare.payload if bare else b""
    if dissection is None:
        messages = [_content_json(bare)] if bare else []
        errors = [bare.problem] if bare and bare.broken else []
    else:
        messages = [_part_json(part) for part in dissection.parts]
        errors = list(dissection.errors)
    return {
        "n": item.number,
        "time": captured.time if captured else None,
        "source": _address(captured.source) if captured else None,
        "destination": _address(captured.destination) if captured else None,
        "hex": data.hex(),
        "messages": messages,
        "errors": errors,
        "reencodes": dissection.reencodes if dissection else bool(bare and bare.reencodes),
    } | ({"note": dissection.note} if dissection and dissection.note else {})


def _part_json(part: Part) -> dict[str, Any]:
    packet = part.packet
    return {
        "source": str(packet.source),
        "destination": str(packet.destination),
        "sequence": packet.sequence,
        "priority": packet.priority.name,
        "broadcast": packet.broadcast.name,
        "ack": packet.ack.name,
        "data_flag": packet.data_flag.name,
    } | _content_json(part.content)


def _content_json(content: Content) -> dict[str, Any]:
    message = content.message
    return {
        "code": None if content.code is None else f"{content.code:04X}",
        "message": message.NAME if message else None,
        "service": message.SERVICE if message else None,
        "version": message.VERSION if message else None,
        "also": [{"message": each.name, "service": each.service, "version": each.version} for each in content.others],
        "fields": message.to_dict() if message else None,
        "deviations": list(content.deviations),
        "problem": content.problem or None,
        "reencodes": content.reencodes,
    }


def _address(address: tuple[str, int]) -> str:
    return f"{address[0]}:{address[1]}"


# --- for people -----------------------------------------------------------------------------------------------------


class HumanPrinter:
    """A line for each datagram and message, and its fields below it; every byte with the definitions in `explain`."""

    def __init__(self, explain: Definitions | None = None) -> None:
        self.failed = False
        self._explain = explain
        self._start: float | None = None
        self._noted: set[int] = set()

    def show(self, item: Item) -> None:
        """Print one item."""
        self.failed |= item.failed
        if item.dissection is None:
            if item.bare is not None:
                self._heading(item, _title(item.bare))
                self._content(item.bare)
            return
        self._datagram(item, item.dissection)

    def _datagram(self, item: Item, dissection: Dissection) -> None:
        if dissection.note:
            self._heading(item, Text(f"{dissection.note} ({len(dissection.data)} bytes)", style="yellow"))
        for index, part in enumerate(dissection.parts):
            line = _route(part.packet).append("  ").append_text(_title(part.content)).append_text(_flags(part.packet))
            if index == 0:
                self._heading(item, line)
            else:
                console.stdout().print(Text("   + ").append_text(line))
            self._content(part.content)
        if not dissection.parts and not dissection.note:
            self._heading(item, Text(f"{len(dissection.data)} bytes", style="red"))
        for error in dissection.errors:
            console.stdout().print(Text(f"     {error}", style="red"))

    def _heading(self, item: Item, line: Text) -> None:
        out = console.stdout()
        head = Text(f"{item.number:>4}" if item.number else "", style="dim")
        if item.captured is not None:
            if self._start is None:
                self._start = item.captured.time
            head.append(f"  {item.captured.time - self._start:+12.6f} s")
            head.append(f"  {_short(item.captured.source)} → {_short(item.captured.destination)}")
        if out.is_terminal and head.cell_len + 2 + line.cell_len > out.width:
            out.print(head)
            out.print(Text("     ").append_text(line))
        else:
            out.print(Text("  ").join((head, line)) if head else line)

    def _content(self, content: Content) -> None:
        out = console.stdout()
        if content.problem and not content.broken:
            out.print(Text(f"     {content.problem}", style="yellow"))
        self._note_others(content)
        if content.message is None and content.payload:
            out.print(Text(f"     {_hex(content.payload)}", style="dim"))
        if self._explain:
            for row in explanation(content, self._explain.model_of):
                out.print(Text("     ").append_text(row))
        elif content.message is not None:
            for line in field_lines(content.message):
                out.print(Text("     ").append_text(line))
        for deviation in content.deviations:
            out.print(Text(f"     {deviation}", style="yellow"))
        if content.message is not None and not content.reencodes:
            again = content.reencoded()
            text = f"encodes to {_hex(again)}" if again is not None else "does not encode again"
            out.print(Text(f"     {text}", style="yellow"))

    def _note_others(self, content: Content) -> None:
        """What else an id means, the first time it is shown."""
        message = content.message
        if message is None or message.CODE in self._noted or not content.others:
            return
        self._noted.add(message.CODE)
        others = ", ".join(f"{each.name} in {_place(each)} ({_option(each, message)})" for each in content.others)
        here = f"{_service(message.SERVICE)} {message.VERSION}"
        console.stdout().print(Text(f"     as in {here}; it is {others}", style="dim"))


def _option(entry: MessageEntry, shown: Message) -> str:
    """What makes a message be read by another definition."""
    if entry.version != shown.VERSION:
        return f"--version {entry.version}"
    return f"--service {_service(entry.service)}"


def _place(entry: MessageEntry) -> str:
    return f"{_service(entry.service)} {entry.version}"


def _service(urn: str) -> str:
    return urn.removeprefix(STANDARD)


def _title(content: Content) -> Text:
    if content.message is not None:
        return Text.assemble((content.message.NAME, "bold cyan"), f" ({content.code:04X}h)")
    if not content.payload:
        return Text("no message")
    return Text(f"message {content.code:04X}h" if content.code is not None else "message", style="bold")


def _route(packet: Packet) -> Text:
    return Text(f"{packet.source} → {packet.destination}", style="green")


def _flags(packet: Packet) -> Text:
    """What is not as usual (standard priority, unicast, no acknowledgement, unfragmented), and the sequence number."""
    words = []
    if packet.priority != Priority.STANDARD:
        words.append(packet.priority.name.lower().replace("_", " ") + " priority")
    if packet.broadcast != Broadcast.NONE:
        words.append(f"{packet.broadcast.name.lower()} broadcast")
    if packet.ack != Ack.NONE:
        words.append({Ack.REQUIRED: "ack required", Ack.ACK: "ACK", Ack.NAK: "NAK"}[packet.ack])
    if packet.data_flag != DataFlag.SINGLE:
        words.append(f"{packet.data_flag.name.lower()} fragment")
    words.append(f"seq {packet.sequence}")
    return Text("  " + ", ".join(words), style="dim")


def _short(address: tuple[str, int]) -> str:
    """The address; the port only when it is not the usual one."""
    return address[0] if address[1] == 3794 else _address(address)


def _hex(data: bytes, limit: int = 64) -> str:
    return data[:limit].hex(" ") + (f" ... ({len(data)} bytes)" if len(data) > limit else "")
