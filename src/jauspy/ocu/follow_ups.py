"""Queries to single components of a fleet: for what is not known of them (`FollowUps`), and what may have changed."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator
from typing import Final, TypeAlias

from jauspy.ids import ANY_COMPONENT, ANY_NODE, JausID
from jauspy.messages.core import QueriedComponentRec, QueriedNodeRec, QueryIdentification, QueryServices
from jauspy.ocu.connection import Connection
from jauspy.ocu.subsystems import Level, SubsystemTree, name_owner

MAX_FOLLOW_UPS: Final = 64
"""Queries to single components in one round, so that a flood of answers does not cause a flood of queries."""
FOLLOW_UP_INTERVAL: Final = 1.0
"""Seconds after which `watch` asks a component again for what it has not reported; twice as many each time."""
MAX_FOLLOW_UP_INTERVAL: Final = 32.0
"""Seconds; some components never answer."""
COALESCE_TIME: Final = 0.1
"""Seconds that `watch` waits for further reports before it yields changes."""
MAX_BROADCAST: Final = 256
"""Components up to which `watch` asks all of them for their services in each interval; of more, some at each probe."""
_SERVICES: Final = 0
"""Stands for services beside the levels of names, which begin at 1."""

_Asked: TypeAlias = dict[tuple[int, JausID], tuple[int, float]]
"""How often a missing thing was asked for, and when again: names by level and owner, services by component."""


class FollowUps:
    """Queries of `watch` to single components for names and services that are not known."""

    def __init__(self, connection: Connection, tree: SubsystemTree) -> None:
        self._connection, self._tree = connection, tree
        self._asked: defaultdict[int, _Asked] = defaultdict(dict)
        """By subsystem."""

    def send(self, now: float) -> float:
        """Send those that are due, at most `MAX_FOLLOW_UPS`; returns the time of the next ones."""
        next_at, sent, unfinished = math.inf, 0, self._tree.unfinished()
        for number in unfinished:
            asked: _Asked = {}
            before = self._asked[number]
            for key, id in self._missing(number, before):
                count, due = before.get(key, (0, now))
                if due <= now and sent < MAX_FOLLOW_UPS:
                    level, _ = key
                    query = query_all_services() if level == _SERVICES else QueryIdentification(query_type=level)
                    self._connection.send(id, query)
                    due = now + min(FOLLOW_UP_INTERVAL * 2.0**count, MAX_FOLLOW_UP_INTERVAL)
                    count, sent = count + 1, sent + 1
                asked[key] = count, due
                next_at = min(next_at, max(due, now + COALESCE_TIME))
            self._asked[number] = asked
            if sent == MAX_FOLLOW_UPS:  # the others are not even looked at
                return now + COALESCE_TIME
        for number in self._asked.keys() - unfinished:
            del self._asked[number]
        return next_at

    def _missing(self, number: int, asked: _Asked) -> Iterator[tuple[tuple[int, JausID], JausID]]:
        """What is not known, with the component to ask: of those with a common name, another one each time."""
        for id in self._tree.without_services(number):
            yield (_SERVICES, id), id
        for level in (Level.COMPONENT, Level.NODE, Level.SUBSYSTEM):
            owners: dict[JausID, list[JausID]] = {}
            for id in self._tree.unnamed(level, number):
                owners.setdefault(name_owner(level, id), []).append(id)
            for owner, ids in owners.items():
                count, _ = asked.get((int(level), owner), (0, 0.0))
                yield (int(level), owner), ids[count % len(ids)]


class Renewals:
    """Queries of `watch` to single components for services that are known already, in turn, since they may change.

    For more than `MAX_BROADCAST` components, whose reports of all services in answer to a broadcast would fill a radio.
    """

    def __init__(self, connection: Connection, tree: SubsystemTree) -> None:
        self._connection, self._tree = connection, tree
        self._last = 0
        """The id that was asked last, as a number."""

    @property
    def is_needed(self) -> bool:
        """True if the components are too many to ask all of them at once."""
        return self._tree.component_count > MAX_BROADCAST

    @property
    def rounds(self) -> int:
        """Calls of `send` until each component has been asked; 0 if that is not needed."""
        return math.ceil(self._tree.component_count / MAX_FOLLOW_UPS) if self.is_needed else 0

    def send(self) -> None:
        """Ask the next `MAX_FOLLOW_UPS` components, if that is needed."""
        if not self.is_needed:
            return
        ids = self._tree.components()
        start = bisect_right(ids, self._last, key=int)
        chosen = [*ids[start:], *ids[:start]][:MAX_FOLLOW_UPS]
        for id in chosen:
            self._connection.send(id, query_all_services())
        self._last = int(chosen[-1])


def query_all_services() -> QueryServices:
    """The query for all services of all components."""
    return QueryServices(
        node_list=[
            QueryServices.NodeSeq(
                node_rec=QueriedNodeRec(node_id=ANY_NODE),
                component_list=[QueriedComponentRec(component_id=ANY_COMPONENT)],
            )
        ]
    )
