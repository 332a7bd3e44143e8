"""The flight recorder: its ring, what it takes for an incident, and the files that it writes."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given, strategies as st

from jauspy.capture.dissect import dissect
from jauspy.capture.reader import CaptureReader, Datagram
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ClearEmergency,
    ConfirmControl,
    Event,
    RejectControl,
    ReleaseControl,
    ReportControl,
    ReportStatus,
    SetEmergency,
)
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import judp
from jauspy.protocol.delivery import fragment_at, fragment_count
from jauspy.protocol.header import Packet
from jauspy.recording import flight_recorder
from jauspy.recording.flight_recorder import OVERHEAD, FlightRecorder, Folder, Ring
from jauspy.recording.incidents import Incident, IncidentDetector, Kind, may_show_incident

OCU, ROBOT, OTHER = JausID(42, 1, 1), JausID(101, 1, 102), JausID(102, 1, 102)
SECOND = JausID(42, 1, 2)
START = 1_700_000_000.0

CONFIRM = ConfirmControl(ConfirmControl.ResponseCode.CONTROL_ACCEPTED)
REJECT = RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED)
STOP = SetEmergency(SetEmergency.EmergencyCode(1))
CLEAR = ClearEmergency(ClearEmergency.EmergencyCode(1))
NOBODY, CLIENT = ReportControl(0, 0, 0, 0), ReportControl(42, 1, 1, 100)


def status(name: str) -> ReportStatus:
    return ReportStatus(ReportStatus.Status[name], 0)


def datagram(seconds: float, message: Message | None = None, source: JausID = ROBOT, to: JausID = OCU) -> Datagram:
    message = message or ReportLocalPose(x=seconds, y=1.0)
    payload = judp.pack(Packet(source, to, message.encode(), round(seconds * 10) % 65536))
    return Datagram(1, START + seconds, ("10.0.0.1", 3794), ("10.0.0.2", 3794), payload)


@example(rows=[(0.0, 0), (-1.0, 0), *[(0.0, 0)] * 5, (2.0, 0)], seconds=1.0, size=2100)
@given(
    rows=st.lists(st.tuples(st.floats(-5.0, 20.0), st.integers(0, 2000))),
    seconds=st.floats(0.0, 30.0),
    size=st.integers(0, 20_000),
)
def test_the_ring_keeps_the_newest_within_its_limits(rows: list[tuple[float, int]], seconds: float, size: int) -> None:
    ring = Ring(seconds, size)
    now, added = START, []
    for step, length in rows:
        now += step  # clocks are set back, too
        added.append(Datagram(len(added), now, ("", 0), ("", 0), bytes(length)))
        ring.add(added[-1])
        kept = list(ring)
        assert kept == added[len(added) - len(kept) :]
        assert ring.size == sum(len(row.payload) + OVERHEAD for row in kept) <= size
        assert not kept or abs(now - kept[0].time) <= seconds
        if not ring.dropped and all(each >= 0.0 for each, _ in rows):
            assert len(kept) == len(added) or now - added[-len(kept) - 1].time > seconds


Case = tuple[list[tuple[Message, JausID, JausID]], list[Kind]]
CASES: dict[str, Case] = {
    "reported": ([(status("READY"), ROBOT, OCU), (status("EMERGENCY"), ROBOT, OCU)], [Kind.EMERGENCY]),
    "reported again": ([(status("FAILURE"), ROBOT, OCU)] * 3, [Kind.FAILURE]),
    "twice": (
        [(status(name), ROBOT, OCU) for name in ("FAILURE", "READY", "FAILURE")],
        [Kind.FAILURE, Kind.FAILURE],
    ),
    "set": ([(STOP, OCU, ROBOT)] * 2, [Kind.EMERGENCY]),
    "set again": ([(STOP, OCU, ROBOT), (CLEAR, OCU, ROBOT), (STOP, OCU, ROBOT)], [Kind.EMERGENCY] * 2),
    "timed out": ([(CONFIRM, ROBOT, OCU), (REJECT, ROBOT, OCU)], [Kind.CONTROL_LOST]),
    "older than the recorder": ([(REJECT, ROBOT, OCU)], [Kind.CONTROL_LOST]),
    "released": ([(CONFIRM, ROBOT, OCU), (ReleaseControl(), OCU, ROBOT), (REJECT, ROBOT, OCU)], []),
    "taken over": ([(CONFIRM, ROBOT, OCU), (REJECT, ROBOT, OCU), (CONFIRM, ROBOT, SECOND)], [Kind.CONTROL_LOST]),
    "taken over, told late": (
        [(CONFIRM, ROBOT, OCU), (CONFIRM, ROBOT, SECOND), (REJECT, ROBOT, OCU), (REJECT, ROBOT, OCU)],
        [Kind.CONTROL_LOST],
    ),
    "lost again": ([(CONFIRM, ROBOT, OCU), (REJECT, ROBOT, OCU)] * 2, [Kind.CONTROL_LOST] * 2),
    "reported as lost": ([(CLIENT, ROBOT, OCU), (NOBODY, ROBOT, OCU)], [Kind.CONTROL_LOST]),
    "told twice": ([(CONFIRM, ROBOT, OCU), (REJECT, ROBOT, OCU), (NOBODY, ROBOT, OCU)], [Kind.CONTROL_LOST]),
    "reported by an event": ([(Event(1, 2, status("EMERGENCY")), ROBOT, OCU)], [Kind.EMERGENCY]),
    "nobody ever": ([(NOBODY, ROBOT, OCU)] * 2, []),
    "of another robot": ([(STOP, OCU, OTHER), (status("FAILURE"), OTHER, OCU)], []),
}


@pytest.mark.parametrize("name", CASES)
def test_incidents(name: str) -> None:
    messages, expected = CASES[name]
    detector = IncidentDetector(101)
    found: list[Incident] = []
    for message, source, to in messages:
        assert may_show_incident(message.encode())
        found += detector.incidents(dissect(datagram(0.0, message, source, to).payload, registry).parts)
    assert found == [Incident(kind, ROBOT) for kind in expected]


def test_most_messages_are_not_decoded_for_incidents() -> None:
    pose = ReportLocalPose(x=1.0)
    for payload in (pose.encode(), Event(1, 2, pose).encode(), b"", b"\x02", Event(1, 2, pose).encode()[:9]):
        assert not may_show_incident(payload)


def test_only_the_wanted_kinds_are_incidents() -> None:
    parts = dissect(datagram(0.0, status("FAILURE")).payload, registry).parts
    assert list(IncidentDetector(None, [Kind.EMERGENCY]).incidents(parts)) == []
    assert list(IncidentDetector(None, [Kind.FAILURE]).incidents(parts)) == [Incident(Kind.FAILURE, ROBOT)]


@pytest.mark.slow
@given(st.lists(st.integers(0, 3000), max_size=3))
def test_memory_of_states_is_bounded(numbers: list[int]) -> None:
    detector = IncidentDetector(None)
    for number in [*range(1100), *numbers]:
        source = JausID.from_int(number + 1)
        list(detector.incidents(dissect(datagram(0.0, status("READY"), source).payload, registry).parts))
    assert len(detector._states) <= 1024


Make = Callable[..., tuple[FlightRecorder, list[str]]]


@pytest.fixture
def make(tmp_path: Path) -> Make:
    def recorder(**limits: Any) -> tuple[FlightRecorder, list[str]]:
        said: list[str] = []
        folder = Folder(tmp_path / "runs", "101", ".pcapng", **limits)
        return FlightRecorder(folder, registry, IncidentDetector(101), before=3.0, after=2.0, log=said.append), said

    return recorder


def files(tmp_path: Path) -> dict[str, list[float]]:
    """The times of the datagrams in each file, in seconds after the start."""
    found = {}
    for path in sorted((tmp_path / "runs").iterdir()):
        with path.open("rb") as file:
            found[path.name] = [round(row.time - START, 1) for row in CaptureReader(file, name=path.name)]
    return found


def feed(recorder: FlightRecorder, end: float, incidents: Iterable[float]) -> None:
    """Ten datagrams a second, and incidents at their times."""
    at = {round(each * 10) for each in incidents}
    for number in range(round(end * 10)):
        if number in at:
            recorder.add(datagram(number / 10, status("READY")))
            recorder.add(datagram(number / 10, status("EMERGENCY")))
        else:
            recorder.add(datagram(number / 10))


def tenths(start: float, end: float) -> list[float]:
    return [number / 10 for number in range(round(start * 10), round(end * 10) + 1)]


def test_a_file_reaches_from_before_until_after(make: Make, tmp_path: Path) -> None:
    recorder, said = make()
    feed(recorder, 20.0, [10.0])
    (found,) = files(tmp_path).items()
    assert found[0] == "101-20231114-221330-emergency.pcapng"
    assert sorted(set(found[1])) == tenths(7.0, 12.0)
    assert len(found[1]) == len(tenths(7.0, 12.0)) + 1  # the incident is two datagrams
    assert said[0].startswith("emergency of 101.1.102: recording to ")
    assert "is complete: 52 datagrams" in said[1]
    assert not recorder.is_recording


def test_incidents_that_overlap_are_in_one_file(make: Make, tmp_path: Path) -> None:
    recorder, said = make()
    feed(recorder, 20.0, [5.0, 6.5, 8.0, 16.0])
    first, second = files(tmp_path).values()
    assert (first[0], first[-1], second[0], second[-1]) == (2.0, 10.0, 13.0, 18.0)
    assert [line.rpartition(" ")[2] for line in said[1:3]] == ["on", "on"]


def test_the_clock_ends_a_file_without_traffic(make: Make, tmp_path: Path) -> None:
    recorder, said = make()
    recorder.add(datagram(0.0, status("FAILURE")))
    recorder.tick(START + 1.0)
    assert recorder.is_recording
    recorder.tick(START + 2.1)
    assert not recorder.is_recording
    assert list(files(tmp_path).values()) == [[0.0]]
    assert len(said) == 2


def test_nothing_is_overwritten(make: Make, tmp_path: Path) -> None:
    for _ in range(3):
        recorder, _ = make()
        recorder.add(datagram(0.0, status("FAILURE")))
        recorder.close()
    stem = "101-20231114-221320-failure"
    assert list(files(tmp_path)) == [f"{stem}-2.pcapng", f"{stem}-3.pcapng", f"{stem}.pcapng"]


def test_the_oldest_own_files_make_room(make: Make, tmp_path: Path) -> None:
    recorder, said = make(files=2)
    for name in ("101-notes.txt", "102-20231114-221320-failure.pcapng", "101-20231114-221320-failure.pcapng.bak"):
        (tmp_path / "runs" / name).touch()
    for at in (100.0, 200.0, 300.0):
        recorder.add(datagram(at, status("FAILURE")))
        recorder.add(datagram(at + 1.0, status("READY")))
        recorder.tick(START + at + 50.0)
        for path in (tmp_path / "runs").glob("*failure.pcapng"):
            os.utime(path, (path.stat().st_mtime - 1.0,) * 2)
    names = {path.name for path in (tmp_path / "runs").iterdir()}
    assert names == {
        "101-notes.txt",
        "102-20231114-221320-failure.pcapng",
        "101-20231114-221320-failure.pcapng.bak",
        "101-20231114-221640-failure.pcapng",
        "101-20231114-221820-failure.pcapng",
    }
    assert any("221500-failure.pcapng is deleted to make room" in line for line in said)


def test_a_long_file_is_followed_by_the_next(make: Make, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(flight_recorder, "MAX_FILE", 1000)
    recorder, _ = make()
    feed(recorder, 10.0, [5.0])
    found = files(tmp_path)
    assert len(found) > 1
    assert sorted({each for times in found.values() for each in times}) == tenths(2.0, 7.0)


def test_an_error_is_said_and_the_next_incident_is_recorded(
    make: Make, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class FullDisk:
        size = 0

        def add(self, *_: object) -> None: ...

        def flush(self) -> None:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

        close = flush

    recorder, said = make()
    with monkeypatch.context() as patch:
        patch.setattr(flight_recorder, "create", lambda *_: FullDisk())
        recorder.add(datagram(0.0, status("FAILURE")))
    assert said[-1].endswith("-failure.pcapng is incomplete: No space left on device")
    recorder.add(datagram(1.0, status("READY")))
    recorder.add(datagram(1.0, status("FAILURE")))
    recorder.close()
    assert list(files(tmp_path).values()) == [[0.0, 1.0, 1.0]]


def test_it_says_what_memory_could_not_hold(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    recorder, said = make()
    monkeypatch.setattr(recorder, "ring", Ring(3.0, 10 * (OVERHEAD + 40)))
    feed(recorder, 10.0, [5.0])
    assert "memory reached only" in said[0]


def test_a_folder_that_cannot_be_made(make: Make, tmp_path: Path) -> None:
    (tmp_path / "runs").touch()
    with pytest.raises(ConfigError, match="cannot be a folder of recordings: File exists"):
        make()


def test_large_messages_of_before_and_across_the_incident_are_in_the_file(tmp_path: Path) -> None:
    pytest.importorskip("foxglove")
    from mcap.reader import make_reader

    folder = Folder(tmp_path / "runs", "101", ".mcap")
    recorder = FlightRecorder(folder, registry, IncidentDetector(101), before=3.0, after=2.0, log=lambda _: None)
    payload = Event(event_id=1, sequence_number=2, report_message=b"\xee\xee" + bytes(15_000)).encode()
    fragments = [fragment_at(payload, index) for index in range(fragment_count(len(payload)))]

    def fragment(seconds: float, first: int, index: int) -> None:
        part, flag = fragments[index]
        packet = judp.pack(Packet(ROBOT, OCU, part, first + index, data_flag=flag))
        recorder.add(Datagram(1, START + seconds, ("10.0.0.1", 3794), ("10.0.0.2", 3794), packet))

    for index in range(len(fragments)):
        fragment(0.1 * index, 100, index)
    fragment(1.0, 200, 0)
    recorder.add(datagram(1.1, status("EMERGENCY")))
    for index in range(1, len(fragments)):
        fragment(1.1 + 0.1 * index, 200, index)
    recorder.close()
    (path,) = (tmp_path / "runs").iterdir()
    with path.open("rb") as file:
        topics = [channel.topic for _, channel, _ in make_reader(file).iter_messages()]
    assert topics.count("/101.1.102/Event") == 2
