"""Results of the demo's stages, its state for display and plot, and the display itself."""

from __future__ import annotations

import asyncio
import json
import math
import time
from collections import deque
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import asynccontextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Final, Self

from rich.console import Console
from rich.live import Live
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from jauspy.errors import RequestError
from jauspy.messages.mobility import ReportLocalPose
from jauspy.ocu import OCU, SubsystemInfo

if TYPE_CHECKING:
    from jauspy.demo.full_tour import VideoRecording

MARKS: Final[Mapping[bool | None, tuple[str, str]]] = {
    True: ("✓", "green"),
    False: ("✗", "bold red"),
    None: ("·", "dim"),
}
REDUCED: Final = ("~", "yellow")
"""The mark of a goal that was reached in a reduced form."""


@dataclass(frozen=True, slots=True)
class StageResult:
    """Result of a stage, as text and as `figures` in SI units; `reached` is None for stages without a goal."""

    stage: str
    measured: str
    reached: bool | None
    figures: Mapping[str, float] = field(default_factory=dict)
    reduced: bool = False
    """True if the goal was reached in a reduced form only, since the machine is too slow; `measured` says how."""

    @property
    def mark(self) -> tuple[str, str]:
        """A character and its style."""
        return REDUCED if self.reduced else MARKS[self.reached]


@dataclass(slots=True)
class Report:
    """The results of all stages, in order, and the files written."""

    results: list[StageResult] = field(default_factory=list)
    files: list[str] = field(default_factory=list)

    @property
    def reached(self) -> bool:
        """True if every goal was reached."""
        return all(stage.reached is not False for stage in self.results)

    @property
    def verdict(self) -> str:
        """The sentence about all goals."""
        if not self.reached:
            return "not all goals were reached"
        if count := sum(stage.reduced for stage in self.results):
            return f"the goals were reached, {count} reduced: this machine is too slow"
        return "all goals were reached"

    def save(self, folder: Path) -> None:
        """Write `summary.json`."""
        stages = [asdict(stage) for stage in self.results]
        text = json.dumps({"reached": self.reached, "results": stages}, indent=2)
        (folder / "summary.json").write_text(text + "\n", encoding="utf-8")

    def panel(self, folder: str) -> Panel:
        """The summary as a table."""
        grid = Table.grid(padding=(0, 2))
        grid.add_column(width=1)
        grid.add_column(style="bold", no_wrap=True)
        grid.add_column()
        for stage in self.results:
            mark, style = stage.mark
            grid.add_row(Text(mark, style=style), stage.stage, stage.measured)
        if self.files:
            grid.add_row("", Text("files", style="dim"), Text(f"{folder}/: {', '.join(self.files)}", style="dim"))
        colour = "yellow" if any(stage.reduced for stage in self.results) else "green"
        return Panel(grid, title=self.verdict, expand=False, border_style=colour if self.reached else "red")


MAX_SAMPLES: Final = 6000
"""Joint positions kept for the plot."""
REFRESH_RATE: Final = 8
"""Hz of the live table."""


@dataclass(slots=True)
class DemoState:
    """The robot's state in metres, radians and kilograms, in the local frame with axes of REP-103."""

    began: float = field(default_factory=time.monotonic)
    pose: tuple[float, float, float] | None = None
    speed: float = 0.0
    joints: Sequence[float] = ()
    width: float | None = None
    """Metres between the fingers."""
    recordings: dict[str, VideoRecording] = field(default_factory=dict)
    scans: int = 0
    controlled: bool = False
    positions: deque[tuple[float, Sequence[float]]] = field(default_factory=lambda: deque(maxlen=MAX_SAMPLES))
    commands: deque[tuple[float, Sequence[float]]] = field(default_factory=lambda: deque(maxlen=MAX_SAMPLES))
    phases: list[tuple[float, str]] = field(default_factory=list)

    @property
    def elapsed(self) -> float:
        """Seconds since the demo began."""
        return time.monotonic() - self.began

    def read(self, report: ReportLocalPose, rate: float) -> tuple[float, float, float]:
        """Take the pose of a report, of which `rate` come in a second, and the speed since the last one."""
        before = self.pose
        self.pose = now = (report.x or 0.0, -(report.y or 0.0), -(report.yaw or 0.0))
        self.speed = 0.0 if before is None else rate * math.dist(now[:2], before[:2])
        return now

    def moved(self, positions: Sequence[float]) -> None:
        """Record measured joint positions, rad."""
        self.joints = positions
        self.positions.append((self.elapsed, positions))

    def commanded(self, positions: Sequence[float]) -> None:
        """Record commanded joint positions, rad."""
        self.commands.append((self.elapsed, positions))


