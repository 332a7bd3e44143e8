"""The worker process of a camera: renders or captures images, encodes and sends them, takes still images."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeVar

import cv2
import numpy as np

from jauspy.errors import JausError
from jauspy.platform.video_settings import VideoSettings, with_parity
from jauspy.video.camera_protocol import (
    AddReceiver,
    ChangeImaging,
    ChangeSettings,
    RemoveReceiver,
    StartCamera,
    StillTaken,
    StreamReduced,
    TakeStill,
)
from jauspy.video.h264 import H264Encoder
from jauspy.video.imaging import Imaging, draw_numbers
from jauspy.video.pace import Niceness, Pace, efforts, reduced_text
from jauspy.video.sender import RtpSender
from jauspy.worker_process import CountersReport, Parent, WorkerReady

if TYPE_CHECKING:
    from jauspy.platform.camera import Image

T = TypeVar("T")

COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""
JPEG_QUALITY: Final = 90
"""Out of 100."""
SUPERSAMPLING: Final = 2
"""Factor by which still images are rendered wider and higher, so that edges are smooth."""
MAX_SUPERSAMPLED: Final = 1280 * 720
"""Pixels of the largest still image that is supersampled; above it a small machine needs more than half a second."""


def run(start: StartCamera, parent: Parent) -> None:
    """Serve one camera until the parent closes the connection.

    The main thread waits, as nice as the robot's process: a thread cannot become less nice again without privileges,
    but one that it starts begins with its niceness.
    """
    cv2.setNumThreads(1)  # its threads would spin while they wait for the next image
    os.environ.setdefault("LP_NUM_THREADS", "0")  # Mesa's threads would keep the niceness with which they began
    least = os.getpriority(os.PRIO_PROCESS, 0)
    worker = _in_thread(least + Niceness(start.niceness).niceness, partial(_open, start, parent))
    try:
        while not parent.ended:
            _in_thread(least + worker.niceness, partial(_serve, worker, parent))
    finally:
        worker.close()


def _in_thread(niceness: int, work: Callable[[], T]) -> T:
    """Do it in a thread of that niceness, and wait."""
    with ThreadPoolExecutor(1, initializer=_be_nice, initargs=(niceness,)) as thread:
        return thread.submit(work).result()


def _be_nice(niceness: int) -> None:
    """Set the niceness of this thread; Linux accepts the id of a thread for that of a process."""
    os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), niceness)


def _open(start: StartCamera, parent: Parent) -> CameraWorker:
    """Open the camera, for any thread."""
    worker = CameraWorker(start, parent.send)
    worker.release()
    return worker


def _serve(worker: CameraWorker, parent: Parent) -> None:
    """Serve the camera in this thread until another niceness is due, or the parent closes the connection."""
    niceness = worker.niceness
    try:
        while not parent.ended and worker.niceness == niceness:
            for command in parent.receive(worker.time_to_frame()):
                worker.execute(command)
            worker.stream_frame()
    finally:
        worker.release()


def processor_times() -> tuple[float, float]:
    """Seconds that this thread has run, and that it has waited for a processor (`schedstats` of Linux)."""
    try:
        ran, waited, _ = Path("/proc/thread-self/schedstat").read_text("ascii").split()
    except (OSError, ValueError):  # a kernel without them
        return time.thread_time(), 0.0
    return int(ran) * 1e-9, int(waited) * 1e-9


class CameraWorker:
    """One camera, for use in one thread at a time; `report` takes the messages to the parent."""

    def __init__(
        self,
        start: StartCamera,
        report: Callable[[object], None],
        clock: Callable[[], float] = time.monotonic,
        processor: Callable[[], tuple[float, float]] = processor_times,
    ) -> None:
        self._report, self._clock, self._processor = report, clock, processor
        self._name, self._stamped = start.camera.setup.name, start.stamped
        self._camera = start.camera.open()
        self._imaging = Imaging(start.camera.setup)
        self._imaging.settings = start.imaging
        self._settings = start.settings
        self._encoder = H264Encoder(start.settings)
        self._sender = RtpSender(self._name)
        self._number = 0
        self._pace = self._make_pace()
        self._niceness = Niceness(start.niceness)
        self._times: tuple[float, float] | None = None
        """CPU time and waiting time of this thread after the last picture; None before its first one."""
        self._due = clock()
        self._counters_due = clock()
        report(WorkerReady(self._camera.description, self._camera.reduced))

    @property
    def niceness(self) -> int:
        """How nice the thread should be that calls, in addition to the robot's process."""
        return self._niceness.niceness

    def release(self) -> None:
        """Leave the thread: another one may call next."""
        self._times = None
        self._camera.release()

    def time_to_frame(self) -> float | None:
        """Seconds until the next frame is due; None without a receiver that plays."""
        return max(0.0, self._due - self._clock()) if self._sender.playing else None

    def execute(self, command: object) -> None:
        """Execute a command of the parent."""
        match command:
            case ChangeSettings(settings):
                self._change(settings)
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
        period = 1.0 / self._pace.effort.rate
        skipped = int((now - self._due) / period)
        self._sender.counters["skipped"] += skipped
        self._due += period * (1 + skipped)
        self._send_frame(now)
        self._adapt(now, skipped)
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
            self._pace.restart()
        try:
            if address not in self._sender.receivers:
                self._sender.add(address)
        except JausError:
            self._sender.counters["refused"] += 1
            return
        (self._sender.play if playing else self._sender.pause)(address)

    def _send_frame(self, now: float) -> None:
        settings, divisor, utc = self._settings, self._pace.effort.divisor, time.time()
        frame = self._imaging.take(self._camera, settings.width // divisor, settings.height // divisor)
        image = frame.image
        if divisor > 1:  # the stream keeps its size, which recordings and descriptions have at their beginning
            image = np.asarray(cv2.resize(image, (settings.width, settings.height)), np.uint8)
        if self._stamped:
            draw_numbers(image, self._number, round(frame.taken * 1e6))
        self._number += 1
        idr = self._sender.needs_idr(now)  # hears what receivers ask for
        self._encoder.settings = with_parity(settings, self._sender.share)
        nals = self._encoder.encode(image, idr=idr)
        self._sender.send(nals, now, utc)

    def _adapt(self, began: float, skipped: int) -> None:
        """Choose effort and niceness after a picture that began then."""
        now, times, before = self._clock(), self._processor(), self._times
        self._times = times
        if before is not None and self._niceness.add(now, times[0] - before[0], times[1] - before[1], skipped):
            self._pace.restart()
        elif self._pace.add(now, now - began, skipped):
            self._apply_effort()

    def _make_pace(self) -> Pace:
        return Pace(efforts(self._settings, self._camera.simplifications))

    def _change(self, settings: VideoSettings) -> None:
        before, self._settings = self._settings, settings
        if (before.width, before.height, before.rate) != (settings.width, settings.height, settings.rate):
            self._pace = self._make_pace()
            self._apply_effort()

    def _apply_effort(self) -> None:
        effort = self._pace.effort
        self._due = self._clock() + 1.0 / effort.rate
        self._camera.simplify(effort.simplified)
        text = reduced_text(self._name, self._settings, effort)
        if text != self._sender.note:
            self._sender.note = text
            self._report(StreamReduced(text))

    def _take_still(self, command: TakeStill) -> None:
        width, height = command.settings.width, command.settings.height
        is_small = width * height <= MAX_SUPERSAMPLED
        factor = SUPERSAMPLING if is_small and not self._sender.note else 1
        frame = self._imaging.take(self._camera, width, height, supersampling=factor, thoroughly=True)
        content = _file_content(frame.image, command.settings.format.value)
        self._report(StillTaken(command.number, content, frame.taken))
        self._pace.restart()  # the pictures that it delayed are no sign of a slow machine


def _file_content(image: Image, suffix: str) -> bytes:
    """The content of an image file with this suffix."""
    options = [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY] if suffix == ".jpg" else []
    done, content = cv2.imencode(suffix, cv2.cvtColor(image, cv2.COLOR_RGB2BGR), options)
    if not done:
        raise ValueError(f"OpenCV cannot write {suffix}")
    return content.tobytes()
