"""`jauspy console`: the operator's console in the browser."""

from __future__ import annotations

import asyncio
import webbrowser
from typing import Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OperatorKey, OwnId
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ocu import OCU

DEFAULT_PORT: Final = 8101


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
        raise ConfigError(f"the console needs the extra 'console': pip install 'jauspy[console]' ({error})") from error

    async def serve() -> None:
        ocu = client.make_ocu(own_id, connect, 0.5, operator=operator_key)
        async with ocu:
            stopper = OCU(client.own_id(None, connect), connect, operator=operator_key, name="jauspy console (stop)")
            async with stopper, serving(ocu, stopper, host, port) as url:
                console.print_lines(f"the console is at {url}", "stop it: Ctrl-C")
                if not no_browser:
                    webbrowser.open(url)
                await asyncio.Event().wait()

    run(serve())
