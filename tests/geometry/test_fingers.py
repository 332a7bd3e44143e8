"""The width between fingers, by the positions of their joints."""

from __future__ import annotations

import pytest

from jauspy.geometry.fingers import FingerWidth, finger_width
from jauspy.geometry.urdf import RobotDescription, parse_urdf
from jauspy.robot import robot_files

LEFT, RIGHT = "left_joint", "right_joint"


def hand(left: str = "", right: str = "", kind: str = "prismatic", shape: str = '<box size=".02 .01 .02"/>') -> str:
    finger = '<link name="{0}"><collision><geometry>{1}</geometry></collision></link>'
    joint = (
        '<joint name="{0}_joint" type="{1}"><parent link="palm"/><child link="{0}"/>{2}'
        '<limit lower="{3}" upper="0.04" effort="20" velocity="0.1"/>{4}</joint>'
    )
    parts = [finger.format("left", shape), finger.format("right", shape)]
    parts.append(joint.format("left", kind, '<origin xyz="0 .02 0"/><axis xyz="0 1 0"/>', -0.01, left))
    parts.append(joint.format("right", kind, '<origin xyz="0 -.02 0"/><axis xyz="0 -1 0"/>', -0.01, right))
    return f'<robot name="hand"><link name="palm"/>{"".join(parts)}</robot>'


def described(urdf: str) -> RobotDescription:
    return parse_urdf(urdf)


def test_a_finger_that_mimics_the_other_doubles_the_width() -> None:
    found = finger_width(described(hand(right=f'<mimic joint="{LEFT}"/>')), [LEFT])
    assert found == FingerWidth(pytest.approx(0.03), {LEFT: pytest.approx(2.0)})


def test_two_driven_fingers_add() -> None:
    found = finger_width(described(hand()), [LEFT, RIGHT])
    assert found == FingerWidth(pytest.approx(0.03), {LEFT: pytest.approx(1.0), RIGHT: pytest.approx(1.0)})


def test_fingers_of_meshes_touch_at_their_lower_limits() -> None:
    found = finger_width(described(hand(shape='<mesh filename="no.stl"/>')), [LEFT, RIGHT])
    assert found == FingerWidth(pytest.approx(0.02), {LEFT: pytest.approx(1.0), RIGHT: pytest.approx(1.0)})


def test_one_finger_closes_at_its_lower_limit() -> None:
    assert finger_width(described(hand()), [LEFT]) == FingerWidth(pytest.approx(0.01), {LEFT: 1.0})


def test_fingers_that_turn_have_no_width() -> None:
    assert finger_width(described(hand(kind="revolute")), [LEFT, RIGHT]) is None


def test_the_gripper_of_inc1_opens_to_ten_centimetres() -> None:
    model = robot_files.robot_model(robot_files.load("inc1"))
    group = model.groups["gripper"]
    found = finger_width(model.description, group.joints)
    assert found == FingerWidth(pytest.approx(0.0), {group.joints[0]: pytest.approx(2.0)})
