"""Recordings are read back by others' libraries: mcap, jsonschema, dpkt."""

from __future__ import annotations

import errno
import io
import json
import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

import dpkt
import pytest
from typer.testing import CliRunner

from jauspy.capture.dissect import dissect
from jauspy.capture.reader import CaptureReader, Datagram
from jauspy.cli.main import app
from jauspy.codec.json_schema import json_schema
from jauspy.codec.rounding import rounded
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ReportServices, ReportStatus
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.recording.recorder import Limits, Recorder
from jauspy.recording.run_files import DATAGRAMS, McapFile, PcapngFile, create

OCU, ROBOT = JausID(42, 1, 1), JausID(101, 1, 102)
START = 1_700_000_000.0


def datagram(number: int, message: Any = None) -> Datagram:
    message = message or ReportLocalPose(x=float(number), y=1.0)
    payload = judp.pack(Packet(ROBOT, OCU, message.encode(), number))
    return Datagram(number, START + number * 0.1, ("10.0.0.1", 3794), ("10.0.0.2", 3794), payload)


STATUS = ReportStatus.from_dict({"status": "READY", "reserved": 0})
RUN = [*(datagram(number) for number in range(40)), datagram(40, STATUS)]


def mcap_messages(path: Path) -> list[tuple[str, Any, Any]]:
    reader = pytest.importorskip("mcap.reader", reason="mcap is of the extra `recording`")
    with path.open("rb") as file:
        return [
            (channel.topic, schema, message) for schema, channel, message in reader.make_reader(file).iter_messages()
        ]


@pytest.fixture
def mcap_file(tmp_path: Path) -> Path:
    pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    path = tmp_path / "run.mcap"
    Recorder(path, registry).run(RUN)
    return path


def test_an_mcap_file_has_each_datagram_as_it_was(mcap_file: Path) -> None:
    packets = [message for topic, _, message in mcap_messages(mcap_file) if topic == DATAGRAMS]
    assert [dpkt.ip.IP(packet.data).data.data for packet in packets] == [row.payload for row in RUN]
    assert [packet.log_time for packet in packets] == [round(row.time * 1e9) for row in RUN]


@pytest.mark.slow
def test_an_mcap_file_is_a_capture(mcap_file: Path) -> None:
    with mcap_file.open("rb") as file:
        found = list(open_capture_file(file, name="run"))
    assert [(row.source, row.destination, row.payload) for row in found] == [row[2:] for row in RUN]
    assert [row.time for row in found] == pytest.approx([row.time for row in RUN])
    assert run("decode", mcap_file, "--filter", "x > 37").stdout.count("ReportLocalPose") == 2
    assert (
        run("echo", "--capture", mcap_file, "--filter", "x > 37", "--field", "x").stdout.count("ReportLocalPose") == 2
    )


def test_a_damaged_mcap_file_is_read_up_to_the_damage(mcap_file: Path) -> None:
    with mcap_file.open("wb", buffering=0) as out:
        file = McapFile(out, registry)  # without definitions: each of the places below is one of messages
        for row in RUN:
            file.add(row, dissect(row.payload, registry).parts)
        file.close()
    whole = mcap_file.read_bytes()
    for end in range(9, len(whole), 997):
        mcap_file.write_bytes(whole[:end])
        result = CliRunner().invoke(app, ["decode", str(mcap_file), "--json"])
        is_said = "damaged or cut off" in result.stderr
        assert is_said or result.stdout.count("\n") == len(RUN)  # only the summary is cut off
        assert result.exit_code == int(is_said)
    chunk = whole.rindex(b"\x28\xb5\x2f\xfd") + 60  # behind the magic number of zstd
    mcap_file.write_bytes(whole[:chunk] + bytes([whole[chunk] ^ 0x5A]) + whole[chunk + 1 :])
    assert "damaged" in CliRunner().invoke(app, ["decode", str(mcap_file)]).stderr


def test_each_message_of_an_mcap_file_fits_its_schema(mcap_file: Path) -> None:
    validate = pytest.importorskip("jsonschema").validate
    messages = [row for row in mcap_messages(mcap_file) if row[1].encoding == "jsonschema"]
    for _, schema, message in messages:
        validate(json.loads(message.data), json.loads(schema.data))
    assert {topic for topic, _, _ in messages} == {"/101.1.102/ReportLocalPose", "/101.1.102/ReportStatus"}
    assert json.loads(messages[3][2].data) == {"x": 3.0, "y": 1.0}


