"""H.264 in RTP, of a capture or of an interface, becomes foxglove.CompressedVideo when it is recorded as MCAP."""

from __future__ import annotations

import dataclasses
import itertools
import os
import socket
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.helpers.ports import unused_port
from typer.testing import CliRunner

from jauspy.capture.reader import Datagram
from jauspy.cli.main import app
from jauspy.export import rtp_streams
from jauspy.export.films import pictures
from jauspy.export.rtp_streams import RtpStreams
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.environment_sensing import RegisterDigitalResourceEndpoint
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.mcap_capture import open_capture_file
from jauspy.video.rtp import RtpPacket

pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")


def record(source: Path, output: Path, *options: str) -> str:
    result = CliRunner().invoke(app, ["record", str(output), "--capture", str(source), *options])
    assert result.exit_code == 0, result.output
    return result.stderr


def test_pictures_are_the_same_in_both_files(run_file: Callable[..., Path], tmp_path: Path) -> None:
    source, output = run_file(), tmp_path / "run.mcap"
    said = record(source, output)
    before = list(pictures(source))
    after = [found for found in pictures(output) if found.picture.nals]
    assert f"91 messages, {len(before)} pictures" in said
    assert [found.picture.nals for found in after] == [found.picture.nals for found in before]
    assert [found.time for found in after] == pytest.approx([found.time for found in before], abs=1e-6)
    assert {found.camera for found in after} == {"10.0.0.1-5004-video"}


def test_pictures_after_the_last_message_are_recorded(
    run_file: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("jauspy.recording.recorder.MAX_PICTURES", 1)
    source, output = run_file(), tmp_path / "run.mcap"
    record(source, output)
    assert len(list(pictures(output))) == len(list(pictures(source)))


@pytest.mark.parametrize(("name", "options"), [("run2.pcapng", []), ("run2.mcap", ["--filter", "msg == Report*"])])
def test_other_files_have_no_pictures(
    run_file: Callable[..., Path], tmp_path: Path, name: str, options: list[str]
) -> None:
    output = tmp_path / name
    assert "pictures" not in record(run_file(), output, *options)
    assert list(pictures(output)) == []


CAMERA = JausID(101, 1, 106)


def registration(sensor: int, url: str) -> bytes:
    kind = RegisterDigitalResourceEndpoint
    record = kind.DigitalResourceEndpointRec(0, url, None, sensor)
    return judp.pack(Packet(JausID(42, 1, 1), CAMERA, kind(kind.RequestIDRec(1), record).encode(), 1))


def cameras(packets: list[tuple[float, bytes]], *said: bytes) -> set[str]:
    """The names of the cameras whose pictures are found after these messages."""
    streams = RtpStreams(registry)
    here, there = ("10.0.0.1", 40_000), ("10.0.0.2", 5004)
    rows = [Datagram(1, 0.0, ("10.0.0.2", 3794), ("10.0.0.1", 3794), payload) for payload in said]
    rows += [Datagram(1, time, here, there, payload) for time, payload in packets]
    return {picture.camera for row in rows for picture in streams.feed(row)}


def test_a_stream_has_the_id_of_the_camera_for_which_its_endpoint_was_registered(
    packets: list[tuple[float, bytes]],
) -> None:
    assert cameras(packets) == {"10.0.0.1-5004"}
    assert cameras(packets, registration(1, "rtp://10.0.0.2:5004")) == {"101.1.106"}
    assert cameras(packets, registration(2, "rtp://10.0.0.2:5004")) == {"101.1.106/2"}
    for other in ("rtp://10.0.0.2:5006", "rtp://10.0.0.9:5004", "rtp://10.0.0.2:99999", "rtp://[10.0.0.2", "rtp://"):
        assert cameras(packets, registration(1, other)) == {"10.0.0.1-5004"}, other


def test_a_stream_begins_with_a_picture_that_can_be_decoded_and_other_packets_are_none(
    packets: list[tuple[float, bytes]],
) -> None:
    sound = [
        (0.0, RtpPacket(n, 960 * n, 9, bytes([0x78 + n % 2]) + bytes(40), marker=True).encode()) for n in range(50)
    ]
    assert cameras(sound) == set()
    second = next(n for n, (_, data) in enumerate(packets) if RtpPacket.decode(data).marker) + 1
    assert cameras(packets[second : second + 5]) == set()
    assert cameras(packets[second:]) <= {"10.0.0.1-5004"}


def test_streams_and_endpoints_are_bounded(packets: list[tuple[float, bytes]]) -> None:
    streams = RtpStreams(registry)
    for number in range(rtp_streams.MAX_ENDPOINTS + 9):
        said = registration(1, f"rtp://10.0.{number // 200}.{number % 200}:5004")
        list(streams.feed(Datagram(1, 0.0, ("10.0.0.2", 3794), ("10.0.0.1", 3794), said)))
        list(streams.feed(Datagram(1, 0.0, ("10.0.0.1", 9), ("10.0.0.2", 5004 + number), packets[0][1])))
    assert (len(streams._streams), len(streams._endpoints)) == (rtp_streams.MAX_STREAMS, rtp_streams.MAX_ENDPOINTS)


@pytest.mark.slow
@pytest.mark.skipif(os.geteuid() != 0, reason="capturing on an interface needs root")
def test_video_on_an_interface_is_recorded_live(
    packets: list[tuple[float, bytes]], free_port: int, tmp_path: Path
) -> None:
    """Sent again and again while it is recorded; the packets of another port that are no RTP are left out."""
    output, ended = tmp_path / "run.mcap", threading.Event()
    video_port = unused_port()

    assert cameras(packets, registration(1, "rtp://10.0.0.2:5004")) == {"101.1.106"}  # what it needs is loaded now
    group = [RtpPacket.decode(data) for _, data in packets[:20]]

    def send() -> None:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            for number in itertools.count():
                sender.sendto(registration(1, f"rtp://127.0.0.1:{video_port}"), ("127.0.0.1", free_port))
                sender.sendto(b"no RTP", ("127.0.0.1", video_port))
                for place, packet in enumerate(group):
                    sequence = (number * len(group) + place) & 0xFFFF
                    stamp = (packet.timestamp + number * 90_000) & 0xFFFFFFFF
                    sent = dataclasses.replace(packet, sequence=sequence, timestamp=stamp)
                    sender.sendto(sent.encode(), ("127.0.0.1", video_port))
                if ended.wait(0.05):
                    return

    thread = threading.Thread(target=send)
    thread.start()
    try:
        options = ["--interface", "lo", "--port", str(free_port), "--for", "3"]
        result = CliRunner().invoke(app, ["record", str(output), *options])
    finally:
        ended.set()
        thread.join()
    assert result.exit_code == 0, result.output
    found = [picture for picture in pictures(output) if picture.picture.nals]
    assert found, result.output
    assert found[-1].camera == "101.1.106-video"
    assert {picture.camera for picture in found} <= {"101.1.106-video", f"127.0.0.1-{video_port}-video"}
    assert found[0].picture.is_idr
    with output.open("rb") as file:
        assert {row.destination[1] for row in open_capture_file(file, name="run", port=None)} == {free_port}
