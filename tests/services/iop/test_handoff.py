"""EnhancedAccessControl and HandoffController: requests queue, the client in control decides, motion stops."""

from __future__ import annotations

import pytest

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import ConfirmControl, RejectControl, ReleaseControl, RequestControl, Resume
from jauspy.messages.iop import (
    ConfirmHandoffRequest,
    ConfirmReleaseControl,
    QueryEnhancedTimeout,
    QueryHandoffTimeout,
    RemoveHandoffRequest,
    RequestHandoff,
    RequestReleaseControl,
)
from jauspy.services.core import AccessControl, Events, Management
from jauspy.services.iop import EnhancedAccessControl, HandoffController
from jauspy.services.iop.handoff import MAX_REQUESTS, Decision
from jauspy.services.service import Service

A, B, C = "42.1.1", "43.1.1", "44.1.1"
Code = ConfirmHandoffRequest.ResponseCode


class Motion(Service, urn="urn:jaus:jss:core:Liveness"):
    """Counts how often motion is stopped."""

    stops = 0

    def control_lost(self) -> None:
        self.stops += 1

    def report_heartbeat_pulse(self) -> None:
        """Nothing is answered."""


@pytest.fixture
def motion():
    return Motion()


@pytest.fixture
def rig(make, motion):
    rig = make(motion, AccessControl(timeout=0), Management(), EnhancedAccessControl(handoff_timeout=10))
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    return rig


def decided(id: int, decision: Decision) -> ConfirmReleaseControl:
    return ConfirmReleaseControl([ConfirmReleaseControl.ReleaseControlRec(id=id, response_code=decision)])


def queued(rig, client: str, authority: int = 50, why: str = "my turn") -> int:
    sent = rig.tell(client, RequestHandoff(authority, why))
    ((_, answer),) = [answer for answer in sent if answer[0] == client]
    assert answer.response_code == Code.QUEUED
    return answer.id


def test_request_is_queued_and_shown_to_the_client_in_control(rig):
    (to_b, answer), (to_a, shown) = rig.tell(B, RequestHandoff(50, "my turn"))
    assert (to_b, to_a) == (B, A)
    assert answer.response_code == Code.QUEUED
    (record,) = shown.request_release_control_list
    assert isinstance(shown, RequestReleaseControl)
    assert (record.id, record.src_subsystem_id, record.authority_code) == (answer.id, 43, 50)
    assert record.explanation == "my turn"


def test_granted_request_hands_control_over_and_stops_motion(rig, motion):
    id = queued(rig, B)
    before = motion.stops
    sent = rig.tell(A, decided(id, Decision.GRANTED))
    assert (B, ConfirmHandoffRequest(id, Code.GRANTED)) in sent
    assert (A, RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED)) in sent
    assert rig.host.controller == JausID.parse(B)
    assert motion.stops == before + 1
    assert rig.host.service(AccessControl).authority == 50
    assert rig.ask(B, RequestControl(50)).response_code == ConfirmControl.ResponseCode.CONTROL_ACCEPTED


def test_only_the_client_in_control_decides(rig):
    id = queued(rig, B)
    assert rig.tell(B, decided(id, Decision.GRANTED)) == []
    assert rig.tell(C, decided(id, Decision.GRANTED)) == []
    assert rig.host.controller == JausID.parse(A)


def test_denied_request_ends(rig):
    id = queued(rig, B)
    assert rig.tell(A, decided(id, Decision.DENIED)) == [(B, ConfirmHandoffRequest(id, Code.DENIED))]
    assert rig.host.service(EnhancedAccessControl).requests == ()
    assert rig.run(100) == []


def test_request_that_nobody_answers_times_out(rig):
    id = queued(rig, B)
    ((when, to, answer),) = rig.run(20)
    assert (when, to, answer) == (10.0, B, ConfirmHandoffRequest(id, Code.TIMEOUT))


def test_request_that_was_put_off_waits_longer(rig):
    id = queued(rig, B)
    assert rig.tell(A, decided(id, Decision.WAIT)) == [(B, ConfirmHandoffRequest(id, Code.DEFERRED))]
    ((when, _, answer),) = rig.run(100)
    assert (when, answer.response_code) == (60.0, Code.TIMEOUT)


def test_second_request_of_a_client_replaces_its_first(rig):
    first = queued(rig, B)
    assert queued(rig, B, 60, "urgent") == first
    (request,) = rig.host.service(EnhancedAccessControl).requests
    assert (request.authority, request.explanation) == (60, "urgent")


