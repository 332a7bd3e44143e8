"""Profiles made from JSIDL: our robot passes them, and no transition is forgotten."""

from __future__ import annotations

from collections import Counter
from datetime import UTC, datetime

import pytest
from tests.conformance.simulated import TARGET, examined, robot

from jauspy.conformance import Bench, Part, Verdict, find, offers_of
from jauspy.conformance.offers import Offers
from jauspy.conformance.walk.events import PROVOKED
from jauspy.conformance.walk.neutral import neutral
from jauspy.conformance.walk.plan import Planner
from jauspy.conformance.walk.subject import subject_of
from jauspy.conformance.walk.trial import Trial
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.services.core import Discovery
from jauspy.services.host import Host

ID = JausID(101, 1, 1)
CORE = frozenset(
    (f"urn:jaus:jss:core:{name}", "1.1")
    for name in ("Transport", "Events", "AccessControl", "Management", "Discovery", "Liveness", "Time", "ListManager")
)
RECEIVING = "Receiving.Ready"
NEVER = {
    "Transport, Receiving: Receive": "what nothing else takes; every ignored input",
    f"Management, {RECEIVING}.NotControlled.NotAvailable.Init: Initialized": "happens by itself, after Reset",
    f"Management, {RECEIVING}.NotControlled.NotAvailable.Emergency: Timedout": "nobody is in control",
    f"Events, {RECEIVING}: CreateCommandEvent [isCommandSupported(msg) && eventExists(msg)]": "no command lasts",
    f"AccessControl, {RECEIVING}.Controlled.NotAvailable: RequestControl": "Emergency, its only state, takes it first",
    f"AccessControl, {RECEIVING}.Controlled.NotAvailable: ReleaseControl": "Emergency, its only state, takes it first",
    f"AccessControl, {RECEIVING}.Controlled.NotAvailable: Timedout": "Emergency, its only state, takes it first",
}
"""Transitions that cannot be seen from outside, and why."""
INSIDE = {"Failure", "EventError", "CommandCompleted", "CommandExpired"}
"""Internal events that only the component can bring about; each is a step that says so."""


def planned(services=CORE):
    return Planner(subject_of(ID, services), services).steps()


def trials(services=CORE):
    return [step.run for step in planned(services) if isinstance(step.run, Trial)]


def test_every_transition_of_every_core_service_is_exercised():
    exercised = {prediction.rule for trial in trials() for prediction in trial.predictions}
    rules = subject_of(ID, CORE).machine.rules()
    missing = {name for name, transition in rules if transition.trigger not in INSIDE} - exercised
    assert missing == set(NEVER)
    listed = {step.id.partition("/")[2] for step in planned() if step.id.startswith("internal/")}
    assert listed == INSIDE - PROVOKED


def test_what_is_ignored_is_tried_too():
    ignored = [each for each in trials() if any(not prediction.rule for prediction in each.predictions)]
    assert {"Resume", "Standby", "Shutdown", "Reset", "SetAuthority", "SetTime", "SetElement"} <= {
        each.stimulus.message for each in ignored
    }


def test_every_lasting_state_is_visited():
    states = {".".join(each.situation.state[2:]) for each in trials()}
    assert states == {
        "NotControlled.Available.Standby",
        "NotControlled.NotAvailable.Emergency",
        "NotControlled.NotAvailable.Shutdown",
        "Controlled.Available.Standby",
        "Controlled.Available.Ready",
        "Controlled.NotAvailable.Emergency",
    }


def test_steps_have_names_of_their_own():
    assert max(Counter(step.id for step in planned()).values()) == 1


def test_what_ends_the_component_comes_last():
    ids = [step.id for step in planned()]
    end = ids.index("Controlled.Available.Ready/Shutdown/pilot")
    after = [id for id in ids[end + 1 :] if not id.startswith(("NotControlled.NotAvailable.Shutdown/", "internal/"))]
    assert after == []


@pytest.mark.parametrize(
    ("name", "module"),
    [
        ("core-1.1", "igvc 105.1.1"),
        ("mobility-1.1", "igvc 105.1.1"),
        ("ugv-1.0", "igvc 105.1.1"),
        ("manipulator-2.0", "inc1 101.1.104"),
        ("manipulator-2.0", "inc1 101.1.105"),
        ("manipulator-2.0", "inc1 101.1.103"),
        ("manipulator-2.0", "inc1 101.1.107"),
        ("manipulator-2.0", "inc1_pprm 102.1.107"),
        ("sensing-2.0", "inc1 101.1.106"),
        ("sensing-2.0", "inc1 101.1.107"),
        ("sensing-2.0", "inc1 101.1.108"),
    ],
)
def test_our_robot_passes(name, module):
    robot_name, target = module.split()
    report = examined(name, robot(name=robot_name, timeout=5), JausID.parse(target))
    assert [f"{each.id}: {each.reason}" for each in report.failures] == []
    assert report.status == 0
    assert report.counts[Verdict.PASS] > 10
    reasons = {each.reason.partition(" ")[2] for each in report.results if each.verdict is Verdict.SKIPPED}
    assert all("inside of the component" in reason or "would end the component" in reason for reason in reasons)


@pytest.mark.parametrize("name", ["mobility-1.1", "manipulator-2.0", "sensing-2.0", "ugv-1.0"])
def test_a_target_without_such_services_does_not_pass(name):
    component = Host(ID, [Discovery()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    report = examined(name, Bench([Part(component)]), ID)
    assert report.status == 2
    assert report.results == ()
    assert "offers no service of" in report.problem
    assert "it offers core:Discovery 1.1, core:Events 1.1" in report.problem


@pytest.mark.parametrize(
    ("set_name", "version"),
    [("mobility", "1.1"), ("manipulator", "2.0"), ("environmentSensing", "2.0"), ("ugv", "1.0")],
)
def test_every_service_of_the_sets_can_be_planned(set_name, version):
    keys = {(each.service, each.version) for each in registry.entries}
    services = [key for key in keys if key[1] == version and f":{set_name}:" in key[0]]
    assert len(services) >= 10
    for key in services:
        if not key[0].endswith("Client"):
            assert len(trials(frozenset({key}))) > 0, key


def test_neutral_messages_are_valid_for_every_message():
    for kind in registry:
        message = neutral(kind)
        assert kind.decode(message.encode()) == message


def test_several_components_are_kept_apart():
    twice = Offers({JausID(101, 1, n): frozenset({("urn:jaus:jss:core:Liveness", "1.1")}) for n in (1, 2)})
    ids = [step.id for step in find("core-1.1").plan(twice)]
    assert {id.partition("/")[0] for id in ids} == {"101.1.1", "101.1.2"}


def test_of_a_wildcard_every_component_is_asked():
    from jauspy.conformance.offers import discover
    from jauspy.conformance.tester import Tester

    bench = robot(name="inc1", tick=None)
    found = discover(Tester(bench, JausID(101, 1, 255), registry=registry))
    assert found == offers_of(bench)
    assert len(found.components) > 5


def test_offers_of_a_bench_are_what_discovery_tells():
    from jauspy.conformance.offers import discover
    from jauspy.conformance.tester import Tester

    bench = robot()
    assert discover(Tester(bench, TARGET, registry=registry)) == offers_of(bench)
