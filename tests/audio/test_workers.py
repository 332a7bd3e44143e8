"""The workers of microphones and loudspeakers, without their processes, on a clock that the test sets."""

from __future__ import annotations

import socket
from pathlib import Path

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")
pytest.importorskip("av", reason="the extra 'video' is not installed")

import numpy as np
from tests.audio.signals import frames, joined, level, packets, strongest, tone
from tests.helpers.robot import described

from jauspy.audio.coding import FRAME, FRAME_TIME
from jauspy.audio.loudspeaker_worker import MAX_BURST, MAX_FILES, SILENCE, LoudspeakerWorker
from jauspy.audio.microphone_worker import MAX_LAG, MicrophoneWorker
from jauspy.audio.receiver import AudioReceiver
from jauspy.audio.wav_files import WavWriter, read_wav
from jauspy.audio.worker_messages import (
    AddListener,
    ChangeAudio,
    MachineMoved,
    OpenPort,
    PlaySource,
    PortOpened,
    RemoveListener,
    SoundPlayed,
    StartLoudspeaker,
    StartMicrophone,
)
from jauspy.errors import ConfigError
from jauspy.platform.sound import AudioSettings, Coding, LoudspeakerSetup
from jauspy.platform.sound_scene import MachineState, SoundScene
from jauspy.worker_process import CountersReport

HERE = frozenset({"127.0.0.1"})


class Clock:
    now = 100.0

    def __call__(self) -> float:
        return self.now


class Mike:
    """A microphone of inc1, and one who listens."""

    def __init__(self, receiver: AudioReceiver) -> None:
        _, model = described("inc1")
        self.clock, self.reports, self.receiver = Clock(), [], receiver
        start = StartMicrophone(SoundScene.of(model, model.microphones[0]), AudioSettings())
        self.worker = MicrophoneWorker(start, self.reports.append, self.clock)

    def listen(self, coding: Coding = Coding.OPUS) -> None:
        self.worker.execute(AddListener(("127.0.0.1", self.receiver.port), True, coding))

    def hear(self, seconds: float):
        found = []
        for _ in range(round(seconds / FRAME_TIME)):
            self.clock.now += FRAME_TIME
            self.worker.send_due()
            found += self.receiver.take()
        return joined(found)


@pytest.fixture
def mike():
    with AudioReceiver() as receiver:
        mike = Mike(receiver)
        yield mike
        mike.worker.close()


def test_microphone_waits_until_somebody_listens(mike):
    assert mike.worker.time_to_frame() is None
    mike.listen()
    assert mike.worker.time_to_frame() == 0.0
    mike.worker.execute(RemoveListener(("127.0.0.1", mike.receiver.port)))
    assert mike.worker.time_to_frame() is None


@pytest.mark.parametrize("coding", Coding)
def test_tracks_are_heard_and_their_level_rises_with_speed(mike, coding):
    mike.listen(coding)
    levels = []
    for speed in (0.0, 0.3, 0.6, 1.2):
        mike.worker.execute(MachineMoved(MachineState(left=speed, right=speed)))
        mike.hear(0.4)
        levels.append(level(mike.hear(1.0)))
    assert levels[1] > levels[0] + 15.0
    assert levels[2] == pytest.approx(levels[1] + 9.0, abs=3.0)
    assert levels[3] == pytest.approx(levels[2] + 9.0, abs=3.0)


def test_loudspeaker_nearby_is_heard(mike):
    mike.listen()
    found = []
    for frame in frames(tone(650.0, 1.0)):
        mike.worker.execute(SoundPlayed("announcer", frame.tobytes()))
        found.append(mike.hear(FRAME_TIME))
    assert strongest(joined(found)[9600:]) == pytest.approx(650.0, abs=3.0)


def test_gain_changes_the_level(mike):
    mike.listen()
    mike.worker.execute(MachineMoved(MachineState(left=0.5, right=0.5)))
    mike.hear(0.5)
    before = level(mike.hear(1.0))
    mike.worker.execute(ChangeAudio(AudioSettings(gain=0.125)))
    mike.hear(0.2)
    assert level(mike.hear(1.0)) == pytest.approx(before - 12.0, abs=1.5)


def test_microphone_that_was_late_leaves_out_what_it_missed(mike):
    mike.listen()
    mike.hear(0.2)
    mike.clock.now += 10 * MAX_LAG
    mike.worker.send_due()
    assert len(mike.receiver.take()) <= 1
    mike.clock.now += 2.0
    mike.worker.send_due()
    (counters,) = [report for report in mike.reports if isinstance(report, CountersReport)][-1:]
    assert counters.counters["skipped"] >= 90


