"""A node manager as a process: its log, its signals, and what it tells the service manager."""

from __future__ import annotations

import asyncio
import json
import logging
import resource
import signal
import sys
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from typing import Final

from jauspy.cli import console
from jauspy.errors import ConfigError
from jauspy.node import NodeConfig, NodeManager
from jauspy.node.service_manager import ServiceManager

_LOGGER = logging.getLogger("jauspy.node")

FILES: Final = 4096
"""Files that the process may have open: a socket for each of 1024 components, connections, and what else there is."""


async def serve(config: NodeConfig, read: Callable[[], NodeConfig] | None, *, quiet: bool) -> None:
    """Run a node manager until cancelled; say so when it is ready, print the counters at the end unless `quiet`.

    `read` reads the configuration again, on SIGHUP.
    """
    start_log(config)
    allow_files()
    async with NodeManager(config) as manager, ServiceManager() as services:
        loop = asyncio.get_running_loop()
        loop.add_signal_handler(signal.SIGUSR1, print_counters, manager.counters)
        if read is not None:
            loop.add_signal_handler(signal.SIGHUP, reload, manager, read, services)
        where = ", ".join(f"{each.address}:{manager.port_of(each.name)}" for each in config.all_networks)
        print(f"node manager ready: UDP {where}, local sockets in {config.local_root}", flush=True)
        try:
            await manager.run()
        finally:
            if not quiet:
                print_counters(manager.counters)


def allow_files() -> None:
    """Many systems begin with 1024, and let each process have more if it asks."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    enough = FILES if hard == resource.RLIM_INFINITY else min(FILES, hard)
    if soft != resource.RLIM_INFINITY and soft < enough:
        resource.setrlimit(resource.RLIMIT_NOFILE, (enough, hard))


def reload(manager: NodeManager, read: Callable[[], NodeConfig], services: ServiceManager) -> None:
    """Take over what the file says now; a bad one changes nothing."""
    services.reloading()
    try:
        restart = manager.reload(read())
    except ConfigError as error:
        console.error(f"the configuration stays as it was: {error}")
        services.ready("the configuration file is wrong; the one before is in use")
        return
    told = f"; after a restart: {', '.join(restart)}" if restart else ""
    console.note(f"the configuration was read again{told}")
    services.ready("running")


def print_counters(counters: Mapping[str, int], title: str = "counters:") -> None:
    """The counters that are not zero, one per line, on stderr."""
    counted = {name: count for name, count in sorted(counters.items()) if count}
    width = max(map(len, counted), default=0)
    lines = [f"  {name:<{width}}  {count}" for name, count in counted.items()] or ["  nothing was received or sent"]
    print(title, *lines, sep="\n", file=sys.stderr, flush=True)


def start_log(config: NodeConfig) -> None:
    """Log to stderr in the form and from the level of the configuration."""
    _log_to_stderr(config.log_level.upper(), JsonLines() if config.log == "json" else _text())


def log_everything() -> None:
    """Every log line, on stderr."""
    _log_to_stderr("DEBUG", _text())


def _text() -> logging.Formatter:
    return logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s")


def _log_to_stderr(level: str, form: logging.Formatter) -> None:
    handler = logging.StreamHandler()
    handler.setFormatter(form)
    logging.basicConfig(level=level, handlers=[handler])
    logging.getLogger("asyncio").setLevel(logging.WARNING)


class JsonLines(logging.Formatter):
    """One JSON object per line: time, level, logger, message, and the traceback if there is one."""

    def format(self, record: logging.LogRecord) -> str:
        """As `logging.Formatter`."""
        told = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        if record.exc_info:
            told["traceback"] = self.formatException(record.exc_info)
        return json.dumps(told)
