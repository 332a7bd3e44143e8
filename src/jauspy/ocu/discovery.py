"""Finds subsystems, nodes, components and services once (`discover`), or continuously (`watch`).

Both broadcast queries at intervals, query single components for what they have not reported, and merge the reports in a
`SubsystemTree`.
"""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import count
from typing import Final, TypeAlias

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import ANY_COMPONENT, ANY_NODE, ANY_SUBSYSTEM, EVERYONE, JausID
from jauspy.messages.core import (
    QueryHeartbeatPulse,
    QueryIdentification,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportServices,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.follow_ups import COALESCE_TIME, MAX_FOLLOW_UPS, FollowUps, Renewals, query_all_services
from jauspy.ocu.subsystems import (
    INTRODUCTION_TIME,
    ComponentInfo,
    Level,
    NodeInfo,
    ServiceInfo,
    SubsystemInfo,
    SubsystemTree,
)
from jauspy.protocol.header import Broadcast

ROUND_INTERVAL: Final = 0.5
"""Seconds between two rounds of queries of `discover`."""
POLL_INTERVAL: Final = 0.05
"""Seconds after which `discover` checks the tree again."""
OTHERS_TIME: Final = 0.6
"""Seconds in which others are searched for when one does not answer: the error names them."""
QUIET_TIME: Final = 0.15
"""Seconds without new facts after which a subsystem that is complete is returned."""
MAX_SEARCH: Final = 2.0
"""Seconds that `discover_all` takes at most without a timeout."""
MIN_ROUNDS: Final = 2
"""Rounds before a subsystem counts as complete: queries to a component, or its answers, may get lost."""
PROBES_PER_INTERVAL: Final = 4
"""How often in each interval `watch` queries components that have not answered the broadcast: packets get lost."""
MIN_PAUSE: Final = 0.02
"""Least seconds between two updates of `watch`, so that it does not keep the event loop busy."""
ROBOT_QUIET_TIME: Final = 0.3
"""Seconds without a new fact after which a robot that is complete is reported."""
MAX_INTRODUCTION: Final = 2.0 * INTRODUCTION_TIME
"""Seconds after which a robot that is not complete is reported."""
_NAME: Final = QueryIdentification(query_type=Level.SUBSYSTEM)
"""The query for a robot's name."""

SubsystemPart: TypeAlias = SubsystemInfo | NodeInfo | ComponentInfo | ServiceInfo


@dataclass(frozen=True, slots=True)
class Appeared:
    """`now` has appeared; `id` is 101.0.0 for a subsystem, 101.1.0 for a node, and the component's for its services."""

    id: JausID
    now: SubsystemPart


@dataclass(frozen=True, slots=True)
class Changed:
    """A robot has other components, or one of them has other services; a part has another name or type."""

    id: JausID
    before: SubsystemPart
    now: SubsystemPart


@dataclass(frozen=True, slots=True)
class Vanished:
    """It sent nothing for `silence` seconds, or the component no longer offers the service."""

    id: JausID
    before: SubsystemPart


News: TypeAlias = Appeared | Changed | Vanished
_Parts: TypeAlias = dict[tuple[JausID, ServiceInfo | None], SubsystemPart]


# --- once -------------------------------------------------------------------------------------------------------------


async def discover(connection: Connection, subsystem: int, timeout: float) -> SubsystemInfo:
    """The subsystem of this number as soon as it is complete; raises `ResponseTimeout` when it does not answer."""
    check_number(subsystem, "a subsystem", whole=True)
    if not 0 < subsystem < ANY_SUBSYSTEM:
        raise ConfigError(f"subsystem {subsystem} is outside 1..{ANY_SUBSYSTEM - 1}")
    tree = await _search(connection, subsystem, timeout)
    found = next((found for found in tree.subsystems() if found.id == subsystem), None)
    if found is None:
        others = await _search(connection, None, OTHERS_TIME)
        clash = await connection.id_clash()
        missing = f"subsystem {subsystem} did not answer for {timeout:g} s: {clash}" if clash else ""
        raise ResponseTimeout(missing or _no_such_subsystem(subsystem, others, timeout))
    return found


async def discover_all(connection: Connection, timeout: float | None) -> tuple[SubsystemInfo, ...]:
    """Every subsystem that answers within `timeout` seconds; without it, as soon as all that answered are complete."""
    check_number(timeout, "timeout", optional=True)
    if timeout is None:
        return (await _search(connection, None, MAX_SEARCH, may_end_early=True)).subsystems()
    return (await _search(connection, None, timeout)).subsystems()


async def _search(
    connection: Connection, subsystem: int | None, timeout: float, *, may_end_early: bool = False
) -> SubsystemTree:
    check_number(timeout, "timeout")
    if not timeout > 0:
        raise ConfigError(f"timeout {timeout} s must be above 0")
    tree, own_id = SubsystemTree(connection.max_components), connection.id
    clock = asyncio.get_running_loop().time
    end, size = clock() + timeout, 0

    def on_report(message: Message, source: JausID) -> None:
        if source != own_id:
            tree.add(message, source, clock())

    with connection.replies.listening(EVERYONE, on_report, ReportIdentification, ReportServices):
        for rounds in count(1):
            _broadcast(connection, subsystem, _NAME, query_all_services())
            _query_missing(connection, tree, subsystem)
            complete = await _completed(tree, subsystem, min(end, clock() + ROUND_INTERVAL), connection)
            if may_end_early and rounds >= MIN_ROUNDS and size == tree.size and _is_complete(tree):
                break
            size = tree.size
            if (complete and rounds >= MIN_ROUNDS) or clock() >= end:
                break
    return tree


async def _completed(tree: SubsystemTree, subsystem: int | None, end: float, connection: Connection) -> bool:
    """Wait for reports until `end`; true as soon as the subsystem is complete and no new fact arrives."""
    clock = asyncio.get_running_loop().time
    size, changed_at = tree.size, clock()
    while clock() < end:
        await asyncio.sleep(min(POLL_INTERVAL, end - clock()))
        if tree.size != size:
            if size == 0 or subsystem is None:
                _query_missing(connection, tree, subsystem)
            size, changed_at = tree.size, clock()
        elif subsystem is not None and tree.is_complete(subsystem) and clock() - changed_at >= QUIET_TIME:
            return True
    return False


def _is_complete(tree: SubsystemTree) -> bool:
    """True when something has answered, and all of it is known."""
    numbers = {member.subsystem for member in tree}
    return bool(numbers) and all(map(tree.is_complete, numbers))


def _query_missing(connection: Connection, tree: SubsystemTree, subsystem: int | None) -> None:
    """Query each component for what it has not reported, and one component of each node for the node's name."""
    numbers = tree.unfinished() if subsystem is None else [subsystem]
    queries: list[tuple[JausID, Message]] = []
    nodes: set[tuple[int, int]] = set()
    for id in (id for number in numbers for id in tree.unnamed(Level.NODE, number)):
        if tree.responds(id) and (id.subsystem, id.node) not in nodes:
            nodes.add((id.subsystem, id.node))
            queries.append((id, QueryIdentification(query_type=Level.NODE)))
    for level in (Level.SUBSYSTEM, Level.COMPONENT):
        identification = QueryIdentification(query_type=level)
        queries += [(id, identification) for number in numbers for id in tree.unnamed(level, number)]
    queries += [(id, query_all_services()) for number in numbers for id in tree.without_services(number)]
    for id, query in queries[:MAX_FOLLOW_UPS]:
        connection.send(id, query)


def _no_such_subsystem(subsystem: int, tree: SubsystemTree, timeout: float) -> str:
    others = ", ".join(map(str, sorted({member.subsystem for member in tree})))
    answered = f"of the others, {others} did answer" if others else "no other one answers either"
    return (
        f"subsystem {subsystem} did not answer QueryIdentification and QueryServices, sent to "
        f"{subsystem}.255.255 for {timeout:g} s ({answered}); start the robot, check its number and its node manager, "
        "or connect to that directly with connect='udp://HOST:PORT'"
    )


# --- continuously -----------------------------------------------------------------------------------------------------


async def watch(
    connection: Connection, subsystem: int | None, interval: float, silence: float, *, parts: bool
) -> AsyncIterator[News]:
    """Yield what is present, then every change; a slow reader gets the difference to what it read last.

    One event for each robot, or, with `parts`, for each subsystem, node, component and service.
    """
    check_number(subsystem, "a subsystem", whole=True, optional=True)
    check_number(interval, "interval")
    check_number(silence, "silence")
    if not 0 < interval < silence:
        raise ConfigError(f"interval {interval:g} s must be above 0, and silence {silence:g} s longer than that")
    if subsystem is not None and not 0 < subsystem < ANY_SUBSYSTEM:
        raise ConfigError(f"subsystem {subsystem} is outside 1..{ANY_SUBSYSTEM - 1}")
    clock, own_id = asyncio.get_running_loop().time, connection.id
    tree, received = SubsystemTree(connection.max_components), asyncio.Event()

    def on_report(message: Message, source: JausID) -> None:
        if source != own_id and subsystem in (None, source.subsystem):
            tree.add(message, source, clock())
            received.set()

    before: _Parts = {}
    robots = RobotNews(interval + COALESCE_TIME)
    query_at, expire_at, probe_at = clock(), -math.inf, clock()
    follow_ups, follow_up_at, renewals = FollowUps(connection, tree), math.inf, Renewals(connection, tree)
    kinds = (ReportIdentification, ReportServices, ReportHeartbeatPulse)
    with connection.replies.listening(EVERYONE, on_report, *kinds):
        while True:
            if clock() >= query_at:
                if clock() > query_at + interval:  # the reader was slow, so nobody was queried: silence means nothing
                    expire_at = clock() + silence
                services = () if renewals.is_needed else (query_all_services(),)
                _broadcast(connection, subsystem, _NAME, *services, QueryHeartbeatPulse())
                follow_up_at = follow_ups.send(clock())
                query_at = clock() + interval
            if clock() >= probe_at:
                for id in tree.silent_since(clock() - interval)[:MAX_FOLLOW_UPS]:
                    connection.send(id, QueryHeartbeatPulse())
                renewals.send()
                probe_at = clock() + interval / PROBES_PER_INTERVAL
            if clock() >= expire_at:
                since = clock() - silence
                tree.expire(since, since - renewals.rounds * interval / PROBES_PER_INTERVAL)
            if parts:
                now = _parts(tree.subsystems(clock()))
                for appearance in _differences(before, now):
                    yield appearance
                before = now
            else:
                for difference in robots.update(tree.subsystems(clock()), tree.is_complete, clock()):
                    yield _news(difference)
            wake_at = min(query_at, probe_at, tree.next_introduction(clock()) or query_at, robots.next_at() or query_at)
            if await _next_reports(received, max(min(wake_at, follow_up_at), clock() + MIN_PAUSE)) or (
                clock() >= follow_up_at
            ):
                follow_up_at = follow_ups.send(clock())


async def _next_reports(received: asyncio.Event, until: float) -> bool:
    """Wait until `until` for a report, and then a little for those that follow; true when there was one."""
    with suppress(TimeoutError):
        async with asyncio.timeout_at(until):
            await received.wait()
            await asyncio.sleep(COALESCE_TIME)
    found = received.is_set()
    received.clear()
    return found


def _news(difference: Difference) -> News:
    before, now = difference.before, difference.now
    if now is None:
        assert before is not None
        return Vanished(JausID(before.id, 0, 0), before)
    id = JausID(now.id, 0, 0)
    return Appeared(id, now) if before is None else Changed(id, before, now)


def _parts(subsystems: tuple[SubsystemInfo, ...]) -> _Parts:
    """All parts of these subsystems, each after the one that it is part of."""
    found: _Parts = {}
    for subsystem in subsystems:
        found[JausID(subsystem.id, 0, 0), None] = subsystem
        for node in subsystem.nodes:
            found[JausID(subsystem.id, node.id, 0), None] = node
            for component in node.components:
                found[component.id, None] = component
                found |= {(component.id, service): service for service in component.services}
    return found


def _differences(before: _Parts, now: _Parts) -> Iterator[News]:
    """Parts vanish before, and appear after, the one that they are part of."""
    for key in reversed(before):
        if key not in now:
            yield Vanished(key[0], before[key])
    for key, part in now.items():
        if key not in before:
            yield Appeared(key[0], part)
        elif _name_and_type(part) != _name_and_type(before[key]):
            yield Changed(key[0], before[key], part)


def _name_and_type(part: SubsystemPart) -> tuple[str, int] | None:
    """Compare a part itself; changes of its own parts are yielded for those."""
    return None if isinstance(part, ServiceInfo) else (part.name, part.type)


# --- queries of both --------------------------------------------------------------------------------------------------


def _broadcast(connection: Connection, subsystem: int | None, *queries: Message) -> None:
    """Send queries to all components of one subsystem, or of all."""
    destination = JausID(ANY_SUBSYSTEM if subsystem is None else subsystem, ANY_NODE, ANY_COMPONENT)
    for query in queries:
        connection.send(destination, query, broadcast=Broadcast.GLOBAL)


@dataclass(frozen=True, slots=True)
class Difference:
    """A robot before and now; None when it was not, or is not, there."""

    before: SubsystemInfo | None
    now: SubsystemInfo | None


@dataclass(slots=True)
class _Pending:
    """A difference that is not reported yet: how the robot is now, since when, and when it is due."""

    now: SubsystemInfo | None
    first: float
    """When the robot began to differ."""
    since: float
    due: float


class RobotNews:
    """Decides when a robot has appeared, changed or vanished.

    Times are seconds of a monotonic clock. When a robot is switched off, its components expire one after the other, up
    to `silence` seconds apart. Therefore a robot with fewer components is reported only when no further one expires
    within `silence`.
    """

    def __init__(self, silence: float) -> None:
        self._silence = silence
        self._reported: dict[int, SubsystemInfo] = {}
        self._pending: dict[int, _Pending] = {}

    def update(
        self, robots: tuple[SubsystemInfo, ...], is_complete: Callable[[int], bool], now: float
    ) -> Iterator[Difference]:
        """Queries that are due now."""
        current = {robot.id: robot for robot in robots}
        for id in sorted(self._reported.keys() | current.keys()):
            before, found = self._reported.get(id), current.get(id)
            if found is before or found == before:
                self._pending.pop(id, None)
            elif self._is_settled(id, found, is_complete(id), now):
                del self._pending[id]
                if found is None:
                    del self._reported[id]
                else:
                    self._reported[id] = found
                yield Difference(before, found)

    def next_at(self) -> float | None:
        """When to call `update` again; None when nothing is pending."""
        return min((pending.due for pending in self._pending.values()), default=None)

    def _is_settled(self, id: int, found: SubsystemInfo | None, complete: bool, now: float) -> bool:
        pending = self._pending.setdefault(id, _Pending(found, now, now, now))
        if pending.now != found:
            pending.now, pending.since = found, now
        if not complete and found is not None and id not in self._reported:
            pending.due = pending.first + MAX_INTRODUCTION
        else:
            pending.due = pending.since + self._wait(id, found)
        return now >= pending.due

    def _wait(self, id: int, found: SubsystemInfo | None) -> float:
        """Seconds that a difference must last."""
        before = self._reported.get(id)
        if found is None:
            return 0.0
        if before is None or {component.id for component in before.components} <= {
            component.id for component in found.components
        }:
            return ROBOT_QUIET_TIME
        return self._silence
