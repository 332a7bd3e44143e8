"""What a robot more costs: discovery, control and events of 10 to 500 robots in virtual time, and the projection.

python tools/bench/fleet.py [--robots 10 100 500] [--processes 10 60 [--per-program 5]] [--json FILE]

`--robots`, in virtual time: each robot has 8 components on local sockets of one of 25 node managers (gateways), and 20
operators have a node manager each. Routers, components and operators' clients are those of jauspy; sockets and clocks
are not: datagrams take 2 ms through memory, and time does not pass while Python works. So what is counted in seconds of
*their* time is what the protocols wait for, and what is counted in CPU seconds is the work of all processes together.

One run: all operators discover all robots; each takes control of its share; each share is handed to the next
operator, who has more authority; each robot reports its pose at 10 Hz to the operator in control. The cost of a robot
is the CPU time of a phase, divided by the robots (of discovery: by robots and operators), as a ratio to that of the
smallest fleet of the same run. Runs of different sizes take turns, since the machine is not quiet: compare ratios.
`--calls` counts calls of functions instead, which depend neither on other load nor on the caches of processors: large
fleets in one process do not fit into them.

`--processes`, in real time: robots, node managers and an operator as processes of this machine (`_fleet_processes.py`).
One of the two parts is left out by its option without a number, or with 0.
"""

from __future__ import annotations

import argparse
import asyncio
import cProfile
import gc
import json
import math
import sys
import time
from collections.abc import AsyncIterator, Mapping, Sequence
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Final

from jauspy.cli.processes import run as run_until_signal
from jauspy.component import Component, ComponentOptions
from jauspy.ids import JausID
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, ReportLocalPoseExt
from jauspy.ocu import OCU
from jauspy.ocu.control import Control
from jauspy.ocu.discovery import Appeared, Changed
from jauspy.ocu.follow_ups import COALESCE_TIME, MAX_FOLLOW_UPS
from jauspy.ocu.subsystems import SubsystemInfo
from jauspy.protocol.address_book import IdBounds
from jauspy.services.service import Service
from jauspy.testing import until
from jauspy.virtual.clock import VirtualClock

sys.path.insert(0, str(Path(__file__).parent))

import _fleet_processes as processes
from _memory_network import Network, Node

GATEWAYS: Final = 25
OPERATORS: Final = 20
COMPONENTS: Final = 8
POSE: Final = 1
"""Number of the component that has a pose and is controlled; the others have the core services."""
RATE: Final = 10.0
"""Hz of events."""
EVENT_SECONDS: Final = 3.0
DISCOVERY_TIME: Final = 5.0
"""Seconds of their time for which discovery is measured at least, also after all robots are known: all components are
asked again every 2 s, and larger fleets are discovered later."""
LIMIT: Final = 10.0
"""Seconds of their time in which all robots must have been discovered."""
FLAT: Final = 0.2
"""Part by which the cost of a robot may exceed that in the smallest fleet."""
FIRST_ROBOT: Final = 1000
FIRST_OPERATOR: Final = 100
PROJECTED: Final = 10_000


class FixedPose(Service, urn="urn:jaus:jss:mobility:LocalPoseSensor"):
    """A pose that does not change, so that the measured work is that of the protocols."""

    def report_local_pose(self) -> ReportLocalPose:
        """The pose."""
        return ReportLocalPose(x=1.0, y=2.0, yaw=0.5)

    def report_local_pose_ext(self) -> ReportLocalPoseExt:
        """The same."""
        return ReportLocalPoseExt(x=1.0, y=2.0, heading=0.5)

    def update_local_pose(self) -> None:
        """Ignore it."""

    def update_local_pose_ext(self) -> None:
        """Ignore it."""


@dataclass
class Row:
    """One run. Times of phases are in seconds of their time, `cpu` in CPU seconds of this process by phase."""

    robots: int
    discovered_after: float = 0.0
    controlled_after: float = 0.0
    handed_over_after: float = 0.0
    events: int = 0
    events_expected: int = 0
    datagrams: int = 0
    cpu: dict[str, float] = field(default_factory=dict)
    calls: dict[str, int] = field(default_factory=dict)
    """Calls of functions by phase, if they are counted, which takes several times as long."""
    tables: dict[str, int] = field(default_factory=dict)
    """The largest number of entries of each table, over all node managers and operators."""

    def per_robot(self, phase: str, work: Mapping[str, float] | None = None) -> float:
        """CPU seconds or other work of a phase for one robot; of discovery, for one robot and operator."""
        return (work or self.cpu)[phase] / self.robots / (OPERATORS if phase == "discovery" else 1)


