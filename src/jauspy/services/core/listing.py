"""Services of components, as the messages of Discovery list them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import groupby
from operator import attrgetter
from typing import Any

from jauspy.ids import JausID
from jauspy.messages.core import ComponentRec, ServiceRec
from jauspy.services.core.directory import Offer
from jauspy.services.service import ServiceHost


def own_offers(host: ServiceHost) -> list[Offer]:
    """The services of a component and all they inherit from."""
    offers = []
    for urn, definition in host.definitions.items():
        major, _, minor = definition.version.partition(".")
        offers.append(Offer(urn, int(major), int(minor or 0)))
    return sorted(offers)


def service(offer: Offer) -> ServiceRec:
    """One service's record."""
    return ServiceRec(uri=offer.uri, major_version_number=offer.major, minor_version_number=offer.minor)


def nodes(report: Any, found: Mapping[JausID, Iterable[Offer]]) -> list[Any]:
    """The nodes of a `ReportServices` or `ReportServiceList`, which look alike and are classes of their own."""
    return [
        report.NodeSeq(
            node_rec=report.NodeRec(node_id=node),
            component_list=[_component(report, each, found[each]) for each in ids],
        )
        for node, ids in groupby(sorted(found), key=attrgetter("node"))
    ]


def _component(report: Any, id: JausID, offers: Iterable[Offer]) -> Any:
    return report.ComponentSeq(
        component_rec=ComponentRec(component_id=id.component, instance_id=0),
        service_list=[service(offer) for offer in offers],
    )
