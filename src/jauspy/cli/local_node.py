"""A node manager for the robots of this machine: the one that runs, or a child that is kept running."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.cli.children import Child, ChildFailed
from jauspy.cli.probe import node_manager_at

RESTART_DELAY: Final = 1.0  # seconds


@asynccontextmanager
async def node_manager(root: Path, port: int) -> AsyncIterator[str]:
    """Make sure that one runs in this local root; yields where, for people.

    One that was started here is started again when it dies; components find it by themselves.
    """
    if node_manager_at(root):
        yield f"was running, local sockets in {root}"
        return
    child = _child(root, port)
    await child.__aenter__()
    keeper = asyncio.create_task(_keep(child, root, port))
    try:
        yield f"UDP port {port}, local sockets in {root}"
    finally:
        keeper.cancel()
        await asyncio.gather(keeper, return_exceptions=True)


async def _keep(child: Child, root: Path, port: int) -> None:
    try:
        while True:
            console.note(f"{await child.ended()}; starting it again")
            await asyncio.sleep(RESTART_DELAY)
            while node_manager_at(root):  # noqa: ASYNC110 - somebody else was quicker, and no event says when it ends
                await asyncio.sleep(RESTART_DELAY)
            child = _child(root, port)
            try:
                await child.__aenter__()
            except ChildFailed as error:
                console.error(str(error))
    finally:
        await child.stop()


def _child(root: Path, port: int) -> Child:
    return Child("node manager", ["node-manager", "--port", str(port), "--local-root", str(root)])
