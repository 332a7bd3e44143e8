"""Output of the verbs: results to stdout, everything else to stderr; colours and live displays on terminals only.

All output goes through this module, which makes text from peers and files printable.
"""

from __future__ import annotations

import json
import logging
import os
import select
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, TextIO

from jauspy.logs import LIMIT, MAX_LINE
from jauspy.printable import printable, printable_lines

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderableType
    from rich.segment import Segment


@cache
def _console(*, stderr: bool, width: int | None = None) -> Console:
    from rich.console import Console
    from rich.segment import Segment

    class SafeConsole(Console):
        """Replaces unprintable characters. `main` handles a closed pipe; rich would exit with status 1."""

        def render(self, renderable: RenderableType, options: ConsoleOptions | None = None) -> Iterator[Segment]:
            """Render as `Console.render` does."""
            for segment in super().render(renderable, options):
                safe = segment.control or segment.text.isprintable()
                yield segment if safe else Segment(printable_lines(segment.text), segment.style)

        def on_broken_pipe(self) -> None:
            raise  # noqa: PLE0704 - rich calls this while it handles the error

    return SafeConsole(stderr=stderr, highlight=False, emoji=False, soft_wrap=True, width=width)


def stdout(pipe_width: int | None = None) -> Console:
    """The console for results. Lines are not wrapped or cut, so that they can be searched and piped.

    Tables are as wide as the terminal; `pipe_width` is their width in columns when stdout is not a terminal.
    """
    return _console(stderr=False, width=None if is_terminal() else pipe_width)


def stderr() -> Console:
    """The console for everything but results."""
    return _console(stderr=True)


def print_lines(*lines: str, file: TextIO | None = None) -> None:
    """Print and flush lines, on stdout unless `file` is another stream."""
    print(*map(printable, lines), sep="\n", file=file, flush=True)


def print_json(value: Any, *, flush: bool = True) -> None:
    """Print one JSON object in a line on stdout."""
    sys.stdout.write(json_line(value))
    if flush:
        sys.stdout.flush()


def json_line(value: Any) -> str:
    """A line of JSON; what a terminal would not print is escaped."""
    try:
        text = _fast_encoder()(value).decode()
    except TypeError:  # integers of more than 64 bits
        text = json.dumps(value, ensure_ascii=False, separators=(",", ":"))
    is_safe = text.isascii() or text.isprintable()  # JSON of ASCII text is the same with and without escapes
    return (text if is_safe else json.dumps(value, separators=(",", ":"))) + "\n"


@cache
def _fast_encoder() -> Callable[[Any], bytes]:
    """The encoder of orjson, which takes 10 ms to load."""
    from orjson import dumps

    return dumps


def styled_printer() -> Callable[[Iterable[Iterable[tuple[str, str]]]], None]:
    """A function that prints lines of texts and their styles on stdout, without flushing; terminals show the styles.

    Whether stdout is a terminal is asked once: asking takes longer than printing.
    """
    out = stdout()
    if not out.is_terminal:
        return _print_plain
    from rich.text import Text

    def print_styled(lines: Iterable[Iterable[tuple[str, str]]]) -> None:
        for parts in lines:
            out.print(Text.assemble(*parts))

    return print_styled


def _print_plain(lines: Iterable[Iterable[tuple[str, str]]]) -> None:
    sys.stdout.write("".join([printable_lines("".join([text for text, _ in parts])) + "\n" for parts in lines]))


def error(message: str) -> None:
    """Print the first line in red on stderr; further lines explain it and are not coloured."""
    from rich.text import Text

    sentence, newline, rest = message.partition("\n")
    stderr().print(Text.assemble(("Error: ", "bold red"), (sentence, "red"), newline, rest))


def note(message: str) -> None:
    """Print one dim line on stderr."""
    from rich.text import Text

    stderr().print(Text(message, style="dim"))


def print_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table without borders: fitted to a terminal; in a pipe, with whole lines so that they can be searched."""
    rows = [[printable(cell) for cell in row] for row in rows]
    if is_terminal():
        from rich.table import Table
        from rich.text import Text

        table = Table(*header, box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
        for row in rows:
            table.add_row(*map(Text, row))
        stdout().print(table, soft_wrap=False)
        return
    widths = [max(map(len, column)) for column in zip(header, *rows, strict=True)]
    for row in (header, *rows):
        cells = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        print("  ".join(cells).rstrip())


def print_counters(counters: Mapping[str, int], title: str = "counters:") -> None:
    """Print the counters that are not zero, one per line, on stderr."""
    counted = {name: count for name, count in sorted(counters.items()) if count}
    width = max(map(len, counted), default=0)
    lines = [f"  {name:<{width}}  {count}" for name, count in counted.items()] or ["  nothing was received or sent"]
    print_if_read(title, *lines, file=sys.stderr)


def print_if_read(*lines: str, file: TextIO | None = None) -> None:
    """Print lines of a service: drop the lines when nobody reads them or the disk is full."""
    stream = file or sys.stdout
    if not _has_room(stream):
        return
    try:
        print_lines(*lines, file=stream)
    except BrokenPipeError:
        raise
    except OSError:
        _discard(stream)


def _has_room(stream: TextIO) -> bool:
    """False when writing would block; a pipe with room takes at least 4096 bytes."""
    try:
        return bool(select.select([], [stream], [], 0)[1])
    except (OSError, ValueError):  # not a file of the system
        return True


class _NonBlockingHandler(logging.StreamHandler[TextIO]):
    """Drops lines instead of blocking when the pipe is full."""

    def emit(self, record: logging.LogRecord) -> None:
        if _has_room(self.stream):
            super().emit(record)


class LogFormatter(logging.Formatter):
    """Formats records as printable text: one line for a record, further ones for a traceback."""

    def __init__(self) -> None:
        super().__init__("%(asctime)s %(levelname)s %(name)s: %(message)s")

    def formatMessage(self, record: logging.LogRecord) -> str:  # noqa: N802 - the name in `logging`
        """Same as `logging.Formatter`."""
        return printable(super().formatMessage(record))

    def formatException(self, ei: Any) -> str:  # noqa: N802 - the name in `logging`
        """Same as `logging.Formatter`."""
        lines = printable_lines(super().formatException(ei)).split("\n")
        return "\n".join(line if len(line) <= MAX_LINE else f"{line[:MAX_LINE]} ..." for line in lines)


def log_to_stderr(level: str, formatter: logging.Formatter | None = None) -> None:
    """Log to stderr from `level` on, as text if `formatter` is None."""
    handler = _NonBlockingHandler()
    handler.setFormatter(formatter or LogFormatter())
    handler.addFilter(LIMIT)  # for lines of other packages
    logging.basicConfig(level=level, handlers=[handler])
    logging.getLogger("asyncio").setLevel(logging.WARNING)


def discard_stdout() -> None:
    """Redirect stdout to /dev/null, so that the interpreter does not fail again when it flushes stdout at exit."""
    _discard(sys.stdout)


def _discard(stream: TextIO) -> None:
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def shows_yaml(*, as_json: bool) -> bool:
    """How verbs print records, such as an answer: YAML on a terminal, JSON lines in a pipe or with `--json`."""
    return not as_json and is_terminal()


def is_terminal() -> bool:
    """True if stdout is a terminal."""
    return sys.stdout.isatty()


def is_interactive() -> bool:
    """True if stdout and stderr are terminals, so that a live display can be shown."""
    return sys.stdout.isatty() and sys.stderr.isatty()
