"""`jauspy node-manager`: route JAUS between local components and the network."""

from __future__ import annotations

import asyncio
import json
import logging
import os
import signal
import socket
import time
from collections.abc import Callable, Iterable, Mapping
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Annotated, Any, Final, Self

import typer

from jauspy.cli import console
from jauspy.cli.options import DEFAULT_ROOT, OwnRoot, Peer, WithParent, file_mode
from jauspy.cli.processes import end_with_parent, remove_if_empty, run
from jauspy.errors import ConfigError
from jauspy.inspection.peers import find_kind
from jauspy.node import NodeConfig, NodeManager, status
from jauspy.node.config import load_config, to_toml
from jauspy.node.manager import raise_open_files_limit

SOCKET: Final = "NOTIFY_SOCKET"
WATCHDOG: Final = "WATCHDOG_USEC"
"""Variables of sd_notify(3)."""


class SystemdNotifier:
    """Notifies systemd of readiness and reloads, and feeds its watchdog (sd_notify(3)).

    In the block the service is ready, and the event loop feeds the watchdog, so that systemd detects a hang.

    Does nothing if the process was not started by systemd with notifications.
    """

    def __init__(self) -> None:
        self._address = os.environ.get(SOCKET, "").replace("@", "\0", 1)
        self._pause = int(os.environ.get(WATCHDOG) or 0) / 2e6
        self._timer: asyncio.TimerHandle | None = None

    async def __aenter__(self) -> Self:
        self._notify("READY=1")
        if self._address and self._pause:
            self._feed_watchdog()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._notify("STOPPING=1")

    def reloading(self) -> None:
        """Report the start of a reload; `ready` reports its end."""
        self._notify(f"RELOADING=1\nMONOTONIC_USEC={time.monotonic_ns() // 1000}")

    def ready(self, status: str) -> None:
        """Report the end of a reload; `systemctl status` shows `status`."""
        self._notify(f"READY=1\nSTATUS={status}")

    def _feed_watchdog(self) -> None:
        self._notify("WATCHDOG=1")
        self._timer = asyncio.get_running_loop().call_later(self._pause, self._feed_watchdog)

    def _notify(self, text: str) -> None:
        if not self._address:
            return
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_CLOEXEC) as sock:
            sock.setblocking(False)
            try:
                sock.sendto(text.encode(), self._address)
            except OSError:
                return


