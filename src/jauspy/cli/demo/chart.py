"""The plot of the arm's joints: where they were, and where they were told to be."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Final

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from jauspy.cli.demo.watch import Scene

NAMES: Final = ("turn", "shoulder", "elbow", "wrist", "roll")
LEAST: Final = 2.5
"""Degrees, half of the least range of an axis: else noise looks like motion."""


def draw(scene: Scene, file: Path) -> None:
    """Write it as a PNG; degrees as the specification counts them."""
    times, positions = zip(*scene.positions, strict=True)
    at, commands = zip(*scene.commands, strict=True)
    began, end = at[0] - 1.0, times[-1]
    phases = [(moment, text) for moment, text in scene.phases if moment >= began]
    figure = Figure(figsize=(11, 9), layout="constrained")
    axes = figure.subplots(len(NAMES), 1, sharex=True)
    for joint, (axis, name) in enumerate(zip(axes, NAMES, strict=True)):
        told = [math.degrees(each[joint]) for each in commands]
        axis.step([*at, end], [*told, told[-1]], where="post", color="0.45", linestyle="--", linewidth=1.2)
        axis.plot(times, [math.degrees(each[joint]) for each in positions], color="C0", linewidth=1.6)
        axis.set_ylabel(f"{name}\ndegrees")
        axis.grid(alpha=0.3)
        low, high = axis.get_ylim()
        margin = max(0.1 * (high - low), LEAST - (high - low) / 2.0)
        axis.set_ylim(low - margin, high + margin)
        for moment, _ in phases:
            axis.axvline(moment, color="C1", alpha=0.4, linewidth=0.8)
    axes[0].legend(("command", "position"), loc="upper right", ncols=2)
    for moment, text in phases:
        axes[0].annotate(text, (moment, 1.0), (2, 3), xycoords=("data", "axes fraction"), textcoords="offset points",
                         rotation=45, fontsize=8, color="0.3")  # fmt: skip
    axes[-1].set_xlabel("seconds since the demo began")
    axes[-1].set_xlim(began, end)
    figure.suptitle("inc1's arm: joint positions against commands")
    FigureCanvasAgg(figure)
    figure.savefig(file)
