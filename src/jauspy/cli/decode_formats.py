"""Formats of `jauspy decode` for other programs: JSON lines, YAML documents, and CSV with a row for each value."""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Final, Protocol, TextIO

import yaml

from jauspy.capture.dissect import Content, Part
from jauspy.cli.can_log import CanFrame
from jauspy.cli.decode_sources import Item
from jauspy.cli.definitions import Definitions
from jauspy.codec.field_paths import leaves
from jauspy.codec.message import Message
from jauspy.codec.registry import MessageEntry
from jauspy.codec.rounding import rounded_dict
from jauspy.printable import printable, spreadsheet_text
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Priority
from jauspy.schema import model

if TYPE_CHECKING:
    from jauspy.codec import reference


class Printer(Protocol):
    """Prints items; `failed` is true once one of them could not be decoded."""

    failed: bool

    def show(self, item: Item) -> None:
        """Print one item."""

    def show_frame(self, frame: CanFrame) -> None:
        """Print one CAN frame."""


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
        "source": address_text(captured.source) if captured else None,
        "destination": address_text(captured.destination) if captured else None,
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
        "source": id_text(packet.source),
        "destination": id_text(packet.destination),
        "sequence": packet.sequence,
        "priority": _PRIORITIES[packet.priority],
        "broadcast": _BROADCASTS[packet.broadcast],
        "ack": _ACKS[packet.ack],
        "data_flag": _DATA_FLAGS[packet.data_flag],
        **_content_json(part.content),
    }


id_text: Final = lru_cache(maxsize=1024)(str)
"""The text of a JAUS id; the ids of a network are few, and are in every packet."""


@lru_cache(maxsize=1024)
def _code_text(code: int) -> str:
    return f"{code:04X}"


_PRIORITIES, _BROADCASTS, _ACKS, _DATA_FLAGS = (
    tuple(member.name for member in kind) for kind in (Priority, Broadcast, Ack, DataFlag)
)
"""Names of the values from 0 on; asking a member for its name takes longer."""


def _content_json(content: Content) -> dict[str, Any]:
    _, message, deviations, problem, _, others, reencodes = content
    code = content.code
    return {
        "code": None if code is None else _code_text(code),
        "message": message.NAME if message else None,
        "service": message.SERVICE if message else None,
        "version": message.VERSION if message else None,
        "also": [_entry_json(entry) for entry in others] if others else [],
        "fields": rounded_dict(message) if message else None,
        "deviations": list(deviations),
        "problem": problem or None,
        "reencodes": reencodes,
    }


def _entry_json(entry: MessageEntry) -> dict[str, str]:
    return {"message": entry.name, "service": entry.service, "version": entry.version}


@lru_cache(maxsize=1024)
def address_text(address: tuple[str, int]) -> str:
    """Address and port, as in 10.0.0.1:3794."""
    return f"{address[0]}:{address[1]}"


def rows_of(
    content: Content, model_of: Callable[[type[Message]], model.MessageDefinition]
) -> list[reference.ExplainedValue]:
    """The fields of a message, up to the damage; none if the message is unknown."""
    if content.message is None:
        return []
    from jauspy.codec import reference  # loads construct, which only explanations need

    return reference.explain(model_of(type(content.message)), content.payload)


COLUMNS: Final = ("n", "time", "source", "destination", "sequence", "message", "field", "value")


def print_yaml(made: dict[str, Any]) -> None:
    """Print a datagram as a YAML document; `made` is its JSON form."""
    yaml.dump(
        made, sys.stdout, Dumper=_dumper(), explicit_start=True, sort_keys=False, width=1000, default_flow_style=None
    )


def _dumper() -> Any:
    return getattr(yaml, "CSafeDumper", yaml.SafeDumper)


class CsvRows:
    """Prints rows of `COLUMNS` with the values of all messages: one row for each number, name or text.

    A field in a list has its index in its path. A message without fields has one row.
    """

    def __init__(self, file: TextIO | None = None) -> None:
        self._writer = csv.writer(file or sys.stdout, lineterminator="\n")
        self._writer.writerow(COLUMNS)

    def add(self, made: dict[str, Any]) -> None:
        """Print the rows of a datagram; `made` is its JSON form."""
        for message in made["messages"]:
            head = (
                made["n"],
                made["time"],
                message.get("source"),
                message.get("destination"),
                message.get("sequence"),
                message["message"] or message["code"],
            )
            for path, value in list(leaves(message["fields"])) or [("", "")]:
                self._writer.writerow((*head, path, _cell(value)))


def _cell(value: Any) -> Any:
    """The value; a text of a message that a spreadsheet would execute is quoted by an apostrophe."""
    return spreadsheet_text(printable(value)) if isinstance(value, str) else value