class View:
    """Prints a line for each step and result with `print_line`; nothing without it."""

    def __init__(self, print_line: Callable[[str], None] | None = None) -> None:
        self._print_line = print_line
        self.state = DemoState()
        self.ocu: OCU | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        return None

    def end_message(self) -> str:
        """The message when the demo is interrupted."""
        return "stopped; control was released" if self.state.controlled else "stopped"

    def step(self, text: str) -> None:
        """Show the step that begins."""
        self._line(Text(text, style="bold"))

    def discovered(self, robot: SubsystemInfo) -> None:
        """Show the discovered robot."""
        services = sum(len(component.services) for component in robot.components)
        line = f"subsystem {robot.id} {robot.name}: {len(robot.components)} components with {services} services"
        self._line(Text(f"  {line}"))

    def add(self, result: StageResult) -> None:
        """Show a result."""
        mark, style = result.mark
        self._line(Text.assemble("  ", (mark, style), f" {result.stage}: {result.measured}"))

    def _line(self, text: Text) -> None:
        if self._print_line is not None:
            self._print_line(f"{self.state.elapsed:6.1f} s  {text.plain}")


class LiveView(View):
    """Shows a live table below the lines on a terminal, drawn by a thread."""

    def __init__(self, terminal: Console) -> None:
        super().__init__()
        self._phase = ""
        self._live = Live(console=terminal, get_renderable=self.table, refresh_per_second=REFRESH_RATE, transient=True)

    def __enter__(self) -> Self:
        self._live.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._live.stop()

    def step(self, text: str) -> None:
        """Show the step, also in the table."""
        self._phase = text
        super().step(text)

    def table(self) -> Panel:
        """The present state as a table."""
        grid = Table.grid(padding=(0, 2))
        grid.add_column(style="dim", min_width=8)
        grid.add_column(min_width=60)
        for name, value in self._figures().items():
            grid.add_row(name, value)
        return Panel(
            grid, title="jauspy demo", subtitle=f"{self.state.elapsed:.1f} s", expand=False, border_style="cyan"
        )

    def _figures(self) -> dict[str, str | Text]:
        state = self.state
        rows: dict[str, str | Text] = {"now": Text(self._phase, style="bold")}
        if state.pose is not None:
            x, y, yaw = state.pose
            rows["robot"] = f"x {x:+.2f} m  y {y:+.2f} m  heading {math.degrees(yaw):+.1f}°  {state.speed:.2f} m/s"
        if state.joints:
            rows["arm"] = "  ".join(f"{math.degrees(joint):+7.1f}°" for joint in state.joints)
        if state.width is not None:
            rows["fingers"] = f"{100.0 * state.width:.2f} cm apart"
        for name, recording in state.recordings.items():
            rows[f"{name} video"] = (
                f"{recording.recorder.pictures} pictures, {recording.camera.counters.get('lost', 0)} packets lost"
            )
        if state.scans:
            rows["map"] = f"{state.scans} scans"
        if self.ocu is not None:
            stats = self.ocu.stats
            rows["messages"] = (
                f"{stats.sent} sent, {stats.received} received, round trip {1e3 * stats.rtt_median:.1f} ms"
            )
        return rows

    def _line(self, text: Text) -> None:
        self._live.console.print(Text.assemble((f"{self.state.elapsed:6.1f} s  ", "dim"), text))


@asynccontextmanager
async def time_limit(seconds: float, why: Callable[[], str]) -> AsyncIterator[None]:
    """Raise `RequestError` with the text of `why` if the block does not end in time."""
    try:
        async with asyncio.timeout(seconds) as limit:
            yield
    except TimeoutError:
        if not limit.expired():
            raise
        raise RequestError(why()) from None
