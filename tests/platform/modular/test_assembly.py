"""One assembly of a modular arm: its modules, its model, and a second base."""

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytest.importorskip("ruckig", reason="the extra 'cell' is not installed")

from tests.helpers.servo_plant import PERIOD, ServoPlant

from jauspy.geometry.poses import IDENTITY, Pose, Transform
from jauspy.platform.modular.assembly import SHARING_TIME, ArmAssembly, carried_over
from jauspy.platform.modular.graph import ArmChain
from jauspy.platform.modular.trajectory import Setpoint

START = (0.3, 0.4, 0.5, 0.4, 0.2)


@pytest.fixture
def plant() -> ServoPlant:
    plant = ServoPlant()
    plant.settle(START)
    return plant


def test_joints_that_stay_keep_their_values() -> None:
    values = carried_over(("a", "b", "c"), ("c", "d", "a"), np.array([1.0, 2.0, 3.0]), (7.0, 8.0, 9.0))
    assert values.tolist() == [3.0, 8.0, 1.0]
    assert carried_over((), (), np.zeros(0), ()).shape == (0,)


class TestAssembly:
    def test_of_nothing(self, plant: ServoPlant) -> None:
        assembly = ArmAssembly(plant.cell, ArmChain(), plant.servos, lambda name: Pose())
        assert assembly.read() == []
        assert assembly.tip_pose(np.zeros(0)) == IDENTITY.to_pose()

    def test_modules_in_the_order_of_the_chain(self, plant: ServoPlant) -> None:
        assembly = plant.assembly()
        assert [drive.name for drive in assembly.drives] == list(assembly.chain.joints)
        assert [reading.position for reading in assembly.read()] == pytest.approx(START)
        assert assembly.torque_limits.tolist() == [13.0, 38.0, 20.0, 7.0, 7.0]
        assert assembly.limits.velocity[0] == pytest.approx(0.8 * 1.503)

    def test_the_torque_of_a_setpoint_includes_rotor_and_friction(self, plant: ServoPlant) -> None:
        assembly = plant.assembly()
        rest = Setpoint(np.array(START), np.zeros(5), np.zeros(5))
        held = np.abs(assembly.model.gravity(rest.q)) / (0.9 * assembly.torque_limits)
        assert assembly.torque_ratio(rest) == pytest.approx(float(held.max()))
        moving = rest._replace(v=np.array([1.0, 0.0, 0.0, 0.0, 0.0]), a=np.array([25.0, 0.0, 0.0, 0.0, 0.0]))
        assert assembly.torque_ratio(moving) > (0.3 * 25.0 + 0.6 + 0.45) / (0.9 * 13.0)

    def test_a_second_base_takes_over_half_of_the_arm(self, plant: ServoPlant) -> None:
        q = np.array(START)
        assert plant.assembly().shared_load(q, 1.0).tolist() == [0.0] * 5
        tip = plant.assembly().model.tip_pose(q)
        plant.connectors["servo_5/output"].attach("platform_2", tip.inverse() @ Transform(position=(0.6, 0.0, 0.0)))
        assembly = plant.assembly()
        first = assembly.shared_load(q, 0.5 * SHARING_TIME)
        shared = assembly.shared_load(q, SHARING_TIME)
        assert first == pytest.approx(0.5 * shared)
        plant.connectors["platform_1/top"].release()
        other = plant.assembly()
        assert other.chain.joints == assembly.chain.joints[::-1]
        alone = other.model.gravity(q[::-1])[::-1]
        assert assembly.model.gravity(q) + shared == pytest.approx(0.5 * (assembly.model.gravity(q) + alone))

    def test_estimates_the_box_at_the_tip(self, plant: ServoPlant) -> None:
        plant.connectors["servo_5/output"].attach("box_1")
        assembly = plant.assembly()
        plant.settle(START)
        for _ in range(100):
            assembly.update_load(plant.measured(), PERIOD)
        assert assembly.model.load_mass == pytest.approx(plant.box_mass, rel=0.02)
