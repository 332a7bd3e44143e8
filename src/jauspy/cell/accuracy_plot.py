"""Picture of the accuracy and repeatability of both arms: where the tool came to rest around the commanded places."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import numpy as np

from jauspy.cell.iso9283 import Report
from jauspy.cell.report import figure

COLOURS: Final = ("#3b6ea5", "#b3423a", "#2f7d4f", "#8a5aa8", "#c58a1c")
"""One for each pose."""


def plot_accuracy(report: Report, path: Path) -> None:
    """Plot the attained places of the UR10 and of the calibrated arm, less the commanded ones, from above and aside."""
    views = ((0, 1, "x, mm", "y, mm"), (0, 2, "x, mm", "z, mm"))
    runs = (report.ur10[0], report.calibrated[0])
    with figure(path, columns=4, size=(14.0, 4.4)) as axes:
        for column, axis in enumerate(axes):
            run, (across, up, x_name, y_name) = runs[column // 2], views[column % 2]
            most = 1.2e3 * max(float(np.max(np.abs(rows))) for rows in run.deviations)
            for number, (rows, colour) in enumerate(zip(run.deviations, COLOURS, strict=True), 1):
                places = 1e3 * rows
                axis.scatter(places[:, across], places[:, up], s=10.0, color=colour, alpha=0.6, label=f"P{number}")
                mean = places.mean(axis=0)
                axis.plot(mean[across], mean[up], "+", color=colour, ms=11.0, mew=1.8)
            axis.axhline(0.0, color="0.75", lw=0.8, zorder=0)
            axis.axvline(0.0, color="0.75", lw=0.8, zorder=0)
            axis.set(xlim=(-most, most), ylim=(-most, most), xlabel=x_name, ylabel=y_name, aspect="equal")
            axis.set_title(run.name, fontsize=10)
        axes[0].legend(loc="best", fontsize=8)
