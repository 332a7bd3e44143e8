"""A camera in a worker process, which is started at first use and restarted when it dies."""

from __future__ import annotations

import asyncio
import os
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Final, NamedTuple, TypeAlias

from jauspy.errors import ConfigError, JausError
from jauspy.logs import get_logger
from jauspy.platform.camera import CameraSetup, CameraSource
from jauspy.platform.imaging_settings import ImagingSettings
from jauspy.platform.video_settings import Still, StillSettings, VideoSettings
from jauspy.video import need_video
from jauspy.video.camera_protocol import (
    AddReceiver,
    Address,
    ChangeImaging,
    ChangeSettings,
    RemoveReceiver,
    StartCamera,
    StillTaken,
    StreamReduced,
    TakeStill,
)
from jauspy.video.sender import MAX_RECEIVERS, RtpSender
from jauspy.worker_process import SupervisedWorker

NICENESS: Final = 15
"""Greatest niceness above that of the robot's process, so that video gets what control leaves (`pace.Niceness`)."""
STILL_TIMEOUT: Final = 30.0
"""Seconds that a worker may be silent while a still image is wanted, until it counts as hung."""
START_TIMEOUT: Final = 90.0
"""The same until the camera is open, which takes long where many processes share a small machine."""
NOTICE_INTERVAL: Final = 3.0
"""Seconds from the start of a worker until receivers without a picture are told so, and between two notes."""
LONG_START: Final = 10.0
"""Seconds after which it is logged that a camera is still starting."""
BUSY_SHARE: Final = 0.5
"""Share of a processor below which a camera that starts is said to have too little."""
MAX_PENDING_STILLS: Final = 8
"""Still images that may be under way; further ones are refused."""

_LOG: Final = get_logger("jauspy.video")

StillCallback: TypeAlias = Callable[[Still | None], None]


