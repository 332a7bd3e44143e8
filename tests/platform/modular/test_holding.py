"""Strength of suction cups and latches: the published figures, and loads in combination."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jauspy.platform.modular.holding import CUP, GRIPPER_CUP, LATCH, PLATE, SAFETY, Holding

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


def test_without_a_leak_the_vacuum_approaches_the_full_one_exponentially() -> None:
    tau = PLATE.volume / PLATE.suction
    assert PLATE.evacuated(0.0, 0.0, tau) == pytest.approx(1.0 - math.exp(-1.0))
    assert PLATE.evacuated(PLATE.evacuated(0.0, 0.0, tau), 0.0, tau) == pytest.approx(1.0 - math.exp(-2.0))
    assert PLATE.settled(0.0) == 1.0


@pytest.mark.parametrize(("gap", "tilt"), [(0.003, 0.0), (0.0015, 0.03), (0.0, 0.08), (0.0025, 0.01), (0.001, 0.03)])
def test_the_leak_is_the_area_that_the_lip_leaves_open(gap: float, tilt: float) -> None:
    angles = np.linspace(0.0, math.tau, 20001)[:-1]
    open_gap = np.maximum(0.0, gap - PLATE.stroke + PLATE.radius * math.sin(tilt) * np.cos(angles))
    assert PLATE.leak(gap, tilt) == pytest.approx(math.tau * PLATE.radius * float(open_gap.mean()), rel=1e-3, abs=1e-12)


def test_the_vacuum_settles_where_the_pump_keeps_up_with_the_leak() -> None:
    leak = 2e-6
    settled = PLATE.settled(leak)
    inflow = 0.6 * leak * math.sqrt(2.0 * 90e3 * settled / 1.2)
    assert inflow == pytest.approx(PLATE.suction * (1.0 - settled))
    vacuum = 0.0
    for _ in range(100):
        vacuum = PLATE.evacuated(vacuum, leak, 0.004)
        assert vacuum <= settled
    assert vacuum == pytest.approx(settled, rel=1e-3)
    assert PLATE.evacuated(1.0, leak, 0.5) == pytest.approx(settled, rel=1e-3)
    assert PLATE.settled(1e-3) < 0.01
