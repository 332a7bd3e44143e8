"""Values of one field over time, and their drawing with the dots of braille characters."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator
from enum import Enum
from typing import Final

from jauspy.capture.filters import printed_values
from jauspy.codec.field_paths import leaves, without_numbers
from jauspy.codec.message import Message
from jauspy.inspection.rates import Route
from jauspy.inspection.traffic import SeenMessage

MAX_POINTS: Final = 20_000
MAX_FIELDS: Final = 200
"""Fields of a message that are offered."""
_BRAILLE: Final = 0x2800
_DOTS: Final = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))
"""Bits of the dots of a braille character, by column and row."""


class Series:
    """The newest values of a field of the messages of one route."""

    def __init__(self, route: Route, path: str) -> None:
        self.route, self.path = route, path
        self.points: deque[tuple[float, float]] = deque(maxlen=MAX_POINTS)
        """Times and values."""

    def add(self, seen: SeenMessage) -> None:
        """Take the value of a message; others than those of the route are ignored."""
        packet = seen.part.packet
        if Route(str(packet.source), str(packet.destination), seen.name) != self.route:
            return
        for value in printed_values(seen.part.content.message, self.path):
            number = value.value if isinstance(value, Enum) else value
            if isinstance(number, int | float) and math.isfinite(number):
                self.points.append((seen.time, float(number)))
            return


def numeric_fields(message: Message) -> list[str]:
    """The paths of the fields that have numbers; of a list, that of its elements once."""
    found = dict.fromkeys(without_numbers(path) for path, value in leaves(message) if isinstance(value, int | float))
    return list(found)[:MAX_FIELDS]


def curve(points: list[tuple[float, float]], start: float, end: float, width: int, height: int) -> list[str]:
    """Lines of braille characters: time to the right from `start` to `end`, the greatest value at the top."""
    cells = [[0] * width for _ in range(height)]
    shown = [point for point in points if start <= point[0] <= end]
    if not shown or width < 1 or height < 1:
        return ["".join(chr(_BRAILLE) for _ in row) for row in cells]
    low, high = min(value for _, value in shown), max(value for _, value in shown)
    columns, rows = 2 * width - 1, 4 * height - 1
    before: tuple[int, int] | None = None
    for time, value in shown:
        x = round((time - start) / (end - start) * columns) if end > start else columns
        y = round((high - value) / (high - low) * rows) if high > low else rows // 2
        for column, row in _line(before or (x, y), (x, y)):
            cells[row // 4][column // 2] |= _DOTS[column % 2][row % 4]
        before = x, y
    return ["".join(chr(_BRAILLE + cell) for cell in row) for row in cells]


def _line(start: tuple[int, int], end: tuple[int, int]) -> Iterator[tuple[int, int]]:
    """The dots between two dots."""
    steps = max(abs(end[0] - start[0]), abs(end[1] - start[1]), 1)
    for step in range(steps + 1):
        part = step / steps
        yield round(start[0] + part * (end[0] - start[0])), round(start[1] + part * (end[1] - start[1]))
