"""Figures that are written as SVG files. They need matplotlib, of the extra `plot`."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

from jauspy.errors import ConfigError

GOOD, BAD, ACCENT = "#2f7d4f", "#b3423a", "#3b6ea5"
_MISSING: Final = "plots need matplotlib; run: pip install 'jauspy[plot]'"


def check_plots() -> None:
    """Raise `ConfigError` without matplotlib, before work that ends in a plot."""
    if find_spec("matplotlib") is None:
        raise ConfigError(_MISSING)


@contextmanager
def figure(path: Path, *, columns: int = 1, size: tuple[float, float] = (10.0, 4.0)) -> Iterator[Any]:
    """A figure with so many axes side by side, written to `path` at the end. Yields the axes as a list."""
    try:
        import_module("matplotlib").use("Agg")
        pyplot = import_module("matplotlib.pyplot")
    except ImportError:
        raise ConfigError(_MISSING) from None
    with pyplot.rc_context({"svg.hashsalt": "jauspy", "font.size": 10, "axes.grid": True, "grid.alpha": 0.3}):
        made, axes = pyplot.subplots(1, columns, figsize=size, layout="constrained", squeeze=False)
        try:
            yield list(axes[0])
            path.parent.mkdir(parents=True, exist_ok=True)
            made.savefig(path, dpi=110)
        finally:
            pyplot.close(made)
