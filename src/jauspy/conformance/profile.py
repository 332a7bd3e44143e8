"""Profiles: named steps, each a function of a tester, and the services of a target that they are planned for."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib.metadata import EntryPoint, entry_points
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, that
from jauspy.conformance.results import StepOutcome
from jauspy.conformance.tester import HARMLESS_QUERIES, Tester
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.messages.core import QueriedComponentRec, QueriedNodeRec, QueryServices, ReportServices, ServiceRec

GROUP: Final = "jauspy.conformance"
"""Group of entry points: a name and the location of a `Profile`."""

BUILT_IN: Final = {
    "core-1.1": "jauspy.conformance.state_tests.plan:CORE",
    "cell-1.0": "jauspy.conformance.state_tests.plan:CELL",
    "mobility-1.1": "jauspy.conformance.state_tests.plan:MOBILITY",
    "manipulator-2.0": "jauspy.conformance.state_tests.plan:MANIPULATOR",
    "sensing-2.0": "jauspy.conformance.state_tests.plan:SENSING",
    "ugv-1.0": "jauspy.conformance.state_tests.plan:UGV",
    "transport": "jauspy.conformance.profiles.transport:PROFILE",
    "iop-v3": "jauspy.conformance.profiles.iop_v3:PROFILE",
    "igvc-2011": "jauspy.conformance.profiles.igvc_2011:PROFILE",
    "igvc-2015": "jauspy.conformance.profiles.igvc_2015:PROFILE",
}
"""Locations of the included profiles, which are imported when they are used."""

Action: TypeAlias = Callable[[Tester], object]
"""The function of a step; raises a `StepOutcome` unless the step passes."""


@dataclass(frozen=True, slots=True)
class Step:
    """One step. `id` is unique in its profile."""

    id: str
    title: str
    run: Action
    points: float = 0.0
    why: str = ""
    """Source of the expectation, such as a state or a rule, if the messages do not show it."""
    moves: bool = False
    """True if the robot drives in this step; `--no-motion` omits it."""
    wants: frozenset[str] = field(default=frozenset())
    """Required features of the wire."""
    transitions: tuple[str, ...] = ()
    """Transitions of the target's state machines that the step may take."""


StartCheck: TypeAlias = "Callable[[Tester, Offers], None]"
"""Raises `ConfigError` if the target is in a state in which no test can begin."""
Plan: TypeAlias = "Callable[[Offers], Sequence[Step]]"
"""Makes the steps for the services of a target."""


@dataclass(frozen=True, slots=True)
class Profile:
    """A test of one standard or competition.

    `steps` are the same for every target, or made by a function from what the target offers (`Offers`). Such a
    function may raise `ConfigError` when there is nothing to test.
    """

    name: str
    title: str
    steps: tuple[Step, ...] | Plan
    notes: tuple[str, ...] = ()
    """Notes for the readers of its reports."""
    one_component: bool = False
    """True if all steps need one component; then several that answer to a wildcard are an error before the first."""
    check: StartCheck | None = None
    """Called before the first step."""

    @property
    def asks_for_services(self) -> bool:
        """True if the steps depend on the services of the target."""
        return callable(self.steps)

    def plan(self, offers: Offers) -> tuple[Step, ...]:
        """The steps for a target; raises `ConfigError` when two have the same id."""
        steps = tuple(self.steps(offers)) if callable(self.steps) else self.steps
        twice = sorted(id for id, count in Counter(step.id for step in steps).items() if count > 1)
        if twice:
            raise ConfigError(f"conformance profile {self.name!r} has two steps {twice[0]!r}; ids must be unique")
        return steps


def ask(
    client: str,
    message: Message | bytes,
    answer: type[Message],
    *checks: Check | Iterable[Check],
    to: JausID | None = None,
) -> Action:
    """A step in which a client sends a message and receives the right answer."""
    return lambda tester: tester.client(client).ask(message, answer, *checks, to=to)


def tell(client: str, message: Message | bytes) -> Action:
    """A step in which a client sends a message that has no answer."""

    def action(tester: Tester) -> None:
        tester.client(client).send(message)
        tester.client(client).silence()

    return action


def known() -> list[str]:
    """The names of the included profiles and of those that installed packages register."""
    return sorted({*BUILT_IN, *(entry.name for entry in entry_points(group=GROUP))})


def find(name: str) -> Profile:
    """The profile with a name or location, as in `acme.brakes:PROFILE`.

    Raises `ConfigError` that lists the profiles, or names why one cannot be loaded.
    """
    if re.fullmatch(r"[\w.]+:\w+", name):
        return _loaded(EntryPoint(name, name, GROUP))
    if name in BUILT_IN:
        return _loaded(EntryPoint(name, BUILT_IN[name], GROUP))
    for entry in entry_points(group=GROUP, name=name):
        return _loaded(entry)
    raise ConfigError(f"no conformance profile {name!r}; there are: {', '.join(known())}; MODULE:NAME is one of yours")


def _loaded(entry: EntryPoint) -> Profile:
    which = entry.name if entry.name == entry.value else f"{entry.name!r} ({entry.value})"
    try:
        profile = entry.load()
    except Exception as error:
        what = f"{type(error).__name__}: {error}"
        raise ConfigError(f"conformance profile {which} cannot be loaded: {what}") from error
    if not isinstance(profile, Profile):
        raise ConfigError(f"conformance profile {which} is not a Profile")
    return profile


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
    listed = that("lists a component", lambda report: any(node.component_list for node in report.node_list))
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
