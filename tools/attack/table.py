"""The table of results, as text and in docs/security.md between two markers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from .attack import Result
from .truth import Motion

BEGIN: Final = "<!-- begin: written by `make attack` -->"
END: Final = "<!-- end: written by `make attack` -->"
_HEAD: Final = (
    ("attack", "attacker", "sent", "honest, lost", "silence", "moved", "control kept", "memory", "leaked"),
    ("---",) * 9,
)


@dataclass(frozen=True, slots=True)
class Run:
    """The circumstances of all results."""

    seconds: float
    seed: int
    network: str
    version: str
    machine: str
    """Its processors, and what else they had to do: a node manager that does not get a processor loses messages."""


def rows(results: Sequence[Result]) -> list[tuple[str, ...]]:
    """A row for each result."""
    return [_row(each) for each in results]


def _row(result: Result) -> tuple[str, ...]:
    attack = result.attack
    if result.skipped:
        return attack.name, attack.attacker.value, f"not run: {result.skipped}", *("",) * 6
    heard = f"{result.silence:.2f} s" if result.silence else ""
    leaked = f"{result.descriptors} descriptors, {result.tasks} tasks, {result.lines} lines"
    return (
        attack.name,
        attack.attacker.value,
        f"{result.sent:,} {attack.unit}",
        f"{result.asked:,}, {result.lost:,}" if result.asked else "",
        heard,
        _moved(result.motion),
        f"{result.motion.controlled / result.motion.samples:.0%}" if result.motion.samples else "",
        f"{result.memory:.1f} MiB",
        leaked,
    )


def _moved(motion: Motion) -> str:
    """How far the robot moved without a command, and how many of the operator's drives it carried out."""
    return f"{motion.moved:.2f} m; {motion.driven} of {motion.legs} drives" if motion.samples else ""


def as_text(results: Sequence[Result]) -> str:
    """The table for a terminal."""
    cells = [_HEAD[0], *rows(results)]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return "\n".join("  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in cells)


def as_markdown(results: Sequence[Result], run: Run) -> str:
    """The table for the documentation, with the circumstances of the run."""
    day = datetime.now(UTC).date()
    reported = f"jauspy {run.version}, {day}, {run.seconds:g} s in all, seed {run.seed}, {run.network}, {run.machine}:"
    lines = [reported, "", *("| " + " | ".join(row) + " |" for row in (*_HEAD, *rows(results)))]
    return "\n".join(lines)


def write(path: Path, text: str) -> None:
    """Replace what is between the markers; raises `ValueError` when they are not there."""
    content = path.read_text(encoding="utf-8")
    before, begin, rest = content.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"{path} does not have the lines {BEGIN!r} and {END!r}")
    path.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{after}", encoding="utf-8")
