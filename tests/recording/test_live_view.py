"""The live view, with a client of another library."""

from __future__ import annotations

import asyncio
import base64
import json
import socket
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from typing import Any

import pytest
from tests.recording.protobuf import decoded

pytest.importorskip("foxglove", reason="foxglove-sdk is of the extra `recording`")
websockets = pytest.importorskip("websockets", reason="websockets is of the extra `console`")

from foxglove import messages as fox  # noqa: E402 - after the check

from jauspy.errors import TransportError  # noqa: E402 - after the check
from jauspy.recording import live_view  # noqa: E402 - after the check
from jauspy.recording.foxglove_messages import picture  # noqa: E402 - after the check
from jauspy.recording.live_view import LiveView  # noqa: E402 - after the check
from jauspy.recording.samples import Sample, sample  # noqa: E402 - after the check

PROTOCOL = "foxglove.sdk.v1"
LARGE = 100_000


def line(text: str, state: str) -> Sample:
    return sample("/log", time.time_ns(), fox.Log(message=text), state=state)


def frame(number: int, size: int = LARGE, *, is_idr: bool = True) -> Sample:
    return picture("101.1.106", time.time_ns(), number.to_bytes(4, "big") + bytes(size), is_idr=is_idr)


class Client:
    """Subscribes to all that is advertised."""

    def __init__(self, ws: Any) -> None:
        self.ws = ws
        self._channels: dict[int, dict[str, Any]] = {}

    async def read(self) -> tuple[str, Any]:
        """The topic and the message that come next."""
        while True:
            data = await self.ws.recv()
            if isinstance(data, bytes):
                channel = self._channels[int.from_bytes(data[1:5], "little")]
                schema = base64.b64decode(channel["schema"])
                return channel["topic"], decoded(channel["schemaName"], schema, data[13:])
            new = json.loads(data).get("channels", ())
            self._channels |= {channel["id"]: channel for channel in new}
            wanted = [{"id": channel["id"], "channelId": channel["id"]} for channel in new]
            if wanted:
                await self.ws.send(json.dumps({"op": "subscribe", "subscriptions": wanted}))

    async def lines(self, last: str) -> tuple[list[str], list[int]]:
        """Lines of the log up to one, and the numbers of the pictures before it."""
        texts: list[str] = []
        pictures: list[int] = []
        while last not in texts:
            topic, message = await self.read()
            if topic == "/log":
                texts.append(message.message)
            else:
                pictures.append(int.from_bytes(message.data[:4], "big"))
        return texts, pictures


@pytest.fixture
async def view() -> AsyncIterator[tuple[LiveView, int]]:
    view = LiveView()
    yield view, await view.start("127.0.0.1", 0)
    await view.close()


@asynccontextmanager
async def connected(port: int) -> AsyncIterator[Client]:
    """A client with a small receive buffer, which reads only while it is asked to."""
    sock = socket.socket()
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 16)
    sock.setblocking(False)
    await asyncio.get_running_loop().sock_connect(sock, ("127.0.0.1", port))
    uri = f"ws://127.0.0.1:{port}"
    ws = await websockets.connect(
        uri, sock=sock, subprotocols=[PROTOCOL], max_size=None, max_queue=1, ping_interval=None, close_timeout=0.1
    )
    try:
        yield Client(ws)
    finally:
        with suppress(OSError, websockets.ConnectionClosed):
            await ws.close()


async def until(is_done: Callable[[], bool]) -> None:
    async with asyncio.timeout(30):
        while not is_done():
            await asyncio.sleep(0.01)


async def test_a_new_client_gets_the_present_states_and_then_what_happens(view: tuple[LiveView, int]) -> None:
    server, port = view
    for number in range(20):
        server.publish(line(f"a{number}", "a"))
    server.publish(line("b", "b"))
    server.publish(frame(0))
    async with connected(port) as client:
        assert (await client.lines("b"))[0] == ["a19", "b"]
        server.publish(line("c", "c"))
        server.publish(frame(1))
        assert (await client.read())[1].message == "c"
        topic, message = await client.read()
        assert (topic, message.format, len(message.data)) == ("/101.1.106/video", "h264", LARGE + 4)


