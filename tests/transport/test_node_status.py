"""Whatever serves a status in a local root, readers get a status, or none."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.protocol.addressing import UNKNOWN_LOCATION, Location
from jauspy.testing import until
from jauspy.transport import node_status

GOOD = {
    "components": [{"id": "101.1.102"}],
    "peers": [{"id": "42.1.1", "address": "192.0.2.7:3794", "heard": 0.5}],
}


@asynccontextmanager
async def serving(root: Path, text: bytes) -> AsyncIterator[None]:
    async def answer(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(text)
        writer.close()

    async with await asyncio.start_unix_server(answer, root / node_status.SOCKET_NAME):
        yield


async def test_a_status_is_read(root: Path) -> None:
    async with serving(root, json.dumps(GOOD).encode()):
        assert await node_status.read(root) == GOOD
        assert await asyncio.to_thread(node_status.read_at_once, root) == GOOD


@pytest.mark.parametrize(
    "text",
    [
        *(b"[]", b"7", b"{", b"", b"\xff", b'{"components": 3}', b'{"components": [3]}', b'{"components": [{}]}'),
        json.dumps({"peers": [{"id": "42.1.1"}]}).encode(),
        b"[" * 100_000,
        b'"' + b"a" * (node_status.MAX_STATUS + 1) + b'"',
    ],
    ids=range(11),
)
async def test_what_is_no_status_is_none(root: Path, text: bytes) -> None:
    async with serving(root, text):
        with pytest.raises(TransportError, match="no node manager serves its status"):
            await node_status.read(root)
        assert await asyncio.to_thread(node_status.read_at_once, root) == {}
        locator, found = node_status.Locator(root), asyncio.get_running_loop().create_future()
        locator.locate(JausID.parse("42.1.1"), found.set_result)
        location: Location = await asyncio.wait_for(found, 10.0)
        assert location == UNKNOWN_LOCATION
        locator.close()


async def test_a_location_has_what_was_sent_and_what_waits(root: Path) -> None:
    networks = {"networks": [{"name": "radio", "send_queue": 4321}, {"name": "odd", "send_queue": "x"}, 7]}
    row = {"id": "42.1.1", "address": "192.0.2.7:3794", "heard": 0.5, "network": "radio", "sent_bytes": 1000}
    peers = {"peers": [row, row | {"id": "43.1.1", "network": "odd", "sent_bytes": True}]}
    components = {"components": [{"id": "101.1.102", "waiting_bytes": 77}, {"id": "101.1.103", "waiting_bytes": -1}]}
    async with serving(root, json.dumps({**GOOD, **networks, **peers, **components}).encode()):
        locator = node_status.Locator(root)
        found: dict[str, Location] = {}
        for id in ("42.1.1", "43.1.1", "101.1.102", "101.1.103"):
            locator.locate(JausID.parse(id), partial(found.__setitem__, id))
        await until(lambda: len(found) == 4)
        locator.close()
    loads = {id: (location.sent, location.waiting) for id, location in found.items()}
    assert loads == {
        "42.1.1": (1000, 4321),
        "43.1.1": (None, None),
        "101.1.102": (None, 77),
        "101.1.103": (None, None),
    }


async def test_a_location_has_what_the_limits_of_its_link_left_out(root: Path) -> None:
    row = {"id": "42.1.1", "address": "192.0.2.7:3794", "heard": 0.5, "network": "radio", "link": "radio"}
    odd: list[object] = [7, {"link": "radio"}, {"link": "radio", "message": "x", "count": "many"}, {"count": 3}]
    some = [{"link": "radio", "message": "A", "count": n} for n in (1, 2)] + [
        {"link": "lan", "message": "A", "count": 9}
    ]
    many = [{"link": "radio", "message": f"M{number}", "count": 1} for number in range(10_000)]
    async with serving(root, json.dumps({**GOOD, "peers": [row], "left_out": [*odd, *some, *many]}).encode()):
        locator = node_status.Locator(root)
        found: list[Location] = []
        locator.locate(JausID.parse("42.1.1"), found.append)
        await until(lambda: len(found) == 1)
        locator.close()
    assert found[0].left_out[0] == ("A", 3)
    assert len(found[0].left_out) == node_status.MAX_LEFT_OUT


async def test_a_location_has_the_ports_of_the_node_managers(root: Path) -> None:
    networks = {"networks": [{"address": "127.0.0.1:4794"}, {"address": 7}, 3]}
    peers = {"peers": [{"id": "42.1.1", "address": "192.0.2.7:4795", "heard": 0.5}]}
    async with serving(root, json.dumps({**GOOD, **networks, **peers}).encode()):
        locator = node_status.Locator(root)
        found: dict[str, Location] = {}
        for id in ("42.1.1", "101.1.102", "7.1.1"):
            locator.locate(JausID.parse(id), partial(found.__setitem__, id))
        locator.locate(JausID.parse("8.1.1"), partial(found.__setitem__, "8.1.1"), is_here=True)
        await until(lambda: len(found) == 4)
        locator.close()
    assert found["42.1.1"] == Location(hosts=frozenset({"192.0.2.7"}), ports=frozenset({4794, 4795}))
    assert found["7.1.1"] == Location(ports=frozenset({4794}))
    assert found["101.1.102"] == found["8.1.1"] == node_status.this_machine()._replace(ports=frozenset({4794}))


async def test_a_status_that_does_not_come_leaves_no_connection_open(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[asyncio.StreamWriter] = []
    connect = asyncio.open_unix_connection

    async def noted(path: Path) -> Any:
        reader, writer = await connect(path)
        opened.append(writer)
        return reader, writer

    async def say_nothing(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.read()  # until the connection is closed
        writer.close()

    monkeypatch.setattr(asyncio, "open_unix_connection", noted)
    monkeypatch.setattr(node_status, "READ_TIMEOUT", 0.05)
    async with await asyncio.start_unix_server(say_nothing, root / node_status.SOCKET_NAME):
        while not opened:
            with pytest.raises(TransportError, match="no answer"):
                await node_status.read(root)
        assert all(writer.transport.is_closing() for writer in opened)
        await opened[-1].wait_closed()
