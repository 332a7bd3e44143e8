"""Subsystems, their nodes, components and services: frozen values, and the tree that merges what components report."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import groupby, islice
from operator import attrgetter
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID, is_called
from jauspy.messages.core import QueryIdentification, ReportIdentification, ReportServices
from jauspy.printable import printable

Level: TypeAlias = QueryIdentification.QueryType
_LEVELS: Final = frozenset(map(int, Level))
_NAMED: Final = (Level.SUBSYSTEM, Level.NODE, Level.COMPONENT)
"""Levels at which a component has a name that is shown."""

MAX_COMPONENTS: Final = 4096
"""Components that a tree holds, and silent ones that it remembers; a flood of invented ids cannot exceed it."""
SERVICES_PER_COMPONENT: Final = 16
"""Services that a tree holds on average; a component whose report does not fit any more is shown without them."""
MAX_SERVICES_OF_COMPONENT: Final = 256
INTRODUCTION_TIME: Final = 1.0
"""Seconds that a new component has for reporting its names and services before it is shown without them."""


PROFILES: Final = ("urn:jaus:jss:iop:", "urn:jaus:jss:exp:")
"""Beginnings of URNs of profiles, some of whose services are called as those of the standards are."""


@dataclass(frozen=True, slots=True, order=True)
class ServiceInfo:
    """A service that a component offers: its URN, and the version as `"1.1"`."""

    urn: str
    version: str

    def is_called(self, name: str) -> bool:
        """True for the whole URN or its end: `mobility:PrimitiveDriver`, `PrimitiveDriver`; case is ignored."""
        return is_called(self.urn, name)

    @property
    def short(self) -> str:
        """The URN without the prefix `urn:jaus:jss:` of the standard services."""
        return printable(self.urn.removeprefix("urn:jaus:jss:"))

    def __str__(self) -> str:
        return f"{self.short} {self.version}"


@dataclass(frozen=True, slots=True)
class ComponentInfo:
    """A component; `name` and `type` are as it reports them, empty and 0 when it does not."""

    id: JausID
    name: str = ""
    type: int = 0
    services: tuple[ServiceInfo, ...] = ()

    @property
    def kind(self) -> str:
        """The name of the type."""
        return kind_of(self.type)

    def find(self, name: str) -> ServiceInfo | None:
        """The newest version of the service of this name; None when the component does not offer it.

        Of services that are called the same, those of the standards precede those of profiles (IOP, AEODRS).
        """
        called = (service for service in self.services if service.is_called(name))
        return max(called, default=None, key=lambda service: (not service.urn.startswith(PROFILES), service))


@dataclass(frozen=True, slots=True)
class NodeInfo:
    """A node (a computer) of a subsystem."""

    id: int
    name: str = ""
    type: int = 0
    components: tuple[ComponentInfo, ...] = ()


@dataclass(frozen=True, slots=True)
class SubsystemInfo:
    """A robot, an operator control unit or another unit that can operate independently."""

    id: int
    name: str = ""
    type: int = 0
    nodes: tuple[NodeInfo, ...] = ()

    @property
    def kind(self) -> str:
        """The name of the type."""
        return kind_of(self.type)

    @property
    def components(self) -> tuple[ComponentInfo, ...]:
        """The components of all nodes, in the order of their ids."""
        return tuple(component for node in self.nodes for component in node.components)

    def offering(self, name: str) -> Iterator[ComponentInfo]:
        """The components that offer a service of this name."""
        return (component for component in self.components if component.find(name))


def kind_of(type: int) -> str:
    """The meaning of a type number of ReportIdentification; a number between two named types is of the lower kind."""
    if type <= 0:
        return "unknown"
    named = max((kind for kind in ReportIdentification.Type if kind <= type), default=None)
    if not named:
        return f"type {type}"
    return "OCU" if named is ReportIdentification.Type.OCU else named.name.lower().replace("_", " ")


@dataclass(slots=True)
class _Entry:
    """One component; times are seconds of a monotonic clock."""

    id: JausID
    first_seen: float
    last_seen: float
    responds: bool = False
    """True when it has sent a message itself; from then on, reports by others do not keep it alive."""
    services: dict[JausID, frozenset[ServiceInfo]] = field(default_factory=dict)
    """Services by the component that reported them."""

    @property
    def offered(self) -> frozenset[ServiceInfo]:
        """The services that it reports itself, or, until it does, those that others report for it."""
        return self.services.get(self.id) or frozenset().union(*self.services.values())

    @property
    def facts(self) -> int:
        """How many facts are known: that it is there, that it responds, and its services."""
        return 1 + self.responds + len(self.offered)


class SubsystemTree:
    """Grows with `add` and shrinks with `expire`; `subsystems` returns what is known as frozen values.

    It holds `max_components`, and in all `SERVICES_PER_COMPONENT` times as many services.
    """

    def __init__(self, max_components: int = MAX_COMPONENTS) -> None:
        self._max_components = max_components
        self._entries: dict[JausID, _Entry] = {}
        self._members: dict[int, dict[JausID, _Entry]] = {}
        """The same entries by subsystem."""
        self._ordered: dict[int, list[JausID]] = {}
        """Their ids in order, of subsystems that were looked at since their last component came or went."""
        self._facts = 0
        self._built: dict[int, tuple[SubsystemInfo | None, float]] = {}
        """Values of subsystems, and until when they hold unless something about them changes."""
        self._names: dict[tuple[int, JausID], tuple[str, int]] = {}
        self._unfinished: set[int] = set()
        """Subsystems of which names or services may be missing."""
        self._introductions: deque[float] = deque()
        """When the `INTRODUCTION_TIME` of each new component ends."""
        self._services = 0
        """Number of services of all entries."""
        self._heard = self._listed = math.inf
        """Times before which none that has responded was seen last, and none that others have listed."""
        self._silent: dict[JausID, None] = {}
        """Components that responded once and fell silent; other components may still list them."""

    def __iter__(self) -> Iterator[JausID]:
        """The known components, in the order of their ids."""
        return iter(self.components())

    def components(self, subsystem: int | None = None) -> list[JausID]:
        """The known components in the order of their ids: all, or those of one subsystem."""
        if subsystem is None:
            return sorted(self._entries, key=int)
        if (found := self._ordered.get(subsystem)) is None:
            found = self._ordered[subsystem] = sorted(self._members.get(subsystem, {}), key=int)
        return found

    @property
    def component_count(self) -> int:
        """The number of known components."""
        return len(self._entries)

    @property
    def size(self) -> int:
        """The number of known facts: components, responses, services and names. It grows with every new fact."""
        return self._facts

    def add(self, message: Message, source: JausID, now: float) -> None:
        """Merge a message from `source`; a message that is no report only shows that the component is alive."""
        self._silent.pop(source, None)
        entry = self._entry(source, now)
        if entry is None:
            return
        self._facts += not entry.responds
        entry.last_seen, entry.responds = now, True
        self._heard = min(self._heard, now)
        if isinstance(message, ReportIdentification):
            if (level := int(message.query_type)) in _LEVELS:
                self._set_name(level, name_owner(level, source), (message.identification, int(message.type)))
        elif isinstance(message, ReportServices):
            for id, services in offered_services(message, source).items():
                self._add_services(id, services, source, now)

    def expire(self, before: float, listed_before: float | None = None) -> None:
        """Remove the components that were last seen before this time, and what they reported of others.

        `listed_before`: the time for those that have sent nothing themselves, and were listed by others.
        """
        listed = before if listed_before is None else listed_before
        if self._heard >= before and self._listed >= listed:
            return
        silent = {id for id, entry in self._entries.items() if entry.last_seen < (before if entry.responds else listed)}
        for id in silent:
            members = self._members[id.subsystem]
            del members[id]
            if not members:
                del self._members[id.subsystem]
            if self._entries.pop(id).responds:
                self._silent[id] = None
        self._heard, self._listed = (
            min((entry.last_seen for entry in self._entries.values() if entry.responds is responds), default=math.inf)
            for responds in (True, False)
        )
        while len(self._silent) > self._max_components:
            del self._silent[next(iter(self._silent))]
        if silent:
            for entry in self._entries.values():
                entry.services = {
                    source: services for source, services in entry.services.items() if source not in silent
                }
            self._services = sum(
                len(services) for entry in self._entries.values() for services in entry.services.values()
            )
            named = {name_owner(level, id) for id in self._entries for level in Level}
            self._names = {key: name for key, name in self._names.items() if key[1] in named}
            self._facts = len(self._names) + sum(entry.facts for entry in self._entries.values())
            self._built.clear()
            self._ordered.clear()
            self._unfinished = set(self._members)

    # --- what is missing ------------------------------------------------------------------------------------------

    def responds(self, id: JausID) -> bool:
        """True when this component has sent a message itself."""
        return self._entries[id].responds

    def unfinished(self) -> list[int]:
        """Subsystems of which a name or services may be missing."""
        return sorted(self._unfinished)

    def unnamed(self, level: Level, subsystem: int) -> list[JausID]:
        """The components of a subsystem whose name at this level is not known, in the order of their ids."""
        named, value = self._names, int(level)
        return [id for id in self.components(subsystem) if (value, name_owner(level, id)) not in named]

    def without_services(self, subsystem: int) -> list[JausID]:
        """The components of a subsystem of which no service is known, in the order of their ids."""
        return [id for id in self.components(subsystem) if not self._entries[id].offered]

    def _incomplete(self, number: int) -> set[JausID]:
        """The components of a subsystem of which a name or services are missing."""
        found = {id for level in _NAMED for id in self.unnamed(level, number)}.union(self.without_services(number))
        if not found:
            self._unfinished.discard(number)
        return found

    def _has_changed(self, number: int) -> None:
        """Look at a subsystem again: something of it is new."""
        self._built.pop(number, None)
        self._unfinished.add(number)

    def silent_since(self, since: float) -> list[JausID]:
        """The components that were last seen before this time."""
        return sorted((id for id, entry in self._entries.items() if entry.last_seen < since), key=int)

    def is_complete(self, subsystem: int) -> bool:
        """True when names and services of the subsystem, and of each component that responds, are known."""
        if subsystem not in self._unfinished:
            return subsystem in self._members
        return bool(
            not self.unnamed(Level.SUBSYSTEM, subsystem)
            and not any(map(self.responds, self.unnamed(Level.COMPONENT, subsystem)))
            and not self.without_services(subsystem)
        )

    def next_introduction(self, now: float) -> float | None:
        """When the next `INTRODUCTION_TIME` of a new component ends; None when there is no new component."""
        while self._introductions and self._introductions[0] <= now:
            self._introductions.popleft()
        return self._introductions[0] if self._introductions else None

    # --- what is known --------------------------------------------------------------------------------------------

    def subsystems(self, now: float = math.inf) -> tuple[SubsystemInfo, ...]:
        """Everything known as values, but components that at `now` may still be reporting their names and services."""
        found = (self._built_at(number, now) for number in sorted(self._members))
        return tuple(subsystem for subsystem in found if subsystem is not None)

    def _built_at(self, number: int, now: float) -> SubsystemInfo | None:
        """The value of a subsystem; None while no component of it is shown."""
        built, until = self._built.get(number, (None, -math.inf))
        if now < until:
            return built
        incomplete = self._incomplete(number)
        shown, until = [], math.inf
        for id in self.components(number):
            introduced = self._entries[id].first_seen + INTRODUCTION_TIME
            if id not in incomplete or now >= introduced:
                shown.append(self._component(id))
            else:
                until = min(until, introduced)
        built = self._subsystem(number, shown) if shown else None
        self._built[number] = built, until
        return built

    def _subsystem(self, number: int, components: list[ComponentInfo]) -> SubsystemInfo:
        nodes = tuple(
            self._node(node, tuple(members)) for node, members in groupby(components, key=attrgetter("id.node"))
        )
        return SubsystemInfo(number, *self._name(Level.SUBSYSTEM, components[0].id), nodes)

    def _node(self, number: int, components: tuple[ComponentInfo, ...]) -> NodeInfo:
        return NodeInfo(number, *self._name(Level.NODE, components[0].id), components)

    def _component(self, id: JausID) -> ComponentInfo:
        return ComponentInfo(id, *self._name(Level.COMPONENT, id), tuple(sorted(self._entries[id].offered)))

    def _name(self, level: Level, id: JausID) -> tuple[str, int]:
        return self._names.get((int(level), name_owner(level, id)), ("", 0))

    def _entry(self, id: JausID, now: float) -> _Entry | None:
        """The entry of a component, new if need be; None when the tree is full."""
        if id not in self._entries and len(self._entries) >= self._max_components:
            return None
        entry = self._entries.get(id)
        if entry is None:
            entry = self._entries[id] = _Entry(id, now, now)
            self._members.setdefault(id.subsystem, {})[id] = entry
            self._facts += 1
            self._ordered.pop(id.subsystem, None)
            self._introductions.append(now + INTRODUCTION_TIME)
            self._listed = min(self._listed, now)
            self._has_changed(id.subsystem)
        return entry

    def _set_name(self, level: int, owner: JausID, name: tuple[str, int]) -> None:
        known = self._names.get((level, owner))
        if known != name:
            self._facts += known is None
            self._names[level, owner] = name
            self._has_changed(owner.subsystem)

    def _add_services(self, id: JausID, services: frozenset[ServiceInfo], source: JausID, now: float) -> None:
        entry = None if id in self._silent else self._entry(id, now)
        if entry is not None:
            services = frozenset(islice(services, MAX_SERVICES_OF_COMPONENT))
            more = len(services) - len(entry.services.get(source, ()))
            is_new = entry.services.get(source) != services
            if is_new and self._services + more <= SERVICES_PER_COMPONENT * self._max_components:
                before = entry.facts
                entry.services[source] = services
                self._services += more
                self._facts += entry.facts - before
                self._has_changed(id.subsystem)
            if not entry.responds:
                entry.last_seen = now


def offered_services(report: ReportServices, source: JausID) -> dict[JausID, frozenset[ServiceInfo]]:
    """The services that a report lists, by component."""
    found: dict[JausID, frozenset[ServiceInfo]] = {}
    for node in report.node_list:
        for record in node.component_list:
            # Some small robots report the ids 0: these stand for the sender's own.
            numbers = (node.node_rec.node_id or source.node, record.component_rec.component_id or source.component)
            id = JausID(source.subsystem, *numbers)
            if not id.is_wildcard:
                found[id] = found.get(id, frozenset()) | {
                    ServiceInfo(service.uri, f"{service.major_version_number}.{service.minor_version_number}")
                    for service in record.service_list
                }
    return found


def name_owner(level: int, id: JausID) -> JausID:
    """The id that a name at this level belongs to: all components of a subsystem share the subsystem's name."""
    if level <= Level.SUBSYSTEM:
        return JausID(id.subsystem, 0, 0)
    return JausID(id.subsystem, id.node, 0) if level == Level.NODE else id


def choose_sensor(
    sensors: Iterable[tuple[ComponentInfo, int, str]], name: str | None, kind: str
) -> tuple[ComponentInfo, int]:
    """The component and number of the sensor with a name; of the only one for None. `kind` is "camera" or "lidar".

    Sensors without a name of their own are named by component and number. Raises `ConfigError` with the names.
    """
    known: dict[str, tuple[ComponentInfo, int]] = {}
    for component, number, own_name in sensors:
        key = own_name if own_name and own_name not in known else f"{component.id} sensor {number}"
        known[key] = component, number
    if name is None and len(known) == 1:
        return next(iter(known.values()))
    if name is not None and name in known:
        return known[name]
    wanted = f"which {kind} is meant" if name is None else f"there is no {kind} {name!r}"
    raise ConfigError(
        f"{wanted}? This robot has {', '.join(map(repr, known))}, as in robot.{kind}({next(iter(known))!r})"
    )
