"""The worker process of a camera: renders or captures images, encodes and sends them, takes still images."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import cv2

from jauspy.errors import JausError
from jauspy.video.camera_protocol import (
    AddReceiver,
    ChangeImaging,
    ChangeSettings,
    RemoveReceiver,
    StartCamera,
    StillTaken,
    TakeStill,
)
from jauspy.video.h264 import H264Encoder
from jauspy.video.imaging import Imaging, draw_numbers
from jauspy.video.sender import RtpSender
from jauspy.worker_process import CountersReport, Parent, WorkerReady

if TYPE_CHECKING:
    from jauspy.platform.camera import Image

COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""
PACE_WINDOW: Final = 5.0
"""Seconds over which it is measured whether a camera keeps its rate."""
MAX_MISSING: Final = 0.2
"""Share of pictures that may be missing until the camera renders at a lower quality."""
JPEG_QUALITY: Final = 90
"""Out of 100."""
SUPERSAMPLING: Final = 2
"""Factor by which still images are rendered wider and higher, so that edges are smooth."""
MAX_SUPERSAMPLED: Final = 1280 * 720
"""Pixels of the largest still image that is supersampled; above it a small machine needs more than half a second."""


def run(start: StartCamera, parent: Parent) -> None:
    """Serve one camera until the parent closes the connection."""
    cv2.setNumThreads(1)  # its threads would spin while they wait for the next image
    worker = CameraWorker(start, parent.send)
    try:
        while not parent.ended:
            for command in parent.receive(worker.time_to_frame()):
                worker.execute(command)
            worker.stream_frame()
    finally:
        worker.close()


class CameraWorker:
    """One camera, for use in one thread; `report` takes the messages to the parent."""

    def __init__(
        self, start: StartCamera, report: Callable[[object], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._report, self._clock = report, clock
        self._stamped = start.stamped
        self._camera = start.camera.open()
        self._imaging = Imaging(start.camera.setup)
        self._imaging.settings = start.imaging
        self._encoder = H264Encoder(start.settings)
        self._sender = RtpSender(start.camera.setup.name)
        self._number = 0
        self._pace = Pace()
        self._due = clock()
        self._counters_due = clock()
        report(WorkerReady(self._camera.description, self._camera.reduced))

    def time_to_frame(self) -> float | None:
        """Seconds until the next frame is due; None without a receiver that plays."""
        return max(0.0, self._due - self._clock()) if self._sender.playing else None

    def execute(self, command: object) -> None:
        """Execute a command of the parent."""
        match command:
            case ChangeSettings(settings):
                self._encoder.settings = settings
            case ChangeImaging(imaging):
                self._imaging.settings = imaging
            case AddReceiver(address, playing):
                self._add_receiver(address, playing=playing)
            case RemoveReceiver(address):
                self._sender.remove(address)
            case TakeStill():
                self._take_still(command)

    def stream_frame(self) -> None:
        """Send a frame if one is due."""
        now = self._clock()
        if not self._sender.playing or now < self._due:
            return
        period = 1.0 / self._encoder.settings.rate
        skipped = int((now - self._due) / period)
        self._sender.counters["skipped"] += skipped
        self._due += period * (1 + skipped)
        self._send_frame(now)
        if self._pace.is_too_slow(now, skipped) and self._camera.simplify():
            self._report(WorkerReady(self._camera.description, self._camera.reduced))
        if now >= self._counters_due:
            self._counters_due = now + COUNTER_INTERVAL
            self._report(CountersReport(dict(self._sender.counters)))

    def close(self) -> None:
        """Close camera and sockets; without effect when closed."""
        self._sender.close()
        self._camera.close()

    def _add_receiver(self, address: tuple[str, int], *, playing: bool) -> None:
        if not self._sender.playing:  # without receivers no frame was due
            self._due = self._clock()
        try:
            if address not in self._sender.receivers:
                self._sender.add(address)
        except JausError:
            self._sender.counters["refused"] += 1
            return
        (self._sender.play if playing else self._sender.pause)(address)

    def _send_frame(self, now: float) -> None:
        settings, utc = self._encoder.settings, time.time()
        frame = self._imaging.take(self._camera, settings.width, settings.height)
        if self._stamped:
            draw_numbers(frame.image, self._number, round(frame.taken * 1e6))
        self._number += 1
        nals = self._encoder.encode(frame.image, idr=self._sender.needs_idr(now))
        self._sender.send(nals, now, utc)

    def _take_still(self, command: TakeStill) -> None:
        width, height = command.settings.width, command.settings.height
        factor = SUPERSAMPLING if width * height <= MAX_SUPERSAMPLED else 1
        frame = self._imaging.take(self._camera, width, height, supersampling=factor, thoroughly=True)
        content = _file_content(frame.image, command.settings.format.value)
        self._report(StillTaken(command.number, content, frame.taken))


class Pace:
    """Watches how many pictures are left out."""

    def __init__(self) -> None:
        self._began: float | None = None
        self._taken = self._skipped = 0

    def is_too_slow(self, now: float, skipped: int) -> bool:
        """Count a picture at that time (monotonic seconds), and those left out before it.

        True when too many of the last `PACE_WINDOW` seconds are missing. The first pictures of a camera, and those
        after a pause, do not count: it takes a while to be ready for them.
        """
        if self._began is None or now - self._began > 2.0 * PACE_WINDOW:
            self._began, self._taken, self._skipped = now, 0, 0
            return False
        self._taken += 1
        self._skipped += skipped
        if now - self._began < PACE_WINDOW:
            return False
        too_slow = self._skipped > MAX_MISSING * (self._taken + self._skipped)
        self._began, self._taken, self._skipped = now, 0, 0
        return too_slow


def _file_content(image: Image, suffix: str) -> bytes:
    """The content of an image file with this suffix."""
    options = [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY] if suffix == ".jpg" else []
    done, content = cv2.imencode(suffix, cv2.cvtColor(image, cv2.COLOR_RGB2BGR), options)
    if not done:
        raise ValueError(f"OpenCV cannot write {suffix}")
    return content.tobytes()
