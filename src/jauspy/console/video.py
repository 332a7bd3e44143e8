"""Video for browsers: receives each camera once, and sends encoded pictures and the attitude to all watchers."""

from __future__ import annotations

import asyncio
import json
import math
import struct
from collections import deque
from collections.abc import Callable
from contextlib import aclosing
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Final

from fastapi import WebSocket, WebSocketDisconnect

from jauspy.codec.message import Message
from jauspy.console.browser_messages import Refuse, messages, video_request
from jauspy.console.languages import ENGLISH, joined, sentence, translated
from jauspy.console.reports import reports_of
from jauspy.console.video_quality import LinkQuality, LinkQualityMeter
from jauspy.console.video_recording import VideoRecording
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.mobility import QueryGlobalPose, QueryLocalPose, QueryVelocityState
from jauspy.ocu import OCU
from jauspy.ocu.camera import Camera
from jauspy.ocu.robot import Robot
from jauspy.printable import printable
from jauspy.video.h264_payload import SPS, Picture, join_nals, nal_type
from jauspy.video.rtp import CLOCK_RATE

ATTITUDE_RATE: Final = 5.0
"""Hz."""
ATTITUDE_SOURCES: Final = (
    ("LocalPoseSensor", QueryLocalPose(), ("heading", "pitch", "roll")),
    ("GlobalPoseSensor", QueryGlobalPose(), ("heading", "pitch", "roll")),
    ("VelocityStateSensor", QueryVelocityState(), ("speed",)),
)
"""Services with their query and the values in its report; of two with the same values, the first is used."""
ATTITUDE_FIELDS: Final = {"heading": "yaw", "pitch": "pitch", "roll": "roll", "speed": "velocity_x"}


@dataclass(frozen=True, slots=True)
class Attitude:
    """Degrees: heading clockwise, 0..360, pitch up, roll to the right; speed in m/s forward. None is not reported."""

    heading: float | None = None
    pitch: float | None = None
    roll: float | None = None
    speed: float | None = None

    def as_dict(self) -> dict[str, float | None]:
        """Attitude and speed as the browser gets them."""
        return asdict(self)


class AttitudeFeed:
    """Follows the attitude of one robot while a browser watches."""

    def __init__(self, ocu: OCU, robot: Robot) -> None:
        self.attitude = Attitude()
        self._ocu = ocu
        self._robot = robot
        self._watchers: list[Callable[[Attitude], None]] = []
        self._tasks: list[asyncio.Task[None]] = []

    def add(self, watcher: Callable[[Attitude], None]) -> None:
        """Call this function now, and whenever the attitude changes."""
        self._watchers.append(watcher)
        watcher(self.attitude)
        if not self._tasks:
            self._start()

    def remove(self, watcher: Callable[[Attitude], None]) -> None:
        """Stop calling this function; without effect if it was not added."""
        if watcher in self._watchers:
            self._watchers.remove(watcher)
        if not self._watchers:
            for task in self._tasks:
                task.cancel()
            self._tasks = []

    def _start(self) -> None:
        followed: set[str] = set()
        for service, query, names in ATTITUDE_SOURCES:
            component = next((candidate for candidate in self._robot.components if candidate.find(service)), None)
            if component is None or followed & set(names):
                continue
            followed |= set(names)
            following = self._follow(component.id, query, names, events=component.find("Events") is not None)
            self._tasks.append(asyncio.create_task(following, name=f"console: attitude of {component.id}"))

    async def _follow(self, id: JausID, query: Message, names: tuple[str, ...], *, events: bool) -> None:
        while True:
            try:
                async with aclosing(reports_of(self._ocu, id, query, ATTITUDE_RATE, events=events)) as reports:
                    async for report in reports:
                        self._take({name: getattr(report, ATTITUDE_FIELDS[name], None) for name in names})
            except JausError:
                self._take(dict.fromkeys(names))
            await asyncio.sleep(RETRY_INTERVAL)

    def _take(self, values: dict[str, float | None]) -> None:
        new = replace(self.attitude, **{name: _shown(name, value) for name, value in values.items()})
        if new != self.attitude:
            self.attitude = new
            for watcher in list(self._watchers):
                watcher(new)


def _shown(name: str, value: float | None) -> float | None:
    """Degrees with one decimal, or m/s with two, so that only visible changes are sent."""
    if value is None:
        return None
    if name == "speed":
        return round(value, 2) + 0.0
    degrees = round(math.degrees(value), 1) + 0.0
    return degrees % 360.0 if name == "heading" else degrees


MAX_QUEUED: Final = 8
"""Pictures that wait for one browser; a slower one gets none until the next IDR picture."""
MAX_BYTES: Final = 4 << 20
"""Bytes of pictures that wait for one browser."""
RETRY_INTERVAL: Final = 2.0
"""Seconds until a camera is queried again after its stream has ended, or a component that reports no attitude."""
QUIET_TIME: Final = 2.0
"""Seconds without a picture after which the browsers are sent the reason."""
KEY_INTERVAL: Final = 2.0
"""Seconds after which a key picture is requested while a browser receives only those: slow cameras make few."""
_HEADER: Final = struct.Struct("<?xxxxxxxdd")
"""Key picture or not, time stamp in microseconds, and when it was taken, in milliseconds since 1970 by the
robot's clock (NaN when unknown)."""


