"""What the joint groups of a simulated robot touch."""

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.backends.can.backend import CanBackend
from jauspy.cli.options import on_bus
from jauspy.platform.contacts import Contacts
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_model(load("inc1"))


@pytest.mark.slow
def test_groups_count_the_bodies_that_they_touch() -> None:
    robot = SimulatedRobot.open(INC1, "empty")
    contacts = Contacts.of(robot)
    assert contacts is not None
    assert "arm" not in contacts.state()
    before = contacts.state()
    robot.groups["flippers"].command([Target(ControlMode.POSITION, -0.2)])
    robot.advance(3.0)
    count = contacts.state()["flippers"]["world"]
    assert count > before.get("flippers", {}).get("world", 0)
    assert "arm" not in contacts.state()
    robot.groups["flippers"].command([Target(ControlMode.POSITION, 2.2)])
    robot.advance(3.0)
    left = contacts.state()["flippers"]["world"]
    robot.advance(1.0)
    assert contacts.state()["flippers"]["world"] == left > 0


@pytest.mark.slow
def test_arm_on_the_table_is_counted_with_all_that_it_carries() -> None:
    robot = SimulatedRobot.open(INC1, "yard")
    address = robot.model.joint("inc1/base").qposadr[0]
    robot.data.qpos[address : address + 7] = (1.87, 0.35, 0.0, 0.7071, 0.0, 0.0, 0.7071)
    robot.groups["arm"].command([Target(ControlMode.POSITION, value) for value in (0.0, -0.35, 0.0, 0.0, 0.0)])
    robot.advance(6.0)
    contacts = Contacts.of(robot)
    assert contacts is not None
    assert contacts.state()["arm"]["table"] > 100
    assert set(contacts.state()["arm"]) <= {"table", "can", "block_small", "block_large"}


def test_drives_on_can_pass_on_the_contacts_of_their_simulation() -> None:
    pytest.importorskip("canopen", reason="needs the extra 'can'")
    robot = CanBackend().open(robot_model(on_bus(load("inc1"), "virtual:sim")), "empty")
    try:
        contacts = Contacts.of(robot)
        assert contacts is not None
        assert "arm" not in contacts.state()
    finally:
        robot.close()
