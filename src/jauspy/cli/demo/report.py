"""What the demo has reached, in figures."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Final

from rich.panel import Panel
from rich.table import Table
from rich.text import Text

MARKS: Final[Mapping[bool | None, tuple[str, str]]] = {
    True: ("✓", "green"),
    False: ("✗", "bold red"),
    None: ("·", "dim"),
}


@dataclass(frozen=True, slots=True)
class Finding:
    """What was measured, in words and as `figures` in SI units, and whether that was the goal; None without one."""

    stage: str
    measured: str
    reached: bool | None
    figures: Mapping[str, float] = field(default_factory=dict)


@dataclass(slots=True)
class Report:
    """All of them, in the order in which they were made."""

    findings: list[Finding] = field(default_factory=list)
    files: list[str] = field(default_factory=list)

    @property
    def reached(self) -> bool:
        """Every goal was."""
        return all(each.reached is not False for each in self.findings)

    def save(self, folder: Path) -> None:
        """As `summary.json`, for programs."""
        found = [asdict(each) for each in self.findings]
        text = json.dumps({"reached": self.reached, "findings": found}, indent=2)
        (folder / "summary.json").write_text(text + "\n", encoding="utf-8")

    def panel(self, folder: str) -> Panel:
        """For people."""
        grid = Table.grid(padding=(0, 2))
        grid.add_column(width=1)
        grid.add_column(style="bold", no_wrap=True)
        grid.add_column()
        for each in self.findings:
            mark, style = MARKS[each.reached]
            grid.add_row(Text(mark, style=style), each.stage, each.measured)
        if self.files:
            grid.add_row("", Text("files", style="dim"), Text(f"{folder}/: {', '.join(self.files)}", style="dim"))
        title = "it works" if self.reached else "not everything was reached"
        return Panel(grid, title=title, expand=False, border_style="green" if self.reached else "red")