async def test_a_client_that_is_behind_gets_each_state_but_not_each_picture(
    view: tuple[LiveView, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(live_view, "STALL", 60.0)
    server, port = view
    server.publish(line("first", "first"))
    server.publish(frame(0, 10))
    async with connected(port) as client:
        await client.lines("first")
        server.publish(frame(1, 10))
        while (await client.read())[0] != "/101.1.106/video":
            pass
        for number in range(2, 200):  # the client does not read
            server.publish(frame(number))
            server.publish(line(f"{number}", "number"))
            await asyncio.sleep(0.005)
        assert server.counters["bulk_left_out"] > 100
        texts, pictures = await client.lines("199")
        assert texts == [str(number) for number in range(2, 200)]
        assert len(pictures) < 40
        # once it has caught up, pictures begin with one that can be decoded alone
        server.publish(frame(300, 10, is_idr=False))
        server.publish(frame(301, 10))
        server.publish(line("end", "end"))
        _, pictures = await client.lines("end")
        assert pictures == [301]


async def test_a_client_that_was_cut_off_finds_the_present_states_and_no_old_data(
    view: tuple[LiveView, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(live_view, "STALL", 0.5)
    monkeypatch.setattr(live_view, "CHECK_INTERVAL", 0.05)
    server, port = view
    server.publish(line("first", "first"))
    server.publish(frame(0, 10))
    async with connected(port) as client:
        await client.lines("first")
        for number in range(2000):  # nothing is read, for longer than `STALL`
            server.publish(frame(number))
            server.publish(line(f"{number}", "number"))
            if server.counters["stalled"]:
                break
            await asyncio.sleep(0.01)
    await until(lambda: not server._clients)
    assert server.counters["stalled"] == 1
    for number in range(2000, 2100):
        server.publish(frame(number))
        server.publish(line(f"{number}", "number"))
    async with connected(port) as client:
        texts, pictures = await client.lines("2099")
        assert sorted(texts) == ["2099", "first"]
        assert not pictures


@pytest.mark.slow
async def test_a_client_that_was_cut_off_for_ten_seconds_gets_what_holds_now(view: tuple[LiveView, int]) -> None:
    """With the limits of the product, and pictures and states at the rates of a robot."""
    server, port = view
    server.publish(line("first", "first"))
    server.publish(frame(0, 10))
    async with connected(port) as client:
        await client.lines("first")
        for number in range(1, 301):  # the client does not read
            server.publish(frame(number))
            server.publish(line(f"{number}", "number"))
            await asyncio.sleep(1.0 / 30.0)
    assert server.counters["stalled"] == 1
    async with connected(port) as client:
        texts, pictures = await client.lines("300")
        assert sorted(texts) == ["300", "first"]
        assert not pictures


async def test_garbage_of_a_client_ends_at_most_that_client(view: tuple[LiveView, int]) -> None:
    server, port = view
    server.publish(line("first", "first"))
    async with connected(port) as good:
        await good.lines("first")
        for rubbish in (b"", b"\x00" * 3000, b"GET / HTTP/1.1\r\n\r\n", b"\xff" * 100_000, b"GET /" + b"a" * 200_000):
            _, writer = await asyncio.open_connection("127.0.0.1", port)
            with suppress(OSError):
                writer.write(rubbish)
                await writer.drain()
            writer.close()
        async with connected(port) as bad:
            for message in ("{", "[]", '{"op":"subscribe","subscriptions":[{"id":-1}]}', "x" * 1_000_000, b"\x00", b""):
                with suppress(websockets.ConnectionClosed):
                    await bad.ws.send(message)
        server.publish(line("still here", "second"))
        assert (await good.lines("still here"))[0] == ["still here"]


async def test_clients_are_limited(view: tuple[LiveView, int], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(live_view, "MAX_CLIENTS", 1)
    server, port = view
    server.publish(line("first", "first"))
    async with connected(port) as client:
        await client.lines("first")
        with pytest.raises((OSError, websockets.InvalidMessage, EOFError)):
            async with connected(port):
                pass
        assert server.counters["refused"] == 1
    await until(lambda: not server._tasks)
    async with connected(port) as client:
        await client.lines("first")


async def test_a_silent_connection_ends(view: tuple[LiveView, int], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(live_view, "HANDSHAKE_TIME", 0.1)
    monkeypatch.setattr(live_view, "CHECK_INTERVAL", 0.02)
    reader, writer = await asyncio.open_connection("127.0.0.1", view[1])
    async with asyncio.timeout(20):
        with suppress(ConnectionResetError):
            assert await reader.read() == b""
    writer.close()


async def test_a_port_that_is_taken_is_one_sentence(view: tuple[LiveView, int]) -> None:
    with pytest.raises(TransportError, match="choose another --port"):
        await LiveView().start("127.0.0.1", view[1])
