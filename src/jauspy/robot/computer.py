"""The computer that runs a robot: load, memory, temperature, room for files. Linux; elsewhere what Python can tell."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

MAX_LOAD: Final = 1.5
"""Processes that wait or run on each processor, averaged over a minute, above which it is too slow."""
MIN_MEMORY: Final = 0.05
"""Fraction of the memory that should be available."""
MIN_ROOM: Final = 0.02
"""Fraction of the file system that should be free."""
HOT: Final = 90.0
"""Degrees Celsius at which processors usually become slower."""


@dataclass(frozen=True, slots=True)
class ComputerState:
    """The state of the computer; None for what it does not tell."""

    load: float | None = None
    """Processes that wait or run on each processor, averaged over a minute."""
    memory: float | None = None
    """Fraction of the memory that is available."""
    room: float | None = None
    """Fraction of the file system of the working directory that is free."""
    temperature: float | None = None
    """Degrees Celsius of its hottest sensor."""


def computer_state(system: Path = Path("/")) -> ComputerState:
    """Read the state; `system`: the root of `proc` and `sys`."""
    load = os.getloadavg()[0] / (os.cpu_count() or 1) if hasattr(os, "getloadavg") else None
    try:
        usage = shutil.disk_usage(Path.cwd())
        room = usage.free / usage.total if usage.total else None
    except OSError:  # the working directory was deleted
        room = None
    zones = [value / 1000.0 for zone in _zones(system) if (value := _number(_text(zone / "temp"))) is not None]
    return ComputerState(load, _memory(_text(system / "proc/meminfo")), room, max(zones, default=None))


def _zones(system: Path) -> Iterator[Path]:
    folder = system / "sys/class/thermal"
    if folder.is_dir():
        yield from sorted(folder.glob("thermal_zone*"))[:64]


def _memory(text: str) -> float | None:
    """The fraction of /proc/meminfo that is available."""
    values = {}
    for line in text.splitlines()[:200]:
        name, _, rest = line.partition(":")
        values[name] = _number(rest.split()[0]) if rest.split() else None
    total, available = values.get("MemTotal"), values.get("MemAvailable")
    return available / total if total and available is not None else None


def _number(text: str) -> float | None:
    text = text.strip()
    return float(text) if text.lstrip("-").isdecimal() and len(text) < 20 else None


def _text(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return file.read(1 << 16).decode("ascii", errors="replace")
    except OSError:  # sensors come and go, and some cannot be read
        return ""


def problems(state: ComputerState) -> dict[str, str]:
    """Problems of a computer, by the kind of part: `processor`, `memory`, `files`."""
    found = {}
    if state.load is not None and state.load > MAX_LOAD:
        found["processor"] = f"{state.load:.1f} processes for each processor: the computer is too slow; end others"
    if state.temperature is not None and state.temperature > HOT:
        found["processor"] = f"the computer has {state.temperature:.0f} degrees Celsius: let it cool down"
    if state.memory is not None and state.memory < MIN_MEMORY:
        found["memory"] = f"{100.0 * state.memory:.0f} % of the memory is available: end other programs"
    if state.room is not None and state.room < MIN_ROOM:
        found["files"] = f"{100.0 * state.room:.0f} % of the file system is free: delete what is not needed"
    return found
