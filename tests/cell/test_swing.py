"""The figures of a swing, and the swing itself in the simulated cell."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from jauspy.cell.swing import AT_REST, Swing, SwingComparison, compare, joint_errors, plot_swing
from jauspy.platform.modular.arm import ArmController


def decaying(controller: ArmController, rate: float, size: float) -> Swing:
    times = np.arange(0.0, 6.0, 0.01)
    speeds = size * np.exp(-rate * times)
    return Swing(controller, times, np.stack([speeds, 0.0 * times, 0.0 * times], axis=1), end=0.5, payload=0.3)


def test_figures_of_a_swing() -> None:
    swing = decaying(ArmController.PID, 2.0, 1.0)
    assert swing.settled == pytest.approx(np.log(1.0 / AT_REST) / 2.0, abs=0.011)
    assert swing.settled_after_end == pytest.approx(swing.settled - 0.5)
    assert swing.overshoot == pytest.approx(np.exp(-1.0), rel=0.02)
    assert swing.came_to_rest


def test_an_arm_that_does_not_come_to_rest() -> None:
    swing = decaying(ArmController.PID, 0.0, 1.0)
    assert not swing.came_to_rest
    assert swing.settled == pytest.approx(swing.times[-1])


def test_comparison_says_what_is_missing() -> None:
    good = SwingComparison(decaying(ArmController.PID, 1.0, 1.0), decaying(ArmController.MODEL, 8.0, 1.0))
    assert good.measured(1).success
    bad = SwingComparison(decaying(ArmController.PID, 1.0, 1.0), decaying(ArmController.MODEL, 2.0, 1.0))
    assert not bad.measured(1).success
    assert bad.measured(1).failure.startswith("at rest 2.0 times sooner, overshoot 0.61")


@pytest.mark.slow
def test_plot(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib", reason="the extra 'plot' is not installed")
    path = tmp_path / "swing.svg"
    plot_swing(SwingComparison(decaying(ArmController.PID, 1.0, 1.0), decaying(ArmController.MODEL, 8.0, 1.0)), path)
    assert path.stat().st_size > 10_000


def test_errors_of_the_joints_are_those_of_the_seed() -> None:
    assert joint_errors(1) == joint_errors(1)
    assert joint_errors(1) != joint_errors(2)


@pytest.mark.slow
@pytest.mark.timeout(900)
async def test_the_model_settles_five_times_sooner() -> None:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    found = (await compare(7)).measured(7)
    assert found.success, found.failure
    assert found.values["payload"] == pytest.approx(0.3, rel=0.03)