class Fleet:
    """All that takes part in one run."""

    def __init__(self, robots: int, operators: int = OPERATORS, gateways: int = GATEWAYS) -> None:
        ids = robots * COMPONENTS + operators
        bounds = IdBounds(2 * ids, ids)
        network = self.network = Network()
        self.nodes = [Node(network, 1 + number, bounds) for number in range(gateways + operators)]
        self.robots = [FIRST_ROBOT + number for number in range(robots)]
        self.components = [
            Component(
                id := JausID(subsystem, 1, number),
                [FixedPose()] if number == POSE else [],
                name=f"component {number}",
                transport=self.nodes[index % gateways].transport(id),
                options=ComponentOptions(),
            )
            for index, subsystem in enumerate(self.robots)
            for number in range(1, 1 + COMPONENTS)
        ]
        self.operators = [
            OCU(
                id := JausID(FIRST_OPERATOR + number, 1, 1),
                transport=self.nodes[gateways + number].transport(id),
                max_components=2 * ids,
            )
            for number in range(operators)
        ]

    @asynccontextmanager
    async def opened(self) -> AsyncIterator[None]:
        """Open all components and operators."""
        async with AsyncExitStack() as stack:
            for component in self.components:
                await stack.enter_async_context(component)
            for operator in self.operators:
                await stack.enter_async_context(operator)
            yield
        for node in self.nodes:
            node.close()

    def share(self, number: int) -> list[int]:
        """The robots of an operator."""
        return self.robots[number % len(self.operators) :: len(self.operators)]

    async def discover(self, operator: OCU, until: float) -> float:
        """Let an operator watch until a time; returns when it knew all robots, with names and services of all parts."""
        clock = asyncio.get_running_loop().time
        missing, known_at = set(self.robots), math.inf
        with suppress(TimeoutError):
            async with asyncio.timeout_at(max(until, clock() + 6.0 * LIMIT)) as limit:
                async for news in operator.watch():
                    if isinstance(news, Appeared | Changed) and isinstance(news.now, SubsystemInfo):
                        missing.difference_update({news.id.subsystem} if is_complete(news.now) else ())
                    if not missing and math.isinf(known_at):
                        known_at = clock()
                        limit.reschedule(max(until, known_at))
        if missing:
            raise TimeoutError(f"{len(missing)} of {len(self.robots)} robots were not discovered in {6.0 * LIMIT:g} s")
        return known_at

    def tables(self) -> dict[str, int]:
        """Numbers of entries that must not grow with time."""
        routers = [node.router for node in self.nodes]
        return {
            "node manager: addresses": max(len(list(router.address_book)) for router in routers),
            "node manager: components": max(len(list(router.components)) for router in routers),
            "node manager: waiting messages": max(router.pending_messages for router in routers),
            "node manager: counters": max(len(router.counters) for router in routers),
            "operator: counters": max(len(operator.counters) for operator in self.operators),
        }


def is_complete(robot: SubsystemInfo) -> bool:
    """True when all components with their names and services are known."""
    found = robot.components
    return len(found) == COMPONENTS and all(component.name and component.services for component in found)


class Phases:
    """Measures CPU time by phase, and counts calls of functions if wanted."""

    def __init__(self, row: Row, *, counts_calls: bool = False) -> None:
        self._row = row
        self._counts_calls = counts_calls

    @asynccontextmanager
    async def phase(self, name: str) -> AsyncIterator[float]:
        """Yields the time at which it begins."""
        gc.collect()
        profile = cProfile.Profile()
        before = time.process_time()
        if self._counts_calls:
            profile.enable()
        yield asyncio.get_running_loop().time()
        if self._counts_calls:
            profile.disable()
            self._row.calls[name] = sum(entry.callcount for entry in profile.getstats())
        self._row.cpu[name] = time.process_time() - before


