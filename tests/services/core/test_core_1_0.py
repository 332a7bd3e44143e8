"""The core services in version 1.0, where it differs: other states, another name for the time-out, fewer messages."""

from __future__ import annotations

import pytest

from jauspy.messages.core import (
    CancelEvent,
    ClearEmergency,
    ConfirmControl,
    ConfirmEventRequest,
    CreateEvent,
    Event,
    QueryHeartbeatPulse,
    QueryStatus,
    QueryTime,
    RejectControl,
    RejectEventRequest,
    ReleaseControl,
    ReportTime,
    RequestControl,
    Reset,
    Resume,
    SetAuthority,
    SetEmergency,
    Shutdown,
    Standby,
    UpdateEvent,
)
from jauspy.services.core import AccessControl, Events, Liveness, Management, Time
from jauspy.services.core.management import Management as _Management

A, B = "42.1.1", "42.2.1"
Answer = ConfirmControl.ResponseCode
RELEASED = RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED)
REFUSED = RejectControl(RejectControl.ResponseCode.NOT_AVAILABLE)

FREE = "Receiving.Ready.NotControlled.StateA"
HELD = "Receiving.Ready.Controlled.StateB"


class Management10(Management, version="1.0"):
    pass


class Time10(Time, version="1.0"):
    pass


class Liveness10(Liveness, version="1.0"):
    pass


@pytest.fixture
def rig(make):
    return make(Management10(), Time10(), Liveness10(), AccessControl(default_authority=10, timeout=5), Events())


def confirm(code: Answer) -> ConfirmControl:
    return ConfirmControl(code)


WAY_THERE = {
    f"{FREE}.Standby": [],
    f"{FREE}.Emergency": [(B, SetEmergency(1))],
    f"{FREE}.Shutdown": [(A, RequestControl(100)), (A, Shutdown())],
    f"{HELD}.Standby": [(A, RequestControl(100))],
    f"{HELD}.Ready": [(A, RequestControl(100)), (A, Resume())],
    f"{HELD}.Emergency": [(A, RequestControl(100)), (A, Resume()), (B, SetEmergency(1))],
}

TRANSITIONS = [
    (f"{FREE}.Standby", A, RequestControl(9), [(A, confirm(Answer.INSUFFICIENT_AUTHORITY))], f"{FREE}.Standby"),
    (f"{FREE}.Standby", A, RequestControl(10), [(A, confirm(Answer.CONTROL_ACCEPTED))], f"{HELD}.Standby"),
    (f"{FREE}.Standby", A, ReleaseControl(), [(A, RELEASED)], f"{FREE}.Standby"),
    (f"{FREE}.Shutdown", A, RequestControl(200), [(A, confirm(Answer.NOT_AVAILABLE))], f"{FREE}.Shutdown"),
    (f"{FREE}.Emergency", A, RequestControl(200), [(A, confirm(Answer.NOT_AVAILABLE))], f"{FREE}.Emergency"),
    (f"{FREE}.Emergency", A, ClearEmergency(1), [], f"{FREE}.Emergency"),
    (f"{FREE}.Emergency", B, ClearEmergency(1), [], f"{FREE}.Standby"),
    (
        f"{HELD}.Ready",
        B,
        RequestControl(101),
        [(A, RELEASED), (B, confirm(Answer.CONTROL_ACCEPTED))],
        f"{HELD}.Ready",
    ),
    (f"{HELD}.Ready", B, RequestControl(100), [(B, confirm(Answer.INSUFFICIENT_AUTHORITY))], f"{HELD}.Ready"),
    (f"{HELD}.Ready", A, RequestControl(9), [(A, RELEASED)], f"{FREE}.Standby"),
    (f"{HELD}.Ready", A, RequestControl(50), [(A, confirm(Answer.CONTROL_ACCEPTED))], f"{HELD}.Ready"),
    (f"{HELD}.Ready", B, ReleaseControl(), [], f"{HELD}.Ready"),
    (f"{HELD}.Ready", A, Standby(), [], f"{HELD}.Standby"),
    (f"{HELD}.Ready", A, Reset(), [(A, RELEASED)], f"{FREE}.Standby"),
    (f"{HELD}.Ready", A, Shutdown(), [(A, RELEASED)], f"{FREE}.Shutdown"),
    (f"{HELD}.Emergency", B, RequestControl(200), [(B, confirm(Answer.NOT_AVAILABLE))], f"{HELD}.Emergency"),
    (f"{HELD}.Emergency", A, ReleaseControl(), [(A, REFUSED)], f"{HELD}.Emergency"),
    (f"{HELD}.Emergency", A, SetAuthority(50), [], f"{HELD}.Emergency"),
    (f"{HELD}.Emergency", B, ClearEmergency(1), [], f"{HELD}.Ready"),
]


