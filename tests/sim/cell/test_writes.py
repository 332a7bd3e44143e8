"""Positions that are written into a simulated cell, and those that physics change."""

from __future__ import annotations

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import ARM, build_arm, open_cell, small_cell

from jauspy.geometry.poses import Pose
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.arm import ModularArm
from jauspy.platform.modular.cell import Conveyor


@pytest.mark.slow
def test_what_moves_by_itself_was_not_written() -> None:
    """The UR10, the belt with a box that it carries, and the bodies that come to rest."""
    cell = open_cell(pose_error=(0.01, 0.09), seed=4)
    conveyor = Conveyor.of(cell)
    assert conveyor is not None
    conveyor.set_speed(0.2)
    cell.groups["ur10"].command([Target(ControlMode.POSITION, 0.5), *[None] * 5])
    before = cell.truth.pose("box_3")
    for _ in range(10):
        cell.advance(0.05)
    assert cell.truth.pose("box_3").y > before.y + 0.03
    assert cell.truth.written == ()


@pytest.mark.slow
def test_parts_that_are_put_in_place_are_named_in_order() -> None:
    cell = small_cell([*ARM, "platform_1"])
    build_arm(cell, ARM[:3])
    assert cell.truth.written == ARM[:3]
    arm = ModularArm.of(cell)
    assert arm is not None
    arm.move([0.3, 0.2], 0.5)
    cell.advance(0.6)
    assert cell.truth.written == ARM[:3], "the arm moves by its servo modules"
    cell.place("tube_1", Pose(0.2, 0.9, 0.1))
    assert cell.truth.written == (*ARM[:3], "tube_1")


@pytest.mark.parametrize("steps", [0, 5])
def test_one_write_between_two_steps_is_caught(steps: int) -> None:
    """Also one of a millimetre, and before the next step."""
    cell = small_cell(["platform_1", "box_1", "servo_1"])
    cell.advance(0.1)
    cell.data.qpos[int(cell.model.joint("box_1").qposadr[0])] += 0.001
    cell.advance(0.002 * steps)
    assert cell.truth.written == ("box_1",)


def test_a_joint_of_the_robot_that_is_written_is_caught() -> None:
    cell = small_cell(["platform_1"])
    cell.data.qpos[0] += 1e-6
    cell.advance(0.01)
    (name,) = cell.truth.written
    assert "link" in name
