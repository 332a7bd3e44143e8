"""What a target does, and the verdict that it gets."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from tests.conformance.scripted import ScriptedLink
from tests.conformance.simulated import examined, robot
from typer.testing import CliRunner

import jauspy
from jauspy.cli.main import app
from jauspy.conformance import Profile, Settings, Skipped, Step, Verdict, ask, has, run, tell
from jauspy.conformance.results import Report, worst
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportStatus

LAMP = Path(__file__).parents[1] / "vendor" / "Lamp.xml"
READY = bytes.fromhex("02400100000000")
STANDBY = bytes.fromhex("02400200000000")
SHORT = bytes.fromhex("0240010000")
PULSE = bytes.fromhex("0242")
EVENT = bytes.fromhex("f14101000200000002420000")
ASK = Step("1", "ready", ask("42.1.1", QueryStatus(), ReportStatus, has(status=ReportStatus.Status.READY)), points=2)


def outcome(*answers: tuple[float, bytes], step: Step = ASK, target: str = "101.1.1", **settings: object) -> Report:
    link = ScriptedLink("101.1.1", lambda _: answers)
    return run(Profile("p", "title", (step,)), link, JausID.parse(target), began=0.0, settings=Settings(**settings))


@pytest.mark.parametrize(
    ("answers", "verdict", "reason"),
    [
        ([(0.1, READY)], Verdict.PASS, ""),
        ([(1.4, READY)], Verdict.PASS, ""),
        ([(2.0, READY)], Verdict.LATE, "ReportStatus 4002h came 0.50 s after the deadline of 1.5 s"),
        ([(0.1, STANDBY)], Verdict.FAIL, "status is 2 STANDBY, not 1 READY"),
        ([(0.1, STANDBY), (0.2, READY)], Verdict.FAIL, "status is 2 STANDBY"),
        ([(0.1, SHORT)], Verdict.MALFORMED, "ReportStatus 4002h from 101.1.1 is malformed: byte 3: reserved"),
        ([(0.1, READY + b"\0")], Verdict.MALFORMED, "is malformed"),
        ([], Verdict.SILENT, "no ReportStatus 4002h came in 3 s"),
        ([(3.1, READY)], Verdict.SILENT, "no ReportStatus 4002h came in 3 s"),
        ([(0.1, PULSE)], Verdict.FAIL, "no ReportStatus 4002h came, but ReportHeartbeatPulse 4202h"),
        ([(0.1, EVENT)], Verdict.SILENT, "no ReportStatus"),
    ],
)
def test_answers_get_the_right_verdict(answers, verdict, reason):
    (result,) = outcome(*answers).results
    assert result.verdict is verdict
    assert reason in result.reason
    assert result.earned == (2 if verdict is Verdict.PASS else 0)


def test_with_a_wildcard_one_right_answer_is_enough():
    (result,) = outcome((0.1, STANDBY), (0.2, READY), target="101.1.255").results
    assert result.verdict is Verdict.PASS


def test_answers_of_other_components_are_ignored():
    (result,) = outcome((0.1, READY), target="101.1.2").results
    assert result.verdict is Verdict.SILENT
    assert result.reason == "no ReportStatus 4002h came from 101.1.2 to 42.1.1, but one from 101.1.1 to 42.1.1"


def test_queried_component_must_answer():
    asked = ask("42.1.1", QueryStatus(), ReportStatus, to=JausID(101, 1, 2))
    (result,) = outcome((0.1, READY), step=Step("1", "x", asked), target="101.1.255").results
    assert result.reason == "no ReportStatus 4002h came from 101.1.2 to 42.1.1, but one from 101.1.1 to 42.1.1"


@pytest.mark.parametrize("delay", [1.6, 2.9, 3.1, 3.5, 4.0, 4.4, 5.0, 5.5, 6.0, 7.0, 8.0])
def test_late_answer_is_not_used_for_the_next_query(delay):
    delays = [0.1]

    def script(payload: bytes) -> list[tuple[float, bytes]]:
        return [(delays.pop() if delays else delay, READY)] if payload[:2] == b"\x02\x20" else []

    link = ScriptedLink("101.1.1", script)
    steps = tuple(Step(str(number), "ready", ASK.run) for number in range(6))
    report = run(Profile("p", "t", steps), link, link.id, began=0.0)
    assert [each.verdict for each in report.results[:2]] == [
        Verdict.PASS,
        Verdict.LATE if delay < 3.0 else Verdict.SILENT,
    ]
    assert report.counts[Verdict.PASS] == 1


@pytest.mark.parametrize(("answer", "verdict"), [("03d032", Verdict.PASS), ("03d0", Verdict.MALFORMED)])
def test_steps_support_vendor_services(answer, verdict):
    lamps = jauspy.load(LAMP)
    asked = ask("42.1.1", lamps.by_name("QueryLamp")(), lamps.by_name("ReportLamp"), has(brightness=50))
    (result,) = outcome((0.1, bytes.fromhex(answer)), step=Step("1", "lamp", asked)).results
    assert result.verdict is verdict, result.reason


def test_answer_to_a_command_fails():
    step = Step("1", "quiet", tell("42.1.1", QueryStatus()))
    assert outcome(step=step).results[0].verdict is Verdict.PASS
    (result,) = outcome((0.01, READY), step=step).results
    assert result.reason == "ReportStatus 4002h came, where nothing should"


def test_result_has_source_and_checks():
    (result,) = outcome((0.1, READY)).results
    assert result.why == "urn:jaus:jss:core:Management 1.1: QueryStatus 2002h"
    assert result.expected == ("ReportStatus 4002h and has status 1 READY",)
    assert [each.name for each in result.checks] == [
        "ReportStatus 4002h comes",
        "ReportStatus 4002h is as its definition says",
        "ReportStatus 4002h has status 1 READY",
        "ReportStatus 4002h comes in time",
    ]
    assert [str(each.direction) for each in result.entries] == [">", "<"]


def test_status_of_a_run():
    assert outcome((0.1, READY)).status == 0
    assert outcome((0.1, STANDBY)).status == 1
    deaf = outcome()
    assert deaf.status == 2
    assert "101.1.1 answers nothing" in deaf.problem
    assert worst([]) == 2
    assert worst([deaf, outcome((0.1, STANDBY)), outcome((0.1, READY))]) == 1


def test_run_without_executed_steps_is_no_success():
    def skip(_):
        raise Skipped("no such service")

    assert outcome(step=Step("1", "x", skip)).status == 2
    moving = outcome((0.1, READY), step=Step("1", "x", ASK.run, moves=True), motion=False)
    assert moving.results[0].reason == "it moves the robot, and --no-motion was given"
    assert moving.status == 2


def test_waiting_times_scale_with_the_timeout():
    assert outcome((2.0, READY), timeout=3.0).results[0].verdict is Verdict.PASS
    assert outcome((0.2, READY), timeout=0.15).results[0].verdict is Verdict.LATE


def test_only_selected_steps_run():
    assert outcome((0.1, READY), only=("1",)).counts[Verdict.PASS] == 1
    assert outcome((0.1, READY), only=("7",)).problem == "no step begins with 7; they begin with 1"


def test_generated_step_ids_contain_states():
    report = examined("core-1.1", robot(component=1, tick=None), JausID(105, 1, 1), only=("Standby",))
    assert report.problem == (
        "no step begins with Standby; they begin with table, NotControlled.Available.Standby, "
        "Controlled.Available.Standby, NotControlled.NotAvailable.Emergency, Controlled.Available.Ready, "
        "Controlled.NotAvailable.Emergency, NotControlled.NotAvailable.Shutdown, untried"
    )


def test_missing_feature_skips_a_step():
    link = ScriptedLink("101.1.1", lambda _: [(0.1, READY)])
    link.features = ()
    steps = (Step("0", "x", ASK.run, wants=frozenset({"raw"})), ASK)
    report = run(Profile("p", "t", steps), link, link.id, began=0.0)
    assert [each.verdict for each in report.results] == [Verdict.SKIPPED, Verdict.PASS]
    assert "(raw)" in report.results[0].reason


def test_duplicate_step_ids_are_rejected():
    link = ScriptedLink("101.1.1", lambda _: [(0.1, READY)])
    report = run(Profile("mine", "t", (ASK, ASK)), link, link.id, began=0.0)
    assert report.status == 2
    assert report.problem == "conformance profile 'mine' has two steps '1'; ids must be unique"


def test_unknown_profiles_are_named():
    from jauspy.conformance import find

    with pytest.raises(ConfigError, match="no conformance profile 'x'; there are: "):
        find("x")


def test_profiles_of_other_packages(monkeypatch):
    from importlib.metadata import EntryPoint

    from jauspy.conformance import find, known, profile

    mine = EntryPoint("mine", "tests.conformance.test_verdicts:MINE", profile.GROUP)
    wrong = EntryPoint("wrong", "tests.conformance.test_verdicts:READY", profile.GROUP)
    gone = EntryPoint("gone", "no.such.module:PROFILE", profile.GROUP)

    def entry_points(*, group, name=None):
        assert group == "jauspy.conformance"
        return [each for each in (mine, wrong, gone) if name in (None, each.name)]

    monkeypatch.setattr(profile, "entry_points", entry_points)
    assert set(known()) >= {"mine", "wrong", "gone", "igvc-2015"}
    assert find("mine").title == "of somebody else"
    with pytest.raises(ConfigError, match="is not a Profile"):
        find("wrong")
    with pytest.raises(ConfigError, match="cannot be loaded"):
        find("gone")


MINE = Profile("mine", "of somebody else", (ASK,))


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        ("PROFILE = 1 / 0", "cannot be loaded: ZeroDivisionError: division by zero"),
        ("PROFILE = (", "cannot be loaded: SyntaxError: "),
        ("", "cannot be loaded: AttributeError: "),
    ],
)
def test_broken_installed_profile_is_an_error(tmp_path, monkeypatch, source, reason):
    from jauspy.conformance import find, known

    installed(tmp_path, monkeypatch, source)
    assert "acme-brakes" in known()
    with pytest.raises(ConfigError, match=reason):
        find("acme-brakes")
    listed = CliRunner().invoke(app, ["conformance", "--list"])
    assert listed.exit_code == 0
    assert "cannot be loaded" in listed.stdout
    assert "igvc-2015" in listed.stdout


def test_a_profile_of_an_installed_package_is_found(tmp_path, monkeypatch):
    from jauspy.conformance import find

    installed(tmp_path, monkeypatch, "from tests.conformance.test_verdicts import MINE as PROFILE")
    assert find("acme-brakes") is MINE
    assert "of somebody else" in CliRunner().invoke(app, ["conformance", "--list"]).stdout


def installed(folder, monkeypatch, source: str) -> None:
    """A package with the entry point of docs/conformance.md, as pip leaves it."""
    (folder / "acme").mkdir()
    (folder / "acme" / "__init__.py").touch()
    (folder / "acme" / "brakes.py").write_text(source)
    info = folder / "acme-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: acme\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text("[jauspy.conformance]\nacme-brakes = acme.brakes:PROFILE\n")
    monkeypatch.syspath_prepend(str(folder))
    for name in ("acme", "acme.brakes"):
        monkeypatch.delitem(sys.modules, name, raising=False)
