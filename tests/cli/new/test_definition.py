"""`jauspy new definition`: what it writes can be loaded and linted, and nothing is overwritten."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import jauspy
from jauspy.cli.main import app

run = CliRunner()


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def new(*arguments: str):
    return run.invoke(app, ["new", "definition", *arguments])


def test_written_service_reports_the_given_fields():
    result = new("urn:example:AirTank", "pressure:bar", "flow_rate:meter per second", "-o", "own/tank.xml")
    assert (result.exit_code, result.output) == (0, "own/tank.xml\n")
    registry = jauspy.load("own/tank.xml")
    report = registry.by_name("ReportAirTank")
    assert (registry.by_name("QueryAirTank").CODE, report.CODE) == (0xD001, 0xD002)
    assert report.decode(report(pressure=2.5, flow_rate=-1.0).encode()) == report(pressure=2.5, flow_rate=-1.0)
    assert report().encode() == b"\x02\xd0\x00"


def test_written_definition_has_no_lint_findings():
    new("urn:example:Many", *(f"f{chr(97 + n)}:one" for n in range(16)), "--first-id", "E0F0")
    result = run.invoke(app, ["schema", "lint", "many.xml"])
    assert result.exit_code == 0, result.output
    assert jauspy.load("many.xml").by_name("QueryMany").CODE == 0xE0F0


def test_field_names_are_kept():
    names = ["flow_rate", "v_2", "a_b"]
    new("urn:example:Lamp", *(f"{name}:one" for name in names))
    assert list(jauspy.load("lamp.xml").by_name("ReportLamp").__annotations__)[:3] == names


def test_existing_file_is_not_overwritten():
    Path("battery.xml").write_text("mine")
    result = new("urn:example:Battery", "charge:percent")
    assert result.exit_code == 1
    assert "battery.xml exists; remove it, or choose another name" in result.output
    assert Path("battery.xml").read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["charge"], "NAME:UNITS"),
        (["charge:"], "NAME:UNITS"),
        (["charge:per<cent"], "NAME:UNITS"),
        (["1charge:percent"], "NAME:UNITS"),
        (["a:one", "A:one"], "two fields have the same name"),
        ([f"f{n}:one" for n in range(17)], "up to 16"),
        (["a:one", "--first-id", "FFFF"], "not a message id"),
        (["a:one", "--first-id", "xyz"], "not a message id"),
        (["a:one", "--first-id", "-5"], "not a message id"),
        (["_:one"], "NAME:UNITS"),
        (["", "a:one"], "NAME:UNITS"),
        (
            ["a:one", "--first-id", "2202"],
            "2202 is QueryHeartbeatPulse of urn:jaus:jss:core:Liveness; D000 to D737 are free",
        ),
        (["a:one", "--first-id", "D737"], "D738 is "),
        (["a:one", "--first-id", "D739"], "; D73A to D73F are free"),
        (["a:one", "--first-id", "F933"], "; F937 to FA4F are free"),
        (["a:one", "--first-id", "FF39"], "; FF3A to FFFE are free"),
    ],
)
def test_invalid_arguments_are_rejected(arguments: list[str], problem: str):
    result = new("urn:example:Battery", *arguments)
    assert result.exit_code == 2
    assert problem in " ".join(result.output.replace("│", " ").split())
    assert not list(Path().iterdir())


@pytest.mark.parametrize(
    ("urn", "problem"),
    [
        ("urn:example:", "'urn:example:' is not the URN of a service: urn:, an organisation,"),
        ("", "'' is not the URN of a service"),
        ("Battery", "'Battery' is not the URN of a service"),
        ("urn:Battery", "as in urn:example:Battery"),
        ("URN:EXAMPLE:BATTERY", "not the URN of a service"),
        ("urn:exa mple:Battery", "not the URN of a service"),
        ("urn:example:Bat tery", "not the URN of a service"),
        ("urn:example::Battery", "not the URN of a service"),
        ("urn:example:2nd", "a name that begins with a letter"),
        ("urn:example:Läm<p", "not the URN of a service"),
        ("urn:jaus:jss:core:Events", "is a public service; choose another name"),
    ],
)
def test_invalid_service_names_are_rejected(urn: str, problem: str):
    result = new(urn, "charge:percent")
    assert result.exit_code == 2
    assert problem in " ".join(result.output.replace("│", " ").split())
    assert not list(Path().iterdir())
