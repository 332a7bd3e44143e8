"""`jauspy new component`: for any service it writes what runs, and what passes its own tests and those of tools."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tests.helpers.sampling import sampled
from typer.testing import CliRunner

import jauspy
from jauspy.cli.main import app
from jauspy.cli.new import component as stubs
from jauspy.schema import load_builtin

run = CliRunner()
OURS = Path(__file__).parents[3]
RUFF_CONFIG = OURS / "pyproject.toml"
ALL = [each for each in load_builtin().services if each.id not in stubs.core_services()]
SOME = [
    "ugv:ParkingBrakeDriver",
    "mobility:PrimitiveDriver",
    "environmentSensing:H264VideoEncoding",
    "iop:PlatformState",
]


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}:{OURS / 'src'}")


def new(*arguments: str):
    return run.invoke(app, ["new", "component", *arguments])


def check(*command: str) -> str:
    done = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize(
    "definition", sampled(ALL, fast=8), ids=lambda each: f"{each.id.partition('jss:')[2]}-{each.version}"
)
def test_package_of_every_service_starts(definition):
    files = stubs.package("it", definition, load_builtin(), None, jauspy.JausID(1, 1, 1))
    names: dict = {}
    exec(compile(files["services.py"], "services.py", "exec"), names)
    component = jauspy.Component("101.1.1", names["services"]())
    assert component.host.definitions[definition.id].version == definition.version


@pytest.mark.slow
def test_written_package_is_clean_and_its_tests_pass():
    for number, (urn, id) in enumerate(zip(SOME, ("101.1.120", "0.0.120", "7.7.7", "65534.254.254"), strict=True)):
        result = new(f"start{number}", "--service", urn, "--id", id)
        assert result.exit_code == 0, result.output
    folders = [f"start{number}" for number in range(len(SOME))]
    check("ruff", "check", *folders)
    check("ruff", "format", "--check", "--config", str(RUFF_CONFIG), *folders)
    check("mypy", "--strict", *folders)
    assert f"{len(SOME)} passed" in check("pytest", "-p", "jauspy.testing.plugin", "-q", *folders)


@pytest.mark.slow
def test_package_of_a_user_defined_service():
    run.invoke(app, ["new", "definition", "urn:example:Battery", "charge:percent"])
    result = new("battery", "--service", "Battery", "--schemas", "battery.xml")
    assert result.exit_code == 0, result.output
    assert Path("battery/battery.xml").read_text() == Path("battery.xml").read_text()
    methods = Path("battery/services.py").read_text()
    assert "def report_battery(self, query: QueryBattery) -> ReportBattery | None:" in methods
    check("ruff", "check", "battery")
    check("ruff", "format", "--check", "--config", str(RUFF_CONFIG), "battery")
    check("mypy", "--strict", "battery")
    assert "1 passed" in check("pytest", "-p", "jauspy.testing.plugin", "-q", "battery")


@pytest.mark.slow
def test_package_of_a_service_with_commands_and_states():
    """Its methods have the types of their messages, and mypy finds a report of the wrong type."""
    winch = ["--states", "Idle,Pulling", "--command", "PullCable(speed:meter per second) Idle->Pulling"]
    run.invoke(app, ["new", "definition", "urn:example:Winch", "tension:newton", *winch])
    assert new("winch", "--schemas", "winch.xml").exit_code == 0
    check("ruff", "check", "winch")
    check("mypy", "--strict", "winch")
    assert "1 passed" in check("pytest", "-p", "jauspy.testing.plugin", "-q", "winch")
    services = Path("winch/services.py")
    text = services.read_text()
    assert "def pull_cable(self, msg: PullCable) -> None:" in text
    services.write_text(text.replace("return None", "return ReportWinch(tension=query.tension)"))
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "winch"], capture_output=True, text=True, check=False
    )
    assert '"QueryWinch" has no attribute "tension"' in done.stdout


@pytest.mark.slow
def test_the_only_service_of_a_file_needs_no_name():
    assert run.invoke(app, ["new", "definition", "urn:example:Battery", "charge:percent"]).exit_code == 0
    result = new("battery", "--schemas", "battery.xml")
    assert result.exit_code == 0, result.output
    assert "def report_battery(" in Path("battery/services.py").read_text()
    Path("vendor").mkdir()
    for name in ("Lamp", "Pump"):
        run.invoke(app, ["new", "definition", f"urn:example:{name}", "x:one", "-o", f"vendor/{name}.xml"])
    several = " ".join(new("parts", "--schemas", "vendor").stderr.split())
    assert "vendor defines urn:example:Lamp, urn:example:Pump; name one with --service" in several
    assert "name the service with --service" in " ".join(new("nothing").stderr.split())


def test_existing_files_are_not_overwritten():
    new("brake", "--service", "ugv:ParkingBrakeDriver")
    before = {path: path.read_text() for path in Path("brake").iterdir()}
    result = new("brake", "--service", "mobility:PrimitiveDriver")
    assert result.exit_code == 1
    assert "exists; remove it" in result.output
    assert {path: path.read_text() for path in Path("brake").iterdir()} == before


def test_non_empty_folder_is_rejected():
    Path("brake").mkdir()
    assert new("brake", "--service", "ugv:ParkingBrakeDriver").exit_code == 0
    Path("winch").mkdir()
    Path("winch/mine.txt").write_text("mine")
    result = new("winch", "--service", "ugv:ParkingBrakeDriver")
    assert (result.exit_code, "winch exists; remove it" in result.output) == (1, True)
    assert [each.name for each in Path("winch").iterdir()] == ["mine.txt"]


def test_file_without_the_service_is_rejected():
    run.invoke(app, ["new", "definition", "urn:example:Battery", "charge:percent"])
    result = new("xyzzy", "--service", "Xyzzy", "--schemas", "battery.xml")
    assert result.exit_code == 1
    assert "no service 'Xyzzy' is known; `jauspy schema ls` lists them; battery.xml does not define it" in " ".join(
        result.output.split()
    )


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["Winch", "--service", "ugv:ParkingBrakeDriver"], "not the name of a Python package"),
        (["class", "--service", "ugv:ParkingBrakeDriver"], "'class' is not the name of a Python package"),
        (["signal", "--service", "ugv:ParkingBrakeDriver"], "signal is the name of an installed module"),
        (["jauspy", "--service", "ugv:ParkingBrakeDriver"], "as in my_jauspy"),
        (["pytest", "--service", "ugv:ParkingBrakeDriver"], "as in my_pytest"),
        (["", "--service", "ugv:ParkingBrakeDriver"], "'' is not the name of a Python package"),
        (["winch", "--service", ""], "no service '' is known"),
        (["winch", "--service", "ugv:ParkingBrakeDriver", "--id", "101.1.255"], "cannot be a component's id"),
        (["winch", "--service", "ParkingBrakDriver"], "did you mean ParkingBrakeDriver"),
        (["winch", "--service", "VelocityStateDriver", "--version", "9.9"], "has no version 9.9; it has 1.0, 1.1"),
        (["winch", "--service", "DigitalResourceDiscovery"], "several services are called"),
        (["winch", "--service", "core:Liveness"], "subclass jauspy.services.core.management.Liveness"),
        (["winch", "--service", "ugv:ParkingBrakeDriver", "--id", "1.2"], "is not a JAUS id"),
    ],
)
def test_invalid_arguments_are_rejected(arguments: list[str], problem: str):
    result = new(*arguments)
    assert result.exit_code == 1
    assert problem in " ".join(result.output.split())
    assert not list(Path().iterdir())


TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<declared_type_set xmlns="urn:jaus:jsidl:1.1" name="Own" id="urn:example:Types" version="1.0">
  <fixed_field name="Charge" field_type="long float" field_units="percent" optional="true"/>
</declared_type_set>
"""


@pytest.mark.slow
def test_definitions_with_types_in_files_of_their_own():
    """As vendors write them: a folder with services, and type sets beside them."""
    run.invoke(app, ["new", "definition", "urn:example:Battery", "charge:percent"])
    text = Path("battery.xml").read_text()
    field = '<fixed_field name="Charge" field_type="long float" field_units="percent" optional="true"/>'
    reference = '<declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/>'
    assert field in text
    text = text.replace(field, '<declared_fixed_field name="Charge" declared_type_ref="own.Charge" optional="true"/>')
    text = text.replace(
        reference, f'{reference}<declared_type_set_ref name="own" id="urn:example:Types" version="1.0"/>'
    )
    Path("vendor/types").mkdir(parents=True)
    Path("vendor/battery.xml").write_text(text)
    Path("vendor/types/types.xml").write_text(TYPES)
    result = new("battery", "--service", "Battery", "--schemas", "vendor")
    assert result.exit_code == 0, result.output
    assert Path("battery/definitions/battery.xml").read_text() == text
    assert Path("battery/definitions/types/types.xml").read_text() == TYPES
    program = "from battery.services import services; assert services()[0].urn == 'urn:example:Battery'"
    subprocess.run([sys.executable, "-c", program], check=True)
