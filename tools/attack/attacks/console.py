"""The console: strangers who hold connections and guess passwords, and users of its machine without its token."""

from __future__ import annotations

import contextlib
import re
import socket
import ssl
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Final
from urllib.parse import urlencode

from jauspy.console.certificates import make_certificate
from jauspy.console.connections import STRANGERS
from jauspy.console.users import add_user

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds
from ..hosts import Host
from ..processes import Victim
from .tcp import connect

PORT: Final = 20796
RATE: Final = 100
KEPT: Final = 410
"""Connections that stay open."""
HONEST_INTERVAL: Final = 0.5
PASSWORD: Final = "correct horse battery"  # noqa: S105 - of the console that is attacked
TOKEN: Final = "a-token-that-only-the-operator-knows"  # noqa: S105 - as above
MEMORY: Final = 64.0
"""MiB by which the console may grow; a password that is verified takes 64 MiB for a moment, before the attack too."""
DESCRIPTORS: Final = STRANGERS.of_group + 8
_WITH_CONSOLE: Final = Bounds(descriptors=4, tasks=4)
"""The node manager and the robot still know the components of the console that has ended."""
FOREIGN: Final = ("sec-fetch-site: cross-site", "sec-fetch-mode: navigate", "sec-fetch-dest: iframe")


class Visitor:
    """An HTTP client on one machine; each request has a connection of its own."""

    def __init__(self, host: Host, where: tuple[str, int], trust: ssl.SSLContext | None) -> None:
        self.cookie = ""
        self._host, self._where, self._trust = host, where, trust

    def request(self, method: str, path: str, *lines: str, body: str = "") -> int:
        """Send a request; the status of the answer, 0 if there is none. Cookies of the answer are kept."""
        host = f"{self._where[0]}:{self._where[1]}"
        head = [f"{method} {path} HTTP/1.1", f"host: {host}", "connection: close", f"cookie: {self.cookie}", *lines]
        if method == "POST":
            scheme = "https" if self._trust else "http"
            head += [f"origin: {scheme}://{host}", f"content-length: {len(body)}"]
        try:
            with self.connected() as sock:
                sock.sendall("\r\n".join([*head, "", body]).encode())
                answer = b"".join(iter(lambda: sock.recv(1 << 16), b"")).decode(errors="replace")
        except OSError:
            return 0
        self.cookie = "; ".join(re.findall(r"^set-cookie: ([^;]+)", answer, re.M)) or self.cookie
        found = re.match(r"HTTP/1.1 (\d+) ", answer)
        return int(found[1]) if found else 0

    @contextlib.contextmanager
    def connected(self) -> Iterator[socket.socket]:
        """A connection, with TLS if the console has it."""
        with connect(self._host, self._where) as plain:
            if self._trust is None:
                yield plain
                return
            with self._trust.wrap_socket(plain, server_hostname=self._where[0]) as sock:
                yield sock

    def log_in(self, password: str) -> int:
        """Send a login; the status of the answer is 303 if it has succeeded."""
        return self.request("POST", "/login", body=urlencode({"name": "anna", "password": password}))


@contextlib.contextmanager
def console(arena: Arena, address: str, *options: str) -> Iterator[Victim]:
    """A console beside the robot."""
    where = ("--host", address, "--port", str(PORT), "--connect", f"local:{arena.root}", "--no-browser")
    victim = Victim(arena.hosts["robot"], arena.folder, "console", ("console", *where, *options))
    try:
        victim.wait_for("the console is at")
        yield victim
    finally:
        victim.stop()


