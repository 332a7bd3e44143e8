"""`jauspy node-manager`: route JAUS between local components and the network."""

from __future__ import annotations

import signal
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.options import DEFAULT_PORT, DEFAULT_ROOT, LocalRoot, Port, WithParent

if TYPE_CHECKING:
    from jauspy.node import NodeConfig


def node_manager(
    *,
    port: Port = DEFAULT_PORT,
    address: Annotated[
        str, typer.Option("--address", metavar="IP", help="Local address to receive on; 0.0.0.0 is all.")
    ] = "0.0.0.0",  # noqa: S104  # what a node manager is for; README says how to narrow it
    local_root: LocalRoot = DEFAULT_ROOT,
    multicast_group: Annotated[
        str, typer.Option("--multicast-group", metavar="IP", help="Group that broadcasts are sent to.")
    ] = "239.255.0.1",
    interface: Annotated[
        list[str] | None,
        typer.Option(
            "--interface", metavar="IP", help="Address of an interface to join the group on; may be repeated."
        ),
    ] = None,
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="Log what is dropped and why.")] = False,
    with_parent: WithParent = False,
) -> None:
    """Route JAUS between the components of this machine and the network.

    It takes the place of the JAUS Toolset's and FKIE's node managers: local components find it at JuniorRTE in the
    local root, other nodes on UDP 3794 and by multicast. SIGUSR1 prints the counters, Ctrl-C or SIGTERM ends it.

    Example:
      jauspy node-manager --port 3795 --local-root /tmp/second
    """
    from jauspy.cli.run import end_with_parent, run
    from jauspy.node import NodeConfig

    if verbose:
        _log_everything()
    if with_parent:
        end_with_parent()
    run(
        serve(
            NodeConfig.make(
                address=address,
                port=port,
                local_root=local_root,
                multicast_group=multicast_group,
                multicast_interfaces=tuple(interface or ()),
            ),
            quiet=with_parent,
        )
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


def print_counters(counters: Mapping[str, int]) -> None:
    """The counters that are not zero, one per line, on stderr."""
    counted = {name: count for name, count in sorted(counters.items()) if count}
    width = max(map(len, counted), default=0)
    lines = [f"  {name:<{width}}  {count}" for name, count in counted.items()] or ["  nothing was received or sent"]
    print("counters:", *lines, sep="\n", file=sys.stderr, flush=True)


def _log_everything() -> None:
    import logging

    logging.basicConfig(level=logging.DEBUG, format="%(asctime)s %(levelname)s %(name)s: %(message)s")
    logging.getLogger("asyncio").setLevel(logging.WARNING)
