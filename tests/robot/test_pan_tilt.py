"""The pan-tilt unit of a CM-VIS on a robot of each backend, on virtual time, and a client in control of it."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from tests.robot.workcell import BACKENDS, OTHER, Workcell

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform, jaus_frame
from jauspy.geometry.vectors import X, rotation_from_quaternion
from jauspy.messages import manipulator as m
from jauspy.messages.core import (
    CommandEvent,
    CreateCommandEvent,
    QueryStatus,
    ReleaseControl,
    SetEmergency,
    Standby,
)
from jauspy.messages.environment_sensing import QueryVisualSensorConfiguration
from jauspy.platform.joints import joint_positions
from jauspy.robot import robot_files
from jauspy.robot.robot_files import robot_model


class Head(Workcell):
    """A robot whose chassis camera can turn, and that camera's component."""

    def __init__(self, backend: str, robot: str = "inc1") -> None:
        super().__init__(backend, robot, 107)

    def angles(self) -> tuple[float, float]:
        found = self.ask(m.QueryPanTiltJointPositions())
        return found.joint1_position, found.joint2_position

    def speeds(self) -> tuple[float, float]:
        found = self.ask(m.QueryPanTiltJointVelocity())
        return found.joint1_velocity, found.joint2_velocity

    def line_of_sight(self) -> tuple[float, float, float]:
        """Where the camera looks, in the vehicle's frame: forward, right, down."""
        tree = FrameTree(self.model.description)
        return jaus_frame(tree.pose("chassis_camera_link", joint_positions(self.robot.groups.values()))).rotate(X)


@pytest.fixture(params=BACKENDS)
def head(request: pytest.FixtureRequest) -> Head:
    head = Head(request.param)
    head.take_control()
    return head


@pytest.mark.parametrize("robot", ["inc1", "inc1_pprm"])
def test_specification_matches_the_description(robot: str) -> None:
    found = Head("kinematic", robot).ask(m.QueryPanTiltSpecifications(0xFF))
    place = (found.pan_tilt_coordinate_sys_x, found.pan_tilt_coordinate_sys_y, found.pan_tilt_coordinate_sys_z)
    assert place == pytest.approx((0.35, 0.0, -0.24), abs=1e-6), "where the axes meet"
    turn = [getattr(found, f"{each}_component_of_unit_quaternion_q") for each in "dabc"]
    assert turn == pytest.approx([1.0, 0.0, 0.0, 0.0], abs=1e-6)
    assert (found.joint1_min_value, found.joint1_max_value, found.joint1_max_speed) == pytest.approx((-2.0, 2.0, 1.5))
    assert (found.joint2_min_value, found.joint2_max_value) == pytest.approx((-0.7, 0.9)), "more upwards than downwards"


def test_specification_has_requested_fields_only() -> None:
    found = Head("kinematic").ask(m.QueryPanTiltSpecifications(0b10))
    assert found.pan_tilt_coordinate_sys_x is None
    assert found.pan_tilt_coordinate_sys_y == pytest.approx(0.0, abs=1e-6)


def test_positive_angles_turn_right_and_up(head: Head) -> None:
    head.tell(m.SetPanTiltJointPositions(0.8, 0.5))
    commanded = head.ask(m.QueryCommandedPanTiltJointPositions())
    assert (commanded.joint1_position, commanded.joint2_position) == pytest.approx((0.8, 0.5))
    head.run(2.0)
    assert head.angles() == pytest.approx((0.8, 0.5), abs=0.01)
    assert head.speeds() == pytest.approx((0.0, 0.0), abs=0.01)
    forward, right, down = head.line_of_sight()
    assert math.atan2(right, forward) == pytest.approx(0.8, abs=0.01)
    assert math.asin(down) == pytest.approx(-0.5, abs=0.01)


def test_camera_direction_follows_from_reported_values(head: Head) -> None:
    head.tell(m.SetPanTiltJointPositions(-1.1, 0.6))
    head.run(3.0)
    system = head.ask(m.QueryPanTiltSpecifications(0xFF))
    turn = Transform(
        rotation_from_quaternion(*(getattr(system, f"{each}_component_of_unit_quaternion_q") for each in "dabc"))
    )
    pan, tilt = head.angles()
    ahead = (math.cos(pan) * math.cos(tilt), math.sin(pan) * math.cos(tilt), -math.sin(tilt))
    assert turn.rotate(ahead) == pytest.approx(head.line_of_sight(), abs=1e-3)


@pytest.mark.slow
def test_angles_beyond_the_limits_are_limited(head: Head) -> None:
    head.tell(m.SetPanTiltJointPositions(-20.0, -20.0))
    head.run(4.0)
    assert head.angles() == pytest.approx((-2.0, -0.7), abs=0.02)


@pytest.mark.slow
def test_velocity_turns_until_the_limit(head: Head) -> None:
    head.tell(m.SetPanTiltJointVelocity(0.5, -0.2))
    head.run(1.5)
    assert head.speeds() == pytest.approx((0.5, -0.2), abs=0.05)
    pan, tilt = head.angles()
    assert pan == pytest.approx(0.7, abs=0.15)
    assert tilt == pytest.approx(-0.28, abs=0.06)
    assert head.ask(m.QueryCommandedPanTiltJointVelocity()).joint1_velocity == pytest.approx(0.5)
    for _ in range(4):
        head.tell(m.SetPanTiltJointVelocity(0.5, -0.2))
        head.run(1.25)
    assert head.angles() == pytest.approx((2.0, -0.7), abs=0.03)


