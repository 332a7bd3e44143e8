"""What `jauspy up` runs, and in which order it ends."""

from __future__ import annotations

import asyncio
import signal
from contextlib import AbstractAsyncContextManager, AsyncExitStack
from pathlib import Path

from jauspy.cli import console
from jauspy.cli.local_node import Keeper
from jauspy.cli.node_serve import print_counters
from jauspy.cli.up_tell import tell
from jauspy.modules.cloud import Clouds
from jauspy.modules.robot import RobotRunner


async def run_robot(
    runner: RobotRunner,
    node: AbstractAsyncContextManager[Keeper] | None,
    root: Path,
    clouds: Clouds,
    *,
    live: bool,
) -> None:
    """Until cancelled. `node`: the node manager that is started with it; `live`: with a table on the terminal."""
    async with AsyncExitStack() as stack:

        def at_the_end(text: str) -> None:
            if live:
                stack.callback(console.note, text)

        at_the_end("all of it has stopped")
        keeper = await stack.enter_async_context(node) if node else None
        if keeper is not None and keeper.is_own:
            at_the_end("stopping the node manager")

        def tell_counters() -> None:
            print_counters({**runner.counters, **clouds.counters}, f"counters of {runner.config.name}:")
            if keeper is not None:
                keeper.print_counters()

        await stack.enter_async_context(runner)
        at_the_end("stopping the modules, the cameras and the robot")
        asyncio.get_running_loop().add_signal_handler(signal.SIGUSR1, tell_counters)
        tell(runner, keeper.where if keeper else f"none started, local sockets in {root}", root)
        await stack.enter_async_context(clouds.published(runner))
        if live:
            from jauspy.cli.up_live import live_table

            await stack.enter_async_context(live_table(runner, root))
        await runner.wait()
