"""The hour meter of a robot in a file, which its TOML file names: `[health] hour_meter = "hours.json"`."""

from __future__ import annotations

import contextlib
import json
import math
import os
from pathlib import Path
from typing import Final

from jauspy.errors import ConfigError
from jauspy.logs import get_logger
from jauspy.services.iop import HoursInMemory
from jauspy.user_files import read_file

_LOG: Final = get_logger("jauspy.robot")

SAVE_PERIOD: Final = 60.0
"""Seconds of operation between two writes; so much is lost when the power fails."""
MAX_FILE: Final = 1 << 16
MAX_HOURS: Final = 1e6
FORMAT: Final = "jauspy hour meter"


class HourMeterFile(HoursInMemory):
    """An `HourMeter` that goes on where it was; `close` writes the last minute, too.

    Raises `ConfigError` for a file that is no hour meter, which is left as it is.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        total, resets = _read(path)
        super().__init__(total, resets)
        self._saved = total
        self._failed = False

    def add(self, seconds: float) -> None:
        """Count further seconds, and write them once a minute."""
        super().add(seconds)
        if self.total - self._saved >= SAVE_PERIOD:
            self.save()

    def reset(self, reminder: int) -> None:
        """Reset a reminder, and write that."""
        super().reset(reminder)
        self.save()

    def save(self) -> None:
        """Write the file; a failure is logged once, and the hours are counted on."""
        self._saved = self.total
        resets = {str(id): seconds / 3600.0 for id, seconds in sorted(self.resets.items())}
        text = json.dumps({"format": FORMAT, "hours": self.total / 3600.0, "resets": resets}, indent=1)
        partial = self._path.with_name(f"{self._path.name}.partial")
        try:
            descriptor = os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC | os.O_NOFOLLOW, 0o644)
            with os.fdopen(descriptor, "w", encoding="ascii") as file:
                file.write(text + "\n")
            partial.replace(self._path)
            self._failed = False
        except OSError as error:
            with contextlib.suppress(OSError):
                partial.unlink()
            if not self._failed:
                _LOG.error("%s: the hours cannot be written: %s", self._path, error.strerror)
            self._failed = True

    def close(self) -> None:
        """Write the hours. May be called twice."""
        if self.total != self._saved:
            self.save()


def _read(path: Path) -> tuple[float, dict[int, float]]:
    """Seconds in all, and at the resets of reminders; zero without a file."""
    if not path.is_symlink() and not path.exists():
        return 0.0, {}
    if path.is_symlink():
        raise ConfigError(f"health.hour_meter: {path}: is a link; name the file itself")
    data: object = None
    with contextlib.suppress(ValueError, RecursionError):
        data = json.loads(read_file(path, MAX_FILE))
    resets = data.get("resets") if isinstance(data, dict) else None
    if not isinstance(data, dict) or data.get("format") != FORMAT or not isinstance(resets, dict):
        raise ConfigError(f"health.hour_meter: {path}: is no hour meter; name a file that does not exist yet")
    total = _seconds(data.get("hours"), path)
    known = {id: value for id, value in resets.items() if id.isdecimal() and len(id) <= 3}
    return total, {int(id): min(total, _seconds(value, path)) for id, value in known.items()}


def _seconds(hours: object, path: Path) -> float:
    if not isinstance(hours, int | float) or isinstance(hours, bool) or not 0.0 <= hours <= MAX_HOURS:
        raise ConfigError(
            f"health.hour_meter: {path}: has {str(hours)[:40]!r} in place of hours from 0 to {MAX_HOURS:g}; "
            "delete it to begin anew"
        )
    return float(hours) * 3600.0 if math.isfinite(hours) else 0.0
