"""Kinematic calibration."""

import math

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("scipy", reason="the extra 'cell' is not installed")
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

import pinocchio as pin
from tests.helpers.servo_plant import ServoPlant, many

from jauspy.cell.calibration import ArmGeometry, Parameters
from jauspy.cell.frames import shifted
from jauspy.cell.iso9283.characteristics import LaserTracker

THREE = (*many(1), ("tube_1", "tube"), ("servo_2", "shoulder"), ("tube_2", "tube"), ("servo_3", "elbow"))


@pytest.fixture
def plant() -> ServoPlant:
    return ServoPlant(THREE)


@pytest.fixture
def geometry(plant: ServoPlant) -> ArmGeometry:
    return ArmGeometry(plant.cell, plant.chain, pin.SE3.Identity())


class TestCalibration:
    def test_without_errors_it_is_the_model_of_the_controller(self, plant: ServoPlant, geometry: ArmGeometry) -> None:
        q = np.array([0.3, -0.4, 0.7])
        assert geometry.tip(q, geometry.nominal).translation == pytest.approx(plant.model.tip_pose(q).position)

    def test_finds_a_turned_module_and_the_errors_of_others(self, geometry: ArmGeometry) -> None:
        random = np.random.default_rng(1)
        count = len(geometry.nominal.quarters)
        quarters = np.zeros(count)
        quarters[3] = math.pi / 2.0
        errors = np.hstack([random.uniform(-0.002, 0.002, (count, 3)), random.uniform(-0.026, 0.026, (count, 3))])
        true = Parameters(np.array([0.01, -0.02, 0.015]), errors, quarters, 0.0004)
        tracker = LaserTracker(random)
        positions = [random.uniform(-1.2, 1.2, 3) for _ in range(16)]
        found = geometry.calibrate(positions, [tracker.measure(geometry.tip(q, true)) for q in positions])
        fresh = [random.uniform(-1.2, 1.2, 3) for _ in range(20)]

        def worst(parameters: Parameters) -> float:
            return max(
                float(np.linalg.norm(geometry.tip(q, parameters).translation - geometry.tip(q, true).translation))
                for q in fresh
            )

        assert worst(found) < 1e-4
        assert worst(Parameters(true.offsets * 0.0, errors * 0.0, quarters)) > 5.0 * worst(found)

    def test_solves_for_the_place(self, geometry: ArmGeometry) -> None:
        start = np.array([0.2, 0.6, 0.8])
        goal = shifted(0.02, -0.01, 0.01) * geometry.tip(start, geometry.nominal)
        q = geometry.solve(goal, start, geometry.nominal)
        assert geometry.tip(q, geometry.nominal).translation == pytest.approx(goal.translation, abs=1e-6)