def test_address_that_cannot_be_sent_to_is_counted(mike):
    mike.worker.execute(AddListener(("nowhere.example", 5004), True, Coding.OPUS))
    mike.clock.now += 2.0
    mike.worker.send_due()
    (counters,) = [report for report in mike.reports if isinstance(report, CountersReport)][-1:]
    assert counters.counters["refused"] == 1


class Speaker:
    """A loudspeaker, and a socket that sends to it."""

    def __init__(self, folder: Path | None) -> None:
        self.clock, self.reports = Clock(), []
        setup = LoudspeakerSetup("announcer", "base_link", folder=str(folder) if folder else None)
        self.worker = LoudspeakerWorker(StartLoudspeaker(setup, AudioSettings()), self.reports.append, self.clock)
        self.worker.execute(OpenPort("127.0.0.1"))
        (opened,) = [report for report in self.reports if isinstance(report, PortOpened)]
        self.port = opened.port
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))

    def send(self, sent, *, pace: float = FRAME_TIME) -> None:
        for packet in sent:
            self.socket.sendto(packet if isinstance(packet, bytes) else packet.encode(), ("127.0.0.1", self.port))
            self.clock.now += pace
            self.worker.play_received()

    @property
    def played(self):
        return joined(np.frombuffer(each.frame, np.float32) for each in self.reports if isinstance(each, SoundPlayed))

    @property
    def counters(self):
        self.clock.now += 2.0
        self.worker.play_received()
        return [report for report in self.reports if isinstance(report, CountersReport)][-1].counters

    def close(self) -> None:
        self.worker.close()
        self.socket.close()


@pytest.fixture
def speaker(tmp_path):
    speaker = Speaker(tmp_path / "announcements")
    yield speaker
    speaker.close()


def test_message_is_played_and_kept_as_a_file(speaker, tmp_path):
    speaker.worker.execute(PlaySource(HERE))
    speaker.send(packets(tone(520.0, 1.0)))
    speaker.worker.execute(PlaySource(frozenset()))
    (file,) = (tmp_path / "announcements").iterdir()
    assert file.name.startswith("announcer-")
    sound = read_wav(file)
    assert strongest(sound[9600:]) == pytest.approx(520.0, abs=3.0)
    assert len(sound) == 50 * FRAME
    assert strongest(speaker.played[9600:]) == pytest.approx(520.0, abs=3.0)
    assert level(speaker.played[9600:]) == pytest.approx(level(tone(520.0, 1.0)), abs=1.0)


def test_nothing_is_played_until_a_client_in_control_starts_it(speaker, tmp_path):
    speaker.send(packets(tone(520.0, 0.5)))
    assert not len(speaker.played)
    speaker.worker.execute(PlaySource(frozenset({"192.0.2.7"})))
    speaker.send(packets(tone(520.0, 0.5), sequence=500))
    assert not len(speaker.played)
    assert speaker.counters["refused"] == 50
    assert not (tmp_path / "announcements").exists()


def test_only_the_given_port_may_send(speaker):
    own = speaker.socket.getsockname()[1]
    speaker.worker.execute(PlaySource(HERE, own + 1))
    speaker.send(packets(tone(520.0, 0.5)))
    assert not len(speaker.played)
    speaker.worker.execute(PlaySource(HERE, own))
    speaker.send(packets(tone(520.0, 0.5), sequence=500))
    assert len(speaker.played)


def test_lost_packets_do_not_shorten_the_message(speaker):
    speaker.worker.execute(PlaySource(HERE))
    speaker.send([packet for number, packet in enumerate(packets(tone(520.0, 1.0))) if number % 10 != 5])
    speaker.worker.execute(PlaySource(frozenset()))
    assert len(speaker.played) == 50 * FRAME
    counters = speaker.counters
    assert counters["lost"] == counters["concealed"] == 5


def test_flood_is_played_at_no_more_than_its_time(speaker):
    speaker.worker.execute(PlaySource(HERE))
    speaker.send(packets(tone(520.0, 4.0)), pace=0.0)
    assert len(speaker.played) <= MAX_BURST * FRAME
    assert speaker.counters["too_fast"] == 200 - MAX_BURST


