"""`jauspy listen` and `jauspy announce`, and the verbs of the client, with a whole robot on the kinematic backend."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

from tests.audio.signals import level, strongest, tone
from tests.helpers.command_line import jauspy, robot_in_thread

from jauspy import sync
from jauspy.audio.wav_files import WavWriter, read_wav
from jauspy.cli.up import with_folder
from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    RegisterDigitalResourceEndpoint as Register,
)
from jauspy.platform.sound import LoudspeakerSetup
from jauspy.platform.video_settings import RTP_SERVER_TYPE


@pytest.fixture(scope="module")
def robot(tmp_path_factory):
    with robot_in_thread() as running:
        with sync.OCU("43.1.1", running.local) as ocu:  # the worker of the microphone takes a second to start
            ocu.robot(101).microphone.record(tmp_path_factory.mktemp("sound") / "x.wav", seconds=0.1)
        yield running


@pytest.fixture
def message(tmp_path):
    with WavWriter(tmp_path / "message.wav") as file:
        file.add(tone(700.0, 1.5))
    return tmp_path / "message.wav"


@pytest.mark.slow
def test_robot_hears_what_an_operator_plays(robot, message, tmp_path):
    heard = tmp_path / "heard.wav"
    with sync.OCU("43.1.1", robot.local) as ocu, ThreadPoolExecutor(1) as thread:
        microphone = ocu.robot(101).microphone
        listening = thread.submit(microphone.record, heard, seconds=6.0)
        played = jauspy("announce", "101", str(message), "--connect", robot.local, "--json")
        assert listening.result() == pytest.approx(6.0, abs=0.03)
    assert json.loads(played.stdout)["seconds"] == pytest.approx(1.5)
    sound = read_wav(heard)
    assert strongest(sound) == pytest.approx(700.0, abs=2.0)
    assert level(sound) > -30.0


@pytest.mark.slow
def test_listen_says_what_it_recorded(robot, tmp_path):
    heard = tmp_path / "heard.wav"
    result = jauspy("listen", "101.1.113", "-o", str(heard), "--seconds", "1", "--connect", robot.local)
    said = " ".join(result.stdout.split())
    assert said.startswith("1.0 s in ")
    assert said.endswith("packets lost")
    result = jauspy("listen", "101", "-o", str(heard), "--seconds", "0.5", "--connect", robot.local, "--json")
    found = json.loads(result.stdout)
    assert found["seconds"] == pytest.approx(0.5, abs=0.03)
    assert found["counters"]["packets"] >= 20
    assert len(read_wav(heard)) == pytest.approx(24000, abs=1500)


@pytest.mark.slow
def test_motors_are_heard_and_louder_when_faster(robot, tmp_path):
    levels = {}
    with sync.OCU("42.1.1", robot.local) as ocu:
        found = ocu.robot(101)
        with found.control("drive"):
            for speed in (0.0, 0.3, 1.0):
                found.drive(linear=speed)
                found.microphone.record(tmp_path / "start.wav", seconds=1.0)
                found.microphone.record(tmp_path / "x.wav", seconds=1.0)
                levels[speed] = level(read_wav(tmp_path / "x.wav"))
            found.stop()
    assert levels[0.3] > levels[0.0] + 10.0
    assert levels[1.0] == pytest.approx(levels[0.3] + 15.7, abs=4.0)


@pytest.mark.slow
def test_foreign_network_gets_no_sound(robot, tmp_path):
    with sync.OCU("42.1.1", robot.local) as ocu:
        record = Register.DigitalResourceEndpointRec(RTP_SERVER_TYPE, "rtp://198.51.100.9:5004", None, 1)
        answer = ocu.query("101.1.113", Register(Register.RequestIDRec(1), record), expects=Confirm)
        assert answer.id == 0


def test_devices_that_are_not_there_get_a_sentence(robot, tmp_path):
    with sync.OCU("42.1.1", robot.local) as ocu:
        with pytest.raises(ConfigError, match="has no microphone 7; it has: 1"):
            ocu.robot(101).component(113).microphone(7).record(tmp_path / "x.wav", seconds=1.0)
        with pytest.raises(ConfigError, match="has no loudspeaker 1"):
            _play_on(ocu, 1, tmp_path)


def _play_on(ocu, number, folder):
    with WavWriter(folder / "short.wav") as file:
        file.add(tone(700.0, 0.1))
    ocu.robot(101).component(113).announcer(number).play(folder / "short.wav")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("listen", "101", "-o", "x.mp3"), "recordings are WAV files"),
        (("listen", "101", "-o", "missing/x.wav"), "its folder is not there"),
        (("listen", "101.1.255", "-o", "x.wav"), "has wildcards"),
        (("listen", "101.1.102", "-o", "x.wav"), "101.1.102 has no microphones"),
        (("announce", "101", "missing.wav"), "is no file"),
        (("announce", "101.1.102", "message.wav"), "plays nothing"),
    ],
)
def test_mistakes_get_a_sentence(robot, message, words, said, monkeypatch):
    monkeypatch.chdir(message.parent)
    result = jauspy(*words, "--connect", robot.local, status=1)
    assert said in " ".join(result.stderr.split())


@pytest.mark.slow
def test_folder_for_announcements_is_checked(tmp_path):
    speakers = [LoudspeakerSetup("horn", "base_link"), LoudspeakerSetup("siren", "base_link", folder="old")]
    assert [item.folder for item in with_folder(speakers, tmp_path / "said")] == [str(tmp_path / "said")] * 2
    with pytest.raises(ConfigError, match="is no folder, and none can be made there"):
        with_folder(speakers, tmp_path / "missing" / "said")
    (tmp_path / "file").touch()
    with pytest.raises(ConfigError, match="is no folder"):
        with_folder(speakers, tmp_path / "file")
    with pytest.raises(ConfigError, match="has no loudspeakers"):
        with_folder((), tmp_path)
