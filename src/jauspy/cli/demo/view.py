"""What the demo shows while it runs: a live table on a terminal, plain lines elsewhere."""

from __future__ import annotations

import math
from types import TracebackType
from typing import Final, Self

from rich.live import Live
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from jauspy.cli import console
from jauspy.cli.demo.report import MARKS, Finding
from jauspy.cli.demo.watch import Scene
from jauspy.ocu import OCU, SubsystemInfo

REFRESH: Final = 8  # Hz


class View:
    """A `Watcher` that prints a line for each step and finding."""

    def __init__(self) -> None:
        self.scene = Scene()
        self.ocu: OCU | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        return None

    def farewell(self) -> str:
        """What there is to say when somebody stopped it."""
        return "stopped; control was given back" if self.scene.controlled else "stopped"

    def step(self, text: str) -> None:
        """The next thing is being done."""
        self._line(Text(text, style="bold"))

    def discovered(self, robot: SubsystemInfo) -> None:
        """Who it is."""
        services = sum(len(each.services) for each in robot.components)
        told = f"subsystem {robot.id} {robot.name}: {len(robot.components)} components with {services} services"
        self._line(Text(f"  {told}"))

    def found(self, finding: Finding) -> None:
        """With a mark."""
        mark, style = MARKS[finding.reached]
        self._line(Text.assemble("  ", (mark, style), f" {finding.stage}: {finding.measured}"))

    def _line(self, text: Text) -> None:
        print(f"{self.scene.elapsed:6.1f} s  {text.plain}", flush=True)


class LiveView(View):
    """A table under the lines, drawn again and again by a thread of its own."""

    def __init__(self) -> None:
        super().__init__()
        self._phase = ""
        self._live = Live(
            console=console.stdout(), get_renderable=self.table, refresh_per_second=REFRESH, transient=True
        )

    def __enter__(self) -> Self:
        self._live.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._live.stop()

    def step(self, text: str) -> None:
        """Also in the table."""
        self._phase = text
        super().step(text)

    def table(self) -> Panel:
        """The figures of this moment."""
        grid = Table.grid(padding=(0, 2))
        grid.add_column(style="dim", min_width=8)
        grid.add_column(min_width=60)
        for name, value in self._figures().items():
            grid.add_row(name, value)
        return Panel(
            grid, title="jauspy demo", subtitle=f"{self.scene.elapsed:.1f} s", expand=False, border_style="cyan"
        )

    def _figures(self) -> dict[str, str | Text]:
        scene = self.scene
        rows: dict[str, str | Text] = {"now": Text(self._phase, style="bold")}
        if scene.pose is not None:
            x, y, yaw = scene.pose
            rows["robot"] = f"x {x:+.2f} m  y {y:+.2f} m  heading {math.degrees(yaw):+.1f}°  {scene.speed:.2f} m/s"
        if scene.joints:
            rows["arm"] = "  ".join(f"{math.degrees(joint):+7.1f}°" for joint in scene.joints)
        if scene.finger is not None:
            rows["fingers"] = f"{200.0 * scene.finger:.2f} cm apart"
        for name, film in scene.films.items():
            rows[f"{name} video"] = (
                f"{film.recorder.pictures} pictures, {film.receiver.counters.get('lost', 0)} packets lost"
            )
        if scene.scans:
            rows["map"] = f"{scene.scans} scans"
        if self.ocu is not None:
            stats = self.ocu.stats
            rows["messages"] = (
                f"{stats.sent} sent, {stats.received} received, round trip {1e3 * stats.rtt_median:.1f} ms"
            )
        return rows

    def _line(self, text: Text) -> None:
        self._live.console.print(Text.assemble((f"{self.scene.elapsed:6.1f} s  ", "dim"), text))
