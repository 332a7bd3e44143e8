"""What `jauspy conformance` does with a target."""

from __future__ import annotations

import asyncio
import time
from contextlib import closing
from dataclasses import replace

from jauspy.conformance.offers import Offers
from jauspy.conformance.profile import Profile, Step
from jauspy.conformance.results import Report
from jauspy.conformance.runner import Interrupted, OnResult, Settings, planned_steps, run
from jauspy.conformance.wire import Wire, open_wire
from jauspy.errors import ConfigError
from jauspy.ids import JausID


def steps_of(profile: Profile, target: str | None, connect: str | None, timeout: float) -> tuple[Step, ...]:
    """The steps; a target is only asked when they depend on it."""
    if not profile.asks_for_services:
        return profile.plan(Offers({}))
    if target is None:
        raise ConfigError(f"{profile.name} is made from what a target offers; say of which, as in --target 101.1.102")
    with closing(asyncio.run(open_wire(connect))) as wire:
        return planned_steps(profile, wire, _id(target), timeout=timeout)


def report_of(profile: Profile, target: str, connect: str | None, settings: Settings, watch: OnResult) -> Report:
    """A run; raises `Interrupted`, which has the report, too."""
    id = _id(target)
    with closing(asyncio.run(open_wire(connect))) as wire:
        try:
            report = run(profile, wire, id, began=time.time(), settings=settings, watch=watch)
        except Interrupted as stop:
            stop.report = _noted(stop.report, wire)
            raise
        return _noted(report, wire)


def _id(target: str) -> JausID:
    id = JausID.parse(target)
    if 0 in (id.subsystem, id.node, id.component):
        raise ConfigError(f"{id} is nobody: ids of components are above 0; 255 stands for any node or component")
    return id


def _noted(report: Report, wire: Wire) -> Report:
    """With what the wire has to say."""
    return replace(report, notes=(*getattr(wire, "notes", ()), *report.notes))
