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
        kinds: dict[Path, str] = {}
        for kind, path in (("--junit", self.junit), ("--html", self.html), ("--pcapng", self.pcapng)):
            if path is None:
                continue
            if obstacle := _obstacle(path):
                raise ConfigError(f"{path}: cannot be written: {obstacle}")
            if other := kinds.get(path.resolve()):
                raise ConfigError(f"{path} is to be the {other} file and the {kind} file; give them different names")
            kinds[path.resolve()] = kind
        if self.html is not None:
            from jauspy.conformance.reports import html_template

            html_template()

    def write(self, report: Report) -> list[str]:
        """Write those that are wanted; a sentence for each that cannot be written."""
        from jauspy.conformance.reports import capture, junit, page

        problems = (
            _write(self.junit, lambda: junit(report)),
            _write(self.html, lambda: page(report).encode()),
            _write(self.pcapng, lambda: capture(report)),
        )
        return [each for each in problems if each]


def _obstacle(path: Path) -> str:
    """What is wrong with a path, as far as it can be told without writing to it."""
    if path.is_dir():
        return "it is a directory"
    if not path.parent.is_dir():
        return f"there is no directory {path.parent}"
    return "" if os.access(path if path.exists() else path.parent, os.W_OK) else "permission denied"


def _write(path: Path | None, content: Callable[[], bytes]) -> str:
    if path is None:
        return ""
    try:
        path.write_bytes(content())
    except OSError as error:
        return f"{path}: cannot be written: {error.strerror}"
    return ""
