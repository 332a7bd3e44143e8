"""Conformance of several targets: one after the other or on a Dask cluster, and one report of all."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial

from jauspy.cli.conformance_runs import Target, chosen_profile, named_offers, report_of
from jauspy.cli.definitions import definitions
from jauspy.cluster import spread
from jauspy.conformance.results import Report, Result
from jauspy.conformance.runner import Interrupted, Settings
from jauspy.errors import JausError


@dataclass(frozen=True, slots=True)
class Plan:
    """What is run for each target, as text that another machine can read; files of `schemas` must be there, too."""

    profile: str
    settings: Settings
    services: str | None = None
    schemas: tuple[str, ...] = ()
    peer: str | None = None


@dataclass(slots=True)
class Campaign:
    """The reports of the targets that were tested so far."""

    reports: list[Report] = field(default_factory=list)
    is_interrupted: bool = False


def run_campaign(
    plan: Plan,
    targets: Sequence[Target],
    cluster: str | None,
    *,
    on_result: Callable[[Target, Result], None],
    on_report: Callable[[Report], None],
) -> Campaign:
    """Test all targets; a target that cannot be tested has a report that says why. Ctrl-C ends with those so far.

    On a cluster, targets that are reached in different ways are tested at once, and `on_result` is called when those of
    one way are done. The clients of all tests have the same ids, so targets of one way wait for each other.
    """
    campaign = Campaign()

    def add(report: Report) -> None:
        campaign.reports.append(report)
        on_report(report)

    try:
        if cluster is None:
            for target in targets:
                add(report_for(plan, target, partial(on_result, target)))
        else:
            for tested, reports in spread(cluster, partial(_work, plan), ways(targets)):
                for target, report in zip(tested, reports, strict=True):
                    for result in report.results:
                        on_result(target, result)
                    add(report)
    except Interrupted as stop:
        campaign.is_interrupted = True
        add(stop.report)
    except KeyboardInterrupt:
        campaign.is_interrupted = True
    return campaign


def ways(targets: Iterable[Target]) -> Iterator[tuple[Target, ...]]:
    """The targets in groups that can be tested at once: those of one way are tested one after the other."""
    found: dict[str | None, list[Target]] = {}
    for target in targets:
        found.setdefault(target.where, []).append(target)
    return map(tuple, found.values())


def report_for(plan: Plan, target: Target, watch: Callable[[Result], None]) -> Report:
    """The report of one target; that it cannot be tested is its problem. Raises `Interrupted`, with what was done."""
    began = time.time()
    try:
        defined = definitions(list(plan.schemas))
        profile = chosen_profile(plan.profile, defined.registry)
        offers = named_offers(plan.services, target.id, defined.own)
        return report_of(
            profile, target, plan.settings, watch, offers=offers, messages=defined.registry, peer=plan.peer
        )
    except JausError as error:
        return Report(plan.profile, plan.profile, target.id, began, problem=str(error))


def _work(plan: Plan, targets: tuple[Target, ...]) -> tuple[tuple[Target, ...], list[Report]]:
    """One group, in a process of the cluster."""
    return targets, [report_for(plan, target, lambda _: None) for target in targets]
