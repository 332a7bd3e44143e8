"""Poses of parts that connectors hold, by their carriers."""

from __future__ import annotations

from typing import Any, cast

import pytest

from jauspy.console.held_parts import HeldParts
from jauspy.console.robot_geometry import output_joint, part_joint
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import rotation_about
from jauspy.ids import JausID
from jauspy.messages.cell import ReportConnectorState
from jauspy.robot import robot_files

HERE = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]


@pytest.fixture
def held() -> HeldParts:
    model = robot_files.robot_model(robot_files.load("cell"))
    assert model.cell is not None
    return HeldParts(cast("Any", None), lambda: None, model.cell, model.description)


def hold(held: HeldParts, number: int, carrier: str, connector: str, part: str, **offset: float) -> None:
    held.take(JausID(201, 2, number), 1, carrier, connector, ReportConnectorState(1, attached_to=part, **offset))


def test_a_chain_turns_with_its_servo(held: HeldParts) -> None:
    hold(held, 1, "platform_1", "top", "servo_1")
    hold(held, 2, "servo_1", "output", "bracket_1", offset_x=0.002)
    hold(held, 3, "bracket_1", "output", "servo_2")
    still = held.poses({}, {})
    turned = held.poses({}, {output_joint("servo_1"): 0.5})
    assert still[part_joint("servo_1")] == turned[part_joint("servo_1")] == [0.6, 0.22, 0.2, 0.0, 0.0, 0.0, 1.0]
    x, y, z, *_ = still[part_joint("bracket_1")]
    turn = Transform(rotation_about((0.0, 0.0, 1.0), 0.5))
    there = turn.apply((x - 0.6, y - 0.22, z))
    at = turned[part_joint("bracket_1")][:3]
    assert [at[0] - 0.6, at[1] - 0.22, at[2]] == pytest.approx(there, abs=2e-4)
    assert turned[part_joint("servo_2")] != still[part_joint("servo_2")]


def test_what_is_held_is_where_its_holder_is_and_not_where_it_was_seen(held: HeldParts) -> None:
    hold(held, 1, "platform_1", "top", "servo_1")
    seen = {part_joint("servo_1"): HERE, part_joint("box_1"): HERE}
    found = held.poses(seen, {})
    assert found[part_joint("servo_1")][:3] == [0.6, 0.22, 0.2]
    assert found[part_joint("box_1")] == HERE


def test_a_part_on_something_unknown_stays_where_it_was_seen(held: HeldParts) -> None:
    hold(held, 1, "gear_of_somebody", "top", "servo_1")
    hold(held, 2, "platform_1", "side", "servo_2")
    hold(held, 3, "tube_1", "output", "servo_3")
    seen = {part_joint("servo_1"): HERE}
    assert held.poses(seen, {}) == seen


def test_parts_that_hold_each_other_end_the_search(held: HeldParts) -> None:
    hold(held, 1, "servo_1", "output", "servo_2")
    hold(held, 2, "servo_2", "output", "servo_1")
    assert held.poses({}, {}) == {}
    seen = {part_joint("servo_1"): HERE, part_joint("servo_2"): HERE}
    assert held.poses(seen, {}).keys() == seen.keys()


def test_what_is_let_go_is_where_it_is_seen(held: HeldParts) -> None:
    hold(held, 1, "gripper", "gripper", "box_1")
    assert held.poses({part_joint("box_1"): HERE}, {})[part_joint("box_1")] != HERE
    hold(held, 1, "gripper", "gripper", "")
    assert held.poses({part_joint("box_1"): HERE}, {})[part_joint("box_1")] == HERE
