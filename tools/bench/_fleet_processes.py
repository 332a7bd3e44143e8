"""A fleet of real processes on this machine: robots with the backend kinematic, node managers, and one operator.

Each robot is a process `jauspy up`, as integrators run it, or several share one by its option `--also`, as in the
simulation of a fleet. Several robots share a node manager, as behind a gateway, and the operator has one of its own,
which finds the others by multicast on loopback. The operator is the client in the process of the benchmark. It
discovers all robots, takes control of each, subscribes to the pose of each at 10 Hz, drives each a little, and releases
it. What a robot does not do is a failure, which is printed.
"""

from __future__ import annotations

import asyncio
import json
import math
import os
import statistics
import tempfile
import time
from collections import Counter
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable, Mapping, Sequence
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Final

import psutil
from _processes import free_port
from _robot_processes import NotStartedError, Site, cpu_seconds, robots_that_fit, site

from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.mobility import QueryLocalPoseExt, ReportLocalPoseExt, SetWrenchEffort
from jauspy.ocu import OCU
from jauspy.ocu.control import Control
from jauspy.ocu.discovery import Appeared, Changed
from jauspy.ocu.subscription import Subscription
from jauspy.ocu.subsystems import SubsystemInfo
from jauspy.robot import robot_files

RATE: Final = 10.0
"""Hz of events."""
FIRST_ROBOT: Final = 1001
OPERATOR: Final = "100.1.1"
AUTHORITY: Final = 200
EFFORT: Final = 40.0
"""Percent, until the time-out of the command."""
LEAST_DISTANCE: Final = 0.05
"""Metres; a robot that went less far has not driven."""
DISCOVERY_TIMEOUT: Final = 120.0
TIMEOUT: Final = 2.0
"""Seconds of one attempt of a query."""
SETTLING_TIME: Final = 5.0
"""Seconds after the start of the last robot in which nothing is measured."""
PROJECTED: Final = 10_000
NEGLIGIBLE: Final = 0.01
"""Part of skipped steps that needs no mention in the projection."""
MAX_FAILURES: Final = 10
"""Failures that are printed."""
DRIVER: Final = "PrimitiveDriver"


@dataclass
class ProcessRow:
    """One run; times are seconds of the clock, CPU is in seconds per second unless stated otherwise."""

    robots: int
    """Robots that were to be started."""
    per_program: int = 1
    """Robots in one process."""
    started: int = 0
    started_after: float = 0.0
    start_cpu: float = 0.0
    """CPU seconds of a robot until it has started."""
    node_managers: int = 0
    discovered: int = 0
    discovered_after: float = 0.0
    controlled: int = 0
    controlled_after: float = 0.0
    driven: int = 0
    released: int = 0
    released_after: float = 0.0
    events: int = 0
    events_expected: int = 0
    latencies: list[float] = field(default_factory=list)
    """Median and 95th percentile from the making of a report until the operator has read it, in seconds."""
    idle_cpu: float = 0.0
    """Of one robot without an operator."""
    cpu: dict[str, float] = field(default_factory=dict)
    """While all report: of one robot, of all node managers, of the operator, and of all processes of the machine."""
    memory: float = 0.0
    """Bytes of one robot (proportional set size) at the end."""
    memory_free: float = 0.0
    """Bytes that the machine could still give."""
    skipped: float = 0.0
    """Part of the steps of the robots' simulation that were skipped while they reported, for want of processor time."""
    failures: list[str] = field(default_factory=list)


