"""Plots of results, as SVG files. They need matplotlib, of the extra `plot`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

from jauspy.cell.measured import Measured
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
    good = [each for each in results if each.success]
    bad = [each for each in results if not each.success]
    with figure(path, columns=2) as (times, errors):
        times.bar([each.seed for each in good], [each.duration for each in good], color=GOOD, label="success")
        times.bar([each.seed for each in bad], [each.duration for each in bad], color=BAD, label="failure")
        times.set_xlabel("seed")
        times.set_ylabel("time of the cell, s")
        times.set_title(f"{summary.task}: {summary.successes} of {summary.runs} succeeded")
        times.legend(loc="lower right")
        rows = [row for each in results for row in each.rows]
        found = [1000.0 * row["error"] for row in rows if "error" in row]
        if found:
            errors.hist(found, bins=30, color=ACCENT)
            errors.set_xlabel("placement error of a part, mm")
            errors.set_ylabel("parts")
        else:
            errors.hist([each.duration for each in good], bins=20, color=ACCENT)
            errors.set_xlabel("time of the cell, s")
            errors.set_ylabel("runs")
