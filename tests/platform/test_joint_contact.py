"""The observer of external efforts: what it finds on joints that are simulated here, and what counts as contact."""

import numpy as np
import pytest

pytest.importorskip("numpy")

from jauspy.platform.joint_contact import GAIN, SUSPICION, THRESHOLD_SHARE, UNCERTAIN, JointContactObserver

INERTIA = np.array([[4.0, 0.5], [0.5, 1.0]])
MOST = (100.0, 50.0)
DT = 0.002


def observed(external: np.ndarray, time: float, *, accelerations: np.ndarray | None = None) -> JointContactObserver:
    """Joints that controllers push back with a spring and a damper from where an external effort moves them."""
    observer = JointContactObserver(MOST)
    wanted = np.zeros(2) if accelerations is None else accelerations
    off, slip = np.zeros(2), np.zeros(2)
    for _ in range(round(time / DT)):
        beyond = -2000.0 * off - 60.0 * slip
        change = np.linalg.solve(INERTIA, beyond + external) * DT
        slip = slip + change
        off = off + slip * DT
        observer.update(INERTIA, change + wanted * DT, wanted, beyond, DT)
    return observer


def test_it_follows_an_external_effort_with_its_time_constant() -> None:
    external = np.array([8.0, -3.0])
    assert observed(external, 1.0 / GAIN).external == pytest.approx(external * (1.0 - np.exp(-1.0)), rel=0.06)
    assert observed(external, 0.2).external == pytest.approx(external, rel=0.01)


def test_accelerations_of_the_setpoints_are_no_external_efforts() -> None:
    assert observed(np.zeros(2), 0.2, accelerations=np.array([3.0, -5.0])).external == pytest.approx([0.0, 0.0])


def test_contact_begins_at_the_threshold_and_is_suspected_before() -> None:
    first, second = (THRESHOLD_SHARE * most for most in MOST)
    below, above = observed(np.array([0.9 * first, 0.0]), 0.2), observed(np.array([-1.1 * first, 1.3 * second]), 0.2)
    assert list(below.touched(certain=True)) == []
    assert below.suspects(certain=True)
    assert not observed(np.array([0.9 * SUSPICION * first, 0.0]), 0.2).suspects(certain=True)
    assert list(above.touched(certain=True)) == [1, 0], "the one furthest beyond its threshold first"


def test_the_weight_of_an_unknown_load_is_no_contact() -> None:
    first = THRESHOLD_SHARE * MOST[0]
    heavy = observed(np.array([0.9 * UNCERTAIN * first, 0.0]), 0.2)
    assert list(heavy.touched(certain=True)) == [0]
    assert list(heavy.touched(certain=False)) == []
    assert list(observed(np.array([1.1 * UNCERTAIN * first, 0.0]), 0.2).touched(certain=False)) == [0]