class Operator:
    """The client, and what it knows of the robots it works with."""

    def __init__(self, ocu: OCU, row: ProcessRow) -> None:
        self.drivers: dict[int, JausID] = {}
        """Components that drive, by subsystem."""
        self._ocu = ocu
        self._row = row
        self._stacks: dict[int, AsyncExitStack] = {}
        self._controls: dict[int, Control] = {}
        self._reports: dict[int, Subscription[ReportLocalPoseExt]] = {}

    async def discover(self, robots: Iterable[int]) -> None:
        """Wait until all robots are known, with names and services of all components."""
        missing, components = set(robots), len(robot_files.load("inc1").modules)
        watching = self._ocu.watch()
        with suppress(TimeoutError):
            async with asyncio.timeout(DISCOVERY_TIMEOUT):
                while missing:
                    news = await anext(watching)
                    if not isinstance(news, Appeared | Changed) or not isinstance(news.now, SubsystemInfo):
                        continue
                    if news.now.id in missing and is_complete(news.now, components):
                        missing.discard(news.now.id)
                        self.drivers[news.now.id] = driver_of(news.now)
        await watching.aclose()
        self._row.failures += [f"robot {subsystem}: not discovered" for subsystem in sorted(missing)]

    async def take_control(self) -> None:
        """Take control of all robots, and make them ready."""

        async def take(subsystem: int) -> None:
            stack = self._stacks[subsystem] = AsyncExitStack()
            driver = self._ocu.service(self.drivers[subsystem], DRIVER)
            self._controls[subsystem] = await stack.enter_async_context(driver.control(AUTHORITY, retries=10))
            await driver.resume(timeout=10.0)

        await self._each(take, "control")

    async def subscribe(self) -> None:
        """Subscribe to the pose of all robots."""

        async def subscribe(subsystem: int) -> None:
            sensor = self._ocu.service(self.drivers[subsystem], "LocalPoseSensor")
            reports = sensor.subscribe(QueryLocalPoseExt(), rate=RATE, expects=ReportLocalPoseExt, silence=None)
            self._reports[subsystem] = await self._stacks[subsystem].enter_async_context(reports)

        await self._each(subscribe, "events")

    async def drive(self, seconds: float) -> None:
        """Let all robots drive, and read their reports for these seconds."""
        latencies: list[float] = []
        began = time.time()

        async def drive(subsystem: int) -> None:
            reports = self._reports[subsystem]
            before, places = reports.received, []
            command = SetWrenchEffort(propulsive_linear_effort_x=EFFORT)
            await self._ocu.service(self.drivers[subsystem], DRIVER).send(command)
            with suppress(TimeoutError):
                async with asyncio.timeout(seconds):
                    while True:
                        report = await reports.get()
                        made = (report.time_seconds or 0) + 1e-9 * (report.time_nano_seconds or 0)
                        places.append((report.x or 0.0, report.y or 0.0))
                        if made >= began:
                            latencies.append(time.time() - made)
            self._row.events += reports.received - before
            if not places or math.dist(places[0], places[-1]) < LEAST_DISTANCE:
                self._row.failures.append(f"robot {subsystem}: did not drive")
            else:
                self._row.driven += 1

        self._row.events_expected = round(seconds * RATE) * len(self.drivers)
        await self._each(drive, "driving")
        if latencies:
            ordered = sorted(latencies)
            self._row.latencies = [statistics.median(ordered), ordered[int(0.95 * len(ordered))]]

    async def release(self) -> None:
        """Cancel events, and release all robots."""

        async def release(subsystem: int) -> None:
            control = self._controls[subsystem]
            lost = control.lost
            await self._stacks[subsystem].aclose()
            if control.released:
                self._row.released += 1
            else:
                reason = f"control was lost: {lost}" if lost else "release was not acknowledged"
                self._row.failures.append(f"robot {subsystem}: {reason}")

        await self._each(release, "release")

    async def _each(self, action: Callable[[int], Awaitable[None]], what: str) -> None:
        """Do this with all robots at once; one that fails is left out of all that follows."""
        subsystems = list(self.drivers)
        for subsystem, result in zip(
            subsystems, await asyncio.gather(*map(action, subsystems), return_exceptions=True), strict=True
        ):
            if isinstance(result, JausError):
                self._row.failures.append(f"robot {subsystem}: {what}: {result}")
                del self.drivers[subsystem]
                await self._stacks[subsystem].aclose()
            elif result is not None:
                raise result


def is_complete(robot: SubsystemInfo, components: int) -> bool:
    """True when all components with their names and services are known."""
    found = robot.components
    return len(found) == components and all(component.name and component.services for component in found)


def driver_of(robot: SubsystemInfo) -> JausID:
    """The component that drives the robot."""
    return next(component.id for component in robot.components if component.find(DRIVER) is not None)


