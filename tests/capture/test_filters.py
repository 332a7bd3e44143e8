"""The filter language: what fits, and where errors point."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, strategies as st

from jauspy.capture.dissect import Part, dissect
from jauspy.capture.filters import MAX_LENGTH, Filter
from jauspy.codec.field_paths import leaves
from jauspy.codec.rounding import rounded_dict
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportServices, ReportStatus
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet, Priority

VERSION = "major_version_number", "minor_version_number"


def part(message, source="101.1.102", destination="42.1.2", **header) -> Part:
    packet = Packet(JausID.parse(source), JausID.parse(destination), message.encode(), 7, **header)
    return dissect(judp.pack(packet), registry).parts[0]


POSE = part(ReportLocalPose(x=9.0, y=-1.5), priority=Priority.HIGH)
STATUS = part(ReportStatus.from_dict({"status": "READY", "reserved": 0}), source="42.1.2", destination="101.1.102")
SERVICES = part(
    ReportServices.from_dict(
        {
            "node_list": [
                {
                    "node_rec": {"node_id": 1},
                    "component_list": [
                        {
                            "component_rec": {"component_id": 2, "instance_id": 1},
                            "service_list": [
                                {
                                    "uri": f"urn:jaus:jss:core:{name}",
                                    "major_version_number": 1,
                                    "minor_version_number": 0,
                                }
                                for name in ("Transport", "Events")
                            ],
                        }
                    ],
                }
            ]
        }
    )
)
PARTS = {"pose": POSE, "status": STATUS, "services": SERVICES}


def fitting(text: str) -> set[str]:
    found = Filter(text, registry)
    return {name for name, tested in PARTS.items() if found(tested)}


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("src == 101.*", {"pose", "services"}),
        ("src == 101", {"pose", "services"}),
        ("dst == *.1.2", {"pose", "services"}),
        ("src != 101.*", {"status"}),
        ("msg == ReportLocalPose", {"pose"}),
        ("msg == reportl*", {"pose"}),
        ("msg == Report* and not msg == ReportStatus", {"pose", "services"}),
        ("code == 0x4403 or code == 4002h", {"pose", "status"}),
        ("service == LocalPoseSensor", {"pose"}),
        ("service == urn:jaus:jss:mobility:*", {"pose"}),
        ("x > 8.9 and y < -1", {"pose"}),
        ("x >= 9.5", set()),
        ("x != 3", {"pose"}),
        ("x", {"pose"}),
        ("status == READY", {"status"}),
        ("status == 1", {"status"}),
        ("status in (STANDBY, 'ready')", {"status"}),
        ("uri contains EVENTS", {"services"}),
        ("node_rec.node_id == 1", {"services"}),
        ("component_rec.node_id == 1", set()),
        ("priority == high", {"pose"}),
        ("seq == 7 && size < 8", {"status"}),
        ("!(src == 101) || x == 9", {"pose", "status"}),
        ("problem", set()),
        ("msg == ReportStatus or msg == ReportLocalPose and src == 42", {"status"}),
        ("(msg == ReportStatus or msg == ReportLocalPose) and src == 101", {"pose"}),
    ],
)
def test_what_fits(text: str, names: set[str]) -> None:
    assert fitting(text) == names


def test_unequal_needs_a_value_of_which_none_fits() -> None:
    assert fitting("uri != urn:jaus:jss:core:Events") == set()
    assert fitting("uri != urn:jaus:jss:core:Liveness") == {"services"}


@pytest.mark.parametrize(
    ("text", "character", "problem"),
    [
        ("x >", 4, "it ends where a value"),
        ("(x > 1", 7, "a closing parenthesis"),
        ("x = 1", 3, "a comparison"),
        ("velocity_q > 1", 1, "no message has a field 'velocity_q'; did you mean 'velocity_z'?"),
        ("x > 1 and msg == SetWrnch", 18, "did you mean SetWrenchEffort?"),
        ("src == 1.2.3.4", 8, "is no id"),
        ("src == gate", 8, "is no id"),
        ("x < fast", 5, "< needs a number"),
        (f"size < 0x{'f' * 300}", 8, "too large"),
        ("x == 1 y == 2", 8, "and, or"),
        ("é == 1", 1, "a name"),
    ],
)
def test_an_error_points_at_its_character(text: str, character: int, problem: str) -> None:
    with pytest.raises(ConfigError, match=re.escape(problem)) as caught:
        Filter(text, registry)
    first, _, mark = str(caught.value).split("\n")
    assert f"at character {character}:" in first
    assert mark == " " * (character + 1) + "^"


def test_bounds() -> None:
    for text, problem in (
        (" ", "the filter is empty"),
        ("x" * (MAX_LENGTH + 1), "is the limit"),
        ("(" * 60 + "x" + ")" * 60, "more than 50"),
        ("not " * 60 + "x", "more than 50"),
    ):
        with pytest.raises(ConfigError, match=problem):
            Filter(text, registry)


@given(st.text(alphabet="srcdmgx.*123 ()=!<>'\"andornticos,-_\n\x1b", max_size=60))
def test_any_text_is_a_filter_or_one_error(text: str) -> None:
    problem = ""
    try:
        found = Filter(text, registry)
        results = {found(tested) for tested in PARTS.values()}
    except ConfigError as error:
        problem, results = str(error), set()
    assert "\x1b" not in problem
    assert results <= {True, False}
    assert bool(results) is not bool(problem)


def test_an_element_of_a_list_is_named_by_its_number() -> None:
    services = "node_list[0].component_list[0].service_list"
    assert fitting(f"{services}[1].uri contains Events") == {"services"}
    assert fitting(f"{services}[0].uri contains Events") == set()
    assert fitting("service_list[1].uri contains Events and node_list.node_rec.node_id == 1") == {"services"}
    with pytest.raises(ConfigError, match=r"no message has a field 'urn_'"):
        Filter("service_list[1].urn_ == 1", registry)
    with pytest.raises(ConfigError, match="at character"):
        Filter("service_list[x].uri == 1", registry)


def test_a_filter_takes_every_path_that_tables_have() -> None:
    for tested in PARTS.values():
        assert tested.content.message is not None
        for path, value in leaves(rounded_dict(tested.content.message)):
            assert Filter(f"{path} == '{value}'" if isinstance(value, str) else f"{path} == {value}", registry)(tested)
