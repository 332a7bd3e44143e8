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
from tests.helpers.console_visit import Visit, visit

pytest.importorskip("nicegui", reason="needs the extra 'console'")
pytest.importorskip("websockets", reason="needs the extra 'console'")

from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.typing import Origin

from jauspy.console.open_pages import MAX_PAGES_OF_SESSION
from jauspy.console.server import serving
from jauspy.errors import ConfigError
from jauspy.testing import LocalNode

PAGE = re.compile(r'data-token="([\w-]+)"')


async def page(console: Visit, path: str = "/") -> str:
    return await asyncio.to_thread(console.get, path)


def socket_of(console: Visit, path: str, origin: str | None = "") -> connect:
    """A WebSocket at this path; its origin is by default the console."""
    given = None if origin is None else Origin(origin or console.url)
    return connect(console.sockets + path, origin=given, additional_headers=console.headers)


def token_of(text: str) -> str:
    found = PAGE.search(text)
    assert found, "the page gives its scripts a token"
    return found[1]


@pytest.fixture(scope="module")
def console() -> Iterator[Visit]:
    """A session at a console beside a robot that runs."""
    with robot_in_thread() as robot:
        process = start("console", "--no-browser", "--port", "0", "--connect", robot.local)
        try:
            assert process.stdout is not None
            url = process.stdout.readline().strip().rpartition(" ")[2]
            assert url.startswith("http://127.0.0.1:"), process.stderr and process.stderr.read()
            yield visit(url)
        finally:
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=30)


@pytest.mark.slow
async def test_a_browser_takes_control_of_nothing_and_stops_all(console: Visit) -> None:
    token = token_of(await page(console))
    async with asyncio.timeout(60.0):
        async with socket_of(console, f"/ws/drive/101/{token}") as drive:
            await drive.send(json.dumps([1.0, 0.0]))
            assert await drive.recv() in ("the robot has gone", "take control first")
        async with socket_of(console, f"/ws/stop/{token}") as stop:
            await stop.send("dance 101")
            assert await stop.recv() == "not understood: stop or release, and a robot's number or all"
            await stop.send("stop 101")
            assert re.fullmatch(r"(\d+) of \1 components stopped", str(await stop.recv()))
            await stop.send("release 101")
            assert "released from the emergency" in str(await stop.recv())


@pytest.mark.slow
async def test_pages_that_never_connect_keep_no_other_out(console: Visit) -> None:
    tokens = [token_of(await page(console)) for _ in range(MAX_PAGES_OF_SESSION + 1)]
    with pytest.raises((InvalidStatus, ConnectionClosed)):
        async with socket_of(console, f"/ws/stop/{tokens[0]}") as given_up:
            await given_up.recv()
    async with asyncio.timeout(60.0), socket_of(console, f"/ws/stop/{tokens[-1]}") as stop:
        await stop.send("dance 101")
        assert await stop.recv() == "not understood: stop or release, and a robot's number or all"


async def test_each_answer_has_a_policy_and_each_script_of_the_page_its_nonce(console: Visit) -> None:
    def get(path: str) -> tuple[str, str]:
        with urllib.request.urlopen(urllib.request.Request(console.url + path, headers=console.headers)) as answer:
            return answer.headers["Content-Security-Policy"], answer.read().decode()

    (first, text), (second, _), (of_file, _) = [
        await asyncio.to_thread(get, path) for path in ("/", "/", "/static/console.js")
    ]
    nonces = [re.search("'nonce-([^']+)'", policy)[1] for policy in (first, second, of_file)]
    assert len(set(nonces)) == 3
    assert text.count("<script") == text.count(f'<script nonce="{nonces[0]}"') + text.count('<script src="/static/') > 8
    assert not re.search(r"<[^>]*\son\w+=", text), "no code in attributes"
    directives = dict(each.split(" ", 1) for each in first.split("; "))
    assert directives.pop("script-src") == f"'self' 'nonce-{nonces[0]}' 'unsafe-eval'"
    assert directives == {
        "default-src": "'none'",
        "script-src-attr": "'none'",
        "style-src": "'self' 'unsafe-inline'",
        "img-src": "'self' data: blob:",
        "font-src": "'self'",
        "media-src": "'self'",
        "connect-src": "'self' data: blob:",
        "base-uri": "'none'",
        "form-action": "'self'",
        "frame-ancestors": "'none'",
        "object-src": "'none'",
        "require-trusted-types-for": "'script'",
        "trusted-types": "default vue dompurify",
    }


async def test_sockets_are_refused_to_other_sites_and_without_a_token(console: Visit) -> None:
    token = token_of(await page(console))
    for path, origin in (
        (f"/ws/stop/{token}", "http://elsewhere.example"),
        (f"/ws/stop/{token}", None),
        ("/ws/stop/guessed", console.url),
        ("/ws/drive/101/guessed", console.url),
        ("/ws/video/101.1.106/guessed", console.url),
    ):
        with pytest.raises((InvalidStatus, ConnectionClosed)):
            async with socket_of(console, path, origin) as refused:
                await refused.recv()


async def test_nothing_is_reached_without_the_cookie_that_the_token_gives(console: Visit) -> None:
    token = token_of(await page(console))
    stranger = Visit(console.url, {"cookie": "jauspy-8101=guessed"})
    for path in ("/", "/?token=guessed", "/static/console.js", "/_nicegui_ws/socket.io/", f"/world/mesh/101/{token}/0"):
        with pytest.raises(urllib.error.HTTPError, match="403") as refused:
            await page(stranger, path)
        assert "the address with its token that `jauspy console` prints" in refused.value.read().decode()
    for path in (f"/ws/stop/{token}", f"/ws/drive/101/{token}", "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"):
        with pytest.raises(InvalidStatus, match="403"):
            await socket_of(stranger, path)


@pytest.mark.slow
async def test_the_world_of_a_robot_is_sent(console: Visit) -> None:
    token = token_of(await page(console))
    async with asyncio.timeout(60.0):
        while True:
            with suppress(ConnectionClosed):  # until the robot is found
                async with socket_of(console, f"/ws/world/101/{token}") as world:
                    shown = json.loads(await world.recv())["model"]
                    while "pose" not in (state := json.loads(await world.recv())):
                        pass
                    break
            await asyncio.sleep(0.1)
        with pytest.raises(ConnectionClosed, match="there is no such robot"):
            async with socket_of(console, f"/ws/world/7/{token}") as other:
                await other.recv()
    assert shown["root"] == "base_link"
    assert "arm_link_4_to_arm_link_5" in {each["name"] for each in shown["joints"]}
    assert len(state["joints"]) == sum(each["kind"] != "fixed" for each in shown["joints"])
    assert state["pose"][:2] == pytest.approx([0.0, 0.0], abs=0.5)
    for path in (f"101/{token}/9999", "101/guessed/0", f"7/{token}/0"):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            await page(console, f"/world/mesh/{path}")


@pytest.mark.slow
@pytest.mark.parametrize(("host", "said"), [("0.0.0.0", "only with TLS and a login"), ("127.0.0.1", "choose another")])
async def test_addresses_that_cannot_be_served(node_manager: LocalNode, host: str, said: str) -> None:
    async with node_manager.ocu("42.1.2") as ocu, node_manager.ocu("42.1.3") as stopper:
        with socket.create_server(("127.0.0.1", 0)) as taken, pytest.raises(ConfigError, match=said):
            async with serving(ocu, stopper, host, taken.getsockname()[1]):
                pass
