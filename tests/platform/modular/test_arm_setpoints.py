"""Setpoints of the joints of a modular arm: motions, silent modules, closed loops, other assemblies."""

import math

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.servo_plant import PERIOD, ServoPlant

from jauspy.geometry.poses import IDENTITY
from jauspy.platform.modular.arm_setpoints import RELAXATION_TIME, SETTLING_TIME, SHAPING_TIME, ArmSetpoints
from jauspy.platform.modular.control_laws import JointMeasurements

START = (0.3, 0.4, 0.5, 0.4, 0.2)


@pytest.fixture
def plant() -> ServoPlant:
    plant = ServoPlant()
    plant.settle(START)
    return plant


def follow(setpoints: ArmSetpoints, seconds: float) -> None:
    """Advance with joints that are exactly where the setpoint is."""
    for _ in range(round(seconds / PERIOD)):
        q, v, _ = setpoints.setpoint
        setpoints.advance(JointMeasurements(q, v, q, q), [True] * len(q), PERIOD)


def test_rests_where_the_joints_are(plant: ServoPlant) -> None:
    assembly = plant.assembly()
    setpoints = ArmSetpoints(assembly, assembly.read())
    follow(setpoints, 0.1)
    assert setpoints.targets == pytest.approx(START)
    assert not setpoints.moving


@pytest.mark.parametrize("shaped", [False, True])
def test_reaches_its_target_in_the_given_duration(plant: ServoPlant, shaped: bool) -> None:
    assembly = plant.assembly()
    setpoints = ArmSetpoints(assembly, assembly.read())
    setpoints.begin((0.0,) * 5, 2.0, shaped=shaped)
    follow(setpoints, 1.9 if shaped else 1.9 - SHAPING_TIME)
    assert setpoints.moving
    assert np.abs(setpoints.setpoint.q).max() > 1e-5
    follow(setpoints, 0.11)
    assert setpoints.setpoint.q.tolist() == [0.0] * 5
    assert not setpoints.moving


def test_a_joint_that_does_not_follow_ends_the_motion_with_an_error(plant: ServoPlant) -> None:
    assembly = plant.assembly()
    setpoints = ArmSetpoints(assembly, assembly.read())
    setpoints.begin((0.5, *START[1:]), 0.0, shaped=True)
    stuck = plant.measured()
    for _ in range(round((1.0 + SETTLING_TIME) / PERIOD)):
        setpoints.advance(stuck, [True] * 5, PERIOD)
    assert not setpoints.moving
    assert setpoints.error == "servo_1 is 0.200 rad from its target 2 s after the motion"


def test_a_silent_module_is_followed(plant: ServoPlant) -> None:
    assembly = plant.assembly()
    setpoints = ArmSetpoints(assembly, assembly.read())
    sagged = plant.measured()._replace(q=np.array([9.0, 9.0, 9.0, 0.7, 9.0]))
    setpoint = setpoints.advance(sagged, [True, True, True, False, True], PERIOD)
    assert setpoint.q == pytest.approx((*START[:3], 0.7, START[4]))


def test_a_closed_loop_gives_way(plant: ServoPlant) -> None:
    plant.connectors["servo_5/output"].attach("platform_2", IDENTITY)
    assembly = plant.assembly()
    setpoints = ArmSetpoints(assembly, assembly.read())
    pushed = plant.measured()._replace(q=np.array(START) + 0.1)
    for _ in range(round(RELAXATION_TIME / PERIOD)):
        setpoints.advance(pushed, [True] * 5, PERIOD)
    assert setpoints.setpoint.q - START == pytest.approx(0.1 * (1.0 - math.exp(-1.0)), abs=1e-3)


def test_adopts_another_assembly(plant: ServoPlant) -> None:
    assembly = plant.assembly()
    setpoints = ArmSetpoints(assembly, assembly.read())
    setpoints.begin((1.0,) * 5, 0.0, shaped=True)
    follow(setpoints, 0.2)
    before = setpoints.setpoint
    plant.connectors["tube_2/end"].release()
    shorter = plant.assembly()
    setpoints.adopt(shorter, shorter.read())
    assert setpoints.setpoint.q.tolist() == before.q[:3].tolist()
    assert setpoints.error == "the motion ended early: modules were attached or released"
    plant.connectors["tube_2/end"].attach("servo_4")
    longer = plant.assembly()
    setpoints.adopt(longer, longer.read())
    assert setpoints.setpoint.q.tolist() == pytest.approx([*before.q[:3], *START[3:]])
    follow(setpoints, 1.0)
    assert not setpoints.moving
    assert not setpoints.setpoint.v.any()
