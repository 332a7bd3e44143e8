"""The view Tasks: sound as an endless WAV file with its level, and the texts of its cards."""

from __future__ import annotations

import io
import wave
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="the console needs the extra `console`")
pytest.importorskip("numpy", reason="sound needs NumPy")

import numpy as np

from jauspy.console.conventions import Conventions
from jauspy.console.listening import RATE, SILENT, Levels, _wav
from jauspy.console.panels.following import state_text
from jauspy.console.panels.way_back import result_text
from jauspy.errors import ResponseTimeout
from jauspy.ids import JausID
from jauspy.ocu.comms_lost import WayBack
from jauspy.ocu.following import Following

MICROPHONE = JausID(101, 1, 113)
PAGE = "page"
FRAME = 960
"""Samples of 20 ms at 48 kHz."""


class Hearing:
    """A microphone that hears half of full scale, then nothing, then fails."""

    def __init__(self, levels: Levels) -> None:
        self._levels = levels
        self.seen: list[float | None] = []

    async def sound(self) -> Any:
        for samples in (np.full(FRAME, 0.5, np.float32), np.full(FRAME, 2.0, np.float32), np.zeros(FRAME, np.float32)):
            yield samples
            self.seen.append(self._levels.of(PAGE))
        raise ResponseTimeout("101.1.113 sends nothing any more")


async def test_sound_is_a_wav_file_with_levels() -> None:
    levels = Levels()
    hearing = Hearing(levels)
    robot = SimpleNamespace(component=lambda _: SimpleNamespace(microphone=lambda: hearing))
    console: Any = SimpleNamespace(levels=levels, fleet=SimpleNamespace(robots={101: robot}))
    data = b"".join([part async for part in _wav(console, MICROPHONE, PAGE)])
    with wave.open(io.BytesIO(data)) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 2, RATE)
    samples = np.frombuffer(data[44:], "<i2").reshape(3, FRAME // 2)
    assert samples[:, 0].tolist() == [16383, 32767, 0]  # at most full scale
    assert np.ptp(samples, axis=1).tolist() == [0, 0, 0]
    assert hearing.seen[0] == pytest.approx(-6.02, abs=0.01)
    assert hearing.seen[2] == SILENT
    assert (levels.of(PAGE), levels.count) == (None, 0), "the page listens no more"
    assert "sends nothing" in levels.problems[PAGE]
    levels.forget(PAGE)
    assert levels.problems == {}


def test_the_end_of_a_way_back_is_explained() -> None:
    assert result_text(WayBack(5.0, "distance"), 5.0, Conventions()) == "drove 5.0 m back"
    assert result_text(WayBack(3.04, "path"), 50.0, Conventions()) == "drove 3.0 m back of 50.0 m: its path begins here"


def test_the_follower_is_described() -> None:
    following = Following(is_following=True, leader=JausID(102, 1, 102), gap=2.5, lag=0.0, max_gap=None, offset=None)
    assert state_text(following, Conventions()) == "follows 102.1.102 at 2.5 m"
    nobody = Following(is_following=False, leader=None, gap=None, lag=None, max_gap=None, offset=None)
    assert state_text(nobody, Conventions()) == "follows nobody"
