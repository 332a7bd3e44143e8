"""`jauspy schema ls`, `show` and `diff`, in this process."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.schema import builtin_paths, load_builtin

SCHEMAS = Path(builtin_paths()[0]).parents[2]
DRIVER = SCHEMAS / "mobility" / "1.1" / "PrimitiveDriver.xml"
TYPES = SCHEMAS / "core" / "types.xml"


def run(*arguments, status=0):
    result = CliRunner().invoke(app, ["schema", *map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


def objects(*arguments, status=0):
    return [json.loads(line) for line in run(*arguments, "--json", status=status).stdout.splitlines()]


@pytest.fixture
def changed(tmp_path):
    """A function that writes the definition of PrimitiveDriver with some text replaced."""

    def write(*replacements):
        text = DRIVER.read_text(encoding="utf-8")
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "PrimitiveDriver.xml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize("verb", [[], ["ls"], ["show"], ["lint"], ["diff"], ["generate"]])
def test_help(verb):
    text = run(*verb, "--help").stdout
    assert "Usage" in text
    assert not verb or "Example" in text


# --- ls -------------------------------------------------------------------------------------------------------------


def test_ls_has_one_line_per_service():
    lines = run("ls").stdout.splitlines()
    assert len(lines) == 1 + len(load_builtin().services)
    assert "mobility  PrimitiveDriver      1.1      core Management 1.1     2 in, 1 out" in lines


def test_ls_json_has_one_object_per_service():
    found = objects("ls")
    assert [(item["urn"], item["version"]) for item in found] == [service.key for service in load_builtin().services]
    [driver] = [item for item in found if item["name"] == "PrimitiveDriver"]
    assert driver == {
        "urn": "urn:jaus:jss:mobility:PrimitiveDriver",
        "name": "PrimitiveDriver",
        "version": "1.1",
        "set": "mobility",
        "jsidl": "1.1",
        "inherits_from": {"urn": "urn:jaus:jss:core:Management", "version": "1.1"},
        "inputs": [{"code": "0405", "name": "SetWrenchEffort"}, {"code": "2405", "name": "QueryWrenchEffort"}],
        "outputs": [{"code": "4405", "name": "ReportWrenchEffort"}],
        "file": str(DRIVER),
    }


def test_ls_of_a_set_and_of_own_files():
    assert {item["set"] for item in objects("ls", "--set", "Core")} == {"core"}
    assert [item["name"] for item in objects("ls", "--from", DRIVER, "--from", TYPES)] == ["PrimitiveDriver"]
    assert "there is no service set 'cor'; there is core" in run("ls", "--set", "cor", status=1).stderr


# --- show -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["SetWrenchEffort", "setwrencheffort", "0405", "0x0405", "0405h"])
def test_show_a_message_by_name_and_id(name):
    text = run("show", name).stdout
    assert "SetWrenchEffort  0405h, command, 4 to 22 bytes" in text
    assert "input of mobility PrimitiveDriver 1.1" in text
    assert "   4     2  PropulsiveLinearEffortX      u16     0  -100..100 %, step 0.0030" in text
    assert " ≤16     1  ResistiveLinearEffortX       u8      6" in text
    assert all(len(line) <= 80 for line in text.splitlines())


def test_show_nested_lists_and_enumerations():
    text = run("show", "ReportServices").stdout
    assert "at least 3 bytes" in text
    assert "  +0         1        NodeID" in text
    text = run("show", "ReportStatus").stdout
    assert "STANDBY" in text
    assert "reserved" not in run("show", "ReportStatus", "--docs").stderr


@pytest.mark.parametrize(
    "name", ["PrimitiveDriver", "mobility:PrimitiveDriver", "urn:jaus:jss:mobility:PrimitiveDriver"]
)
def test_show_a_service(name):
    text = run("show", name, "--version", "1.1").stdout
    assert "inherits from Management 1.1, AccessControl 1.1, Events 1.1, Transport 1.1" in text
    assert "2405h  QueryWrenchEffort" in text
    assert "by default QueryWrenchEffort: send ReportWrenchEffort" in text
    assert "SetWrenchEffort [isControllingClient(transportData)]" in text
    assert all(len(line) <= 80 for line in text.splitlines())


def test_show_everything_fits_80_columns():
    for service in load_builtin().services:
        for name in (service.id, *(message.name for message in service.messages)):
            assert all(len(line) <= 80 for line in run("show", name).stdout.splitlines()), name


def test_show_json():
    [message] = objects("show", "SetWrenchEffort")
    assert (message["kind"], message["code"], message["bytes"]) == ("message", "0405", [4, 22])
    row = message["layout"][2]
    assert (row["name"], row["offset"], row["size"], row["type"], row["presence_bit"]) == (
        "PropulsiveLinearEffortX", "4", "2", "u16", 0,
    )  # fmt: skip
    [service] = objects("show", "core:Time")
    assert (service["kind"], service["urn"]) == ("service", "urn:jaus:jss:core:Time")


def test_show_what_is_not_there():
    assert (
        "no service or message is called 'SetWrenchEffor'; did you mean SetWrenchEffort"
        in run("show", "SetWrenchEffor", status=1).stderr
    )
    assert "nothing has the version 9.9; there are 1" in run("show", "Time", "--version", "9.9", status=1).stderr


# --- diff -----------------------------------------------------------------------------------------------------------


def test_diff_of_the_same(changed):
    text = run("diff", "mobility:PrimitiveDriver@1.1", DRIVER).stdout
    assert text.count("identical on the wire") == 3
    assert "behaviour: identical" in text
    path = changed(("Open-loop driving", "Driving"), ("Sets propulsive", "Commands propulsive"))
    run("diff", "PrimitiveDriver", path)


CHANGES = {
    "type": (('"unsigned byte" field_units="percent"', '"byte" field_units="percent"'), "type u8 -> i8"),
    "range": (('real_lower_limit="-100"', 'real_lower_limit="-50"'), "range -100..100 -> -50..100"),
    "presence": (('field_type_unsigned="unsigned short integer"', 'field_type_unsigned="unsigned integer"'),
                 "presence vector u16 -> u32"),
    "mandatory": (('"unsigned byte" field_units="percent" optional="true"',
                   '"unsigned byte" field_units="percent" optional="false"'), "is mandatory now"),
    "id": (('message_id="0405"', 'message_id="0406"'), "message_id 0405 -> 0406"),
}  # fmt: skip


@pytest.mark.parametrize("case", CHANGES)
def test_diff_on_the_wire(changed, case):
    replacement, text = CHANGES[case]
    result = run("diff", "PrimitiveDriver@1.1", changed(replacement), status=1)
    assert text in result.stdout
    assert "0405h SetWrenchEffort: differs on the wire" in result.stdout
    assert "2405h QueryWrenchEffort: identical on the wire" in result.stdout


def test_diff_of_names_and_units_alone(changed):
    path = changed(("PropulsiveLinearEffortX", "Thrust"), ('field_units="percent"', 'field_units="one"'))
    text = run("diff", "PrimitiveDriver@1.1", path, status=1).stdout
    assert "0405h SetWrenchEffort: identical on the wire, names and units differ" in text
    assert "PropulsiveLinearEffortX: is called Thrust now" in text
    assert "units percent -> one" in text


def test_diff_of_behaviour(changed):
    path = changed(("isControllingClient(transportData)", "true"), ("resetTravelSpeed", "stopMotion"))
    text = run("diff", "PrimitiveDriver@1.1", path, status=1).stdout
    assert text.count("identical on the wire") == 3
    assert "on exit resetTravelSpeed() -> stopMotion()" in text
    assert "SetWrenchEffort [true]: setWrenchEffort(msg) added" in text


def test_diff_of_messages_and_services(changed):
    path = changed(('name="ReportWrenchEffort" message_id="4405"', 'name="ReportThrust" message_id="4406"'))
    [found] = objects("diff", "PrimitiveDriver@1.1", path, status=1)
    assert (found["removed"], found["added"]) == (
        [{"code": "4405", "name": "ReportWrenchEffort"}],
        [{"code": "4406", "name": "ReportThrust"}],
    )
    assert {message["wire"] for message in found["messages"]} == {"identical"}
    text = run("diff", "mobility@1.1", path, status=1).stdout
    assert "urn:jaus:jss:mobility:LocalPoseSensor 1.1: service removed" in text


def test_diff_json_of_the_same():
    [found] = objects("diff", "core:Time@1.1", "core:Time")
    assert found["same"]
    assert {message["wire"] for message in found["messages"]} == {"identical"}


@pytest.mark.parametrize(
    ("what", "sentence"),
    [("nowhere.xml", "no JSIDL file matches 'nowhere.xml'"), ("Time@7.0", "Time 7.0 is not built in; there is 1")],
)
def test_diff_of_what_cannot_be_read(what, sentence):
    assert sentence in run("diff", what, "Time", status=2).stderr
