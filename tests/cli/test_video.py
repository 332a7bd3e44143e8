"""`jauspy video` beside a robot whose cameras see sky and floor."""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import select
import signal

import pytest
from tests.helpers.command_line import jauspy, robot_in_thread, start

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import av

from jauspy.cli import still, video
from jauspy.cli.video import StreamSettings
from jauspy.errors import RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.transport.loopback import LoopbackHub, LoopbackTransport
from jauspy.transport.udp import UdpTransport
from jauspy.video.receiver import RtpReceiver

HEADLESS = {name: value for name, value in os.environ.items() if name not in {"DISPLAY", "WAYLAND_DISPLAY"}}


def lines_until(process, text):
    lines = []
    for line in process.stdout:
        lines.append(line)
        if text in line:
            return "".join(lines)
    pytest.fail(f"{text!r} was never printed: {process.stderr.read()}")


@pytest.fixture(scope="module")
def robot():
    """Where a robot listens."""
    with robot_in_thread() as running:
        yield ["--connect", running.local]


@pytest.fixture
def port():
    with RtpReceiver() as receiver:
        return receiver.port


@pytest.mark.slow
def test_video_is_recorded_in_the_size_that_is_asked_for(robot, port, tmp_path):
    film = tmp_path / "arm.mp4"
    wanted = ["--size", "320x240", "--rate", "20", "--bitrate", "500"]
    to = ["--to", f"127.0.0.1:{port}", "--save", str(film), "--seconds", "1"]
    recording = start("video", "101.1.106", *wanted, *to, *robot)
    out, said = recording.communicate(timeout=60)
    assert recording.returncode == 0, said
    assert "0 packets lost" in said
    assert f"recording 101.1.106 to {film}" in out
    with av.open(str(film)) as opened:
        frames = list(opened.decode(video=0))
    assert len(frames) > 2
    assert (frames[0].width, frames[0].height) == (320, 240)


@pytest.mark.slow
def test_component_without_cameras_is_an_error(robot, port, tmp_path):
    film, to = tmp_path / "none.mp4", f"127.0.0.1:{port}"
    run = jauspy("video", "101.1.102", "--to", to, "--save", str(film), *robot, status=1)
    assert "101.1.102 does not offer DigitalResourceDiscovery; it offers" in " ".join(run.stderr.split())
    assert not film.exists()


@pytest.mark.slow
def test_players_are_printed_and_the_robot_sends_until_the_end(robot, tmp_path):
    file = tmp_path / "chassis.sdp"
    with RtpReceiver() as receiver:
        to = f"127.0.0.1:{receiver.port}"
        watching = start("video", "101.1.107", "--to", to, "--sdp", str(file), "--show", *robot, env=HEADLESS)
        try:
            out = lines_until(watching, "Ctrl-C")
            text = file.read_text()
            assert f"m=video {receiver.port} RTP/AVP 96" in text
            assert re.search(r"packetization-mode=1;profile-level-id=42[0-9a-f]{4};sprop-parameter-sets=\S+,\S+", text)
            assert all(player in out for player in ("ffplay ", "gst-launch-1.0 ", "vlc "))
            pictures = []
            while not pictures:
                pictures = receiver.take()
            assert pictures[0].is_idr
        finally:
            watching.send_signal(signal.SIGTERM)
            _, said = watching.communicate(timeout=20)
        assert "there is no display" in said
        for _ in range(100):
            receiver.take()
            if not select.select([receiver], [], [], 0.5)[0]:
                return
        pytest.fail("it still sends")


@pytest.mark.slow
def test_unknown_sensor_is_an_error(robot):
    run = jauspy("video", "101.1.107", "--sensor", "7", "--sdp", os.devnull, *robot, status=1)
    assert "101.1.107 does not send sensor 7 to rtp://127.0.0.1:5004" in run.stderr


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (["101.1.255"], 1, "has wildcards"),
        (["101.1.106", "--to", "robot:5004"], 1, "an address in numbers"),
        (["101.1.106", "--size", "641x480"], 1, "--size 641x480: JAUS has no such size for video; it has: 128x96,"),
        (["101.1.106", "--rate", "0"], 2, "--rate"),
        (["101.1.106", "--sdp", "/no/such/folder/x.sdp"], 1, "choose another file with --sdp"),
        (["101.1.106", "--save", "x.mp4", "--show"], 2, "cannot be combined with --output"),
    ],
)
def test_wrong_usage_ends_with_status_2(arguments, status, said):
    assert said in " ".join(jauspy("video", *arguments, status=status).stderr.split())


