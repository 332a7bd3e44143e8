"""Video for browsers: what waits for a slow one, why there is no picture, and what a browser may ask for."""

from __future__ import annotations

import asyncio
import json
import struct
from collections.abc import AsyncGenerator, Callable
from datetime import UTC, datetime
from typing import Any

import pytest

pytest.importorskip("fastapi", reason="needs the extra 'console'")

from jauspy.console import video as module
from jauspy.console.video import MAX_BYTES, MAX_QUEUED, Attitude, SharedCamera, Watcher, camera_state
from jauspy.console.video_quality import LinkQualityMeter
from jauspy.errors import RequestError
from jauspy.video.h264_payload import IDR, SPS, Picture

KEY = Picture(0, (bytes([SPS, 0x42, 0xC0, 0x1E]), bytes([IDR]) + b"key"), whole=True)
OTHER = Picture(6000, (b"\x01other",), whole=True)
TAKEN = datetime(2026, 1, 1, tzinfo=UTC)


def refuse(reason: str) -> None:
    """Ignore a message that is refused."""


class FakeCamera:
    """Sends what the test puts into its queue; an exception ends the stream."""

    waiting = "the robot agreed to send to rtp://here, and no packet has arrived"

    note = ""

    def __init__(self) -> None:
        self.counters: dict[str, int] = {}
        self.queue: asyncio.Queue[Picture | Exception] = asyncio.Queue()
        self.receiving = 0
        self.refreshed = 0

    async def encoded(self) -> AsyncGenerator[Picture, None]:
        self.receiving += 1
        try:
            while True:
                item = await self.queue.get()
                if isinstance(item, Exception):
                    raise item
                yield item
        finally:
            self.receiving -= 1

    def taken(self, picture: Picture) -> datetime:
        return TAKEN

    def refresh(self) -> None:
        self.refreshed += 1


class Browser:
    """The server's end of a WebSocket."""

    def __init__(self) -> None:
        self.asked: asyncio.Queue[str | None] = asyncio.Queue()
        self.texts: list[dict[str, Any]] = []
        self.pictures: list[bytes] = []
        self.reads = asyncio.Event()
        self.reads.set()

    async def receive(self) -> dict[str, Any]:
        text = await self.asked.get()
        return {"type": "websocket.disconnect" if text is None else "websocket.receive", "text": text}

    async def send_text(self, text: str) -> None:
        await self.reads.wait()
        self.texts.append(json.loads(text))

    async def send_bytes(self, data: bytes) -> None:
        await self.reads.wait()
        self.pictures.append(data)

    def said(self, name: str) -> Any:
        return next((each[name] for each in reversed(self.texts) if name in each), None)


async def until(condition: Callable[[], object]) -> None:
    async with asyncio.timeout(10.0):
        while not condition():
            await asyncio.sleep(0.001)


