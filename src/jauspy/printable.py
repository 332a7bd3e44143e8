"""Text from peers and files, made safe to show: it moves no cursor, turns no direction, and stays on its line."""

from __future__ import annotations


def printable(text: str) -> str:
    r"""The text with what is not printable escaped: control characters, line breaks, directions (`\x1b`, `\u202e`)."""
    if text.isprintable():
        return text
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text)


def printable_lines(text: str) -> str:
    """The same for text that has several lines."""
    return text if text.isprintable() else "\n".join(map(printable, text.split("\n")))
