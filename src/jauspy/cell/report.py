"""The report of results: plots as SVG files, and one HTML page with plots and films inside.

Plots need matplotlib, of the extra `plot`; the page opens without a network.
"""

from __future__ import annotations

import base64
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any, Final

from jauspy.cell.measurements import Measured
from jauspy.cell.trials import Summary
from jauspy.errors import ConfigError

GOOD, BAD, ACCENT = "#2f7d4f", "#b3423a", "#3b6ea5"


@contextmanager
def figure(path: Path, *, columns: int = 1, size: tuple[float, float] = (10.0, 4.0)) -> Iterator[Any]:
    """A figure with so many axes side by side, written to `path` at the end. Yields the axes as a list."""
    try:
        import_module("matplotlib").use("Agg")
        pyplot = import_module("matplotlib.pyplot")
    except ImportError:
        raise ConfigError("plots need matplotlib; run: pip install 'jauspy[plot]'") from None
    with pyplot.rc_context({"svg.hashsalt": "jauspy", "font.size": 10, "axes.grid": True, "grid.alpha": 0.3}):
        made, axes = pyplot.subplots(1, columns, figsize=size, layout="constrained", squeeze=False)
        try:
            yield list(axes[0])
            path.parent.mkdir(parents=True, exist_ok=True)
            made.savefig(path, dpi=110)
        finally:
            pyplot.close(made)


def plot_trials(results: Sequence[Measured], summary: Summary, path: Path) -> None:
    """The time of each run, with failures marked, and the distribution of the placement errors."""
    good = [run for run in results if run.success]
    bad = [run for run in results if not run.success]
    with figure(path, columns=2) as (times, errors):
        times.bar([run.seed for run in good], [run.duration for run in good], color=GOOD, label="success")
        times.bar([run.seed for run in bad], [run.duration for run in bad], color=BAD, label="failure")
        times.set_xlabel("seed")
        times.set_ylabel("time of the cell, s")
        times.set_title(f"{summary.task}: {summary.successes} of {summary.runs} succeeded")
        times.legend(loc="lower right")
        rows = [row for run in results for row in run.rows]
        found = [1000.0 * row["error"] for row in rows if "error" in row]
        if found:
            errors.hist(found, bins=30, color=ACCENT)
            errors.set_xlabel("placement error of a part, mm")
            errors.set_ylabel("parts")
        else:
            errors.hist([run.duration for run in good], bins=20, color=ACCENT)
            errors.set_xlabel("time of the cell, s")
            errors.set_ylabel("runs")


MAX_FILM: Final = 40_000_000
"""Bytes of a film that is put into the page; a larger one is only named."""

STYLE: Final = """
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 62rem; padding: 2rem 1rem; color: #1c2733; }
h1 { font-size: 1.9rem; margin-bottom: 0; } h2 { margin-top: 2.5rem; border-bottom: 1px solid #d5dce3; }
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; margin: 1rem 0; }
th, td { text-align: left; padding: 0.3rem 0.7rem; border-bottom: 1px solid #e4e9ee; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
.yes { color: #1f7a45; font-weight: 600; } .no { color: #b3322a; font-weight: 600; }
video, img { width: 100%; border-radius: 6px; background: #eef1f4; } p.lead { color: #52606d; margin-top: 0.2rem; }
"""


@dataclass(frozen=True, slots=True)
class Promise:
    """Something that is promised, what was measured of it, and whether that is enough."""

    what: str
    wanted: str
    measured: str
    kept: bool


@dataclass(slots=True)
class Section:
    """One part of the page."""

    title: str
    text: str = ""
    table: list[Sequence[str]] = field(default_factory=list)
    """Rows of cells; the first one is the heading."""
    plots: list[Path] = field(default_factory=list)
    """SVG or PNG files."""
    film: Path | None = None


def page(title: str, lead: str, promises: Sequence[Promise], sections: Sequence[Section]) -> str:
    """The HTML of the whole page."""
    rows: list[Sequence[str]] = [("what", "promised", "measured", "")]
    body = [f"<h1>{escape(title)}</h1>", f'<p class="lead">{escape(lead)}</p>']
    marks = [
        '<span class="yes">kept</span>' if promise.kept else '<span class="no">not kept</span>' for promise in promises
    ]
    body.append(_table(rows + [(promise.what, promise.wanted, promise.measured, "") for promise in promises], marks))
    for section in sections:
        body.append(f"<h2>{escape(section.title)}</h2>")
        if section.text:
            body.append(f"<p>{escape(section.text)}</p>")
        if section.film is not None and section.film.exists():
            body.append(_film(section.film))
        body += [_plot(path) for path in section.plots if path.exists()]
        if section.table:
            body.append(_table(section.table))
    return (
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title>'
        f'<meta name="viewport" content="width=device-width"><style>{STYLE}</style>'
        f"<body>{''.join(body)}</body></html>\n"
    )


def _table(rows: Sequence[Sequence[str]], marks: Sequence[str] = ()) -> str:
    head, *rest = rows
    lines = ["<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>"]
    for number, row in enumerate(rest):
        cells = [f"<td{_class(cell)}>{escape(cell)}</td>" for cell in row]
        if marks:
            cells[-1] = f"<td>{marks[number]}</td>"
        lines.append(f"<tr>{''.join(cells)}</tr>")
    return f"<table>{''.join(lines)}</table>"


def _class(cell: str) -> str:
    try:
        float(cell)
    except ValueError:
        return ""
    return ' class="number"'


def _film(path: Path) -> str:
    if path.stat().st_size > MAX_FILM:
        return f"<p>Film: {escape(path.name)}</p>"
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<video controls preload="metadata" src="data:video/mp4;base64,{data}"></video>'


def _plot(path: Path) -> str:
    kind = "image/svg+xml" if path.suffix == ".svg" else "image/png"
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img alt="{escape(path.stem)}" src="data:{kind};base64,{data}">'
