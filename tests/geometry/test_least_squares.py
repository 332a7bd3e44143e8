"""Least squares with bounds: the answer fulfils the conditions that only the best one does (Karush, Kuhn, Tucker)."""

import random

import pytest

from jauspy.geometry.least_squares import bounded_least_squares


def slope(rows, wanted, damping, x) -> list[float]:
    """Of half the sum of squares, by each x."""
    errors = [sum(a * b for a, b in zip(row, x, strict=True)) - goal for row, goal in zip(rows, wanted, strict=True)]
    columns = zip(*rows, strict=True)
    return [
        sum(a * error for a, error in zip(column, errors, strict=True)) + factor * factor * value
        for column, factor, value in zip(columns, damping, x, strict=True)
    ]


@pytest.mark.parametrize("seed", range(100))
def test_solution_is_optimal_within_bounds(seed: int) -> None:
    rng = random.Random(seed)
    unknowns, equations = rng.randint(1, 8), rng.randint(1, 9)
    rows = [[rng.gauss(0.0, 1.0) for _ in range(unknowns)] for _ in range(equations)]
    wanted = [rng.gauss(0.0, 3.0) for _ in range(equations)]
    lower, upper = ([side * rng.random() for _ in range(unknowns)] for side in (-1.0, 1.0))
    damping = [10.0 ** rng.uniform(-3.0, 0.0)] * unknowns
    x = bounded_least_squares(rows, wanted, lower, upper, damping)
    for value, low, high, steep in zip(x, lower, upper, slope(rows, wanted, damping, x), strict=True):
        assert low <= value <= high
        assert value == high or steep > -1e-7, "it would get better with more"
        assert value == low or steep < 1e-7, "it would get better with less"


def test_equal_or_nonzero_bounds_are_kept() -> None:
    x = bounded_least_squares([[1.0, 1.0, 1.0]], [3.0], [0.5, 0.2, -1.0], [0.5, 0.3, 1.0], [0.01] * 3)
    assert x == [0.5, 0.3, 1.0]


def test_unconstrained_directions_stay_zero() -> None:
    x = bounded_least_squares([[1.0, 0.0], [2.0, 0.0]], [1.0, 2.0], [-9.0, -9.0], [9.0, 9.0], [1e-4, 1e-4])
    assert x == pytest.approx([1.0, 0.0], abs=1e-6)
