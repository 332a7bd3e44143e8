"""What a camera's process does: looks through the camera, encodes, sends, takes still images."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import cv2
import numpy as np

from jauspy.errors import JausError
from jauspy.video import stamp
from jauspy.video.h264 import H264Encoder
from jauspy.video.orders import (
    AddReceiver,
    CameraOpened,
    ChangeSettings,
    CountersReport,
    RemoveReceiver,
    Report,
    Start,
    StillTaken,
    TakeStill,
)
from jauspy.video.sender import RtpSender

if TYPE_CHECKING:
    from jauspy.platform.camera import Image

COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""

JPEG_QUALITY: Final = 90
"""Of JPEGs, out of 100."""


SUPERSAMPLING: Final = 2
"""How many times as wide and high a still image is looked at, so that its edges are smooth."""

MAX_SUPERSAMPLED: Final = 1280 * 720
"""Pixels of the largest image that is: four times as many take a small machine half a second."""


class CameraWorker:
    """One camera, for one thread. `say` takes what the robot's process is to know."""

    def __init__(
        self, begin: Start, say: Callable[[Report], None], clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._say, self._clock = say, clock
        self._stamped = begin.stamped
        self._eye = begin.camera.open()
        self._encoder = H264Encoder(begin.settings)
        self._sender = RtpSender(begin.camera.setup.name)
        self._number = 0
        self._due = clock()
        self._count_due = clock()
        say(CameraOpened(self._eye.description, self._eye.reduced))

    def wait(self) -> float | None:
        """Seconds until the next picture is due; None when nobody watches."""
        return max(0.0, self._due - self._clock()) if self._sender.playing else None

    def obey(self, order: object) -> None:
        """Do what the robot's process wants."""
        match order:
            case ChangeSettings(settings):
                self._encoder.settings = settings
            case AddReceiver(address, playing):
                self._watch(address, playing=playing)
            case RemoveReceiver(address):
                self._sender.remove(address)
            case TakeStill():
                self._take(order)

    def film(self) -> None:
        """Send a picture, if one is due."""
        now = self._clock()
        if not self._sender.playing or now < self._due:
            return
        period = 1.0 / self._encoder.settings.rate
        late = int((now - self._due) / period)
        self._sender.counters["skipped"] += late
        self._due += period * (1 + late)
        self._picture(now)
        if now >= self._count_due:
            self._count_due = now + COUNTER_INTERVAL
            self._say(CountersReport(dict(self._sender.counters)))

    def close(self) -> None:
        """Give camera and sockets back; twice is fine."""
        self._sender.close()
        self._eye.close()

    def _watch(self, address: tuple[str, int], *, playing: bool) -> None:
        if not self._sender.playing:  # nobody watched: no picture was missed
            self._due = self._clock()
        try:
            if address not in self._sender.receivers:
                self._sender.add(address)
        except JausError:
            self._sender.counters["refused"] += 1
            return
        (self._sender.play if playing else self._sender.pause)(address)

    def _picture(self, now: float) -> None:
        settings, utc = self._encoder.settings, time.time()
        frame = self._eye.look(settings.width, settings.height)
        if self._stamped:
            stamp.draw(frame.image, self._number, round(frame.taken * 1e6))
        self._number += 1
        nals = self._encoder.encode(frame.image, idr=self._sender.needs_idr(now))
        self._sender.send(nals, now, utc)

    def _take(self, order: TakeStill) -> None:
        width, height = order.settings.width, order.settings.height
        finer = SUPERSAMPLING if width * height <= MAX_SUPERSAMPLED else 1
        frame = self._eye.look(finer * width, finer * height, thoroughly=True)
        image = np.asarray(cv2.resize(frame.image, (width, height), interpolation=cv2.INTER_AREA), np.uint8)
        self._say(StillTaken(order.number, _file(image, order.settings.format.value), frame.taken))


def _file(image: Image, ending: str) -> bytes:
    options = [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY] if ending == ".jpg" else []
    done, content = cv2.imencode(ending, cv2.cvtColor(image, cv2.COLOR_RGB2BGR), options)
    if not done:
        raise ValueError(f"OpenCV cannot write {ending}")
    return content.tobytes()
