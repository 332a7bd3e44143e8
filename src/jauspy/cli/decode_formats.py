"""Formats of `jauspy decode` for other programs: YAML documents, and CSV with a row for each value."""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterator
from typing import Any, Final, TextIO

import yaml

from jauspy.printable import printable

COLUMNS: Final = ("n", "time", "source", "destination", "sequence", "message", "field", "value")
_FORMULA_STARTS: Final = ("=", "+", "-", "@", "\t", "\r")
"""Spreadsheets take texts that begin so for formulas."""


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
            for path, value in list(_leaves(message["fields"], "")) or [("", "")]:
                self._writer.writerow((*head, path, _cell(value)))


def _leaves(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from _leaves(inner, f"{path}.{name}" if path else name)
    elif isinstance(value, list):
        for number, inner in enumerate(value):
            yield from _leaves(inner, f"{path}[{number}]")
    elif path:
        yield path, value


def _cell(value: Any) -> Any:
    """The value; a text of a message that a spreadsheet would execute is quoted by an apostrophe."""
    if not isinstance(value, str):
        return value
    text = printable(value)
    return "'" + text if text.startswith(_FORMULA_STARTS) else text