class Usage:
    """CPU time of the processes of a site, of the operator and of the machine, since this was made."""

    def __init__(self, site: Site) -> None:
        self._site = site
        self._before = self._totals()

    def shares(self) -> dict[str, float]:
        """CPU seconds per second: of one robot, all node managers, the operator, and the whole machine."""
        now = self._totals()
        used = {name: now[name] - self._before[name] for name in now}
        passed = used.pop("time")
        used["robot"] /= max(1, len(self._site.robots))
        return {name: seconds / passed for name, seconds in used.items()}

    def _totals(self) -> dict[str, float]:
        machine = psutil.cpu_times()
        return {
            "time": time.monotonic(),
            "robot": sum(program.cpu() for program in self._site.programs),
            "node managers": sum(manager.cpu() for manager in self._site.node_managers),
            "operator": cpu_seconds(psutil.Process()),
            "machine": machine.user + machine.nice + machine.system + machine.irq + machine.softirq,
        }


@asynccontextmanager
async def started(row: ProcessRow, per_node_manager: int, step: float) -> AsyncIterator[tuple[Site, Path]]:
    """Node managers and robots; also yields the folder of the operator's sockets.

    As many start at a time as there are processors: a start that has to share them with all others takes minutes.
    """
    async with AsyncExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="jauspy-", ignore_cleanup_errors=True))
        found = await stack.enter_async_context(site(Path(folder), free_port(), step))
        began = time.monotonic()
        operator = await found.start_node_manager()
        roots = [await found.start_node_manager() for _ in range(math.ceil(row.robots / per_node_manager))]

        turns = asyncio.Semaphore(psutil.cpu_count() or 1)

        async def start(robots: Sequence[int], root: Path) -> None:
            try:
                async with turns:
                    await found.start_robots(robots, root)
            except NotStartedError as error:
                row.failures += [f"robot {subsystem}: not started: {error}" for subsystem in robots]

        count = min(row.robots, robots_that_fit(row.per_program))
        if count < row.robots:
            row.failures.append(f"{row.robots - count} robots: not started: there is no memory for them")
        async with asyncio.TaskGroup() as group:
            for number, root in enumerate(roots):
                last = FIRST_ROBOT + min(count, (number + 1) * per_node_manager)
                for first in range(FIRST_ROBOT + number * per_node_manager, last, row.per_program):
                    group.create_task(start(range(first, min(last, first + row.per_program)), root))
        row.started, row.started_after = len(found.robots), time.monotonic() - began
        row.node_managers = len(found.node_managers)
        yield found, operator


async def run(robots: int, *, per_program: int, per_node_manager: int, step: float, seconds: float) -> ProcessRow:
    """One run; `step` is that of the robots, in seconds."""
    row = ProcessRow(robots, per_program)
    clock = time.monotonic
    async with started(row, per_node_manager, step) as (place, root):
        programs = place.programs
        row.start_cpu = sum(program.cpu() for program in programs) / max(1, row.started)
        await asyncio.sleep(SETTLING_TIME)
        usage = Usage(place)
        await asyncio.sleep(seconds)
        row.idle_cpu = usage.shares()["robot"]
        async with OCU(OPERATOR, f"local:{root}", timeout=TIMEOUT) as ocu:
            operator = Operator(ocu, row)
            began = clock()
            await operator.discover(place.robots)
            row.discovered, row.discovered_after = len(operator.drivers), clock() - began
            began = clock()
            await operator.take_control()
            row.controlled, row.controlled_after = len(operator.drivers), clock() - began
            await operator.subscribe()
            before = await asyncio.gather(*(program.counters() for program in programs))
            usage = Usage(place)
            await operator.drive(seconds)
            row.cpu = usage.shares()
            after = await asyncio.gather(*(program.counters() for program in programs))
            row.skipped = skipped_part(before, after)
            began = clock()
            await operator.release()
            row.released_after = clock() - began
        row.memory = sum(program.memory() for program in programs) / max(1, row.started)
        row.memory_free = psutil.virtual_memory().available
        row.failures += [
            f"robot {subsystem}: its process has ended: {program.last_error()}"
            for subsystem, program in place.robots.items()
            if program.has_ended
        ]
    return row


async def measure(
    sizes: Sequence[int], per_program: int, per_node_manager: int, step: float, seconds: float
) -> list[ProcessRow]:
    """All runs, one after the other."""
    rows = []
    for size in sizes:
        rows.append(
            await run(size, per_program=per_program, per_node_manager=per_node_manager, step=step, seconds=seconds)
        )
        print(json.dumps(asdict(rows[-1])), flush=True)
    return rows


