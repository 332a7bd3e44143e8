"""Robots and node managers as processes: start, end, CPU time, memory and counters."""

from __future__ import annotations

import asyncio
import re
import signal
import sys
import time
from collections import Counter
from collections.abc import AsyncIterator, Iterable, Sequence
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import psutil

ADDRESS: Final = "127.0.0.{}"
"""Address of a node manager, by its number from 2; 127.0.0.1 is that of the interface."""
START_TIMEOUT: Final = 120.0
"""Seconds in which a process must have started, which takes 3 CPU seconds."""
END_TIMEOUT: Final = 30.0
"""Seconds from SIGTERM to SIGKILL."""
PRINT_TIMEOUT: Final = 20.0
"""Seconds in which a robot must have printed its counters."""
MEMORY_EACH: Final = 100 << 20
MEMORY_FURTHER: Final = 20 << 20
"""Bytes of memory that a program with a robot is expected to take, and each further robot in it."""
MEMORY_RESERVE: Final = 1 << 30
"""Bytes of memory of the machine that are left to others."""


class NotStartedError(Exception):
    """A process that did not start, with the reason."""


@dataclass
class Child:
    """A process that has started; `errors` is the file of its standard error output."""

    process: asyncio.subprocess.Process
    errors: Path
    robots: int = 0
    """Number of robots in it."""

    @property
    def has_ended(self) -> bool:
        """True if it does not run any more."""
        return self.process.returncode is not None

    def last_error(self) -> str:
        """The last line of its error output."""
        lines = self.errors.read_text(errors="replace").strip().splitlines()
        return lines[-1] if lines else "no error was printed"

    def cpu(self) -> float:
        """CPU seconds so far; 0 when it has ended. Robots that send no video have no further processes."""
        try:
            return cpu_seconds(psutil.Process(self.process.pid))
        except psutil.NoSuchProcess:
            return 0.0

    def memory(self) -> int:
        """Bytes of its proportional set size: pages that several processes share are divided among them."""
        try:
            return int(psutil.Process(self.process.pid).memory_full_info().pss)
        except psutil.NoSuchProcess:
            return 0

    async def counters(self) -> dict[str, int]:
        """The counters that `jauspy up` prints on SIGUSR1, of all its robots; empty if it prints none."""
        before = self._printed()
        with suppress(ProcessLookupError):
            self.process.send_signal(signal.SIGUSR1)
        end = time.monotonic() + PRINT_TIMEOUT
        while not self.has_ended and time.monotonic() < end:
            await asyncio.sleep(0.1)
            if len(printed := self._printed()[len(before) :]) >= self.robots:
                total = Counter[str]()
                for block in printed:
                    total.update({name: int(number) for name, number in re.findall(r"^  (\S+) +(\d+)$", block, re.M)})
                return total
        return {}

    def _printed(self) -> list[str]:
        """Counters that have been printed completely: those of the steps are the last ones."""
        blocks = self.errors.read_text(errors="replace").split("counters of ")[1:]
        return [block for block in blocks if re.search(r"realtime\.steps +\d+\n", block)]


def robots_that_fit(per_program: int) -> int:
    """The number of robots, so many in a program, for which the machine has memory now."""
    program = MEMORY_EACH + (per_program - 1) * MEMORY_FURTHER
    return max(0, (psutil.virtual_memory().available - MEMORY_RESERVE) // program) * per_program


def cpu_seconds(process: psutil.Process) -> float:
    """CPU seconds of a process so far."""
    times = process.cpu_times()
    return float(times.user + times.system)


class Site:
    """Starts node managers and robots on loopback addresses, with sockets in a folder of their own."""

    def __init__(self, folder: Path, port: int, step: float) -> None:
        self.node_managers: list[Child] = []
        self.programs: list[Child] = []
        """Programs with robots that have started."""
        self.robots: dict[int, Child] = {}
        """The programs of robots, by subsystem."""
        self._folder = folder
        self._port = port
        self._step = step
        self._all: list[Child] = []

    async def start_node_manager(self) -> Path:
        """Start a node manager with an address of its own; returns the folder of its sockets."""
        number = 2 + len(self.node_managers)
        root = self._folder / str(number)
        root.mkdir()
        where = ("--address", ADDRESS.format(number), "--interface", "127.0.0.1", "--port", str(self._port))
        child = await self._start(f"node_manager_{number}", "ready", "node-manager", *where, "--local-root", str(root))
        self.node_managers.append(child)
        return root

    async def start_robots(self, subsystems: Sequence[int], root: Path) -> None:
        """Start robots inc1 in one program, with the backend kinematic, at the node manager with these sockets."""
        first, *others = subsystems
        options = ["--id", str(first), *(option for other in others for option in ("--also", f"inc1:{other}"))]
        options += ["--backend", "kinematic", "--local-root", str(root), "--step", str(self._step)]
        command = ("up", "inc1", *options, "--no-node-manager", "--plain")
        program = await self._start(f"robot_{first}", "stop it", *command)
        program.robots = len(subsystems)
        self.programs.append(program)
        self.robots.update(dict.fromkeys(subsystems, program))

    async def _start(self, name: str, ready: str, *command: str) -> Child:
        """Start a verb of jauspy, and wait for a line with `ready`."""
        errors = self._folder / f"{name}.txt"
        with errors.open("w") as file:
            process = await asyncio.create_subprocess_exec(
                *(sys.executable, "-m", "jauspy.cli.main", *command, "--with-parent"),
                stdin=asyncio.subprocess.PIPE,
                stdout=asyncio.subprocess.PIPE,
                stderr=file,
                cwd=self._folder,
            )
        child = Child(process, errors)
        self._all.append(child)
        assert process.stdout is not None
        try:
            async with asyncio.timeout(START_TIMEOUT):
                while ready not in (line := (await process.stdout.readline()).decode(errors="replace")):
                    if not line:
                        raise NotStartedError(child.last_error())
        except TimeoutError:
            process.kill()
            raise NotStartedError(f"it did not start within {START_TIMEOUT:g} s") from None
        return child

    async def close(self) -> None:
        """End the robots, and then the node managers."""
        robots = [child for child in self._all if child not in self.node_managers]
        await end(robots)
        await end(self.node_managers)


async def end(children: Iterable[Child]) -> None:
    """End processes; those that do not end in time are killed."""
    running = [child.process for child in children if not child.has_ended]
    for process in running:
        with suppress(ProcessLookupError):
            process.terminate()
    ends = [asyncio.ensure_future(process.wait()) for process in running]
    try:
        if ends:
            await asyncio.wait(ends, timeout=END_TIMEOUT)
    finally:
        for process in running:
            if process.returncode is None:
                with suppress(ProcessLookupError):
                    process.kill()
    await asyncio.gather(*ends)


@asynccontextmanager
async def site(folder: Path, port: int, step: float) -> AsyncIterator[Site]:
    """A site whose processes end with the block; its robots take steps of so many seconds."""
    async with AsyncExitStack() as stack:
        found = Site(folder, port, step)
        stack.push_async_callback(found.close)
        yield found
