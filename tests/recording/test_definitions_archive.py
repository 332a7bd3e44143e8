"""The definitions in a recording are enough to read it, also where jauspy is not installed."""

from __future__ import annotations

import io
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

from jauspy import load
from jauspy.capture.dissect import dissect
from jauspy.capture.reader import Datagram
from jauspy.codec.build import load_schema
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.definitions_archive import NAME, definitions_archive
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.recording.recorder import Limits, Recorder
from jauspy.schema import Schema, builtin_paths, load_builtin, load_files

pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
make_reader = pytest.importorskip("mcap.reader", reason="mcap is of the extra `recording`").make_reader

OWN_TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<declared_type_set xmlns="urn:jaus:jsidl:1.1" name="Own" id="urn:example:Types" version="1.0">
  <fixed_field name="Charge" field_type="long float" field_units="percent" optional="true"/>
</declared_type_set>
"""


def datagram(number: int) -> Datagram:
    message = ReportLocalPose(x=float(number), y=1.0)
    payload = judp.pack(Packet(JausID(101, 1, 102), JausID(42, 1, 1), message.encode(), number))
    return Datagram(number, 1_700_000_000.0 + 0.1 * number, ("10.0.0.1", 3794), ("10.0.0.2", 3794), payload)


RUN = [datagram(number) for number in range(40)]


def unpacked(archive: bytes) -> dict[str, bytes]:
    found = {}
    with tarfile.open(fileobj=io.BytesIO(archive)) as opened:
        for member in opened:
            assert member.isfile()
            found[member.name] = opened.extractfile(member).read()  # type: ignore[union-attr]
    return found


def definitions_of(path: Path) -> dict[str, bytes]:
    """The files of definitions that are attached to an MCAP file, by name."""
    with path.open("rb") as file:
        found = {attachment.name: attachment.data for attachment in make_reader(file).iter_attachments()}
    assert set(found) <= {NAME}
    return unpacked(found[NAME]) if found else {}


def test_all_definitions_are_attached(tmp_path: Path) -> None:
    Recorder(tmp_path / "run.mcap", registry).run(RUN)
    found = definitions_of(tmp_path / "run.mcap")
    assert sorted(found.values()) == sorted(path.read_bytes() for path in builtin_paths())
    assert "jauspy/mobility/1.1/LocalPoseSensor.xml" in found
    assert not any(name.startswith("/") or ".." in name for name in found)


@pytest.mark.slow
def test_the_attached_definitions_decode_the_datagrams(tmp_path: Path) -> None:
    Recorder(tmp_path / "run.mcap", registry).run(RUN)
    for name, data in definitions_of(tmp_path / "run.mcap").items():
        path = tmp_path / "kept" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    schema = load_files(sorted((tmp_path / "kept").rglob("*.xml")))
    assert {service.key for service in schema.services} == {service.key for service in load_builtin().services}
    kept = load_schema(Schema(services=(schema.service(ReportLocalPose.SERVICE),)))
    with (tmp_path / "run.mcap").open("rb") as file:
        found = [part for row in open_capture_file(file, name="run") for part in dissect(row.payload, kept).parts]
    places = [getattr(part.content.message, "x", None) for part in found]
    assert places == pytest.approx([float(number) for number in range(40)], abs=1e-4)
    assert all(type(part.content.message).__module__.startswith("jauspy_loaded") for part in found)


def test_definitions_of_the_user_are_attached_too(tmp_path: Path) -> None:
    service = next(path for path in builtin_paths() if path.name == "FailureRecovery.xml").read_bytes()
    service = service.replace(b"urn:jauspy:recovery:", b"urn:example:")
    for name, data in (("a/types.xml", OWN_TYPES.encode()), ("b/service.xml", service)):
        path = tmp_path / "vendor" / name
        path.parent.mkdir(parents=True)
        path.write_bytes(data)
    Recorder(tmp_path / "run.mcap", load(tmp_path / "vendor")).run(RUN[:1])
    found = definitions_of(tmp_path / "run.mcap")
    assert len(found) == len(builtin_paths()) + 2
    assert (found["own/a/types.xml"], found["own/b/service.xml"]) == (OWN_TYPES.encode(), service)


def test_each_file_of_a_split_recording_has_them(tmp_path: Path) -> None:
    recorder = Recorder(tmp_path / "run.mcap", registry, Limits(seconds=2.0, files=2))
    recorder.run(RUN)
    assert len(recorder.recorded.files) == 2
    assert all(definitions_of(path) for path in recorder.recorded.files)


def test_small_files_are_not_filled_with_them(tmp_path: Path) -> None:
    size = len(definitions_archive(registry))
    assert size < 200_000
    for name, limit in (("small", 9 * size), ("large", 11 * size)):
        Recorder(tmp_path / f"{name}.mcap", registry, Limits(size=limit)).run(RUN)
    assert not definitions_of(tmp_path / "small-0001.mcap")
    assert definitions_of(tmp_path / "large-0001.mcap")


def test_equal_definitions_make_equal_bytes() -> None:
    program = "import sys; from jauspy.messages import registry; from jauspy.recording import definitions_archive as d;"
    program += "sys.stdout.buffer.write(d.definitions_archive(registry))"
    again = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True).stdout
    assert again == definitions_archive(registry)