def skipped_part(before: Sequence[Mapping[str, int]], after: Sequence[Mapping[str, int]]) -> float:
    """Part of the steps that were skipped between two readings of the counters of all robots."""
    total = Counter[str]()
    for then, now in zip(before, after, strict=True):
        if then and now:
            for name in ("realtime.steps", "realtime.skipped"):
                total[name] += now.get(name, 0) - then.get(name, 0)
    return total["realtime.skipped"] / max(1, total.total())


def show(rows: Sequence[ProcessRow]) -> None:
    """Print rows, failures, and the projection."""
    processors = os.cpu_count() or 1
    together = f", {rows[0].per_program} in a process" if rows[0].per_program > 1 else ""
    print(f"\nreal processes on this machine, which has {processors} processors: inc1, backend kinematic{together}")
    print("robots   started  discovered  controlled    released  events          latency p50, p95  driven  MB each")
    for row in rows:
        times = f"{row.started_after:6.0f} s  {row.discovered_after:8.2f} s  {row.controlled_after:8.2f} s"
        latency = ", ".join(f"{1e3 * value:.0f}" for value in row.latencies) or "none"
        events = f"{row.events} of {row.events_expected}"
        print(
            f"{row.robots:6}  {times}  {row.released_after:8.2f} s  {events:14}  {latency + ' ms':>16}"
            f"  {row.driven:6}  {row.memory / 1e6:7.0f}"
        )
    print("\nCPU seconds per second while all report, but for `start` (CPU seconds) and `idle`:")
    print("robots   start    idle   robot  all robots  node managers      operator  machine  steps skipped")
    for row in rows:
        cpu = row.cpu
        print(
            f"{row.robots:6}  {row.start_cpu:6.2f}  {row.idle_cpu:6.4f}  {cpu['robot']:6.4f}"
            f"  {row.started * cpu['robot']:10.2f}  {cpu['node managers']:6.2f} ({row.node_managers:3})"
            f"  {cpu['operator']:12.2f}  {cpu['machine']:7.2f}  {row.skipped:12.1%}"
        )
    for row in rows:
        print(f"\n{row.robots} robots: {verdict(row)}")
        for failure in row.failures[:MAX_FAILURES]:
            print(f"  {failure}")
        if len(row.failures) > MAX_FAILURES:
            print(f"  and {len(row.failures) - MAX_FAILURES} more, which --json tells")
    project(max(rows, key=lambda row: row.started))


def verdict(row: ProcessRow) -> str:
    """A statement about what fitted on the machine."""
    counts = {
        "started": row.started,
        "were discovered": row.discovered,
        "were controlled": row.controlled,
        "drove": row.driven,
        "were released": row.released,
    }
    incomplete = [f"{count} {what}" for what, count in counts.items() if count < row.robots]
    done = ", ".join(incomplete) if incomplete else "all started, were discovered, controlled, drove and were released"
    return f"{done}; {row.skipped:.1%} of the steps of their simulations were skipped for want of processor time"


def project(row: ProcessRow) -> None:
    """Print what a larger fleet would need, from the largest one, and what ends first on this machine."""
    if not row.started:
        return
    processors = os.cpu_count() or 1
    each = row.cpu["robot"] + row.cpu["node managers"] / row.started
    memory = row.memory_free + row.started * row.memory
    print(f"\nprojection, if a robot costs what it costs among {row.started}:")
    if row.skipped > NEGLIGIBLE:
        print(f"  (a robot needs more than that: {row.skipped:.0%} of the steps were skipped)")
    print(f"  processors: a robot with its part of a node manager takes {each:.4f}, so those of this machine have")
    print(f"    enough for {processors / each:.0f} robots; {PROJECTED:,} need {PROJECTED * each:.0f}")
    reading = row.cpu["operator"] / row.started
    print(f"  operator: control and {RATE:g} events/s of a robot take {reading:.4f} of a processor, so one client has")
    print(f"    enough time for {1.0 / reading:.0f} robots; {PROJECTED:,} need {PROJECTED * reading:.0f}")
    print(f"  memory: {row.memory / 1e6:.0f} MB each, so that of this machine is enough for {memory / row.memory:.0f}")
    print(f"    robots; {PROJECTED:,} need {PROJECTED * row.memory / 1e9:.0f} GB")
