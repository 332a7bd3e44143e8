"""What is inferred of components from their messages, and what was known at any time of a capture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from jauspy.capture.reader import CaptureReader, Datagram
from jauspy.errors import ConfigError
from jauspy.ids import EVERYONE, JausID
from jauspy.inspection import observed as module, timeline as timeline_module
from jauspy.inspection.observed import History, Observed, Sequence
from jauspy.inspection.rates import BEYOND, Route
from jauspy.inspection.series import Series, curve, numeric_fields
from jauspy.inspection.timeline import Timeline
from jauspy.inspection.traffic import seen_messages
from jauspy.messages import registry
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Packet

OCU, OTHER, ROBOT = JausID(42, 1, 1), JausID(43, 1, 1), JausID(101, 1, 102)
CAPTURES = Path(__file__).parents[2].parent / "shared" / "captures"
ADDRESSES = ("10.0.0.1", 3794), ("10.0.0.2", 3794)


class Talk:
    """Messages one after the other, a second apart."""

    def __init__(self) -> None:
        self.datagrams: list[Datagram] = []

    def say(
        self,
        source: JausID,
        to: JausID,
        name: str,
        fields: dict[str, Any] | None = None,
        *,
        after: float = 1.0,
        **header,
    ) -> None:
        time = self.datagrams[-1].time + after if self.datagrams else 100.0
        message = registry.by_name(name).from_dict(fields or {})
        number = header.pop("sequence", len(self.datagrams) + 1)
        data = judp.pack(Packet(source, to, message.encode(), number, **header))
        self.datagrams.append(Datagram(1, time, *ADDRESSES, data))

    def observed(self) -> Observed:
        found = Observed()
        for seen in seen_messages(self.datagrams, registry):
            found.add(seen)
        return found


def status(name: str) -> dict[str, Any]:
    return {"status": name, "reserved": 0}


def controlled() -> Talk:
    talk = Talk()
    talk.say(OCU, ROBOT, "RequestControl", {"authority_code": 200})
    talk.say(ROBOT, OCU, "ConfirmControl", {"response_code": 0})
    return talk


def test_nothing_is_known_at_first() -> None:
    talk = Talk()
    talk.say(OCU, ROBOT, "QueryStatus")
    robot = talk.observed().components[ROBOT]
    assert (robot.name, robot.state, robot.control, robot.services, robot.heard) == (None,) * 5


def test_control_is_inferred_from_request_and_answer() -> None:
    talk = controlled()
    found = talk.observed()
    assert found.components[ROBOT].control == (OCU, 200, 101.0)
    assert found.controlled_by(OCU) == [ROBOT]
    talk.say(OCU, ROBOT, "SetAuthority", {"authority_code": 150})
    assert talk.observed().components[ROBOT].control == (OCU, 150, 101.0)
    talk.say(ROBOT, OCU, "RejectControl", {"response_code": 0})
    assert talk.observed().components[ROBOT].control == (None, None, 103.0)


def test_a_refused_request_changes_nothing() -> None:
    talk = controlled()
    talk.say(OTHER, ROBOT, "RequestControl", {"authority_code": 10})
    talk.say(ROBOT, OTHER, "ConfirmControl", {"response_code": 2})
    found = talk.observed().components[ROBOT]
    assert (found.control, found.requests) == ((OCU, 200, 101.0), {})


def test_reported_control() -> None:
    talk = Talk()
    fields = {"subsystem_id": 42, "node_id": 1, "component_id": 1, "authority_code": 7}
    talk.say(ROBOT, OTHER, "ReportControl", fields)
    assert talk.observed().components[ROBOT].control == (OCU, 7, 100.0)
    talk.say(ROBOT, OTHER, "ReportControl", dict.fromkeys(fields, 0))
    assert talk.observed().components[ROBOT].control == (None, None, 101.0)


def test_a_state_is_reported_or_commanded() -> None:
    talk = controlled()
    talk.say(OTHER, ROBOT, "Resume")  # of a client without control
    assert talk.observed().components[ROBOT].state is None
    talk.say(OCU, ROBOT, "Resume")
    assert talk.observed().components[ROBOT].state == ("READY", 103.0, False)
    talk.say(ROBOT, OCU, "ReportStatus", status("READY"))
    assert talk.observed().components[ROBOT].state == ("READY", 104.0, True)


def test_an_emergency_of_everyone_and_its_end() -> None:
    talk = Talk()
    talk.say(ROBOT, OCU, "ReportStatus", status("STANDBY"))
    talk.say(OCU, EVERYONE, "SetEmergency", {"emergency_code": 1})
    assert talk.observed().components[ROBOT].state == ("EMERGENCY", 101.0, False)
    talk.say(OCU, ROBOT, "ClearEmergency", {"emergency_code": 1})
    assert talk.observed().components[ROBOT].state == ("STANDBY", 102.0, False)


def test_names_and_services() -> None:
    talk = Talk()
    for kind, name in ((2, "inc1"), (3, "left"), (4, "CM-MOB\0\x7fgarbage")):
        talk.say(ROBOT, OCU, "ReportIdentification", {"query_type": kind, "type": 60001, "identification": name})
    record = {"uri": "urn:jaus:jss:core:Events", "major_version_number": 1, "minor_version_number": 1}
    talk.say(ROBOT, JausID(101, 1, 1), "RegisterServices", {"service_list": [record]})
    found = talk.observed()
    robot = found.components[ROBOT]
    assert found.names == {(101, None): "inc1", (101, 1): "left"}
    assert (robot.name, robot.type, robot.services) == ("CM-MOB", "COMPONENT", ("core:Events 1.1",))


def test_numbers_that_are_missing_resent_late_or_begin_anew() -> None:
    numbers = Sequence()
    for number in (65534, 65535, 0, 3, 3, 1):
        numbers.add(number)
    assert (numbers.missing, numbers.resent, numbers.restarts) == (1, 1, 0)
    numbers.add(30_000)
    assert (numbers.missing, numbers.restarts) == (1, 1)


def test_acknowledgements_have_numbers_of_others() -> None:
    talk = Talk()
    talk.say(ROBOT, OCU, "ReportStatus", status("READY"), sequence=1)
    talk.datagrams.append(Datagram(1, 101.0, *ADDRESSES, judp.pack(Packet(ROBOT, OCU, b"", 900, ack=Ack.ACK))))
    talk.say(ROBOT, OCU, "ReportStatus", status("READY"), sequence=2)
    assert talk.observed().components[ROBOT].sequence.missing == 0


def test_rates_are_of_whole_seconds() -> None:
    history = History()
    for tenth in range(105):
        history.add(100.0 + tenth / 10.0)
    assert history.rate(110.4) == pytest.approx(10.0)
    assert history.rate(113.0) == 5.0
    assert history.rate(500.0) == 0.0
    assert history.counts(110.4)[-3:] == [10, 10, 5]


def test_streams_of_a_component_node_and_subsystem() -> None:
    talk = controlled()
    talk.say(OTHER, JausID(101, 2, 1), "QueryStatus")
    found = talk.observed()
    names = {
        scope: [route.message for route, _ in found.streams_of(scope)] for scope in ("101.1.102", "101.1", "101", "10")
    }
    assert names["101.1.102"] == names["101.1"] == ["ConfirmControl", "RequestControl"]
    assert names["101"] == ["ConfirmControl", "QueryStatus", "RequestControl"]
    assert names["10"] == []


def test_tables_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MAX_COMPONENTS", 5)
    monkeypatch.setattr(module, "MAX_STREAMS", 4)
    monkeypatch.setattr(module, "MAX_REQUESTS", 3)
    talk = Talk()
    for number in range(1, 40):
        talk.say(JausID(number, 1, 1), ROBOT, "RequestControl", {"authority_code": 1}, after=0.001)
    found = talk.observed()
    assert len(found.components) == 5
    assert found.beyond == 35
    assert set(found.streams) - {Route(BEYOND, BEYOND, BEYOND)} == {
        Route(f"{number}.1.1", str(ROBOT), "RequestControl") for number in range(1, 5)
    }
    assert len(found.components[ROBOT].requests) == 3


def test_a_copy_stands_still() -> None:
    talk = controlled()
    found = talk.observed()
    copy = found.copy()
    talk.say(ROBOT, OCU, "ReportStatus", status("READY"))
    for seen in seen_messages(talk.datagrams, registry):
        found.add(seen)
    assert (copy.count, copy.components[ROBOT].sent, copy.components[ROBOT].state) == (2, 1, None)
    assert copy.streams[Route(str(OCU), str(ROBOT), "RequestControl")].count == 1


def long_talk() -> Talk:
    talk = controlled()
    for number in range(40):
        fields = {"x": float(number), "y": 0.0}
        talk.say(ROBOT, OCU, "ReportLocalPose", fields, after=0.5)
        talk.datagrams.append(talk.datagrams[-1]._replace(time=talk.datagrams[-1].time + 0.01))  # a copy
    return talk


def test_any_time_of_a_capture_is_as_if_read_until_then(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timeline_module, "MIN_STRIDE", 3)
    talk = long_talk()
    timeline = Timeline(talk.datagrams, registry)
    for until in range(1, len(talk.datagrams) + 1):
        expected = Talk()
        expected.datagrams = talk.datagrams[:until]
        found, wanted = timeline.at(talk.datagrams[until - 1].time), expected.observed()
        assert (found.count, found.components[ROBOT].sent) == (
            wanted.count,
            wanted.components[ROBOT].sent if ROBOT in wanted.components else 0,
        )
        assert {route: each.count for route, each in found.streams.items()} == {
            route: each.count for route, each in wanted.streams.items()
        }


def test_a_filter_lists_less_and_infers_the_same() -> None:
    timeline = Timeline(long_talk().datagrams, registry)
    timeline.index(lambda part: getattr(part.content.message, "x", 0.0) > 30.5)
    found = timeline.at(timeline.end)
    assert {route.message: each.count for route, each in found.streams.items()} == {"ReportLocalPose": 9}
    assert found.components[ROBOT].control is not None


def test_a_capture_that_is_too_long_or_empty(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timeline_module, "MAX_DATAGRAMS", 10)
    timeline = Timeline(long_talk().datagrams, registry)
    assert timeline.problem == "only the first 10 datagrams are shown"
    with pytest.raises(ConfigError, match="no JAUS datagrams"):
        Timeline([], registry)


@pytest.mark.parametrize("name", ["cop_waypoint_run_2013", "sae_management"])
def test_captures_of_others(name: str) -> None:
    path = CAPTURES / f"{name}.pcap"
    if not path.exists():
        pytest.skip("the captures are not here")
    with path.open("rb") as file:
        timeline = Timeline(CaptureReader(file, name=name), registry)
    found = timeline.at(timeline.end)
    states = {str(id): each.state.name for id, each in found.components.items() if each.state is not None}
    controls = {str(id): str(each.control.controller) for id, each in found.components.items() if each.control}
    if name == "sae_management":
        assert (states, controls) == ({"126.1.10": "STANDBY"}, {"126.1.10": "126.1.20"})
    else:
        assert (states, controls) == ({"110.1.1": "READY"}, {"110.1.1": "42.1.1"})
        assert found.names == {(42, None): "JAUS-COP", (110, None): "REVENANT"}


def test_values_of_a_field() -> None:
    talk = long_talk()
    series = Series(Route(str(ROBOT), str(OCU), "ReportLocalPose"), "x")
    for seen in seen_messages(talk.datagrams, registry):
        series.add(seen)
    assert [value for _, value in series.points] == list(range(40))
    last = list(seen_messages(talk.datagrams, registry))[-1].part.content.message
    assert last is not None
    assert {"x", "y"} <= set(numeric_fields(last))


def test_a_curve() -> None:
    rising = curve([(0.0, 0.0), (10.0, 1.0)], 0.0, 10.0, 4, 2)
    assert [len(line) for line in rising] == [4, 4]
    assert rising[0][0] == rising[1][3] == "⠀"
    assert rising[1][0] != "⠀"
    assert curve([], 0.0, 1.0, 2, 1) == ["⠀⠀"]
