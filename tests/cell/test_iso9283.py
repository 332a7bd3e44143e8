"""Characteristics of ISO 9283 from measured poses, and the measurement in the simulated cell."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("scipy", reason="the extra 'cell-measurements' is not installed")
pytest.importorskip("coal", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

import pinocchio as pin

from jauspy.cell.frames import shifted, turned
from jauspy.cell.iso9283 import loads
from jauspy.cell.iso9283.bench import Plan, UR10Bench
from jauspy.cell.iso9283.characteristics import (
    Accuracy,
    Arrival,
    Drift,
    DriftPoint,
    LaserTracker,
    PathAccuracy,
    Sample,
    accuracy,
    arrival,
    cube_points,
    line,
    path_accuracy,
)
from jauspy.cell.judge import Judge
from jauspy.cell.session import UNDISTURBED, simulated
from jauspy.errors import ConfigError
from jauspy.geometry.urdf import inertials
from jauspy.platform.description import RobotModel


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
        assert found.angles == pytest.approx((0.0, 0.0, 0.02), abs=1e-12)
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


START, END, THERE = shifted(0.1, 0.2, 0.3), shifted(0.4, 0.2, 0.3), shifted()


def passage(off: pin.SE3 = THERE, *, speed: float = 0.5, step: float = 0.004) -> list[Sample]:
    """A passage of the line from START to END and beyond, shifted by `off`, at an even speed."""
    times = np.arange(-0.1, 0.3 / speed + 0.1, step).tolist()
    return [Sample(time, off * shifted(0.1 + speed * time, 0.2, 0.3)) for time in times]


class TestPath:
    def test_an_exact_path_has_no_error(self) -> None:
        found = path_accuracy(line(START, END), [passage()] * 3)
        assert found.worst.accuracy == pytest.approx(0.0, abs=1e-12)
        assert found.worst.repeatability == pytest.approx(0.0, abs=1e-12)
        assert found.speed == pytest.approx(0.5)
        assert found.cycles == 3

    @pytest.mark.parametrize("off", [shifted(0.0, 0.001, 0.0), shifted(0.0, 0.0, -0.001)])
    def test_a_path_that_is_shifted_by_a_millimetre_has_that_accuracy(self, off: pin.SE3) -> None:
        found = path_accuracy(line(START, END), [passage(off)] * 3)
        assert found.worst.accuracy == pytest.approx(0.001)
        assert found.worst.repeatability == pytest.approx(0.0, abs=1e-12)
        assert np.allclose(np.linalg.norm(found.deviations, axis=1), 0.001)

    def test_a_shift_along_the_path_is_no_error(self) -> None:
        found = path_accuracy(line(START, END), [passage(shifted(0.001))] * 2)
        assert found.worst.accuracy == pytest.approx(0.0, abs=1e-12)

    def test_the_worst_plane_counts(self) -> None:
        bumped = [
            Sample(time, shifted(0.0, 0.002 * math.exp(-(((pose.translation[0] - 0.25) / 0.02) ** 2)), 0.0) * pose)
            for time, pose in passage()
        ]
        assert path_accuracy(line(START, END), [bumped]).worst.accuracy == pytest.approx(0.002, rel=0.03)

    def test_the_accuracy_is_that_of_the_mean_path_and_the_repeatability_that_about_it(self) -> None:
        offs = (0.0, 0.0, 0.0, 0.004)
        found = path_accuracy(line(START, END), [passage(shifted(0.0, off)) for off in offs])
        assert found.worst.accuracy == pytest.approx(0.001)
        distances = (0.001, 0.001, 0.001, 0.003)
        assert found.worst.repeatability == pytest.approx(0.0015 + 3.0 * float(np.std(distances, ddof=1)))

    def test_angles_count_about_each_axis(self) -> None:
        leaning = [Sample(time, pose * turned("y", 0.01)) for time, pose in passage()]
        found = path_accuracy(line(START, END), [leaning])
        assert found.worst.angles == pytest.approx((0.0, 0.01, 0.0), abs=1e-9)

    def test_commanded_poses_turn_evenly(self) -> None:
        poses = line(START, END * turned("z", 0.2))
        angles = [pin.log3(pose.rotation)[2] for pose in poses]
        assert np.allclose(np.diff(angles), angles[1] - angles[0])
        assert angles[-1] == pytest.approx(0.95 * 0.2)

    def test_a_passage_that_ends_early_is_an_error(self) -> None:
        with pytest.raises(ValueError, match="does not cross the plane"):
            path_accuracy(line(START, END), [passage()[:60]])


class TestDrift:
    def test_is_the_largest_change_since_the_first_measurement(self) -> None:
        rows = [(0.0, 0.001, 0.0002), (60.0, 0.0004, 0.0002), (120.0, 0.0012, 0.0005)]
        found = Drift(tuple(DriftPoint(time, Accuracy(ap, rp)) for time, ap, rp in rows))
        assert found.accuracy == pytest.approx(0.0006)
        assert found.repeatability == pytest.approx(0.0003)
        assert found.duration == 120.0


class TestLoads:
    def test_a_bolted_load_is_part_of_the_robot(self, model: RobotModel) -> None:
        found = {row.link: row.mass for row in inertials(loads.with_bolted_load(model, 10.0).description.urdf)}
        assert found[loads.LOAD] == pytest.approx(10.0 - found["gripper"]), "the gripper is part of the load"
        assert found["gripper"] == loads.GRIPPER_MASS

    def test_less_than_the_gripper_is_refused(self, model: RobotModel) -> None:
        with pytest.raises(ConfigError, match=r"includes its gripper of 0\.6 kg"):
            loads.with_bolted_load(model, 0.5)


QUICK = Plan(cycles=2, path_cycles=2, speeds=(0.5,))


def measured(load: float = 0.0) -> PathAccuracy:
    """The UR10's path in the simulated cell; poses are checked on the way."""

    async def run() -> PathAccuracy:
        change = partial(loads.with_bolted_load, mass=load) if load else lambda model: model
        async with simulated(0, UNDISTURBED, change=change) as session:
            bench = UR10Bench(session, LaserTracker(np.random.default_rng(0)), load)
            (found,) = await bench.runs("UR10", QUICK)
            assert found.worst.repeatability < 0.001
            assert found.load == load
            assert found.path is not None
            return found.path

    return asyncio.run(run())


@contextmanager
def seen_elsewhere(off: pin.SE3, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The tool is seen beside its place."""
    true = Judge.connector
    with monkeypatch.context() as patch:
        patch.setattr(Judge, "connector", lambda judge, name: off * true(judge, name))
        yield


@pytest.mark.slow
def test_the_ur10_keeps_its_line_and_a_tool_beside_it_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    found = measured()
    assert found.worst.accuracy < 0.003
    assert found.speed == pytest.approx(0.5, rel=0.1)
    mean = found.deviations[int(np.argmax(np.linalg.norm(found.deviations, axis=1)))]
    with seen_elsewhere(pin.SE3(np.eye(3), 0.001 * mean / np.linalg.norm(mean)), monkeypatch):
        beside = measured()
    assert beside.worst.accuracy == pytest.approx(found.worst.accuracy + 0.001, abs=1e-4)


@pytest.mark.slow
def test_the_ur10_carries_its_rated_load() -> None:
    assert measured(loads.UR10_RATED).worst.accuracy < 0.005