@pytest.mark.slow
def test_schemas_of_all_messages_are_valid_and_fit_their_messages() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    for entry in registry.entries:
        jsonschema.Draft202012Validator.check_schema(json_schema(entry.load()))
    services = {"node_list": [{"node_rec": {"node_id": 1}, "component_list": []}]}
    for message in (ReportServices.from_dict(services), STATUS, ReportLocalPose(x=1.0)):
        jsonschema.validate(rounded(message).to_dict(), json_schema(type(message)))


def test_a_schema_rejects_what_is_no_such_message() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    for wrong in ({"x": "far"}, [], {"time_stamp": 3}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(wrong, json_schema(ReportLocalPose))


def payloads(path: Path) -> list[bytes]:
    with path.open("rb") as file:
        return [row.payload for row in CaptureReader(file, name=str(path))]


def test_files_follow_each_other_and_old_ones_go(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path / "run.pcapng", registry, Limits(seconds=1.0, files=2))
    recorder.run(RUN)
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["run-0004.pcapng", "run-0005.pcapng"]
    assert [path.name for path in recorder.recorded.files] == names
    assert [row for name in names for row in payloads(tmp_path / name)] == [row.payload for row in RUN[30:]]


def test_a_file_ends_at_its_size(tmp_path: Path) -> None:
    Recorder(tmp_path / "run.pcapng", registry, Limits(size=1500)).run(RUN)
    sizes = [path.stat().st_size for path in sorted(tmp_path.iterdir())]
    assert len(sizes) > 1
    assert max(sizes) < 1500 + 1000


def test_only_what_fits_is_recorded(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path / "run.pcapng", registry, fits=lambda part: part.content.code == 0x4002)
    recorder.run(RUN)
    assert payloads(tmp_path / "run.pcapng") == [RUN[-1].payload]
    assert (recorder.recorded.datagrams, recorder.recorded.messages) == (1, 1)


def test_errors_are_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "there.pcapng").touch()
    for name, problem in (
        ("run.bag", "none of the suffixes"),
        ("there.pcapng", "exists already"),
        ("no/run.pcapng", "cannot be written: No such file"),
    ):
        with pytest.raises(ConfigError, match=problem):
            create(tmp_path / name, registry)


class FullDisk(io.BytesIO):
    def write(self, data: Any) -> int:
        if self.tell() + len(data) > 2000:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return super().write(data)


@pytest.mark.parametrize("kind", ["mcap", "pcapng"])
def test_a_full_disk_is_said_at_the_next_flush(kind: str) -> None:
    if kind == "mcap":
        pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    file = McapFile(FullDisk(), registry) if kind == "mcap" else PcapngFile(FullDisk())
    with pytest.raises(OSError, match="No space left"):  # noqa: PT012 - somewhere in it
        for row in RUN:
            file.add(row, ())
            file.flush()


KILLED = """
import itertools, sys, time
from pathlib import Path
from jauspy.messages import registry
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.recording.recorder import Recorder
from tests.recording.test_recording import datagram
recorder = Recorder(Path(sys.argv[1]), registry)
for number in itertools.count():
    recorder.add(datagram(number))
    if number == 100:
        print("ready", flush=True)
        time.sleep(60)
"""


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["mcap", "pcapng"])
def test_kill_loses_less_than_a_second(tmp_path: Path, suffix: str) -> None:
    if suffix == "mcap":
        pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    path = tmp_path / f"run.{suffix}"
    with subprocess.Popen([sys.executable, "-c", KILLED, str(path)], stdout=subprocess.PIPE, cwd=Path.cwd()) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"ready\n"
        process.send_signal(signal.SIGKILL)
    if suffix == "pcapng":
        assert len(payloads(path)) >= 90
        return
    from mcap.exceptions import EndOfFile
    from mcap.records import Chunk, Message
    from mcap.stream_reader import StreamReader

    found: list[object] = []
    with path.open("rb") as file, suppress(EndOfFile):
        found.extend(StreamReader(file).records)  # what was read stays, when the end is missing
    assert not any(isinstance(record, Chunk) for record in found)
    assert sum(isinstance(record, Message) for record in found) >= 2 * 90


def test_what_came_last_is_written_while_nothing_follows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    now = [100.0]
    monkeypatch.setattr("jauspy.recording.recorder.monotonic", lambda: now[0])
    path = tmp_path / "run.pcapng"
    recorder = Recorder(path, registry)
    for number in range(8):
        recorder.add(datagram(number))
    assert len(payloads(path)) == 6
    now[0] += 0.4
    recorder.flush()
    assert len(payloads(path)) == 6
    now[0] += 0.2
    recorder.flush()
    assert len(payloads(path)) == 8
    recorder.close()


