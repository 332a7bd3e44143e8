"""A node manager for the robots of this machine: the one that runs, or a child that is kept running."""

from __future__ import annotations

import asyncio
import signal
import sys
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.cli.children import Child, ChildFailed
from jauspy.errors import ConfigError
from jauspy.protocol import junior
from jauspy.transport import local as local_socket

RESTART_DELAY: Final = 1.0  # seconds


@asynccontextmanager
async def node_manager(root: Path, port: int, options: Sequence[str] = ()) -> AsyncIterator[Keeper]:
    """Make sure that one runs in this local root, and goes on running.

    When it dies, whoever started it, one is started here; components find it by themselves. `options` are more of
    `jauspy node-manager`.
    """
    keeper = Keeper(root, port, options)
    if not keeper.is_there():
        await keeper.start()
    keeping = asyncio.create_task(keeper.keep())
    try:
        yield keeper
    finally:
        keeping.cancel()
        await asyncio.gather(keeping, return_exceptions=True)
        await keeper.stop()


class Keeper:
    """Watches the node manager of a local root, and starts one when there is none."""

    def __init__(self, root: Path, port: int, options: Sequence[str] = ()) -> None:
        self.where = f"was running, local sockets in {root}"
        """For people."""
        self._root = root
        self._port = port
        self._options = tuple(options)
        self._socket = root / junior.SOCKET_NAME
        self._child: Child | None = None

    @property
    def is_own(self) -> bool:
        """True when one was started here, and is ended here."""
        return self._child is not None

    def print_counters(self) -> None:
        """Have one that was started here print its counters; another's has a terminal of its own."""
        if self._child is not None:
            self._child.signal(signal.SIGUSR1)

    def is_there(self) -> bool:
        """True while one runs, whoever started it."""
        return local_socket.is_alive(self._socket)

    async def start(self) -> None:
        """Raises `ChildFailed` when it does not start."""
        arguments = ["node-manager", "--port", str(self._port), "--local-root", str(self._root), *self._options]
        child = Child("node manager", arguments, heard=_forward)
        await child.__aenter__()
        self._child = child
        self.where = f"UDP port {self._port}, local sockets in {self._root}"

    async def stop(self) -> None:
        """End the one that was started here."""
        if self._child is not None:
            await self._child.stop()

    async def keep(self) -> None:
        """Until cancelled."""
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


def gateway_port(path: Path, subsystem: int, root: Path, *, starts: bool) -> int:
    """The port in the configuration file of a gateway; `ConfigError` unless it can be put before this robot."""
    from jauspy.node import config_file

    config = config_file.load(path)
    if config.gateway is None:
        raise ConfigError(f"{path}: has no [gateway]; `jauspy node-manager --print-config` shows how one looks")
    if config.gateway.subsystem != subsystem:
        raise ConfigError(f"{path}: gateway.subsystem = {config.gateway.subsystem}: the robot is subsystem {subsystem}")
    if not starts:
        raise ConfigError("--gateway needs a node manager of its own; leave out --no-node-manager")
    if local_socket.is_alive(root / junior.SOCKET_NAME):
        raise ConfigError(f"--gateway: a node manager runs in {root} already; stop it, or choose another --local-root")
    return config.port


def _forward(line: str) -> None:
    print(f"node manager: {line}", file=sys.stderr, flush=True)
