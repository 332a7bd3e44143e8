"""A camera in a process of its own, as the robot's process has it: it starts it, tells it what to do, restarts it."""

from __future__ import annotations

import asyncio
import logging
import time
from collections import Counter
from collections.abc import Mapping
from contextlib import suppress
from types import TracebackType
from typing import Final, Self

from jauspy import workers
from jauspy.errors import ConfigError
from jauspy.platform.camera import Camera, CameraSetup
from jauspy.platform.video_settings import StillSettings, VideoSettings
from jauspy.video.extra import need_video
from jauspy.video.orders import Address, Begin, Change, Counted, Leave, Opened, Order, Take, Taken, Watch
from jauspy.video.sender import MAX_RECEIVERS
from jauspy.video.still_orders import StillOrders, Then
from jauspy.video.worker_process import WorkerProcess

STILL_TIMEOUT: Final = 30.0
"""Seconds that a process may be silent while a still image is wanted; one that is longer hangs."""
START_TIMEOUT: Final = 90.0
"""Seconds that it may be until its camera is open; where many processes share a small machine that takes a while."""

_LOG: Final = logging.getLogger("jauspy.video")


class CameraProcess:
    """Starts when somebody first wants something of it between `open` and `close`. What holds survives a restart.

    Counters: those of the sender; `started` processes, `hung` ones, `stills` taken, and `stills_lost` with a process.
    """

    def __init__(self, camera: Camera, settings: VideoSettings, *, stamped: bool = False) -> None:
        self._camera, self._settings, self._stamped = camera, settings, stamped
        self._receivers: dict[Address, bool] = {}
        self._stills = StillOrders()
        self._own: Counter[str] = Counter()
        self._sent: Counter[str] = Counter()
        self._before: Counter[str] = Counter()
        self._description = ""
        self._process: WorkerProcess | None = None
        self._heard_at = 0.0
        self._patience = START_TIMEOUT
        self._keeper: asyncio.Task[None] | None = None
        self._is_open = False

    @property
    def setup(self) -> CameraSetup:
        """What the camera is."""
        return self._camera.setup

    @property
    def pid(self) -> int | None:
        """Of the process that runs; None between two."""
        return None if self._process is None else self._process.pid

    @property
    def counters(self) -> Mapping[str, int]:
        """What was counted so far, by all its processes."""
        return self._own + self._before + self._sent

    @property
    def description(self) -> str:
        """How the camera comes to its pictures; empty before it is open."""
        return self._description

    @property
    def settings(self) -> VideoSettings:
        """How the stream is encoded."""
        return self._settings

    @settings.setter
    def settings(self, settings: VideoSettings) -> None:
        self._settings = settings
        self._order(Change(settings))

    @property
    def receivers(self) -> Mapping[Address, bool]:
        """Who is sent to, and whether they play."""
        return dict(self._receivers)

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send there, from an IDR on, or pause; `ConfigError` without the extra, or for one receiver too many."""
        if address not in self._receivers and len(self._receivers) >= MAX_RECEIVERS:
            raise ConfigError(f"{MAX_RECEIVERS} receivers watch this camera already; one must leave first")
        self._wake()
        self._receivers[address] = playing
        self._order(Watch(address, playing))

    def leave(self, address: Address) -> None:
        """Send there no longer; unknown ones are no error."""
        if self._receivers.pop(address, None) is not None:
            self._order(Leave(address))

    def take(self, settings: StillSettings, then: Then) -> None:
        """Take a still image; `then` gets it, or None if its process dies.

        Raises `ConfigError` without the extra, or when too many wait.
        """
        self._stills.check()
        self._wake()
        order = self._stills.add(settings, then)
        self._order(order)
        if self._is_open:
            asyncio.get_running_loop().call_later(STILL_TIMEOUT, self._look_after, order)

    async def open(self) -> None:
        """Be ready to start; twice is fine."""
        self._is_open = True

    async def close(self) -> None:
        """End the process; twice is fine."""
        self._is_open = False
        if self._keeper is not None:
            self._keeper.cancel()
            with suppress(asyncio.CancelledError):
                await self._keeper
            self._keeper = None
        if self._process is not None:
            await self._process.stop()
            self._end()

    async def __aenter__(self) -> Self:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    def _wake(self) -> None:
        if self._keeper is None and self._is_open:
            need_video()
            self._keeper = asyncio.get_running_loop().create_task(
                workers.keep(self._live, self._say), name=f"camera {self.setup.name}"
            )

    def _order(self, order: Order) -> None:
        if self._process is not None and not self._process.order(order):
            self._kill(self._process)

    def _look_after(self, order: Take) -> None:
        if order not in self._stills or self._process is None:
            return
        left = self._heard_at + self._patience - time.monotonic()
        if left <= 0.0:
            self._kill(self._process)
        else:
            asyncio.get_running_loop().call_later(left, self._look_after, order)

    def _kill(self, process: WorkerProcess) -> None:
        self._own["hung"] += 1
        process.kill()

    async def _start(self) -> WorkerProcess:
        self._process = process = await WorkerProcess.start(self._camera.descriptors)
        self._own["started"] += 1
        self._heard_at, self._patience = time.monotonic(), START_TIMEOUT
        self._order(Begin(self._camera, self._settings, self._stamped))
        for address, playing in self._receivers.items():
            self._order(Watch(address, playing))
        for order in self._stills:
            self._order(order)
        return process

    async def _live(self) -> int:
        """One process, from start to end; hears what it says."""
        process = await self._start()
        async for word in process.words():
            self._hear(word)
        status = await process.ended()
        self._end()
        return status

    def _say(self, status: int, pause: float) -> None:
        name = self._camera.setup.name
        _LOG.warning("camera %s: its process ended (%s); it starts again in %.1f s", name, status, pause)

    def _hear(self, word: object) -> None:
        self._heard_at, self._patience = time.monotonic(), STILL_TIMEOUT
        match word:
            case Opened(description, reduced):
                if description != self._description:
                    level = logging.WARNING if reduced else logging.INFO
                    _LOG.log(level, "camera %s: %s", self._camera.setup.name, description)
                self._description = description
            case Taken():
                self._own["stills"] += 1
                self._stills.deliver(word, time.monotonic())
            case Counted(counters):
                self._sent = Counter(counters)

    def _end(self) -> None:
        self._process = None
        self._before += self._sent
        self._sent = Counter()
        self._own["stills_lost"] += self._stills.lose()
