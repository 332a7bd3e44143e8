"""The files that `jauspy conformance` writes."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from jauspy.errors import ConfigError

if TYPE_CHECKING:
    from collections.abc import Callable

    from jauspy.conformance.results import Report


@dataclass(frozen=True, slots=True)
class Files:
    """Where to write each kind of report. Raises `ConfigError` before a run that could not be written down."""

    junit: Path | None = None
    html: Path | None = None
    pcapng: Path | None = None

    def __post_init__(self) -> None:
        for path in (self.junit, self.html, self.pcapng):
            if path is not None and (obstacle := _obstacle(path)):
                raise ConfigError(f"{path}: cannot be written: {obstacle}")

    def write(self, report: Report) -> None:
        """Write those that are wanted."""
        from jauspy.conformance.html import page
        from jauspy.conformance.junit import junit
        from jauspy.conformance.pcap import capture

        _write(self.junit, lambda: junit(report))
        _write(self.html, lambda: page(report).encode())
        _write(self.pcapng, lambda: capture(report))


def _obstacle(path: Path) -> str:
    """What is wrong with a path, as far as it can be told without writing to it."""
    if path.is_dir():
        return "it is a directory"
    if not path.parent.is_dir():
        return f"there is no directory {path.parent}"
    return "" if os.access(path if path.exists() else path.parent, os.W_OK) else "permission denied"


def _write(path: Path | None, content: Callable[[], bytes]) -> None:
    if path is None:
        return
    try:
        path.write_bytes(content())
    except OSError as error:
        raise ConfigError(f"{path}: cannot be written: {error.strerror}") from error
