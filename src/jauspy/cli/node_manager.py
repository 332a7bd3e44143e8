"""`jauspy node-manager`: route JAUS between local components and the network."""

from __future__ import annotations

import re
import signal
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING

import typer

from jauspy.cli.options import (
    DEFAULT_ADDRESS,
    DEFAULT_GROUP,
    DEFAULT_MODE,
    DEFAULT_PORT,
    DEFAULT_ROOT,
    Address,
    Interface,
    LocalRoot,
    MulticastGroup,
    OwnRoot,
    Port,
    SocketMode,
    Verbose,
    WithParent,
)

if TYPE_CHECKING:
    from jauspy.node import NodeConfig


def node_manager(
    *,
    port: Port = DEFAULT_PORT,
    address: Address = DEFAULT_ADDRESS,
    local_root: LocalRoot = DEFAULT_ROOT,
    socket_mode: SocketMode = DEFAULT_MODE,
    multicast_group: MulticastGroup = DEFAULT_GROUP,
    interface: Interface = None,
    verbose: Verbose = False,
    with_parent: WithParent = False,
    own_root: OwnRoot = False,
) -> None:
    """Route JAUS between the components of this machine and the network.

    It takes the place of the JAUS Toolset's and FKIE's node managers: local components find it at JuniorRTE in the
    local root, other nodes on UDP 3794 and by multicast. SIGUSR1 prints the counters, Ctrl-C or SIGTERM ends it.

    Example:
      jauspy node-manager --port 3795 --local-root /tmp/second
    """
    from jauspy.cli.run import end_with_parent, remove_if_empty, run
    from jauspy.node import NodeConfig

    if verbose:
        log_everything()
    if with_parent:
        end_with_parent()
    run(
        serve(
            NodeConfig.make(
                address=address,
                port=port,
                local_root=local_root,
                local_mode=mode_of(socket_mode),
                multicast_group=multicast_group,
                multicast_interfaces=tuple(interface or ()),
            ),
            quiet=with_parent,
        )
    )
    if own_root:
        remove_if_empty(local_root)


def mode_of(text: str) -> int:
    """`0o660` of `660`."""
    if re.fullmatch("0?[0-7]{3}", text):
        return int(text, 8)
    raise typer.BadParameter(
        f"{text!r} is no file mode; write three octal digits, as in 660", param_hint="--socket-mode"
    )


async def serve(config: NodeConfig, *, quiet: bool) -> None:
    """Run a node manager until cancelled; say so when it is ready, print the counters at the end unless `quiet`."""
    import asyncio

    from jauspy.node import NodeManager

    async with NodeManager(config) as manager:
        asyncio.get_running_loop().add_signal_handler(signal.SIGUSR1, print_counters, manager.counters)
        print(
            f"node manager ready: UDP {config.address}:{manager.port}, local sockets in {config.local_root}", flush=True
        )
        try:
            await manager.run()
        finally:
            if not quiet:
                print_counters(manager.counters)


def print_counters(counters: Mapping[str, int], title: str = "counters:") -> None:
    """The counters that are not zero, one per line, on stderr."""
    counted = {name: count for name, count in sorted(counters.items()) if count}
    width = max(map(len, counted), default=0)
    lines = [f"  {name:<{width}}  {count}" for name, count in counted.items()] or ["  nothing was received or sent"]
    print(title, *lines, sep="\n", file=sys.stderr, flush=True)


def log_everything() -> None:
    """Every log line, on stderr."""
    import logging

    logging.basicConfig(level=logging.DEBUG, format="%(asctime)s %(levelname)s %(name)s: %(message)s")
    logging.getLogger("asyncio").setLevel(logging.WARNING)
