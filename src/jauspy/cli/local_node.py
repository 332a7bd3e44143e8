"""A node manager for the robots of this machine: the one that runs, or a child that is kept running."""

# ruff: noqa: PLC0415 - verbs import what they need when they run

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.cli.children import Child, ChildFailed
from jauspy.cli.options import DEFAULT_PORT
from jauspy.cli.probe import node_manager_at
from jauspy.errors import ConfigError

RESTART_DELAY: Final = 1.0  # seconds


@asynccontextmanager
async def node_manager(root: Path, port: int, config: Path | None = None) -> AsyncIterator[str]:
    """Make sure that one runs in this local root; yields where, for people.

    One that was started here is started again when it dies; components find it by themselves. With a `config` file
    its port is used, unless `port` is another than the usual one.
    """
    if node_manager_at(root):
        yield f"was running, local sockets in {root}"
        return
    child = _child(root, port, config)
    await child.__aenter__()
    keeper = asyncio.create_task(_keep(child, root, port, config))
    try:
        yield child.first_line.removeprefix("node manager ready: ") + (f", gateway by {config}" if config else "")
    finally:
        keeper.cancel()
        await asyncio.gather(keeper, return_exceptions=True)


async def _keep(child: Child, root: Path, port: int, config: Path | None) -> None:
    try:
        while True:
            console.note(f"{await child.ended()}; starting it again")
            await asyncio.sleep(RESTART_DELAY)
            while node_manager_at(root):  # noqa: ASYNC110 - somebody else was quicker, and no event says when it ends
                await asyncio.sleep(RESTART_DELAY)
            child = _child(root, port, config)
            try:
                await child.__aenter__()
            except ChildFailed as error:
                console.error(str(error))
    finally:
        await child.stop()


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
    if node_manager_at(root):
        raise ConfigError(f"--gateway: a node manager runs in {root} already; stop it, or choose another --local-root")


def _child(root: Path, port: int, config: Path | None) -> Child:
    arguments = ["node-manager", "--local-root", str(root)]
    if config is not None:
        arguments += ["--config", str(config)]
    if config is None or port != DEFAULT_PORT:
        arguments += ["--port", str(port)]
    return Child("node manager", arguments)
