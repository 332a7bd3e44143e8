"""A node manager for the robots of this machine: the one that runs, or a child that is kept running."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.cli.children import Child, ChildFailed
from jauspy.cli.options import DEFAULT_PORT
from jauspy.errors import ConfigError
from jauspy.protocol import junior
from jauspy.transport import local_socket

RESTART_DELAY: Final = 1.0  # seconds


@asynccontextmanager
async def node_manager(root: Path, port: int, config: Path | None = None) -> AsyncIterator[str]:
    """Make sure that one runs in this local root, and goes on running; yields where, for people.

    When it dies, whoever started it, one is started here; components find it by themselves. With a `config` file
    its port is used, unless `port` is another than the usual one.
    """
    keeper = _Keeper(root, lambda: _child(root, port, config))
    if keeper.is_there():
        where = f"was running, local sockets in {root}"
    else:
        ready = await keeper.start()
        where = ready.removeprefix("node manager ready: ") + (f", gateway by {config}" if config else "")
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

    async def start(self) -> str:
        """Returns its first line; raises `ChildFailed` when it does not start."""
        child = self._make()
        await child.__aenter__()
        self._child = child
        return child.first_line

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


def check_gateway(path: Path, subsystem: int, root: Path, *, starts: bool) -> None:
    """Raise `ConfigError` unless a gateway with this configuration file can be put before a robot."""
    from jauspy.node import config_file

    gateway = config_file.load(path).gateway
    if gateway is None:
        raise ConfigError(f"{path}: has no [gateway]; `jauspy node-manager --print-config` shows how one looks")
    if gateway.subsystem != subsystem:
        raise ConfigError(f"{path}: gateway.subsystem = {gateway.subsystem}: the robot is subsystem {subsystem}")
    if not starts:
        raise ConfigError("--gateway needs a node manager of its own; leave out --no-node-manager")
    if local_socket.is_alive(root / junior.SOCKET_NAME):
        raise ConfigError(f"--gateway: a node manager runs in {root} already; stop it, or choose another --local-root")


def _child(root: Path, port: int, config: Path | None) -> Child:
    arguments = ["node-manager", "--local-root", str(root)]
    if config is not None:
        arguments += ["--config", str(config)]
    if config is None or port != DEFAULT_PORT:
        arguments += ["--port", str(port)]
    return Child("node manager", arguments)
