"""A load that the simulated arm cannot carry, as its module tells of it."""

from __future__ import annotations

import logging

import pytest
from tests.robot.workcell import Workcell

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.messages import manipulator as m
from jauspy.platform.contract import Snapshot
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.config import ModuleConfig
from jauspy.robot.monitors import LoadMonitor, overloads


class Link:
    """What the monitor reads of a robot."""

    def __init__(self, cell: Workcell) -> None:
        self._robot = cell.robot
        self.groups = cell.robot.groups

    @property
    def snapshot(self) -> Snapshot:
        return Snapshot.of(self._robot)


@pytest.mark.slow
def test_a_load_that_is_too_heavy_is_reported_once(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, logger="jauspy.robot")
    cell = Workcell("sim", "inc1", 104)
    cell.take_control()
    arm = cell.robot.groups["arm"]
    arm.command([Target(ControlMode.POSITION, value) for value in (0.0, 0.6, -0.3, 0.0, 0.0)])
    cell.run(4.5)
    link, module = Link(cell), ModuleConfig(type="CM-MAN", component=104)
    LoadMonitor(cell.host, module, link)
    hand = cell.robot.model.body("inc1/gripper_link").id
    cell.robot.data.xfrc_applied[hand][2] = -12.0 * 9.81
    cell.run(2.0)
    joints = {name: group.joints for name, group in link.groups.items()}
    reported = overloads(module, joints, link.snapshot)["arm_link_1_to_arm_link_2"]
    assert "cannot carry its load (1" in reported
    assert "N m of 110 N m)" in reported
    warned = [each.getMessage() for each in caplog.records if "arm_link_1_to_arm_link_2 cannot" in each.getMessage()]
    assert len(warned) == 1
    assert cell.host.counters["overload"] >= 1
    efforts = cell.ask(m.QueryJointForceTorques()).actuator_force_torque_list
    assert efforts[1].joint_force_torque.value > 110.0, "the load is visible over JAUS"
    cell.robot.data.xfrc_applied[hand][2] = 0.0
    cell.run(1.0)
    assert not overloads(module, joints, link.snapshot)
    assert "arm_link_1_to_arm_link_2 carries its load again" in caplog.text
