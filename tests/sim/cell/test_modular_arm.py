"""The modular arm's controller in MuJoCo: it is the physics of the cell that is not its own model."""

import math

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.cells import ARM, build_arm, put_on, small_cell

from jauspy.geometry.poses import Transform
from jauspy.platform.modular.arm import ModularArm
from jauspy_sim.cell.robot import SimulatedCell

TARGET = (0.4, 0.8, 0.6, 0.4, 0.3)
NAN = math.nan


@pytest.fixture
def cell() -> SimulatedCell:
    """A cell with the arm of five joints on its platform."""
    cell = small_cell([*ARM, "platform_1", "box_1"])
    build_arm(cell)
    return cell


def arm_of(cell: SimulatedCell) -> ModularArm:
    arm = ModularArm.of(cell)
    assert arm is not None
    return arm


@pytest.mark.slow
def test_moves_and_knows_where_its_tip_is(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    arm.move(TARGET, 0.0)
    cell.advance(3.0)
    state = arm.state()
    assert state.error == ""
    assert state.positions == pytest.approx(TARGET, abs=5e-3)
    true = cell.truth.connector("servo_5/output")
    off = np.subtract(Transform.from_pose(state.tip_pose).position, true.position)
    assert float(np.linalg.norm(off)) < 4e-3


@pytest.mark.slow
def test_estimates_a_box_and_lets_it_go_without_a_jump(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    arm.move(TARGET, 0.0)
    cell.advance(2.5)
    put_on(cell, "servo_5/output", "box_1")
    cell.advance(2.0)
    assert cell.connectors["servo_5/output"].state().attached_to == "box_1"
    assert arm.state().payload == pytest.approx(0.3, rel=0.03, abs=0.02)
    efforts = np.array(arm.state().efforts)
    cell.connectors["servo_5/output"].set(False)
    cell.advance(0.004)
    changes = np.abs(np.array(arm.state().efforts) - efforts)
    assert float(changes.max()) < 1.0
    cell.advance(1.0)
    assert arm.state().payload == 0.0
    assert arm.state().positions == pytest.approx(TARGET, abs=0.01)


@pytest.mark.slow
def test_hold_stops_within_200_ms_and_all_stay_attached(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    arm.move((1.4, 0.9, 0.8, 0.9, 1.5), 0.0)
    cell.advance(0.5)
    assert max(map(abs, arm.state().velocities)) > 0.5
    arm.hold()
    cell.advance(0.2)
    assert max(map(abs, arm.state().velocities)) < 0.1
    cell.advance(0.5)
    assert not arm.state().moving
    assert len(arm.state().joints) == 5


@pytest.mark.slow
def test_a_module_without_power_stops_the_others(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    arm.move((1.4, NAN, NAN, NAN, 3.0), 0.0)
    cell.advance(0.4)
    cell._power.switch("servo_5", False)
    cell.advance(0.5)
    assert arm.state().error == "the motion ended early: no report of servo_5"
    assert abs(arm.state().velocities[0]) < 0.02
