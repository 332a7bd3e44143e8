"""Finding subsystems, their nodes, components and services, by asking everybody and then each one."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

import asyncio
from itertools import count
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import ANY_COMPONENT, ANY_NODE, ANY_SUBSYSTEM, EVERYONE, JausID
from jauspy.messages.core import (
    QueriedComponentRec,
    QueriedNodeRec,
    QueryIdentification,
    QueryServices,
    ReportIdentification,
    ReportServices,
)
from jauspy.ocu.findings import Findings, Level
from jauspy.ocu.link import Link
from jauspy.ocu.model import Subsystem
from jauspy.protocol.header import Broadcast

ASK_AGAIN: Final = 0.5
"""Seconds between two rounds of questions."""
LOOK: Final = 0.05
"""Seconds between two looks at what has come in."""
QUIET: Final = 0.15
"""Seconds without news after which a picture seems to be complete."""
ROUNDS: Final = 2
"""How often everybody is asked before that is believed: the questions to a component, or its answers, may get lost."""
MAX_FOLLOW_UPS: Final = 64
"""Questions to single components in one round, so that a flood of answers is not answered with a flood."""


async def discover(link: Link, subsystem: int, timeout: float) -> Subsystem:
    """The subsystem of this number as soon as it is known whole; raises `ResponseTimeout` when it does not answer."""
    check_number(subsystem, "a subsystem", whole=True)
    if not 0 < subsystem < ANY_SUBSYSTEM:
        raise ConfigError(f"subsystem {subsystem} is outside 1..{ANY_SUBSYSTEM - 1}")
    findings = await _search(link, subsystem, timeout)
    found = next((each for each in findings.subsystems() if each.id == subsystem), None)
    if found is None:
        raise ResponseTimeout(_nobody(subsystem, findings, timeout))
    return found


async def discover_all(link: Link, timeout: float) -> tuple[Subsystem, ...]:
    """Every subsystem that answers within `timeout` seconds, which are used whole."""
    return (await _search(link, None, timeout)).subsystems()


async def _search(link: Link, subsystem: int | None, timeout: float) -> Findings:
    check_number(timeout, "timeout")
    if not timeout > 0:
        raise ConfigError(f"timeout {timeout} s must be above 0")
    findings, myself = Findings(), link.id

    def heard(message: Message, source: JausID) -> None:
        if source != myself:
            findings.add(message, source)

    clock = asyncio.get_running_loop().time
    end = clock() + timeout
    with link.replies.tapped(EVERYONE, heard, ReportIdentification, ReportServices):
        for asked in count(1):
            ask_everybody(link, subsystem)
            _follow_up(link, findings, subsystem)
            settled = await _settled(findings, subsystem, min(end, clock() + ASK_AGAIN), link)
            if (settled and asked >= ROUNDS) or clock() >= end:
                break
    return findings


async def _settled(findings: Findings, subsystem: int | None, end: float, link: Link) -> bool:
    """Wait for answers until `end`; true as soon as the subsystem is known whole and nothing more comes."""
    clock = asyncio.get_running_loop().time
    known, news_at = len(findings), clock()
    while clock() < end:
        await asyncio.sleep(min(LOOK, end - clock()))
        if len(findings) != known:
            if known == 0 or subsystem is None:
                _follow_up(link, findings, subsystem)
            known, news_at = len(findings), clock()
        elif subsystem is not None and findings.is_complete(subsystem) and clock() - news_at >= QUIET:
            return True
    return False


def ask_everybody(link: Link, subsystem: int | None) -> JausID:
    """Ask who everybody is, or everybody in one subsystem, and what they offer; the address that reaches them."""
    number = ANY_SUBSYSTEM if subsystem is None else subsystem
    everybody = JausID(number, ANY_NODE, ANY_COMPONENT)
    for question in (QueryIdentification(query_type=Level.SUBSYSTEM), all_services()):
        link.send(everybody, question, broadcast=Broadcast.GLOBAL)
    return everybody


def _follow_up(link: Link, findings: Findings, subsystem: int | None) -> None:
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
    asked += [(id, all_services()) for id in findings.mute(subsystem)]
    for id, question in asked[:MAX_FOLLOW_UPS]:
        link.send(id, question)


def all_services() -> QueryServices:
    """The question for all services of all components."""
    return QueryServices(
        node_list=[
            QueryServices.NodeSeq(
                node_rec=QueriedNodeRec(node_id=ANY_NODE),
                component_list=[QueriedComponentRec(component_id=ANY_COMPONENT)],
            )
        ]
    )


def _nobody(subsystem: int, findings: Findings, timeout: float) -> str:
    others = sorted({each.subsystem for each in findings.components()})
    answered = f"subsystems {', '.join(map(str, others))} did" if others else "nobody else did either"
    return (
        f"subsystem {subsystem} did not answer QueryIdentification and QueryServices, sent to "
        f"{subsystem}.255.255 for {timeout:g} s ({answered}); start the robot, check its number and its node manager, "
        "or connect to that directly with connect='udp://HOST:PORT'"
    )
