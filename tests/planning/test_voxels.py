"""The window of voxels: it moves with the robot, forgets what leaves it, and never grows."""

from __future__ import annotations

import numpy as np
import pytest

from jauspy.planning.voxels import MAX_VOXELS, VoxelWindow

POINT = np.array([[1.01, -0.53, 0.26]])


def window() -> VoxelWindow:
    made = VoxelWindow((60, 60, 20), 0.1)
    made.centre_on(np.zeros(3))
    return made


def test_a_point_is_in_the_voxel_around_it() -> None:
    voxels = window()
    cells = voxels.cells(np.concatenate((POINT, POINT + 0.01, [[9.0, 0.0, 0.0]])))
    assert voxels.centres(cells) == pytest.approx(np.array([[1.05, -0.55, 0.25]])), "once, and none outside"


def test_evidence_fades_adds_up_to_a_limit_and_is_taken_by_rays() -> None:
    voxels = window()
    cells = voxels.cells(POINT)
    voxels.hit(cells, 0.0, gain=10.0, keep=25.0)
    assert len(voxels.occupied(9.9)) == 1
    assert len(voxels.occupied(10.1)) == 0
    for _ in range(9):
        voxels.hit(cells, 1.0, gain=10.0, keep=25.0)
    assert len(voxels.occupied(25.9)) == 1
    assert len(voxels.occupied(26.1)) == 0
    assert voxels.ages(cells, 4.0) == pytest.approx([3.0])
    voxels.pass_through(cells, 20.0)
    assert len(voxels.occupied(6.1)) == 0


def test_voxels_stay_where_they_are_while_the_window_moves() -> None:
    voxels = window()
    voxels.hit(voxels.cells(POINT), 0.0, 10.0, 10.0)
    for step in range(1, 40):
        voxels.centre_on(np.array([0.1 * step, -0.07 * step, 0.0]))
        found = voxels.centres(voxels.occupied(1.0))
        assert found == pytest.approx(np.array([[1.05, -0.55, 0.25]])), step


@pytest.mark.parametrize("far", [4.5, 1e4])
def test_what_leaves_the_window_is_forgotten(far: float) -> None:
    voxels = window()
    voxels.hit(voxels.cells(POINT), 0.0, 10.0, 10.0)
    voxels.centre_on(np.array([far, 0.0, 0.0]))
    assert len(voxels.occupied(1.0)) == 0
    voxels.centre_on(np.zeros(3))
    assert len(voxels.occupied(1.0)) == 0
    assert len(voxels.unknown(POINT[0], 0.05)) == 1


def test_the_frontier_is_the_unknown_beside_the_known() -> None:
    voxels = window()
    voxels.mark_known(voxels.cells(POINT))
    frontier = voxels.centres(voxels.frontier(POINT[0], 1.0))
    assert len(frontier) == 6
    assert np.linalg.norm(frontier - (1.05, -0.55, 0.25), axis=1) == pytest.approx(0.1)


def test_memory_is_fixed_and_limited() -> None:
    voxels = window()
    before = voxels.bytes
    voxels.hit(voxels.cells(np.random.default_rng(1).uniform(-9.0, 9.0, (50_000, 3))), 0.0, 10.0, 10.0)
    assert voxels.bytes == before == 17 * 60 * 60 * 20
    with pytest.raises(ValueError, match="voxels; there may be 16,000,000 at most"):
        VoxelWindow((MAX_VOXELS, 2, 1), 0.1)