def test_request_can_be_taken_back(rig):
    id = queued(rig, B)
    assert rig.tell(B, RemoveHandoffRequest(id)) == [(B, ConfirmHandoffRequest(id, Code.DENIED))]
    assert rig.host.service(EnhancedAccessControl).requests == ()


def test_first_of_several_grants_counts_and_the_others_are_shown_to_the_next_client(rig):
    first, second = queued(rig, B), queued(rig, C)
    rig.tell(A, decided(first, Decision.GRANTED))
    assert rig.host.controller == JausID.parse(B)
    (left,) = rig.host.service(EnhancedAccessControl).requests
    assert left.id == second
    sent = rig.tell(B, decided(second, Decision.GRANTED))
    assert (C, ConfirmHandoffRequest(second, Code.GRANTED)) in sent


@pytest.mark.slow
def test_insufficient_authority_is_refused(make):
    rig = make(AccessControl(default_authority=20, timeout=0), Management(), EnhancedAccessControl())
    rig.tell(A, RequestControl(100))
    assert rig.ask(B, RequestHandoff(10, "")).response_code == Code.INSUFFICIENT_AUTHORITY
    id = queued(rig, B, 30)
    sent = rig.tell(B, RequestHandoff(10, ""))
    assert (B, ConfirmHandoffRequest(id, Code.INSUFFICIENT_AUTHORITY)) in sent
    assert rig.host.service(EnhancedAccessControl).requests == ()


def test_requests_end_when_nobody_is_in_control(rig):
    id = queued(rig, B)
    sent = rig.tell(A, ReleaseControl())
    assert (B, ConfirmHandoffRequest(id, Code.DENIED)) in sent
    assert rig.ask(B, RequestHandoff(50, "")).response_code == Code.DENIED


def test_queue_is_bounded_and_counted(rig):
    for number in range(MAX_REQUESTS):
        queued(rig, f"50.1.{number + 1}")
    sent = rig.tell(B, RequestHandoff(50, "one more"))
    assert sent[0] == (B, ConfirmHandoffRequest(0, Code.NOT_AVAILABLE))
    assert rig.host.counters["handoff_not_queued"] == 1
    assert len(rig.host.service(EnhancedAccessControl).requests) == MAX_REQUESTS


def test_unknown_requests_are_counted(rig):
    assert rig.tell(A, decided(77, Decision.GRANTED)) == []
    assert rig.host.counters["handoff_unknown"] == 1
    assert rig.host.controller == JausID.parse(A)


def test_timeouts_are_reported(rig):
    assert rig.ask(B, QueryHandoffTimeout()).timeout == 10
    assert rig.ask(B, QueryEnhancedTimeout()).timeout == 60


@pytest.mark.parametrize("seconds", [0, 256, -1])
def test_impossible_timeouts_are_named(seconds):
    with pytest.raises(ConfigError, match=r"handoff_timeout is .* must be 1..255"):
        EnhancedAccessControl(handoff_timeout=seconds)


# --- the client's side ----------------------------------------------------------------------------------------------


def shown(*ids: int) -> RequestReleaseControl:
    record = RequestReleaseControl.RequestReleaseControlRec
    return RequestReleaseControl([record(id, 43, 1, 1, 50, f"reason {id}") for id in ids])


def test_client_answers_what_it_decides(make):
    asked = []

    def decide(component, request):
        asked.append((component, request.client, request.explanation))
        return Decision.DENIED if request.id == 2 else None

    controller = HandoffController(decide)
    rig = make(controller, Events())
    assert rig.tell("101.1.110", shown(1, 2)) == [("101.1.110", decided(2, Decision.DENIED))]
    assert asked[0] == (JausID(101, 1, 110), JausID(43, 1, 1), "reason 1")
    controller.answer(JausID(101, 1, 110), 1, Decision.GRANTED)
    assert rig.sent() == [("101.1.110", decided(1, Decision.GRANTED))]


def test_client_without_a_decision_answers_nothing(make):
    rig = make(HandoffController(), Events())
    assert rig.tell("101.1.110", shown(1)) == []
    assert rig.tell("101.1.110", ConfirmHandoffRequest(1, Code.GRANTED)) == []
    assert rig.host.counters["handoff_unawaited"] == 1


def test_flood_of_requests_is_cut(make):
    rig = make(HandoffController(lambda component, request: Decision.DENIED), Events())
    ((_, answer),) = rig.tell("101.1.110", shown(*range(1, 255)))
    assert len(answer.release_control_list) == MAX_REQUESTS
