"""How runs end: targets that die in the midst, Ctrl-C, and what is left behind."""

from __future__ import annotations

import pytest
from tests.conformance.scripted import ScriptedLink
from tests.conformance.simulated import examined, robot

from jauspy.conformance import Profile, Step, Verdict, ask, run, tell
from jauspy.conformance.runner import Interrupted
from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.messages.core import (
    QueryControl,
    QueryStatus,
    ReportControl,
    ReportStatus,
    RequestControl,
    SetEmergency,
    Standby,
)
from jauspy.messages.mobility import SetTravelSpeed

READY = bytes.fromhex("02400100000000")
COP = "42.1.1"
COMPONENT = JausID(105, 1, 1)
STATUS = ask(COP, QueryStatus(), ReportStatus)


def dying(after: int):
    """Answers so many times."""
    said = []

    def script(payload):
        said.append(payload)
        return [(0.01, READY)] if len(said) <= after else []

    return script


def steps(*actions):
    return Profile("p", "title", tuple(Step(str(n), f"step {n}", each) for n, each in enumerate(actions, 1)))


def verdicts(report):
    return [each.verdict for each in report.results]


def test_steps_that_expect_silence_fail_if_the_target_is_dead():
    link = ScriptedLink("101.1.1", dying(after=1))
    report = run(steps(STATUS, STATUS, tell(COP, Standby())), link, link.id, began=0.0)
    assert verdicts(report) == [Verdict.PASS, Verdict.SILENT, Verdict.SILENT]
    assert report.results[2].reason == "the target is silent since step 2"


def test_steps_after_three_silent_ones_are_skipped():
    link = ScriptedLink("101.1.1", dying(after=1))
    report = run(steps(*[STATUS] * 50), link, link.id, began=0.0)
    assert verdicts(report) == [Verdict.PASS, *[Verdict.SILENT] * 3, *[Verdict.SKIPPED] * 46]
    assert report.results[-1].reason == "the target is silent since step 2"
    assert report.status == 1
    assert report.notes == ("the target is silent since step 2",)
    assert report.seconds < 20


def test_unanswered_query_alone_does_not_count_as_dead():
    def script(payload):
        return [(0.01, READY)] if payload[:2] == b"\x02\x20" else []

    link = ScriptedLink("101.1.1", script)
    ignored = ask(COP, QueryControl(), ReportControl)
    report = run(steps(STATUS, *[ignored] * 5, tell(COP, Standby()), STATUS), link, link.id, began=0.0)
    assert verdicts(report) == [Verdict.PASS, *[Verdict.SILENT] * 5, Verdict.PASS, Verdict.PASS]


@pytest.mark.slow
@pytest.mark.parametrize(
    "profile", [pytest.param("mobility-1.1", marks=pytest.mark.slow), "ugv-1.0", "manipulator-2.0"]
)
def test_robot_is_restored_at_the_end(profile):
    name, target = ("inc1", JausID(101, 1, 105)) if profile == "manipulator-2.0" else ("igvc", COMPONENT)
    virtual_target = robot(name=name, tick=None)
    examined(profile, virtual_target, target)
    assert is_free(virtual_target, target)


def test_exception_in_a_step_fails_it_and_the_others_run():
    def buggy(tester):
        tester.client(COP).nonsense()

    link = ScriptedLink("101.1.1", dying(after=9))
    report = run(steps(STATUS, buggy, STATUS), link, link.id, began=0.0)
    assert verdicts(report) == [Verdict.PASS, Verdict.FAIL, Verdict.PASS]
    reason = report.results[1].reason
    assert reason.startswith("the step itself has a bug: AttributeError: 'Client' object has no attribute 'nonsense' (")
    assert "test_endings.py:" in reason


def test_encode_error_in_a_step_fails_it():
    link = ScriptedLink("101.1.1", dying(after=9))
    report = run(steps(STATUS, tell(COP, SetTravelSpeed(1e9)), STATUS), link, link.id, began=0.0)
    assert verdicts(report) == [Verdict.PASS, Verdict.FAIL, Verdict.PASS]
    assert "the step itself has a bug: EncodeError: " in report.results[1].reason


def test_robot_is_restored_after_any_end_of_the_run():
    def full(result):
        if result.id == "2":
            raise OSError("no space left")

    virtual_target = robot(tick=None)
    with pytest.raises(OSError, match="no space left"):
        run(steps(STATUS, tell(COP, RequestControl(200)), STATUS), virtual_target, COMPONENT, began=0.0, watch=full)
    assert is_free(virtual_target)


@pytest.mark.slow
def test_target_that_is_shut_down_is_named_before_the_first_step():
    virtual_target = robot(timeout=5, component=1, tick=None)
    only = "NotControlled.Available.Standby/Query", "Controlled.Available.Ready/Shutdown/controller"
    assert examined("core-1.1", virtual_target, COMPONENT, only=only).status == 0
    report = examined("core-1.1", virtual_target, COMPONENT, only=only)
    assert report.problem.startswith("105.1.1 is shut down, as at the end of a test of core services: restart")
    assert (report.status, report.results) == (2, ())


def test_target_controlled_by_another_client_fails_once():
    virtual_target = robot(timeout=60, component=1, tick=None)
    virtual_target.components[COMPONENT].host.receive(RequestControl(255).encode(), JausID(7, 7, 7), 0.0)
    report = examined("core-1.1", virtual_target, COMPONENT, only=("NotControlled.Available.Standby/Query",))
    first, *others = report.results
    assert first.reason.startswith("105.1.1 reports status STANDBY, controlled by 7.7.7, and a test begins in ")
    assert {each.verdict for each in others} == {Verdict.SKIPPED}


def is_free(virtual_target, target=COMPONENT):
    seen = examined(steps(STATUS, ask(COP, QueryControl(), ReportControl)), virtual_target, target)
    status, control = (result.entries[-1].lines[0] for result in seen.results)
    return "STANDBY" in status and "subsystem_id=0" in control


def interrupt(tester):
    raise KeyboardInterrupt


def test_ctrl_c_restores_the_robot_and_keeps_the_report():
    virtual_target = robot(tick=None)
    emergency = tell("42.2.4", SetEmergency(SetEmergency.EmergencyCode.STOP))
    profile = steps(STATUS, tell(COP, RequestControl(200)), emergency, interrupt, STATUS)
    with pytest.raises(Interrupted) as stopped:
        examined(profile, virtual_target)
    report = stopped.value.report
    assert report.problem == "interrupted after 3 steps"
    assert len(report.results) == 3
    assert is_free(virtual_target)


def test_lost_network_is_reported():
    class Unplugged(ScriptedLink):
        def send(self, datagram, source, *, other_port=False):
            if self.sent:
                raise TransportError("cannot send to UDP 10.0.0.1:3794: Network is unreachable")
            super().send(datagram, source)

    link = Unplugged("101.1.1", dying(after=9))
    report = run(steps(STATUS, tell(COP, RequestControl(200)), STATUS), link, link.id, began=0.0)
    assert len(report.results) == 1
    assert report.status == 2
    assert "Network is unreachable" in report.problem
