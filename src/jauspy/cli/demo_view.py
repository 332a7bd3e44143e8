"""What the demo shows: a live table on a terminal, plain lines elsewhere, and a summary."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable
from types import TracebackType
from typing import Final, Self

from rich.live import Live
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from jauspy.cli import console
from jauspy.ids import JausID
from jauspy.messages.core import ReportControl, ReportStatus
from jauspy.ocu import Stats, Subsystem, demo as script
from jauspy.ocu.steering import Motion

_RATE_OVER: Final = 20  # reports
_LINE_EVERY: Final = 1.0  # seconds between two plain lines about the motion


class View(script.Observer):
    """What is known about the drive at this moment."""

    def __init__(self) -> None:
        self.driven: JausID | None = None
        self.stats: Callable[[], Stats] = Stats
        self.phase = ""
        self.robot = ""
        self.motion: Motion | None = None
        self.left = ""
        self.status = ""
        self.holder = ""
        self._began = time.monotonic()
        self._arrivals: deque[float] = deque(maxlen=_RATE_OVER)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        return None

    @property
    def elapsed(self) -> float:
        """Seconds since the demo began."""
        return time.monotonic() - self._began

    @property
    def rate(self) -> float:
        """Pose reports per second; 0 while none come."""
        if len(self._arrivals) < 2 or time.monotonic() - self._arrivals[-1] > 1.0:
            return 0.0
        return (len(self._arrivals) - 1) / (self._arrivals[-1] - self._arrivals[0])

    def step(self, text: str) -> None:
        """The next thing is being done."""
        self.phase = text

    def discovered(self, robot: Subsystem) -> None:
        """Remember whom to watch."""
        component = next(robot.offering("mobility:PrimitiveDriver"), None)
        self.driven = component.id if component else None
        services = sum(len(each.services) for each in robot.components)
        nodes, components = len(robot.nodes), len(robot.components)
        self.robot = (
            f"subsystem {robot.id} {robot.name}: {nodes} node{'s' * (nodes != 1)}, "
            f"{components} component{'s' * (components != 1)}, {services} services"
        )

    def moved(self, motion: Motion, left: float, unit: str) -> None:
        """A report came in."""
        self._arrivals.append(time.monotonic())
        self.motion = motion
        self.left = f"{left:.2f} m" if unit == "m" else f"{math.degrees(left):.1f}°"

    def looked(self, status: ReportStatus, control: ReportControl) -> None:
        """Somebody asked who is in control."""
        self.status = getattr(status.status, "name", str(status.status))
        holder = JausID(control.subsystem_id, control.node_id, control.component_id)
        self.holder = f"{holder}, authority {control.authority_code}" if int(holder) else "nobody"


class PlainView(View):
    """One line per step, and one each second about the motion."""

    def __init__(self) -> None:
        super().__init__()
        self._next_line = 0.0

    def step(self, text: str) -> None:
        """Print it."""
        super().step(text)
        print(f"{self.elapsed:6.1f} s  {text}", flush=True)

    def discovered(self, robot: Subsystem) -> None:
        """Print it."""
        super().discovered(robot)
        print(f"{self.elapsed:6.1f} s    {self.robot}", flush=True)

    def moved(self, motion: Motion, left: float, unit: str) -> None:
        """Print it now and then."""
        super().moved(motion, left, unit)
        if self.elapsed >= self._next_line:
            self._next_line = self.elapsed + _LINE_EVERY
            print(f"{self.elapsed:6.1f} s    {pose_text(motion)}, {self.left} to go", flush=True)


class LiveView(View):
    """A table that is drawn again and again, by a thread of its own."""

    def __init__(self) -> None:
        super().__init__()
        self._live = Live(console=console.stdout(), get_renderable=self.table, refresh_per_second=8, transient=True)

    def __enter__(self) -> Self:
        self._live.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._live.stop()

    def step(self, text: str) -> None:
        """Leave what was done above the table."""
        super().step(text)
        self._live.console.print(Text.assemble((f"{self.elapsed:6.1f} s  ", "dim"), text))

    def table(self) -> Panel:
        """The figures of this moment."""
        motion, stats = self.motion or Motion(), self.stats()
        grid = Table.grid(padding=(0, 2))
        grid.add_column(style="dim", min_width=10)
        grid.add_column(min_width=44)
        rows: dict[str, str | Text] = {
            "phase": Text(self.phase, style="bold"),
            "robot": self.robot or "-",
            "pose": pose_text(motion),
            "velocity": f"{motion.speed:+.2f} m/s   {math.degrees(motion.yaw_rate):+.1f}°/s",
            "effort": f"linear {motion.linear_effort:+.0f} %   rotational {motion.rotational_effort:+.0f} %",
            "to go": self.left or "-",
            "control": self.holder or "-",
            "status": self.status or "-",
            "events": f"{self.rate:.1f} pose reports/s",
            "round trip": f"median {stats.rtt_median * 1e3:.2f} ms of {stats.answers} queries",
        }
        for name, value in rows.items():
            grid.add_row(name, value)
        return Panel(grid, title="jauspy demo", subtitle=f"{self.elapsed:.1f} s", expand=False, border_style="cyan")


def pose_text(motion: Motion) -> str:
    """Where the robot is, in JAUS axes: yaw grows to the right."""
    return f"x {motion.x:+.2f} m   y {motion.y:+.2f} m   yaw {math.degrees(motion.yaw):+.1f}°"


def summary(result: script.Result, backend: str) -> Panel:
    """How it went."""
    stats, end = result.stats, result.end
    grid = Table.grid(padding=(0, 2))
    grid.add_column(style="dim")
    grid.add_column()
    lost = f", {result.lost_reports} lost" if result.lost_reports else ", none lost"
    for name, value in {
        "robot": f"{result.robot.name}, subsystem {result.robot.id}, backend {backend}",
        "final pose": pose_text(end),
        "driven": f"{100 * result.distance_error:+.1f} cm off 2 m, {math.degrees(result.angle_error):+.1f}° off 90°",
        "messages": f"{stats.sent} sent, {stats.received} received, {stats.timeouts} without answer",
        "reports": f"{result.pose_reports} poses at {result.confirmed_rate:.3g} Hz{lost}",
        "round trip": f"{stats.rtt_min * 1e3:.2f} / {stats.rtt_median * 1e3:.2f} / {stats.rtt_max * 1e3:.2f} ms "
        f"(least / median / most of {stats.answers})",
        "duration": f"{result.duration:.1f} s",
    }.items():
        grid.add_row(name, value)
    return Panel(grid, title="it works", expand=False, border_style="green")
