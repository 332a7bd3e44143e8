"""A run as JSON, JUnit, HTML and pcapng."""

from __future__ import annotations

import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree as ET

import dpkt
import pytest
from dpkt.ip import IP
from tests.conformance.scripted import ScriptedLink

import jauspy
from jauspy.capture.reader import CaptureReader
from jauspy.cli.conformance import ReportFiles, show
from jauspy.conformance import Profile, Step, Verdict, ask, has, run
from jauspy.conformance.reports import capture, junit, page, result_json, summary, summary_json
from jauspy.conformance.results import DEPENDS_ON_TARGET, Report, Result, TransitionResult
from jauspy.errors import ConfigError
from jauspy.messages.core import QueryIdentification, QueryStatus, ReportIdentification, ReportStatus

VENDOR = Path(__file__).parents[1] / "vendor" / "Gate.xml"
NAME = b"<b>\x01\x9f&"
ANSWERS = {
    0x2002: bytes.fromhex("02400200000000"),
    0x2B00: bytes.fromhex("004b041127") + bytes([len(NAME)]) + NAME,
}


@pytest.fixture(scope="module")
def report():
    link = ScriptedLink("101.1.1", lambda payload: [(0.1, ANSWERS[int.from_bytes(payload[:2], "little")])])
    status = ask("42.1.1", QueryStatus(), ReportStatus, has(status=ReportStatus.Status.READY))
    steps = (
        Step("1", "who", ask("42.1.1", QueryIdentification(4), ReportIdentification), points=1),
        Step("2", "<ready>", status, points=1),
        Step("3", "skipped", status, points=1, wants=frozenset({"telepathy"})),
    )
    return run(Profile("mine", "a <profile>", steps), link, link.id, began=1_700_000_000.0)


def test_json(report):
    lines = [json.loads(json.dumps(result_json(each))) for each in report.results]
    assert [each["verdict"] for each in lines] == ["pass", "fail", "skipped"]
    sent, received = lines[1]["traffic"]
    assert sent["direction"] == "sent"
    assert received["hex"].endswith("02400200000000" + "0100")
    assert "ReportStatus(status=<Status.STANDBY: 2>" in received["decoded"][0]
    assert summary_json(report) | {"seconds": 0} == {
        "profile": "mine",
        "target": "101.1.1",
        "began": 1_700_000_000.0,
        "seconds": 0,
        "verdicts": {"pass": 1, "fail": 1, "skipped": 1},
        "points": 1,
        "of": 3,
        "problem": "",
        "transitions": {"declared": 0, "taken": 0, "left": []},
        "notes": [],
        "status": 1,
    }


def test_junit(report):
    suites = ET.fromstring(junit(report))
    assert suites.tag == "testsuites"
    (suite,) = suites
    assert suite.attrib | {"time": ""} == {
        "name": "mine",
        "tests": "3",
        "failures": "1",
        "errors": "0",
        "skipped": "1",
        "time": "",
        "timestamp": "2023-11-14T22:13:20",
        "hostname": "101.1.1",
    }
    failure = suite[1].find("failure")
    assert failure is not None
    assert failure.get("type") == "fail"
    assert "status is 2 STANDBY" in failure.get("message", "")
    assert "from: urn:jaus:jss:core:Management 1.1: QueryStatus 2002h" in (failure.text or "")
    assert suite[2].find("skipped") is not None


class Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict]] = []
        self.text = ""

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        if tag not in ("meta", "input", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


def test_the_failed_check_and_what_came_are_in_every_report(report, capsys):
    name = "ReportStatus 4002h has status 1 READY"
    problem = "status is 2 STANDBY, not 1 READY"
    came = "101.1.1 to 42.1.1: 4002h ReportStatus(status=<Status.STANDBY: 2>, reserved=0)"
    step = report.results[1]
    assert result_json(step)["failed"] == [name]
    assert result_json(step)["came"] == [came]
    failure = ET.fromstring(junit(report)).find(".//failure")
    assert f"failed check: {name}: {problem}\ncame: {came}" in failure.text
    html = re.sub("&lt;", "<", re.sub("&gt;", ">", page(report)))
    assert f"{name}: {problem}" in html
    assert f"Came: {came}" in html
    show(report)
    text = capsys.readouterr().out
    assert f"failed check: {name}: {problem}" in text
    assert f"came: {came}" in text


def test_messages_of_a_vendor_are_decoded_in_the_report():
    known = jauspy.load(VENDOR)
    answer = known.by_name("ReportGate")(opening=55)
    link = ScriptedLink("101.1.1", lambda payload: [(0.1, answer.encode())])
    wrong = ask("42.1.1", known.by_name("QueryGate")(), type(answer), has(opening=100))
    report = run(Profile("mine", "mine", (Step("1", "gate", wrong),)), link, link.id, began=0.0, registry=known)
    (result,) = report.results
    assert [each.name for each in result.failed_checks] == [f"ReportGate {answer.CODE:04X}h has opening 100"]
    assert "ReportGate(opening=55" in result.came[0]


def test_html_is_complete_escaped_and_self_contained(report):
    text = page(report)
    parsed = Page()
    parsed.feed(text)
    assert parsed.open == []
    assert not re.search(r"https?:|url\(|@import|<script|<link|<img", text)
    assert not {"b", "ready", "profile"} & {tag for tag, _ in parsed.tags}
    assert "<ready>" in parsed.text
    assert "status is 2 STANDBY, not 1 READY" in parsed.text
    steps = [attributes for tag, attributes in parsed.tags if tag == "details"]
    assert ["open" in each for each in steps] == [False, True, False]
    assert [each["id"] for each in steps] == ["1", "2", "3"]
    assert [dict(each)["href"] for tag, each in parsed.tags if tag == "a"] == ["#2"]
    assert "Expected: ReportStatus 4002h and has status 1 READY" in parsed.text
    assert summary(report) == "1 pass, 1 fail, 1 skipped; 1 of 3 points"


def test_html_without_jinja2_names_the_extra(report, monkeypatch):
    monkeypatch.setitem(sys.modules, "jinja2", None)
    with pytest.raises(ConfigError, match=r"HTML reports need Jinja2: pip install 'jauspy\[conformance\]'"):
        page(report)
    with pytest.raises(ConfigError, match="Jinja2"):
        ReportFiles(html=Path("report.html"))


def test_pcapng(report, tmp_path):
    path = tmp_path / "run.pcapng"
    path.write_bytes(capture(report))
    with path.open("rb") as file:
        datagrams = list(CaptureReader(file, name=path.name))
    assert [each.payload for each in datagrams] == [each.data for each in report.entries]
    with path.open("rb") as file:  # as another program reads it
        others = [IP(data).data for _, data in dpkt.pcapng.Reader(file)]
    assert [bytes(each.data) for each in others] == [each.data for each in report.entries]
    assert {(each.sport, each.dport) for each in others} == {(3794, 3794)}
    assert [round(each.time - 1_700_000_000.0, 3) for each in datagrams] == [0.0, 0.1, 0.1, 0.2]


def test_transitions_are_counted_and_untested_ones_have_a_reason():
    reset, failure = "Management, Ready: Reset", "Management, Ready: Failure"
    query, create = "Events, Ready: Query [known(msg)]", "Events, Ready: CreateEvent [!supported(msg)]"
    results = (
        Result("a", "skipped", Verdict.SKIPPED, "it comes from inside", transitions=(failure, reset)),
        Result("b", "tried", Verdict.FAIL, "wrong", transitions=(reset, query), taken=(reset,)),
        Result("c", "again", Verdict.PASS, transitions=(reset, create), taken=(reset,)),
    )
    report = Report("p", "t", "1.1.1", 0.0, results=results)
    assert report.transitions == (
        TransitionResult(failure, reason="it comes from inside"),
        TransitionResult(reset, "b"),
        TransitionResult(query, reason="wrong"),
        TransitionResult(create, reason=DEPENDS_ON_TARGET),
    )
    total = "1 of 4 state machine transitions in these steps were taken and judged"
    assert summary_json(report)["transitions"] == {
        "declared": 4,
        "taken": 1,
        "left": [
            {"transition": failure, "reason": "it comes from inside"},
            {"transition": query, "reason": "wrong"},
            {"transition": create, "reason": DEPENDS_ON_TARGET},
        ],
    }
    assert f"{total}</summary><ul><li>Management, Ready: Failure: it comes from inside</li>" in page(report)
    (suite,) = ET.fromstring(junit(report))
    assert [each.attrib for each in suite.iter("property")] == [{"name": "transitions", "value": total}]


def test_impossible_run_is_an_error():
    deaf = ScriptedLink("101.1.1", lambda _: [])
    report = run(
        Profile("p", "t", (Step("1", "x", ask("42.1.1", QueryStatus(), ReportStatus)),)), deaf, deaf.id, began=0.0
    )
    assert report.results[0].verdict is Verdict.SILENT
    (suite,) = ET.fromstring(junit(report))
    assert suite.get("errors") == "1"
    assert "answers nothing" in page(report)
