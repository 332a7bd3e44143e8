"""Targets that send without end: what is kept is bounded and counted, and verdicts do not depend on it."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import pytest
from tests.conformance.scripted import ScriptedLink
from tests.conformance.simulated import examined, robot
from tests.conformance.test_endings import COP, READY, STATUS, dying, steps, verdicts

from jauspy.conformance import Verdict, run, tell, tester, trace
from jauspy.conformance.link import Arrival
from jauspy.conformance.reports import junit, page, result_json, summary_json
from jauspy.ids import JausID
from jauspy.messages.core import Standby
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

PULSE = bytes.fromhex("0242")
EVENT_STEPS = tuple(
    f"NotControlled.Available.Standby/{each}"
    for each in ("CreateEvent", "UpdateEvent", "CancelEvent", "CreateCommandEvent", "EventOccurred")
)


@pytest.fixture
def nothing_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if what came before had filled the record."""
    monkeypatch.setattr(trace, "MAX_ENTRIES", 0)
    monkeypatch.setattr(trace, "MAX_STEP_ENTRIES_WHEN_FULL", 0)


@pytest.mark.parametrize(("profile", "only"), [("core-1.1", EVENT_STEPS), ("transport", ())])
def test_verdicts_do_not_depend_on_the_trace(profile, only, nothing_kept):
    report = examined(profile, robot(timeout=5, component=1, tick=None), JausID(105, 1, 1), only=only)
    assert report.counts[Verdict.PASS] > 10
    assert [f"{each.id}: {each.reason}" for each in report.failures] == []
    assert report.entries == ()


def test_dead_target_is_detected_without_the_trace(nothing_kept):
    link = ScriptedLink("101.1.1", dying(after=1))
    report = run(steps(STATUS, STATUS, tell(COP, Standby()), *[STATUS] * 9), link, link.id, began=0.0)
    assert verdicts(report) == [Verdict.PASS, *[Verdict.SILENT] * 3, *[Verdict.SKIPPED] * 8]


def flooding(payload):
    """The right answer, and then much that nobody has asked for."""
    return [(0.01, READY), *((0.02, PULSE) for _ in range(500))]


def test_omitted_datagrams_are_counted_in_every_report(monkeypatch):
    monkeypatch.setattr(trace, "MAX_STEP_ENTRIES", 20)
    link = ScriptedLink("101.1.1", flooding)
    wait = steps(STATUS, lambda at: at.wait(0.1), STATUS)
    report = run(wait, link, link.id, began=0.0)
    assert [(len(each.entries), each.omitted) for each in report.results] == [(2, 0), (20, 480), (2, 0)]
    assert "480 datagrams of this step were too many to keep" in page(report)
    assert result_json(report.results[1])["left_out"] == 480
    (suite,) = ET.fromstring(junit(report))
    assert "480 datagrams of this step were too many to keep" in suite.findall("testcase")[1].findtext("system-out")
    (note,) = summary_json(report)["notes"]
    assert note == "480 datagrams were too many to keep for the report; no verdict depends on that"
    assert note in page(report)
    assert [each.attrib for each in suite.iter("property")] == [{"name": "note", "value": note}]


def test_full_trace_still_has_the_first_datagrams_of_each_step(monkeypatch):
    monkeypatch.setattr(trace, "MAX_ENTRIES", 10)
    monkeypatch.setattr(trace, "MAX_STEP_ENTRIES_WHEN_FULL", 5)
    link = ScriptedLink("101.1.1", flooding)
    report = run(steps(*[lambda at: (STATUS(at), at.wait(0.1))] * 3), link, link.id, began=0.0)
    assert [len(each.entries) for each in report.results] == [10, 5, 5]


def test_dropped_pending_messages_are_counted():
    def much(payload):
        return [(0.02, PULSE) for _ in range(1500)]

    link = ScriptedLink("101.1.1", much)

    def quiet(at):
        at.client(COP).send(Standby())
        at.wait(0.1)

    report = run(steps(quiet), link, link.id, began=0.0)
    assert report.notes == ("476 messages were dropped before a step read them: more arrived than a client holds",)


class Endless(ScriptedLink):
    """Once asked, there is always one more datagram."""

    def receive(self, until):
        pulse = judp.pack(Packet(self.id, JausID(42, 1, 1), PULSE, 1))
        return super().receive(until) or (Arrival(pulse) if self.sent else None)


def test_flood_faster_than_the_test_ends_the_run(monkeypatch):
    monkeypatch.setattr(tester, "MAX_BEHIND", 500)
    link = Endless("101.1.1", lambda _: [])
    report = run(steps(tell(COP, Standby()), STATUS), link, link.id, began=0.0)
    assert report.status == 2
    assert report.problem.startswith("datagrams come faster than they can be read")
    assert verdicts(report) == [Verdict.FAIL]
