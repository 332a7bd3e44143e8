"""`--schemas`, `--service` and `--version` of the verbs that read and make messages."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli.definitions import definitions
from jauspy.cli.fields import message_from
from jauspy.cli.main import app
from jauspy.errors import ConfigError
from jauspy.messages.core import Event

LAMP = Path(__file__).parents[1] / "vendor" / "Lamp.xml"


def run(*arguments, status=0):
    result = CliRunner().invoke(app, list(map(str, arguments)))
    assert result.exit_code == status, result.output
    return result


def decoded(*arguments, status=0):
    (line,) = run("decode", *arguments, "--json", status=status).stdout.splitlines()
    return json.loads(line)["messages"][0]


@pytest.mark.parametrize("source", [LAMP, LAMP.parent])
def test_messages_of_user_files_are_decoded(source):
    assert decoded("03d046", status=1)["problem"] == "unknown message D003h"
    found = decoded("03d046", "--schemas", source)
    assert (found["message"], found["service"], found["version"]) == ("ReportLamp", "urn:example:vendor:Lamp", "1.2")
    assert found["fields"] == {"brightness": 70}
    assert "urn:jaus:jss:core:" in decoded("0f0000", "--schemas", source)["service"]


def test_user_defined_messages_are_explained():
    assert "brightness" in run("decode", "03d046", "--schemas", LAMP, "--explain").stdout.casefold()
    assert "response" in run("decode", "0f0000", "--schemas", LAMP, "--explain").stdout.casefold()


def test_user_defined_messages_inside_built_in_ones_are_decoded():
    event = Event(1, 0, bytes.fromhex("03d046")).encode().hex()
    assert "hex" in decoded(event)["fields"]["report_message"]
    assert decoded(event, "--schemas", LAMP)["fields"]["report_message"]["message"] == "ReportLamp"


def test_other_versions_are_noted_once(tmp_path):
    found = decoded("0306010100000000")
    assert found["message"] == "SetJointVelocity"
    assert found["also"] == [
        {
            "message": "SetJointVelocities",
            "service": "urn:jaus:jss:manipulator:ManipulatorJointVelocitiesDriver",
            "version": "1.0",
        }
    ]
    file = tmp_path / "two.hex"
    file.write_text("0306010100000000\n0306010100000000\n")
    shown = run("decode", file).stdout
    assert shown.count("SetJointVelocity (0603h)") == 2
    assert shown.count("SetJointVelocities in manipulator:ManipulatorJointVelocitiesDriver 1.0 (--version 1.0)") == 1


def test_options_select_a_definition():
    older = decoded("0306010100000000", "--version", "1.0")
    assert (older["message"], older["also"]) == ("SetJointVelocities", [])
    assert decoded("0306010100000000", "--service", "ManipulatorJointVelocitiesDriver")["version"] == "1.0"
    # what has no such version is read as ever
    assert decoded("0f0000", "--service", "manipulatorjointvelocitiesdriver")["message"] == "ConfirmControl"
    assert decoded("2af900", status=1)["problem"].endswith("specify the service")
    assert decoded("2af900", "--service", "MeasurementSensor", status=1)["message"] == "QueryMeasurement"


def test_option_message_selects_one_of_two():
    data = "32f90001000000000000"
    found = decoded(data, status=1)
    assert found["message"] is None
    assert "RNDetailedMeasurement of iop:CBRNSensor 1.1 or CBDetailedMeasurement" in found["problem"]
    assert found["problem"].endswith("specify the message")
    assert decoded(data, "--message", "cbdetailedmeasurement", status=1)["message"] == "CBDetailedMeasurement"
    explained = run("decode", data[:-2], "--message", "CBDetailedMeasurement", "--explain").stdout
    assert explained.startswith("CBDetailedMeasurement")


@pytest.mark.parametrize(
    ("option", "value", "sentence"),
    [
        ("--service", "PrimitveDriver", "no service PrimitveDriver is known; did you mean PrimitiveDriver"),
        ("--version", "9.9", "no version 9.9 is known"),
        ("--message", "ReportLmap", "no message ReportLmap is known; did you mean ReportLamp"),
        ("--schemas", "nowhere/*.xml", "no JSIDL file matches 'nowhere/*.xml'"),
    ],
)
def test_unknown_names_are_rejected(option, value, sentence):
    assert sentence in run("decode", "0f0000", "--schemas", LAMP, option, value, status=1).stderr


def test_options_select_service_and_version():
    known = definitions(None)
    newest = message_from(known.registry, "SetTime", ["date_stamp={day: 1, month: 2, year: 3}"])
    older = message_from(
        known.registry, "SetTime", ["date_stamp={day: 1, month: 2, year: 3}"], known.hints("core:Time", "1.0")
    )
    assert (newest.VERSION, older.VERSION) == ("1.1", "1.0")
    with pytest.raises(
        ConfigError, match=r"no message QueryLamp is known; .*\? \(`--schemas` reads your own definitions\)$"
    ):
        message_from(known.registry, "QueryLamp", [])
    with pytest.raises(ConfigError, match=r"no message SetTime of Discovery is known"):
        message_from(known.registry, "SetTime", ["date_stamp={day: 1, month: 2, year: 3}"], known.hints("Discovery"))


@pytest.mark.parametrize(
    ("verb", "message", "sentence"),
    [
        ("query", ["QueryLamp"], "was sent QueryLamp 6 times"),
        ("query", ["SetLamp", "brightness=3"], "SetLamp is not a query"),
        ("send", ["SetLamp", "brightness=3"], "SetLamp was sent, but 101.1.7 does not answer"),
        ("send", ["QueryLamp"], "QueryLamp is a query"),
    ],
)
def test_user_defined_messages_are_sent(verb, message, sentence, free_port):
    where = ("--connect", f"udp://127.0.0.1:{free_port}", "--timeout", "0.3", "--schemas", LAMP, "--version", "1.2")
    assert sentence in run(verb, "101.1.7", *message, *where, status=1).stderr
