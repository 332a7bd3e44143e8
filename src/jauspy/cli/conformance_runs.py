"""How `jauspy conformance` runs a profile: which profile, against what, and how it is reached."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Iterable
from contextlib import closing
from dataclasses import dataclass, replace
from typing import Final

from jauspy.cli.schema.ls import find as find_definitions
from jauspy.codec.registry import Registry
from jauspy.conformance.known_deviations import marked, with_known_deviations
from jauspy.conformance.link import TesterLink, open_link
from jauspy.conformance.profile import Offers, Profile, Step, find
from jauspy.conformance.results import Report, Result
from jauspy.conformance.runner import Interrupted, OnResult, Settings, planned_steps, run
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.peers import find_kind
from jauspy.messages import registry
from jauspy.schema import Schema, load_builtin
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.model import ServiceDefinition

MAX_TARGETS: Final = 10_000


@dataclass(frozen=True, slots=True)
class Target:
    """One target; `where` is how to reach it, as --connect says it."""

    id: str
    where: str | None = None


def parse_targets(texts: Iterable[str], connect: str | None) -> tuple[Target, ...]:
    """The targets of `ID` and `ID@WHERE`; the others are reached by `connect`. Raises `ConfigError` for a wrong one."""
    found: dict[Target, None] = {}
    for text in texts:
        id, mark, where = text.partition("@")
        if mark and not where:
            raise ConfigError(f"--target {text}: write how to reach it after @, as in {id}@udp://192.168.1.101")
        target = Target(id, where if mark else connect)
        target_id(id)
        if target in found:
            raise ConfigError(f"--target {text} is given twice")
        found[target] = None
        if len(found) > MAX_TARGETS:
            raise ConfigError(f"more than {MAX_TARGETS} targets; name a whole robot by its number, as in --target 101")
    return tuple(found)


def is_urn(profile: str) -> bool:
    """True when a profile is named by the URN of a service."""
    return profile.startswith("urn:")


def chosen_profile(name: str, messages: Registry) -> Profile:
    """The profile of this name, or that of the service with this URN. Raises `ConfigError` for an unknown one."""
    if not is_urn(name):
        return find(name)
    from jauspy.conformance.state_tests.plan import service_profile

    return service_profile(name, messages)


def named_offers(names: str | None, target: str | None, own: Schema | None = None) -> Offers | None:
    """The services that the user names, and their ancestors, as offers of the target; None without names.

    `own` has the user's definitions.
    """
    if names is None or target is None:
        return None
    if (id := target_id(target)).is_wildcard:
        raise ConfigError(f"--services names the services of one component, and {id} has wildcards")
    schema = Schema(services=(*(own.services if own else ()), *load_builtin().services))
    parent_of = parents_among(schema.services)
    found: dict[str, ServiceDefinition] = {}
    for name in filter(None, (name.strip() for name in names.split(","))):
        services = [match.service for match in find_definitions(schema, name) if match.message is None]
        if len(services) != 1:
            several = ", ".join(service.id for service in services)
            raise ConfigError(f"--services {name}: {'name one of ' + several if several else 'this is a message'}")
        for service in lineage(services[0], parent_of):
            if (other := found.setdefault(service.id, service)).version != service.version:
                raise ConfigError(
                    f"--services {name}: it needs {service.name} {service.version}, and the services before it need "
                    f"{service.name} {other.version}; give a version to each, as in {services[0].name}@{other.version}"
                )
    return Offers({id: frozenset(service.key for service in found.values())})


def steps_of(
    profile: Profile,
    target: Target | None,
    timeout: float,
    offers: Offers | None,
    *,
    messages: Registry,
) -> tuple[Step, ...]:
    """The steps of a profile; the target is queried only if they depend on its services, and these are not named."""
    if not profile.asks_for_services:
        return profile.plan(Offers({}))
    if target is None:
        raise ConfigError(
            f"the steps of {profile.name} depend on the target's services; add --target, as in --target 101.1.102"
        )
    with closing(asyncio.run(open_link(target.where))) as link:
        return planned_steps(profile, link, target_id(target.id), offers=offers, timeout=timeout, registry=messages)


def report_of(
    profile: Profile,
    target: Target,
    settings: Settings,
    watch: OnResult,
    *,
    offers: Offers | None = None,
    messages: Registry = registry,
    peer: str | None = None,
) -> Report:
    """Run a profile; raises `Interrupted`, which has the report so far."""
    id = target_id(target.id)
    kind = None if peer is None else find_kind(peer)

    def watch_marked(result: Result) -> None:
        watch(result if kind is None else marked(result, profile.name, kind))

    with closing(asyncio.run(open_link(target.where))) as link:
        try:
            report = run(
                profile,
                link,
                id,
                began=time.time(),
                offers=offers,
                settings=settings,
                registry=messages,
                watch=watch_marked,
            )
        except Interrupted as stop:
            stop.report = with_known_deviations(_with_notes(stop.report, link), kind)
            raise
        return with_known_deviations(_with_notes(report, link), kind)


def target_id(target: str) -> JausID:
    """The id of a target, as in 101.1.102, 101.1.255 and 101; raises `ConfigError`."""
    id = JausID.parse(f"{target}.255.255" if target.isascii() and target.isdigit() else target)
    if 0 in (id.subsystem, id.node, id.component):
        raise ConfigError(
            f"{id} is not the id of a component: no part may be 0; 255 is the wildcard of node and component"
        )
    return id


def _with_notes(report: Report, link: TesterLink) -> Report:
    """The report with the notes of the wire."""
    return replace(report, notes=(*getattr(link, "notes", ()), *report.notes))
