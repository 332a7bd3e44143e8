from __future__ import annotations

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import numpy as np

from jauspy.errors import ConfigError
from jauspy.platform.video_settings import H264Profile, H264Settings, Preset, VideoSettings
from jauspy.video import h264_payload
from jauspy.video.h264 import H264Decoder, H264Encoder
from jauspy.video.h264_payload import MAX_PAYLOAD, Picture
from jauspy.video.imaging import read_numbers


def kinds(nals):
    return [h264_payload.nal_type(unit) for unit in nals]


def test_idr_pictures_include_parameter_sets(scene):
    encoder = H264Encoder(VideoSettings(gop=5))
    pictures = [kinds(encoder.encode(scene(number))) for number in range(11)]
    for number, found in enumerate(pictures):
        if number % 5 == 0:
            assert found[:2] == [h264_payload.SPS, h264_payload.PPS]
            assert h264_payload.IDR in found
        else:
            assert set(found) == {1}


def test_idr_can_be_requested(scene):
    encoder = H264Encoder()
    wanted = [2, 3, 7]
    found = [h264_payload.IDR in kinds(encoder.encode(scene(number), idr=number in wanted)) for number in range(9)]
    assert [number for number, idr in enumerate(found) if idr] == [0, *wanted]


def test_pictures_are_encoded_without_delay(scene):
    encoder, decoder = H264Encoder(), H264Decoder()
    for number in range(8):
        image = decoder.decode(Picture(number, tuple(encoder.encode(scene(number))), whole=True))
        assert read_numbers(image) == [number]
        assert np.abs(image.astype(int) - scene(number)).mean() < 12.0


def test_a_slice_fits_into_a_packet(scene):
    encoder = H264Encoder(VideoSettings(1280, 720, bit_rate=8_000_000))
    sizes = [len(unit) for number in range(4) for unit in encoder.encode(scene(number, 1280, 720))]
    assert max(sizes) <= MAX_PAYLOAD
    assert len(sizes) > 40


def test_the_size_changes_with_the_next_picture(scene):
    encoder, decoder = H264Encoder(), H264Decoder()
    for width, height in ((640, 480), (320, 240), (1280, 720)):
        encoder.settings = VideoSettings(width, height)
        nals = encoder.encode(scene(3, width, height))
        assert h264_payload.IDR in kinds(nals)
        assert decoder.decode(Picture(0, tuple(nals), whole=True)).shape == (height, width, 3)


def test_bit_rate_is_kept_and_changes_at_once(scene):
    encoder = H264Encoder(VideoSettings(bit_rate=2_000_000, rate=15))
    measured = []
    for bit_rate in (2_000_000, 500_000):
        encoder.settings = VideoSettings(bit_rate=bit_rate, rate=15)
        size = sum(len(unit) for number in range(45) for unit in encoder.encode(scene(number)))
        measured.append(size * 8 / 3.0)
    assert 1_200_000 < measured[0] < 2_300_000
    assert 350_000 < measured[1] < 650_000


def test_picture_of_another_size_is_an_error(scene):
    with pytest.raises(ConfigError, match="320x240 for 640x480"):
        H264Encoder().encode(scene(0, 320, 240))


@pytest.mark.parametrize(
    ("wrong", "said"),
    [({"rate": 0}, "rate = 0 is not in 1..60"), ({"width": 641}, "must be even"), ({"bit_rate": 1}, "bit_rate = 1")],
)
def test_invalid_settings_are_rejected(wrong, said):
    with pytest.raises(ConfigError, match=said):
        VideoSettings(**wrong)


def test_undecodable_data_is_counted():
    decoder = H264Decoder()
    assert decoder.decode(Picture(0, (b"\x65\xff\xff\xff", b"\x41nonsense"), whole=True)) is None
    assert decoder.counters["undecodable"] == 1


# --- as H264VideoEncoding sets it


@pytest.mark.parametrize(
    ("profile", "number"), [(H264Profile.BASELINE, 66), (H264Profile.MAIN, 77), (H264Profile.HIGH, 100)]
)
@pytest.mark.parametrize("preset", Preset)
def test_profile_and_level_are_those_of_the_stream(scene, profile, number, preset):
    for level, reported in ((None, 22), (9, 31)):
        encoder = H264Encoder(VideoSettings(coding=H264Settings(profile, level, preset)))
        decoder = H264Decoder()
        pictures = [tuple(encoder.encode(scene(each))) for each in range(3)]
        sps = pictures[0][0]
        assert (h264_payload.nal_type(sps), sps[1], sps[3]) == (h264_payload.SPS, number, reported)
        images = [decoder.decode(Picture(each, units, whole=True)) for each, units in enumerate(pictures)]
        assert [read_numbers(image) for image in images] == [[0], [1], [2]]


def test_constrained_baseline_is_signalled(scene):
    sps = H264Encoder().encode(scene(0))[0]
    assert sps[2] & 0b0100_0000


def gradual():
    return H264Encoder(VideoSettings(gop=20, coding=H264Settings(gradual=True)))


def test_gradual_refresh_has_no_large_pictures(scene):
    """Only the first one is whole, and any that is asked for."""
    encoder = gradual()
    pictures = [encoder.encode(scene(number), idr=number == 30) for number in range(45)]
    assert [number for number, units in enumerate(pictures) if h264_payload.IDR in kinds(units)] == [0, 30]
    sizes = [sum(map(len, units)) for units in pictures]
    assert max(sizes[10:30]) < 0.5 * sizes[0]


def test_gradual_refresh_repairs_losses(scene):
    encoder, decoder = gradual(), H264Decoder()
    seen = []
    for number in range(70):
        units = tuple(encoder.encode(scene(number)))
        if number not in {31, 32}:
            seen.append(decoder.decode(Picture(number, units, whole=True)))
    assert h264_payload.IDR not in kinds(units)
    assert np.abs(seen[-1].astype(int) - scene(69)).mean() < 12.0
