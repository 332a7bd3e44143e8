"""Session descriptions with the stream's parameter sets: a player that joins late knows the stream at once."""

from __future__ import annotations

import base64
import re
import threading
import time

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import av

from jauspy.platform.video_settings import H264Profile, H264Settings, VideoSettings
from jauspy.video.h264 import H264Encoder
from jauspy.video.h264_payload import IDR, PPS, SPS, nal_type
from jauspy.video.receiver import RtpReceiver
from jauspy.video.rtp import session_description
from jauspy.video.sender import RtpSender


def encoded(settings, scene, count):
    encoder = H264Encoder(settings)
    return [encoder.encode(scene(number, settings.width, settings.height)) for number in range(count)]


def sets_of(picture):
    return [next(nal for nal in picture if nal_type(nal) == kind) for kind in (SPS, PPS)]


def test_description_has_profile_level_and_parameter_sets(scene):
    (picture,) = encoded(VideoSettings(coding=H264Settings(H264Profile.HIGH, level=9)), scene, 1)
    text = session_description("front", "127.0.0.1", 5004, sets_of(picture))
    found = re.search(r"profile-level-id=(\w{6});sprop-parameter-sets=([^,]+),(\S+)\r\n", text)
    assert [base64.b64decode(each) for each in found.groups()[1:]] == sets_of(picture)
    profile, _, level = bytes.fromhex(found[1])
    assert (profile, level) == (100, 31)
    assert "sprop" not in session_description("front", "127.0.0.1", 5004)


def test_late_player_knows_the_size_before_the_next_key_frame(scene, tmp_path):
    settings = VideoSettings(320, 240, gop=200)
    first, *others = encoded(settings, scene, 20)
    assert not any(nal_type(nal) in (SPS, IDR) for picture in others for nal in picture)
    with RtpReceiver() as free:
        port = free.port
    sdp, ending = tmp_path / "late.sdp", threading.Event()
    sdp.write_text(session_description("late", "127.0.0.1", port, sets_of(first)), newline="")

    def send(sender):
        number = 0
        while not ending.wait(0.03):
            sender.send(others[number % len(others)], time.monotonic(), time.time())
            number += 1

    with RtpSender() as sender:
        sender.add(("127.0.0.1", port))
        sender.send(first, time.monotonic(), time.time())  # nobody listens yet
        sending = threading.Thread(target=send, args=(sender,))
        sending.start()
        try:
            options = {"protocol_whitelist": "file,udp,rtp", "analyzeduration": "300000", "fflags": "nobuffer"}
            with av.open(str(sdp), format="sdp", options=options, timeout=(10.0, 5.0)) as opened:
                size = opened.streams.video[0].codec_context.width, opened.streams.video[0].codec_context.height
        finally:
            ending.set()
            sending.join()
    assert size == (320, 240)  # without the sets, the player finds none within ten seconds
