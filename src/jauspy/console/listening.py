"""Sound of robots for browsers: an endless WAV file, since no browser plays Opus over RTP itself.

The console receives the microphone's stream once for each listener, decodes it, and sends samples of 16 bits at 24 kHz.
"""

from __future__ import annotations

import struct
from collections.abc import AsyncIterator
from contextlib import aclosing
from typing import TYPE_CHECKING, Final

from fastapi import FastAPI, HTTPException
from fastapi.responses import StreamingResponse

from jauspy.audio import need_audio
from jauspy.console.languages import sentence
from jauspy.console.users import current_user
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.ocu.sound import MICROPHONE

if TYPE_CHECKING:
    from jauspy.console.console import Console

RATE: Final = 24_000
"""Samples a second."""
STEP: Final = 2
"""Every second sample of 48 kHz, as the mean of two, is sent."""
MAX_LISTENERS: Final = 4
"""Streams at once, of all browsers."""
ENDLESS: Final = 0xFFFFFFFF
SILENT: Final = -90.0
"""dBFS that stand for no sound."""


class Levels:
    """The loudness of what browsers hear, by the tokens of their pages."""

    def __init__(self) -> None:
        self._levels: dict[str, float] = {}
        self.problems: dict[str, str] = {}
        """Why a page hears nothing any more."""

    @property
    def count(self) -> int:
        """Streams that are open."""
        return len(self._levels)

    def of(self, token: str) -> float | None:
        """DB below full scale of the last 20 ms; None for a page that does not listen."""
        return self._levels.get(token)

    def begin(self, token: str) -> None:
        """Note that a page listens."""
        self._levels[token] = SILENT
        self.problems.pop(token, None)

    def set(self, token: str, level: float) -> None:
        """Note the present level."""
        self._levels[token] = level

    def end(self, token: str, problem: str = "") -> None:
        """Note that a page hears nothing any more, and why if it did not end that itself."""
        self._levels.pop(token, None)
        if problem:
            self.problems[token] = problem

    def forget(self, token: str) -> None:
        """Forget a page that has ended."""
        self._levels.pop(token, None)
        self.problems.pop(token, None)


def add_listening(app: FastAPI, console: Console) -> None:
    """Add the path of sound."""

    @app.get("/sound/{component}/{token}")
    async def sound(component: str, token: str) -> StreamingResponse:
        """The sound of a microphone until the browser leaves."""
        levels = console.levels
        if not console.is_of(token, current_user()):
            raise HTTPException(404)
        if levels.of(token) is not None or levels.count >= MAX_LISTENERS:
            raise HTTPException(
                429,
                sentence("at most {most} pages listen at once, each to one microphone", most=MAX_LISTENERS),
            )
        if (problem := _problem(console, component)) is not None:
            raise HTTPException(404, problem)
        id = JausID.parse(component)
        headers = {"Cache-Control": "no-store", "Content-Encoding": "identity"}  # compression would hold sound back
        return StreamingResponse(_wav(console, id, token), media_type="audio/wav", headers=headers)


def _problem(console: Console, component: str) -> str | None:
    """Why there is no sound of this component; None if there is."""
    try:
        need_audio()
        id = JausID.parse(component)
    except ConfigError as error:
        return str(error)
    robot = console.fleet.robots.get(id.subsystem)
    parts = () if robot is None else robot.components
    found = any(part.id == id and part.find(MICROPHONE) for part in parts)
    return None if found else sentence("there is no microphone {id}", id=id)


async def _wav(console: Console, id: JausID, token: str) -> AsyncIterator[bytes]:
    """The header of a WAV file without an end, then samples as they come."""
    import numpy as np  # noqa: PLC0415 - with the extra `video` only

    levels = console.levels
    levels.begin(token)
    problem = ""
    yield _header()
    try:
        microphone = console.fleet.robots[id.subsystem].component(id).microphone()
        async with aclosing(microphone.sound()) as sounds:
            async for samples in sounds:
                power = float(np.mean(np.square(samples))) if len(samples) else 0.0
                levels.set(token, max(SILENT, 10.0 * np.log10(power)) if power > 0.0 else SILENT)
                whole = samples[: len(samples) // STEP * STEP].reshape(-1, STEP).mean(axis=1)
                yield (np.clip(whole, -1.0, 1.0) * 32767.0).astype("<i2").tobytes()
    except (JausError, KeyError) as error:
        problem = (
            str(error)
            if isinstance(error, JausError)
            else sentence("robot {subsystem} has gone", subsystem=id.subsystem)
        )
    finally:
        levels.end(token, problem)


def _header() -> bytes:
    """The header of one channel of 16 bits whose length is not known."""
    form = struct.pack("<4sIHHIIHH", b"fmt ", 16, 1, 1, RATE, 2 * RATE, 2, 16)
    return struct.pack("<4sI4s", b"RIFF", ENDLESS, b"WAVE") + form + struct.pack("<4sI", b"data", ENDLESS)
