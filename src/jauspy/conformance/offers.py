"""What a target offers: its components and their services, as Discovery reports them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Final, TypeAlias

from jauspy.conformance.checks import that
from jauspy.conformance.results import StepOutcome
from jauspy.conformance.tester import HARMLESS_QUERIES, Tester
from jauspy.errors import RequestError
from jauspy.ids import JausID
from jauspy.messages.core import QueriedComponentRec, QueriedNodeRec, QueryServices, ReportServices, ServiceRec

ServiceKey: TypeAlias = tuple[str, str]
"""URN and version, as `1.1`."""

ALL_SERVICES: Final = QueryServices(
    node_list=[
        QueryServices.NodeSeq(
            node_rec=QueriedNodeRec(node_id=255), component_list=[QueriedComponentRec(component_id=255)]
        )
    ]
)
"""Queries all services: 255 stands for all nodes and all components."""
DISCOVERY_CLIENT: Final = "42.1.1"


@dataclass(frozen=True, slots=True)
class Offers:
    """The services of each component of the target."""

    components: Mapping[JausID, frozenset[ServiceKey]]

    def with_any(self, wanted: frozenset[ServiceKey]) -> Mapping[JausID, frozenset[ServiceKey]]:
        """The `wanted` services by component, without components that have none of them."""
        found = {id: services & wanted for id, services in sorted(self.components.items())}
        return {id: services for id, services in found.items() if services}


def discover(tester: Tester) -> Offers:
    """Ask the target for all of its services. Raises `RequestError` if no component reports them.

    Some components report all services of their node, others only their own. So answers to a wildcard are collected for
    a whole timeout. If a component does not answer, its whole node is queried, because often one Discovery service
    reports for all components.
    """
    listed = that("lists a component", lambda report: any(each.component_list for each in report.node_list))
    client = tester.client(DISCOVERY_CLIENT)
    try:
        first = client.ask(ALL_SERVICES, ReportServices, listed, within=2.0)
    except StepOutcome as error:
        found = _merged(tester, _reported_by_node(tester))
        if found.components:
            return found
        _probe(tester)
        raise RequestError(
            f"{tester.target} does not report its services: {error}; without Discovery, name them: "
            "--services Management@1.0,Liveness@1.0"
        ) from error
    reports = [(tester.component, first)]
    if tester.target.is_wildcard:
        reports += client.answers(ALL_SERVICES, ReportServices, tester.timeout)
    return _merged(tester, reports)


def _reported_by_node(tester: Tester) -> list[tuple[JausID, ReportServices]]:
    if tester.target.is_wildcard:
        return []
    node = replace(tester.target, component=255)
    return tester.client(DISCOVERY_CLIENT).answers(ALL_SERVICES, ReportServices, tester.timeout, of=node)


def _probe(tester: Tester) -> None:
    """Return whether the target answers any query, for the error message."""
    for ping in HARMLESS_QUERIES:
        tester.client(DISCOVERY_CLIENT).send(ping)
    tester.pump(tester.now + tester.timeout, lambda: tester.has_received)


def _merged(tester: Tester, reports: Iterable[tuple[JausID, ReportServices]]) -> Offers:
    found: dict[JausID, frozenset[ServiceKey]] = {}
    for source, report in reports:
        for id, services in _listed(source, report):
            if tester.target.matches(id):
                found[id] = found.get(id, frozenset()) | services
    return Offers(found)


def _listed(source: JausID, report: ReportServices) -> Iterator[tuple[JausID, frozenset[ServiceKey]]]:
    for node in report.node_list:
        for component in node.component_list:
            id = JausID(source.subsystem, node.node_rec.node_id, component.component_rec.component_id)
            yield id, frozenset(map(_key, component.service_list))


def _key(service: ServiceRec) -> ServiceKey:
    return service.uri, f"{service.major_version_number}.{service.minor_version_number}"
