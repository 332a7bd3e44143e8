"""Tables: fitted to a terminal, with whole lines in a pipe so that they can be searched."""

from __future__ import annotations

from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from jauspy.cli import console


def print_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """A table without rules; the last column is as wide as it is."""
    if console.is_terminal():
        table = Table(*header, box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
        for row in rows:
            table.add_row(*map(Text, row))
        console.stdout().print(table, soft_wrap=False)
        return
    widths = [max(map(len, column)) for column in zip(header, *rows, strict=True)]
    for row in (header, *rows):
        cells = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        print("  ".join(cells).rstrip())
