"""What joints add to the tool's velocity, against small differences of its pose."""

import math
import random

import pytest
from tests.geometry.test_denavit_hartenberg import random_chain

from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.kinematics import forward_kinematics
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import X, Y, Z, difference, rotation_about

SMALL = 1e-6


@pytest.mark.parametrize("seed", range(60))
def test_velocities_are_differences_of_poses(seed: int) -> None:
    rng = random.Random(seed)
    found = manipulator_geometry(random_chain(rng))
    positions, rates = ([rng.uniform(-2.0, 2.0) for _ in found.links] for _ in range(2))
    before = forward_kinematics(found.links, positions, found.tool)
    later = [position + SMALL * rate for position, rate in zip(positions, rates, strict=True)]
    after = forward_kinematics(found.links, later, found.tool)
    turning, moving = before.velocity(rates)
    turned = rotation_vector(before.tool.rotation, after.tool.rotation)
    assert [part / SMALL for part in turned] == pytest.approx(turning, abs=1e-4)
    moved = difference(after.tool.position, before.tool.position)
    assert [part / SMALL for part in moved] == pytest.approx(moving, abs=1e-4)
    last = (found.base.inverse() @ found.forward(positions)).apply(found.tool)
    assert before.tool.position == pytest.approx(last, abs=1e-9)


@pytest.mark.parametrize("axis", [X, Y, Z, (0.6, 0.0, -0.8)])
@pytest.mark.parametrize("angle", [0.0, 1e-7, 0.5, 3.0, math.pi])
def test_a_rotation_vector_leads_from_one_attitude_to_the_other(axis, angle: float) -> None:
    start = rotation_about((0.0, 0.8, 0.6), 1.1)
    end = (Transform(rotation_about(axis, angle)) @ Transform(start)).rotation
    turn = rotation_vector(start, end)
    assert math.hypot(*turn) == pytest.approx(angle, abs=1e-9)
    assert turn == pytest.approx([angle * part for part in axis], abs=1e-7) or angle == math.pi
