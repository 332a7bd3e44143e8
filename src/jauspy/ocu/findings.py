"""What answers during discovery, merged as it comes in."""

from __future__ import annotations

from itertools import groupby
from operator import attrgetter
from typing import TypeAlias

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification, ReportIdentification, ReportServices
from jauspy.ocu.model import Component, Node, ServiceInfo, Subsystem

Level: TypeAlias = QueryIdentification.QueryType
MAX_COMPONENTS = 4096
"""Components that are remembered; a flood of made-up ids ends here."""


class Findings:
    """Grows with `add`; the properties say what is still missing."""

    def __init__(self) -> None:
        self.responders: set[JausID] = set()
        self._services: dict[JausID, frozenset[ServiceInfo]] = {}
        self._names: dict[tuple[int, JausID], tuple[str, int]] = {}

    def __len__(self) -> int:
        """The number of facts; it grows with everything that is new."""
        return len(self.responders) + len(self._names) + sum(1 + len(each) for each in self._services.values())

    def add(self, message: Message, source: JausID) -> None:
        """Take a report from `source`."""
        if source not in self._services and len(self._services) >= MAX_COMPONENTS:
            return
        self.responders.add(source)
        self._services.setdefault(source, frozenset())
        if isinstance(message, ReportIdentification):
            key = (int(message.query_type), at_level(int(message.query_type), source))
            self._names[key] = (message.identification, int(message.type))
        elif isinstance(message, ReportServices):
            self._add_services(message, source)

    def _add_services(self, report: ReportServices, source: JausID) -> None:
        for id, offered in offers(report, source).items():
            if id in self._services or len(self._services) < MAX_COMPONENTS:
                self._services[id] = self._services.get(id, frozenset()) | offered

    def components(self, subsystem: int | None = None) -> list[JausID]:
        """The components known so far, in order."""
        return sorted(each for each in self._services if subsystem in (None, each.subsystem))

    def unnamed(self, level: Level, subsystem: int | None = None) -> list[JausID]:
        """Components whose name at this level is not known yet."""
        ids = self.components(subsystem)
        return [each for each in ids if (int(level), at_level(int(level), each)) not in self._names]

    def mute(self, subsystem: int | None = None) -> list[JausID]:
        """Components of which no service is known."""
        return [each for each in self.components(subsystem) if not self._services[each]]

    def is_complete(self, subsystem: int) -> bool:
        """True when the subsystem, and each component that answers at all, has said everything."""
        ids = self.components(subsystem)
        silent = set(ids) - self.responders
        return bool(
            ids
            and not self.unnamed(Level.SUBSYSTEM, subsystem)
            and not set(self.unnamed(Level.COMPONENT, subsystem)) - silent
            and not self.mute(subsystem)
        )

    def subsystems(self) -> tuple[Subsystem, ...]:
        """Everything known, as values."""
        return tuple(
            self._subsystem(number, list(ids))
            for number, ids in groupby(self.components(), key=attrgetter("subsystem"))
        )

    def _subsystem(self, number: int, ids: list[JausID]) -> Subsystem:
        name, type = self._name(Level.SUBSYSTEM, ids[0])
        nodes = tuple(self._node(node, list(own)) for node, own in groupby(ids, key=attrgetter("node")))
        return Subsystem(number, name, type, nodes)

    def _node(self, number: int, ids: list[JausID]) -> Node:
        name, type = self._name(Level.NODE, ids[0])
        return Node(number, name, type, tuple(map(self._component, ids)))

    def _component(self, id: JausID) -> Component:
        name, type = self._name(Level.COMPONENT, id)
        return Component(id, name, type, tuple(sorted(self._services[id])))

    def _name(self, level: Level, id: JausID) -> tuple[str, int]:
        return self._names.get((int(level), at_level(int(level), id)), ("", 0))


def offers(report: ReportServices, source: JausID) -> dict[JausID, frozenset[ServiceInfo]]:
    """The services that a report tells of, by component."""
    found: dict[JausID, frozenset[ServiceInfo]] = {}
    for node in report.node_list:
        for each in node.component_list:
            # Small robots call themselves 0: whoever answers means itself by that.
            numbers = (node.node_rec.node_id or source.node, each.component_rec.component_id or source.component)
            id = JausID(source.subsystem, *numbers)
            if not id.is_wildcard:
                found[id] = found.get(id, frozenset()) | {
                    ServiceInfo(service.uri, f"{service.major_version_number}.{service.minor_version_number}")
                    for service in each.service_list
                }
    return found


def at_level(level: int, id: JausID) -> JausID:
    """What a name at this level belongs to: all components of a subsystem share its name."""
    if level <= Level.SUBSYSTEM:
        return JausID(id.subsystem, 0, 0)
    return JausID(id.subsystem, id.node, 0) if level == Level.NODE else id