def strangers(arena: Arena) -> None:
    """Connections that say nothing, half of a handshake, half of a request; guesses; pages of other sites."""
    address = arena.hosts["robot"].address
    certificate, key, users = (
        arena.folder / f"console-{name}" for name in ("certificate.pem", "key.pem", "users.toml")
    )
    for path in (certificate, key, users):
        path.unlink(missing_ok=True)
    make_certificate([address], certificate, key)
    add_user(users, "anna", "operator", PASSWORD)
    trust = ssl.create_default_context(cafile=str(certificate))
    options = ("--users", str(users), "--certificate", str(certificate), "--key", str(key))
    where = (address, PORT)
    operator, newcomer, attacker = (
        Visitor(arena.hosts[name], where, trust) for name in ("operator", "operator", "attacker")
    )
    with console(arena, address, *options) as victim:
        arena.require(operator.log_in(PASSWORD) == 303, "the operator cannot log in before the attack")
        before = victim.usage()
        kept: list[socket.socket] = []
        due = 0.0
        for number in arena.paced(RATE):
            _hold_one(arena, number, where, kept)
            if number % 50 == 0:
                attacker.log_in(f"guess {number}")
                arena.require(attacker.request("GET", "/", *FOREIGN) in (0, 403), "a page of another site is answered")
            if time.monotonic() >= due:
                due = time.monotonic() + HONEST_INTERVAL
                arena.asked += 1
                arena.lost += operator.request("GET", "/login") != 303  # as for those who are logged in
        arena.require(newcomer.log_in(PASSWORD) == 303, "guesses of another host lock the operator out")
        after = victim.usage()
        for what, growth, bound in (
            ("the console grew by MiB", after.memory - before.memory, MEMORY),
            ("descriptors of the console are open", after.descriptors - before.descriptors, DESCRIPTORS),
        ):
            arena.require(growth <= bound, f"{what}: {growth:.4g}; the bound is {bound:g}")


def _hold_one(arena: Arena, number: int, where: tuple[str, int], kept: list[socket.socket]) -> None:
    """Open one more connection, and say a little on an old one."""
    with contextlib.suppress(OSError):
        kept.append(sock := arena.open(connect(arena.attacker, where)))
        sock.setblocking(False)
        if number % 3 == 1:
            sock.send(b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc")  # the begin of a ClientHello
        elif number % 3 == 2:
            sock.send(arena.chance.randbytes(100))
    arena.sent += 1
    with contextlib.suppress(OSError, IndexError):
        arena.chance.choice(kept).send(b"\x03")
    if len(kept) > KEPT:
        kept.pop(arena.chance.randrange(len(kept))).close()


def without_token(arena: Arena) -> None:
    """Every kind of route, with guessed tokens and cookies, while the operator uses the console."""
    token_file = Path(arena.folder, "console.token")
    token_file.write_text(TOKEN)
    token_file.chmod(0o600)
    where = ("127.0.0.1", PORT)
    robot = arena.hosts["robot"]
    loopback = Host(robot.name, where[0], robot.address6, "", robot.namespace)
    operator, attacker = (Visitor(loopback, where, None) for _ in range(2))
    paths = (
        "/",
        "/static/console.js",
        "/ws/stop/x",
        "/ws/drive/101/x",
        "/_nicegui_ws/socket.io/",
        "/world/mesh/101/x/0",
    )
    upgrade = ("upgrade: websocket", "connection: upgrade", "sec-websocket-version: 13", "sec-websocket-key: eA==")
    with console(arena, where[0], "--token-file", str(token_file)):
        arena.require(operator.request("GET", f"/?token={TOKEN}") == 303, "the operator's token is refused")
        due = 0.0
        for number in arena.paced(RATE):
            attacker.cookie = f"jauspy-{PORT}={arena.chance.randbytes(32).hex()}"
            guess = f"?token={arena.chance.randbytes(16).hex()}" * (number % 2)
            lines = (*upgrade, f"origin: http://127.0.0.1:{PORT}") if number % 3 == 0 else ()
            status = attacker.request("GET", paths[number % len(paths)] + guess, *lines)
            arena.sent += 1
            arena.require(status in (0, 400, 403), f"{paths[number % len(paths)]} is answered with {status}")
            if time.monotonic() >= due:
                due = time.monotonic() + HONEST_INTERVAL
                arena.asked += 1
                arena.lost += operator.request("GET", "/static/theme.css") != 200


STRANGERS_OF_CONSOLE: Final = Attack("console-strangers", Attacker.REMOTE, "connections", strangers, _WITH_CONSOLE)
WITHOUT_TOKEN: Final = Attack("console-without-token", Attacker.LOCAL, "requests", without_token, _WITH_CONSOLE)
