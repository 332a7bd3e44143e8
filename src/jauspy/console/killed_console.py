"""A process that puts the robots of a console in Standby and releases them, as soon as the console is killed.

A browser that is lost is the matter of `operation.py` (driving) and `motion.py` (arms).

A console that is stopped in order releases its robots itself. One that is killed (SIGKILL, a crash, no memory) cannot,
and its robots would continue until their `command_timeout`, since JAUS commands have no duration and clients cannot
change that time. The process waits for the end of its standard input, and then acts with the id of the console, which
controls the robots.
"""

from __future__ import annotations

import asyncio
import json
import signal
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from types import TracebackType
from typing import Self

from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.core import ReleaseControl, Standby
from jauspy.ocu import OCU

_LOG = get_logger("jauspy.console")


class Watchdog:
    """The process, while the context is open; `id`, `connect` and `operator` are those of the console's OCU."""

    def __init__(self, id: JausID | str, connect: str | None, operator: Path | None = None) -> None:
        self._arguments = (str(id), connect or "", str(operator or ""))
        self._held: dict[int, list[str]] = {}
        self._process: asyncio.subprocess.Process | None = None

    async def __aenter__(self) -> Self:
        self._process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-P",  # nothing from the current directory, which may be a stranger's
            "-m",
            "jauspy.console.killed_console",
            *self._arguments,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C in the terminal is for the console
        )
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        assert self._process is not None
        assert self._process.stdin is not None
        self._process.stdin.close()
        await self._process.wait()

    def hold(self, robot: int, components: Iterable[JausID]) -> None:
        """Set the components of a robot that are controlled now; empty after its release."""
        self._held[robot] = [str(component) for component in components]
        process = self._process
        if process is None or process.stdin is None:
            return
        if process.returncode is not None:
            _LOG.warning("the console's watchdog has ended: robots would not be stopped if the console were killed")
            return
        held = [component for components in self._held.values() for component in components]
        process.stdin.write(json.dumps(held).encode() + b"\n")


async def release(id: str, connect: str | None, operator: str | None, components: Sequence[str]) -> None:
    """Put components that a client with this id controls in Standby, and release them."""

    async def one(ocu: OCU, component: str) -> None:
        for message in (Standby(), ReleaseControl()):
            try:
                await ocu.send(component, message, ack=True)
            except JausError as error:
                _LOG.warning("%s was not released when the console was killed: %s", component, error)

    async with OCU(id, connect, operator=operator) as ocu:
        await asyncio.gather(*(one(ocu, component) for component in components))


def main(id: str, connect: str, operator: str) -> None:
    """Read standard input until it ends, then release the components in its last line.

    It is empty after an orderly end.
    """
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    held: list[str] = []
    for line in sys.stdin:
        held = json.loads(line)
    if held:
        asyncio.run(release(id, connect or None, operator or None, held))


if __name__ == "__main__":
    main(*sys.argv[1:])
