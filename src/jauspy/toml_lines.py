"""In which line of a TOML file a key is, for error messages: parsers of TOML do not tell."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import Final

_NAME: Final = r"""(?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*')"""
_KEY: Final = re.compile(rf"\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*=")
_HEADER: Final = re.compile(rf"\s*(\[\[?)\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*\]")
_PART: Final = re.compile(_NAME)


def line_of(text: str, keys: Sequence[str | int]) -> int | None:
    """The line of a key, numbered from 1; that of the table or list which has it, or None if the file has neither.

    `keys` leads from the outermost table to the key; a list's items have numbers.
    """
    table: tuple[str | int, ...] = ()
    lists: Counter[tuple[str | int, ...]] = Counter()
    found, longest = None, 0
    for number, line in enumerate(text.splitlines(), 1):
        if header := _HEADER.match(line):
            table = _within_lists(_names(header[2]), lists)
            if header[1] == "[[":
                table = _names(header[2])
                lists[table] += 1
                table = (*table, lists[table] - 1)
            here = table
        elif key := _KEY.match(line):
            here = (*table, *_names(key[1]))
        else:
            continue
        if len(here) > longest and here == tuple(keys[: len(here)]):
            found, longest = number, len(here)
    return found


def line_prefix(text: str, keys: Sequence[str | int]) -> str:
    """`line 12: `, or nothing for a key that is not in the file, but for example in one that it extends."""
    number = line_of(text, keys)
    return "" if number is None else f"line {number}: "


def _names(text: str) -> tuple[str | int, ...]:
    return tuple(part.strip("\"'") for part in _PART.findall(text))


def _within_lists(names: tuple[str | int, ...], lists: Counter[tuple[str | int, ...]]) -> tuple[str | int, ...]:
    """The way to a table, with the number of the last item of each list on the way."""
    way: tuple[str | int, ...] = ()
    for number, name in enumerate(names, 1):
        way = (*way, name)
        if count := lists[names[:number]]:
            way = (*way, count - 1)
    return way
