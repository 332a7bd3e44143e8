"""`field=value` of the command line, and fields on paper."""

from __future__ import annotations

import math
import shlex
from random import Random

import pytest
import yaml
from tests.helpers.command_line import jauspy
from tests.helpers.sampling import sampled

from jauspy.cli import fields
from jauspy.cli.fields import describe, example, message_from
from jauspy.cli.render import field_lines
from jauspy.codec.names import members
from jauspy.codec.registry import Hints
from jauspy.errors import ConfigError
from jauspy.messages import registry
from jauspy.messages.manipulator import SetJointPositions
from jauspy.messages.mobility import QueryLocalPose
from jauspy.schema import load_builtin, model as m


def build(name, *assignments):
    return message_from(registry, name, assignments)


@pytest.mark.parametrize("text", ["12.5", "1.25e1", "+12.5", " 12.5"])
def test_numbers_are_parsed(text):
    assert build("SetWrenchEffort", f"propulsive_linear_effort_x={text}").propulsive_linear_effort_x == 12.5


@pytest.mark.parametrize("text", ["0x43", "67", "0b1000011"])
def test_integers_are_parsed(text):
    assert build("querylocalpose", f"presence_vector={text}").presence_vector == 67


@pytest.mark.parametrize(
    "text",
    [
        *("EVERY_CHANGE", "every change", "Every-Change", "1", "1 Every change"),
        *("EventType.EVERY_CHANGE", "CreateEvent.EventType.EVERY_CHANGE", "<EventType.EVERY_CHANGE: 1>"),
    ],
)
def test_enumerations_are_parsed_by_name_and_number(text):
    message = build(
        "CreateEvent", "request_id=1", f"event_type={text}", "requested_periodic_rate=0", "query_message=0220"
    )
    assert message.event_type.name == "EVERY_CHANGE"


def test_names_of_enumerations_inside_lists_are_parsed():
    kind = registry.by_name("RegisterServices").layout().slots[0].item
    assert fields._with_names(kind, [{"uri": "urn:a", "unknown": "1 x"}, 3]) == [{"uri": "urn:a", "unknown": "1 x"}, 3]
    query = build(
        "QueryVisualSensorCapabilities",
        "query_visual_sensor_capabilities_list=[{sensor_id: all sensors, query_presence_vector: 0}]",
    )
    assert query.query_visual_sensor_capabilities_list[0].sensor_id.name == "ALL_SENSORS"


def names_of_enumerations(node):
    if isinstance(node, m.FixedField):
        yield [(each.value, each.name) for each in node.values.enums] if node.values else []
    for each in (*(getattr(node, "fields", ())), *(getattr(node, "items", ())), *(getattr(node, "arms", ()))):
        yield from names_of_enumerations(each)
    if hasattr(node, "element"):
        yield from names_of_enumerations(node.element)


def test_every_name_that_schema_show_prints_is_parsed():
    bodies = [message.body for service in load_builtin().services for message in service.messages]
    sets = [listed for body in bodies for listed in names_of_enumerations(body) if listed]
    assert len(sets) > 300
    for listed in sets:
        known = members(listed)
        for value, name in listed:
            assert known[fields._enumerated(name)] == value == fields._enumerated(f"{value} {name}")


def test_nested_message_is_given_as_mapping():
    message = build(
        "CreateEvent",
        "request_id=1",
        "event_type=PERIODIC",
        "requested_periodic_rate=10",
        "query_message={message: QueryStatus}",
    )
    assert message.query_message.encode() == b"\x02\x20"


def test_dotted_paths_set_nested_fields():
    by_dots = build(
        "SetTime", *(f"time_stamp.{name}=1" for name in ("milliseconds", "seconds", "minutes", "hour", "day"))
    )
    assert by_dots == build("SetTime", "time_stamp={milliseconds: 1, seconds: 1, minutes: 1, hour: 1, day: 1}")


def test_omitted_bits_are_0_and_names_need_no_quotes():
    short = build("SetIlluminationState", "illumination={headlights: ON, fog_lights: OFF, variable_light1: 3}")
    assert short == build("SetIlluminationState", "illumination.headlights=ON", "illumination.variable_light1=3")
    assert short.encode()[2:] == b"\x01\x03\x00\x00"
    (words,) = (each for each in fields.example(registry, type(short)) if "headlights" in each)
    assert "headlights: OFF, left_turn_signal: OFF" in words
    with pytest.raises(ConfigError, match=r"time_stamp\.day: a value is required"):
        build("SetTime", "time_stamp.hour=1")


