"""A finding: what went wrong, named by its cause, in a small JSON file."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Final

from jauspy.codec.items import Item
from jauspy.codec.layout import Repeat
from jauspy.errors import ConfigError
from jauspy.fuzz.offsets import Spot, spots_of


@dataclass(frozen=True, slots=True)
class Problem:
    """What a check has to say; `what` is the exception type or field path that makes it this problem and no other."""

    check: str
    what: str
    seen: str


@dataclass(frozen=True, slots=True)
class Finding:
    """A problem and the bytes that show it. `seed` and `case` say which campaign made them."""

    check: str
    message: str
    service: str
    version: str
    what: str
    seen: str
    hex: str
    seed: int
    case: int

    @property
    def cause(self) -> str:
        """The name of the problem: the same for all bytes that show it."""
        return " ".join(part for part in (self.check, self.message, self.version, self.what) if part)

    @property
    def data(self) -> bytes:
        """The bytes."""
        return bytes.fromhex(self.hex)

    def smaller(self, data: bytes, seen: str) -> Finding:
        """The same problem, shown by other bytes."""
        return replace(self, hex=data.hex(), seen=seen)

    def save(self, folder: Path) -> Path:
        """Write `<cause>.json` into a folder that is made when it is not there."""
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / (re.sub(r"[^\w.]+", "-", self.cause).strip("-.") + ".json")
        path.write_text(json.dumps({"cause": self.cause, **asdict(self)}, indent=2) + "\n", encoding="utf-8")
        return path


def load_finding(path: Path) -> Finding:
    """The inverse of `Finding.save`; raises `ConfigError`."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        finding = Finding(**{name: data[name] for name in Finding.__slots__})
        assert len(finding.data) >= 2
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, KeyError, TypeError, AssertionError):
        raise ConfigError(f"{path} is not a finding of jauspy fuzz") from None
    return finding


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
