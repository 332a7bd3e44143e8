"""Connections of the console without a session: they are closed in time, and keep nobody out."""

from __future__ import annotations

import asyncio
import errno
import socket
import ssl
import struct
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

import uvicorn

from jauspy.console import connections as module
from jauspy.console.certificates import make_certificate
from jauspy.console.connections import KNOWN, STRANGERS, Connections, Share, network_of
from jauspy.console.login import LoginMiddleware
from jauspy.console.server import AcceptingServer

TOKEN = "token-of-this-start"
QUICK = 0.2
"""Seconds in place of the times of the console."""


async def answering(scope: Any, receive: Any, send: Any) -> None:
    """The application behind the login."""
    if scope["type"] == "websocket":
        await send({"type": "websocket.accept"})
        while (await receive())["type"] != "websocket.disconnect":
            pass
        return
    await send({"type": "http.response.start", "status": 200, "headers": [(b"content-length", b"5")]})
    await send({"type": "http.response.body", "body": b"hello"})


class Served:
    """A server at a port of its own."""

    def __init__(self, port: int, connections: Connections, trust: ssl.SSLContext | None, notes: list[str]) -> None:
        self.port, self.connections, self._trust, self.notes = port, connections, trust, notes
        self._writers: list[asyncio.StreamWriter] = []

    async def connect(self, *, tls: bool = True) -> asyncio.StreamReader:
        """Connect, and send nothing but the handshake of TLS."""
        trust = self._trust if tls else None
        reader, writer = await asyncio.open_connection(
            "127.0.0.1", self.port, ssl=trust, server_hostname="localhost" if trust else None
        )
        self._writers.append(writer)
        return reader

    async def send(self, reader: asyncio.StreamReader, data: bytes) -> None:
        """Send on a connection that `connect` has opened."""
        writer = next(each for each in self._writers if each.transport is reader._transport)  # type: ignore[attr-defined]
        writer.write(data)
        await writer.drain()

    async def get(self, reader: asyncio.StreamReader, path: str = "/", *lines: str) -> bytes:
        """Send a request on a connection; the head of its answer."""
        head = "".join(f"{line}\r\n" for line in (f"GET {path} HTTP/1.1", "host: localhost", *lines))
        await self.send(reader, f"{head}\r\n".encode())
        async with asyncio.timeout(20.0):
            return await reader.readuntil(b"\r\n\r\n")

    async def enter(self) -> str:
        """The line with the cookie of a new session."""
        answer = await self.get(await self.connect(), f"/?token={TOKEN}")
        found = next(line for line in answer.decode().split("\r\n") if line.startswith("set-cookie: "))
        return f"cookie: {found.removeprefix('set-cookie: ').partition(';')[0]}"

    def close(self) -> None:
        for writer in self._writers:
            writer.transport.abort()


@asynccontextmanager
async def served(folder: Path | None = None, backlog: int = 512) -> AsyncIterator[Served]:
    """A console with an application of this test, with TLS if there is a folder for its certificate."""
    listener = socket.create_server(("127.0.0.1", 0), backlog=backlog)
    notes: list[str] = []
    connections, trust, files = Connections(notes.append), None, dict[str, Any]()
    if folder is not None:
        certificate, key = folder / "certificate.pem", folder / "key.pem"
        make_certificate(["localhost"], certificate, key)
        trust = ssl.create_default_context(cafile=str(certificate))
        files = {"ssl_certfile": certificate, "ssl_keyfile": key}
    port = listener.getsockname()[1]
    gate = LoginMiddleware(answering, None, lambda _: None, port=port, token=TOKEN, connections=connections)
    config = uvicorn.Config(
        gate, http="h11", lifespan="off", log_level="critical", timeout_graceful_shutdown=1, **files
    )
    server = AcceptingServer(config, listener, connections)
    task = asyncio.create_task(server.serve())
    while not server.started:
        await asyncio.sleep(0.01)
    found = Served(port, connections, trust, notes)
    try:
        yield found
    finally:
        found.close()
        server.should_exit = True
        await task
        listener.close()


async def is_closed(reader: asyncio.StreamReader) -> bool:
    """Wait until the server closes a connection."""
    async with asyncio.timeout(20.0):
        with suppress(ConnectionError, ssl.SSLError):
            await reader.read()
        return True


@pytest.mark.parametrize("tls", [False, True], ids=["plain", "tls"])
async def test_idle_connections_of_one_host_keep_nobody_out(tls: bool, tmp_path: Path) -> None:
    """They used to count for all: 410 of them were 503 for everybody."""
    async with served(tmp_path if tls else None) as at:
        cookie = await at.enter()
        idle = [await at.connect() for _ in range(STRANGERS.of_group + 8)]
        assert b" 200 " in await at.get(await at.connect(), "/", cookie)
        assert all([await is_closed(each) for each in idle[:8]]), "the oldest ones"
        assert at.connections.closed[STRANGERS.reason] >= 8
        assert len(at.connections) <= STRANGERS.of_group + 3
        assert at.notes[0].startswith("connections closed because too many had no session: 1 so far, now one of 127.")
        assert len(at.notes) <= 6


