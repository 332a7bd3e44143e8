"""The clearance of a footprint is that of its rectangle, also at its corners."""

from __future__ import annotations

import math

import numpy as np
import pytest

pytest.importorskip("scipy", reason="needs the extra `planning`")

from scipy import ndimage

from jauspy.planning.footprint import Footprint
from jauspy.planning.mobility import Mobility

CELL, COUNT = 0.05, 120
LOW = -0.5 * CELL * COUNT
MOBILITY = Mobility(front=0.4, back=0.45, half_width=0.34, step=0.08, flipper_step=0.2, up=0.5, down=0.5, side=0.3)
ENOUGH = 0.12


def footprint_among(cells: np.ndarray) -> tuple[Footprint, np.ndarray]:
    """The footprint in a map with blocked cells, rows and columns of shape (n, 2); and their centres, x and y."""
    blocked = np.zeros((COUNT, COUNT), bool)
    blocked[tuple(cells.T)] = True
    distance = (ndimage.distance_transform_edt(~blocked) * CELL).astype(np.float32)
    return Footprint(MOBILITY, distance, (LOW, LOW), CELL), LOW + (cells[:, ::-1] + 0.5) * CELL


def from_rectangle(points: np.ndarray, x: float, y: float, heading: float) -> float:
    """Metres from the rectangle of the robot to the nearest point; 0 inside."""
    c, s = math.cos(heading), math.sin(heading)
    ahead, left = np.array([[c, s], [-s, c]]) @ (points - (x, y)).T
    beyond = np.maximum(np.maximum(ahead - MOBILITY.front, -MOBILITY.back - ahead), 0.0)
    return float(np.hypot(beyond, np.maximum(np.abs(left) - MOBILITY.half_width, 0.0)).min())


def test_the_clearance_is_that_of_the_rectangle() -> None:
    rng = np.random.default_rng(7)
    near = 0
    for _ in range(100):
        found, points = footprint_among(rng.integers(0, COUNT, (12, 2)))
        for x, y, heading in rng.uniform((-2.0, -2.0, -math.pi), (2.0, 2.0, math.pi), (20, 3)):
            true = from_rectangle(points, x, y, heading)
            clearance = found.clearance(x, y, heading, ENOUGH, is_exact=True)
            along = found.clearances(np.array([x, x]), np.array([y, y]), heading, is_exact=True)
            if true < ENOUGH - 0.04:
                near += true > 0.0
                assert clearance == pytest.approx(along[0], abs=1e-6)
            else:
                assert clearance > min(true, ENOUGH) - 0.04
                assert along[1] == pytest.approx(true, abs=0.04)
            assert (clearance <= 0.02) if true == 0.0 else (true - 0.04 < clearance < true + 0.02) or true > ENOUGH
    assert near > 50


def test_a_robot_turns_where_its_corners_pass() -> None:
    """Between walls that are 1.25 m apart; the corner at the rear is 0.564 m from the base."""
    rows = [round((side - LOW) / CELL - 0.5) for side in (-0.625, 0.625)]
    found, _ = footprint_among(np.array([(row, column) for row in rows for column in range(COUNT)]))
    clearances = [
        found.clearance(0.0, 0.0, heading, ENOUGH, is_exact=True) for heading in np.linspace(0.0, math.tau, 33)
    ]
    assert min(clearances) == pytest.approx(0.625 - math.hypot(0.45, 0.34), abs=0.02)
    circles = [found.clearance(0.0, 0.0, heading, ENOUGH, is_exact=False) for heading in (0.0, math.pi / 2.0)]
    assert circles[0] == pytest.approx(0.625 - 0.34, abs=0.04)
    assert circles[1] < -0.05, "circles reach beyond the ends"


def test_outside_of_the_map_there_is_no_clearance() -> None:
    found, _ = footprint_among(np.array([(0, 0)]))
    assert found.clearance(LOW - 0.1, 0.0, 0.0, ENOUGH, is_exact=True) == -math.inf
    assert found.clearance(0.0, -LOW + 0.1, 0.0, ENOUGH, is_exact=True) == -math.inf
    assert found.clearance(-LOW - 0.2, 0.0, 0.0, ENOUGH, is_exact=True) < -1e3, "a part of it is outside"
    assert found.clearances(np.array([0.0, 9.0]), np.zeros(2), 0.0, is_exact=True)[1] == -math.inf
