"""Measurements of servo modules against the simulation's true state."""

from __future__ import annotations

from dataclasses import replace
from statistics import fmean, pstdev

import pytest

pytest.importorskip("mujoco")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.cells import cell_model, put_on, small_cell

from jauspy.platform.modular.parts import EXACT, ServoSensors
from jauspy_sim.cell.robot import SimulatedCell

DATA = ServoSensors()
SAMPLES = 300


def upright(seed: int = 0, sensors: ServoSensors = DATA) -> SimulatedCell:
    """One inline servo module on a platform, at rest."""
    types = dict(cell_model().cell.types)  # type: ignore[union-attr]
    kind = types["x5_4_inline"]
    assert kind.servo is not None
    types["x5_4_inline"] = replace(kind, servo=replace(kind.servo, sensors=sensors))
    cell = small_cell(["platform_1", "servo_5"], arm="", seed=seed, types=types)
    put_on(cell, "platform_1/top", "servo_5")
    cell.advance(0.5)
    return cell


def errors(cell: SimulatedCell) -> tuple[list[float], list[float], list[float], list[float]]:
    """Errors of position, velocity and torque, and the angular velocity about x by the IMU."""
    rows = []
    for _ in range(SAMPLES):
        cell.servos["servo_5"].sample()
        state, (position, velocity, torque) = cell.servos["servo_5"].state(), cell.truth.servo("servo_5")
        rows.append(
            (state.position - position, state.velocity - velocity, state.torque - torque, state.angular_velocity[0])
        )
    found = list(zip(*rows, strict=True))
    return list(found[0]), list(found[1]), list(found[2]), list(found[3])


@pytest.mark.parametrize("seed", [1, 2])
def test_measurements_differ_from_the_truth_by_what_is_stated(seed: int) -> None:
    cell = upright(seed)
    setup = cell.setup.types["x5_4_inline"].servo
    assert setup is not None
    position, velocity, torque, rate = errors(cell)
    spread = (DATA.encoder_noise**2 + DATA.encoder_step**2 / 12.0) ** 0.5
    assert (fmean(error**2 for error in position)) ** 0.5 == pytest.approx(spread, rel=0.25)
    assert pstdev(torque) == pytest.approx(DATA.torque_noise(setup.stiffness), rel=0.25)
    assert 0.0005 < pstdev(velocity) < 0.02
    assert pstdev(rate) == pytest.approx(DATA.imu_noise(DATA.gyro_density), rel=0.2)


def test_positions_are_whole_counts() -> None:
    cell = upright()
    counts = cell.servos["servo_5"].state().position / DATA.encoder_step
    assert counts == pytest.approx(round(counts), abs=1e-6)


def test_exact_sensors_read_the_truth() -> None:
    position, velocity, _, rate = errors(upright(sensors=EXACT))
    assert max(map(abs, position)) < 1e-12
    assert max(map(abs, velocity)) < 1e-3
    assert pstdev(rate) < 1e-12


@pytest.mark.slow
def test_equal_seeds_measure_the_same_and_others_do_not() -> None:
    first, same, other = (upright(seed).servos["servo_5"].state() for seed in (3, 3, 4))
    assert first == same
    assert first.angular_velocity != other.angular_velocity
