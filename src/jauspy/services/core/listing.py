"""Services of components, as the messages of Discovery list them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import groupby
from operator import attrgetter
from typing import Any

from jauspy.ids import JausID
from jauspy.messages.core import ComponentRec, ServiceRec
from jauspy.services.core.directory import OfferedService
from jauspy.services.service import ServiceHost


def offered_services(host: ServiceHost) -> list[OfferedService]:
    """The services of a component and all they inherit from."""
    offers = []
    for urn, definition in host.definitions.items():
        major, _, minor = definition.version.partition(".")
        offers.append(OfferedService(urn, int(major), int(minor or 0)))
    return sorted(offers)


def service_record(offer: OfferedService) -> ServiceRec:
    """One service's record."""
    return ServiceRec(uri=offer.uri, major_version_number=offer.major, minor_version_number=offer.minor)


def node_records(report: Any, found: Mapping[JausID, Iterable[OfferedService]]) -> list[Any]:
    """The nodes of a `ReportServices` or `ReportServiceList`, which look alike and are classes of their own."""
    return [
        report.NodeSeq(
            node_rec=report.NodeRec(node_id=node),
            component_list=[_component(report, each, found[each]) for each in ids],
        )
        for node, ids in groupby(sorted(found), key=attrgetter("node"))
    ]


def _component(report: Any, id: JausID, offers: Iterable[OfferedService]) -> Any:
    return report.ComponentSeq(
        component_rec=ComponentRec(component_id=id.component, instance_id=0),
        service_list=[service_record(offer) for offer in offers],
    )
