"""Paths of fields: one notation in messages, their JSON form, tables, replays and filters."""

from __future__ import annotations

import re

import pytest

from jauspy.cli.fields import example, message_from
from jauspy.codec.field_paths import leaves, path_pattern, without_numbers
from jauspy.messages import registry
from jauspy.messages.manipulator import JointPositionRec, ReportJointPositions

RADIAN = JointPositionRec.JointPositionChoice(1)


def joints(*angles: float) -> ReportJointPositions:
    kind = JointPositionRec.JointPosition
    return ReportJointPositions([JointPositionRec(joint_position=kind(RADIAN, angle)) for angle in angles])


def test_names_are_joined_by_dots_and_elements_have_numbers_in_brackets() -> None:
    value = {"a": [1, {"b": True}], "c": None, "d": {"e": "x"}, "f": [[2], [3]], "g": []}
    assert dict(leaves(value)) == {"a[0]": 1, "a[1].b": True, "d.e": "x", "f[0][0]": 2, "f[1][0]": 3}
    assert dict(leaves(None)) == {}


def test_a_message_and_its_json_form_have_the_same_paths() -> None:
    message = joints(0.5, -0.25)
    paths = [path for path, _ in leaves(message)]
    assert paths == [path for path, _ in leaves(message.to_dict())]
    assert paths[2:] == ["joint_position_list[1].joint_position.choice", "joint_position_list[1].joint_position.value"]
    assert dict(leaves(message))["joint_position_list[0].joint_position.choice"] is RADIAN
    assert dict(leaves(message.to_dict()))["joint_position_list[0].joint_position.choice"] == RADIAN.name


@pytest.mark.parametrize(
    "name", ["ConfirmSensorConfiguration", "SetJointMotionProfile", "ReportManipulatorSpecifications"]
)
def test_an_alternative_of_a_variant_has_its_name(name: str) -> None:
    kind = registry.by_name(name)
    message = message_from(registry, name, example(registry, kind)[4:])
    paths = {path for path, _ in leaves(message)}
    assert paths == {path for path, _ in leaves(message.to_dict())}
    assert any(re.search(r"\.\w+_rec\.", path) for path in paths)


@pytest.mark.parametrize(
    ("end", "fits"),
    [
        ("value", True),
        ("joint_position.value", True),
        ("joint_position_list.joint_position.value", True),
        ("joint_position_list[1].joint_position.value", True),
        ("joint_position_list[0].joint_position.value", False),
        ("position.value", False),
        ("joint_position", False),
        ("value[0]", False),
        ("", False),
        (".*", False),
    ],
)
def test_a_pattern_finds_the_last_names_with_or_without_numbers(end: str, fits: bool) -> None:
    path = "joint_position_list[1].joint_position.value"
    assert bool(path_pattern(end).search(path)) is fits


def test_numbers_are_removed() -> None:
    assert without_numbers("a[0][12].b.c[3]") == "a.b.c"
