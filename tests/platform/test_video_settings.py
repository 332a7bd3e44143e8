from __future__ import annotations

import dataclasses
from itertools import pairwise

import pytest

from jauspy.errors import ConfigError
from jauspy.platform.video_settings import LEVELS, H264Profile, H264Settings, VideoSettings

NAMES = [level.name for level in LEVELS]


@pytest.mark.parametrize(
    ("settings", "level"),
    [
        (VideoSettings(176, 144, 15, 64_000), "1"),
        (VideoSettings(176, 144, 15, 100_000), "1b"),
        (VideoSettings(352, 288, 30, 768_000), "1.3"),
        (VideoSettings(640, 480, 15, 2_000_000), "2.2"),
        (VideoSettings(640, 480, 30, 2_000_000), "3"),
        (VideoSettings(1280, 720, 30, 2_000_000), "3.1"),
        (VideoSettings(1280, 720, 30, 17_000_000), "3.2"),
        (VideoSettings(1280, 720, 30, 17_000_000, coding=H264Settings(H264Profile.HIGH)), "3.1"),
        (VideoSettings(1920, 1080, 30, 8_000_000), "4"),
        (VideoSettings(1920, 1080, 60, 8_000_000), "4.2"),
        (VideoSettings(7680, 16, 15, 2_000_000), "5.1"),
        (VideoSettings(7680, 4800, 60, 2_000_000), None),
    ],
)
def test_lowest_sufficient_level_is_selected(settings, level):
    assert settings.level == (None if level is None else NAMES.index(level))


def test_levels_are_ascending():
    for lower, higher in pairwise(LEVELS):
        assert all(a <= b for a, b in zip(lower[1:], higher[1:], strict=True))
        assert lower[1:] != higher[1:]


def test_a_level_that_is_too_low_is_refused():
    low = H264Settings(level=NAMES.index("2"))
    with pytest.raises(ConfigError, match="level 2 has no 640x480 with 15 pictures and 2000000 bits a second"):
        VideoSettings(coding=low)
    fitting = VideoSettings(320, 240, coding=low)
    assert fitting.level == NAMES.index("2")
    with pytest.raises(ConfigError, match="level 2"):
        dataclasses.replace(fitting, rate=60)


def test_duration_of_a_gradual_refresh():
    assert VideoSettings(640, 480, gop=60).refresh == 40
    assert VideoSettings(640, 480, gop=30).refresh == 30
