"""`jauspy new definition`: what it writes can be loaded and linted, and nothing is overwritten."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import jauspy
from jauspy.cli.main import app
from jauspy.testing import VirtualNetwork

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
            "2202 is QueryHeartbeatPulse of urn:jaus:jss:core:Liveness; D000 to D700 are free",
        ),
        (["a:one", "--first-id", "D737"], "D738 is "),
        (["a:one", "--first-id", "D739"], "; D73A to D73F are free"),
        (["a:one", "--first-id", "F933"], "; F937 to F998 are free"),
        (["a:one", "--first-id", "FF39"], "; FF3A to FFD0 are free"),
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


WINCH = (
    "urn:example:Winch",
    "tension:newton",
    "--states",
    "Idle,Pulling,Locked",
    "--command",
    "PullCable(speed:meter per second) Idle->Pulling",
    "--command",
    "StopCable ->Idle",
    "--command",
    "LockDrum Idle->Locked",
)


async def test_commands_lead_from_state_to_state(virtual_network: VirtualNetwork, ocu: jauspy.OCU) -> None:
    assert new(*WINCH).exit_code == 0
    winch = jauspy.load("winch.xml")
    done: list[str] = []

    class Winch(jauspy.Service, urn="urn:example:Winch", definitions=winch):
        def pull_cable(self, msg: Any) -> None:
            done.append(f"pull at {msg.speed}")

        def stop_cable(self) -> None:
            done.append("stop")

        def lock_drum(self) -> None:
            done.append("lock")

        def report_winch(self) -> Any:
            return winch.by_name("ReportWinch")(tension=5.0)

    async with virtual_network.component("101.1.120", [Winch()]):
        service = (await ocu.discover(101)).service("Winch")
        pull, stop, lock = (winch.by_name(name) for name in ("PullCable", "StopCable", "LockDrum"))
        assert (await service.query(winch.by_name("QueryWinch")(1))).tension == 5.0
        await service.send(pull(speed=1.0))  # without control
        async with service.control():
            await service.send(pull(speed=2.0))  # in Standby
            await service.resume()
            for command in (lock(), pull(speed=3.0), lock(), stop(), stop(), pull(speed=4.0), lock()):
                await service.send(command)
            await service.query(winch.by_name("QueryWinch")(1))
    assert done == ["lock", "stop", "stop", "pull at 4.0"]


@pytest.mark.parametrize("parent", ["Events", "accesscontrol", "core:Management"])
@pytest.mark.parametrize("fields", [(), ("level:percent",)])
def test_every_parent_gives_a_definition_without_findings(parent: str, fields: tuple[str, ...]) -> None:
    result = new(
        "urn:example:Lamp", *fields, "--inherits", parent, "--command", "SwitchLamp", "--command", "Dim(to:one)"
    )
    assert result.exit_code == 0, result.output
    linted = run.invoke(app, ["schema", "lint", "lamp.xml"])
    assert linted.exit_code == 0, linted.output
    code = f"{jauspy.load('lamp.xml').by_name('Dim').CODE:04X}"
    assert code == ("D004" if fields else "D002")


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ((), "needs fields to report, or commands"),
        (("--command", "Pull (a:one"), "is not NAME[(FIELD:UNITS, ...)] [[STATE]->STATE]"),
        (("--command", 'Pull"/><x'), "is not NAME"),
        (("--command", "Pull ->Gone", "--states", "Idle"), "Pull names the state Gone, which is not in --states Idle"),
        (("--command", "Pull ->Gone"), "not in --states (none)"),
        (("--command", "Pull", "--states", "Idle,Idle"), "'Idle' is not the name of a state, or it is there twice"),
        (("--command", "Pull", "--command", "Pull"), "Pull is there twice"),
        (("--command", "SetWrenchEffort"), "SetWrenchEffort is the name of a public message"),
        (("--command", "Pull", "--inherits", "Discovery"), "is not one of Events, AccessControl, Management"),
        (("a:one", "--command", "P", "--command", "Q", "--first-id", "D735"), "D738 is "),
    ],
)
def test_invalid_commands_are_rejected(arguments: tuple[str, ...], problem: str) -> None:
    result = new("urn:example:Winch", *arguments)
    assert result.exit_code == 2
    assert problem in " ".join(result.output.replace("│", " ").split())
    assert not list(Path().iterdir())
