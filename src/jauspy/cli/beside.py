"""Processes that `jauspy up` runs beside a robot, so that they never delay it: a console, and a flight recorder."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import asynccontextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.cli.processes import ChildFailed, ChildProcess
from jauspy.errors import ConfigError
from jauspy.recording.incidents import Kind

CONSOLE_PORT: Final = 8101
CONSOLE_READY: Final = "the console is at"
NEEDS_CONSOLE: Final = "the console needs the extra 'console': pip install 'jauspy[console]'"

RECORDINGS: Final = Path("recordings")
MAX_BEFORE, MAX_AFTER = 600.0, 600.0
DEFAULT_BEFORE, DEFAULT_AFTER = 30.0, 10.0
"""Seconds that a flight recorder records before and after an incident."""
ALL_KINDS: Final = ",".join(Kind)


def parse_kinds(text: str, option: str) -> tuple[Kind, ...]:
    """The kinds of incidents in a list with commas. Raises `ConfigError`."""
    names = [name.strip() for name in text.split(",")]
    for name in names:
        if name not in tuple(Kind):
            raise ConfigError(f"{option}: {name!r} is nothing to record on; these are: {', '.join(Kind)}")
    return tuple(dict.fromkeys(map(Kind, names)))


@dataclass(frozen=True, slots=True)
class FlightRecorderOptions:
    """How a robot's own flight recorder records."""

    kinds: tuple[Kind, ...]
    before: float
    after: float
    folder: Path

    def arguments(self, subsystem: int, root: Path) -> list[str]:
        """The command line of the verb."""
        kinds, before, after = ",".join(self.kinds), str(self.before), str(self.after)
        command = ["flight-recorder", "--on", kinds, "--before", before, "--after", after]
        return [*command, "--output", str(self.folder), "--subsystem", str(subsystem), "--local-root", str(root)]


def chosen_options(
    on: str | None, before: float | None, after: float | None, folder: Path
) -> FlightRecorderOptions | None:
    """What the options of a robot say; None without `--record-on`. Raises `ConfigError`."""
    if on is None:
        given = {"--before": before, "--after": after}  # without a flight recorder, DataLogging has the folder
        for name, value in given.items():
            if value is not None:
                raise ConfigError(f"{name} needs --record-on, as in --record-on {ALL_KINDS}")
        return None
    return FlightRecorderOptions(
        parse_kinds(on, "--record-on"),
        DEFAULT_BEFORE if before is None else before,
        DEFAULT_AFTER if after is None else after,
        folder,
    )


@asynccontextmanager
async def flight_recorder_beside(options: FlightRecorderOptions, subsystem: int, root: Path) -> AsyncIterator[str]:
    """Run a flight recorder; yields what it records to and on. Raises `ConfigError` if it does not start."""
    advice = "the robot keeps running without it"
    async with _beside("flight recorder", options.arguments(subsystem, root), advice) as first_line:
        yield first_line


@asynccontextmanager
async def console_beside(root: Path, port: int, robot: int) -> AsyncIterator[str]:
    """Run a console that shows this robot first, for the node manager with these local sockets; yields its URL.

    Raises `ConfigError` if it does not start.
    """
    if find_spec("nicegui") is None:
        raise ConfigError(NEEDS_CONSOLE)
    arguments = ["console", "--no-browser", "--port", str(port), "--connect", f"local:{root}", "--robot", str(robot)]
    advice = "the robot keeps running; start another console with: jauspy console"

    def explain(error: ChildFailed) -> str:
        return str(error).replace("--port", "--console-port")

    async with _beside("console", arguments, advice, explain) as first_line:
        yield first_line.removeprefix(CONSOLE_READY).strip()


@asynccontextmanager
async def _beside(
    name: str, arguments: Sequence[str], advice: str, explain: Callable[[ChildFailed], str] = str
) -> AsyncIterator[str]:
    """A verb of jauspy in a child process, until the block ends; yields its first line.

    If it ends before, that is said with the advice, and the robot keeps running. `explain` words why it did not start.
    """

    def forward(line: str) -> None:
        console.print_lines(f"{name}: {line}", file=sys.stderr)

    async def tell_end() -> None:
        console.error(f"{await child.ended()}; {advice}")

    child = ChildProcess(name, arguments, on_error_line=forward)
    try:
        await child.__aenter__()
    except ChildFailed as error:
        raise ConfigError(explain(error)) from error
    watching = asyncio.create_task(tell_end())
    try:
        yield child.first_line
    finally:
        watching.cancel()
        await asyncio.wait({watching})
        await child.stop()
