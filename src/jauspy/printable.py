"""Makes text from peers and files safe to print: without control characters, changes of direction and line breaks."""

from __future__ import annotations

from typing import Final

FORMULA_STARTS: Final = ("=", "+", "-", "@", "\t", "\r")
"""First characters of text that spreadsheets take for a formula."""


def printable(text: str) -> str:
    r"""The text with unprintable characters escaped: control characters, line breaks, directions (`\x1b`, `\u202e`)."""
    if text.isprintable():
        return text
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text)


def printable_lines(text: str) -> str:
    """The same for text that has several lines."""
    return text if text.isprintable() else "\n".join(map(printable, text.split("\n")))


def spreadsheet_text(text: str) -> str:
    """Text for a cell of a table, with an apostrophe before what a spreadsheet would take for a formula."""
    return f"'{text}" if text.startswith(FORMULA_STARTS) else text