def node_manager(
    *,
    config: Annotated[
        Path | None,
        typer.Option(
            "--config", metavar="FILE", help="TOML file with all settings; SIGHUP reloads its rules and limits."
        ),
    ] = None,
    print_config: Annotated[
        bool, typer.Option("--print-config", help="Print all settings as a TOML file with comments, and exit.")
    ] = False,
    show_status: Annotated[
        bool, typer.Option("--status", help="Print the status of the node manager that runs in --local-root, and exit.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="With --status: as JSON.")] = False,
    port: Annotated[
        int | None,
        typer.Option("--port", min=1, max=65535, help="UDP port; 3794 is registered for JAUS.", show_default="3794"),
    ] = None,
    address: Annotated[
        str | None,
        typer.Option("--address", metavar="IP", help="Local address to receive on. Default: all addresses."),
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
    own_ids: Annotated[
        list[str] | None,
        typer.Option(
            "--own-ids",
            metavar="PATTERN",
            help="Ids of this machine, as in 101.1.*; never accepted from a network; may be repeated.",
        ),
    ] = None,
    metrics: Annotated[
        str | None, typer.Option("--metrics", metavar="IP:PORT", help="Serve metrics for Prometheus at this address.")
    ] = None,
    mirror: Annotated[
        str | None,
        typer.Option("--mirror", metavar="WHERE", help="Copy all routed packets to a pcapng FILE or udp:IP:PORT."),
    ] = None,
    log: Annotated[
        str | None, typer.Option("--log", metavar="text|json", help="Format of the log.", show_default="text")
    ] = None,
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="Log what is dropped and why.")] = False,
    socket_mode: Annotated[
        str | None,
        typer.Option(
            "--socket-mode",
            metavar="OCTAL",
            help="Permissions of the local socket, which decide who on this machine may attach a component.",
            show_default="660",
        ),
    ] = None,
    peer: Peer = None,
    with_parent: WithParent = False,
    own_root: OwnRoot = False,
) -> None:
    """Route JAUS between the components of this machine and the network.

    A drop-in replacement for the JAUS Toolset and FKIE node managers. Local components connect to JuniorRTE in the
    local root, other nodes to UDP port 3794 and by multicast. SIGUSR1 prints the counters; Ctrl-C and SIGTERM end the
    node manager. With --config, SIGHUP reloads rules and limits from the file. Options override the file.

    Example:
      jauspy node-manager --port 3795 --local-root /tmp/second
    """
    overrides: dict[str, Any] = {
        "port": port,
        "address": address,
        "local_root": local_root,
        "multicast_group": multicast_group,
        "multicast_interfaces": tuple(interface) if interface else None,
        "own_ids": tuple(own_ids) if own_ids else None,
        "metrics": metrics,
        "mirror": mirror,
        "local_mode": None if socket_mode is None else file_mode(socket_mode),
        "log": log,
        "log_level": "debug" if verbose else None,
    }
    if peer is not None and multicast_group is None:
        overrides["multicast_group"] = find_kind(peer).multicast_group
    if as_json and not show_status:
        raise typer.BadParameter("it requires --status", param_hint="--json")
    if show_status:
        return _status(local_root, config, as_json=as_json)
    settings = load_config(config, overrides)
    if print_config:
        console.print_lines(*to_toml(settings).splitlines())
        return None
    if with_parent:
        end_with_parent()

    run(serve(settings, None if config is None else lambda: load_config(config, overrides), quiet=with_parent))
    if own_root:
        remove_if_empty(settings.local_root)
    return None


def _status(root: Path | None, config: Path | None, *, as_json: bool) -> None:
    """Read the status twice, to compute rates, and print it."""
    if root is None:
        root = DEFAULT_ROOT if config is None else load_config(config).local_root

    async def read_twice() -> tuple[dict[str, Any], dict[str, Any]]:
        before = await status.read(root)
        await asyncio.sleep(status.RATE_INTERVAL)
        return before, await status.read(root)

    now = status.with_rates(*asyncio.run(read_twice()))
    if as_json:
        console.print_json(now)
    else:
        _show(now)


async def serve(config: NodeConfig, read: Callable[[], NodeConfig] | None, *, quiet: bool) -> None:
    """Run a node manager until cancelled; print a line when it is ready, and the counters at the end unless `quiet`.

    On SIGHUP the configuration that `read` returns replaces `config`.
    """
    console.log_to_stderr(config.log_level.upper(), JsonLines() if config.log == "json" else None)
    raise_open_files_limit()
    async with NodeManager(config) as manager, SystemdNotifier() as services:
        loop = asyncio.get_running_loop()
        loop.add_signal_handler(signal.SIGUSR1, console.print_counters, manager.counters)
        if read is not None:
            loop.add_signal_handler(signal.SIGHUP, reload, manager, read, services)
        where = ", ".join(f"{network.address}:{manager.port_of(network.name)}" for network in config.all_networks)
        ready = f"node manager ready: UDP {where}, local sockets in {config.local_root}"
        console.print_if_read(ready)
        try:
            await manager.run()
        finally:
            if not quiet:
                console.print_counters(manager.counters)


def reload(manager: NodeManager, read: Callable[[], NodeConfig], services: SystemdNotifier) -> None:
    """Apply the file's present configuration; an invalid one changes nothing."""
    services.reloading()
    try:
        restart = manager.reload(read())
    except ConfigError as error:
        console.error(f"the configuration was not changed: {error}")
        services.ready("the configuration file is invalid; the previous configuration is in use")
        return
    pending = f"; after a restart: {', '.join(restart)}" if restart else ""
    console.note(f"the configuration was reloaded{pending}")
    services.ready("running")


class JsonLines(logging.Formatter):
    """One JSON object per line: time, level, logger, message, and the traceback if there is one."""

    def format(self, record: logging.LogRecord) -> str:
        """Same as `logging.Formatter`."""
        entry = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        if record.exc_info:
            entry["traceback"] = self.formatException(record.exc_info)
        return json.dumps(entry)


def _show(status: Mapping[str, Any]) -> None:
    """Print a status as tables."""
    uptime = _duration(status["uptime"])
    console.print_lines(f"node manager, process {status['pid']}, up {uptime}, sockets in {status['local_root']}")
    _table("networks", map(_network, status["networks"]))
    _table(
        "components",
        ((component["id"], component["path"], f"{component['waiting']} waiting") for component in status["components"]),
    )
    _table("peers", map(_peer, status["peers"]))
    if refused := status.get("refused"):
        rows = (
            (refusal["message"], f"from {refusal['network']}", refusal["why"], str(refusal["count"]))
            for refusal in refused
        )
        _table("refused by the gateway", rows)
    if left_out := status.get("left_out"):
        rows = ((kind["message"], f"on {kind['link']}", kind["limit"], str(kind["count"])) for kind in left_out)
        _table("left out by the limits of links", rows)
    _table("queues", ((name, str(count)) for name, count in status["queues"].items()))
    counters = status["counters"]
    dropped = {name: count for name, count in counters.items() if name.startswith("dropped.")}
    _table("counted", _counts({name: n for name, n in counters.items() if name not in dropped}, status["rates"]))
    _table("dropped", _counts(dropped, status["rates"]))


def _network(network: Mapping[str, Any]) -> tuple[str, ...]:
    buffer = network["receive_buffer"]
    notes = [word for word in ("inside", "authenticated") if network[word]]
    kernel = f"{buffer['bytes']} of {buffer['limit']} bytes buffered, {buffer['dropped']} dropped by the kernel"
    addresses, groups = (
        " and ".join(network[key] for key in keys if network.get(key))
        for keys in (("address", "address6"), ("multicast_group", "multicast_group6"))
    )
    return network["name"], addresses, f"group {groups}", ", ".join([*notes, kernel])


def _peer(peer: Mapping[str, Any]) -> tuple[str, ...]:
    heard = "from the address book" if peer["heard"] is None else f"heard {_duration(peer['heard'])} ago"
    return peer["id"], peer["address"], peer["network"], heard


def _counts(counters: Mapping[str, int], rates: Mapping[str, float]) -> Iterable[tuple[str, ...]]:
    for name, count in counters.items():
        yield name.removeprefix("dropped."), str(count), f"{rates.get(name, 0.0):.0f}/s"


def _table(title: str, rows: Iterable[tuple[str, ...]]) -> None:
    cells = list(rows)
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    console.print_lines(f"{title}:" if cells else f"{title}: none")
    for row in cells:
        line = "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        console.print_lines(f"  {line.rstrip()}")


def _duration(seconds: float) -> str:
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {rest} s" if minutes else f"{seconds:.1f} s"
