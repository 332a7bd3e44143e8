"""Torques of the motors of a modular arm: at rest, faded over, within limits."""

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.servo_plant import PERIOD, ServoPlant

from jauspy.platform.modular.arm import ArmController
from jauspy.platform.modular.arm_setpoints import ArmSetpoints
from jauspy.platform.modular.torque_controller import FADE_TIME, TorqueController

START = (0.3, 0.4, 0.5, 0.4, 0.2)


@pytest.fixture
def plant() -> ServoPlant:
    plant = ServoPlant()
    plant.settle(START)
    return plant


@pytest.mark.parametrize("controller", ArmController)
def test_hold_the_arm_at_rest(plant: ServoPlant, controller: ArmController) -> None:
    assembly = plant.assembly()
    torques = TorqueController(assembly)
    torques.select(controller)
    rest = ArmSetpoints(assembly, assembly.read()).setpoint
    gravity = assembly.model.gravity(rest.q)
    torques.restart(gravity)
    for _ in range(round(2.0 * FADE_TIME / PERIOD)):
        found = torques.update(rest, plant.measured(), PERIOD)
    assert found == pytest.approx(gravity, abs=1e-3)
    assert torques.last_torques is found


def test_fade_over_from_the_last_ones(plant: ServoPlant) -> None:
    assembly = plant.assembly()
    torques = TorqueController(assembly)
    rest = ArmSetpoints(assembly, assembly.read()).setpoint
    last = np.array([1.0, -1.0, 1.0, -1.0, 1.0])
    torques.adopt(assembly, last)
    found = [torques.update(rest, plant.measured(), PERIOD) for _ in range(round(FADE_TIME / PERIOD))]
    gravity = assembly.model.gravity(rest.q)
    assert np.abs(found[0] - last).max() < 0.05 * np.abs(gravity - last).max()
    assert found[-1] == pytest.approx(gravity, abs=1e-3)


def test_stay_within_the_limits_of_the_modules(plant: ServoPlant) -> None:
    assembly = plant.assembly()
    torques = TorqueController(assembly)
    torques.select(ArmController.PID)
    rest = ArmSetpoints(assembly, assembly.read()).setpoint
    torques.restart(np.full(5, 1000.0))
    found = torques.update(rest, plant.measured(), PERIOD)
    assert found.tolist() == [13.0, 38.0, 20.0, 7.0, 7.0]
