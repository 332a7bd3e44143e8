"""`jauspy demo`: the whole system on this machine; the verb, its processes, and the tour against them."""

from __future__ import annotations

import asyncio
import signal
import tempfile
from collections.abc import Callable, Coroutine
from contextlib import AsyncExitStack
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any, Final

import typer

from jauspy.cli import console
from jauspy.cli.options import DEFAULT_PORT, Port
from jauspy.cli.processes import ChildFailed, ChildProcess, run
from jauspy.demo import plan
from jauspy.demo.judge import RobotOutput
from jauspy.demo.report import LiveView, Report, StageResult, View
from jauspy.demo.tour import Tour
from jauspy.errors import ConfigError, RequestError
from jauspy.ocu import OCU
from jauspy.platform.video_settings import SUPPORTED_FRAME_SIZES
from jauspy.robot import robot_files

DEFAULT_WORLD: Final = "yard"


def demo(
    *,
    port: Port = DEFAULT_PORT,
    backend: Annotated[
        str,
        typer.Option(
            "--backend",
            metavar="NAME",
            help="sim: MuJoCo physics (extra 'all'). can: the same, moved by simulated servo "
            "drives. Other backends, such as kinematic, only drive and move the arm.",
        ),
    ] = "sim",
    world: Annotated[
        str, typer.Option("--world", metavar="NAME", help=f"{' or '.join(plan.PLANS)}: where, and what is grasped.")
    ] = DEFAULT_WORLD,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="Directory for videos, still, map, plot and summary.")
    ] = Path("demo_out"),
    size: Annotated[str, typer.Option("--size", metavar="WxH", help="Size of the videos.")] = "640x480",
    plain: Annotated[
        bool, typer.Option("--plain", "--headless", help="Print lines instead of a live table, as in a pipe.")
    ] = False,
) -> None:
    """Run the whole system: a simulated robot drives to a table, finds a can, grasps and lifts it.

    In the world street it drives over a kerb and lifts a pipe with wires from the pavement.

    The node manager and the robot run as child processes; this process is the operator control unit (OCU). It
    discovers the robot over UDP, takes control, records its cameras and one outside of it, maps with the lidar,
    drives by waypoints, finds what to grasp in a still, moves the arm and the gripper, and releases control. Videos,
    map and measurements are written to DIR, and a summary is printed. The exit status is 0 if every goal was reached, 1
    otherwise. On a machine that is too slow for the cameras, videos may be reduced. The demo takes about 40 s.

    Example:
      jauspy demo --port 3795 --output /tmp/demo
      jauspy demo --world street
    """
    pixels = _size(size)
    if world not in plan.PLANS:
        raise typer.BadParameter(f"{world!r} is not one of {', '.join(plan.PLANS)}", param_hint="--world")
    view = View(console.print_lines) if plain or not console.is_terminal() else LiveView(console.stdout())
    try:
        report = run(play(port, backend, view, output, size=pixels, world=world))
    except KeyboardInterrupt:
        console.note(view.end_message())
        raise typer.Exit(130) from None
    if report is None:  # SIGTERM or SIGHUP
        console.note(view.end_message())
        raise typer.Exit(1)
    console.stdout().print(report.panel(str(output)))
    console.stdout().print(f"operate it yourself, in the browser: jauspy up inc1 --world {world} --console")
    if not report.reached:
        raise typer.Exit(1)


def _size(text: str) -> tuple[int, int]:
    named = {f"{width}x{height}": (width, height) for width, height in SUPPORTED_FRAME_SIZES.values()}
    if text not in named:
        raise typer.BadParameter(f"{text!r} is not one of {', '.join(named)}", param_hint="--size")
    return named[text]


PHYSICS: Final[dict[str, tuple[str, ...]]] = {"sim": (), "can": ("--bus", "virtual:sim")}
"""Backends with a world in which the whole tour takes place, and their options of `jauspy up`."""

TOUR_TIMEOUT: Final = 240.0  # seconds; the tour takes about 40 on an idle machine
REQUIRED_PACKAGES: Final = {
    "mujoco": "MuJoCo",
    "av": "PyAV",
    "cv2": "OpenCV",
    "numpy": "NumPy",
    "matplotlib": "matplotlib",
}