def test_a_slow_browser_gets_nothing_until_the_next_key_picture() -> None:
    watcher = Watcher()
    watcher.put(OTHER, b"before", "avc1")
    assert len(watcher) == 0, "a decoder cannot begin with it"
    for _ in range(1000):
        watcher.put(KEY, b"key", "avc1")
    assert len(watcher) == MAX_QUEUED
    assert watcher.left_out == 1000 - MAX_QUEUED
    large = Watcher()
    for _ in range(3):
        large.put(KEY, bytes(MAX_BYTES // 2), "avc1")
    assert len(large) == 2


async def test_news_of_one_kind_replace_each_other_and_come_before_pictures() -> None:
    watcher = Watcher()
    for heading in range(1000):
        watcher.tell(attitude={"heading": heading}, reason="none")
    watcher.put(KEY, b"key", "avc1.42c01e")
    assert json.loads(await watcher.next()) == {
        "attitude": {"heading": 999},
        "reason": "none",
        "codec": "avc1.42c01e",
    }
    assert await watcher.next() == b"key"


def test_only_key_pictures_or_nothing() -> None:
    watcher = Watcher()
    assert watcher.choose("keys")
    for picture in (KEY, OTHER, OTHER, KEY, OTHER):
        watcher.put(picture, b"data", "avc1")
    assert len(watcher) == 2
    assert not watcher.choose("nothing")
    watcher.put(KEY, b"data", "avc1")
    assert len(watcher) == 2
    assert watcher.left_out == 0, "what was not asked for is not missing"


async def test_a_picture_carries_when_it_was_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    camera, browser = FakeCamera(), Browser()
    shared = SharedCamera(camera, "101.1.106", lambda _: None)  # type: ignore[arg-type] - what it uses of a camera
    serving = asyncio.create_task(shared.serve(browser, refuse))  # type: ignore[arg-type] - what it uses of a socket
    for picture in (KEY, OTHER):
        camera.queue.put_nowait(picture)
    await until(lambda: len(browser.pictures) == 2)
    heads = [struct.unpack("<?xxxxxxxdd", each[:24]) for each in browser.pictures]
    assert heads == [(True, 0.0, 1e3 * TAKEN.timestamp()), (False, 6000 * 1e6 / 90000, 1e3 * TAKEN.timestamp())]
    assert browser.said("codec") == "avc1.42c01e"
    assert camera.refreshed == 1, "one who begins to watch asks for a key picture"
    browser.asked.put_nowait("not JSON")
    browser.asked.put_nowait("[1]")
    browser.asked.put_nowait('{"want": "keys"}')
    await until(lambda: camera.refreshed == 2)
    monkeypatch.setattr(module, "KEY_INTERVAL", 0.0)
    await until(lambda: camera.refreshed == 3)
    browser.asked.put_nowait(None)
    await serving
    await until(lambda: camera.receiving == 0)


async def test_the_browser_is_told_what_the_link_does() -> None:
    camera, browser = FakeCamera(), Browser()
    camera.counters = {"packets": 1000, "missing": 10}
    shared = SharedCamera(camera, "101.1.106", lambda _: None)  # type: ignore[arg-type] - what it uses of a camera
    serving = asyncio.create_task(shared.serve(browser, refuse))  # type: ignore[arg-type] - what it uses of a socket
    await asyncio.sleep(0.6)  # the first look
    camera.counters = {"packets": 1190, "missing": 20, "lost": 10}
    await until(lambda: browser.said("link") is not None)
    assert browser.said("link") == {"missing": 0.05, "lost": 0.05}
    browser.asked.put_nowait(None)
    await serving


def test_the_links_quality_is_that_of_the_last_ten_seconds() -> None:
    meter = LinkQualityMeter()
    assert meter.add(0.0, {}) == (0.0, 0.0)
    assert meter.add(1.0, {"packets": 100, "missing": 5}) == (0.05, 0.0)
    assert meter.add(2.0, {"packets": 198, "missing": 10, "lost": 2}) == (0.05, 0.01)
    assert meter.add(12.5, {"packets": 298, "missing": 10, "lost": 2}) == (0.0, 0.0)
    assert meter.add(13.0, {"packets": 3}) == (0.0, 0.0), "another receiver counts from 0"
    assert meter.add(14.0, {"packets": 53, "missing": 1}) == (0.02, 0.0)


async def test_one_that_does_not_read_holds_nobody_up() -> None:
    camera, slow, fast = FakeCamera(), Browser(), Browser()
    shared = SharedCamera(camera, "101.1.106", lambda _: None)  # type: ignore[arg-type] - what it uses of a camera
    slow.reads.clear()
    serving = [asyncio.create_task(shared.serve(each, refuse)) for each in (slow, fast)]  # type: ignore[arg-type] - a socket
    for number in range(200):
        camera.queue.put_nowait(KEY)
        await until(lambda number=number: len(fast.pictures) > number)
    slow.reads.set()
    await until(lambda: slow.said("left_out") is not None)
    assert slow.said("left_out") >= 200 - MAX_QUEUED - 2
    assert fast.said("left_out") is None
    for each in (slow, fast):
        each.asked.put_nowait(None)
    await asyncio.gather(*serving)


async def test_why_there_is_no_picture_is_reported_in_words(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "QUIET_TIME", 0.0)
    camera, browser, events = FakeCamera(), Browser(), list[str]()
    state = camera_state("STANDBY", silent=False)
    shared = SharedCamera(camera, "101.1.106", events.append, lambda: state)  # type: ignore[arg-type] - what it uses
    serving = asyncio.create_task(shared.serve(browser, refuse))  # type: ignore[arg-type] - what it uses of a socket
    await until(lambda: browser.said("reason"))
    assert browser.said("reason") == f"{camera.waiting}; the camera's component is in STANDBY"
    camera.queue.put_nowait(RequestError("101.1.106 does not send to rtp://here"))
    await until(lambda: "does not send to" in browser.said("reason"))
    assert events == ["no video of 101.1.106: 101.1.106 does not send to rtp://here"]
    browser.asked.put_nowait(None)
    await serving


class FakeFeed:
    """Tells one attitude to those who follow it."""

    def __init__(self) -> None:
        self.watchers: list[Callable[[Attitude], None]] = []

    def add(self, watcher: Callable[[Attitude], None]) -> None:
        self.watchers.append(watcher)
        watcher(Attitude(heading=12.0))

    def remove(self, watcher: Callable[[Attitude], None]) -> None:
        if watcher in self.watchers:
            self.watchers.remove(watcher)


async def test_the_attitude_goes_to_those_who_show_it() -> None:
    feed, browser = FakeFeed(), Browser()
    shared = SharedCamera(FakeCamera(), "101.1.106", lambda _: None, attitude=feed)  # type: ignore[arg-type] - fakes
    serving = asyncio.create_task(shared.serve(browser, refuse))  # type: ignore[arg-type] - what it uses of a socket
    for _ in range(2):
        browser.asked.put_nowait('{"want": "all", "attitude": true}')
    await until(lambda: browser.said("attitude"))
    assert browser.said("attitude") == {"heading": 12.0, "pitch": None, "roll": None, "speed": None}
    await until(browser.asked.empty)
    assert len(feed.watchers) == 1
    browser.asked.put_nowait(None)
    await serving
    assert feed.watchers == []


async def test_what_a_camera_says_is_sent_once_and_is_the_reason_for_no_picture(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(module, "QUIET_TIME", 0.0)
    camera, browser, events = FakeCamera(), Browser(), []
    shared = SharedCamera(camera, "101.1.106", events.append)  # type: ignore[arg-type] - what it uses of a camera
    camera.note = "camera arm is still starting"
    serving = asyncio.create_task(shared.serve(browser, refuse))  # type: ignore[arg-type] - what it uses of a socket
    await until(lambda: browser.said("note") == "camera arm is still starting")
    assert events == [], "its end is no news"
    camera.note = ""
    camera.queue.put_nowait(KEY)
    await until(lambda: browser.said("note") == "")
    assert events == []
    for note in ("the robot's machine is too slow for camera arm", ""):
        camera.note = note
        await until(lambda: browser.said("note") == camera.note)
    assert events == [
        "video of 101.1.106: the robot's machine is too slow for camera arm",
        "video of 101.1.106: all that is set again",
    ]
    assert sum("note" in each for each in browser.texts) == 4
    browser.asked.put_nowait(None)
    await serving