class Watcher:
    """The send queue of one browser: pictures in order, and the newest of each kind of news."""

    def __init__(self, language: str = ENGLISH) -> None:
        self.language = language
        """The code of the language of the browser's page."""
        self.choice = "all"
        self.left_out = 0
        """Pictures that were left out because the browser or its connection is slow."""
        self._pictures: deque[bytes] = deque()
        self._size = 0
        self._news: dict[str, Any] = {}
        self._codec = ""
        self._note = ""
        self._quality = LinkQuality()
        self._waits_for_idr = True
        self._ready = asyncio.Event()

    def __len__(self) -> int:
        return len(self._pictures)

    def tell(self, **news: Any) -> None:
        """Send news; those of the same name that wait are replaced."""
        self._news.update(news)
        self._ready.set()

    def tell_note(self, note: str) -> None:
        """Send what the camera says of its stream, if it is something else than before."""
        if note != self._note:
            self._note = note
            self.tell(note=note)

    def tell_quality(self, quality: LinkQuality) -> None:
        """Send what the link does to the stream, if it is something else than before."""
        if quality != self._quality:
            self._quality = quality
            self.tell(link=quality._asdict())

    def choose(self, choice: str) -> bool:
        """Send these pictures (`all`, `keys` or `nothing`) from now on; returns True if a key picture is waited for."""
        if choice == self.choice:
            return False
        self.choice = choice
        self._waits_for_idr = True
        return choice != "nothing"

    def put(self, picture: Picture, data: bytes, codec: str) -> None:
        """Queue a picture; when too much waits, all until the next IDR picture are left out."""
        if self.choice == "nothing" or (self.choice == "keys" and not picture.is_idr):
            return
        is_full = len(self._pictures) >= MAX_QUEUED or self._size + len(data) > MAX_BYTES
        if is_full or (self._waits_for_idr and not picture.is_idr):
            if is_full or self.left_out:
                self.left_out += 1
                self.tell(left_out=self.left_out)
            self._waits_for_idr = True
            return
        if codec != self._codec:
            if self._pictures:  # they are of the other coding
                self.left_out += len(self._pictures)
                self._pictures.clear()
                self._size = 0
            self._codec = codec
            self.tell(codec=codec)
        self._waits_for_idr = False
        self._pictures.append(data)
        self._size += len(data)
        self._ready.set()

    async def next(self) -> str | bytes:
        """The next message: news first."""
        await self._ready.wait()
        item: str | bytes
        if self._news:
            item, self._news = json.dumps(self._news), {}
        else:
            item = self._pictures.popleft()
            self._size -= len(item)
        if not self._news and not self._pictures:
            self._ready.clear()
        return item


