"""What a depth camera's clouds are made of, and where they go."""

from __future__ import annotations

import asyncio
import json
import logging
import pickle
from collections import Counter
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from types import TracebackType
from typing import Final, Self

from jauspy import workers
from jauspy.cloud.socket import CloudPublisher
from jauspy.platform.camera import Camera


@dataclass(frozen=True, slots=True)
class DepthSettings:
    """How a camera's cloud is made."""

    width: int = 400
    height: int = 250
    """Points of a cloud, at most: one for each pixel that shows something within range."""
    rate: float = 10.0
    """Clouds per second."""
    least: float = 0.2
    most: float = 10.0
    """Metres along the camera's x axis."""


@dataclass(frozen=True, slots=True)
class DepthStream:
    """Which camera's clouds are published, and at which address."""

    camera: Camera
    settings: DepthSettings
    address: str


_LOG: Final = logging.getLogger("jauspy.cloud")


class DepthProcess:
    """Publishes between `open` and `close`.

    Counters: clouds `published`, their `points`, clouds `skipped` because it was too slow, and processes `started`.
    """

    def __init__(self, stream: DepthStream) -> None:
        self._stream = stream
        self._own: Counter[str] = Counter()
        self._before: Counter[str] = Counter()
        self._now: Counter[str] = Counter()
        self._keeper: asyncio.Task[None] | None = None
        self.description = ""
        """How the camera comes to its pictures; empty before it is open."""
        self.pid: int | None = None
        """Of the process that runs; None between two."""

    @property
    def counters(self) -> Mapping[str, int]:
        """What was counted so far, by all its processes."""
        return self._own + self._before + self._now

    async def open(self) -> None:
        """Start; `ConfigError` without pynng, `TransportError` when the address cannot be used. Twice is fine."""
        if self._keeper is None:
            CloudPublisher(self._stream.address).close()
            self._keeper = asyncio.create_task(
                workers.keep(self._live, self._say), name=f"clouds of {self._stream.camera.setup.name}"
            )

    async def close(self) -> None:
        """End the process; twice is fine."""
        if self._keeper is not None:
            self._keeper.cancel()
            with suppress(asyncio.CancelledError):
                await self._keeper
            self._keeper = None

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    def _say(self, status: int, pause: float) -> None:
        name = self._stream.camera.setup.name
        _LOG.warning("clouds of %s: their process ended (%s); it starts again in %.1f s", name, status, pause)

    async def _live(self) -> int:
        """One process, from start to end."""
        process = await workers.start("jauspy.cloud.depth_worker", self._stream.camera.descriptors)
        self._own["started"] += 1
        self.pid = process.pid
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            process.stdin.write(pickle.dumps(self._stream))
            async for line in process.stdout:
                self._hear(json.loads(line))
            return await process.wait()
        finally:
            await workers.stop(process)
            self.pid = None
            self._before += self._now
            self._now = Counter()

    def _hear(self, words: Mapping[str, object]) -> None:
        match words:
            case {"description": str(description)}:
                _LOG.info("clouds of %s: %s", self._stream.camera.setup.name, description)
                self.description = description
            case {"counters": dict(counters)}:
                self._now = Counter(counters)