async def test_without_an_address_it_is_the_one_that_routes_to_the_robot(monkeypatch):
    """Not 127.0.0.1, to which a robot on another machine sends its own."""
    asked = []
    monkeypatch.setattr("jauspy.ocu.connection.address_towards", lambda host: asked.append(host) or "10.0.0.7")
    async with OCU("42.1.1", transport=UdpTransport(JausID(42, 1, 1), peer=("127.0.0.1", 9))) as ocu:
        assert await ocu.address_towards("101.1.106") == "10.0.0.7"
    assert asked == ["127.0.0.1"]
    async with OCU("42.1.1", transport=UdpTransport(JausID(42, 1, 1), group=("239.255.0.77", 9))) as ocu:
        with pytest.raises(RequestError, match=r"101\.1\.106 has sent nothing yet, so its machine is unknown"):
            await ocu.address_towards("101.1.106")


async def test_the_address_of_this_machine_is_that_of_its_loopback_interface(robot):
    async with OCU("42.1.9", robot[1]) as ocu:
        assert await video.own_address(ocu, JausID(101, 1, 106), None) == ("127.0.0.1", 5004)
        assert await video.own_address(ocu, JausID(101, 1, 106), ("10.0.0.1", 6000)) == ("10.0.0.1", 6000)


@pytest.mark.slow
async def test_missing_picture_is_explained_after_three_seconds(monkeypatch, capsys, tmp_path, port):
    assert video.FIRST_NOTE == 3.0
    monkeypatch.setattr(video, "FIRST_NOTE", 0.05)
    monkeypatch.setattr(video, "START_TIMEOUT", 0.1)
    monkeypatch.setattr(video, "registered", lambda *_: contextlib.nullcontext())
    ocu, camera = OCU("42.1.1", transport=LoopbackTransport(JausID(42, 1, 1), LoopbackHub())), JausID(101, 1, 106)
    unchanged = StreamSettings()
    with pytest.raises(RequestError, match=r"no picture was received in 0\.1 s: no packet has arrived at rtp://127"):
        await video.record(ocu, camera, 1, ("127.0.0.1", port), unchanged, file=tmp_path / "x.mp4", seconds=None)
    said = " ".join(capsys.readouterr().err.split())
    assert "no picture yet: no packet has arrived" in said
    assert "if 101.1.106 is on another one, name an address with --to" in said
    says = video.no_picture(camera, ("10.0.0.7", 5004), {}, "camera arm is still starting")
    assert says == "101.1.106 says: camera arm is still starting"
    assert "101.1.106 may have no route to 10.0.0.7" in video.no_picture(camera, ("10.0.0.7", 5004), {})
    assert "no whole picture to begin with (lost 3)" in video.no_picture(camera, ("10.0.0.7", 5004), {"lost": 3})


class Silent:
    """A receiver to which only notes come."""

    note = "camera arm is still starting"


async def test_a_camera_that_says_that_it_starts_has_more_time(monkeypatch):
    monkeypatch.setattr(video, "START_TIMEOUT", 0.0)
    monkeypatch.setattr(video, "FIRST_NOTE", 0.0)
    started, receiver = asyncio.Event(), Silent()
    waiting = asyncio.create_task(video._first_picture(started, receiver))
    await asyncio.sleep(0)
    assert not waiting.done()
    started.set()
    await asyncio.wait_for(waiting, 20.0)
    started.clear()
    receiver.note = ""
    with pytest.raises(TimeoutError):
        await video._first_picture(started, receiver)


async def test_what_a_camera_says_is_printed_when_it_changes(monkeypatch, capsys):
    monkeypatch.setattr(video, "NOTE_INTERVAL", 0.0)
    receiver = Silent()
    telling = asyncio.create_task(video._tell_notes(JausID(101, 1, 106), receiver))
    for note in ("one", "one", "", "two\x1b[2J"):
        receiver.note = note
        for _ in range(3):
            await asyncio.sleep(0)
    telling.cancel()
    lines = capsys.readouterr().err.splitlines()
    assert [line.partition("says: ")[2] for line in lines] == ["one", "two\\x1b[2J"]


@pytest.mark.slow
async def test_a_still_that_does_not_come_is_explained_by_the_camera(robot, monkeypatch, tmp_path):
    monkeypatch.setattr(RtpReceiver, "note", "camera arm is still starting")
    with pytest.raises(ResponseTimeout, match=r"no picture of sensor 1 in 0 s: .*; 101.1.106 says: camera arm is"):
        await still.take_picture(
            OCU("42.1.9", robot[1]), JausID(101, 1, 106), 1, None, "jpeg", file=tmp_path / "x.jpg", max_wait=0.0
        )