class SharedCamera:
    """Receives a camera while somebody watches or records.

    `state` returns a text if the component cannot send video, else an empty one.
    """

    def __init__(
        self,
        camera: Camera,
        name: str,
        on_event: Callable[[str], None],
        state: Callable[[], str] = lambda: "",
        attitude: AttitudeFeed | None = None,
    ) -> None:
        self.recording: VideoRecording | None = None
        """The present one; after its end, the last one."""
        self.camera = camera
        self.name = name
        self._on_event = on_event
        self._state = state
        self._attitude = attitude
        self._watchers: set[Watcher] = set()
        self._tasks: list[asyncio.Task[None]] = []
        self._codec = ""
        self._problem = self._note = ""
        self._picture_at = -math.inf
        self._has_begun = False
        self._key_at = -math.inf

    async def serve(self, socket: WebSocket, refuse: Refuse, language: str = ENGLISH) -> None:
        """Send news as JSON and requested pictures as bytes to one browser until it leaves."""
        watcher = Watcher(language)
        self._watchers.add(watcher)
        self._start()
        self.camera.refresh()

        def tell(attitude: Attitude) -> None:
            watcher.tell(attitude=attitude.as_dict())

        leaving = asyncio.create_task(self._listen(socket, watcher, tell, refuse))
        sending = asyncio.create_task(_send(socket, watcher))
        try:
            await asyncio.wait({leaving, sending}, return_when=asyncio.FIRST_COMPLETED)
        finally:
            leaving.cancel()
            sending.cancel()
            if self._attitude is not None:
                self._attitude.remove(tell)
            self._watchers.discard(watcher)
            self._stop_if_unused()

    def record(self, folder: Path) -> VideoRecording:
        """Record pictures until `stop_recording`, independent of watchers.

        Returns the present recording if there is one.

        Raises `ConfigError` when nothing can be written there.
        """
        if self.recording is None or self.recording.ended:
            self.recording = VideoRecording(folder, self.name)
            self._on_event(
                sentence("video of {name}: recording to {path} has begun", name=self.name, path=self.recording.path)
            )
            self._start()
            self.camera.refresh()
        return self.recording

    async def stop_recording(self) -> None:
        """End the recording; without effect when there is none."""
        if self.recording is not None:
            await self.recording.close()
            self._on_event(sentence("video of {name}: {summary}", name=self.name, summary=self.recording.summary))
        self._stop_if_unused()

    async def close(self) -> None:
        """The console ends."""
        if self.recording is not None:
            await self.recording.close()
        self._watchers.clear()
        self._stop_if_unused()

    def _start(self) -> None:
        if not self._tasks:
            self._picture_at = asyncio.get_running_loop().time()
            self._problem, self._note, self._has_begun = "", "", False
            self._tasks = [
                asyncio.create_task(self._receive(), name=f"console: video of {self.name}"),
                asyncio.create_task(self._explain(), name=f"console: why {self.name} is dark"),
            ]

    def _stop_if_unused(self) -> None:
        if not self._watchers and (self.recording is None or self.recording.ended):
            for task in self._tasks:
                task.cancel()
            self._tasks = []

    async def _receive(self) -> None:
        sent = ""
        while True:
            try:
                async with aclosing(self.camera.encoded()) as pictures:
                    async for picture in pictures:
                        self._hand_out(picture)
                        sent = self._problem = ""
                        self._has_begun = True
            except JausError as error:
                self._problem = printable(str(error))
                if self._problem != sent:
                    self._on_event(sentence("no video of {name}: {error}", name=self.name, error=error))
                sent = self._problem
                self._has_begun = False
            await asyncio.sleep(RETRY_INTERVAL)

    async def _explain(self) -> None:
        """Send browsers the reason while there is no picture, and the link's quality, and request key pictures."""
        meter = LinkQualityMeter()
        while True:
            await asyncio.sleep(0.5)
            reason, note = self.why_no_picture(), self.camera.note
            if note != self._note and self._has_begun:  # before, it is the reason
                self._on_event(
                    sentence("video of {name}: {note}", name=self.name, note=note or sentence("all that is set again"))
                )
                self._note = note
            quality = meter.add(asyncio.get_running_loop().time(), self.camera.counters)
            for watcher in self._watchers:
                watcher.tell_note(note)
                watcher.tell_quality(quality)
                if reason:
                    watcher.tell(reason=translated(reason, watcher.language))
            now = asyncio.get_running_loop().time()
            if now - self._key_at >= KEY_INTERVAL and any(watcher.choice == "keys" for watcher in self._watchers):
                self.camera.refresh()
            if self.recording is not None and self.recording.ended:
                self._stop_if_unused()

    def why_no_picture(self) -> str:
        """A text for users; empty when pictures arrive."""
        if asyncio.get_running_loop().time() - self._picture_at < QUIET_TIME:
            return ""
        state = "" if self._has_begun else self._state()
        return joined(line for line in (self._problem or self.camera.waiting, state) if line)

    def _hand_out(self, picture: Picture) -> None:
        self._picture_at = asyncio.get_running_loop().time()
        if picture.is_idr:
            self._key_at = self._picture_at
            parameters = next((nal for nal in picture.nals if nal_type(nal) == SPS), b"")
            self._codec = f"avc1.{parameters[1:4].hex()}" if len(parameters) > 3 else self._codec
        taken = self.camera.taken(picture)
        taken_ms = math.nan if taken is None else 1e3 * taken.timestamp()
        data = _HEADER.pack(picture.is_idr, picture.timestamp * 1e6 / CLOCK_RATE, taken_ms) + join_nals(picture.nals)
        for watcher in self._watchers:
            watcher.put(picture, data, self._codec)
        if self.recording is not None:
            self.recording.add(picture)

    async def _listen(
        self, socket: WebSocket, watcher: Watcher, tell: Callable[[Attitude], None], refuse: Refuse
    ) -> None:
        """Handle the browser's requests, as in {"want": "keys", "attitude": true}, until it leaves."""
        async for asked in messages(socket, video_request, refuse):
            if asked is None:
                continue
            if asked.want is not None and watcher.choose(asked.want):
                self.camera.refresh()
            if self._attitude is not None:
                self._attitude.remove(tell)
                if asked.attitude:
                    self._attitude.add(tell)


async def _send(socket: WebSocket, watcher: Watcher) -> None:
    try:
        while True:
            item = await watcher.next()
            await (socket.send_text(item) if isinstance(item, str) else socket.send_bytes(item))
    except (WebSocketDisconnect, RuntimeError):
        return


def camera_state(status: str, *, silent: bool) -> str:
    """A text that explains a missing picture by the state of the camera's component."""
    if silent:
        return sentence("the camera's component does not answer")
    return sentence("the camera's component is in {status}", status=status) if status not in ("", "READY") else ""
