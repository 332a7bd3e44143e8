"""Mass and centre of mass of what a robot holds, from efforts of its joints."""

from __future__ import annotations

import numpy as np
import pytest

from jauspy.platform.payload import Payload, PayloadIdentifier

MASS, CENTER = 2.0, (0.1, -0.05, 0.2)
NOISE = 0.3


def identified(*, measurements: int, error: float = 0.0, seed: int = 0) -> Payload:
    """What is found from random rows of three joints with noise, and with an `error` (N m) that the model has."""
    random = np.random.default_rng(seed)
    identifier, found = PayloadIdentifier(), Payload()
    true = np.array([MASS, *(MASS * value for value in CENTER)])
    for _ in range(measurements):
        rows = random.normal(0.0, 8.0, (3, 4))
        wrong = error * random.choice((-1.0, 1.0), 3)
        efforts = rows @ true + random.normal(0.0, NOISE, 3) + wrong
        found = identifier.add(rows, efforts, np.full(3, NOISE), 0.01)
    return found


def test_mass_and_centre_are_found() -> None:
    found = identified(measurements=50)
    assert found.mass == pytest.approx(MASS, abs=0.02)
    assert found.center == pytest.approx(CENTER, abs=0.02)


def test_errors_of_the_mass_agree_with_its_deviation() -> None:
    found = [identified(measurements=20, seed=seed) for seed in range(60)]
    errors = np.array([(payload.mass - MASS) / payload.mass_deviation for payload in found])
    assert 0.7 < float(np.sqrt(np.mean(errors**2))) < 1.4


def test_a_model_that_does_not_fit_is_less_certain() -> None:
    assert identified(measurements=30, error=2.0).mass_deviation > 3.0 * identified(measurements=30).mass_deviation


def test_of_one_measurement_little_is_known() -> None:
    identifier = PayloadIdentifier()
    found = identifier.add(np.array([[8.0, 0.0, 0.0, 9.81]]), np.array([16.0]), np.array([NOISE]), 0.01)
    assert found.mass_deviation > 0.25
    assert all(abs(value) <= 1.0 for value in found.center)


def test_no_load_is_none() -> None:
    identifier, random = PayloadIdentifier(), np.random.default_rng(0)
    for _ in range(50):
        rows = random.normal(0.0, 8.0, (3, 4))
        found = identifier.add(rows, random.normal(0.0, NOISE, 3), np.full(3, NOISE), 0.01)
    assert found.mass == 0.0
    assert found.mass_deviation < 0.05


def test_old_measurements_are_forgotten() -> None:
    identifier, random = PayloadIdentifier(), np.random.default_rng(0)
    for mass in (1.0, 3.0):
        for _ in range(500):
            rows = random.normal(0.0, 8.0, (3, 4))
            found = identifier.add(rows, rows @ np.array([mass, 0.0, 0.0, 0.0]), np.full(3, NOISE), 0.01)
    assert found.mass == pytest.approx(3.0, abs=0.05)


def test_a_centre_that_motions_hardly_show_stays_near_the_tool() -> None:
    """An error of 0.3 N m on the second joint, which only a moment of 6 kg m would explain."""
    identifier, rows = PayloadIdentifier(), np.array([[8.0, 0.0, 0.0, 0.0], [0.0, 0.05, 0.0, 0.0]])
    for _ in range(200):
        found = identifier.add(rows, rows @ np.array([0.57, 0.0, 0.0, 0.0]) + [0.0, 0.3], np.array([0.5, 0.5]), 0.01)
    assert found.mass == pytest.approx(0.57, abs=0.05)
    assert np.linalg.norm(found.center) < 0.15
