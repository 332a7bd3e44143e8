"""Fewer and plainer bytes that still show the same problem (delta debugging)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final

from jauspy.codec.items import Item, Repeat
from jauspy.fuzz.spots import Spot, spots_of

MOST_TRIES: Final = 1500
KEPT: Final = 2
"""The message id stays."""

Shows = Callable[[bytes], bool]


def minimise(data: bytes, shows: Shows, layout: Item | None = None, tries: int = MOST_TRIES) -> bytes:
    """The smallest bytes that were found within so many tries; `shows` says whether bytes show the problem.

    With a layout, elements and fields are left out together with their count or presence bit, too.
    """
    budget = _Budget(shows, tries)
    before = b""
    while data != before and budget.left:
        before = data
        if layout is not None:
            data = _without_parts(data, layout, budget)
        data = _plainer(_shorter(data, budget), budget)
    return data


class _Budget:
    def __init__(self, shows: Shows, tries: int) -> None:
        self._shows = shows
        self.left = tries

    def shows(self, data: bytes) -> bool:
        """False without a try when there is none left."""
        if not self.left:
            return False
        self.left -= 1
        return self._shows(data)


def _without_parts(data: bytes, layout: Item, budget: _Budget) -> bytes:
    """Leave out parts as long as that goes."""
    found = True
    while found:
        found = False
        for spot in spots_of(layout, data):
            smaller = next((candidate for candidate in _without(data, spot) if budget.shows(candidate)), None)
            if smaller is not None:
                data, found = smaller, True
                break
    return data


def _without(data: bytes, spot: Spot) -> Iterator[bytes]:
    """The data without some elements of a count, or without a field of a presence vector."""
    number = int.from_bytes(data[spot.at : spot.at + spot.size], "little")
    if spot.kind == "presence":
        for bit, (start, end) in enumerate(zip(spot.cuts[::2], spot.cuts[1::2], strict=True)):
            if number >> bit & 1:
                yield _cut(data, spot, number & ~(1 << bit), start, end)
    if spot.kind != "count" or len(spot.cuts) < 2:
        return
    borders = spot.cuts if isinstance(spot.item, Repeat) else range(spot.cuts[0], spot.cuts[-1] + 1)
    size = len(borders) - 1
    while size:
        for first in range(0, len(borders) - size, size):
            yield _cut(data, spot, max(number - size, 0), borders[first], borders[first + size])
        size //= 2


def _cut(data: bytes, spot: Spot, number: int, start: int, end: int) -> bytes:
    """Another number at the spot, and nothing from `start` to `end`."""
    head = data[: spot.at] + number.to_bytes(spot.size, "little") + data[spot.at + spot.size :]
    return head[:start] + head[end:]


def _shorter(data: bytes, budget: _Budget) -> bytes:
    """Leave out blocks, halves first, then smaller and smaller ones; the last bytes first."""
    size = max(len(data) - KEPT, 0)
    while size:
        end = len(data)
        while end > KEPT:
            start = max(end - size, KEPT)
            candidate = data[:start] + data[end:]
            if budget.shows(candidate):
                data = candidate
            end = start
        size //= 2
    return data


def _plainer(data: bytes, budget: _Budget) -> bytes:
    """Zeros, where they do as well."""
    for at in range(KEPT, len(data)):
        if data[at]:
            candidate = data[:at] + b"\0" + data[at + 1 :]
            if budget.shows(candidate):
                data = candidate
    return data
