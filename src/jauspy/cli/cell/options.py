"""Options that the verbs of `jauspy cell` share."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.platform.modular import check_libraries

MODULES: Final = ("pinocchio", "coal", "ruckig", "numpy")
OUTPUT: Final = Path("cell_out")

Seed = Annotated[int, typer.Option("--seed", min=0, metavar="N", help="Random seed; equal seeds give equal runs.")]
Record = Annotated[
    Path | None, typer.Option("--record", metavar="FILE", help="Film the task, as .mp4. Needs the extra 'video'.")
]
View = Annotated[
    bool, typer.Option("--view", help="Show the task in MuJoCo's window, no faster than the clock; needs a display.")
]
Out = Annotated[
    Path, typer.Option("-o", "--output", "--out", metavar="DIR", help="Directory of plots, films and results.")
]
Jobs = Annotated[
    int | None, typer.Option("--jobs", "-j", min=1, metavar="N", help="Parallel processes. Default: one per core.")
]
Seeds = Annotated[int, typer.Option("--seeds", min=1, metavar="N", help="Runs, with the seeds 0 to N - 1.")]
Exact = Annotated[
    bool, typer.Option("--exact", help="Without errors of the parts' poses and without grasps that fail.")
]


def check_extra() -> None:
    """Raise `ConfigError` when a package of the extra `cell` cannot be imported."""
    check_libraries("`jauspy cell`", *MODULES)


def degrees(angle: float) -> str:
    """An angle for a table."""
    return f"{math.degrees(angle):.2f}"


def millimetres(distance: float) -> str:
    """A distance for a table."""
    return f"{1000.0 * distance:.2f}"
