"""Steps 1, 2, 11 to 19, 73 and 74: who is there, and what it offers."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.checks import Check, has, that
from jauspy.conformance.profile import Action, ask
from jauspy.conformance.profiles.igvc_2015.judge import (
    COP,
)
from jauspy.conformance.tester import Tester
from jauspy.ids import EVERYONE
from jauspy.messages.core import (
    QueryIdentification,
    ReportIdentification,
    ReportServices,
)


def _of(*uris: str) -> Check:
    def listed(report: ReportServices) -> bool:
        found = {each.uri for node in report.node_list for part in node.component_list for each in part.service_list}
        return found >= set(uris)

    return that("lists the core services", listed)


SERVICES: Final = (
    that("lists a node", lambda report: bool(report.node_list)),
    that("lists a component of each node", lambda report: all(node.component_list for node in report.node_list)),
    _of(*(f"urn:jaus:jss:core:{name}" for name in ("Transport", "Events", "AccessControl", "Management", "Discovery"))),
)
CONFIGURATION: Final = that(
    "lists nodes with components",
    lambda report: bool(report.node_list) and all(n.component_list for n in report.node_list),
)
LISTED: Final = that("lists a subsystem", lambda report: bool(report.subsystem_list))


def identification(level: int) -> Action:
    """Steps 13 to 16."""
    named = that("has a name", lambda report: bool(report.identification.strip("\0 ")))
    return ask(COP, QueryIdentification(level), ReportIdentification, has(query_type=level), named)


def hello(tester: Tester) -> None:
    """Steps 1, 73 and 74: asked of everybody."""
    tester.client(COP).ask(QueryIdentification(4), ReportIdentification, has(query_type=4), to=EVERYONE)
