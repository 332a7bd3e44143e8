"""The processes of the demo, and the drive against them."""

from __future__ import annotations

import asyncio
import importlib.util
import tempfile
from contextlib import AsyncExitStack, suppress
from pathlib import Path
from typing import Final

from jauspy.cli.children import Child, ChildFailed
from jauspy.cli.demo_view import View
from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.messages.core import QueryControl, QueryStatus, ReportControl, ReportStatus
from jauspy.ocu import OCU, demo as script

LIMIT: Final = 75.0  # seconds; the drive takes about 20
LOOK: Final = 0.5  # seconds between two looks at who is in control
ROBOT: Final = "inc1"


async def play(port: int, backend: str, view: View) -> script.Result:
    """Start node manager and robot, drive, stop them; raises what went wrong.

    Sockets are in a directory of their own and UDP stays on the loopback address, so that no other JAUS system on this
    machine or network is disturbed.
    """
    if backend == "sim" and importlib.util.find_spec("mujoco") is None:
        raise ConfigError("MuJoCo is not installed: pip install 'jauspy[sim]', or choose --backend kinematic")
    async with AsyncExitStack() as stack:
        root = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="jauspy-")))
        stack.enter_context(view)
        view.step(f"Start a node manager on UDP 127.0.0.1:{port}")
        manager = await _node_manager(stack, port, root)
        view.step(f"Start the robot {ROBOT} ({backend})")
        robot = await stack.enter_async_context(
            Child("robot", ["up", ROBOT, "--no-node-manager", "--local-root", str(root), "--backend", backend])
        )
        ocu = await stack.enter_async_context(OCU(connect=f"udp://127.0.0.1:{port}"))
        return await _drive(ocu, view, manager, robot)


async def _node_manager(stack: AsyncExitStack, port: int, root: Path) -> Child:
    arguments = ["node-manager", "--address", "127.0.0.1", "--port", str(port), "--local-root", str(root)]
    try:
        return await stack.enter_async_context(Child("node manager", arguments))
    except ChildFailed as error:
        if "--port" in str(error):
            other = port + 1 if port < 65535 else 3794
            raise ConfigError(f"{error}, as in `jauspy demo --port {other}` or `make demo PORT={other}`") from None
        raise


async def _drive(ocu: OCU, view: View, *children: Child) -> script.Result:
    """The scripted drive; ends with an error when one of the processes does."""
    view.stats = lambda: ocu.stats
    drive = asyncio.create_task(script.run(ocu, observer=view))
    watchers: list[asyncio.Task[ChildFailed]] = [asyncio.create_task(child.ended()) for child in children]
    looking = asyncio.create_task(_look(ocu, view))
    try:
        await asyncio.wait((drive, *watchers), timeout=LIMIT, return_when=asyncio.FIRST_COMPLETED)
        for watcher in watchers:
            if watcher.done():
                raise watcher.result()
        if not drive.done():
            raise RequestError(f"the drive did not end within {LIMIT:g} s; is this machine busy?")
        return drive.result()
    finally:
        # The drive first, and waited for: it gives control back on its way out.
        for task in (drive, looking, *watchers):
            task.cancel()
            await asyncio.wait({task})


async def _look(ocu: OCU, view: View) -> None:
    """Ask the driven component now and then who controls it and what its status is."""
    while True:
        await asyncio.sleep(LOOK)
        if view.driven is None:
            continue
        with suppress(ResponseTimeout):
            status = await ocu.query(view.driven, QueryStatus(), expects=ReportStatus)
            control = await ocu.query(view.driven, QueryControl(), expects=ReportControl)
            view.looked(status, control)
