"""Inertia of parts against closed forms."""

from __future__ import annotations

import math

import pytest

from jauspy.geometry.poses import Pose, Transform
from jauspy.platform.modular.parts import PartSolid, Shape, combined, inertia


def test_cuboid() -> None:
    found = inertia([PartSolid(Shape.CUBOID, (0.2, 0.3, 0.5), 6.0, Transform(position=(0.1, -0.2, 0.3)))])
    assert found.mass == 6.0
    assert found.center == pytest.approx((0.1, -0.2, 0.3))
    expected = (0.5 * (0.09 + 0.25), 0.5 * (0.04 + 0.25), 0.5 * (0.04 + 0.09))
    assert [found.moments[i][i] for i in range(3)] == pytest.approx(expected)
    assert [found.moments[i][j] for i in range(3) for j in range(3) if i != j] == pytest.approx([0.0] * 6, abs=1e-15)


def test_cylinder_that_lies() -> None:
    lying = Transform.from_pose(Pose(roll=math.pi / 2.0))  # its axis is along y
    found = inertia([PartSolid(Shape.CYLINDER, (0.1, 0.1, 0.6), 2.0, lying)])
    across = 2.0 * (3.0 * 0.01 + 0.36) / 12.0
    assert [found.moments[i][i] for i in range(3)] == pytest.approx((across, 0.01, across))


def test_two_halves_are_a_whole() -> None:
    """Steiner's part: a cuboid cut in two, turned about all axes, has the inertia of the whole."""
    turn = Transform.from_pose(Pose(0.3, 0.1, -0.4, 0.5, -0.7, 1.1))
    halves = [
        PartSolid(Shape.CUBOID, (0.2, 0.3, 0.25), 3.0, turn @ Transform(position=(0.0, 0.0, z)))
        for z in (-0.125, 0.125)
    ]
    whole = inertia([PartSolid(Shape.CUBOID, (0.2, 0.3, 0.5), 6.0, turn)])
    found = inertia(halves)
    assert found.center == pytest.approx(whole.center)
    for row, expected in zip(found.moments, whole.moments, strict=True):
        assert row == pytest.approx(expected)


def test_combined_of_bodies_is_that_of_their_solids() -> None:
    a = PartSolid(Shape.CYLINDER, (0.05, 0.05, 0.2), 0.7, Transform(position=(0.0, 0.1, 0.0)))
    b = PartSolid(Shape.CUBOID, (0.1, 0.2, 0.3), 1.3)
    at = Transform.from_pose(Pose(0.5, -0.2, 0.1, 0.3, 0.2, -0.9))
    moved = PartSolid(b.shape, b.size, b.mass, at @ b.pose)
    found = combined([(inertia([a]), Transform()), (inertia([b]), at)])
    expected = inertia([a, moved])
    assert found.mass == expected.mass
    assert found.center == pytest.approx(expected.center)
    for row, other in zip(found.moments, expected.moments, strict=True):
        assert row == pytest.approx(other)


def test_nothing() -> None:
    assert inertia([]).mass == 0.0
