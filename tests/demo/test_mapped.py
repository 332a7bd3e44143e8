"""How well scans that are not in a map agree with it."""

import math

import pytest

pytest.importorskip("numpy", reason="NumPy is not installed")

from jauspy.demo.full_tour import MIN_AGREEMENT, HoldoutMapper
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid

ANGLES = [math.radians(each) for each in range(360)]


def room(x: float, y: float) -> list[float]:
    """Distances to the walls of a room of 6 m by 4 m around the origin."""
    return [
        min(((3.0 if (c := math.cos(a)) > 0 else -3.0) - x) / c, ((2.0 if (s := math.sin(a)) > 0 else -2.0) - y) / s)
        for a in (angle + 1e-9 for angle in ANGLES)
    ]


@pytest.fixture
def mapper() -> HoldoutMapper:
    mapper = HoldoutMapper(OccupancyGrid(10.0))
    for step in range(10):
        x = 0.05 * step  # every other one is too near to the one before to be used
        mapper.add(PlanarPose(x, 0.0), PlanarPose(), ANGLES, room(x, 0.0))
    return mapper


def test_unused_scans_of_the_same_room_agree_with_the_map(mapper: HoldoutMapper) -> None:
    assert len(mapper.path) + len(mapper.others) == mapper.scans == 10
    assert len(mapper.others) >= 4
    assert mapper.agreement() > MIN_AGREEMENT


def test_scans_of_another_room_disagree_with_the_map(mapper: HoldoutMapper) -> None:
    mapper.others.clear()
    mapper.add(mapper.path[-1], PlanarPose(), ANGLES, [0.8 * far for far in room(0.45, 0.0)])
    assert mapper.agreement() < 0.5


def test_no_echoes_give_no_agreement() -> None:
    assert HoldoutMapper(OccupancyGrid(10.0)).agreement() == 0.0
