"""Discovery: components and the services that they offer (AS5710)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Set as AbstractSet
from dataclasses import dataclass
from functools import partial
from itertools import groupby, product
from operator import attrgetter
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from jauspy.errors import ConfigError
from jauspy.ids import ANY_COMPONENT, ANY_NODE, ANY_SUBSYSTEM, JausID, component_id
from jauspy.messages.core import (
    ComponentRec,
    QueryConfiguration,
    QueryIdentification,
    QueryServiceList,
    QueryServices,
    RegisterServices,
    ReportConfiguration,
    ReportIdentification,
    ReportServiceList,
    ReportServices,
    ReportSubsystemList,
    ServiceRec,
    SubsystemRec,
)
from jauspy.protocol.addressing import HERE, Location
from jauspy.services.definitions import OLDER_VERSION, answered_in_older_version
from jauspy.services.service import Service, ServiceHost

MAX_COMPONENTS: Final = 256
"""Other components that may be registered."""
MAX_SERVICES: Final = 64
"""Services of one component that are kept; a message can carry 255."""


AddressPattern: TypeAlias = tuple[int, int, int]
"""Subsystem, node and component; each may be a wildcard."""
SearchFilters: TypeAlias = AbstractSet[str]
"""Substrings of URIs."""


class OfferedService(NamedTuple):
    """A service a component offers."""

    uri: str
    major: int
    minor: int

    @property
    def size(self) -> int:
        """Bytes in a message: the URI, its length, two version numbers."""
        return len(self.uri) + 3


@dataclass(slots=True)
class _Registration:
    offers: tuple[OfferedService, ...]
    until: float


class Directory:
    """Services by component, each until some time (s). The own component does not expire, and always has room."""

    def __init__(self) -> None:
        self._entries: dict[JausID, _Registration] = {}

    def register(self, id: JausID, offers: Iterable[OfferedService], until: float = math.inf) -> bool:
        """Register or replace the services of a component; False when the table is full."""
        if id not in self._entries and len(self._entries) > MAX_COMPONENTS:
            return False
        # A registration that is repeated keeps its place, see `matching`.
        self._entries[id] = _Registration(tuple(dict.fromkeys(offers))[:MAX_SERVICES], until)
        return True

    def renew(self, id: JausID, until: float) -> None:
        """Extend the time of a component, if it is registered."""
        entry = self._entries.get(id)
        if entry is not None:
            entry.until = max(entry.until, until)

    def expire(self, now: float) -> None:
        """Remove the components whose time is over."""
        self._entries = {id: entry for id, entry in self._entries.items() if entry.until > now}

    def is_permanent(self, id: JausID) -> bool:
        """True for a component that does not expire: of the same program."""
        entry = self._entries.get(id)
        return entry is not None and entry.until == math.inf

    def remove(self, id: JausID) -> None:
        """Remove a component, permanent or not."""
        self._entries.pop(id, None)

    def forget(self, id: JausID) -> None:
        """Remove a component, if it is registered and not permanent."""
        if not self.is_permanent(id):
            self._entries.pop(id, None)

    def matching(self, wanted: Mapping[AddressPattern, SearchFilters]) -> dict[JausID, tuple[OfferedService, ...]]:
        """The services of the components addressed, which may be wildcards; those registered first come first.

        A service is included when its URI contains one of the filters for its component; an empty filter matches all.
        Each component is looked up eight times, whatever the size of the query.
        """
        found: dict[JausID, tuple[OfferedService, ...]] = {}
        for id, entry in self._entries.items():
            filters = set().union(*(wanted.get(where, ()) for where in _addresses(id)))
            if filters:
                found[id] = tuple(offer for offer in entry.offers if any(text in offer.uri for text in filters))
        return found

    def all(self) -> Mapping[JausID, tuple[OfferedService, ...]]:
        """All components in the order of their ids."""
        return {id: entry.offers for id, entry in sorted(self._entries.items())}


def _addresses(id: JausID) -> Iterator[AddressPattern]:
    """The addresses that match a component, from its own id to all wildcards."""
    return product((id.subsystem, ANY_SUBSYSTEM), (id.node, ANY_NODE), (id.component, ANY_COMPONENT))


def within(offers: Iterable[OfferedService], size: int) -> tuple[OfferedService, ...]:
    """The first offers, as many as take up to `size` bytes together."""
    kept: list[OfferedService] = []
    for offer in offers:
        size -= offer.size
        if size < 0:
            break
        kept.append(offer)
    return tuple(kept)


SYSTEM, SUBSYSTEM, NODE, COMPONENT = 1, 2, 3, 4
"""The levels of a query (its field QueryType)."""
REGISTRATION_LIFETIME: Final = 300.0
"""Seconds that a registration lasts after the last message from the component. AS5710 has no renewal: components renew
it by queries or by registering again."""
REGISTRATION_INTERVAL: Final = 30.0
"""Seconds between registrations of this component with another one, which may restart or expire them."""
MAX_REGISTRATION: Final = 2048
"""Bytes of services that one component may register."""
MAX_REPORT: Final = 4000
"""Bytes of services in one report: it fits one packet (4079), also inside an Event, so that every client takes it."""
MAX_FILTERS: Final = 64
"""Search filters of one query that are applied."""
Registrants: TypeAlias = Literal["machine", "subsystem"]
_ALL: Final = frozenset({""})
_RECORDS: Final = 8
"""Bytes around the services of a component: the records of subsystem, node and component with their counts."""


@dataclass(frozen=True, slots=True)
class Identity:
    """A name (Latin-1, at most 255 bytes), and the type of AS5710: 10001 vehicle, 40001 node, 60001 component."""

    name: str
    type: int

    def __post_init__(self) -> None:
        try:
            fits = len(self.name.encode("latin-1")) <= 255
        except UnicodeEncodeError:
            fits = False
        if not fits:
            raise ConfigError(f"identity {self.name!r}: a name in a message is Latin-1 text of up to 255 bytes")


VEHICLE_TYPE: Final = 10001
NODE_TYPE: Final = 40001
COMPONENT_TYPE: Final = 60001


def vehicle_identities(vehicle: str, node: str, component: str, *, system: str = "") -> Mapping[int, Identity]:
    """What a component of a vehicle reports at each level; the system has the name of the vehicle, if it has none."""
    return {
        SYSTEM: Identity(system or vehicle, VEHICLE_TYPE),
        SUBSYSTEM: Identity(vehicle, VEHICLE_TYPE),
        NODE: Identity(node, NODE_TYPE),
        COMPONENT: Identity(component, COMPONENT_TYPE),
    }


DEFAULT_IDENTITIES: Final = vehicle_identities("jauspy vehicle", "jauspy node", "jauspy component", system="jauspy")


class Discovery(Service, urn="urn:jaus:jss:core:Discovery"):
    """Answers for its own component, for those passed to `add_local`, and for those of its subsystem that registered.

    `identities` by level: 1 system, 2 subsystem, 3 node, 4 component; the others have defaults. Registrations end
    `REGISTRATION_LIFETIME` seconds after the last message from the component. Reports name as many components as fit
    one packet, this one first, then those registered first; omitted ones are counted.

    `registrants`: components whose registrations are accepted: those on this machine, or those of the whole subsystem,
    that is, any sender on the network with one of its ids. A registration applies to the component that sends it, and
    never to one of this program.

    `register_with`: the id of a component of the same subsystem whose Discovery is to list this one as long as it
    runs, for clients that ask only there.
    """

    def __init__(
        self,
        identities: Mapping[int, Identity] | None = None,
        *,
        register_with: str | JausID | None = None,
        registrants: Registrants = "machine",
    ) -> None:
        if registrants not in ("machine", "subsystem"):
            raise ConfigError(f"registrants is {registrants!r}; it must be 'machine' or 'subsystem'")
        self.registrants = registrants
        self.identities = dict(identities or {})
        self.directory = Directory()
        self._registrar = None if register_with is None else _one_component(register_with)

    def attached(self) -> None:
        """List the component's own services, including inherited ones; `ConfigError` when it cannot register."""
        me, other = self.host.id, self._registrar
        if other is not None and me.subsystem and (other == me or other.subsystem != me.subsystem):
            raise ConfigError(f"register_with: {me} cannot register with {other}; name another one of its subsystem")
        self._list_own()

    def leaving(self) -> None:
        """Forget registrations, which were made under the old id, and cancel the own one."""
        self.directory = Directory()
        self._register(())

    def joined(self) -> None:
        """List the same services under the new id."""
        self._list_own()

    def _list_own(self) -> None:
        self.directory.register(self.host.id, offered_services(self.host))
        if self._registrar is not None:
            self.host.set_timer(self._repeat_registration, self.host.now, self._repeat_registration)

    def _repeat_registration(self) -> None:
        self.host.set_timer(self._repeat_registration, self.host.now + REGISTRATION_INTERVAL, self._repeat_registration)
        self._register(offered_services(self.host))

    def _register(self, offers: Iterable[OfferedService]) -> None:
        subsystem = self.host.id.subsystem
        if self._registrar is None or not subsystem:
            return
        if subsystem != self._registrar.subsystem:
            self.host.count("not_registered", f"with {self._registrar}, which is in another subsystem")
            return
        self.host.send(self._registrar, RegisterServices([service_record(offer) for offer in offers]))

    def add_local(self, others: Iterable[ServiceHost]) -> None:
        """List components of the same program: they need not register, do not expire, and keep their ids."""
        for other in others:
            self.directory.register(other.id, offered_services(other))

    def remove_local(self, id: JausID) -> None:
        """Stop listing a component of the same program that has ended."""
        self.directory.remove(id)

    def publish_services(self, msg: RegisterServices, source: JausID) -> None:
        """List another component of this subsystem; one that registers no services is removed."""
        if source.subsystem != self.host.id.subsystem or self.directory.is_permanent(source):
            self.host.count("foreign_registration", str(source))
            return
        self._renew(source)
        if not msg.service_list:  # it may have left its machine already
            self.directory.forget(source)
        elif self.registrants == "subsystem":
            self._list(msg, source, HERE)
        else:
            self.host.locate(source, partial(self._list, msg, source))

    def _list(self, msg: RegisterServices, source: JausID, location: Location) -> None:
        if not location.is_here:
            self.host.count("foreign_registration", f"{source} is on another machine; registrants may be 'subsystem'")
            return
        offers = [
            OfferedService(service.uri, service.major_version_number, service.minor_version_number)
            for service in msg.service_list
        ]
        kept = within(offers, MAX_REGISTRATION)
        if len(kept) < len(offers):
            self.host.count("registration_cut", f"{source} with {len(offers)} services")
        if not self.directory.register(source, kept, self.host.now + REGISTRATION_LIFETIME):
            self.host.count("registration_dropped", str(source))

    def client_lost(self, client: JausID) -> None:
        """Remove the component from the list, unless it is of this program."""
        self.directory.forget(client)

    def _renew(self, source: JausID) -> None:
        self.directory.renew(source, self.host.now + REGISTRATION_LIFETIME)
        self.directory.expire(self.host.now)

    def report_identification(self, query: QueryIdentification, source: JausID) -> ReportIdentification | None:
        """Name and type at the requested level; no answer for a reserved level."""
        self._renew(source)
        level = int(query.query_type)
        identity = self.identities.get(level) or DEFAULT_IDENTITIES.get(level)
        if identity is None:
            return None
        return ReportIdentification(query_type=query.query_type, type=identity.type, identification=identity.name)

    def report_configuration(self, query: QueryConfiguration, source: JausID) -> ReportConfiguration | None:
        """Nodes and components of the subsystem, or of this node alone; no answer for a reserved level."""
        self._renew(source)
        if query.query_type not in (SUBSYSTEM, NODE):
            return None
        me = self.host.id
        listed = [
            id
            for id in self.directory.all()
            if id.subsystem == me.subsystem and (query.query_type == SUBSYSTEM or id.node == me.node)
        ]
        return ReportConfiguration(
            node_list=[
                ReportConfiguration.NodeSeq(
                    node_rec=ReportConfiguration.NodeRec(node_id=node),
                    component_list=[ComponentRec(component_id=id.component, instance_id=0) for id in ids],
                )
                for node, ids in groupby(listed, key=attrgetter("node"))
            ]
        )

    def report_subsystem_list(self, source: JausID) -> ReportSubsystemList:
        """The own subsystem, with this component as the one that answers for it."""
        self._renew(source)
        me = self.host.id
        record = SubsystemRec(subsystem_id=me.subsystem, node_id=me.node, component_id=me.component)
        return ReportSubsystemList(subsystem_list=[record])

    def report_services(self, query: QueryServices, source: JausID) -> ReportServices:
        """The services of all queried components that are known; wildcards (255) are supported."""
        self._renew(source)
        wanted = {
            (self.host.id.subsystem, node.node_rec.node_id, component.component_id): _ALL
            for node in query.node_list
            for component in node.component_list
        }
        return ReportServices(node_list=node_records(ReportServices, self._fitting(self.directory.matching(wanted))))

    def report_service_list(self, query: QueryServiceList, source: JausID) -> ReportServiceList:
        """Same as `report_services`, over subsystems; a search filter keeps the services whose URI contains it."""
        self._renew(source)
        matching = self.directory.matching(self._wanted(query))
        found = self._fitting({item: offers for item, offers in matching.items() if offers})
        subsystems = groupby(sorted(found), key=attrgetter("subsystem"))
        return ReportServiceList(
            subsystem_list=[
                ReportServiceList.SubsystemSeq(
                    subsystem_rec=ReportServiceList.SubsystemRec(subsystem_id=number),
                    node_list=node_records(ReportServiceList, {id: found[id] for id in ids}),
                )
                for number, ids in subsystems
            ]
        )

    def _wanted(self, query: QueryServiceList) -> dict[AddressPattern, SearchFilters]:
        wanted: dict[AddressPattern, set[str]] = {}
        filters = 0
        for subsystem in query.subsystem_list:
            for node in subsystem.node_list:
                for component in node.component_list:
                    where = (subsystem.subsystem_rec.subsystem_id, node.node_rec.node_id, component.component_id)
                    known = wanted.setdefault(where, set())
                    if component.search_filter and component.search_filter not in known:
                        filters += 1
                        if filters > MAX_FILTERS:
                            continue
                    known.add(component.search_filter or "")
        if filters > MAX_FILTERS:
            self.host.count("query_cut", f"{filters} search filters")
        return {where: known for where, known in wanted.items() if known}

    def _fitting(self, found: Mapping[JausID, tuple[OfferedService, ...]]) -> dict[JausID, tuple[OfferedService, ...]]:
        """The components that fit `MAX_REPORT`: this one with the services that fit, others with all of theirs."""
        left, kept = MAX_REPORT, {}
        for id in sorted(found, key=lambda component: component != self.host.id):
            offers = within(found[id], left - _RECORDS)
            if id == self.host.id or (left >= _RECORDS and len(offers) == len(found[id])):
                kept[id] = offers
                left -= _RECORDS + sum(offer.size for offer in offers)
        if sum(map(len, kept.values())) < sum(map(len, found.values())) or len(kept) < len(found):
            self.host.count("report_cut", f"{len(found) - len(kept)} of {len(found)} components left out")
        return kept


