"""A camera on a machine that is too slow: what is sent, what receivers are told, and what recordings are like."""

from __future__ import annotations

import dataclasses
import math
import os
import random
import select
import signal
import socket
import subprocess
import sys
from types import SimpleNamespace

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import av

from jauspy.backends.kinematic import KinematicRobot
from jauspy.platform.camera import CameraFrame, CameraSetup
from jauspy.platform.imaging_settings import IDEAL
from jauspy.platform.video_settings import StillFormat, StillSettings, VideoSettings
from jauspy.robot.robot_files import load, robot_model
from jauspy.testing import until
from jauspy.video import camera_process, rtp
from jauspy.video.camera_process import CameraProcess, processor_time, starting_text
from jauspy.video.camera_protocol import AddReceiver, ChangeSettings, StartCamera, StreamReduced, TakeStill
from jauspy.video.camera_worker import CameraWorker
from jauspy.video.h264 import H264Decoder
from jauspy.video.receiver import NOTE_TIMEOUT, RtpReceiver
from jauspy.video.recorder import Recorder
from jauspy.video.sender import RtpSender

SETTINGS = VideoSettings(320, 240, 15)
SLOW = "the robot's machine is too slow for camera front: 160x120 at 5/s, of lower quality, instead of 320x240 at 15/s"


class SlowSession:
    """A `CameraSession` in which each picture takes a while, less with a lower quality and fewer pixels."""

    description, reduced, simplifications = "paints", False, 1

    def __init__(self, scene):
        self.scene, self.now, self.seconds, self.number = scene, 0.0, 0.01, 0
        self.looked, self.lower = [], 0

    def simplify(self, steps):
        self.lower = steps

    def release(self):
        """Nothing is bound to a thread."""

    def close(self):
        """Nothing is open."""

    def look(self, width, height, *, thoroughly=False, fov=None, distances=False):
        self.looked.append((width, height))
        self.number += 1
        self.now += self.seconds * 0.6**self.lower * {160: 0.6}.get(width, 1.0)
        return CameraFrame(self.scene(self.number, width, height), self.now)


class Bench:
    """A worker with a clock that only its pictures and its waiting advance."""

    def __init__(self, scene):
        self.session, self.reports = SlowSession(scene), []
        setup = CameraSetup("front", "chassis_camera_link", math.radians(80.0), IDEAL)
        camera = SimpleNamespace(setup=setup, open=lambda: self.session)
        start = StartCamera(camera, SETTINGS, IDEAL.initial, True, 15)
        self.worker = CameraWorker(start, self.reports.append, lambda: self.session.now, lambda: (0.0, 0.0))

    def run(self, seconds, take=lambda: None):
        end = self.session.now + seconds
        while self.session.now < end:
            self.session.now += self.worker.time_to_frame()
            self.worker.stream_frame()
            take()

    def said(self):
        return [report.text for report in self.reports if isinstance(report, StreamReduced)]


@pytest.fixture
def bench(scene):
    made = Bench(scene)
    yield made
    made.worker.close()


@pytest.fixture
def receiver():
    with RtpReceiver() as made:
        yield made


def at(receiver):
    return ("127.0.0.1", receiver.port)


@pytest.mark.slow
def test_stream_and_recording_keep_their_size_while_pictures_get_smaller_and_larger_again(bench, receiver, tmp_path):
    bench.worker.execute(AddReceiver(at(receiver)))
    decoder, sizes, times, notes = H264Decoder(), set(), [], []
    with Recorder(tmp_path / "front.mp4") as recorder:

        def take():
            for picture in receiver.take():
                recorder.add(picture)
                sizes.add(decoder.decode(picture).shape)
                times.append(bench.session.now)
            if receiver.note not in notes:
                notes.append(receiver.note)

        bench.run(10.0, take)
        assert bench.said() == []
        bench.session.seconds = 0.42
        bench.run(20.0, take)
        assert bench.said() == [SLOW]
        assert notes == ["", SLOW]
        assert set(bench.session.looked[-20:]) == {(160, 120)}
        assert len([time for time in times if time > bench.session.now - 4.0]) == pytest.approx(20, abs=2)
        bench.session.seconds = 0.01
        bench.run(30.0, take)
        assert bench.said() == [SLOW, ""]
        assert notes == ["", SLOW]
        assert (receiver.note, bench.session.lower) == ("", 0)
        assert set(bench.session.looked[-20:]) == {(320, 240)}
        assert not recorder.ended, "a change of the parameter sets would end it"
        pictures = recorder.pictures
    assert sizes == {(240, 320, 3)}
    with av.open(str(tmp_path / "front.mp4")) as film:
        assert len(list(film.decode(video=0))) == pictures == len(times)


def test_other_settings_are_tried_in_full(bench, receiver):
    bench.worker.execute(AddReceiver(at(receiver)))
    bench.session.seconds = 0.42
    bench.run(10.0)
    bench.worker.execute(ChangeSettings(dataclasses.replace(SETTINGS, gop=60)))
    assert bench.said() == [SLOW]
    bench.worker.execute(ChangeSettings(dataclasses.replace(SETTINGS, rate=10)))
    assert bench.said() == [SLOW, ""]
    bench.run(1.0)
    assert bench.session.looked[-1] == (320, 240)


