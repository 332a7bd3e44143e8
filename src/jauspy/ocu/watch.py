"""What appears, changes and vanishes, as an endless async iterator."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import ANY_SUBSYSTEM, EVERYONE, JausID
from jauspy.messages.core import (
    QueryHeartbeatPulse,
    QueryIdentification,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportServices,
)
from jauspy.ocu.discovery import MAX_FOLLOW_UPS, all_services, ask_everybody
from jauspy.ocu.findings import Level
from jauspy.ocu.link import Link
from jauspy.ocu.model import Component, Node, ServiceInfo, Subsystem
from jauspy.ocu.sightings import SETTLE, Sightings
from jauspy.protocol.header import Broadcast

PROBES: Final = 4
"""How often in each interval those are asked who have not answered the question to all: packets get lost."""
QUIET: Final = 0.1
"""Seconds that news may wait for more of them."""

Thing: TypeAlias = Subsystem | Node | Component | ServiceInfo


@dataclass(frozen=True, slots=True)
class Appeared:
    """`now` is there; `id` is 101.0.0 for a subsystem, 101.1.0 for a node, and the component's for its services."""

    id: JausID
    now: Thing


@dataclass(frozen=True, slots=True)
class Changed:
    """A subsystem, node or component has another name or type."""

    id: JausID
    before: Thing
    now: Thing


@dataclass(frozen=True, slots=True)
class Vanished:
    """It was silent for too long, or, a service, is not offered any more."""

    id: JausID
    before: Thing


News: TypeAlias = Appeared | Changed | Vanished
_Key: TypeAlias = tuple[JausID, ServiceInfo | None]
_Picture: TypeAlias = dict[_Key, Thing]


async def watch(link: Link, subsystem: int | None, interval: float, silence: float) -> AsyncIterator[News]:
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
                _follow_up(link, sightings, -math.inf)
                ask_at = clock() + interval
            if clock() >= probe_at:
                for id in sightings.silent(clock() - interval)[:MAX_FOLLOW_UPS]:
                    link.send(id, QueryHeartbeatPulse())
                probe_at = clock() + interval / PROBES
            if clock() >= judge_at:
                sightings.expire(clock() - silence)
            now = _picture(sightings.subsystems(clock()))
            for each in _differences(told, now):
                yield each
            told = now
            if await _news(heard_something, min(ask_at, probe_at, sightings.next_settled(clock()) or ask_at)):
                _follow_up(link, sightings, clock() - SETTLE)


async def _news(heard_something: asyncio.Event, until: float) -> bool:
    """Wait for news, and a moment for what comes with them, no longer than `until`; true when there were some."""
    with suppress(TimeoutError):
        async with asyncio.timeout_at(until):
            await heard_something.wait()
            await asyncio.sleep(QUIET)
    found = heard_something.is_set()
    heard_something.clear()
    return found


def _ask_everybody(link: Link, subsystem: int | None) -> None:
    everybody = ask_everybody(link, subsystem)
    link.send(everybody, QueryHeartbeatPulse(), broadcast=Broadcast.GLOBAL)


def _follow_up(link: Link, sightings: Sightings, since: float) -> None:
    """Ask those who have not introduced themselves, of all or of the newcomers since then."""
    questions: list[tuple[JausID, Message]] = [(id, all_services()) for id in sightings.mute(since)]
    for level in (Level.COMPONENT, Level.NODE, Level.SUBSYSTEM):
        questions += [(id, QueryIdentification(query_type=level)) for id in sightings.unknown(level, since)]
    for id, question in questions[:MAX_FOLLOW_UPS]:
        link.send(id, question)


def _picture(subsystems: tuple[Subsystem, ...]) -> _Picture:
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


def _label(thing: Thing) -> tuple[str, int] | None:
    """What may change: of parts it is told by themselves."""
    return None if isinstance(thing, ServiceInfo) else (thing.name, thing.type)
