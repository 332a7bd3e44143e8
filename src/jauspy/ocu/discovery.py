"""Finding subsystems, their nodes, components and services, by asking everybody and then each one."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import count
from typing import Final, TypeAlias

from jauspy.arguments import check_number
from jauspy.codec.base import Message
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import ANY_COMPONENT, ANY_NODE, ANY_SUBSYSTEM, EVERYONE, JausID
from jauspy.messages.core import (
    QueriedComponentRec,
    QueriedNodeRec,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryServices,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportServices,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.sightings import INTRODUCTION_TIME, Sightings
from jauspy.ocu.subsystems import ComponentInfo, Level, NodeInfo, ServiceInfo, SubsystemInfo, SubsystemTree
from jauspy.protocol.header import Broadcast

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom


ROUND_INTERVAL: Final = 0.5
"""Seconds between two rounds of questions."""
POLL_INTERVAL: Final = 0.05
"""Seconds between two looks at what has come in."""
QUIET_TIME: Final = 0.15
"""Seconds without news after which a picture seems to be complete."""
ROUNDS: Final = 2
"""How often everybody is asked before that is believed: the questions to a component, or its answers, may get lost."""
MAX_FOLLOW_UPS: Final = 64
"""Questions to single components in one round, so that a flood of answers is not answered with a flood."""


async def discover(link: Connection, subsystem: int, timeout: float) -> SubsystemInfo:
    """The subsystem of this number as soon as it is known whole; raises `ResponseTimeout` when it does not answer."""
    check_number(subsystem, "a subsystem", whole=True)
    if not 0 < subsystem < ANY_SUBSYSTEM:
        raise ConfigError(f"subsystem {subsystem} is outside 1..{ANY_SUBSYSTEM - 1}")
    findings = await _search(link, subsystem, timeout)
    found = next((each for each in findings.subsystems() if each.id == subsystem), None)
    if found is None:
        raise ResponseTimeout(_nobody(subsystem, findings, timeout))
    return found


async def discover_all(link: Connection, timeout: float) -> tuple[SubsystemInfo, ...]:
    """Every subsystem that answers within `timeout` seconds, which are used whole."""
    return (await _search(link, None, timeout)).subsystems()


async def _search(link: Connection, subsystem: int | None, timeout: float) -> SubsystemTree:
    check_number(timeout, "timeout")
    if not timeout > 0:
        raise ConfigError(f"timeout {timeout} s must be above 0")
    findings, myself = SubsystemTree(), link.id

    def heard(message: Message, source: JausID) -> None:
        if source != myself:
            findings.add(message, source)

    clock = asyncio.get_running_loop().time
    end = clock() + timeout
    with link.replies.tapped(EVERYONE, heard, ReportIdentification, ReportServices):
        for asked in count(1):
            query_everybody(link, subsystem)
            _follow_up(link, findings, subsystem)
            settled = await _settled(findings, subsystem, min(end, clock() + ROUND_INTERVAL), link)
            if (settled and asked >= ROUNDS) or clock() >= end:
                break
    return findings


async def _settled(findings: SubsystemTree, subsystem: int | None, end: float, link: Connection) -> bool:
    """Wait for answers until `end`; true as soon as the subsystem is known whole and nothing more comes."""
    clock = asyncio.get_running_loop().time
    known, news_at = len(findings), clock()
    while clock() < end:
        await asyncio.sleep(min(POLL_INTERVAL, end - clock()))
        if len(findings) != known:
            if known == 0 or subsystem is None:
                _follow_up(link, findings, subsystem)
            known, news_at = len(findings), clock()
        elif subsystem is not None and findings.is_complete(subsystem) and clock() - news_at >= QUIET_TIME:
            return True
    return False


def query_everybody(link: Connection, subsystem: int | None) -> JausID:
    """Ask who everybody is, or everybody in one subsystem, and what they offer; the address that reaches them."""
    number = ANY_SUBSYSTEM if subsystem is None else subsystem
    everybody = JausID(number, ANY_NODE, ANY_COMPONENT)
    for question in (QueryIdentification(query_type=Level.SUBSYSTEM), query_all_services()):
        link.send(everybody, question, broadcast=Broadcast.GLOBAL)
    return everybody


def _follow_up(link: Connection, findings: SubsystemTree, subsystem: int | None) -> None:
    """Ask each component for what it has not said."""
    asked: list[tuple[JausID, Message]] = []
    nodes: set[tuple[int, int]] = set()
    for id in findings.unnamed(Level.NODE, subsystem):
        if id in findings.responders and (id.subsystem, id.node) not in nodes:
            nodes.add((id.subsystem, id.node))
            asked.append((id, QueryIdentification(query_type=Level.NODE)))
    asked += [
        (id, QueryIdentification(query_type=Level.SUBSYSTEM)) for id in findings.unnamed(Level.SUBSYSTEM, subsystem)
    ]
    asked += [
        (id, QueryIdentification(query_type=Level.COMPONENT)) for id in findings.unnamed(Level.COMPONENT, subsystem)
    ]
    asked += [(id, query_all_services()) for id in findings.mute(subsystem)]
    for id, question in asked[:MAX_FOLLOW_UPS]:
        link.send(id, question)


def query_all_services() -> QueryServices:
    """The question for all services of all components."""
    return QueryServices(
        node_list=[
            QueryServices.NodeSeq(
                node_rec=QueriedNodeRec(node_id=ANY_NODE),
                component_list=[QueriedComponentRec(component_id=ANY_COMPONENT)],
            )
        ]
    )


def _nobody(subsystem: int, findings: SubsystemTree, timeout: float) -> str:
    others = sorted({each.subsystem for each in findings.components()})
    answered = f"subsystems {', '.join(map(str, others))} did" if others else "nobody else did either"
    return (
        f"subsystem {subsystem} did not answer QueryIdentification and QueryServices, sent to "
        f"{subsystem}.255.255 for {timeout:g} s ({answered}); start the robot, check its number and its node manager, "
        "or connect to that directly with connect='udp://HOST:PORT'"
    )


PROBES_PER_INTERVAL: Final = 4
"""How often in each interval those are asked who have not answered the question to all: packets get lost."""
COALESCE_TIME: Final = 0.1
"""Seconds that news may wait for more of them."""

Discovered: TypeAlias = SubsystemInfo | NodeInfo | ComponentInfo | ServiceInfo


@dataclass(frozen=True, slots=True)
class Appeared:
    """`now` is there; `id` is 101.0.0 for a subsystem, 101.1.0 for a node, and the component's for its services."""

    id: JausID
    now: Discovered


