"""Video for browsers: each camera is received once, and its encoded pictures go to all who watch."""

from __future__ import annotations

import asyncio
import struct
from collections.abc import Callable
from contextlib import aclosing
from typing import Final

from fastapi import WebSocket, WebSocketDisconnect

from jauspy.errors import JausError
from jauspy.ocu.camera import Camera
from jauspy.video.h264_payload import SPS, Picture, join_nals, nal_type
from jauspy.video.rtp import CLOCK_RATE

MAX_QUEUED: Final = 8
"""Pictures that wait for one browser; a slower one gets none until the next IDR picture."""
RETRY_INTERVAL: Final = 2.0
"""Seconds until a camera is asked again after its stream has ended."""
_HEADER: Final = struct.Struct("<?xxxxxxxd")
"""Whether a decoder can start with the picture, and its time in microseconds."""


class Watcher:
    """One browser that watches."""

    def __init__(self) -> None:
        self.queue: asyncio.Queue[bytes | str] = asyncio.Queue(MAX_QUEUED)
        self._waits_for_idr = True

    def put(self, picture: Picture, data: bytes, codec: str) -> None:
        """Queue a picture; when the queue is full, all until the next IDR picture are left out."""
        if self._waits_for_idr and not picture.is_idr:
            return
        if self.queue.full():
            self._waits_for_idr = True
            return
        if self._waits_for_idr and codec:
            self.queue.put_nowait(codec)
            if self.queue.full():
                return
        self._waits_for_idr = False
        self.queue.put_nowait(data)


class SharedCamera:
    """Receives a camera while somebody watches."""

    def __init__(self, camera: Camera, on_event: Callable[[str], None]) -> None:
        self._camera = camera
        self._on_event = on_event
        self._watchers: set[Watcher] = set()
        self._task: asyncio.Task[None] | None = None
        self._codec = ""

    async def serve(self, socket: WebSocket) -> None:
        """Send the pictures to one browser until it leaves: the codec as text, then each picture as bytes."""
        watcher = Watcher()
        self._watchers.add(watcher)
        if self._task is None or self._task.done():
            self._task = asyncio.create_task(self._receive(), name=f"console: {self._camera!r}")
        leaving = asyncio.create_task(_until_closed(socket))
        try:
            while not leaving.done():
                getting = asyncio.create_task(watcher.queue.get())
                await asyncio.wait({getting, leaving}, return_when=asyncio.FIRST_COMPLETED)
                if not getting.done():
                    getting.cancel()
                    return
                item = getting.result()
                await (socket.send_text(item) if isinstance(item, str) else socket.send_bytes(item))
        except (WebSocketDisconnect, RuntimeError):
            return
        finally:
            leaving.cancel()
            self._watchers.discard(watcher)
            if not self._watchers and self._task is not None:
                self._task.cancel()
                self._task = None

    async def _receive(self) -> None:
        told = ""
        while True:
            try:
                async with aclosing(self._camera.encoded()) as pictures:
                    async for picture in pictures:
                        self._hand_out(picture)
                        told = ""
            except JausError as error:
                if str(error) != told:
                    self._on_event(f"no video: {error}")
                told = str(error)
            await asyncio.sleep(RETRY_INTERVAL)

    def _hand_out(self, picture: Picture) -> None:
        if picture.is_idr:
            parameters = next((nal for nal in picture.nals if nal_type(nal) == SPS), b"")
            self._codec = f"avc1.{parameters[1:4].hex()}" if len(parameters) > 3 else self._codec
        data = _HEADER.pack(picture.is_idr, picture.timestamp * 1e6 / CLOCK_RATE) + join_nals(picture.nals)
        for watcher in self._watchers:
            watcher.put(picture, data, self._codec)


async def _until_closed(socket: WebSocket) -> None:
    try:
        while True:
            await socket.receive_text()
    except (WebSocketDisconnect, RuntimeError):
        return