def test_velocity_ends_when_no_further_command_arrives(head: Head) -> None:
    head.tell(m.SetPanTiltJointVelocity(0.3, 0.0))
    head.run(1.9)
    assert head.speeds()[0] == pytest.approx(0.3, abs=0.05)
    head.run(0.4)
    assert head.speeds()[0] == pytest.approx(0.0, abs=0.05)


def test_effort_moves_and_zero_effort_holds(head: Head) -> None:
    head.tell(m.SetPanTiltJointEffort(20.0, 0.0))
    assert head.ask(m.QueryPanTiltJointEffort()).joint1_effort == pytest.approx(20.0, abs=0.01)
    head.run(0.5)
    pan, tilt = head.angles()
    assert pan > 0.05, "to the right"
    assert tilt == pytest.approx(0.0, abs=0.02)
    head.tell(m.SetPanTiltJointEffort(0.0, 0.0))
    head.run(0.5)
    held, _ = head.angles()
    head.run(1.0)
    assert head.angles()[0] == pytest.approx(held, abs=0.01)


def test_a_profile_limits_all_drivers(head: Head) -> None:
    head.tell(m.SetPanTiltMotionProfile(0.2, 2.0, 2.0, 30.0, 0.0, 30.0))
    found = head.ask(m.QueryPanTiltMotionProfile())
    assert found.joint1_max_speed == pytest.approx(0.2)
    assert found.joint2_max_speed == pytest.approx(1.5), "no more than the joint can do"
    assert found.joint2_max_acceleration_rate == pytest.approx(6.0), "zero is no wish"
    head.tell(m.SetPanTiltJointPositions(1.0, 0.0))
    head.run(2.0)
    assert 0.3 < head.angles()[0] < 0.42
    head.tell(m.SetPanTiltJointVelocity(-1.0, 0.0))
    head.run(1.0)
    assert head.speeds()[0] == pytest.approx(-0.2, abs=0.03)


@pytest.mark.slow
def test_command_event_reports_when_the_angles_are_reached(head: Head) -> None:
    head.tell(CreateCommandEvent(7, 10, m.SetPanTiltJointPositions(0.8, 0.5)))
    results: list[Message] = []
    head.run(3.0, lambda: results.extend(head.tell()))
    (found,) = [each for each in results if isinstance(each, CommandEvent)]
    assert found.command_result == CommandEvent.CommandResult.SUCCESSFUL
    assert head.angles() == pytest.approx((0.8, 0.5), abs=0.03)


@pytest.mark.parametrize("ending", [Standby(), SetEmergency(1), ReleaseControl()])
def test_leaving_ready_stops_the_unit(head: Head, ending: Message) -> None:
    head.tell(m.SetPanTiltJointVelocity(0.5, 0.0))
    head.run(1.0)
    head.tell(ending)
    head.run(0.3)
    stopped = head.angles()
    head.run(1.0)
    assert head.angles() == pytest.approx(stopped, abs=0.01)
    assert head.ask(m.QueryCommandedPanTiltJointVelocity()).joint1_velocity == pytest.approx(0.0, abs=1e-6)


@pytest.mark.slow
def test_commands_without_control_are_ignored(head: Head) -> None:
    head.tell(m.SetPanTiltJointPositions(1.0, 0.0), client=OTHER)
    head.run(1.0)
    assert head.angles() == pytest.approx((0.0, 0.0), abs=0.01)


def test_newest_command_preempts_earlier_ones(head: Head) -> None:
    head.tell(m.SetPanTiltJointVelocity(0.5, 0.0), m.SetPanTiltJointPositions(0.3, 0.1))
    assert head.ask(m.QueryCommandedPanTiltJointVelocity()).joint1_velocity == pytest.approx(0.0, abs=1e-6)
    head.run(2.0)
    assert head.angles() == pytest.approx((0.3, 0.1), abs=0.01)


def test_camera_services_are_offered_as_well(head: Head) -> None:
    record = QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec(1, 0xFFFF)
    assert head.ask(QueryVisualSensorConfiguration([record])).visual_sensor_configuration_list
    assert head.ask(QueryStatus()).status == 1


MOUNT = """
[groups.pan_tilt]
base = "base_link"
tip = "{tip}"
joints = [{joints}]
"""
JOINT = "{{ name = '{0}', position = {{ p = 1 }}, velocity = {{ p = 1 }} }}"


@pytest.mark.parametrize(
    ("tip", "joints", "said"),
    [
        ("pan_link", ["base_link_to_pan_link"], r"groups.pan_tilt.joints: .* exactly two joints"),
        (
            "arm_link_2",
            ["base_link_to_arm_link_1", "arm_link_1_to_arm_link_2"],
            r"the camera is on 'chassis_camera_link', which 'arm_link_1_to_arm_link_2' does not move",
        ),
    ],
)
def test_invalid_pan_tilt_groups_are_rejected(tmp_path: Path, tip: str, joints: list[str], said: str) -> None:
    file = tmp_path / "mine.toml"
    text = MOUNT.format(tip=tip, joints=", ".join(JOINT.format(joint) for joint in joints))
    module = "[[modules]]\ntype = 'CM-VIS'\ncomponent = 107\ncamera = 'chassis'\ngroup = 'pan_tilt'\n"
    file.write_text(f"extends = 'inc1'\n{module}{text}")
    with pytest.raises(ConfigError, match=said):
        robot_model(robot_files.load(file))


def test_pan_tilt_services_without_group_are_an_error(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    services = "services = ['Discovery', 'PanTiltJointPositionSensor']"
    file.write_text(
        f"extends = 'inc1'\n[[modules]]\ntype = 'CM-VIS'\ncomponent = 107\ncamera = 'chassis'\n{services}\n"
    )
    with pytest.raises(ConfigError, match="group: is missing; PanTiltJointPositionSensor needs"):
        robot_files.load(file)