@dataclass(frozen=True, slots=True)
class Changed:
    """A subsystem, node or component has another name or type."""

    id: JausID
    before: Discovered
    now: Discovered


@dataclass(frozen=True, slots=True)
class Vanished:
    """It was silent for too long, or, a service, is not offered any more."""

    id: JausID
    before: Discovered


News: TypeAlias = Appeared | Changed | Vanished
_Key: TypeAlias = tuple[JausID, ServiceInfo | None]
_Picture: TypeAlias = dict[_Key, Discovered]


async def watch(link: Connection, subsystem: int | None, interval: float, silence: float) -> AsyncIterator[News]:
    """What is there at first, and then every change; what was not read in time is summed up, never piled up."""
    check_number(subsystem, "a subsystem", whole=True, optional=True)
    check_number(interval, "interval")
    check_number(silence, "silence")
    if not 0 < interval < silence:
        raise ConfigError(f"interval {interval:g} s must be above 0, and silence {silence:g} s longer than that")
    if subsystem is not None and not 0 < subsystem < ANY_SUBSYSTEM:
        raise ConfigError(f"subsystem {subsystem} is outside 1..{ANY_SUBSYSTEM - 1}")
    clock, myself = asyncio.get_running_loop().time, link.id
    sightings, heard_something = Sightings(), asyncio.Event()

    def heard(message: Message, source: JausID) -> None:
        if source != myself and subsystem in (None, source.subsystem):
            sightings.add(message, source, clock())
            heard_something.set()

    told: _Picture = {}
    ask_at, judge_at, probe_at = clock(), -math.inf, clock()
    with link.replies.tapped(EVERYONE, heard, ReportIdentification, ReportServices, ReportHeartbeatPulse):
        while True:
            if clock() >= ask_at:
                if clock() > ask_at + interval:  # the reader was slow, so nobody was asked, and silence says nothing
                    judge_at = clock() + silence
                _ask_everybody(link, subsystem)
                _query_missing(link, sightings, -math.inf)
                ask_at = clock() + interval
            if clock() >= probe_at:
                for id in sightings.silent(clock() - interval)[:MAX_FOLLOW_UPS]:
                    link.send(id, QueryHeartbeatPulse())
                probe_at = clock() + interval / PROBES_PER_INTERVAL
            if clock() >= judge_at:
                sightings.expire(clock() - silence)
            now = _picture(sightings.subsystems(clock()))
            for each in _differences(told, now):
                yield each
            told = now
            if await _wait_for_news(heard_something, min(ask_at, probe_at, sightings.next_settled(clock()) or ask_at)):
                _query_missing(link, sightings, clock() - INTRODUCTION_TIME)


async def _wait_for_news(heard_something: asyncio.Event, until: float) -> bool:
    """Wait for news, and a moment for what comes with them, no longer than `until`; true when there were some."""
    with suppress(TimeoutError):
        async with asyncio.timeout_at(until):
            await heard_something.wait()
            await asyncio.sleep(COALESCE_TIME)
    found = heard_something.is_set()
    heard_something.clear()
    return found


def _ask_everybody(link: Connection, subsystem: int | None) -> None:
    everybody = query_everybody(link, subsystem)
    link.send(everybody, QueryHeartbeatPulse(), broadcast=Broadcast.GLOBAL)


def _query_missing(link: Connection, sightings: Sightings, since: float) -> None:
    """Ask those who have not introduced themselves, of all or of the newcomers since then."""
    questions: list[tuple[JausID, Message]] = [(id, query_all_services()) for id in sightings.mute(since)]
    for level in (Level.COMPONENT, Level.NODE, Level.SUBSYSTEM):
        questions += [(id, QueryIdentification(query_type=level)) for id in sightings.unknown(level, since)]
    for id, question in questions[:MAX_FOLLOW_UPS]:
        link.send(id, question)


def _picture(subsystems: tuple[SubsystemInfo, ...]) -> _Picture:
    """Everything there is, the whole before its parts."""
    found: _Picture = {}
    for subsystem in subsystems:
        found[JausID(subsystem.id, 0, 0), None] = subsystem
        for node in subsystem.nodes:
            found[JausID(subsystem.id, node.id, 0), None] = node
            for component in node.components:
                found[component.id, None] = component
                found |= {(component.id, service): service for service in component.services}
    return found


def _differences(before: _Picture, now: _Picture) -> Iterator[News]:
    """Parts vanish before the whole, and appear after it."""
    for key in reversed(before):
        if key not in now:
            yield Vanished(key[0], before[key])
    for key, thing in now.items():
        if key not in before:
            yield Appeared(key[0], thing)
        elif _label(thing) != _label(before[key]):
            yield Changed(key[0], before[key], thing)


def _label(thing: Discovered) -> tuple[str, int] | None:
    """What may change: of parts it is told by themselves."""
    return None if isinstance(thing, ServiceInfo) else (thing.name, thing.type)
