"""The tables written by hand find mistakes of the merged state machine, which the generated steps share."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from unittest.mock import patch

import pytest
from tests.conformance.simulated import examined, robot
from tests.helpers.sampling import sampled

from jauspy.conformance import Report, Verdict, state_tables
from jauspy.conformance.state_tables import TABLES, table_steps
from jauspy.conformance.state_tests import behaviour
from jauspy.ids import JausID
from jauspy.schema import state_tree
from jauspy.schema.model import ServiceDefinition, State, Transition
from jauspy.services import binding

TARGET = JausID(105, 1, 1)
HELD, FREE = "Receiving.Ready.Controlled", "Receiving.Ready.NotControlled"
Change = Callable[[Transition], Transition | None]


def run_of(profile: str, *only: str) -> Report:
    return examined(profile, robot(timeout=5, component=1, tick=None), TARGET, only=only)


def dropped(transition: Transition) -> None:
    """The transition is missing."""


def unguarded(transition: Transition) -> Transition:
    """It is taken whoever sends."""
    return replace(transition, guard="")


def elsewhere(transition: Transition) -> Transition:
    """It leads to another state."""
    return replace(transition, end_state="Receiving.Ready.NotControlled.Available.Standby")


def seeded(service: str, path: str, message: str, change: Change) -> Callable[[Iterable[ServiceDefinition]], object]:
    """`merge_machines` with this mistake in the transitions of a state for a message."""

    def transitions(given: tuple[Transition, ...]) -> tuple[Transition, ...]:
        chosen = (change(each) if any(p.type == message for p in each.parameters) else each for each in given)
        return tuple(each for each in chosen if each is not None)

    def state(given: State, parent: str) -> State:
        here = f"{parent}.{given.name}".lstrip(".")
        nested = tuple(state(each, here) for each in given.states)
        if here != path:
            return replace(given, states=nested)
        changed, defaults = transitions(given.transitions), transitions(given.default_transitions)
        assert (changed, defaults) != (given.transitions, given.default_transitions)
        return replace(given, states=nested, transitions=changed, default_transitions=defaults)

    def definition(given: ServiceDefinition) -> ServiceDefinition:
        if given.name != service:
            return given
        machines = tuple(
            replace(each, states=tuple(state(one, "") for one in each.states)) for each in given.behavior.machines
        )
        return replace(given, behavior=replace(given.behavior, machines=machines))

    merge = state_tree.merge_machines
    return lambda definitions: merge([definition(each) for each in definitions])


READY = "Controlled.Available.Ready"
MISTAKES = {
    ("Management", f"{HELD}.Available.Standby", "Resume", dropped): (
        "Controlled.Standby/Resume/controller",
        "Controlled.Available.Standby/Resume",
    ),
    ("Management", f"{HELD}.Available.Ready", "Standby", elsewhere): (
        "Controlled.Ready/Standby/controller",
        f"{READY}/Standby/controller",
    ),
    ("Management", HELD, "Reset", dropped): ("Controlled.Ready/Reset/controller", f"{READY}/Reset"),
    ("Management", HELD, "Shutdown", unguarded): (
        "Controlled.Ready/Shutdown/other-client",
        f"{READY}/Shutdown/other-client",
    ),
    ("AccessControl", f"{HELD}.Available", "ReleaseControl", unguarded): (
        "Controlled.Ready/ReleaseControl/other-client",
        f"{READY}/ReleaseControl/other-client",
    ),
    ("AccessControl", f"{FREE}.Available", "RequestControl", dropped): (
        "NotControlled.Standby/RequestControl/controller",
        "NotControlled.Available.Standby/RequestControl/other-client",
    ),
    ("Events", "Receiving.Ready", "CancelEvent", dropped): (
        "Controlled.Ready/CancelEvent/other-client/an-unknown-one",
        f"{READY}/CancelEvent/other-client/an-unknown-one",
    ),
    ("Liveness", "Receiving.Ready", "QueryHeartbeatPulse", dropped): (
        "Controlled.Ready/QueryHeartbeatPulse/other-client",
        f"{READY}/QueryHeartbeatPulse/other-client",
    ),
    ("Time", HELD, "QueryTime", dropped): (
        "Controlled.Ready/QueryTime/other-client",
        f"{READY}/QueryTime/other-client/all-fields",
    ),
    ("ListManager", HELD, "DeleteElement", unguarded): (
        "Controlled.Standby/DeleteElement/other-client/an-unknown-one",
        "Controlled.Available.Standby/DeleteElement/other-client/an-unknown-one",
    ),
    ("PrimitiveDriver", f"{HELD}.Available.Ready", "SetWrenchEffort", dropped): (
        "Controlled.Ready/SetWrenchEffort/controller",
        f"{READY}/SetWrenchEffort",
    ),
    ("PrimitiveDriver", f"{HELD}.Available.Ready", "SetWrenchEffort", unguarded): (
        "Controlled.Ready/SetWrenchEffort/other-client",
        f"{READY}/SetWrenchEffort/other-client",
    ),
    ("LocalWaypointDriver", HELD, "SetLocalWaypoint", dropped): (
        "Controlled.Standby/SetLocalWaypoint/controller",
        "Controlled.Available.Standby/SetLocalWaypoint",
    ),
}
"""A mistake in the merged machine; the row that finds it, and the beginning of generated steps that do not."""


@pytest.mark.slow
@pytest.mark.parametrize(
    "mistake", sampled(list(MISTAKES), fast=4), ids=lambda each: f"{each[0]}-{each[2]}-{each[3].__name__}"
)
def test_mistake_in_the_merged_machine_is_detected_by_the_tables_only(mistake):
    row, generated = MISTAKES[mistake]
    profile = "mobility-1.1" if mistake[0].endswith("Driver") else "core-1.1"
    merge = seeded(*mistake)
    with ExitStack() as patches:
        for module in (binding, behaviour):
            patches.enter_context(patch.object(module, "merge_machines", merge))
        found = run_of(profile, f"table/{mistake[0]}/{row}")
        shared = run_of(profile, generated)
    assert [each.verdict in (Verdict.FAIL, Verdict.SILENT) for each in found.results] == [True]
    assert shared.results
    assert shared.failures == ()


@pytest.mark.slow
@pytest.mark.parametrize("profile", ["core-1.1", "mobility-1.1"])
def test_robot_passes_every_row(profile):
    report = run_of(profile, "table/")
    assert {each.verdict for each in report.results} == {Verdict.PASS}
    assert len(report.results) >= 20


def test_tables_cover_services_and_name_their_source():
    assert len(TABLES) >= 5
    assert all(table.rows and table.source.startswith("AS") for table in TABLES)
    keys = frozenset((table.service, table.version) for table in TABLES)
    steps = table_steps(TARGET, keys, keys)
    assert [id for id, count in Counter(step.id for step in steps).items() if count > 1] == []


def test_component_with_liveness_only_has_rows_without_control():
    liveness = ("urn:jaus:jss:core:Liveness", "1.1")
    assert [step.id for step in table_steps(TARGET, [liveness], [liveness])] == [
        "table/Liveness/NotControlled.Standby/QueryHeartbeatPulse/other-client"
    ]


def test_the_tables_use_no_definition():
    tree = ast.parse(Path(state_tables.__file__).read_text())
    used = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.module}
    assert not [each for each in used if each.startswith(("jauspy.schema", "jauspy.services"))]
    assert "jauspy.conformance.state_tests" not in {each[: len("jauspy.conformance.state_tests")] for each in used}
