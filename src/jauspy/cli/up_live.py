"""The live table of `jauspy up`."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any, Final

from rich.live import Live

from jauspy.cli import console
from jauspy.cli.up_look import Lookout
from jauspy.cli.up_table import table
from jauspy.errors import TransportError
from jauspy.modules.robot import RobotRunner
from jauspy.node import status

INTERVAL: Final = 0.4
"""Seconds between two looks."""


@asynccontextmanager
async def live_table(runner: RobotRunner, root: Path) -> AsyncIterator[None]:
    """Draw it as long as this lasts; what is printed meanwhile, on either stream, stands above it."""
    with Live(console=console.stderr(), auto_refresh=False, transient=True, vertical_overflow="crop") as live:
        drawing = asyncio.create_task(_draw(live, runner, root))
        try:
            yield
        finally:
            drawing.cancel()
            with suppress(asyncio.CancelledError):
                await drawing


async def _draw(live: Live, runner: RobotRunner, root: Path) -> None:
    """Drawing takes some milliseconds, in which the robot shall answer: so a thread does it."""
    lookout, clock = Lookout(runner), asyncio.get_running_loop().time
    began = clock()
    while True:
        told = await _told(root)
        now = clock()
        drawn = table(runner.config, lookout.look(now, told), now - began)
        await asyncio.to_thread(live.update, drawn, refresh=True)
        await asyncio.sleep(INTERVAL)


async def _told(root: Path) -> dict[str, Any] | None:
    """What the node manager says of itself; None when it does not, as while it is started again."""
    try:
        return await status.read(root)
    except TransportError:
        return None