async def hold(operator: OCU, subsystem: int, authority: int, stack: AsyncExitStack) -> Control:
    """Take control of a robot until the end of the stack."""
    service = operator.service(JausID(subsystem, 1, POSE), "AccessControl")
    control = service.control(authority, retries=5)
    await stack.enter_async_context(control)
    return control


async def count_events(operator: OCU, subsystem: int, seconds: float) -> int:
    """Number of reports of a robot in these seconds."""
    service = operator.service(JausID(subsystem, 1, POSE), "LocalPoseSensor")
    found = 0
    async with service.subscribe(QueryLocalPose(presence_vector=0xFF), rate=RATE) as reports:
        with suppress(TimeoutError):
            async with asyncio.timeout(seconds):
                async for _ in reports:
                    found += 1
    return found


async def run(
    robots: int,
    *,
    operators: int = OPERATORS,
    gateways: int = GATEWAYS,
    seconds: float = EVENT_SECONDS,
    discovery_time: float = DISCOVERY_TIME,
    counts_calls: bool = False,
) -> Row:
    """One run, in virtual time."""
    row = Row(robots)
    clock = asyncio.get_running_loop().time
    with VirtualClock():
        clock = asyncio.get_running_loop().time
        fleet = Fleet(robots, operators, gateways)
        phases = Phases(row, counts_calls=counts_calls)
        async with fleet.opened(), AsyncExitStack() as first, AsyncExitStack() as second:
            gc.collect()
            gc.freeze()  # robots are processes of their own, whose collectors do not look at each other
            async with phases.phase("discovery") as began:
                known = [fleet.discover(operator, began + discovery_time) for operator in fleet.operators]
                row.discovered_after = max(await asyncio.gather(*known)) - began
            shares = [(subsystem, number) for number in range(operators) for subsystem in fleet.share(number)]
            async with phases.phase("control") as began:
                held = await asyncio.gather(
                    *(hold(fleet.operators[number], subsystem, 100, first) for subsystem, number in shares)
                )
                row.controlled_after = clock() - began
            async with phases.phase("handover") as began:
                next_ones = [(subsystem, fleet.operators[(number + 1) % operators]) for subsystem, number in shares]
                taken = await asyncio.gather(
                    *(hold(operator, subsystem, 150, second) for subsystem, operator in next_ones)
                )
                await until(lambda: all(control.lost for control in held), within=LIMIT)
                row.handed_over_after = clock() - began
            async with phases.phase("events"):
                counts = await asyncio.gather(
                    *(count_events(operator, subsystem, seconds) for subsystem, operator in next_ones)
                )
            assert not any(control.lost for control in taken)
            row.events, row.events_expected = sum(counts), round(seconds * RATE) * robots
            gc.unfreeze()
            row.tables = fleet.tables()
            row.datagrams = fleet.network.datagrams
    return row


def ratios(rows: Sequence[Row]) -> dict[str, dict[int, float]]:
    """The cost of a robot by phase and size of the fleet, relative to the smallest fleet; of several runs the best.

    It is counted in calls where those were counted, else in CPU time.
    """
    sizes = sorted({row.robots for row in rows})
    best = {
        (phase, size): min(row.per_robot(phase, row.calls) for row in rows if row.robots == size)
        for phase in rows[0].cpu
        for size in sizes
    }
    return {phase: {size: best[phase, size] / best[phase, sizes[0]] for size in sizes} for phase in rows[0].cpu}


