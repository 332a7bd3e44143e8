"""Differences between a recorded answer and the one that came when its request was replayed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from fnmatch import fnmatchcase
from typing import Final, TypeAlias

from jauspy.codec.field_paths import leaves, without_numbers
from jauspy.codec.message import Message
from jauspy.codec.rounding import rounded

Value: TypeAlias = Enum | str | bytes | float | None

ABSENT: Final = "(absent)"
ALWAYS_IGNORED: Final = ("event_id",)
"""Ids that the target assigns; later requests are sent with those of the target."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """What is compared, besides the ids of messages.

    By default enumerations, texts, and which fields there are: numbers are measurements, which differ. `strict`
    compares all values, numbers within `tolerance` (absolute, and as a part of the value). `ignored` are names of
    fields, or the first or last parts of their paths, with `*` as in file names.
    """

    strict: bool = False
    tolerance: float = 0.0
    ignored: tuple[str, ...] = ()

    def differences(self, recorded: Message, live: Message) -> Iterator[tuple[str, str, str]]:
        """Field, recorded value and live value of each difference; the field is empty for another message."""
        if recorded.CODE != live.CODE:
            yield "", recorded.NAME, live.NAME
            return
        before, now = dict(leaves(rounded(recorded))), dict(leaves(rounded(live)))
        for path in dict.fromkeys((*before, *now)):
            if self._ignores(path):
                continue
            old, new = before.get(path), now.get(path)
            if self._differ(path, old, new):
                yield path, _text(old), _text(new)

    def _ignores(self, path: str) -> bool:
        names = without_numbers(path).split(".")
        ends = [".".join(names[first:]) for first in range(len(names))]
        starts = [".".join(names[: last + 1]) for last in range(len(names))]
        return any(
            fnmatchcase(name, wanted) for wanted in (*ALWAYS_IGNORED, *self.ignored) for name in (*ends, *starts)
        )

    def _differ(self, path: str, old: Value, new: Value) -> bool:
        if old is None or new is None:  # lists of measurements may have other lengths
            return self.strict or "[" not in path or _is_exact(new if old is None else old)
        if self.strict and _is_number(old) and _is_number(new):
            return not _is_close(_number(old), _number(new), self.tolerance)
        if self.strict or _is_exact(old) or _is_exact(new):
            return old != new
        return False


def _is_exact(value: Value) -> bool:
    """True for enumerations, texts and booleans, which are no measurements."""
    return isinstance(value, Enum | str | bool)


def _is_number(value: Value) -> bool:
    return isinstance(value, int | float) and not isinstance(value, Enum)


def _number(value: Value) -> float:
    assert isinstance(value, int | float)
    return float(value)


def _is_close(old: float, new: float, tolerance: float) -> bool:
    return (math.isnan(old) and math.isnan(new)) or math.isclose(old, new, rel_tol=tolerance, abs_tol=tolerance)


def _text(value: Value) -> str:
    if value is None:
        return ABSENT
    if isinstance(value, Enum):
        return value.name
    return value.hex() if isinstance(value, bytes) else str(value)
