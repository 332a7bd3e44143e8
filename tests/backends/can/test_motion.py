"""Commands to joints become the three cyclic synchronous modes; efforts carry the arm as in the simulation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest
from tests.backends.can.conftest import OpenCan
from tests.backends.can.test_failing_drives import advance_until_fault

from jauspy.backends.can.robot import CanRobot
from jauspy.platform.joints import ControlMode, Target

SHOULDER, WRIST = 1, 4


def stretched(robot: CanRobot) -> CanRobot:
    arm = robot.groups["arm"]
    stretch(robot)
    assert arm.state().efforts[SHOULDER] == pytest.approx(17.5, abs=0.5)  # N m, of the weight of the arm
    return robot


def stretch(robot: CanRobot, positions: Sequence[float] = (0.0, 1.2, -1.5, 0.3, 0.0), *, seconds: float = 3.0) -> None:
    robot.groups["arm"].command([Target(ControlMode.POSITION, position) for position in positions])
    robot.advance(seconds)


@pytest.mark.slow
@pytest.mark.parametrize("share", [-0.2, 0.3])
def test_a_compensated_effort_moves_at_its_share_of_the_speed(robot: CanRobot, share: float) -> None:
    arm = stretched(robot).groups["arm"]
    joint = arm.joints[SHOULDER]
    arm.command([None, Target(ControlMode.EFFORT, share * joint.effort, compensated=True), None, None, None])
    robot.advance(0.6)
    assert arm.state().velocities[SHOULDER] == pytest.approx(share * joint.velocity, abs=0.02)
    assert arm.state().velocities[WRIST] == pytest.approx(0.0, abs=1e-3)


@pytest.mark.slow
def test_an_effort_that_is_not_compensated_is_that_of_the_motor(robot: CanRobot) -> None:
    arm = stretched(robot).groups["arm"]
    arm.command([None, Target(ControlMode.EFFORT, 5.0), None, None, None])
    robot.advance(0.2)
    assert arm.state().efforts[SHOULDER] == pytest.approx(5.0, abs=0.2)
    assert arm.state().velocities[SHOULDER] < -0.05  # less than the weight


@pytest.mark.slow
def test_a_joint_that_is_commanded_to_its_end_by_effort_stays_within_its_limits(robot: CanRobot) -> None:
    arm = robot.groups["arm"]
    arm.command([None, None, None, None, Target(ControlMode.EFFORT, 12.0)])
    with pytest.raises(pytest.fail.Exception, match="no drive has failed"):
        advance_until_fault(robot, 3.0)
    assert arm.joints[WRIST].upper - 0.05 < arm.state().positions[WRIST] <= arm.joints[WRIST].upper + 0.01


@pytest.mark.slow
def test_a_load_that_a_motor_cannot_carry_is_reported_as_by_other_backends(open_can: OpenCan) -> None:
    pytest.importorskip("mujoco")
    robot = open_can(bus="virtual:sim")
    stretch(robot, (0.0, 0.15, -0.1, 0.0, 0.0), seconds=6.0)
    assert robot.groups["arm"].state().overloads == {}
    assert robot.fleet is not None
    plant: Any = robot.fleet.plant.robot
    plant.data.xfrc_applied[plant.model.body("inc1/gripper_link").id][2] = -9.81 * 12.0  # N, at the hand
    robot.advance(1.5)
    state, joint = robot.groups["arm"].state(), robot.groups["arm"].joints[SHOULDER]
    brake = plant.groups["arm"].state().overloads[joint.name]
    assert brake > 0.9 * joint.effort
    assert state.overloads[joint.name] == pytest.approx(brake, rel=0.1)
    assert state.velocities[SHOULDER] == pytest.approx(0.0, abs=0.02)
