"""Findings: a problem by its cause, the bytes that reproduce it, minimised by delta debugging, and its JSON file."""

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
from jauspy.fuzz.mutation import ByteSpan, offsets_of


@dataclass(frozen=True, slots=True)
class Problem:
    """The problem that a check reports. `what` is the exception type or field path that distinguishes it."""

    check: str
    what: str
    seen: str


@dataclass(frozen=True, slots=True)
class FuzzFinding:
    """A problem and the bytes that reproduce it. `seed` and `case` identify the campaign and case."""

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
        """The bytes of the case."""
        return bytes.fromhex(self.hex)

    def smaller(self, data: bytes, seen: str) -> FuzzFinding:
        """The same problem, reproduced by other bytes."""
        return replace(self, hex=data.hex(), seen=seen)

    def save(self, folder: Path) -> Path:
        """Write `<cause>.json` into a folder, which is created if necessary."""
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / (re.sub(r"[^\w.]+", "-", self.cause).strip("-.") + ".json")
        path.write_text(json.dumps({"cause": self.cause, **asdict(self)}, indent=2) + "\n", encoding="utf-8")
        return path


def load_finding(path: Path) -> FuzzFinding:
    """The inverse of `FuzzFinding.save`; raises `ConfigError`."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        finding = FuzzFinding(**{name: data[name] for name in FuzzFinding.__slots__})
        assert len(finding.data) >= 2
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, KeyError, TypeError, AssertionError):
        raise ConfigError(f"{path} is not a finding of jauspy fuzz") from None
    return finding


MAX_TRIES: Final = 1500
MESSAGE_ID_SIZE: Final = 2
"""Number of bytes that are kept: the message id."""

Reproduces = Callable[[bytes], bool]


def minimise(data: bytes, shows: Reproduces, layout: Item | None = None, tries: int = MAX_TRIES) -> bytes:
    """The smallest bytes found within `tries` attempts; `shows` returns whether bytes reproduce the problem.

    With a layout, elements and fields are removed together with their count or presence bit.
    """
    budget = _Attempts(shows, tries)
    before = b""
    while data != before and budget.left:
        before = data
        if layout is not None:
            data = _without_parts(data, layout, budget)
        data = _zeroed(_shorter(data, budget), budget)
    return data


class _Attempts:
    def __init__(self, shows: Reproduces, tries: int) -> None:
        self._shows = shows
        self.left = tries

    def shows(self, data: bytes) -> bool:
        """True if the bytes reproduce the problem; always false once all attempts are used."""
        if not self.left:
            return False
        self.left -= 1
        return self._shows(data)


def _without_parts(data: bytes, layout: Item, budget: _Attempts) -> bytes:
    """Remove parts until no more can be removed."""
    found = True
    while found:
        found = False
        for offset in offsets_of(layout, data):
            smaller = next((candidate for candidate in _without(data, offset) if budget.shows(candidate)), None)
            if smaller is not None:
                data, found = smaller, True
                break
    return data


def _without(data: bytes, offset: ByteSpan) -> Iterator[bytes]:
    """The data without some elements of a count, or without a field of a presence vector."""
    number = int.from_bytes(data[offset.at : offset.at + offset.size], "little")
    if offset.kind == "presence":
        for bit, (start, end) in enumerate(zip(offset.cuts[::2], offset.cuts[1::2], strict=True)):
            if number >> bit & 1:
                yield _cut(data, offset, number & ~(1 << bit), start, end)
    if offset.kind != "count" or len(offset.cuts) < 2:
        return
    borders = offset.cuts if isinstance(offset.item, Repeat) else range(offset.cuts[0], offset.cuts[-1] + 1)
    size = len(borders) - 1
    while size:
        for first in range(0, len(borders) - size, size):
            yield _cut(data, offset, max(number - size, 0), borders[first], borders[first + size])
        size //= 2


def _cut(data: bytes, offset: ByteSpan, number: int, start: int, end: int) -> bytes:
    """Replace the number at the offset, and remove the bytes from `start` to `end`."""
    head = data[: offset.at] + number.to_bytes(offset.size, "little") + data[offset.at + offset.size :]
    return head[:start] + head[end:]


def _shorter(data: bytes, budget: _Attempts) -> bytes:
    """Remove blocks, halves first, then smaller ones, from the end."""
    size = max(len(data) - MESSAGE_ID_SIZE, 0)
    while size:
        end = len(data)
        while end > MESSAGE_ID_SIZE:
            start = max(end - size, MESSAGE_ID_SIZE)
            candidate = data[:start] + data[end:]
            if budget.shows(candidate):
                data = candidate
            end = start
        size //= 2
    return data


def _zeroed(data: bytes, budget: _Attempts) -> bytes:
    """Replace bytes by zeros where the problem remains."""
    for offset in range(MESSAGE_ID_SIZE, len(data)):
        if data[offset]:
            candidate = data[:offset] + b"\0" + data[offset + 1 :]
            if budget.shows(candidate):
                data = candidate
    return data
