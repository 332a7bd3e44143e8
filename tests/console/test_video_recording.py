"""Recording in the console: a file that plays, its limits, and what is told."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import av
import numpy as np

from jauspy.console.video_recording import MAX_QUEUED, VideoRecording
from jauspy.errors import ConfigError
from jauspy.platform.video_settings import VideoSettings
from jauspy.video.h264 import H264Encoder
from jauspy.video.h264_payload import Picture


def pictures(count: int, width: int = 64) -> list[Picture]:
    encoder = H264Encoder(VideoSettings(width, 64, gop=255))
    image = np.zeros((64, width, 3), np.uint8)
    return [Picture(6000 * number, tuple(encoder.encode(image)), whole=True) for number in range(count)]


def frames(path: Path) -> int:
    with av.open(str(path)) as film:
        return sum(1 for _ in film.decode(video=0))


async def test_what_arrives_is_in_the_file(tmp_path: Path) -> None:
    recording = VideoRecording(tmp_path / "new", "101.1.106", min_free=0)
    for picture in pictures(20):
        recording.add(picture)
    await recording.close()
    await recording.close()
    assert recording.path.parent == tmp_path / "new"
    assert recording.path.name.startswith("101.1.106-")
    assert frames(recording.path) == recording.pictures == 20
    assert recording.size == recording.path.stat().st_size
    assert recording.summary.startswith("recorded 20 pictures (0.0 MB) to ")


async def test_another_size_begins_another_file(tmp_path: Path) -> None:
    recording = VideoRecording(tmp_path, "a", min_free=0)
    for picture in pictures(5) + pictures(7, width=96):
        recording.add(picture)
    await recording.close()
    first, second = sorted(tmp_path.iterdir(), key=lambda path: (len(path.name), path.name))
    assert (frames(first), frames(second)) == (5, 7)
    assert recording.pictures == 12
    assert " and 1 more" in recording.summary


async def test_nothing_recorded_leaves_no_file(tmp_path: Path) -> None:
    recording = VideoRecording(tmp_path, "a", min_free=0)
    recording.add(pictures(2)[1])
    await recording.close()
    assert list(tmp_path.iterdir()) == []
    assert recording.summary == "nothing was recorded: no picture arrived"


async def test_a_slow_disk_bounds_what_waits(tmp_path: Path) -> None:
    recording = VideoRecording(tmp_path, "a", min_free=0)
    key = pictures(1)[0]
    for _ in range(MAX_QUEUED + 5):  # nothing is written before the loop runs
        recording.add(key)
    await recording.close()
    assert recording.pictures == MAX_QUEUED
    assert recording.left_out == 5
    assert "5 left out" in recording.summary


async def test_a_full_disk_ends_it_and_is_reported(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="choose another folder with --recordings"):
        VideoRecording(tmp_path, "a", min_free=1 << 60)
    recording = VideoRecording(tmp_path, "a", min_free=0)
    recording._min_free = 1 << 60
    for picture in pictures(3):
        recording.add(picture)
    await asyncio.wait({recording.writing})
    assert recording.ended
    assert frames(recording.path) == 3
    assert "stay free" in recording.summary


async def test_a_folder_that_cannot_be_made(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(ConfigError, match=r"recordings cannot be kept in .*choose --recordings DIR"):
        VideoRecording(tmp_path / "file" / "below", "a")
