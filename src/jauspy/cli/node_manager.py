"""`jauspy node-manager`: route JAUS between local components and the network."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from jauspy.cli.options import DEFAULT_ROOT, OwnRoot, WithParent


def node_manager(
    *,
    config: Annotated[
        Path | None,
        typer.Option("--config", metavar="FILE", help="TOML file with all settings; SIGHUP reads its rules again."),
    ] = None,
    print_config: Annotated[
        bool, typer.Option("--print-config", help="Print all settings as a TOML file with comments, and end.")
    ] = False,
    status: Annotated[
        bool, typer.Option("--status", help="Print what the running one at --local-root says of itself, and end.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="With --status: as JSON.")] = False,
    port: Annotated[
        int | None,
        typer.Option("--port", min=1, max=65535, help="UDP port; 3794 is registered for JAUS.", show_default="3794"),
    ] = None,
    address: Annotated[
        str | None,
        typer.Option("--address", metavar="IP", help="Local address to receive on. Default: all of this machine."),
    ] = None,
    local_root: Annotated[
        Path | None,
        typer.Option(
            "--local-root",
            metavar="DIR",
            help="Directory of the local sockets (JuniorRTE).",
            show_default=str(DEFAULT_ROOT),
        ),
    ] = None,
    multicast_group: Annotated[
        str | None,
        typer.Option(
            "--multicast-group", metavar="IP", help="Group that broadcasts are sent to.", show_default="239.255.0.1"
        ),
    ] = None,
    interface: Annotated[
        list[str] | None,
        typer.Option(
            "--interface",
            metavar="IP|NAME",
            help='Interface to join the group on, by address or name, or "all"; may be repeated.',
        ),
    ] = None,
    metrics: Annotated[
        str | None, typer.Option("--metrics", metavar="IP:PORT", help="Serve metrics for Prometheus there.")
    ] = None,
    mirror: Annotated[
        str | None,
        typer.Option("--mirror", metavar="WHERE", help="Copy all routed packets to a pcapng FILE or udp:IP:PORT."),
    ] = None,
    log: Annotated[
        str | None, typer.Option("--log", metavar="text|json", help="Form of the log.", show_default="text")
    ] = None,
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="Log what is dropped and why.")] = False,
    socket_mode: Annotated[
        str | None,
        typer.Option(
            "--socket-mode",
            metavar="OCTAL",
            help="Permissions of the local socket: who on this machine may attach a component.",
            show_default="660",
        ),
    ] = None,
    with_parent: WithParent = False,
    own_root: OwnRoot = False,
) -> None:
    """Route JAUS between the components of this machine and the network.

    It takes the place of the JAUS Toolset's and FKIE's node managers: local components find it at JuniorRTE in the
    local root, other nodes on UDP 3794 and by multicast. SIGUSR1 prints the counters, Ctrl-C or SIGTERM ends it.
    With --config, SIGHUP reads rules and limits of the file again. Options go before what the file says.

    Example:
      jauspy node-manager --port 3795 --local-root /tmp/second
    """
    from jauspy.cli.run import end_with_parent, remove_if_empty, run
    from jauspy.node import config_file

    overrides: dict[str, Any] = {
        "port": port,
        "address": address,
        "local_root": local_root,
        "multicast_group": multicast_group,
        "multicast_interfaces": tuple(interface) if interface else None,
        "metrics": metrics,
        "mirror": mirror,
        "local_mode": None if socket_mode is None else mode_of(socket_mode),
        "log": log,
        "log_level": "debug" if verbose else None,
    }
    if as_json and not status:
        raise typer.BadParameter("it goes with --status only", param_hint="--json")
    if status:
        return _status(local_root, config, as_json=as_json)
    settings = config_file.load(config, overrides)
    if print_config:
        print(config_file.to_toml(settings), end="")
        return None
    if with_parent:
        end_with_parent()
    from jauspy.cli.node_serve import serve

    run(serve(settings, None if config is None else lambda: config_file.load(config, overrides), quiet=with_parent))
    if own_root:
        remove_if_empty(settings.local_root)
    return None


def mode_of(text: str) -> int:
    """`0o660` of `660`."""
    if re.fullmatch("0?[0-7]{3}", text):
        return int(text, 8)
    raise typer.BadParameter(
        f"{text!r} is no file mode; write three octal digits, as in 660", param_hint="--socket-mode"
    )


def _status(root: Path | None, config: Path | None, *, as_json: bool) -> None:
    """Two looks, because rates need them."""
    import asyncio

    from jauspy.cli.node_status import show
    from jauspy.node import config_file, status

    if root is None:
        root = DEFAULT_ROOT if config is None else config_file.load(config).local_root

    async def look() -> tuple[dict[str, Any], dict[str, Any]]:
        before = await status.read(root)
        await asyncio.sleep(status.RATE_INTERVAL)
        return before, await status.read(root)

    now = status.with_rates(*asyncio.run(look()))
    if as_json:
        json.dump(now, sys.stdout)
        print()
    else:
        show(now)
