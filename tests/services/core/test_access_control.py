"""Every transition of AccessControl 1.1, and what the state chart leaves to the service."""

from __future__ import annotations

import pytest

from jauspy.errors import ConfigError
from jauspy.messages.core import (
    ClearEmergency,
    ConfirmControl,
    QueryAuthority,
    QueryControl,
    QueryTimeout,
    RejectControl,
    ReleaseControl,
    ReportAuthority,
    ReportControl,
    ReportTimeout,
    RequestControl,
    Resume,
    SetAuthority,
    SetEmergency,
)
from jauspy.services.core import AccessControl, Management

A, B = "42.1.1", "42.2.1"
ACCEPTED = ConfirmControl(ConfirmControl.ResponseCode.CONTROL_ACCEPTED)
BUSY = ConfirmControl(ConfirmControl.ResponseCode.NOT_AVAILABLE)
TOO_LOW = ConfirmControl(ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY)
RELEASED = RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED)
REFUSED = RejectControl(RejectControl.ResponseCode.NOT_AVAILABLE)

FREE = "Receiving.Ready.NotControlled.Available"
HELD = "Receiving.Ready.Controlled.Available"


@pytest.fixture
def rig(make):
    """AccessControl alone, default authority 10, which client A may hold with authority 100."""
    return make(AccessControl(default_authority=10, timeout=5))


# (A has control with 100 before, who sends, what, who gets what, state afterwards)
TRANSITIONS = [
    (False, A, RequestControl(9), [(A, TOO_LOW)], FREE),
    (False, A, RequestControl(10), [(A, ACCEPTED)], HELD),
    (False, A, ReleaseControl(), [(A, RELEASED)], FREE),
    (False, A, SetAuthority(50), [], FREE),
    (False, A, QueryAuthority(), [(A, ReportAuthority(10))], FREE),
    (False, A, QueryTimeout(), [(A, ReportTimeout(5))], FREE),
    (False, A, QueryControl(), [(A, ReportControl(0, 0, 0, 0))], FREE),
    (True, B, RequestControl(101), [(A, RELEASED), (B, ACCEPTED)], HELD),
    (True, B, RequestControl(100), [(B, TOO_LOW)], HELD),
    (True, B, RequestControl(9), [(B, TOO_LOW)], HELD),
    (True, A, RequestControl(10), [(A, ACCEPTED)], HELD),
    (True, A, RequestControl(200), [(A, ACCEPTED)], HELD),
    (True, A, RequestControl(9), [(A, RELEASED)], FREE),
    (True, A, ReleaseControl(), [(A, RELEASED)], FREE),
    (True, B, ReleaseControl(), [], HELD),
    (True, B, QueryAuthority(), [(B, ReportAuthority(100))], HELD),
    (True, B, QueryTimeout(), [(B, ReportTimeout(5))], HELD),
    (True, B, QueryControl(), [(B, ReportControl(42, 1, 1, 100))], HELD),
]


@pytest.mark.parametrize("row", TRANSITIONS)
def test_transitions(rig, row) -> None:
    held, client, message, answers, state = row
    if held:
        assert rig.ask(A, RequestControl(100)) == ACCEPTED
    assert rig.tell(client, message) == answers
    assert rig.host.state == state


@pytest.mark.parametrize(
    ("client", "authority", "after"), [(A, 99, 99), (A, 10, 10), (A, 9, 100), (A, 101, 100), (B, 50, 100)]
)
def test_controller_can_only_lower_its_authority(rig, client, authority, after) -> None:
    rig.ask(A, RequestControl(100))
    assert rig.tell(client, SetAuthority(authority)) == []
    assert rig.ask(A, QueryAuthority()) == ReportAuthority(after)


def test_control_times_out_unless_renewed(rig) -> None:
    rig.ask(A, RequestControl(100))
    assert rig.run(4.9) == []
    assert rig.ask(A, RequestControl(100)) == ACCEPTED
    assert rig.run(4.9) == []
    assert rig.run(10.0) == [(pytest.approx(9.9), A, RELEASED)]
    assert rig.host.controller is None
    assert rig.ask(A, QueryAuthority()) == ReportAuthority(10)


def test_rejected_request_does_not_renew_control(rig) -> None:
    rig.ask(A, RequestControl(100))
    rig.run(3.0)
    assert rig.ask(B, RequestControl(50)) == TOO_LOW
    assert [when for when, *_ in rig.run(3.0)] == [5.0]


def test_timeout_restarts_for_a_new_controller(rig) -> None:
    rig.ask(A, RequestControl(100))
    rig.run(3.0)
    rig.tell(B, RequestControl(101))
    assert rig.run(10.0) == [(8.0, B, RELEASED)]


def test_no_timer_runs_without_a_controller(rig) -> None:
    rig.ask(A, RequestControl(100))
    assert rig.host.next_timeout() == 5.0
    rig.ask(A, ReleaseControl())
    assert rig.host.next_timeout() is None


def test_zero_never_times_out(make) -> None:
    rig = make(AccessControl(timeout=0))
    rig.ask(A, RequestControl(100))
    assert rig.run(1e6) == []
    assert rig.ask(A, QueryTimeout()) == ReportTimeout(0)


@pytest.mark.parametrize("options", [{"timeout": 256}, {"timeout": -1}, {"default_authority": 256}])
def test_settings_outside_of_their_fields_are_rejected(options) -> None:
    with pytest.raises(ConfigError, match=r"must be 0\.\.255"):
        AccessControl(**options)


def test_client_that_dies_in_an_emergency_loses_control_afterwards(make) -> None:
    rig = make(AccessControl(timeout=5), Management())
    rig.ask(A, RequestControl(100))
    rig.tell(A, Resume())
    rig.run(1.0)
    rig.tell(B, SetEmergency(1))
    assert rig.run(60.0) == []
    assert rig.host.controller is not None
    rig.tell(B, ClearEmergency(1))
    assert [(to, message) for _, to, message in rig.run(5.0)] == [(A, RELEASED)]
    assert rig.host.state == f"{FREE}.Standby"


def test_services_share_one_access_control(robot) -> None:
    assert robot.ask(A, RequestControl(100)) == ACCEPTED
    assert robot.ask(B, RequestControl(100)) == TOO_LOW
    assert str(robot.host.controller) == A


def test_unreachable_client_loses_control(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.host.unreachable(robot.ID.parse(B), 0.0)
    assert str(robot.host.controller) == A
    stops = drive.stops
    robot.host.unreachable(robot.ID.parse(A), 0.0)
    assert robot.host.controller is None
    assert drive.stops > stops
