"""`jauspy decode` as YAML and CSV, of JSerial lines, and of large messages."""

import csv
import gc
import io
import json
from contextlib import suppress
from pathlib import Path

import pytest
import yaml
from typer.testing import CliRunner

from jauspy.capture import writer
from jauspy.cli.decode import collected_rarely
from jauspy.cli.main import app
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import Event, QueryHeartbeatPulse, ReportIdentification
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import jserial, judp
from jauspy.protocol.delivery import fragment_at, fragment_count
from jauspy.protocol.header import Packet

HOSTS = ("10.0.0.7", 3794), ("10.0.0.2", 3794)


def run(*arguments, status=0):
    result = CliRunner().invoke(app, ["decode", *map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


def datagram(payload, sequence=1, **fields):
    return judp.pack(Packet(JausID(1, 1, 1), JausID(2, 1, 1), payload, sequence, **fields))


def named(text):
    kind = ReportIdentification
    return kind(query_type=kind.QueryType(4), type=kind.Type(10001), identification=text)


@pytest.fixture
def capture(tmp_path):
    messages = [ReportLocalPose(x=1.5, yaw=0.5), QueryHeartbeatPulse(), named("=cmd|'/C calc'!A0"), named("\x1b[2J")]
    path = tmp_path / "run.pcapng"
    blocks = [writer.packet(*HOSTS, datagram(each.encode(), n), n * 10**9) for n, each in enumerate(messages)]
    path.write_bytes(writer.preamble() + b"".join(blocks))
    return path


def test_csv_has_a_row_for_each_value(capture):
    rows = list(csv.DictReader(io.StringIO(run(capture, "--format", "csv").stdout)))
    assert [(row["message"], row["field"], row["value"]) for row in rows[:3]] == [
        ("ReportLocalPose", "x", "1.5"),
        ("ReportLocalPose", "yaw", "0.5"),
        ("QueryHeartbeatPulse", "", ""),
    ]
    assert rows[0]["source"] == "1.1.1"
    texts = [row["value"] for row in rows if row["field"] == "identification"]
    assert texts[0] == "'=cmd|'/C calc'!A0"
    assert "\x1b" not in texts[1]


def test_yaml_has_the_documents_of_json(capture):
    documents = list(yaml.safe_load_all(run(capture, "--format", "yaml").stdout))
    assert documents == [json.loads(line) for line in run(capture, "--json").stdout.splitlines()]


def test_csv_of_a_log_of_can_frames_is_refused(tmp_path):
    log = tmp_path / "can.log"
    log.write_text("(1436509052.249713) can0 701#05\n")
    result = run(log, "--format", "csv", status=1)
    assert "print it as --json" in result.output


@pytest.mark.parametrize("source", ["file", "hex"])
def test_bytes_of_a_serial_line(tmp_path, source):
    line = b"\x10\x10noise" + b"".join(
        jserial.frame(datagram(each.encode(), n)) for n, each in enumerate([ReportLocalPose(x=1.0), named("a")])
    )
    damaged = bytearray(jserial.frame(datagram(named("b").encode())))
    damaged[25] ^= 0x40
    line += bytes(damaged)
    path = tmp_path / "line.bin"
    path.write_bytes(line)
    result = run(path if source == "file" else line.hex(), "--as", "serial", "--json")
    shown = [json.loads(text)["messages"][0]["message"] for text in result.stdout.splitlines()]
    assert shown == ["ReportLocalPose", "ReportIdentification"]
    assert "1 damaged frames, 2 whole ones" in result.output


def test_a_large_message_is_shown_at_its_last_fragment(tmp_path: Path):
    whole = Event(event_id=1, sequence_number=2, report_message=b"\xee\xee" + bytes(15000)).encode()
    path = tmp_path / "large.pcapng"
    with path.open("wb") as file:
        file.write(writer.preamble())
        for index in range(fragment_count(len(whole))):
            part, flag = fragment_at(whole, index)
            file.write(writer.packet(*HOSTS, datagram(part, index, data_flag=flag), 10**9 + index))
    found = [json.loads(line)["messages"][0] for line in run(path, "--json").stdout.splitlines()]
    assert [each["message"] for each in found] == [None] * (len(found) - 1) + ["Event"]
    assert len(found[-1]["fields"]["report_message"]["hex"]) == 30004


def test_what_comes_before_damage_is_printed(capture):
    capture.write_bytes(capture.read_bytes()[:-9])
    result = run(capture, "--json", status=1)
    assert len(result.stdout.splitlines()) >= 3
    assert "damaged or cut off after frame 3" in result.output


def test_thresholds_of_the_garbage_collector_are_restored_after_errors_too() -> None:
    before = gc.get_threshold()
    found = []
    with suppress(ConfigError), collected_rarely():
        found.append(gc.get_threshold()[0])
        raise ConfigError("the file is cut off")
    assert found[0] > before[0]
    assert gc.get_threshold() == before