async def test_a_handshake_that_does_not_end_is_not_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "HANDSHAKE_TIME", QUICK)
    async with served(tmp_path) as at:
        silent = [await at.connect(tls=False) for _ in range(4)]
        await at.send(silent[0], b"\x16\x03\x01\x02\x00\x01")
        await at.send(silent[1], b"GET / HTTP/1.1\r\n\r\n")
        assert all([await is_closed(each) for each in silent])
        assert at.connections.closed["handshake"] == 4
        assert b" 403 " in await at.get(await at.connect())


@pytest.mark.parametrize(
    "slow",
    [b"", b"GET / HTT", b"GET / HTTP/1.1\r\nhost: localhost\r\nx: ", b"GET / HTTP/1.1\r\nhost: localhost\r\n\r\nG"],
)
async def test_a_request_that_does_not_end_is_not_waited_for(slow: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "IDLE_TIME", QUICK)
    monkeypatch.setattr(module, "_SWEEP_INTERVAL", QUICK / 4)
    async with served() as at:
        reader = await at.connect()
        await at.send(reader, slow)
        assert await is_closed(reader)
        assert at.connections.closed["no request"] == 1


async def test_headers_without_end_are_refused() -> None:
    async with served() as at:
        reader = await at.connect()
        await at.send(reader, b"GET / HTTP/1.1\r\nx: " + bytes(1 << 16))
        async with asyncio.timeout(20.0):
            assert b" 400 " in await reader.readline()


async def test_a_form_that_does_not_end_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "REQUEST_TIME", QUICK)
    monkeypatch.setattr(module, "_SWEEP_INTERVAL", QUICK / 4)

    async def waiting(scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "http":
            while (await receive())["type"] != "http.disconnect":
                pass

    monkeypatch.setattr(LoginMiddleware, "_handle", lambda self, *request: waiting(*request))
    async with served() as at:
        reader = await at.connect()
        await at.send(reader, b"POST /login HTTP/1.1\r\nhost: localhost\r\ncontent-length: 9\r\n\r\nname")
        assert await is_closed(reader)
        assert at.connections.closed["slow request"] == 1


@pytest.mark.slow
async def test_sockets_of_a_session_stay_open_beside_idle_connections() -> None:
    async with served() as at:
        cookie = await at.enter()
        origin = "origin: http://localhost"
        upgrade = ("upgrade: websocket", "connection: upgrade", "sec-websocket-version: 13")
        stop = await at.connect()
        key = "sec-websocket-key: dGhlIHNhbXBsZSBub25jZQ=="
        assert b" 101 " in await at.get(stop, "/ws/stop/x", cookie, origin, *upgrade, key)
        for _ in range(2 * STRANGERS.of_group):
            await at.connect()
        for _ in range(2 * KNOWN.of_group):
            assert b" 200 " in await at.get(await at.connect(), "/", cookie)
        assert at.connections.closed[KNOWN.reason] >= KNOWN.of_group - 1
        await at.send(stop, bytes([0x89, 0x80, 0, 0, 0, 0]))
        async with asyncio.timeout(20.0):
            assert await stop.readexactly(2) == bytes([0x8A, 0]), "a pong"


async def test_of_many_hosts_the_one_with_most_connections_loses_its_oldest(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "STRANGERS", Share(4, 6, "too many"))
    monkeypatch.setattr(module, "network_of", lambda address: "few" if len(hosts) < 3 else "many")
    hosts: list[asyncio.StreamReader] = []
    async with served() as at:
        for _ in range(10):
            hosts.append(await at.connect())
            await at.get(hosts[-1])
        assert all([await is_closed(each) for each in hosts[3:6]])
        for each in (*hosts[:3], *hosts[-3:]):
            assert not each.at_eof()


async def test_no_descriptor_left_closes_the_oldest_stranger(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_ACCEPT_PAUSE", 0.0)
    async with served() as at:
        first = await at.connect()
        await at.get(first)
        accept, refused = socket.socket.accept, [errno.EMFILE]

        def without_descriptors(sock: socket.socket) -> Any:
            if refused:
                raise OSError(refused.pop(), "Too many open files")
            return accept(sock)

        monkeypatch.setattr(socket.socket, "accept", without_descriptors)
        await at.get(await at.connect())
        assert b" 403 " in await at.get(await at.connect())
        assert await is_closed(first)


@pytest.mark.slow
async def test_a_peer_that_does_not_read_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "IDLE_TIME", QUICK)
    monkeypatch.setattr(module, "_SWEEP_INTERVAL", QUICK / 4)
    async with served() as at:
        with socket.create_connection(("127.0.0.1", at.port)) as peer:
            peer.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            await asyncio.to_thread(peer.sendall, 4000 * b"GET / HTTP/1.1\r\nhost: localhost\r\n\r\n")
            async with asyncio.timeout(20.0):
                while len(at.connections):
                    await asyncio.sleep(QUICK / 4)


def test_the_host_of_an_address() -> None:
    assert network_of("10.0.0.1") == "10.0.0.1"
    assert network_of("::ffff:10.0.0.1") == "10.0.0.1"
    assert network_of("2001:db8::1") == network_of("2001:db8::2") == "2001:db8::/64"
    assert network_of("fe80::1%eth0") == "fe80::/64"
    assert network_of("?") == "?"
