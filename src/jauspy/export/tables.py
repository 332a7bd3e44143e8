"""Messages as tables: one of each sender and kind of message, with nested fields flattened into columns."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack
from itertools import islice
from pathlib import Path
from typing import Any, Final, NamedTuple, TypeAlias

from jauspy.codec.field_paths import leaves
from jauspy.codec.message import Message
from jauspy.codec.names import unique
from jauspy.codec.rounding import rounded_dict
from jauspy.errors import ConfigError
from jauspy.inspection.traffic import SeenMessage
from jauspy.printable import spreadsheet_text

Scalar: TypeAlias = bool | int | float | str | None

MAX_TABLES: Final = 500
"""Files that are open at a time; messages of further senders and kinds are left out and counted."""
MAX_COLUMNS: Final = 2000
"""Columns of a table; further values are left out."""
ROWS_AT_ONCE: Final = 5000
"""Rows of a Parquet row group."""
MAX_NAME: Final = 100
"""Characters of a name in a path."""
HEADER: Final = ("time", "destination", "sequence")
INTEGERS: Final = range(-(2**63), 2**63)


class Row(NamedTuple):
    """A message as it becomes a row."""

    table: tuple[str, type[Message]]
    values: dict[str, Scalar]


class Exported(NamedTuple):
    """What was written."""

    files: dict[Path, int]
    """Rows by file."""
    left_out: Counter[str]
    """Messages by why they are in no table."""


def rows(messages: Iterable[SeenMessage], left_out: Counter[str]) -> Iterator[Row]:
    """A row of each message that was decoded; the others are counted."""
    for seen in messages:
        message, packet = seen.part.content.message, seen.part.packet
        if message is None:
            left_out[seen.name] += 1
            continue
        values: dict[str, Scalar] = {
            "time": seen.time,
            "destination": str(packet.destination),
            "sequence": packet.sequence,
        }
        values.update((f"{path}_" if path in HEADER else path, value) for path, value in _fields(message))
        yield Row((str(packet.source), type(message)), values)


def _fields(message: Message) -> Iterator[tuple[str, Scalar]]:
    return islice(leaves(rounded_dict(message)), MAX_COLUMNS)


def export_tables(read: Callable[[], Iterable[SeenMessage]], folder: Path, suffix: str) -> Exported:
    """Write `.csv` or `.parquet` files into a new folder; `read` is called twice: for the columns, then for the rows.

    Raises `ConfigError` if the folder exists or cannot be written.
    """
    left_out: Counter[str] = Counter()
    columns: dict[tuple[str, type[Message]], dict[str, set[type]]] = {}
    for row in rows(read(), left_out):
        if row.table not in columns and len(columns) >= MAX_TABLES:
            continue
        kinds = columns.setdefault(row.table, {})
        for name, value in row.values.items():
            if name in kinds or len(kinds) < MAX_COLUMNS:
                kinds.setdefault(name, set()).add(_kind(value))
    make_folder(folder)
    files: dict[tuple[str, type[Message]], Path] = {}
    counts: dict[Path, int] = {}
    with ExitStack() as stack:
        tables: dict[tuple[str, type[Message]], _CsvTable | _ParquetTable] = {}
        for table, kinds in columns.items():
            name = unique(f"{table[0]}_{table[1].__name__[:MAX_NAME]}", lambda name: folder / (name + suffix) in counts)
            files[table] = folder / (name + suffix)
            counts[files[table]] = 0
            if suffix == ".csv":
                tables[table] = stack.enter_context(_CsvTable(files[table], kinds))
            else:
                tables[table] = stack.enter_context(_ParquetTable(files[table], table, kinds))
        for row in rows(read(), Counter()):
            if row.table not in tables:
                left_out[f"{row.table[0]} {row.table[1].NAME}, beyond {MAX_TABLES} tables"] += 1
                continue
            tables[row.table].add(row.values)
            counts[files[row.table]] += 1
    return Exported(counts, left_out)


def make_folder(folder: Path) -> None:
    """Make a new folder for results; raises `ConfigError` if there is one already."""
    try:
        folder.mkdir(parents=True)
    except FileExistsError:
        raise ConfigError(f"{folder} exists already; give another folder with -o") from None
    except OSError as error:
        raise ConfigError(f"{folder} cannot be made: {error.strerror}") from None


def _kind(value: Scalar) -> type:
    if isinstance(value, int) and not isinstance(value, bool) and value not in INTEGERS:
        return float
    return type(value)


class _CsvTable(ExitStack):
    """A CSV file as spreadsheets and pandas read it. Text that a spreadsheet took for a formula begins with `'`."""

    def __init__(self, path: Path, kinds: Mapping[str, set[type]]) -> None:
        super().__init__()
        file = self.enter_context(path.open("x", encoding="utf-8", newline=""))
        self._writer = csv.DictWriter(file, list(kinds), restval="", extrasaction="ignore")
        self._writer.writerow({name: _cell(name) for name in kinds})

    def add(self, values: Mapping[str, Scalar]) -> None:
        """Write a row."""
        self._writer.writerow({name: _cell(value) for name, value in values.items()})


def _cell(value: Scalar) -> Scalar:
    return spreadsheet_text(value) if isinstance(value, str) else value


class _ParquetTable(ExitStack):
    """A Parquet file; a column of several types is text."""

    def __init__(self, path: Path, table: tuple[str, type[Message]], kinds: Mapping[str, set[type]]) -> None:
        import pyarrow as pa  # noqa: PLC0415 - of the extra `export`
        from pyarrow import parquet  # noqa: PLC0415

        super().__init__()
        self._arrow = pa
        sender, message = table
        self._converters = {name: _converter(types) for name, types in kinds.items()}
        arrow_types: dict[Any, Any] = {float: pa.float64(), int: pa.int64(), bool: pa.bool_(), str: pa.string()}
        metadata = {"sender": sender, "message": message.NAME, "service": message.SERVICE, "version": message.VERSION}
        self._schema = pa.schema(
            [(name, arrow_types[converter]) for name, converter in self._converters.items()], metadata=metadata
        )
        self._rows: list[dict[str, Scalar]] = []
        self._writer = self.enter_context(parquet.ParquetWriter(path, self._schema))
        self.callback(self._flush)

    def add(self, values: Mapping[str, Scalar]) -> None:
        """Add a row, which is written with others."""
        self._rows.append({name: convert(values[name]) for name, convert in self._converters.items() if name in values})
        if len(self._rows) >= ROWS_AT_ONCE:
            self._flush()

    def _flush(self) -> None:
        if self._rows:
            self._writer.write_table(self._arrow.Table.from_pylist(self._rows, schema=self._schema))
            self._rows.clear()


def _converter(types: set[type]) -> Callable[[Any], Scalar]:
    """The type of a column."""
    if types in ({bool}, {int}):
        return next(iter(types))
    return float if types <= {int, float} else str