def no_space(_: object) -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_a_full_disk_that_is_met_while_nothing_comes_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    now = [100.0]
    monkeypatch.setattr("jauspy.recording.recorder.monotonic", lambda: now[0])
    recorder = Recorder(tmp_path / "run.pcapng", registry)
    recorder.add(datagram(0))
    with monkeypatch.context() as full:
        full.setattr(PcapngFile, "flush", no_space)
        now[0] += 1.0
        recorder.flush()
    with pytest.raises(OSError, match="No space left"):
        recorder.add(datagram(1))
    recorder.close()


def run(*arguments: object, status: int = 0) -> Any:
    result = CliRunner().invoke(app, [*map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


def test_the_verbs(tmp_path: Path) -> None:
    pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    source, output = tmp_path / "run.pcapng", tmp_path / "run.mcap"
    Recorder(source, registry).run(RUN)
    assert "41 datagrams, 41 messages" in run("record", output, "--capture", source).stderr
    for path in (source, output):
        found = json.loads(run("info", path, "--json").stdout)
        assert [(row["message"], row["count"]) for row in found["messages"]] == [
            ("ReportLocalPose", 40),
            ("ReportStatus", 1),
        ]
        assert found["end"] - found["start"] == pytest.approx(4.0)
        assert "4.0 s from 2023-11-14 22:13:20 UTC" in run("info", path).stdout
    assert "is no size" in run("record", tmp_path / "x.mcap", "--split-size", "much", status=1).stderr
    assert "--keep needs" in run("record", tmp_path / "x.mcap", "--keep", 2, status=1).stderr
    output.write_bytes(output.read_bytes()[:500])
    assert "mcap recover" in run("info", output, status=1).stderr


def test_info_of_a_file_that_a_crash_has_cut_off(mcap_file: Path) -> None:
    whole = mcap_file.read_bytes()
    footer = whole.rindex(b"\x02\x14" + bytes(7))
    for end, complete in ((len(whole), True), (footer - 100, False), (footer, False)):
        cut = mcap_file.with_name(f"cut{end}.bin")
        cut.write_bytes(whole[:end])
        result = run("info", cut, "--json")
        found = json.loads(result.stdout)
        assert found["complete"] is complete
        assert [(row["message"], row["count"]) for row in found["messages"]] == [
            ("ReportLocalPose", 40),
            ("ReportStatus", 1),
        ]
        assert ("no summary" in result.stderr) is not complete


@pytest.mark.parametrize("suffix", ["mcap", "pcapng"])
def test_files_of_killed_recorders_are_read_up_to_their_end(tmp_path: Path, suffix: str) -> None:
    if suffix == "mcap":
        pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    path = tmp_path / f"run.{suffix}"
    recorder = Recorder(path, registry)
    for row in RUN:
        recorder.add(row)
    cut = tmp_path / f"cut.{suffix}"
    cut.write_bytes(path.read_bytes() + (b"" if suffix == "mcap" else b"\6"))  # the end of a chunk is not written yet
    recorder.close()
    for verb, told in (
        (("hz", "--capture", cut), "ReportLocalPose"),
        (("graph", "--capture", cut), "101.1.102"),
        (("export", cut, "--csv", "-o", tmp_path / "csv"), "101.1.102_ReportLocalPose.csv"),
        (("export", cut, "--pcapng", "-o", tmp_path / "again.pcapng"), "datagrams"),
    ):
        result = run(*verb)
        assert told in result.stdout
        assert "damaged or cut off after" in result.stderr
    whole = tmp_path / "whole.pcapng"
    assert "datagrams" in run("record", whole, "--capture", cut).stderr
    assert 35 <= len(payloads(whole)) <= len(RUN)


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["mcap", "pcapng"])
def test_a_full_disk_is_said_at_once(tmp_path: Path, suffix: str) -> None:
    if suffix == "mcap":
        pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    source, path = tmp_path / "run.pcapng", tmp_path / f"short.{suffix}"
    Recorder(source, registry).run(datagram(number % 900) for number in range(3000))
    limited = "import resource, signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN); "
    limited += "resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000)); from jauspy.cli import main; main()"
    command = [sys.executable, "-c", limited, "record", str(path), "--capture", str(source)]
    result = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert result.returncode == 1
    assert "File too large" in result.stderr
    assert str(path) in result.stderr.replace("\n", "")
    assert "Traceback" not in result.stderr
    assert path.stat().st_size <= 20_000
