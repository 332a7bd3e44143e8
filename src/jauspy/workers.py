"""Processes that work for this one: how they are started, ended, and started again when they die."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Awaitable, Callable, Sequence
from contextlib import suppress
from typing import Final

PAUSES: Final = (0.5, 10.0)
"""Seconds before a process that died is started again: at first, and at most; doubled from time to time."""

STEADY: Final = 30.0
"""Seconds that a process must have lived for the pause to be short again."""

STOP_TIMEOUT: Final = 5.0


async def start(module: str, descriptors: Sequence[int]) -> asyncio.subprocess.Process:
    """Run a module, which inherits these files; it must end with its standard input, which ends with this process."""
    return await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        module,
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        pass_fds=descriptors,
        process_group=0,  # no Ctrl-C; a session of its own would have a share of its own, however nice it is
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )


def give_way(niceness: int) -> None:
    """In such a process: be nicer than who started it, and leave the first processor alone, if there is another.

    Niceness says who gets how much, not who waits: one that wakes may wait 4 ms until a nicer one is interrupted.
    """
    os.nice(niceness)
    processors = sorted(os.sched_getaffinity(0))
    os.sched_setaffinity(0, processors[1:] or processors)


async def stop(process: asyncio.subprocess.Process) -> None:
    """Have it end, if need be by force."""
    assert process.stdin is not None
    process.stdin.close()
    try:
        async with asyncio.timeout(STOP_TIMEOUT):
            await process.communicate()
    except TimeoutError:
        with suppress(ProcessLookupError):
            process.kill()
        await process.communicate()


async def keep(live: Callable[[], Awaitable[int]], say: Callable[[int, float], None]) -> None:
    """Let one process `live` after the other; `say` gets the status of each that ended, and the pause after it."""
    pause, longest = PAUSES
    loop = asyncio.get_running_loop()
    while True:
        born = loop.time()
        status = await live()
        pause = PAUSES[0] if loop.time() - born > STEADY else pause
        say(status, pause)
        await asyncio.sleep(pause)
        pause = min(longest, 2.0 * pause)
