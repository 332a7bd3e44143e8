"""The processes of the demo, and the tour against them."""

from __future__ import annotations

import asyncio
import re
import signal
import tempfile
from collections.abc import Callable, Coroutine
from contextlib import AsyncExitStack
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from jauspy.cli.children import Child, ChildFailed
from jauspy.cli.demo import plan
from jauspy.cli.demo.patience import within
from jauspy.cli.demo.report import Finding, Report
from jauspy.cli.demo.tour import Tour
from jauspy.cli.demo.view import View
from jauspy.errors import ConfigError, RequestError
from jauspy.modules import robots
from jauspy.ocu import OCU

if TYPE_CHECKING:
    from jauspy.services.environment_sensing.frame_sizes import FrameSize

LIMIT: Final = 240.0  # seconds; it takes about 40 on a machine that has nothing else to do
NEEDED: Final = {"mujoco": "MuJoCo", "av": "PyAV", "cv2": "OpenCV", "numpy": "NumPy", "matplotlib": "matplotlib"}
COUNTED: Final = 5.0  # seconds in which the robot's process must have told its counters


async def play(port: int, backend: str, view: View, folder: Path, size: FrameSize) -> Report:
    """Start node manager and robot, do the tour, stop them; raises what went wrong.

    Sockets are in a directory of their own and UDP stays on the loopback address, so that no other JAUS system on this
    machine or network is disturbed.
    """
    whole = backend == "sim"
    make: Callable[..., Tour] = _whole_tour(folder, size) if whole else Tour
    report, heard = Report(), Heard()
    async with AsyncExitStack() as stack:
        root = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="jauspy-")))
        stack.enter_context(view)
        view.step(f"Start a node manager on UDP 127.0.0.1:{port}")
        manager = await _node_manager(stack, port, root)
        view.step(f"Start the robot {plan.ROBOT} ({backend})")
        arguments = ["up", plan.ROBOT, "--no-node-manager", "--local-root", str(root), "--own-root"]
        robot = await stack.enter_async_context(Child("robot", [*arguments, "--backend", backend], heard=heard.line))
        ocu = await stack.enter_async_context(OCU(connect=f"udp://127.0.0.1:{port}"))
        view.ocu = ocu
        tour = make(ocu, robots.load(plan.ROBOT), view, report, folder)
        try:
            await _unless_ended(tour.run(), manager, robot)
        except RequestError as error:
            stage = view.scene.phases[-1][1] if view.scene.phases else "begin"
            report.findings.append(Finding(stage, str(error), reached=False))
        robot.signal(signal.SIGUSR1)
        report.findings += [_time(await heard.counters()), _messages(ocu)]
    if whole:
        report.files.append("summary.json")
        report.save(folder)
    return report


class Heard:
    """What the robot's process says."""

    def __init__(self) -> None:
        self._counted: dict[str, int] = {}

    def line(self, text: str) -> None:
        """One line of it."""
        if found := re.fullmatch(r"\s+(realtime\.\w+)\s+(\d+)", text):
            self._counted[found[1]] = int(found[2])

    async def counters(self) -> dict[str, int]:
        """How well it kept time, once it has told; counters that are zero are left out."""
        async with within(COUNTED, lambda: "the robot's process does not tell its counters"):
            while "realtime.steps" not in self._counted:  # noqa: ASYNC110 - lines come when they come
                await asyncio.sleep(0.05)
        return self._counted


def _whole_tour(folder: Path, size: FrameSize) -> Callable[..., Tour]:
    """What can be known to be missing is said, and what is slow to import is imported, before anything is started."""
    missing = [title for package, title in NEEDED.items() if find_spec(package) is None]
    if missing:
        raise ConfigError(
            f"the demo needs {', '.join(missing)}: pip install 'jauspy[all]'; --backend kinematic needs none of it, "
            "and only drives and moves the arm"
        )
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ConfigError(f"{folder}: cannot be made: {error.strerror}; name another folder with --output") from error
    from jauspy.cli.demo.whole import WholeTour

    return partial(WholeTour, size=size)


async def _node_manager(stack: AsyncExitStack, port: int, root: Path) -> Child:
    arguments = ["node-manager", "--address", "127.0.0.1", "--port", str(port), "--local-root", str(root)]
    arguments.append("--own-root")  # should this process be killed, the last of its children removes the folder
    try:
        return await stack.enter_async_context(Child("node manager", arguments))
    except ChildFailed as error:
        if "--port" in str(error):
            other = port + 1 if port < 65535 else 3794
            raise ConfigError(f"{error}, as in `jauspy demo --port {other}` or `make demo PORT={other}`") from None
        raise


async def _unless_ended(tour: Coroutine[Any, Any, None], *children: Child) -> None:
    """The tour; ends with an error when one of the processes does."""
    touring = asyncio.create_task(tour)
    watchers: list[asyncio.Task[ChildFailed]] = [asyncio.create_task(child.ended()) for child in children]
    try:
        await asyncio.wait((touring, *watchers), timeout=LIMIT, return_when=asyncio.FIRST_COMPLETED)
        for watcher in watchers:
            if watcher.done():
                raise watcher.result()
        if not touring.done():
            raise RequestError(f"it did not end within {LIMIT:g} s; is this machine busy?")
        touring.result()
    finally:
        # The tour first, and waited for: it gives control back on its way out.
        for task in (touring, *watchers):
            task.cancel()
            await asyncio.wait({task})


def _time(counters: dict[str, int]) -> Finding:
    steps, skipped = counters["realtime.steps"], counters.get("realtime.skipped", 0)
    late = counters.get("realtime.late", 0)
    held = steps / (steps + skipped)
    text = f"{100 * held:.1f} % held: of {steps + skipped} steps {skipped or 'none'} left out, {late} late"
    return Finding("real time", text, None, {"held": held, "skipped": skipped, "late": late})


def _messages(ocu: OCU) -> Finding:
    stats = ocu.stats
    text = (
        f"{stats.sent} sent, {stats.received} received, {stats.timeouts} without answer; round trip "
        f"{1e3 * stats.rtt_median:.1f} ms (median), {1e3 * stats.rtt_max:.0f} ms (most)"
    )
    return Finding("messages", text, None, {"round_trip": stats.rtt_median, "timeouts": stats.timeouts})
