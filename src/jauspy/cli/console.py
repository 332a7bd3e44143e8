"""Output of the verbs: results to stdout, everything else to stderr; colours and live displays on terminals only."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING

from jauspy.logs import LIMIT

if TYPE_CHECKING:
    from rich.console import Console


@cache
def _console(*, stderr: bool, width: int | None = None) -> Console:
    from rich.console import Console

    class PipeConsole(Console):
        """Leaves a closed pipe to `main`; rich itself would end with status 1."""

        def on_broken_pipe(self) -> None:
            raise  # noqa: PLE0704 - rich calls this while it handles the error

    return PipeConsole(stderr=stderr, highlight=False, emoji=False, soft_wrap=True, width=width)


def stdout(pipe_width: int | None = None) -> Console:
    """The console for results. Lines are not wrapped or cut, so that they can be searched and piped.

    Tables are as wide as the terminal; `pipe_width` is their width in columns when stdout is not a terminal.
    """
    return _console(stderr=False, width=None if is_terminal() else pipe_width)


def stderr() -> Console:
    """The console for everything but results."""
    return _console(stderr=True)


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
    print(title, *lines, sep="\n", file=sys.stderr, flush=True)


def log_to_stderr(level: str, formatter: logging.Formatter | None = None) -> None:
    """Log to stderr from `level` on, as text if `formatter` is None."""
    handler = logging.StreamHandler()
    handler.setFormatter(formatter or logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    handler.addFilter(LIMIT)  # for lines of other packages
    logging.basicConfig(level=level, handlers=[handler])
    logging.getLogger("asyncio").setLevel(logging.WARNING)


def discard_stdout() -> None:
    """Redirect stdout to /dev/null, so that the interpreter does not fail again when it flushes stdout at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def is_terminal() -> bool:
    """True if stdout is a terminal."""
    return sys.stdout.isatty()


def is_interactive() -> bool:
    """True if stdout and stderr are terminals, so that a live display can be shown."""
    return sys.stdout.isatty() and sys.stderr.isatty()
