"""CM-MAN and CM-EEF on a robot of each backend, on virtual time, and a client in control of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib.util import find_spec
from typing import Any

import pytest
from tests.robot.workcell import BACKENDS, OTHER, Workcell, outcomes

from jauspy.codec.message import Message
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector, X, Z, rotation_about, rotation_from_quaternion
from jauspy.ids import JausID
from jauspy.messages import manipulator as m
from jauspy.messages.core import (
    ConfirmElementRequest,
    CreateCommandEvent,
    ElementRec,
    QueryStatus,
    ReleaseControl,
    Resume,
    SetElement,
    SetEmergency,
    Standby,
)
from jauspy.services.manipulator.joints import percent_records

GOAL = (0.4, 1.2, -0.9, 0.3, -0.5)


@pytest.fixture(params=BACKENDS)
def arm(request: pytest.FixtureRequest) -> Workcell:
    cell = Workcell(request.param, "inc1", 104)
    cell.take_control()
    return cell


@pytest.fixture(params=BACKENDS)
def gripper(request: pytest.FixtureRequest) -> Workcell:
    cell = Workcell(request.param, "inc1", 105)
    cell.take_control()
    return cell


def positions(arm: Workcell, native: Sequence[float]) -> m.SetJointPositions:
    """The command for positions that the URDF would call so: the report at the start says what zero is."""
    links = offsets(arm)
    make, choice = m.JointPositionRec.JointPosition, m.JointPositionRec.JointPositionChoice
    return m.SetJointPositions(
        [m.JointPositionRec(make(choice.RADIAN, value + zero)) for value, zero in zip(native, links, strict=True)]
    )


def offsets(arm: Workcell) -> list[float]:
    """What the standard calls the positions that the URDF calls zero: limits differ by that."""
    specification = arm.ask(m.QueryManipulatorSpecifications(0xFF))
    joints = arm.robot.groups["arm"].joints
    first, *others = (specification.first_joint_parameters, *specification.joint_specification_list)
    lowest = [first.joint1_min_value, *(each.min_value for each in others)]
    return [low - joint.lower for low, joint in zip(lowest, joints, strict=True)]


def velocities(*values: float) -> m.SetJointVelocity:
    make, choice = m.JointVelocityRec.JointVelocity, m.JointVelocityRec.JointVelocityChoice
    return m.SetJointVelocity([m.JointVelocityRec(make(choice.RADIAN_PER_SECOND, value)) for value in values])


# --- geometry


def forward(report: Any, positions: Sequence[float], tool: Vector) -> tuple[Vector, Transform]:
    """The standard's forward kinematics, from what was reported alone: the tool in the vehicle's frame, z down."""
    system = report.manipulator_coordinate_system_rec
    x, y, z, *q = (getattr(system, name) for name in system.__dataclass_fields__)
    base = Transform(rotation_from_quaternion(*q), (x, y, z))
    frame, first = base, report.first_joint_parameters
    links = [
        (0.0, 0.0, first),
        *((each.link_length, each.twist_angle, each) for each in report.joint_specification_list),
    ]
    for (length, twist, joint), position in zip(links, positions, strict=True):
        offset = getattr(joint, "joint_offset", getattr(joint, "joint1_offset", None))
        angle = getattr(joint, "joint_angle", getattr(joint, "joint1_angle", None))
        turn, along = (position, offset) if offset is not None else (angle, position)
        frame = (
            frame
            @ Transform(rotation_about(X, twist), (length, 0.0, 0.0))
            @ Transform(rotation_about(Z, turn), (0.0, 0.0, along))
        )
    return frame.apply(tool), base.inverse() @ frame


@pytest.mark.slow
@pytest.mark.skipif(find_spec("mujoco") is None, reason="MuJoCo is not installed")
@pytest.mark.parametrize(
    ("robot", "goal"), [("inc1", GOAL), ("inc1", (-1.0, 2.0, -1.5, -0.8, 1.0)), ("inc1_pprm", (0.3, 0.2, -0.7, 0.4))]
)
def test_reported_geometry_gives_the_simulated_tool_pose(robot: str, goal: tuple[float, ...]) -> None:
    cell = Workcell("sim", robot, 104)
    cell.take_control()
    make, choice = m.JointPositionRec.JointPosition, m.JointPositionRec.JointPositionChoice
    kinds = [record.joint_position.choice for record in cell.ask(m.QueryJointPositions()).joint_position_list]
    rows = zip(goal, offsets(cell), kinds, strict=True)
    records = [m.JointPositionRec(make(choice(kind), value + zero)) for value, zero, kind in rows]
    cell.tell(m.SetJointPositions(records))
    cell.run(5.0)
    offset = cell.ask(m.QueryToolOffset())
    tool = (offset.tool_point_coordinate_x, offset.tool_point_coordinate_y, offset.tool_point_coordinate_z)
    point, last = forward(cell.ask(m.QueryManipulatorSpecifications(0xFF)), cell.positions(), tool)
    data = cell.robot.data
    base, seen = data.body(f"{robot}/base_link"), data.body(f"{robot}/tool_link").xpos
    x, y, z = (seen - base.xpos) @ base.xmat.reshape(3, 3)
    assert point == pytest.approx((x, -y, -z), abs=0.001)
    pose = cell.ask(m.QueryEndEffectorPose())
    reported = (pose.tool_point_coordinate_x, pose.tool_point_coordinate_y, pose.tool_point_coordinate_z)
    assert reported == pytest.approx(last.apply(tool), abs=0.001)


def test_joint_names_are_those_of_the_description(arm: Workcell) -> None:
    names = [each.description for each in arm.ask(m.QueryManipulatorSpecifications(0xFF)).joint_names_list]
    assert names == [joint.name for joint in arm.robot.groups["arm"].joints]


def test_presence_vectors_are_applied(arm: Workcell) -> None:
    report = arm.ask(m.QueryManipulatorSpecifications(0x01))
    assert report.manipulator_coordinate_system_rec is not None
    assert report.joint_names_list is None


def test_the_tool_offset_can_be_set(arm: Workcell) -> None:
    before = arm.ask(m.QueryEndEffectorPose())
    offset = arm.ask(m.QueryToolOffset())
    arm.tell(m.SetToolOffset(offset.tool_point_coordinate_x, offset.tool_point_coordinate_y + 0.1, 0.0))
    after = arm.ask(m.QueryEndEffectorPose())
    moved = math.dist(
        (before.tool_point_coordinate_x, before.tool_point_coordinate_y, before.tool_point_coordinate_z),
        (after.tool_point_coordinate_x, after.tool_point_coordinate_y, after.tool_point_coordinate_z),
    )
    assert moved >= 0.099


# --- motion


@pytest.mark.slow
def test_joint_positions_are_reached(arm: Workcell) -> None:
    command = positions(arm, GOAL)
    arm.tell(command)
    arm.run(6.0)
    wanted = [record.joint_position.value for record in command.joint_position_list]
    assert arm.positions() == pytest.approx(wanted, abs=0.003)
    commanded = arm.ask(m.QueryCommandedJointPositions()).joint_position_list
    assert [record.joint_position.value for record in commanded] == pytest.approx(wanted, abs=1e-6)


@pytest.mark.slow
def test_command_event_reports_success_or_failure(arm: Workcell) -> None:
    assert outcomes(arm, CreateCommandEvent(1, 60, positions(arm, GOAL))) == []
    ends: list[int] = []
    arm.run(6.0, lambda: ends.extend(outcomes(arm)))
    assert ends == [0]
    back = CreateCommandEvent(1, 60, positions(arm, (0.0, 1.0, -1.0, 0.0, 0.0)))
    assert outcomes(arm, back) == []
    assert outcomes(arm, velocities(0.1, 0.1, 0.1, 0.1, 0.1)) == [1]
    assert outcomes(arm, back, Standby()) == [1]
    arm.tell(Resume())
    assert outcomes(arm, CreateCommandEvent(1, 60, velocities(0.1))) == [1], "it does not fit the joints"


@pytest.mark.slow
def test_the_motion_profile_limits_speed(arm: Workcell) -> None:
    record = m.SetJointMotionProfile.RevoluteJointMotionProfileRec
    arm.tell(m.SetJointMotionProfile([record(0.2, 1.0, 1.0)] * 5))
    profile = arm.ask(m.QueryJointMotionProfile()).joint_motion_profile_list
    assert [each.joint_max_speed for each in profile] == pytest.approx([0.2] * 5, abs=1e-6)
    arm.tell(positions(arm, GOAL))
    fastest = [0.0]
    arm.run(2.0, lambda: fastest.append(max(map(abs, arm.velocities()))))
    assert 0.15 < max(fastest) < 0.25


def test_motion_profile_is_limited_to_the_joints(arm: Workcell) -> None:
    record = m.SetJointMotionProfile.RevoluteJointMotionProfileRec
    arm.tell(m.SetJointMotionProfile([record(30.0, 30.0, 30.0)] * 5))
    profile = arm.ask(m.QueryJointMotionProfile()).joint_motion_profile_list
    most = [joint.velocity for joint in arm.robot.groups["arm"].joints]
    assert [each.joint_max_speed for each in profile] == pytest.approx(most, abs=1e-6)


def test_velocities_hold_until_another_driver_commands(arm: Workcell) -> None:
    arm.tell(velocities(0.3, 0.0, 0.0, 0.0, -0.4))
    arm.run(1.0)
    assert arm.velocities() == pytest.approx([0.3, 0.0, 0.0, 0.0, -0.4], abs=0.03)
    arm.tell(positions(arm, GOAL))
    commanded = arm.ask(m.QueryCommandedJointVelocity()).joint_velocity_list
    assert [record.joint_velocity.value for record in commanded] == pytest.approx([0.0] * 5, abs=1e-6)


def test_effort_moves_and_zero_effort_holds(arm: Workcell) -> None:
    before = arm.positions()
    arm.tell(m.SetJointEffort(percent_records([8.0, 0.0, 0.0, 0.0, 0.0])))
    arm.run(0.4)
    moved = arm.positions()
    assert moved[0] > before[0] + 0.005
    assert moved[1:] == pytest.approx(before[1:], abs=0.01)
    efforts = arm.ask(m.QueryJointForceTorques()).actuator_force_torque_list
    assert 0.5 < efforts[0].joint_force_torque.value < 0.081 * 60.0
    arm.tell(m.SetJointEffort(percent_records([0.0] * 5)))
    arm.run(0.5)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=0.02)


def test_force_torques_are_applied(arm: Workcell) -> None:
    make, choice = m.ActuatorForceTorqueRec.JointForceTorque, m.ActuatorForceTorqueRec.JointForceTorqueChoice
    records = [m.ActuatorForceTorqueRec(make(choice.NEWTON_METER, effort)) for effort in (5.0, 30.0, 0.0, 0.0, -0.2)]
    arm.tell(m.SetActuatorForceTorques(records))
    arm.run(0.02)
    found = arm.ask(m.QueryJointForceTorques()).actuator_force_torque_list
    step = 0.03 if arm.backend == "can" else 1e-3  # drives take thousandths of their torque
    assert [each.joint_force_torque.value for each in found] == pytest.approx([5.0, 30.0, 0.0, 0.0, -0.2], abs=step)


@pytest.mark.slow
def test_tool_moves_at_the_reported_velocity(arm: Workcell) -> None:
    def tool() -> Vector:
        pose = arm.ask(m.QueryEndEffectorPose())
        return pose.tool_point_coordinate_x, pose.tool_point_coordinate_y, pose.tool_point_coordinate_z

    arm.tell(positions(arm, GOAL))
    arm.run(6.0)
    arm.tell(velocities(0.2, -0.2, 0.3, 0.1, 0.2))
    arm.run(0.6)
    before, state = tool(), arm.ask(m.QueryEndEffectorVelocityState())
    arm.run(0.04)
    rate = [(a - b) / 0.04 for a, b in zip(tool(), before, strict=True)]
    linear = (state.linear_velocity_component_x, state.linear_velocity_component_y, state.linear_velocity_component_z)
    assert rate == pytest.approx(linear, abs=0.02)


# --- lists


@pytest.mark.slow
def test_list_of_positions_is_executed(arm: Workcell) -> None:
    goals = [(0.3, 2.5, -2.4, 0.0, 0.0), (0.3, 2.2, -2.2, 0.2, 0.5), (0.0, 2.5, -2.5, 0.0, 0.0)]
    elements = [
        ElementRec(uid, uid - 1, (uid + 1) % 4, ElementRec.ElementData(format=0, data=positions(arm, goal)))
        for uid, goal in enumerate(goals, 1)
    ]
    answers = arm.tell(SetElement(SetElement.RequestIDRec(7), elements))
    assert answers == [ConfirmElementRequest(7)]
    seen = []
    arm.tell(m.ExecuteList(element_uid=1))
    arm.run(6.0, lambda: seen.append(arm.ask(m.QueryActiveElement()).element_uid))
    assert list(dict.fromkeys(seen)) == [1, 2, 3, 0]
    wanted = [record.joint_position.value for record in positions(arm, goals[-1]).joint_position_list]
    assert arm.positions() == pytest.approx(wanted, abs=0.02)


# --- what stops it


@pytest.mark.parametrize("stop", [Standby(), ReleaseControl(), SetEmergency(1)])
def test_stops_within_200_ms(arm: Workcell, stop: Message) -> None:
    arm.tell(velocities(0.5, -0.3, 0.4, 0.3, 0.5))
    arm.run(1.0)
    arm.tell(stop)
    arm.run(0.2)
    assert arm.velocities() == pytest.approx([0.0] * 5, abs=0.03)


def test_does_not_move_without_control(arm: Workcell) -> None:
    before = arm.positions()
    arm.tell(positions(arm, GOAL), velocities(0.5, 0.5, 0.5, 0.5, 0.5), client=OTHER)
    arm.run(0.5)
    assert arm.positions() == pytest.approx(before, abs=0.003)


def test_commands_that_do_not_match_the_joints_are_counted(arm: Workcell) -> None:
    make, choice = m.JointPositionRec.JointPosition, m.JointPositionRec.JointPositionChoice
    metres = m.SetJointPositions([m.JointPositionRec(make(choice.METER, 0.1))] * 5)
    arm.tell(metres, velocities(0.1), m.SetJointEffort(percent_records([5.0] * 6)))
    arm.tell(m.SetJointMotionProfile([m.SetJointMotionProfile.RevoluteJointMotionProfileRec(1.0, 1.0, 1.0)] * 4))
    before = arm.positions()
    arm.run(0.3)
    assert arm.positions() == pytest.approx(before, abs=0.003)
    assert arm.host.counters["wrong_joints"] == 4


# --- the gripper


@pytest.mark.slow
def test_positive_efforts_close_the_gripper_and_negative_ones_open_it(gripper: Workcell) -> None:
    fingers = gripper.robot.groups["gripper"]
    gripper.tell(m.SetEndEffectorEffort(60.0))
    gripper.run(1.5)
    assert fingers.state().positions[0] == pytest.approx(0.0, abs=0.002)
    assert gripper.ask(m.QueryEndEffectorEffort()).end_effector_effort == pytest.approx(60.0, abs=0.01)
    gripper.tell(m.SetEndEffectorEffort(-60.0))
    gripper.run(1.5)
    assert fingers.state().positions[0] == pytest.approx(0.05, abs=0.002)


def test_gripper_keeps_its_grasp_without_control_but_stops_opening(gripper: Workcell) -> None:
    gripper.tell(m.SetEndEffectorEffort(40.0), ReleaseControl())
    assert gripper.ask(m.QueryEndEffectorEffort()).end_effector_effort == pytest.approx(40.0, abs=0.01)
    gripper.take_control()
    gripper.tell(m.SetEndEffectorEffort(-40.0), Standby())
    gripper.run(0.2)
    assert gripper.ask(m.QueryEndEffectorEffort()).end_effector_effort == pytest.approx(0.0, abs=0.01)


def test_gripper_reports_its_manipulator(gripper: Workcell) -> None:
    assert gripper.ask(m.QueryEndEffectorSpecification()).parent_id == int(JausID(101, 1, 104))
    assert gripper.ask(QueryStatus()).status == 1