def _one_component(id: str | JausID) -> JausID:
    found = component_id(id)
    if not found.subsystem or not found.node:
        raise ConfigError(
            f"register_with: {found} is incomplete or has wildcards; give the id of one component, as in 101.1.1"
        )
    return found


def offered_services(host: ServiceHost) -> list[OfferedService]:
    """The services of a component and all they inherit from; older versions of them if it lists those."""
    keys = {(urn, definition.version) for urn, definition in host.definitions.items()}
    if host.older_versions:
        keys |= {(urn, OLDER_VERSION) for urn in answered_in_older_version(host.definitions, host.inputs)}
    offers = []
    for urn, version in keys:
        major, _, minor = version.partition(".")
        offers.append(OfferedService(urn, int(major), int(minor or 0)))
    return sorted(offers)


def service_record(offer: OfferedService) -> ServiceRec:
    """The record of one service."""
    return ServiceRec(uri=offer.uri, major_version_number=offer.major, minor_version_number=offer.minor)


def node_records(report: Any, found: Mapping[JausID, Iterable[OfferedService]]) -> list[Any]:
    """The node records of a `ReportServices` or `ReportServiceList`, which have classes of their own."""
    return [
        report.NodeSeq(
            node_rec=report.NodeRec(node_id=node),
            component_list=[_component(report, id, found[id]) for id in ids],
        )
        for node, ids in groupby(sorted(found), key=attrgetter("node"))
    ]


def _component(report: Any, id: JausID, offers: Iterable[OfferedService]) -> Any:
    return report.ComponentSeq(
        component_rec=ComponentRec(component_id=id.component, instance_id=0),
        service_list=[service_record(offer) for offer in offers],
    )
