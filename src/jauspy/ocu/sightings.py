"""Who is there now: what discovery heard, and when, so that the silent can be forgotten."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import ReportIdentification, ReportServices
from jauspy.ocu.findings import MAX_COMPONENTS, Level, at_level, offers
from jauspy.ocu.model import Component, Node, ServiceInfo, Subsystem

SETTLE: Final = 1.0
"""Seconds that a newcomer has to introduce itself before it is reported as it is."""


@dataclass(slots=True)
class _Seen:
    """One component."""

    since: float
    at: float
    answers: bool = False
    """It has spoken itself; from then on what others say of it is no sign of life."""
    services: dict[JausID, frozenset[ServiceInfo]] = field(default_factory=dict)
    """By who said so."""

    @property
    def offered(self) -> frozenset[ServiceInfo]:
        return frozenset().union(*self.services.values())


class Sightings:
    """Grows with `add`, shrinks with `expire`; bounded like `Findings`."""

    def __init__(self) -> None:
        self._seen: dict[JausID, _Seen] = {}
        self._names: dict[tuple[int, JausID], tuple[str, int]] = {}
        self._gone: dict[JausID, None] = {}
        """Components that answered once and fell silent: a directory may still list them."""

    def add(self, message: Message, source: JausID, now: float) -> None:
        """Take a message from `source`, whatever it says."""
        self._gone.pop(source, None)
        seen = self._known(source, now)
        if seen is None:
            return
        seen.at, seen.answers = now, True
        if isinstance(message, ReportIdentification):
            level = int(message.query_type)
            self._names[level, at_level(level, source)] = (message.identification, int(message.type))
        elif isinstance(message, ReportServices):
            for id, services in offers(message, source).items():
                self._list(id, services, source, now)

    def _list(self, id: JausID, services: frozenset[ServiceInfo], source: JausID, now: float) -> None:
        seen = None if id in self._gone else self._known(id, now)
        if seen is not None:
            seen.services[source] = services
            if not seen.answers:
                seen.at = now

    def expire(self, before: float) -> None:
        """Forget those of whom nothing was heard since then, and what they said."""
        silent = {id for id, seen in self._seen.items() if seen.at < before}
        for id in silent:
            if self._seen.pop(id).answers:
                self._gone[id] = None
        for id in silent:
            for seen in self._seen.values():
                seen.services.pop(id, None)
        while len(self._gone) > MAX_COMPONENTS:
            del self._gone[next(iter(self._gone))]
        if silent:
            named = {at_level(level, id) for id in self._seen for level in Level}
            self._names = {key: name for key, name in self._names.items() if key[1] in named}

    def __iter__(self) -> Iterator[JausID]:
        """Everybody known, in order."""
        return iter(sorted(self._seen))

    def unknown(self, level: Level, since: float = -math.inf) -> list[JausID]:
        """Those whose name at this level is not known, of all or of those who are known only since then."""
        return [id for id in self if self._seen[id].since >= since and (level, at_level(level, id)) not in self._names]

    def mute(self, since: float = -math.inf) -> list[JausID]:
        """Those of whom no service is known, of all or of those who are known only since then."""
        return [id for id in self if self._seen[id].since >= since and not self._seen[id].offered]

    def silent(self, since: float) -> list[JausID]:
        """Those of whom nothing was heard since then."""
        return [id for id in self if self._seen[id].at < since]

    def next_settled(self, now: float) -> float | None:
        """When the next newcomer has had its time."""
        return min((seen.since + SETTLE for seen in self._seen.values() if seen.since + SETTLE > now), default=None)

    def subsystems(self, now: float) -> tuple[Subsystem, ...]:
        """Those who have introduced themselves, or have had the time to, as values."""
        unnamed = {id for level in (Level.SUBSYSTEM, Level.NODE, Level.COMPONENT) for id in self.unknown(level)}
        shown: dict[int, dict[int, list[Component]]] = {}
        for id in self:
            seen = self._seen[id]
            if now - seen.since < SETTLE and (id in unnamed or not seen.offered):
                continue
            component = Component(id, *self._name(Level.COMPONENT, id), tuple(sorted(seen.offered)))
            shown.setdefault(id.subsystem, {}).setdefault(id.node, []).append(component)
        return tuple(self._subsystem(number, nodes) for number, nodes in shown.items())

    def _known(self, id: JausID, now: float) -> _Seen | None:
        """What is known of it, from now on if nothing was; None when there are too many."""
        if id not in self._seen and len(self._seen) >= MAX_COMPONENTS:
            return None
        return self._seen.setdefault(id, _Seen(now, now))

    def _subsystem(self, number: int, nodes: dict[int, list[Component]]) -> Subsystem:
        any_id = next(iter(nodes.values()))[0].id
        return Subsystem(
            number,
            *self._name(Level.SUBSYSTEM, any_id),
            tuple(Node(node, *self._name(Level.NODE, own[0].id), tuple(own)) for node, own in nodes.items()),
        )

    def _name(self, level: Level, id: JausID) -> tuple[str, int]:
        return self._names.get((level, at_level(level, id)), ("", 0))
