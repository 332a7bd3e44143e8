"""Examples of messages that help texts show can be sent as they are."""

from __future__ import annotations

import shlex

import pytest
from tests.helpers.command_line import jauspy
from tests.helpers.sampling import sampled

from jauspy.cli.examples import example
from jauspy.cli.fields import message_from
from jauspy.codec.registry import Hints
from jauspy.messages import registry
from jauspy.messages.manipulator import SetJointPositions
from jauspy.messages.mobility import QueryLocalPose

INPUTS = [
    each
    for entry in registry.entries
    for each in [registry.by_name(entry.name, service=entry.service, version=entry.version)]
    if each.IS_COMMAND or each.IS_QUERY
]


@pytest.mark.parametrize(
    "kind", sampled(INPUTS, 60), ids=lambda kind: f"{kind.SERVICE.rpartition(':')[2]}-{kind.NAME}-{kind.VERSION}"
)
def test_example_of_every_command_and_query_is_the_message_that_it_shows(kind):
    program, verb, target, name, *fields = example(registry, kind)
    assert (program, target, name) == ("jauspy", "ID", kind.NAME)
    assert verb == ("query" if kind.IS_QUERY else "send")
    made = message_from(registry, name, fields, Hints(kind.SERVICE, kind.VERSION))
    assert type(made).decode(made.encode()).encode() == made.encode()


def test_example_of_a_nested_message():
    assert example(registry, SetJointPositions, "101.1.104") == [
        *("jauspy", "send", "101.1.104", "SetJointPositions"),
        "joint_position_list=[{joint_position: {choice: RADIAN, value: 0.5}}]",
    ]
    assert example(registry, QueryLocalPose) == ["jauspy", "query", "ID", "QueryLocalPose"]


def test_schema_show_prints_an_example():
    shown = jauspy("schema", "show", "SetJointMotionProfile").stdout
    _, _, command = shown.partition("example:  ")
    words = shlex.split(command.replace("\\\n", " "))  # as a shell reads it
    assert words[:4] == ["jauspy", "send", "ID", "SetJointMotionProfile"]
    assert message_from(registry, "SetJointMotionProfile", words[4:]).joint_motion_profile_list
    assert "example:" not in jauspy("schema", "show", "ReportLocalPose").stdout


@pytest.mark.parametrize("verb", ["send", "query"])
def test_help_tells_where_examples_are(verb):
    assert "jauspy schema show MESSAGE" in " ".join(jauspy(verb, "--help").stdout.split())
