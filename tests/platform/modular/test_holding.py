"""Strength of suction cups and latches: the published figures, and loads in combination."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jauspy.platform.modular.holding import CUP, GRIPPER_CUP, LATCH, SAFETY, Holding

NOTHING = (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("holding", "force", "moment"), [(CUP, 254.0, 7.6), (GRIPPER_CUP, 137.0, 3.0), (LATCH, 1100.0, 27.5)]
)
def test_strengths_are_the_published_ones(holding: Holding, force: float, moment: float) -> None:
    assert holding.force == pytest.approx(force, rel=0.01)
    assert holding.moment == pytest.approx(moment, rel=0.01)
    assert holding.utilisation((0.0, 0.0, -force), NOTHING) == pytest.approx(1.0, rel=0.01)
    assert holding.utilisation(NOTHING, (0.0, moment, 0.0)) == pytest.approx(1.0, rel=0.01)
    assert holding.utilisation((0.0, 0.5 * force, 0.0), NOTHING) == pytest.approx(1.0, rel=0.01)
    assert holding.utilisation(NOTHING, (0.0, 0.0, -0.5 * moment)) == pytest.approx(1.0, rel=0.01)


def test_pressing_plates_together_is_no_load() -> None:
    assert CUP.utilisation((0.0, 0.0, 10.0 * CUP.force), NOTHING) == 0.0


def test_loads_combine() -> None:
    """Friction carries shear and torsion together; tipping and sliding need the same force, the pull comes on top."""
    force, radius = CUP.force, CUP.radius
    assert CUP.combined(0.3 * force, 0.0, 0.4 * force * radius, 0.0) == pytest.approx(0.7)
    assert CUP.combined(0.3 * force, 0.2 * force, 0.1 * force * radius, 0.0) == pytest.approx(0.7)
    assert CUP.combined(0.0, 0.3 * force, 0.0, 0.4 * force * radius) == pytest.approx(1.0)


def test_many_loads_at_once_are_the_same() -> None:
    random = np.random.default_rng(1)
    forces, moments = random.normal(size=(2, 5, 20, 3)) * np.array([100.0, 5.0])[:, None, None, None]
    found = LATCH.utilisations(forces, moments)
    assert found.shape == (5, 20)
    for index in np.ndindex(5, 20):
        assert found[index] == pytest.approx(LATCH.utilisation(forces[index], moments[index]))


def test_what_is_planned_leaves_a_third() -> None:
    assert LATCH.moment / SAFETY == pytest.approx(18.3, abs=0.05)
    assert math.isclose(1.0 / SAFETY, 2.0 / 3.0)
