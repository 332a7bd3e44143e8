"""Steps made from JSIDL: which there are, in which order, and what they say."""

from __future__ import annotations

from collections import Counter
from datetime import UTC, datetime

import pytest
from tests.conformance.injectors import Fault, code, instead, repacked, says, short, slow, without, works
from tests.conformance.mistakes import elsewhere
from tests.conformance.simulated import TARGET, examined, robot
from tests.helpers.sampling import sampled

from jauspy.conformance import TargetComponent, Verdict, VirtualTarget, find, offers_of
from jauspy.conformance.profile import Offers
from jauspy.conformance.state_tests.behaviour import component_under_test
from jauspy.conformance.state_tests.neutral_messages import neutral
from jauspy.conformance.state_tests.plan import Planner
from jauspy.conformance.state_tests.state_test import StateTest
from jauspy.conformance.trace import Direction
from jauspy.ids import JausID
from jauspy.messages import core, registry
from jauspy.messages.core import RegisterServices, ServiceRec
from jauspy.services.core import Discovery, Liveness
from jauspy.services.host import Host
from jauspy.services.service import Service

ID = JausID(101, 1, 1)
CORE = frozenset(
    (f"urn:jaus:jss:core:{name}", "1.1")
    for name in ("Transport", "Events", "AccessControl", "Management", "Discovery", "Liveness", "Time", "ListManager")
)


def planned(services=CORE):
    return Planner(component_under_test(ID, services), services).steps()


def state_tests_of(services=CORE):
    return [step.run for step in planned(services) if isinstance(step.run, StateTest)]


def test_ignored_inputs_are_tested():
    ignored = [each for each in state_tests_of() if any(not prediction.rule for prediction in each.predictions)]
    assert {"Resume", "Standby", "Shutdown", "Reset", "SetAuthority", "SetTime", "SetElement"} <= {
        each.stimulus.message for each in ignored
    }


def test_all_lasting_states_are_visited():
    states = {".".join(each.situation.state[2:]) for each in state_tests_of()}
    assert states == {
        "NotControlled.Available.Standby",
        "NotControlled.NotAvailable.Emergency",
        "NotControlled.NotAvailable.Shutdown",
        "Controlled.Available.Standby",
        "Controlled.Available.Ready",
        "Controlled.NotAvailable.Emergency",
    }


@pytest.mark.slow
def test_without_motion_nothing_is_commanded_in_ready():
    ready = "Controlled.Available.Ready"
    report = examined("mobility-1.1", robot(timeout=5, tick=None), JausID(105, 1, 1), motion=False, only=(ready,))
    core_codes = {kind.CODE for kind in registry if ":core:" in kind.SERVICE}
    commands = {kind.CODE for kind in registry if kind.IS_COMMAND} - core_codes
    moved = {
        result.id
        for result in report.results
        for entry in result.entries
        if entry.direction is Direction.SENT
        for packet in entry.packets
        if int.from_bytes(packet.payload[:2], "little") in commands
    }
    assert report.counts[Verdict.PASS] > 40
    assert moved == set()


def test_step_ids_are_unique():
    assert max(Counter(step.id for step in planned()).values()) == 1


def test_steps_that_end_the_component_are_last():
    ids = [step.id for step in planned()]
    end = ids.index("Controlled.Available.Ready/Shutdown/controller")
    after = [id for id in ids[end + 1 :] if not id.startswith(("NotControlled.NotAvailable.Shutdown/", "untried/"))]
    assert after == []


