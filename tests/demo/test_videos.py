"""When a video of the demo counts as a success, as reduced, or as a failure."""

from __future__ import annotations

import asyncio
import time
from collections import deque
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("matplotlib", reason="the extra 'demo' is not installed")

from jauspy.demo import plan
from jauspy.demo.full_tour import VideoRecording
from jauspy.errors import RequestError

PICTURE: Any = object()
SLOW = "the robot's machine is too slow for camera arm: 320x240 at 5/s instead of 640x480 at 15/s"


def recorded(pictures: int, note: str = "", **counters: int) -> VideoRecording:
    """Ten seconds of a camera that is set to 15 pictures per second."""
    camera: Any = SimpleNamespace(counters=counters, note=note, taken=lambda _: None)
    recorder: Any = SimpleNamespace(pictures=pictures, add=lambda _: None)
    recording = VideoRecording("arm", camera, recorder, 15, deque(), began=0.0, ended=10.0)
    recording.add(PICTURE)
    return recording


@pytest.mark.parametrize(
    ("pictures", "note", "reached", "reduced"),
    [
        (140, "", True, False),
        (76, "", True, False),
        (74, "", False, False),
        (21, "", False, False),
        (140, SLOW, True, True),
        (50, SLOW, True, True),
        (10, SLOW, True, True),
        (6, SLOW, True, True),
        (4, SLOW, False, False),
        (0, SLOW, False, False),
    ],
)
def test_few_pictures_are_a_failure_or_reduced_if_the_camera_says_why(
    pictures: int, note: str, reached: bool, reduced: bool
) -> None:
    result = recorded(pictures, note).result()
    assert (result.reached, result.reduced) == (reached, reduced)
    assert (SLOW in result.measured) is bool(note)


def test_a_lost_packet_is_a_failure_in_any_case() -> None:
    assert recorded(140, lost=1).result().reached is False
    assert recorded(140, SLOW, lost=1).result().reached is False


async def test_what_a_camera_said_is_kept_and_its_start_is_forgotten() -> None:
    recording = recorded(1, "camera arm is still starting")
    await recording.begins()
    assert recording.note == ""
    recording.camera.note = SLOW  # type: ignore[misc] - not a real one
    recording.add(PICTURE)
    recording.camera.note = ""  # type: ignore[misc]
    recording.add(PICTURE)
    assert recording.note == SLOW


async def test_a_camera_that_says_that_it_starts_has_more_time() -> None:
    waiting = recorded(0, "camera arm is still starting")
    waiting.began = time.monotonic() - plan.CAMERA_TIMEOUT - 1.0
    beginning = asyncio.create_task(waiting.begins())
    await asyncio.sleep(0)
    assert not beginning.done()
    waiting.recorder.pictures = 1
    await asyncio.wait_for(beginning, 20.0)
    late = recorded(0, "camera arm is still starting")
    late.began = time.monotonic() - plan.LONG_CAMERA_TIMEOUT - 1.0
    with pytest.raises(RequestError, match="camera arm: no picture in 120 s; it says: camera arm is still starting"):
        await late.begins()
    silent = recorded(0)
    silent.began = time.monotonic() - plan.CAMERA_TIMEOUT - 1.0
    with pytest.raises(RequestError, match=r"camera arm: no picture in 40 s$"):
        await silent.begins()