@pytest.mark.slow
def test_a_still_is_no_sign_of_a_slow_machine_and_is_made_with_less_effort_on_one(bench, receiver):
    bench.worker.execute(AddReceiver(at(receiver)))
    wanted = TakeStill(1, StillSettings(640, 480, StillFormat.JPEG))
    bench.run(3.0)
    bench.session.seconds = 5.0
    bench.worker.execute(wanted)
    assert bench.session.looked[-1] == (1280, 960)
    bench.session.seconds = 0.01
    bench.run(10.0)
    assert bench.said() == []
    bench.session.seconds = 0.42
    bench.run(10.0)
    bench.worker.execute(wanted)
    assert bench.session.looked[-1] == (640, 480)


# --- notes ------------------------------------------------------------------------------------------------------------


def heard(receiver):
    assert select.select([receiver._rtcp], [], [], 20.0)[0], "nothing came"
    return receiver.note


def test_a_note_comes_before_the_first_picture_and_ends_with_it(scene, receiver):
    with RtpSender("front") as sender:
        sender.add(at(receiver))
        sender.announce("camera front is still starting")
        assert heard(receiver) == "camera front is still starting"
        assert receiver.counters == {}
        bench = Bench(scene)
        bench.worker.execute(AddReceiver(at(receiver)))
        bench.run(0.5)
        bench.worker.close()
        assert receiver.take()
        assert receiver.note == ""


def test_notes_of_strangers_do_not_replace_those_of_the_source_and_old_ones_end(bench):
    now = 0.0
    with RtpReceiver(clock=lambda: now) as receiver, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        bench.worker.execute(AddReceiver(at(receiver)))
        bench.session.seconds = 0.42
        bench.run(10.0, receiver.take)
        assert receiver.note == SLOW
        before = receiver.counters.get("foreign", 0)
        stranger.sendto(rtp.source_note(1, "front", "send your password"), ("127.0.0.1", receiver.port + 1))
        assert select.select([receiver._rtcp], [], [], 20.0)[0]
        assert receiver.note == SLOW
        assert receiver.counters["foreign"] == before + 1
        now = NOTE_TIMEOUT + 1.0
        assert receiver.note == ""


def test_a_long_note_is_cut_and_damaged_reports_are_nothing():
    text = "ü" * 200
    found = rtp.noted(rtp.source_note(7, "front", text))
    assert found is not None
    assert found.ssrc == 7
    assert found.text.startswith("ü" * 127)
    assert len(found.text) <= 128
    assert rtp.noted(rtp.source_note(7, "front", "")) == (7, "")
    whole = rtp.sender_report(9, "front", "slow", utc=1e9, timestamp=5, packets=1, octets=1)
    assert rtp.noted(whole) == (9, "slow")
    assert rtp.sender_clock(whole) is not None
    chance = random.Random(1)
    for _ in range(20_000):
        damaged = bytearray(whole[: chance.randrange(len(whole) + 1)])
        for _ in range(chance.randrange(4)):
            if damaged:
                damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        found = rtp.noted(bytes(damaged))
        assert found is None or len(found.text) <= rtp.MAX_TEXT


# --- the process ------------------------------------------------------------------------------------------------------


@pytest.mark.slow
async def test_receivers_and_the_log_are_told_that_a_camera_starts(monkeypatch, caplog, receiver):
    """A worker that gets nothing of the processor, here because it is stopped."""
    monkeypatch.setattr(camera_process, "NOTICE_INTERVAL", 0.05)
    monkeypatch.setattr(camera_process, "LONG_START", 0.1)
    setup = CameraSetup("front", "chassis_camera_link", math.radians(80.0))
    robot = KinematicRobot(dataclasses.replace(robot_model(load("inc1")), cameras=(setup,)))
    async with CameraProcess(robot.cameras["front"], SETTINGS) as camera:
        camera.watch(at(receiver))
        camera.watch(("127.0.0.1", 2000), playing=False)
        await until(lambda: camera.pid is not None, 20.0)
        os.kill(camera.pid, signal.SIGSTOP)
        await until(lambda: "is still starting" in receiver.note, 20.0)
        assert "front is still starting, since the robot's machine is busy: its process got " in receiver.note
        await until(lambda: "camera front is still starting" in caplog.text, 20.0)
        os.kill(camera.pid, signal.SIGCONT)
        await until(receiver.take, 100.0)
        await until(lambda: camera.counters["pictures"], 20.0)
        assert receiver.note == ""
        logged = [record for record in caplog.records if "still starting" in record.message]
        assert [record.levelname for record in logged] == ["WARNING"]
    robot.close()


async def test_a_reduction_is_logged_and_ends_with_the_worker(caplog, bench):
    caplog.set_level("INFO", "jauspy.video")
    camera = CameraProcess(SimpleNamespace(setup=CameraSetup("front", "link", 1.0)), SETTINGS)
    camera._on_message(StreamReduced(SLOW))
    assert (camera.reduced, camera.counters["reduced"]) == (SLOW, 1)
    camera._on_message(StreamReduced(""))
    assert camera.reduced == ""
    assert [record.message for record in caplog.records] == [SLOW, "camera front: sends what is set again"]


def test_the_share_of_a_processor_that_a_process_got():
    work = "import time\nwhile time.process_time() < 0.3: pass\nprint(flush=True)\ninput()"
    with subprocess.Popen([sys.executable, "-c", work], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        process.stdout.readline()
        assert processor_time(process.pid) == pytest.approx(0.3, abs=0.1)
        process.communicate(b"\n")
    assert processor_time(process.pid) == 0.0
    assert starting_text("arm", 12.0, 0.5) == (
        "camera arm is still starting, since the robot's machine is busy: its process got 4 % of a processor in 12 s"
    )
    assert "busy" not in starting_text("arm", 4.0, 3.0)
