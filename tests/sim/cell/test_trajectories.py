"""Trajectories of the modular arm through points with times, in MuJoCo; true positions and velocities of its joints."""

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.cells import ARM, build_arm, small_cell

from jauspy.platform.modular.arm import ModularArm, MotionResult, TrajectoryPoint
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.robot import SimulatedCell

interpolate = pytest.importorskip("scipy.interpolate", reason="splines are compared with those of SciPy")

POINTS = (
    (0.7, (0.3, 0.4, 0.5, 0.3, 0.5)),
    (1.3, (0.8, 0.7, 0.2, 0.5, 1.0)),
    (2.0, (1.2, 0.3, 0.6, 0.1, 0.4)),
    (3.0, (0.6, 0.2, 0.3, 0.2, 0.0)),
)
LATE = 0.02
"""Seconds by which averaged setpoints are late."""


@pytest.fixture
def cell() -> SimulatedCell:
    cell = small_cell([*ARM, "platform_1"])
    build_arm(cell)
    cell.advance(1.0)
    return cell


def arm_of(cell: SimulatedCell) -> ModularArm:
    arm = ModularArm.of(cell)
    assert arm is not None
    return arm


@pytest.mark.slow
def test_joints_follow_a_spline_and_do_not_stop_at_its_points(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    names, start = arm.state().joints, arm.state().targets
    arm.follow(names, [TrajectoryPoint(time, positions) for time, positions in POINTS])
    times = np.arange(1, 1601) * TIMESTEP
    positions, velocities = [], []
    for _ in times:
        cell.advance(TIMESTEP)
        positions.append([cell.servos[name].true_position for name in names])
        velocities.append([cell.servos[name].true_velocity for name in names])
    assert (arm.state().result, arm.state().error) == (MotionResult.REACHED, "")
    knots = [0.0, *(time for time, _ in POINTS)]
    spline = interpolate.CubicSpline(knots, [start, *(at for _, at in POINTS)], bc_type="clamped")
    expected = np.clip(times - LATE, 0.0, knots[-1])
    assert np.abs(np.array(positions) - spline(expected)).max() < 0.007
    assert np.abs(np.array(velocities) - spline(expected, 1)).max() < 0.12
    assert np.abs(np.diff(velocities, axis=0)).max() < 0.02, "rad/s within 2 ms, where a stop would be a jump"
    at_points = np.array([velocities[round((time + LATE) / TIMESTEP) - 1] for time, _ in POINTS[:-1]])
    assert np.abs(at_points).max(axis=1).min() > 0.5


@pytest.mark.slow
def test_a_motion_that_is_too_fast_is_refused_before_it_begins(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    names, before = arm.state().joints, arm.state().positions
    arm.follow(names, [TrajectoryPoint(0.3, (0.0, 0.9, 0.0, 0.0, 0.0)), TrajectoryPoint(0.9, (0.0,) * 5)])
    error = arm.state().error
    assert arm.state().result is MotionResult.REFUSED
    assert "servo_2 " in error
    assert " s; its limit is " in error
    cell.advance(0.2)
    assert arm.state().positions == pytest.approx(before, abs=1e-3)


@pytest.mark.slow
def test_a_trajectory_takes_over_from_a_motion_without_a_jump(cell: SimulatedCell) -> None:
    arm = arm_of(cell)
    names = arm.state().joints
    arm.move((1.2, 0.5, 0.4, 0.3, 0.3), 1.5)
    cell.advance(0.7)
    before = np.array([cell.servos[name].true_velocity for name in names])
    assert np.abs(before).max() > 0.5
    arm.follow(("servo_1",), [TrajectoryPoint(0.8, (1.0,), (0.1,)), TrajectoryPoint(1.6, (0.9,))])
    largest = 0.0
    for _ in range(200):
        cell.advance(TIMESTEP)
        now = np.array([cell.servos[name].true_velocity for name in names])
        largest, before = max(largest, float(np.abs(now - before).max())), now
    assert largest < 0.05
    cell.advance(2.0)
    assert arm.state().result is MotionResult.REACHED
    assert arm.state().positions == pytest.approx((0.9, 0.5, 0.4, 0.3, 0.3), abs=6e-3)
