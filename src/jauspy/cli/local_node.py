"""A node manager for the robots of this machine: the one that runs, or a child that is kept running."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.cli.children import Child, ChildFailed
from jauspy.protocol import junior
from jauspy.transport import local_socket

RESTART_DELAY: Final = 1.0  # seconds


@asynccontextmanager
async def node_manager(root: Path, port: int) -> AsyncIterator[str]:
    """Make sure that one runs in this local root, and goes on running; yields where, for people.

    When it dies, whoever started it, one is started here; components find it by themselves.
    """
    keeper = _Keeper(root, lambda: _child(root, port))
    if keeper.is_there():
        where = f"was running, local sockets in {root}"
    else:
        await keeper.start()
        where = f"UDP port {port}, local sockets in {root}"
    keeping = asyncio.create_task(keeper.keep())
    try:
        yield where
    finally:
        keeping.cancel()
        await asyncio.gather(keeping, return_exceptions=True)
        await keeper.stop()


class _Keeper:
    """Watches the node manager of a local root, and starts one when there is none."""

    def __init__(self, root: Path, make: Callable[[], Child]) -> None:
        self._socket = root / junior.SOCKET_NAME
        self._make = make
        self._child: Child | None = None

    def is_there(self) -> bool:
        return local_socket.is_alive(self._socket)

    async def start(self) -> None:
        """Raises `ChildFailed` when it does not start."""
        child = self._make()
        await child.__aenter__()
        self._child = child

    async def stop(self) -> None:
        if self._child is not None:
            await self._child.stop()

    async def keep(self) -> None:
        if self._child is None:
            await self._absence()
            console.note("the node manager that was running has ended; starting one")
        told = ""
        while True:
            if self._child is not None:
                console.note(f"{await self._child.ended()}; starting it again")
                self._child = None
                await asyncio.sleep(RESTART_DELAY)
            await self._absence()
            try:
                await self.start()
            except ChildFailed as error:
                if str(error) != told and not self.is_there():  # else somebody was quicker
                    console.error(told := str(error))
                await asyncio.sleep(RESTART_DELAY)

    async def _absence(self) -> None:
        """Wait while one runs that somebody else has started; no event says when it ends."""
        while self.is_there():  # noqa: ASYNC110
            await asyncio.sleep(RESTART_DELAY)


def _child(root: Path, port: int) -> Child:
    return Child("node manager", ["node-manager", "--port", str(port), "--local-root", str(root)])
