"""Video and descriptions that `record` and `live` take along, and `live` beside a node manager."""

from __future__ import annotations

import asyncio
import json
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from jauspy.cli import recorded, video
from jauspy.cli.main import app
from jauspy.cli.recorded import Camera, cameras, described, pictures_taken, take_pictures
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.recording.recorder import Picture
from jauspy.video.h264_payload import join_nals, packetise
from jauspy.video.rtp import RtpPacket

CAMERA = JausID(101, 1, 106)
NALS = [b"\x67sps", b"\x68pps", b"\x65" + bytes(5000)]
"""Parameter sets and an IDR picture of several packets."""


class FakeOcu:
    """A client of whom the cameras are on this machine."""

    def __init__(self, problem: Exception | None = None) -> None:
        self._problem = problem

    async def __aenter__(self) -> FakeOcu:
        return self

    async def __aexit__(self, *_: object) -> None:
        pass

    async def discover(self, subsystem: int) -> None:
        assert subsystem == 101
        if self._problem is not None:
            raise self._problem

    async def address_towards(self, _: JausID) -> str:
        return "127.0.0.1"


@pytest.fixture
def sends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cameras that send two pictures to whoever registers."""

    @asynccontextmanager
    async def registered(_: Any, camera: JausID, sensor: int, url: str) -> AsyncIterator[None]:
        assert (camera, sensor) == (CAMERA, 2)
        port = int(url.rpartition(":")[2])
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            sequence = 0
            for timestamp in (0, 3000):
                payloads = packetise(NALS)
                for payload in payloads:
                    is_last = payload is payloads[-1]
                    packet = RtpPacket(sequence, timestamp, 7, payload, marker=is_last)
                    sender.sendto(packet.encode(), ("127.0.0.1", port))
                    sequence += 1
            yield

    monkeypatch.setattr(video, "registered", registered)


async def test_pictures_come_as_they_were_sent(sends: None) -> None:
    found: asyncio.Queue[Picture] = asyncio.Queue()
    ocu: Any = FakeOcu()
    task = asyncio.create_task(take_pictures(ocu, [Camera(CAMERA, 2)], found.put_nowait, lambda: None))
    async with asyncio.timeout(20):
        for _ in range(2):
            picture = await found.get()
            assert picture.camera == "101.1.106/2"
            assert picture.access_unit == join_nals(NALS)
            assert picture.is_idr
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)


def test_pictures_are_taken_in_a_thread_until_the_end(sends: None) -> None:
    found: list[Picture] = []
    ocu: Any = FakeOcu()
    with pictures_taken(ocu, [Camera(CAMERA, 2)], found.append):
        pass
    problem = FakeOcu(RequestError("there is no such camera"))
    failing: Any = problem
    with (
        pytest.raises(RequestError, match="no such camera"),
        pictures_taken(failing, [Camera(CAMERA, 2)], found.append),
    ):
        pytest.fail("the context was entered")


def test_cameras_by_name() -> None:
    assert list(map(str, cameras(["101.1.106", "101.1.107/2"]))) == ["101.1.106", "101.1.107/2"]
    for name in ("101.1.106/0", "101.1.106/x", "101.1.106/"):
        with pytest.raises(ConfigError, match="name one camera"):
            cameras([name])
    with pytest.raises(ConfigError, match="at most"):
        cameras(["101.1.106"] * (recorded.MAX_CAMERAS + 1))


def test_descriptions_by_name() -> None:
    assert described(["inc1"])[101].movers[104] == "arm"
    with pytest.raises(ConfigError, match="same subsystem"):
        described(["inc1", "inc1"])


def test_video_needs_a_file_that_has_room_for_it(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["record", str(tmp_path / "run.pcapng"), "--video", "101.1.106"])
    assert "needs a .mcap file" in result.stderr
    assert not list(tmp_path.iterdir())


def test_info_counts_messages_of_jaus_only(tmp_path: Path) -> None:
    pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
    from tests.recording.test_recording import RUN

    from jauspy.messages import registry
    from jauspy.recording.recorder import Recorder

    Recorder(tmp_path / "run.mcap", registry).run(RUN)
    found = json.loads(CliRunner().invoke(app, ["info", str(tmp_path / "run.mcap"), "--json"]).stdout)
    assert {row["message"] for row in found["messages"]} == {"ReportLocalPose", "ReportStatus"}