def test_omitted_presence_vector_requests_all_fields():
    assert build("QueryLocalPose").presence_vector == 0x1FF


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["SetWrenchEfort"], "did you mean SetWrenchEffort"),
        (["SetWrenchEffort", "propulsive_linear_x=1"], "did you mean 'propulsive_linear_effort_x'"),
        (["SetWrenchEffort", "propulsive_linear_effort_x=500"], r"500.* is outside -100.*percent"),
        (["SetWrenchEffort", "propulsive_linear_effort_x=fast"], "'fast' is not a number"),
        (["SetWrenchEffort", "x"], "'x' is not FIELD=VALUE"),
        (["CreateEvent"], r"request_id: a value is required"),
        (["QueryStatus", "x=1"], "QueryStatus has no fields"),
        (["SetTime", "time_stamp=[1"], "neither a number, a name, nor JSON or YAML"),
        (["SetTime", "time_stamp=1", "time_stamp.day=1"], "set twice"),
        (["SetTime", "time_stamp.day=1", "time_stamp={day: 1}"], "set twice"),
        (["QueryLocalPose", "presence_vector=3", "presence_vector=4"], "'presence_vector' is set twice"),
    ],
)
def test_invalid_values_raise_a_config_error(arguments, what):
    with pytest.raises(ConfigError, match=what):
        build(*arguments)


def test_unknown_field_error_lists_fields_with_units():
    with pytest.raises(ConfigError) as caught:
        build("SetWrenchEffort", "nonsense=1")
    assert "\n  resistive_linear_effort_x       0..100 %, optional\n" in str(caught.value)


@pytest.mark.slow
def test_all_messages_can_be_described_and_rendered():
    for cls in registry:
        assert cls.NAME in describe(cls)
        message, _ = cls.decode(cls.CODE.to_bytes(2, "little") + bytes(200), strict=False)
        text = "\n".join(line.plain for line in field_lines(message, yaml=True))
        data = yaml.safe_load(text) or {}
        assert list(data) == list(message.to_dict())


def test_values_have_the_decimals_of_their_resolution():
    message = registry.by_name("ReportLocalPose")(x=2.0, yaw=math.pi / 2)
    message = type(message).decode(message.encode())
    assert [line.plain for line in field_lines(message)] == ["x: 2 m", "yaw: 1.5708 rad"]


@pytest.mark.slow
def test_text_and_json_show_the_same_values():
    random = Random(1)
    for cls in registry:
        for size in (0, 3, 20, 150):
            data = bytes(random.choice((0, 1, 2, 3, random.randrange(256))) for _ in range(size))
            incomplete, _ = cls.decode(cls.CODE.to_bytes(2, "little") + data, strict=False)
            message, _ = cls.decode(incomplete.encode(strict=False), strict=False)
            text = "\n".join(line.plain for line in field_lines(message, yaml=True))
            assert is_same(yaml.load(text, yaml.BaseLoader) or {}, message.to_dict()), (cls.NAME, data.hex())


def is_same(shown, expected):
    """True if values of YAML are those of JSON: numbers in the decimals of their resolution, messages by their name."""
    if isinstance(expected, dict):
        names = expected.keys() - ({"service", "version"} if "message" in expected else set())
        return shown.keys() == names and all(is_same(shown[name], expected[name]) for name in names)
    if isinstance(expected, list):
        return len(shown) == len(expected) and all(map(is_same, shown, expected))
    if isinstance(expected, str):
        is_float = shown in {".nan", ".inf", "-.inf"}
        return (shown.replace(".", "") if is_float else shown) == (expected.partition(":")[0] if is_float else expected)
    number = int(shown, 16) if shown.startswith("0x") else float(shown)
    return math.isclose(number, expected, rel_tol=1e-6, abs_tol=0.5)


@pytest.mark.parametrize("data", ["2304000100", "23040001000200"])
def test_lists_that_contain_nothing_are_shown(data):
    message, _ = registry.decode(bytes.fromhex(data), strict=False)
    text = "\n".join(line.plain for line in field_lines(message, yaml=True))
    assert "- []" in text
    assert list(yaml.safe_load(text)) == list(message.to_dict())


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
