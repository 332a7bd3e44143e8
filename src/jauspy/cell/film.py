"""Films of simulated tasks, with one picture for each twenty-fifth of a second of the cell's time."""

from __future__ import annotations

import asyncio
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Any, Final, Self

from jauspy.errors import ConfigError
from jauspy.platform.camera import Camera, CameraSession

RATE: Final = 25
SIZE: Final = (1280, 720)
"""Width and height, pixels."""
CODEC: Final = "libx264"


class Film:
    """`async with Film(path, camera)`: films while the event loop's time passes, whatever its speed."""

    def __init__(self, path: Path, camera: Camera | None, *, size: tuple[int, int] = SIZE) -> None:
        if camera is None:
            raise ConfigError("the cell has no camera to film with")
        self.path = path
        self.pictures = 0
        self._camera = camera
        self._size = size
        self._session: CameraSession | None = None
        self._task: asyncio.Task[None] | None = None
        self._container: Any = None
        self._stream: Any = None
        self._av: Any = None

    async def __aenter__(self) -> Self:
        try:
            self._av = import_module("av")
        except ImportError:
            raise ConfigError("films need PyAV; install the extra 'video'") from None
        self.path.parent.mkdir(parents=True, exist_ok=True)
        try:
            self._container = self._av.open(str(self.path), "w")
        except OSError as error:
            raise ConfigError(f"{self.path} cannot be written: {error}") from error
        self._stream = self._container.add_stream(CODEC, rate=RATE)
        self._stream.width, self._stream.height = self._size
        self._stream.pix_fmt = "yuv420p"
        self._stream.options = {"crf": "22", "preset": "veryfast"}
        self._session = self._camera.open()
        self._task = asyncio.create_task(self._record(), name="film")
        return self

    async def __aexit__(self, *_: object) -> None:
        if self._task is not None:
            self._task.cancel()
            await asyncio.wait({self._task})
        for packet in self._stream.encode():
            self._container.mux(packet)
        self._container.close()
        if self._session is not None:
            self._session.close()

    async def _record(self) -> None:
        loop = asyncio.get_running_loop()
        due = loop.time()
        assert self._session is not None
        while True:
            picture = self._session.look(*self._size, thoroughly=True)
            frame = self._av.VideoFrame.from_ndarray(picture.image, format="rgb24")
            frame.pts, frame.time_base = self.pictures, Fraction(1, RATE)
            for packet in self._stream.encode(frame):
                self._container.mux(packet)
            self.pictures += 1
            due += 1.0 / RATE
            await asyncio.sleep(due - loop.time())