def test_garbage_is_counted(speaker):
    speaker.worker.execute(PlaySource(HERE))
    sent = packets(tone(520.0, 1.0))
    speaker.send([packet for pair in zip(sent, [b"\x80garbage!!!!!", b"", b"x"] * 17, strict=False) for packet in pair])
    speaker.worker.execute(PlaySource(frozenset()))
    assert len(speaker.played) == 50 * FRAME
    assert speaker.counters["not_rtp"] >= 30


def test_recording_ends_after_a_silence_and_the_next_one_is_another_file(speaker, tmp_path):
    speaker.worker.execute(PlaySource(HERE))
    speaker.send(packets(tone(520.0, 0.5)))
    speaker.clock.now += SILENCE + 0.1
    speaker.worker.play_received()
    speaker.send(packets(tone(880.0, 0.5), sequence=7))
    speaker.worker.close()
    files = sorted((tmp_path / "announcements").iterdir())
    assert [round(strongest(read_wav(file)[9600:]), -1) for file in files] == [520.0, 880.0]


def test_full_folder_gets_no_more_files(speaker, tmp_path):
    folder = tmp_path / "announcements"
    folder.mkdir()
    for number in range(MAX_FILES):
        (folder / f"{number}.wav").touch()
    speaker.worker.execute(PlaySource(HERE))
    speaker.send(packets(tone(520.0, 0.5)))
    assert len(speaker.played), "it is still played"
    assert len(list(folder.iterdir())) == MAX_FILES
    assert speaker.counters["unrecorded"]


def test_folder_that_is_a_link_gets_no_files(speaker, tmp_path):
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "announcements").symlink_to(tmp_path / "elsewhere")
    speaker.worker.execute(PlaySource(HERE))
    speaker.send(packets(tone(520.0, 0.5)))
    assert not list((tmp_path / "elsewhere").iterdir())
    assert speaker.counters["unrecorded"]


def test_loudspeaker_without_a_folder_keeps_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    speaker = Speaker(None)
    speaker.worker.execute(PlaySource(HERE))
    speaker.send(packets(tone(520.0, 0.5)))
    speaker.close()
    assert len(speaker.played)
    assert not list(tmp_path.iterdir())


def test_port_that_is_taken_is_reported():
    with AudioReceiver() as other:
        setup, reports = LoudspeakerSetup("announcer", "base_link", port=other.port), []
        worker = LoudspeakerWorker(StartLoudspeaker(setup, AudioSettings()), reports.append, Clock())
        worker.execute(OpenPort("127.0.0.1"))
        assert PortOpened("127.0.0.1", 0) in reports
        worker.close()


def test_machine_without_a_sound_card_says_so(caplog):
    from jauspy.audio.sound_card import open_sound_card

    try:
        import sounddevice
    except (ImportError, OSError):
        assert open_sound_card("announcer") is None
        assert "loudspeaker announcer: no sound card is used" in caplog.text
    else:
        pytest.skip(f"sounddevice {sounddevice.__version__} is installed")


@pytest.mark.parametrize("content", [b"", b"RIFF", b"RIFF\xff\xff\xff\xffWAVEfmt ", b"\x00" * 4000])
def test_file_that_is_no_wav_is_refused(tmp_path, content):
    path = tmp_path / "x.wav"
    path.write_bytes(content)
    with pytest.raises(ConfigError, match=r"x\.wav: "):
        read_wav(path)
    with pytest.raises(ConfigError, match="is no file"):
        read_wav(tmp_path)


def test_wav_of_another_rate_keeps_its_frequency(tmp_path):
    import wave

    path = tmp_path / "x.wav"
    with wave.open(str(path), "wb") as file:
        file.setnchannels(2)
        file.setsampwidth(2)
        file.setframerate(22050)
        one = (12000 * np.sin(2 * np.pi * 600 * np.arange(22050) / 22050)).astype("<i2")
        file.writeframes(np.repeat(one, 2).tobytes())
    sound = read_wav(path)
    assert len(sound) == pytest.approx(48000, abs=200)
    assert strongest(sound) == pytest.approx(600.0, abs=2.0)


def test_recording_does_not_grow_without_end(tmp_path, monkeypatch):
    monkeypatch.setattr("jauspy.audio.wav_files.MAX_LENGTH", 0.5)
    with WavWriter(tmp_path / "x.wav") as file:
        for frame in frames(tone(500.0, 1.0)):
            file.add(frame)
        assert file.seconds == 0.5
    assert len(read_wav(tmp_path / "x.wav")) == 24000
