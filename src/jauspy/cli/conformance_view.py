"""What `jauspy conformance` prints."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from jauspy.cli import console
from jauspy.conformance.profile import Step, find, known
from jauspy.conformance.reports import summary, transcript
from jauspy.conformance.results import Report, Result, Verdict, transitions_summary
from jauspy.errors import ConfigError

if TYPE_CHECKING:
    from rich.table import Table

    from jauspy.conformance.runner import OnResult

_STYLES: Final = {Verdict.PASS: "green", Verdict.SKIPPED: "dim"}
_PIPE: Final = 1000
"""Columns of what is no terminal: a line for each step, however long, for grep."""

_MOST_LINES: Final = 24
"""Lines of traffic shown of a step that failed; the files have all of it."""


def show(report: Report) -> None:
    """The steps as a table, what went wrong, and the sum."""
    from rich.text import Text

    out = console.stdout()
    if report.results:
        console.stdout(pipe_width=_PIPE).print(_table(report))
    for result in report.failures:
        _explain(result)
    for note in report.notes:
        console.note(note)
    if total := transitions_summary(report):
        rest = "; --json and --html name the others" if any(not each.step for each in report.transitions) else ""
        out.print(Text(f"{total}{rest}", style="dim"))
    style = "bold green" if report.status == 0 else "bold red"
    out.print(Text(f"{report.profile}, {report.target}: {summary(report)}", style=style))


def _table(report: Report) -> Table:
    from rich.table import Table
    from rich.text import Text

    counted = report.points[1] > 0
    table = Table(box=None, pad_edge=False, header_style="dim")
    for header in ("step", "verdict", "ms", *(["points"] if counted else []), "what"):
        table.add_column(header, overflow="fold", justify="right" if header == "ms" else "left")
    for each in report.results:
        reason = f"  {each.reason}" if each.verdict is Verdict.SKIPPED else ""
        table.add_row(
            each.id,
            Text(str(each.verdict), style=_STYLES.get(each.verdict, "red")),
            f"{each.elapsed * 1000:.0f}",
            *([f"{each.earned:g}/{each.points:g}" if each.points else ""] if counted else []),
            Text.assemble(each.title, (reason, "dim")),
        )
    return table


def _explain(result: Result) -> None:
    from rich.text import Text

    out = console.stdout()
    out.print(Text(f"\n{result.id} {result.title}: {result.verdict}", style="bold red"))
    out.print(Text(f"  {result.reason}"))
    for expected in result.expected:
        out.print(Text(f"  expected: {expected}"))
    if result.why:
        out.print(Text(f"  from: {result.why}"))
    lines = transcript(result)
    for line in lines[-_MOST_LINES:]:
        out.print(Text(f"  {line}", style="dim"))
    if len(lines) > _MOST_LINES:
        out.print(Text(f"  ({len(lines) - _MOST_LINES} lines before these; --html and --json have them)", style="dim"))


def show_list() -> None:
    """Every profile that is installed."""
    from rich.table import Table

    table = Table("profile", "steps", "points", "what", box=None, pad_edge=False, header_style="dim")
    for name in known():
        try:
            profile = find(name)
        except ConfigError as error:
            table.add_row(name, "", "", str(error))
            continue
        steps = () if callable(profile.steps) else profile.steps
        points = sum(step.points for step in steps)
        table.add_row(name, str(len(steps) or "as offered"), f"{points:g}" if points else "", profile.title)
    console.stdout().print(table)


def show_steps(steps: Iterable[Step]) -> None:
    """The steps of one profile."""
    for step in steps:
        console.stdout().print(f"{step.id}  {step.title}", markup=False)


@contextmanager
def watching() -> Iterator[OnResult]:
    """A line that says how far it is, on terminals."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    with console.stderr().status("listening ...") as status:
        yield lambda result: status.update(f"{result.id} {result.title}: {result.verdict}")
