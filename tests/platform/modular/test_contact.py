"""The observed momentum of an arm: external torques, and which of them count as contact."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from jauspy.platform.modular.contact import GAIN, PAYLOAD_TIME, SEEKING, THRESHOLD_SHARE, ContactObserver
from jauspy.platform.modular.control_laws import JointMeasurements

PERIOD = 0.002
INERTIA, GRAVITY = 0.5, 2.0
MAX = np.array([10.0, 20.0])
THRESHOLD = THRESHOLD_SHARE * MAX


def observer(*, has_load: bool = False, on_wheels: bool = False) -> ContactObserver:
    """Two joints of equal inertia, each with a constant torque of gravity."""
    model: Any = SimpleNamespace(has_load=has_load, momentum=lambda _, v: (INERTIA * v, np.full(2, -GRAVITY)))
    return ContactObserver(model, MAX, on_wheels=on_wheels)


def push(observed: ContactObserver, external: np.ndarray, seconds: float, spring: float = 3.0) -> None:
    """Have springs and an external torque move the joints."""
    v = np.zeros(2)
    for _ in range(round(seconds / PERIOD)):
        v = v + PERIOD * (spring - GRAVITY + external) / INERTIA
        observed.update(JointMeasurements(np.zeros(2), v, np.full(2, spring), np.zeros(2)), PERIOD)


def touched(observed: ContactObserver, *, seeks: bool = False) -> list[int]:
    return list(observed.touched(seeks=lambda: seeks))


def test_what_the_springs_do_is_not_external() -> None:
    observed = observer()
    push(observed, np.zeros(2), 0.3)
    assert observed.external == pytest.approx([0.0, 0.0], abs=0.15)
    assert not touched(observed)


def test_external_torques_are_found_with_the_time_constant_of_the_gain() -> None:
    observed, external = observer(), np.array([1.0, -6.0])
    push(observed, np.zeros(2), 0.1, spring=GRAVITY)
    push(observed, external, 1.0 / GAIN, spring=GRAVITY)
    assert observed.external == pytest.approx(external * (1.0 - np.exp(-1.0)), rel=0.15)
    push(observed, external, 0.2, spring=GRAVITY)
    assert observed.external == pytest.approx(external, rel=0.02)
    assert touched(observed) == [1], "the first one has less than its threshold"
    observed.restart()
    assert not touched(observed)


def test_the_joint_furthest_beyond_its_threshold_is_first() -> None:
    observed = observer()
    push(observed, THRESHOLD * [2.0, 1.5], 0.3, spring=GRAVITY)
    assert touched(observed) == [0, 1]


def test_an_arm_that_is_to_touch_something_may_press_harder() -> None:
    observed = observer()
    push(observed, THRESHOLD * [0.0, 0.8 * SEEKING], 0.3, spring=GRAVITY)
    assert touched(observed) == [1]
    assert not touched(observed, seeks=True)
    push(observed, THRESHOLD * [0.0, 1.3 * SEEKING], 0.3, spring=GRAVITY)
    assert touched(observed, seeks=True) == [1]


def test_accelerations_of_a_base_that_moves_are_no_contact() -> None:
    observed = observer(on_wheels=True)
    push(observed, THRESHOLD * [0.0, 2.0], 0.3, spring=GRAVITY)
    assert not touched(observed)


def test_a_box_of_unknown_mass_is_no_contact() -> None:
    observed = observer(has_load=True)
    push(observed, THRESHOLD * [0.0, 2.0], PAYLOAD_TIME - 0.1, spring=GRAVITY)
    assert not touched(observed)
    assert not observed.suspects, "or its mass would never be estimated"
    push(observed, THRESHOLD * [0.0, 2.0], 0.2, spring=GRAVITY)
    assert touched(observed) == [1]
    assert observed.suspects