@pytest.mark.parametrize("row", TRANSITIONS)
def test_transitions(rig, row) -> None:
    before, client, message, answers, after = row
    for who, what in WAY_THERE[before]:
        rig.tell(who, what)
    assert rig.host.state == before
    assert rig.tell(client, message) == answers
    assert rig.host.state == after


def test_control_times_out_by_the_older_name_of_the_event(rig) -> None:
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    assert rig.run(10.0) == [(5.0, A, RELEASED)]
    assert rig.host.state == f"{FREE}.Standby"


def test_client_that_dies_in_an_emergency_loses_control_afterwards(rig) -> None:
    rig.tell(A, RequestControl(100))
    rig.tell(B, SetEmergency(1))
    assert rig.run(60.0) == []
    rig.tell(B, ClearEmergency(1))
    assert [(to, message) for _, to, message in rig.run(5.0)] == [(A, RELEASED)]


@pytest.mark.parametrize("state", WAY_THERE)
def test_every_state_reports_its_status(rig, state) -> None:
    for who, what in WAY_THERE[state]:
        rig.tell(who, what)
    assert rig.ask(B, QueryStatus()).status.name == state.rpartition(".")[2].upper()


def test_initialization_comes_first(make) -> None:
    class Slow(_Management, version="1.0"):
        def initialize(self) -> None:
            pass

    rig = make(Slow())
    assert rig.host.state == f"{FREE}.Init"
    assert rig.ask(A, RequestControl(200)) == confirm(Answer.NOT_AVAILABLE)
    rig.host.fire("Initialized")
    assert rig.host.state == f"{FREE}.Standby"


def test_failure_notifies_the_controller(rig) -> None:
    rig.tell(A, RequestControl(100))
    rig.host.fire("Failure")
    assert rig.sent() == [(A, RELEASED)]
    assert rig.host.state == f"{FREE}.Failure"


def test_events_do_not_time_out_and_have_no_command_events(rig) -> None:
    id = rig.ask(A, CreateEvent(7, 0, 1.0, QueryHeartbeatPulse())).event_id
    assert {type(message) for *_, message in rig.run(200.0)} == {Event}
    assert rig.ask(A, UpdateEvent(8, 1, 0.0, id, QueryStatus())) == ConfirmEventRequest(8, id, 0.0)
    assert rig.ask(B, CancelEvent(9, id)) == RejectEventRequest(9, 6)
    assert rig.ask(A, CancelEvent(9, id)) == ConfirmEventRequest(9, id, 0.0)
    assert rig.ask(A, CreateEvent(7, 0, 1.0, b"\xff\xff")) == RejectEventRequest(7, 5)
    assert rig.run(10.0) == []
    assert rig.tell(A, bytes.fromhex("f601 01 01000000 02000000 0300")) == []
    assert rig.host.counters["unknown_message"] == 1


def test_time_and_heartbeat_are_answered(rig) -> None:
    assert isinstance(rig.ask(A, QueryTime(presence_vector=3)), ReportTime)
    assert rig.ask(A, QueryHeartbeatPulse()).NAME == "ReportHeartbeatPulse"


def test_closing_component_notifies_clients(rig) -> None:
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    first = rig.ask(A, CreateEvent(7, 0, 1.0, QueryHeartbeatPulse()))
    second = rig.ask(B, CreateEvent(8, 0, 1.0, QueryHeartbeatPulse()))
    rig.host.leave(rig.now)
    assert rig.sent() == [(A, RELEASED), (A, first), (B, second)]
    assert rig.host.state == f"{FREE}.Standby"
    assert rig.run(10.0) == []
    assert rig.host.counters["action_failed"] == 0