def show(rows: Sequence[Row]) -> None:
    """Print rows, ratios, and the projection."""
    print("\nrobots  discovered  controlled  handed over  events            datagrams  CPU s by phase")
    for row in rows:
        cpu = ", ".join(f"{phase} {seconds:.2f}" for phase, seconds in row.cpu.items())
        times = f"{row.discovered_after:8.2f} s  {row.controlled_after:8.2f} s  {row.handed_over_after:9.2f} s"
        print(f"{row.robots:6}  {times}  {row.events:6} of {row.events_expected:6}  {row.datagrams:9}  {cpu}")
    late = [row.robots for row in rows if row.discovered_after > LIMIT]
    print(f"\ndiscovery within {LIMIT:g} s of their time: " + (f"not with {late} robots" if late else "yes"))
    unit = "calls of functions" if rows[0].calls else "CPU time"
    print(f"cost of a robot in {unit}, relative to the smallest fleet:")
    for phase, by_size in ratios(rows).items():
        values = "  ".join(f"{size}: {ratio:.2f}" for size, ratio in by_size.items())
        flat = max(by_size.values()) <= 1.0 + FLAT
        print(f"  {phase:10} {values}  {'does not grow' if flat else 'GROWS'} (by {FLAT:.0%})")
    largest = max(rows, key=lambda row: row.robots)
    print(f"\nlargest tables with {largest.robots} robots:")
    for name, number in largest.tables.items():
        print(f"  {name}: {number}")
    if not largest.calls:  # counting takes longer than all else
        project(largest)


def project(row: Row) -> None:
    """Print what 10,000 robots would need, from the largest fleet, and what ends first."""
    event = row.cpu["events"] / max(1, row.events)
    discovery = row.per_robot("discovery") * PROJECTED
    ids, queries = PROJECTED * COMPONENTS, MAX_FOLLOW_UPS / COALESCE_TIME
    print(f"\nprojection to {PROJECTED:,} robots, if a robot costs what it costs among {row.robots}:")
    print(f"  discovery: {discovery:.0f} CPU s for each operator, robots and routing included;")
    print(f"    and {ids / queries:.0f} s of their time, since a client sends {queries:.0f} queries a second at most")
    print(f"  events: {1e6 * event:.0f} us each from sensor to operator, so all at {RATE:g} Hz need")
    print(
        f"    {event * RATE * PROJECTED:.0f} processors; one processor has enough for {1.0 / (event * RATE):.0f} robots"
    )
    print(
        f"  tables: {ids:,} ids, about {0.6e-3 * ids:.0f} MB in each node manager and client; the default bound, 4096,"
    )
    print(f"    ends at {4096 // COMPONENTS} robots: set max_ids, max_ids_per_host and OCU(max_components)")


async def measure(sizes: Sequence[int], repeats: int, *, counts_calls: bool = False) -> list[Row]:
    """All runs, in turns."""
    rows = []
    await run(2, operators=2, gateways=2, seconds=0.5, discovery_time=0.0)  # modules are loaded and code is generated
    for _ in range(repeats):
        for size in sizes:
            rows.append(await run(size, counts_calls=counts_calls))
            print(json.dumps(asdict(rows[-1])), flush=True)
    return rows


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--robots", type=int, nargs="*", default=[10, 100, 500], help="in virtual time")
    parser.add_argument("--repeats", type=int, default=1, help="of runs in virtual time")
    parser.add_argument("--calls", action="store_true", help="count calls of functions instead of CPU time")
    parser.add_argument("--processes", type=int, nargs="*", default=[60], help="robots as processes")
    parser.add_argument("--per-program", type=int, default=1, help="robots that share a process (`jauspy up --also`)")
    parser.add_argument("--per-node-manager", type=int, default=10, help="robots that share a node manager's process")
    parser.add_argument(
        "--step", type=float, default=0.02, help="of robots as processes, in seconds (`jauspy up --step`)"
    )
    parser.add_argument("--seconds", type=float, default=10.0, help="of idling, and of events, of processes")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    rows: list[Row | processes.ProcessRow] = []
    if sizes := [size for size in arguments.robots if size]:
        virtual = asyncio.run(measure(sizes, arguments.repeats, counts_calls=arguments.calls))
        show(virtual)
        rows += virtual
    if sizes := [size for size in arguments.processes if size]:
        try:
            real = run_until_signal(
                processes.measure(
                    sizes, arguments.per_program, arguments.per_node_manager, arguments.step, arguments.seconds
                )
            )
        except KeyboardInterrupt:
            real = None
        if real is None:
            raise SystemExit("stopped; all processes have ended")
        processes.show(real)
        rows += real
    if arguments.json:
        arguments.json.write_text(json.dumps([asdict(row) for row in rows], indent=2))


if __name__ == "__main__":
    main()
