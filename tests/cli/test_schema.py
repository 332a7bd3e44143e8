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


def run(*arguments, status=0):
    result = CliRunner().invoke(app, ["schema", *map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


def objects(*arguments, status=0):
    return [json.loads(line) for line in run(*arguments, "--json", status=status).stdout.splitlines()]


EFFORT = """<fixed_field name="Effort{}" field_type="unsigned byte" field_units="percent" optional="true">
<scale_range real_lower_limit="-100" real_upper_limit="100" integer_function="round"/></fixed_field>"""
SCALE = '<scale_range real_lower_limit="-100" real_upper_limit="100" integer_function="round"/>'
SPAN = """<value_set><value_range lower_limit="{}" lower_limit_type="inclusive"
upper_limit="{}" upper_limit_type="inclusive"/></value_set>"""
MESSAGE = """<message_def name="{}" message_id="{}" is_command="false"><description>It {}.</description>
<declared_header name="H" declared_type_ref="core.MsgHeader"/><body name="B">{}</body><footer name="F"/>
</message_def>"""
RECORD = f"""<record name="Rec"><presence_vector field_type_unsigned="unsigned short integer"/>
{EFFORT.format("X")}{EFFORT.format("Y")}</record>"""
THRUSTER = f"""<service_def xmlns="urn:jaus:jsidl:1.1" name="Thruster" id="urn:acme:things:Thruster" version="1.0">
<description>Thrusts.</description><assumptions/>
<declared_type_set name="t">
<declared_type_set_ref name="core" id="urn:jauspy:core:Types" version="1.0"/></declared_type_set>
<message_set><input_set>{MESSAGE.format("SetThrust", "D405", "thrusts", RECORD)}
{MESSAGE.format("QueryThrust", "D406", "asks", "")}</input_set>
<output_set>{MESSAGE.format("ReportThrust", "D407", "tells", RECORD)}</output_set></message_set>
<internal_events_set/>
<protocol_behavior><start state_machine_name="M" state_name="On"/><state_machine name="M"><state name="On">
<exit><action name="stop"/></exit>
<transition name="Receive"><parameter type="SetThrust" value="msg"/><guard condition="isReady( msg )"/><internal/>
<action name="setThrust"><argument value="msg"/></action></transition>
</state></state_machine></protocol_behavior></service_def>
"""


@pytest.fixture
def old(tmp_path):
    path = tmp_path / "old.xml"
    path.write_text(THRUSTER, encoding="utf-8")
    return path


@pytest.fixture
def changed(tmp_path):
    """A function that writes the definition with some text replaced."""

    def write(*replacements):
        text = THRUSTER
        for before, after in replacements:
            assert before in text
            text = text.replace(before, after)
        path = tmp_path / "new.xml"
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
    lines = [line.split() for line in run("ls").stdout.splitlines()]
    assert lines[0] == ["set", "service", "version", "inherits", "from", "messages"]
    assert len(lines) == 1 + len(load_builtin().services)
    assert ["mobility", "PrimitiveDriver", "1.1", "core", "Management", "1.1", "2", "in,", "1", "out"] in lines


def test_ls_json_has_one_object_per_service():
    found = objects("ls")
    assert [(item["urn"], item["version"]) for item in found] == [service.key for service in load_builtin().services]
    [driver] = [item for item in found if item["name"] == "PrimitiveDriver" and item["version"] == "1.1"]
    assert driver == {
        "urn": "urn:jaus:jss:mobility:PrimitiveDriver",
        "name": "PrimitiveDriver",
        "version": "1.1",
        "set": "mobility",
        "package": "mobility",
        "jsidl": "1.1",
        "inherits_from": {"urn": "urn:jaus:jss:core:Management", "version": "1.1"},
        "inputs": [{"code": "0405", "name": "SetWrenchEffort"}, {"code": "2405", "name": "QueryWrenchEffort"}],
        "outputs": [{"code": "4405", "name": "ReportWrenchEffort"}],
        "file": str(DRIVER),
    }


def test_ls_of_a_set_and_of_own_files(old):
    assert {item["set"] for item in objects("ls", "--set", "Core")} == {"core"}
    assert [item["name"] for item in objects("ls", "--schemas", old)] == ["Thruster"]
    message = run("ls", "--set", "cor", status=2).stderr
    assert message.startswith("Error: there is no service set 'cor'; the sets are ")
    assert " core, " in message


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


@pytest.mark.parametrize(
    "name",
    [
        "ReportVelocityState",
        "ReportServices",
        "CBRNSensor",
        "SetJointMotionProfile",
        "MissionSpooler",
        "Drawing",
        "F92A",
    ],
)
def test_show_fits_80_columns(name):
    assert all(len(line) <= 80 for line in run("show", name, "--docs").stdout.splitlines())


def test_show_one_id_of_two_messages():
    text = run("show", "F92A").stdout
    assert "CBRNScanWindowConfigurationCommand  F92Ah" in text
    assert "QueryMeasurement  F92Ah" in text
    assert "also in iop MeasurementSensorClient" in text


def test_show_own_definitions(old):
    assert "EffortX" in run("show", "SetThrust", "--schemas", old).stdout
    assert "SetThrust [isReady( msg )]: setThrust(msg)" in run("show", "Thruster", "--schemas", old).stdout


def test_show_json():
    [message] = objects("show", "SetWrenchEffort")
    assert (message["kind"], message["code"], message["bytes"]) == ("message", "0405", [4, 22])
    row = message["layout"][2]
    assert (row["name"], row["offset"], row["size"], row["type"], row["presence_bit"]) == (
        "PropulsiveLinearEffortX", "4", "2", "u16", 0,
    )  # fmt: skip
    [service] = objects("show", "core:Time")
    assert (service["kind"], service["urn"]) == ("service", "urn:jaus:jss:core:Time")


@pytest.mark.parametrize(
    ("type", "inside", "shown"),
    [
        ("unsigned byte", SCALE, "-100..100 %, step 0.784"),
        ("byte", SCALE, "-100..100 %, step 1.57"),  # raw values are 0..127
        ("float", SCALE, "%"),
        ("float", SPAN.format(0, 0.5), "0..0.5 %"),
        ("long integer", SPAN.format(-(2**63), 7), "-9223372036854775808..7 %"),
    ],
)
def test_show_ranges_with_their_units(changed, type, inside, shown):
    before = 'field_type="unsigned byte"'
    path = changed((f'name="EffortX" {before}', f'name="EffortX" field_type="{type}"'), (SCALE, inside))
    rows = {row["name"]: row for row in objects("show", "SetThrust", "--schemas", path)[0]["layout"]}
    assert rows["EffortX"]["values"] == [shown]


def test_show_marks_fields_without_presence_bit():
    """The published CBRNDetection has fourteen optional members and a vector of eight bits."""
    text = run("show", "CBRNDetection").stdout
    assert "CBRNDetection  F931h, 8 to 55 bytes" in text
    assert "8 bits for 14 optional" in text
    [message] = objects("show", "CBRNDetection")
    assert message["bytes"] == [8, 55]
    rows = {row["name"]: row for row in message["layout"]}
    assert (rows["LeftRadialLine"]["presence_bit"], rows["LeftRadialLine"]["size"]) == (7, "4")
    for name in ("RightRadialLine", "DetectionAltitude"):
        assert (rows[name]["presence_bit"], rows[name]["size"], rows[name]["offset"]) == (None, "0", "")
        assert rows[name]["values"] == ["never present: no presence bit is left"]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["core:Time{}", "urn:jaus:jss:core:Time{}", "SetTime{}", "0011{}"])
def test_show_selects_a_version_by_suffix(name):
    for sign in "@:":
        assert objects("show", name.format(f"{sign}1.0"))[0]["version"] == "1.0"
    assert objects("show", name.format("@1.0"), "--version", "1.0")[0]["version"] == "1.0"
    assert objects("show", name.format(""))[0]["version"] == "1.1"
    both = run("show", name.format("@1.0"), "--version", "1.1", status=2).stderr
    assert "with version 1.0 and with 1.1; give one version" in both


def test_show_unknown_name_is_an_error():
    assert (
        "no service or message is called 'SetWrenchEffor'; did you mean SetWrenchEffort"
        in run("show", "SetWrenchEffor", status=2).stderr
    )
    assert "no service has version 9.9; the versions are 1" in run("show", "Time", "--version", "9.9", status=2).stderr


def test_sets_are_found_by_all_names():
    def urns(name):
        return [service["urn"] for service in objects("ls", "--set", name)]

    assert urns("environmentSensing") == urns("environment_sensing") == urns("ENVIRONMENTSENSING") != []
    assert urns("exp") == urns("aeodrs")
    assert "urn:jaus:jss:exp:aeodrs:HealthMonitor" in urns("aeodrs")
    assert all(urn.startswith("urn:jaus:jss:exp:aeodrs:") for urn in urns("aeodrs"))
    assert {(each["set"], each["package"]) for each in objects("ls", "--set", "mission_spooler")} == {
        ("missionSpooler", "mission_spooler")
    }


@pytest.mark.parametrize(
    "arguments",
    [
        ["ls", "--set", "nonsense"],
        ["ls", "--schemas", "nowhere/*.xml"],
        ["show", "Nonsense"],
        ["show", "Time", "--schemas", "nowhere/*.xml"],
        ["lint", "nowhere/*.xml"],
        ["diff", "nowhere/*.xml", "Time"],
        ["generate", "nowhere/*.xml", "-o", "nowhere"],
    ],
    ids=" ".join,
)
def test_all_errors_have_exit_status_2(arguments):
    assert run(*arguments, status=2).stderr.startswith("Error: ")


def test_exit_statuses_are_documented():
    text = " ".join(run("--help").stdout.replace("│", " ").split())
    assert "0 success; 1 lint found something or diff found a difference; 2 wrong use" in text


# --- diff -----------------------------------------------------------------------------------------------------------


def test_diff_of_equal_definitions_is_empty(old, changed):
    text = run("diff", old, old).stdout
    assert text.count("identical on the wire") == 3
    assert "behaviour: identical" in text
    run(
        "diff", old, changed(("Thrusts.", "Drives."), ("It thrusts.", "It drives."), ("isReady( msg )", "isReady(msg)"))
    )


EFFORT_X = EFFORT.format("X")
CHANGES = {
    "type": (('field_type="unsigned byte"', 'field_type="byte"'), "EffortX: type u8 -> i8"),
    "range": (('real_lower_limit="-100"', 'real_lower_limit="-50"'), "EffortX: range -100..100 -> -50..100"),
    "removed": ((EFFORT_X, ""), "EffortX: removed (optional u8)"),
    "added": ((EFFORT_X, EFFORT_X + EFFORT.format("Z")), "EffortZ: added (optional u8)"),
    "order": ((f"{EFFORT_X}{EFFORT.format('Y')}", f"{EFFORT.format('Y')}{EFFORT_X}"), "order EffortX, EffortY"),
    "presence": (("unsigned short integer", "unsigned integer"), "presence vector u16 -> u32"),
    "mandatory": (('optional="true"', 'optional="false"'), "EffortX: is mandatory now"),
    "values": (
        ('<scale_range real_lower_limit="-100" real_upper_limit="100" integer_function="round"/>',
         '<value_set><value_enum enum_index="3" enum_const="FULL"/></value_set>'),
        "EffortX: value 3 FULL added",
    ),
    "id": (('message_id="D405"', 'message_id="D40A"'), "message_id D405 -> D40A"),
}  # fmt: skip


@pytest.mark.parametrize(("replacement", "text"), CHANGES.values(), ids=CHANGES.keys())
def test_diff_on_the_wire(old, changed, replacement, text):
    result = run("diff", old, changed(replacement), status=1)
    assert text in result.stdout
    assert "D405h SetThrust: differs on the wire" in result.stdout
    assert "D406h QueryThrust: identical on the wire" in result.stdout


def test_diff_of_names_and_units_alone(old, changed):
    text = run("diff", old, changed(("EffortX", "Thrust"), ('"percent"', '"one"')), status=1).stdout
    assert "D405h SetThrust: identical on the wire, names and units differ" in text
    assert "EffortX: is called Thrust now" in text
    assert "units percent -> one" in text


def test_diff_of_behaviour(old, changed):
    text = run("diff", old, changed(("isReady( msg )", "true"), ('name="stop"', 'name="brake"')), status=1).stdout
    assert text.count("identical on the wire") == 3
    assert "M.On: on exit stop() -> brake()" in text
    assert "M.On: SetThrust [isReady(msg)]: setThrust(msg) removed" in text
    assert "M.On: SetThrust [true]: setThrust(msg) added" in text
    text = run("diff", old, changed(('"On"', '"Off"')), status=1).stdout
    assert "M.On: state removed" in text
    assert "M.Off: state added" in text


def test_diff_of_messages_and_services(old, changed):
    path = changed(('name="ReportThrust" message_id="D407"', 'name="ReportEffort" message_id="D408"'))
    [found] = objects("diff", old, path, status=1)
    assert (found["removed"], found["added"]) == (
        [{"code": "D407", "name": "ReportThrust"}],
        [{"code": "D408", "name": "ReportEffort"}],
    )
    assert {message["wire"] for message in found["messages"]} == {"identical"}
    text = run("diff", "mobility@1.1", path, status=1).stdout
    assert "urn:jaus:jss:mobility:LocalPoseSensor 1.1: service removed" in text
    assert "urn:acme:things:Thruster 1.0: service added" in text


def test_diff_of_two_versions_of_a_set():
    found = objects("diff", "core@1.0", "core@1.1", status=1)
    [time] = [item for item in found if item["a"] == {"urn": "urn:jaus:jss:core:Time", "version": "1.0"}]
    assert time["b"] == {"urn": "urn:jaus:jss:core:Time", "version": "1.1"}


def test_diff_json_of_equal_definitions():
    [found] = objects("diff", "core:Time@1.1", "core:Time")
    assert found["same"]
    assert {message["wire"] for message in found["messages"]} == {"identical"}


@pytest.mark.parametrize(
    ("what", "sentence"),
    [
        ("nowhere.xml", "no JSIDL file matches 'nowhere.xml'"),
        ("Time@7.0", "Time 7.0 is not built in; the versions are 1"),
    ],
)
def test_diff_of_unreadable_files_is_an_error(what, sentence):
    assert sentence in run("diff", what, "Time", status=2).stderr
