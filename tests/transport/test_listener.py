"""Stream connections whose server ends, however far their handlers are."""

from __future__ import annotations

import asyncio
import logging
import socket
from contextlib import suppress

import pytest

from jauspy.protocol.counters import Counters
from jauspy.transport.listener import StreamServer


@pytest.mark.parametrize("turns", range(6))
async def test_a_server_that_ends_closes_its_connections(turns: int) -> None:
    problems: list[object] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: problems.append(context))
    writers: list[asyncio.StreamWriter] = []
    ended: list[bool] = []

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writers.append(writer)
        try:
            writer.write(b"a" * 10_000_000)  # more than the socket takes
            await reader.read()
        finally:
            ended.append(True)
            writer.close()

    sock = socket.create_server(("127.0.0.1", 0))
    address = sock.getsockname()
    server = StreamServer(sock, serve, Counters(logging.getLogger(__name__)))
    with socket.create_connection(address) as client:
        for _ in range(turns):
            await asyncio.sleep(0)
        await server.close()
        assert len(ended) == len(writers)
        await asyncio.to_thread(read_to_the_end, client)
    assert not problems


def read_to_the_end(client: socket.socket) -> None:
    client.settimeout(10.0)
    with suppress(ConnectionResetError):
        while client.recv(1 << 20):
            pass
