"""A browser of the console that sends anything on its sockets: noise, numbers out of range, floods, forged lines."""

from __future__ import annotations

import json
import random
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from urllib.parse import urlsplit
from urllib.request import HTTPCookieProcessor, build_opener

import psutil
from websockets.exceptions import WebSocketException
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds

RATE = 400
ON_ONE = 150
"""Messages on one connection."""
GROWTH = 150 << 20
"""Bytes by which the console may grow: pages of browsers that have left are kept for some seconds."""
PAGE = re.compile(r'data-token="([\w-]+)"')
CLIENT = re.compile(r"client_id[^0-9a-z]{1,20}([0-9a-f-]{36})")
SEEDS = (
    "[0.5, 0]",
    "[NaN, 1]",
    "[1e999, -1e999]",
    '[0.1, 0, 0, 0, 0, 0, "tool"]',
    '{"want": "keys", "attitude": true}',
    "stop 70000",
    "[" * 900,
    "\x1b]0;x\x07",
)
PARTS = ("[", "{", "NaN", "9" * 40, '"', "\x1b[2J", ",", "null")


@contextmanager
def console(arena: Arena) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """A console on the robot's machine: its URL, and its process; what it has logged is checked at the end."""
    command = [sys.executable, "-m", "jauspy.cli.main", "console", "--no-browser", "--port", "0"]
    command += ["--connect", f"local:{arena.root}"]
    with tempfile.TemporaryFile() as log:
        process = subprocess.Popen(arena.hosts["robot"].command(*command), stdout=subprocess.PIPE, stderr=log)
        try:
            assert process.stdout is not None
            yield process.stdout.readline().decode().strip().rpartition(" ")[2], process
            arena.require(process.poll() is None, "the console has ended")
        finally:
            process.kill()
            process.wait()
        log.seek(0)
        text = log.read().decode(errors="replace")
    arena.require("Traceback" not in text, f"the console logs a traceback: {text[-300:]!r}")
    arena.require("\x1b" not in text, "the console logs escape sequences of a terminal")
    arena.require(text.count("\n") < 200, f"the console logs {text.count(chr(10))} lines")


class Browser:
    """A browser with a session at the console, whose address has the token."""

    def __init__(self, url: str) -> None:
        cookies = HTTPCookieProcessor()
        self._opener, self._jar = build_opener(cookies), cookies.cookiejar
        self._opener.open(url).close()
        parts = urlsplit(url)
        self._url = f"{parts.scheme}://{parts.netloc}"

    def page(self) -> tuple[str, str]:
        """The token of a new page, and the id of its client."""
        with self._opener.open(self._url) as answer:
            text = answer.read().decode().replace("\\", "")
        token, client = PAGE.search(text), CLIENT.search(text)
        assert token is not None
        assert client is not None
        return token[1], client[1]

    def connect(self, path: str) -> ClientConnection:
        """A socket at this path."""
        cookie = {"cookie": "; ".join(f"{cookie.name}={cookie.value}" for cookie in self._jar)}
        url = self._url.replace("http", "ws", 1) + path
        return connect(url, origin=Origin(self._url), additional_headers=cookie, close_timeout=0.5)


def mutated(chance: random.Random, text: str) -> str:
    """The text with a few of its parts replaced."""
    for _ in range(chance.randrange(3)):
        where = chance.randrange(len(text) + 1)
        text = text[:where] + chance.choice(PARTS) + text[where + chance.randrange(3) :]
    return text


def packet(chance: random.Random, client: str) -> str:
    """A packet of the page's socket."""
    content = {
        "client_id": client,
        "id": chance.randrange(300),
        "listener_id": str(chance.randrange(300)),
        "args": [chance.choice(["1e9", "NaN", "true", '"x"', "[]"])],
        "level": "error",
        "message": "\x1b[2J anna has logged in",
    }
    return f"42{json.dumps([chance.choice(['event', 'log', 'ack', 'handshake']), content])}"


def send(arena: Arena, socket: ClientConnection, client: str) -> None:
    """Send one message of any kind."""
    chance = arena.chance
    arena.sent += 1
    if chance.random() < 0.05:
        socket.send(chance.randbytes(chance.randrange(2000)))
    else:
        socket.send(mutated(chance, packet(chance, client) if client else chance.choice(SEEDS)))


def run(arena: Arena) -> None:
    """One connection after the other, on each of the sockets in turn."""
    with arena.hosts["robot"].entered(), console(arena) as (url, process):
        memory = psutil.Process(process.pid).memory_info
        browser = Browser(url)
        before, turns, socket = 0, 0, None
        paths = ("drive/101", "jog/101.1.104", "video/101.1.106", "world/101", "stop", "")
        for number in arena.paced(RATE):
            with suppress(OSError, WebSocketException):
                if socket is None or number % ON_ONE == 0:
                    if socket is not None:
                        socket.close()
                    token, client = browser.page()
                    path = paths[turns % len(paths)]
                    query = f"/_nicegui_ws/socket.io/?EIO=4&transport=websocket&client_id={client}"
                    where = f"/ws/{path}/{token}" if path else query
                    socket = browser.connect(where)
                    turns += 1
                    client = "" if path else client
                    if turns == 2 * len(paths):
                        before = memory().rss
                send(arena, socket, client)
        browser.page()
        growth = memory().rss - before if before else 0
        arena.require(growth < GROWTH, f"the console has grown by {growth >> 20} MiB")


ATTACK = Attack("console-sockets", Attacker.LOCAL, "messages", run, Bounds(descriptors=4, tasks=4))
"""The node manager and the robot still know the components of the console that has ended."""