class CameraProcess(SupervisedWorker):
    """Streams video and takes still images. Receivers, settings and pending stills survive a restart of the worker.

    Counters: those of the sender; `started` workers, `hung` ones, `stills` taken, and `stills_lost` with a worker.
    """

    def __init__(self, camera: CameraSource, settings: VideoSettings, *, stamped: bool = False) -> None:
        super().__init__("jauspy.video.camera_worker", 0, f"camera {camera.setup.name}", _LOG)
        self._camera, self._settings, self._stamped = camera, settings, stamped
        self._imaging = camera.setup.imaging.initial
        self._receivers: dict[Address, bool] = {}
        self._stills = PendingStills()
        self._heard_at = 0.0
        self._timeout = START_TIMEOUT
        self._is_open = False
        self._reduced = ""
        self._expects_picture = False

    @property
    def setup(self) -> CameraSetup:
        """Name, link and field of view of the camera."""
        return self._camera.setup

    @property
    def settings(self) -> VideoSettings:
        """The settings of the encoder."""
        return self._settings

    @settings.setter
    def settings(self, settings: VideoSettings) -> None:
        self._settings = settings
        self._send(ChangeSettings(settings))

    @property
    def imaging(self) -> ImagingSettings:
        """The settings of lens and sensor."""
        return self._imaging

    @imaging.setter
    def imaging(self, settings: ImagingSettings) -> None:
        self._imaging = settings
        self._send(ChangeImaging(settings))

    @property
    def receivers(self) -> Mapping[Address, bool]:
        """The receivers, and whether they play."""
        return dict(self._receivers)

    @property
    def reduced(self) -> str:
        """A sentence for users about a camera for which the machine is too slow; empty when it sends what is set."""
        return self._reduced

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send to this address, from an IDR picture on, or pause sending.

        Raises `ConfigError` without the extra `video`, or for one receiver too many.
        """
        if address not in self._receivers and len(self._receivers) >= MAX_RECEIVERS:
            raise ConfigError(f"{MAX_RECEIVERS} receivers watch this camera already; one must leave first")
        self._wake()
        self._receivers[address] = playing
        self._send(AddReceiver(address, playing))
        self._expect_picture()

    def leave(self, address: Address) -> None:
        """Stop sending to this address; without effect for an unknown one."""
        if self._receivers.pop(address, None) is not None:
            self._send(RemoveReceiver(address))

    def take(self, settings: StillSettings, callback: StillCallback) -> None:
        """Take a still image, which is passed to `callback`, or None if the worker dies.

        Raises `ConfigError` without the extra `video`, or when too many still images are under way.
        """
        self._stills.check()
        self._wake()
        command = self._stills.add(settings, callback)
        self._send(command)
        if self._is_open:
            asyncio.get_running_loop().call_later(STILL_TIMEOUT, self._check_still, command)

    async def open(self) -> None:
        """Allow the worker to start when it is first needed; without effect when open."""
        self._is_open = True

    async def close(self) -> None:
        """Stop the worker; without effect when closed."""
        self._is_open = False
        await super().close()

    @property
    def _descriptors(self) -> tuple[int, ...]:
        return self._camera.descriptors

    def _wake(self) -> None:
        if self._task is None and self._is_open:
            need_video()
            self._supervise()

    def _check_still(self, command: TakeStill) -> None:
        """Kill a worker that has been silent for too long while this image is wanted."""
        if command not in self._stills or self._process is None:
            return
        left = self._heard_at + self._timeout - time.monotonic()
        if left <= 0.0:
            self._kill(self._process)
        else:
            asyncio.get_running_loop().call_later(left, self._check_still, command)

    def _on_started(self) -> None:
        self._heard_at, self._timeout = time.monotonic(), START_TIMEOUT
        self._reduced = ""
        self._expects_picture = False
        self._expect_picture()
        self._send(StartCamera(self._camera, self._settings, self._imaging, self._stamped, NICENESS))
        for address, playing in self._receivers.items():
            self._send(AddReceiver(address, playing))
        for command in self._stills:
            self._send(command)

    def _on_message(self, message: object) -> None:
        self._heard_at, self._timeout = time.monotonic(), STILL_TIMEOUT
        if isinstance(message, StillTaken):
            self._own["stills"] += 1
            self._stills.deliver(message, time.monotonic())
        elif isinstance(message, StreamReduced):
            self._take_reduction(message.text)
        else:
            super()._on_message(message)

    def _take_reduction(self, text: str) -> None:
        """Log what the camera does less than is set, or that it does all again."""
        if text:
            _LOG.warning("%s", text)
        elif self._reduced:
            _LOG.info("%s: sends what is set again", self._name)
        self._own["reduced"] += bool(text)
        self._reduced = text

    def _expect_picture(self) -> None:
        """Tell receivers and the log why nothing comes, until a picture has been sent."""
        if self.pid is not None and not self._expects_picture and any(self._receivers.values()):
            self._expects_picture = True
            waiting = Waiting(self.pid, time.monotonic(), processor_time(self.pid), self._reported["pictures"])
            asyncio.get_running_loop().call_later(NOTICE_INTERVAL, self._notify, waiting)

    def _notify(self, waiting: Waiting) -> None:
        if waiting.pid != self.pid:
            return
        playing = [address for address, plays in self._receivers.items() if plays]
        if self._reported["pictures"] > waiting.pictures or not playing:
            self._expects_picture = False
            return
        elapsed = time.monotonic() - waiting.began
        text = starting_text(self._camera.setup.name, elapsed, processor_time(waiting.pid) - waiting.used)
        if elapsed - NOTICE_INTERVAL < LONG_START <= elapsed:
            _LOG.warning("%s", text)
        with RtpSender(self._camera.setup.name) as sender:
            for address in playing:
                with suppress(JausError):  # the worker counts addresses that are none
                    sender.add(address)
            sender.announce(text)
        asyncio.get_running_loop().call_later(NOTICE_INTERVAL, self._notify, waiting)

    def _on_ended(self) -> None:
        self._own["stills_lost"] += self._stills.fail()


class Waiting(NamedTuple):
    """Receivers that wait for a first picture of this process."""

    pid: int
    began: float
    """Seconds of the monotonic clock."""
    used: float
    """Seconds of a processor that it had used then."""
    pictures: int
    """Pictures that it had sent then."""


def starting_text(name: str, elapsed: float, used: float) -> str:
    """The sentence for users about a camera that has no picture yet; seconds since its start, and of a processor."""
    why = ", since the robot's machine is busy" if used < BUSY_SHARE * elapsed else ""
    share = f"its process got {100.0 * used / elapsed:.0f} % of a processor in {elapsed:.0f} s"
    return f"camera {name} is still starting{why}: {share}"


def processor_time(pid: int) -> float:
    """Seconds that a process has run (utime and stime, proc(5)); 0 if it has ended."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text("utf-8", "replace").rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class PendingStills:
    """Still images that were requested and not delivered, by number; numbers continue over restarts of the worker."""

    def __init__(self) -> None:
        self._pending: dict[int, tuple[TakeStill, StillCallback]] = {}
        self._number = 0

    def __iter__(self) -> Iterator[TakeStill]:
        return (command for command, _ in self._pending.values())

    def __contains__(self, command: TakeStill) -> bool:
        return command.number in self._pending

    def check(self) -> None:
        """Raise `ConfigError` when there are too many."""
        if len(self._pending) >= MAX_PENDING_STILLS:
            raise ConfigError(
                f"{MAX_PENDING_STILLS} still images of this camera are pending; try again when one has arrived"
            )

    def add(self, settings: StillSettings, callback: StillCallback) -> TakeStill:
        """Add an image; returns the command for the worker."""
        self._number += 1
        command = TakeStill(self._number, settings)
        self._pending[command.number] = (command, callback)
        return command

    def deliver(self, taken: StillTaken, now: float) -> None:
        """Pass an image to its callback; `now` is in seconds of the machine's monotonic clock."""
        _, callback = self._pending.pop(taken.number)
        callback(Still(taken.content, now - taken.at))

    def fail(self) -> int:
        """Pass None to all callbacks; returns how many there were."""
        lost, self._pending = self._pending, {}
        for _, callback in lost.values():
            callback(None)
        return len(lost)
