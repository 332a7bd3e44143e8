"""A camera's video: received, recorded and timed. Import it after `extra.need_video`."""

from __future__ import annotations

import asyncio
import time
from collections import deque
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.patience import within
from jauspy.cli.demo.report import Finding
from jauspy.cli.video_watch import entered, url_of
from jauspy.errors import RequestError
from jauspy.messages.environment_sensing.v2_0.digital_video import SetDigitalVideoSensorConfiguration
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.ocu import OCU
from jauspy.ocu.robot import ComponentClient
from jauspy.services.environment_sensing.frame_sizes import FrameSize
from jauspy.video.receiver import RtpReceiver
from jauspy.video.recorder import Recorder

HERE: Final = "127.0.0.1"
SENSOR: Final = 1
LATENCIES: Final = 3000


@dataclass(slots=True)
class Film:
    """What has come of a camera's video so far."""

    name: str
    receiver: RtpReceiver
    recorder: Recorder
    latencies: deque[float] = field(default_factory=lambda: deque(maxlen=LATENCIES))
    began: float = field(default_factory=time.monotonic)
    ended: float = 0.0

    def take(self) -> None:
        """Whatever has come."""
        now = time.time()
        for picture in self.receiver.take():
            self.recorder.add(picture)
            if (taken := self.receiver.taken(picture)) is not None:
                self.latencies.append(now - taken)

    async def begins(self) -> None:
        """Wait for the first picture; `RequestError` when it stays out."""
        async with within(plan.CAMERA_TIME, lambda: f"camera {self.name}: no picture in {plan.CAMERA_TIME:g} s"):
            while not self.recorder.pictures:  # noqa: ASYNC110 - the socket's reader adds them
                await asyncio.sleep(0.05)
        self.began = time.monotonic()

    def finding(self) -> Finding:
        """How well it came: nothing may be lost."""
        pictures, counters = self.recorder.pictures, self.receiver.counters
        lost, damaged = counters.get("lost", 0), counters.get("damaged", 0)
        rate = pictures / max(self.ended - self.began, 1e-3)
        late = median(self.latencies) if self.latencies else 0.0
        return Finding(
            f"{self.name} video",
            f"{pictures} pictures ({rate:.1f} Hz), {lost or 'no'} packets lost, {damaged or 'none'} damaged; "
            f"{1e3 * late:.0f} ms old on arrival (median)",
            pictures > 0 and not lost and not damaged,
            {"pictures": pictures, "rate": rate, "packets_lost": lost, "damaged": damaged, "latency": late},
        )


@asynccontextmanager
async def filmed(ocu: OCU, camera: ComponentClient, name: str, file: Path, size: FrameSize) -> AsyncIterator[Film]:
    """The camera's video goes to the file as long as this lasts, in that size; wait until it begins."""
    await _resize(camera, size)
    loop = asyncio.get_running_loop()
    with RtpReceiver(HERE) as receiver, Recorder(file) as recorder:
        film = Film(name, receiver, recorder)
        loop.add_reader(receiver.fileno(), film.take)
        try:
            async with entered(ocu, camera.id, SENSOR, url_of((HERE, receiver.port))):
                yield film
                film.ended = time.monotonic()
        finally:
            loop.remove_reader(receiver.fileno())


async def _resize(camera: ComponentClient, size: FrameSize) -> None:
    """Needs control, for a moment: other clients see the new size, too."""
    service = camera.service("DigitalVideo")
    wanted = SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec(SENSOR, frame_size=size)
    request = SetDigitalVideoSensorConfiguration.RequestIdRec(1)
    order = SetDigitalVideoSensorConfiguration(request, [wanted])
    async with service.control(plan.AUTHORITY):
        await service.resume()
        answer = await service.query(order, expects=ConfirmSensorConfiguration)
    refused = [each for each in answer.confirm_sensor_list if hasattr(each, "error_message")]
    if refused:
        raise RequestError(f"{camera.id} does not film in that size: {refused[0].error_message}")