KNOWN = "NotControlled.Available.Standby/QueryTime/other-client/all-fields", core.ReportTime
OPEN = "NotControlled.Available.Standby/CreateCommandEvent/other-client/a-new-one", core.ConfirmEventRequest
"""A step with one right outcome, and one whose outcome is up to the target, with what our robot answers."""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("step", "kind"),
    [pytest.param(*KNOWN, id="known"), pytest.param(*OPEN, id="open", marks=pytest.mark.slow)],
)
@pytest.mark.parametrize(
    ("mistake", "verdict", "reason"),
    [
        (lambda kind: says(lambda payload, to: [payload]), Verdict.PASS, ""),
        (without, Verdict.SILENT, " came"),
        (slow, Verdict.LATE, "after the deadline of 1.5 s"),
        (short, Verdict.MALFORMED, "is malformed"),
        (lambda kind: instead(kind, lambda message: core.ReportStatus(2, 0)), Verdict.FAIL, "ReportStatus 4002h"),
        (lambda kind: says(lambda payload, to: [payload] * (1 + (payload[:2] == code(kind)))), Verdict.FAIL, " came"),
        (lambda kind: works(repacked(elsewhere(9, kind))), Verdict.SILENT, " came"),
    ],
    ids=["right", "silent", "late", "short", "another", "twice", "wrong sender"],
)
def test_all_verdicts_are_possible(step, kind, mistake, verdict, reason):
    (result,) = Fault("x", "core-1.1", (), mistake(kind), timeout=5, only=(step,)).run().results
    assert (result.verdict, reason in result.reason) == (verdict, True), result.reason


@pytest.mark.parametrize("name", ["mobility-1.1", "manipulator-2.0", "sensing-2.0", "ugv-1.0"])
def test_target_without_the_services_does_not_pass(name):
    component = Host(ID, [Discovery()], utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    report = examined(name, VirtualTarget([TargetComponent(component)]), ID)
    assert report.status == 2
    assert report.results == ()
    assert "offers no service of" in report.problem
    assert "it offers core:Discovery 1.1, core:Events 1.1" in report.problem


@pytest.mark.slow
@pytest.mark.parametrize(
    ("set_name", "version"),
    sampled(
        [("mobility", "1.1"), ("manipulator", "2.0"), ("environmentSensing", "2.0"), ("ugv", "1.0")],
        fast=1,
        several=True,
    ),
)
def test_every_service_of_the_sets_can_be_planned(set_name, version):
    keys = {(each.service, each.version) for each in registry.entries}
    services = [key for key in keys if key[1] == version and f":{set_name}:" in key[0]]
    assert len(services) >= 10
    for key in services:
        if not key[0].endswith("Client"):
            assert len(state_tests_of(frozenset({key}))) > 0, key


def test_neutral_messages_are_valid_for_every_message():
    for kind in registry:
        message = neutral(kind)
        assert kind.decode(message.encode()) == message


def test_components_are_tested_separately():
    twice = Offers({JausID(101, 1, n): frozenset({("urn:jaus:jss:core:Liveness", "1.1")}) for n in (1, 2)})
    ids = [step.id for step in find("core-1.1").plan(twice)]
    assert {id.partition("/")[0] for id in ids} == {"101.1.1", "101.1.2"}


@pytest.mark.slow
def test_wildcard_target_queries_every_component():
    from jauspy.conformance.profile import discover
    from jauspy.conformance.tester import Tester

    virtual_target = robot(name="inc1", tick=None)
    found = discover(Tester(virtual_target, JausID(101, 1, 255), registry=registry))
    assert found == offers_of(virtual_target)
    assert len(found.components) > 5


def component(number: int, *services: Service) -> TargetComponent:
    host = Host(JausID(101, 1, number), services, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC))
    return TargetComponent(host)


def test_services_of_a_component_without_discovery_come_from_its_node():
    discovery, lonely = component(1, Discovery()), component(7, Liveness())
    offer = RegisterServices([ServiceRec("urn:jaus:jss:core:Liveness", 1, 1)])
    discovery.host.receive(offer.encode(), lonely.host.id, 0.0)
    report = examined("core-1.1", VirtualTarget([discovery, lonely]), lonely.host.id)
    assert report.problem == ""
    assert report.status == 0


def test_responsive_target_without_services_is_not_reported_as_dead():
    report = examined("core-1.1", VirtualTarget([component(7, Liveness())]), JausID(101, 1, 7))
    assert report.status == 2
    assert "101.1.7 does not report its services: no ReportServices" in report.problem


def test_offers_of_a_virtual_target_match_discovery():
    from jauspy.conformance.profile import discover
    from jauspy.conformance.tester import Tester

    virtual_target = robot()
    assert discover(Tester(virtual_target, TARGET, registry=registry)) == offers_of(virtual_target)
