"""Linear least squares with bounds, for few unknowns: an active-set method on the normal equations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from operator import mul
from typing import Final, TypeAlias

Row: TypeAlias = Sequence[float]

GRADIENT_TOLERANCE: Final = 1e-12
"""Slope of the cost at a bound below which the bound is kept."""


def bounded_least_squares(matrix: Sequence[Row], target: Row, lower: Row, upper: Row, damping: Row) -> list[float]:
    """The x of shape (n,), within bounds, that minimises |matrix x - target|^2 + |damping x|^2.

    Shapes: `matrix` (m, n), as rows; `target` (m,); the others (n,). No damping is zero, so the minimum is unique. The
    result is within the bounds even if rounding ends the search early.
    """
    columns = list(zip(*matrix, strict=True))
    normal = [[_dot(a, b) for b in columns] for a in columns]
    for number, factor in enumerate(damping):
        normal[number][number] += factor * factor
    return _Problem(normal, [_dot(column, target) for column in columns], lower, upper).solve()


def _dot(a: Row, b: Row) -> float:
    return float(sum(map(mul, a, b)))


class _Problem:
    """`matrix` (n, n) times x equals `goal`, within bounds."""

    def __init__(self, matrix: Sequence[Row], goal: Row, lower: Row, upper: Row) -> None:
        self._matrix, self._goal = matrix, goal
        self._lower, self._upper = lower, upper
        self._x = [min(high, max(low, 0.0)) for low, high in zip(lower, upper, strict=True)]

    def solve(self) -> list[float]:
        """Activate the bounds that x reaches, and release those that prevent the cost from falling."""
        held: set[int] = set()
        for _ in range(4 * len(self._x) + 4):
            stopped = self._go([number for number in range(len(self._x)) if number not in held])
            if stopped is not None:
                held.add(stopped)
            elif (released := self._to_release(held)) is not None:
                held.remove(released)
            else:
                break
        return self._x

    def _go(self, free: Sequence[int]) -> int | None:
        """Move the free values to their optimum, or to the first bound on the way; returns the index of its value."""
        x, share, stopped = self._x, 1.0, None
        best = self._best(free)
        for number, value in zip(free, best, strict=True):
            ahead, left = value - x[number], self._bound(number, value) - x[number]
            if abs(ahead) > abs(left) and left / ahead < share:
                share, stopped = max(0.0, left / ahead), number
        for number, value in zip(free, best, strict=True):
            x[number] = self._bound(number, value) if number == stopped else x[number] + share * (value - x[number])
        return stopped

    def _bound(self, number: int, value: float) -> float:
        return self._upper[number] if value > self._x[number] else self._lower[number]

    def _to_release(self, held: set[int]) -> int | None:
        worst, found = GRADIENT_TOLERANCE, None
        for number in held:
            pull = self._goal[number] - _dot(self._matrix[number], self._x)
            inward = pull if self._x[number] == self._lower[number] else -pull
            if inward > worst and self._lower[number] < self._upper[number]:
                worst, found = inward, number
        return found

    def _best(self, free: Sequence[int]) -> list[float]:
        """The optimum of the free values; the others stay."""
        matrix, x = self._matrix, self._x
        fixed = [0.0 if number in free else value for number, value in enumerate(x)]
        right = [self._goal[number] - _dot(matrix[number], fixed) for number in free]
        return _solve([[matrix[row][column] for column in free[: place + 1]] for place, row in enumerate(free)], right)


def _solve(lower_half: Sequence[Row], right: list[float]) -> list[float]:
    """Solve a symmetric positive definite system by Cholesky factorisation."""
    factors: list[list[float]] = []
    for row in lower_half:
        line: list[float] = []
        for value, above in zip(row, factors, strict=False):
            line.append((value - _dot(line, above)) / above[-1])
        line.append(math.sqrt(max(1e-300, row[-1] - _dot(line, line))))
        factors.append(line)
    for place, line in enumerate(factors):
        right[place] = (right[place] - _dot(line[:-1], right)) / line[-1]
    for place in reversed(range(len(factors))):
        right[place] /= factors[place][place]
        for other in range(place):
            right[other] -= factors[place][other] * right[place]
    return right
