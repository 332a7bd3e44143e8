"""One process of a camera, from its start to its end: orders go in, words come out."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Sequence
from contextlib import suppress
from typing import Final, Self

from jauspy import workers
from jauspy.video.orders import LENGTH, Command, length, packed, unpacked

BACKLOG: Final = 1 << 22
"""Bytes of orders, the first of which carries the model of the world, that the process may leave unread; one that
leaves more hangs."""


class WorkerProcess:
    """Ends with the robot's process, however that ends, since its standard input does."""

    def __init__(self, process: asyncio.subprocess.Process, orders: asyncio.StreamWriter) -> None:
        self._process, self._orders = process, orders

    @classmethod
    async def start(cls, descriptors: Sequence[int]) -> Self:
        """A new one, which inherits these files and waits for its first order, `Begin`."""
        process = await workers.start("jauspy.video.worker", descriptors)
        assert process.stdin is not None
        return cls(process, process.stdin)

    @property
    def pid(self) -> int:
        """Its number."""
        return self._process.pid

    def order(self, order: Command) -> bool:
        """Tell it what to do; false when it hangs."""
        if self._orders.is_closing():
            return True
        self._orders.write(packed(order))
        return self._orders.transport.get_write_buffer_size() <= BACKLOG

    async def words(self) -> AsyncIterator[object]:
        """What it says, until it has ended."""
        heard = self._process.stdout
        assert heard is not None
        with suppress(asyncio.IncompleteReadError):
            while True:
                head = await heard.readexactly(LENGTH)
                yield unpacked(await heard.readexactly(length(head)))

    async def ended(self) -> int:
        """Wait for its end; its status."""
        return await self._process.wait()

    def kill(self) -> None:
        """End it at once; fine when it has ended."""
        with suppress(ProcessLookupError):
            self._process.kill()

    async def stop(self) -> None:
        """Have it end, if need be by force."""
        await workers.stop(self._process)
