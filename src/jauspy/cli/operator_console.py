"""`jauspy console`: the operator's console in the browser."""

from __future__ import annotations

import asyncio
import sys
import webbrowser
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OperatorKey, OwnId, WithParent
from jauspy.cli.processes import ChildFailed, ChildProcess, end_with_parent, run
from jauspy.errors import ConfigError
from jauspy.ocu import OCU

DEFAULT_PORT: Final = 8101
NEEDS_EXTRA: Final = "the console needs the extra 'console': pip install 'jauspy[console]'"
READY: Final = "the console is at"


def console_page(
    *,
    port: Annotated[
        int, typer.Option("--port", min=0, max=65535, help="The port of the page; 0 is any free one.")
    ] = DEFAULT_PORT,
    host: Annotated[str, typer.Option("--host", metavar="ADDRESS", help="Where it listens.")] = "127.0.0.1",
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Do not open a browser.")] = False,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    with_parent: WithParent = False,
) -> None:
    """Operate robots in the browser: cameras, driving, arm, emergency stop.

    It finds every robot that the node manager of this machine reaches, shows its cameras, drives it by keys, stick or
    gamepad, and moves its arm. A robot stops when the key is up, or the page is left. Escape stops all robots.

    Example:
      jauspy console
    """
    try:
        from jauspy.console.server import serving
    except ImportError as error:
        raise ConfigError(f"{NEEDS_EXTRA} ({error})") from error
    if with_parent:
        end_with_parent()

    async def serve() -> None:
        ocu = client.make_ocu(own_id, connect, 0.5, operator=operator_key)
        async with ocu:
            stopper = OCU(client.own_id(None, connect), connect, operator=operator_key, name="jauspy console (stop)")
            async with stopper, serving(ocu, stopper, host, port) as url:
                console.print_lines(f"{READY} {url}", "stop it: Ctrl-C")
                if not no_browser:
                    webbrowser.open(url)
                await asyncio.Event().wait()

    run(serve())


@asynccontextmanager
async def console_beside(root: Path, port: int) -> AsyncIterator[str]:
    """A console in a child process, for the node manager with these local sockets; its URL.

    It has a process of its own so that pages and video never delay the robot. When it ends by itself, this is told and
    the robot runs on.
    """
    if find_spec("nicegui") is None:
        raise ConfigError(NEEDS_EXTRA)
    arguments = ["console", "--no-browser", "--port", str(port), "--connect", f"local:{root}"]
    child = ChildProcess("console", arguments, on_error_line=_forward)
    try:
        await child.__aenter__()
    except ChildFailed as error:
        raise ConfigError(str(error).replace("--port", "--console-port")) from error
    watching = asyncio.create_task(_tell_end(child))
    try:
        yield child.first_line.removeprefix(READY).strip()
    finally:
        watching.cancel()
        await asyncio.wait({watching})
        await child.stop()


async def _tell_end(child: ChildProcess) -> None:
    console.error(f"{await child.ended()}; the robot runs on; start another one with: jauspy console")


def _forward(line: str) -> None:
    console.print_lines(f"console: {line}", file=sys.stderr)
