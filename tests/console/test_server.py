"""The console's sockets and page, over a real port, beside a robot in memory."""

from __future__ import annotations

import asyncio
import json
import re
import signal
import socket
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import suppress

import pytest
from tests.helpers.command_line import robot_in_thread, start

pytest.importorskip("nicegui", reason="needs the extra 'console'")
pytest.importorskip("websockets", reason="needs the extra 'console'")

from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus

from jauspy.console.server import serving
from jauspy.errors import ConfigError
from jauspy.testing import LocalNode

PAGE = re.compile(r'jauspy\.start\("([\w-]+)"\)')


async def page(url: str) -> str:
    def get() -> str:
        with urllib.request.urlopen(url) as answer:
            text: str = answer.read().decode()
            return text

    return await asyncio.to_thread(get)


def token_of(text: str) -> str:
    found = PAGE.search(text.replace("\\", ""))
    assert found, "the page starts its script with a token"
    return found[1]


@pytest.fixture(scope="module")
def console() -> Iterator[str]:
    """The URL of a console beside a robot that runs."""
    with robot_in_thread() as robot:
        process = start("console", "--no-browser", "--port", "0", "--connect", robot.local)
        try:
            assert process.stdout is not None
            url = process.stdout.readline().strip().rpartition(" ")[2]
            assert url.startswith("http://127.0.0.1:"), process.stderr and process.stderr.read()
            yield url
        finally:
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=30)


async def test_a_browser_takes_control_of_nothing_and_stops_all(console: str) -> None:
    token = token_of(await page(console))
    base = console.replace("http", "ws")
    async with asyncio.timeout(60.0):
        async with connect(f"{base}/ws/drive/101/{token}", origin=console) as drive:
            await drive.send(json.dumps([1.0, 0.0]))
            assert await drive.recv() in ("the robot has gone", "take control first")
        async with connect(f"{base}/ws/stop/{token}", origin=console) as stop:
            await stop.send("dance 101")
            assert await stop.recv() == "not understood: dance 101"
            await stop.send("stop 101")
            assert re.fullmatch(r"(\d+) of \1 components stopped", str(await stop.recv()))
            await stop.send("release 101")
            assert "released from the emergency" in str(await stop.recv())


async def test_sockets_are_refused_to_other_sites_and_without_a_token(console: str) -> None:
    token = token_of(await page(console))
    base = console.replace("http", "ws")
    for path, origin in (
        (f"/ws/stop/{token}", "http://elsewhere.example"),
        (f"/ws/stop/{token}", None),
        ("/ws/stop/guessed", console),
        ("/ws/drive/101/guessed", console),
        ("/ws/video/101.1.106/guessed", console),
    ):
        with pytest.raises((InvalidStatus, ConnectionClosed)):
            async with connect(base + path, origin=origin) as refused:
                await refused.recv()


async def test_the_world_of_a_robot_is_sent(console: str) -> None:
    token = token_of(await page(console))
    base = console.replace("http", "ws") + "/ws/world"
    async with asyncio.timeout(60.0):
        while True:
            with suppress(ConnectionClosed):  # until the robot is found
                async with connect(f"{base}/101/{token}", origin=console) as world:
                    shown = json.loads(await world.recv())["model"]
                    while "pose" not in (state := json.loads(await world.recv())):
                        pass
                    break
            await asyncio.sleep(0.1)
        with pytest.raises(ConnectionClosed, match="there is no such robot"):
            async with connect(f"{base}/7/{token}", origin=console) as other:
                await other.recv()
    assert shown["root"] == "base_link"
    assert "arm_link_4_to_arm_link_5" in {each["name"] for each in shown["joints"]}
    assert len(state["joints"]) == sum(each["kind"] != "fixed" for each in shown["joints"])
    assert state["pose"][:2] == pytest.approx([0.0, 0.0], abs=0.5)
    for path in (f"101/{token}/9999", "101/guessed/0", f"7/{token}/0"):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            await page(f"{console}/world/mesh/{path}")


@pytest.mark.parametrize(("host", "said"), [("0.0.0.0", "only with TLS and a login"), ("127.0.0.1", "choose another")])
async def test_addresses_that_cannot_be_served(node_manager: LocalNode, host: str, said: str) -> None:
    async with node_manager.ocu("42.1.2") as ocu, node_manager.ocu("42.1.3") as stopper:
        with socket.create_server(("127.0.0.1", 0)) as taken, pytest.raises(ConfigError, match=said):
            async with serving(ocu, stopper, host, taken.getsockname()[1]):
                pass
