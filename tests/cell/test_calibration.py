"""Accuracy and repeatability by ISO 9283, and kinematic calibration."""

import math

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("scipy", reason="the extra 'cell' is not installed")
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

import pinocchio as pin
from tests.helpers.servo_plant import ServoPlant, many

from jauspy.cell.calibration import ArmGeometry, Parameters
from jauspy.cell.frames import shifted, turned
from jauspy.cell.iso9283 import Arrival, LaserTracker, accuracy, arrival, cube_points

THREE = (*many(1), ("tube_1", "tube"), ("servo_2", "shoulder"), ("tube_2", "tube"), ("servo_3", "elbow"))


@pytest.fixture
def plant() -> ServoPlant:
    return ServoPlant(THREE)


@pytest.fixture
def geometry(plant: ServoPlant) -> ArmGeometry:
    return ArmGeometry(plant.cell, plant.chain, pin.SE3.Identity())


class TestAccuracy:
    def test_of_exact_poses_is_zero(self) -> None:
        found = accuracy(shifted(1.0), [shifted(1.0)] * 5)
        assert (found.accuracy, found.repeatability) == pytest.approx((0.0, 0.0), abs=1e-12)
        assert (found.angle_accuracy, found.angle_repeatability) == pytest.approx((0.0, 0.0), abs=1e-12)

    def test_accuracy_is_that_of_the_mean(self) -> None:
        found = accuracy(shifted(), [shifted(0.001), shifted(0.003)])
        assert found.accuracy == pytest.approx(0.002)
        assert found.repeatability == pytest.approx(0.001)  # both are as far from their mean

    def test_repeatability_is_the_mean_distance_and_three_deviations(self) -> None:
        found = accuracy(shifted(), [shifted(x) for x in (0.0, 0.0, 0.0, 0.004)])
        distances = (0.001, 0.001, 0.001, 0.003)
        assert found.repeatability == pytest.approx(0.0015 + 3.0 * float(np.std(distances, ddof=1)))

    def test_angles(self) -> None:
        found = accuracy(turned("z", 0.0), [turned("z", 0.01), turned("z", 0.03)])
        assert found.angle_accuracy == pytest.approx(0.02)
        assert found.angle_repeatability == pytest.approx(3.0 * float(np.std((0.01, 0.03), ddof=1)))

    def test_the_points_lie_in_a_plane_of_the_cube(self) -> None:
        points = np.array(cube_points((1.0, 2.0, 3.0), 0.4))
        assert np.linalg.matrix_rank(points - points[0], tol=1e-9) == 2
        assert points[1:].mean(axis=0) == pytest.approx(points[0])
        diagonal = 0.4 * math.sqrt(3.0)
        assert np.linalg.norm(points[1] - points[3]) == pytest.approx(0.8 * diagonal)

    def test_what_stays_in_the_band_is_stable_at_once(self) -> None:
        assert arrival([0.0, 0.1, 0.2], [0.5, 0.01, 0.02], 0.05) == Arrival(0.0, 0.0)

    def test_an_overshoot_counts_from_the_first_time_in_the_band_until_the_last_outside(self) -> None:
        times = [0.1 * number for number in range(7)]
        found = arrival(times, [0.5, 0.04, 0.09, 0.03, 0.06, 0.02, 0.01], 0.05)
        assert found.stabilisation == pytest.approx(0.4)  # in the band at 0.1 s, and for good at 0.5 s
        assert found.overshoot == 0.09

    def test_a_tool_that_never_comes_into_the_band_has_no_time(self) -> None:
        assert arrival([0.0, 0.1], [0.5, 0.4], 0.05) == Arrival(0.0, 0.0)

    def test_the_tracker_has_noise(self) -> None:
        tracker = LaserTracker(np.random.default_rng(1))
        found = [tracker.measure(shifted(1.0)).translation[0] for _ in range(400)]
        assert float(np.std(found)) == pytest.approx(15e-6, rel=0.15)


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
