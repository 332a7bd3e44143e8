"""`jauspy conformance` with several targets: one report of all, in order, and on a cluster."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from tests.conformance.winch import ID, SOURCE, URN, winch
from typer.testing import CliRunner

from jauspy.capture.reader import CaptureReader
from jauspy.cli import conformance_campaign, conformance_runs
from jauspy.cli.conformance_campaign import Plan, report_for, run_campaign, ways
from jauspy.cli.conformance_runs import Target, parse_targets
from jauspy.cli.main import app
from jauspy.conformance import Settings, VirtualTarget
from jauspy.conformance.results import Report
from jauspy.conformance.runner import Interrupted
from jauspy.errors import ConfigError, TransportError

GONE = "udp://192.0.2.9"
SOME = ("--only", "Controlled.Available.Ready.Idle/PullWinch", "--only", "Controlled.Available.Ready.Locked/QueryWinch")


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[str | None]:
    """Where targets were looked for; there is a winch everywhere but at `GONE`."""
    found: list[str | None] = []

    async def open_link(connect: str | None) -> VirtualTarget:
        found.append(connect)
        if connect == GONE:
            raise TransportError("cannot send to UDP 192.0.2.9:3794: No route to host")
        return winch()

    monkeypatch.setattr(conformance_runs, "open_link", open_link)
    return found


def invoke(*arguments: object):
    return CliRunner().invoke(app, ["conformance", URN, "--schemas", str(SOURCE), *map(str, (*SOME, *arguments))])


@pytest.mark.slow
def test_report_has_all_targets_and_one_that_is_gone_does_not_end_the_others(asked, tmp_path: Path) -> None:
    files = {kind: tmp_path / f"all.{kind}" for kind in ("html", "junit", "pcapng")}
    written = [word for kind, path in files.items() for word in (f"--{kind}", path)]
    places = [f"{ID}@udp://10.0.0.1", f"{ID}@{GONE}", str(ID)]
    targets = [word for place in places for word in ("--target", place)]
    result = invoke(*targets, "--connect", "udp://10.0.0.3", "--json", *written)
    assert asked == ["udp://10.0.0.1", GONE, "udp://10.0.0.3"]
    *lines, totals = map(json.loads, result.stdout.splitlines())
    steps = [line for line in lines if "step" in line]
    assert {line["connect"] for line in steps} == {"udp://10.0.0.1", "udp://10.0.0.3"}
    assert {line["verdict"] for line in steps} == {"pass"}
    assert totals == {
        "targets": 3,
        "passed": [str(ID), str(ID)],
        "failed": [],
        "not_tested": [str(ID)],
        "verdicts": {"pass": len(steps)},
        "status": 2,
    }
    assert result.exit_code == 2
    assert "No route to host" in result.stderr
    suites = ET.fromstring(files["junit"].read_bytes())
    assert [suite.get("errors") for suite in suites] == ["0", "1", "0"]
    page = files["html"].read_text()
    assert page.count("<header") == 3
    ids = [part.split('"')[0] for part in page.split(' id="')[1:]]
    assert len(ids) == len(set(ids))
    assert all(f'href="#{number}/run"' in page for number in (1, 2, 3))
    with files["pcapng"].open("rb") as file:
        times = [datagram.time for datagram in CaptureReader(file, name="all")]
    assert len(times) > 20
    assert times == sorted(times)


def test_table_of_targets_follows_their_steps(asked) -> None:
    result = invoke("--target", f"{ID}@udp://10.0.0.1", "--target", f"{ID}@udp://10.0.0.2")
    assert result.exit_code == 0
    assert result.stdout.rstrip().splitlines()[-2:][0].startswith(str(ID))
    assert "pass" in result.stdout.rstrip().splitlines()[-1]


def test_targets_of_one_way_wait_for_each_other() -> None:
    targets = parse_targets(["101.1.102@udp://10.0.0.1", "101.1.103", "101.1.104", "102@udp://10.0.0.1"], None)
    assert [[target.id for target in group] for group in ways(targets)] == [
        ["101.1.102", "102"],
        ["101.1.103", "101.1.104"],
    ]


@pytest.mark.parametrize(
    ("texts", "reported"),
    [
        (["101.1.102", "101.1.102"], "--target 101.1.102 is given twice"),
        (["101.1.102@"], "--target 101.1.102@: write how to reach it after @, as in 101.1.102@udp://192.168.1.101"),
        (["101.1"], "'101.1' is not a JAUS id"),
        (["101.0.1"], "101.0.1 is not the id of a component"),
    ],
)
def test_wrong_targets_are_one_sentence(texts: list[str], reported: str) -> None:
    with pytest.raises(ConfigError) as caught:
        parse_targets(texts, None)
    assert reported in str(caught.value)


def test_ctrl_c_keeps_the_reports_so_far(monkeypatch: pytest.MonkeyPatch) -> None:
    def report_of_target(plan: Plan, target: Target, watch: object) -> Report:
        report = Report("p", "p", target.id, 0.0)
        if target.id == "2.1.1":
            raise Interrupted(report)
        return report

    monkeypatch.setattr(conformance_campaign, "report_for", report_of_target)
    seen: list[Report] = []
    campaign = run_campaign(
        Plan("p", Settings()),
        [Target("1.1.1"), Target("2.1.1"), Target("3.1.1")],
        None,
        on_result=lambda _, __: None,
        on_report=seen.append,
    )
    assert campaign.is_interrupted
    assert [report.target for report in campaign.reports] == ["1.1.1", "2.1.1"]
    assert seen == campaign.reports


def test_report_of_a_worker_has_what_was_decoded_there(asked) -> None:
    """Another process has not loaded the user's definitions."""
    plan = Plan(URN, Settings(only=(SOME[1],)), schemas=(str(SOURCE),))
    report = report_for(plan, Target(str(ID)), lambda _: None)
    copy = pickle.loads(pickle.dumps(report))
    assert [entry.lines for entry in copy.entries] == [entry.lines for entry in report.entries]
    assert any("PullWinch" in line for entry in copy.entries for line in entry.lines)
    assert [result.verdict for result in copy.results] == [result.verdict for result in report.results]


@pytest.mark.slow
@pytest.mark.filterwarnings("default")  # of Dask, about its own processes
def test_campaign_on_a_cluster(free_port: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody answers, which each report says."""
    pytest.importorskip("distributed", reason="needs jauspy[cell-cluster]")
    targets = [
        word
        for number in (1, 2, 3)
        for word in ("--target", f"7.1.{number}@udp://127.0.0.{number}:{free_port}", "--timeout", "0.1")
    ]
    result = CliRunner().invoke(app, ["conformance", "igvc-2015", *targets, "--cluster", "local", "--json"])
    *lines, totals = map(json.loads, result.stdout.splitlines())
    assert totals["not_tested"] == ["7.1.1", "7.1.2", "7.1.3"]
    assert all(line["traffic"] for line in lines if line.get("verdict") == "silent")
    assert result.exit_code == 2