async def play(port: int, backend: str, view: View, folder: Path, *, size: tuple[int, int], world: str) -> Report:
    """Start node manager and robot, run the tour, stop them.

    Local sockets are in a temporary directory and UDP uses the loopback address, so that other JAUS systems on this
    machine and network are not affected.
    """
    whole = backend in PHYSICS
    if not whole and world != DEFAULT_WORLD:
        raise ConfigError(f"--world {world} needs physics: leave out --backend {backend}, or the world")
    make: Callable[..., Tour] = _whole_tour(folder, size) if whole else Tour
    report, output, goals = Report(), RobotOutput(), plan.PLANS[world]
    async with AsyncExitStack() as stack:
        root = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="jauspy-")))
        stack.enter_context(view)
        view.step(f"Start a node manager on UDP 127.0.0.1:{port}")
        manager = await _node_manager(stack, port, root)
        view.step(f"Start the robot {plan.ROBOT} ({backend}) in the world {world}")
        arguments = ["up", plan.ROBOT, "--no-node-manager", "--local-root", str(root), "--own-root"]
        arguments += ["--backend", backend, *PHYSICS.get(backend, ())]
        if whole:
            arguments += ["--world", world]
        robot = await stack.enter_async_context(ChildProcess("robot", arguments, on_error_line=output.line))
        ocu = await stack.enter_async_context(OCU(connect=f"udp://127.0.0.1:{port}"))
        view.ocu = ocu
        tour = make(ocu, robot_files.load(plan.ROBOT), view, report, folder, goals=goals)
        try:
            await _unless_ended(tour.run(), manager, robot)
        except RequestError as error:
            stage = view.state.phases[-1][1] if view.state.phases else "begin"
            report.results.append(StageResult(stage, str(error), reached=False))
        robot.signal(signal.SIGUSR1)
        report.results += [_time(await output.counters()), _messages(ocu)]
        if any(result.stage == "drive" for result in report.results):
            report.results += output.results(goals)
    if whole:
        report.files.append("summary.json")
        report.save(folder)
    return report


def _whole_tour(folder: Path, size: tuple[int, int]) -> Callable[..., Tour]:
    """Check packages and the output directory, and import what is slow to import, before processes are started."""
    missing = [title for package, title in REQUIRED_PACKAGES.items() if find_spec(package) is None]
    if missing:
        raise ConfigError(
            f"the demo needs {', '.join(missing)}: pip install 'jauspy[all]'; --backend kinematic needs none of "
            "them, and only drives and moves the arm"
        )
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ConfigError(
            f"{folder}: cannot be created: {error.strerror}; choose another directory with --output"
        ) from error
    from jauspy.demo.full_tour import FullTour

    return partial(FullTour, size=size)


async def _node_manager(stack: AsyncExitStack, port: int, root: Path) -> ChildProcess:
    arguments = ["node-manager", "--address", "127.0.0.1", "--port", str(port), "--local-root", str(root)]
    arguments.append("--own-root")  # if this process is killed, its last child removes the directory
    try:
        return await stack.enter_async_context(ChildProcess("node manager", arguments))
    except ChildFailed as error:
        if "--port" in str(error):
            other = port + 1 if port < 65535 else 3794
            raise ConfigError(f"{error}, as in `jauspy demo --port {other}` or `make demo PORT={other}`") from None
        raise


async def _unless_ended(tour: Coroutine[Any, Any, None], *children: ChildProcess) -> None:
    """Run the tour; raises `ChildFailed` if one of the processes ends."""
    touring = asyncio.create_task(tour)
    watchers: list[asyncio.Task[ChildFailed]] = [asyncio.create_task(child.ended()) for child in children]
    try:
        await asyncio.wait((touring, *watchers), timeout=TOUR_TIMEOUT, return_when=asyncio.FIRST_COMPLETED)
        for watcher in watchers:
            if watcher.done():
                raise watcher.result()
        if not touring.done():
            raise RequestError(f"the tour did not end within {TOUR_TIMEOUT:g} s; the machine may be overloaded")
        touring.result()
    finally:
        # The tour first, because it releases control when it is cancelled.
        for task in (touring, *watchers):
            task.cancel()
            await asyncio.wait({task})


def _time(counters: dict[str, int]) -> StageResult:
    steps, skipped = counters["realtime.steps"], counters.get("realtime.skipped", 0)
    late = counters.get("realtime.late", 0)
    held = steps / (steps + skipped)
    text = f"{100 * held:.1f} % held: of {steps + skipped} steps {skipped or 'none'} skipped, {late} late"
    return StageResult("real time", text, None, {"held": held, "skipped": skipped, "late": late})


def _messages(ocu: OCU) -> StageResult:
    stats = ocu.stats
    text = (
        f"{stats.sent} sent, {stats.received} received, {stats.timeouts} timeouts; round trip "
        f"{1e3 * stats.rtt_median:.1f} ms (median), {1e3 * stats.rtt_max:.0f} ms (maximum)"
    )
    return StageResult("messages", text, None, {"round_trip": stats.rtt_median, "timeouts": stats.timeouts})
