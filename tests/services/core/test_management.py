"""Every transition of Management 1.1."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from jauspy.messages.core import (
    ClearEmergency,
    ConfirmControl,
    DateStamp,
    QueryControl,
    QueryHeartbeatPulse,
    QueryStatus,
    QueryTime,
    RejectControl,
    ReleaseControl,
    ReportHeartbeatPulse,
    ReportStatus,
    ReportTime,
    RequestControl,
    Reset,
    Resume,
    SetAuthority,
    SetEmergency,
    SetTime,
    Shutdown,
    Standby,
    TimeStamp,
)
from jauspy.messages.mobility import QueryLocalPose, QueryLocalPoseExt, QueryVelocityState, QueryVelocityStateExt
from jauspy.services.core import AccessControl, Liveness, Management
from jauspy.services.core.management import MAX_EMERGENCY_CLIENTS

A, B, C = "42.1.1", "42.2.1", "42.2.2"
BUSY = ConfirmControl(ConfirmControl.ResponseCode.NOT_AVAILABLE)
RELEASED = RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED)
REFUSED = RejectControl(RejectControl.ResponseCode.NOT_AVAILABLE)
STOP = SetEmergency(1)
CLEAR = ClearEmergency(1)

FREE_STANDBY = "Receiving.Ready.NotControlled.Available.Standby"
FREE_EMERGENCY = "Receiving.Ready.NotControlled.NotAvailable.Emergency"
FREE_FAILURE = "Receiving.Ready.NotControlled.NotAvailable.Failure"
FREE_SHUTDOWN = "Receiving.Ready.NotControlled.NotAvailable.Shutdown"
HELD_STANDBY = "Receiving.Ready.Controlled.Available.Standby"
HELD_READY = "Receiving.Ready.Controlled.Available.Ready"
HELD_EMERGENCY = "Receiving.Ready.Controlled.NotAvailable.Emergency"

WAY_THERE = {
    FREE_STANDBY: [],
    FREE_EMERGENCY: [(B, STOP)],
    FREE_SHUTDOWN: [(A, RequestControl(100)), (A, Shutdown())],
    HELD_STANDBY: [(A, RequestControl(100))],
    HELD_READY: [(A, RequestControl(100)), (A, Resume())],
    HELD_EMERGENCY: [(A, RequestControl(100)), (A, Resume()), (B, STOP)],
}

# (state before, who sends, what, who gets what, state afterwards); A is in control where somebody is, B set emergencies
TRANSITIONS = [
    (FREE_STANDBY, A, Resume(), [], FREE_STANDBY),
    (FREE_STANDBY, A, Standby(), [], FREE_STANDBY),
    (FREE_STANDBY, A, Reset(), [], FREE_STANDBY),
    (FREE_STANDBY, A, Shutdown(), [], FREE_STANDBY),
    (FREE_STANDBY, B, STOP, [], FREE_EMERGENCY),
    (FREE_STANDBY, B, CLEAR, [], FREE_STANDBY),
    (FREE_EMERGENCY, B, CLEAR, [], FREE_STANDBY),
    (FREE_EMERGENCY, A, CLEAR, [], FREE_EMERGENCY),
    (FREE_EMERGENCY, A, RequestControl(200), [(A, BUSY)], FREE_EMERGENCY),
    (FREE_EMERGENCY, A, ReleaseControl(), [(A, RELEASED)], FREE_EMERGENCY),
    (FREE_EMERGENCY, A, SetAuthority(5), [], FREE_EMERGENCY),
    (FREE_EMERGENCY, A, Shutdown(), [], FREE_EMERGENCY),
    (FREE_EMERGENCY, A, Reset(), [], FREE_EMERGENCY),
    (FREE_SHUTDOWN, A, RequestControl(200), [(A, BUSY)], FREE_SHUTDOWN),
    (FREE_SHUTDOWN, B, STOP, [], FREE_EMERGENCY),
    (HELD_STANDBY, A, Resume(), [], HELD_READY),
    (HELD_STANDBY, B, Resume(), [], HELD_STANDBY),
    (HELD_STANDBY, A, Reset(), [(A, RELEASED)], FREE_STANDBY),
    (HELD_STANDBY, B, Reset(), [], HELD_STANDBY),
    (HELD_STANDBY, A, Shutdown(), [(A, RELEASED)], FREE_SHUTDOWN),
    (HELD_STANDBY, B, Shutdown(), [], HELD_STANDBY),
    (HELD_STANDBY, B, STOP, [], HELD_EMERGENCY),
    (HELD_STANDBY, A, ReleaseControl(), [(A, RELEASED)], FREE_STANDBY),
    (HELD_READY, A, Standby(), [], HELD_STANDBY),
    (HELD_READY, B, Standby(), [], HELD_READY),
    (HELD_READY, A, Reset(), [(A, RELEASED)], FREE_STANDBY),
    (HELD_READY, A, Shutdown(), [(A, RELEASED)], FREE_SHUTDOWN),
    (HELD_READY, C, STOP, [], HELD_EMERGENCY),
    (HELD_READY, A, ReleaseControl(), [(A, RELEASED)], FREE_STANDBY),
    (HELD_EMERGENCY, B, CLEAR, [], HELD_READY),
    (HELD_EMERGENCY, A, CLEAR, [], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, RequestControl(200), [(A, BUSY)], HELD_EMERGENCY),
    (HELD_EMERGENCY, C, RequestControl(200), [(C, BUSY)], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, ReleaseControl(), [(A, REFUSED)], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, SetAuthority(5), [], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, Standby(), [], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, Resume(), [], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, Reset(), [], HELD_EMERGENCY),
    (HELD_EMERGENCY, A, Shutdown(), [], HELD_EMERGENCY),
]


@pytest.fixture
def rig(make):
    return make(Management(), AccessControl(timeout=5))


@pytest.mark.parametrize("row", TRANSITIONS)
def test_transitions(rig, row) -> None:
    before, client, message, answers, after = row
    for who, what in WAY_THERE[before]:
        rig.tell(who, what)
    assert rig.host.state == before
    assert rig.tell(client, message) == answers
    assert rig.host.state == after


@pytest.mark.parametrize(
    ("state", "status"),
    [
        (FREE_STANDBY, "STANDBY"),
        (FREE_EMERGENCY, "EMERGENCY"),
        (FREE_SHUTDOWN, "SHUTDOWN"),
        (HELD_STANDBY, "STANDBY"),
        (HELD_READY, "READY"),
        (HELD_EMERGENCY, "EMERGENCY"),
    ],
)
def test_status_is_reported_in_every_state_to_all_clients(rig, state, status) -> None:
    for who, what in WAY_THERE[state]:
        rig.tell(who, what)
    answer = rig.ask(C, QueryStatus())
    assert answer == ReportStatus(status=ReportStatus.Status[status], reserved=0)
    assert len(answer.encode()) == 2 + 5
    assert rig.host.status is ReportStatus.Status[status]


@pytest.mark.parametrize(
    ("before", "answers", "after"),
    [
        (FREE_STANDBY, [], FREE_FAILURE),
        (HELD_READY, [(A, RELEASED)], FREE_FAILURE),
        (FREE_EMERGENCY, [], FREE_EMERGENCY),
        (HELD_EMERGENCY, [], HELD_EMERGENCY),
    ],
)
def test_failure_is_entered_and_kept(rig, before, answers, after) -> None:
    for who, what in WAY_THERE[before]:
        rig.tell(who, what)
    rig.host.fire("Failure")
    assert rig.sent() == answers
    assert rig.host.state == after
    if after == FREE_FAILURE:
        assert rig.host.status is ReportStatus.Status.FAILURE
        assert rig.ask(A, RequestControl(100)) == BUSY


@pytest.mark.parametrize("state", [HELD_STANDBY, HELD_READY])
def test_control_timeout_enters_standby(rig, state) -> None:
    for who, what in WAY_THERE[state]:
        rig.tell(who, what)
    assert rig.run(5.0) == [(5.0, A, RELEASED)]
    assert rig.host.state == FREE_STANDBY


def test_emergency_lasts_until_all_clients_have_cleared_it(rig) -> None:
    for client in (B, C, B, B):
        rig.tell(client, STOP)
    rig.tell(B, CLEAR)
    assert rig.host.state == FREE_EMERGENCY
    rig.tell(B, CLEAR)
    assert rig.host.state == FREE_EMERGENCY
    rig.tell(C, CLEAR)
    assert rig.host.state == FREE_STANDBY
    rig.tell(C, STOP)
    rig.tell(C, CLEAR)
    assert rig.host.state == FREE_STANDBY


def test_repeated_emergencies_take_no_memory(rig) -> None:
    clients = [f"{number}.1.1" for number in range(1, MAX_EMERGENCY_CLIENTS + 3)]
    for client in 2 * clients:
        rig.tell(client, STOP)
    assert len(rig.host.service(Management)._emergency_clients) == MAX_EMERGENCY_CLIENTS
    assert rig.host.counters["emergency_not_remembered"] == 4
    for client in clients:
        rig.tell(client, CLEAR)
    assert rig.host.state == FREE_EMERGENCY
    assert len(rig.host.service(Management)._emergency_clients) == 0


def test_initialization_may_be_lengthy(make) -> None:
    class Slow(Management):
        def initialize(self) -> None:
            self.host.set_timer("warm up", self.host.now + 2.0, lambda: self.host.fire("Initialized"))

    rig = make(Slow(), AccessControl(timeout=5))
    rig.tell(A, RequestControl(100))
    assert rig.tell(A, Reset()) == [(A, RELEASED)]
    assert rig.host.status is ReportStatus.Status.INITIALIZE
    assert rig.ask(A, RequestControl(100)) == BUSY
    rig.run(2.0)
    assert rig.host.state == FREE_STANDBY
    assert rig.ask(A, QueryControl()).authority_code == 0


def test_emergency_restarts_the_initialization_afterwards(make) -> None:
    class Slow(Management):
        def initialize(self) -> None:
            self.host.set_timer("warm up", self.host.now + 2.0, lambda: self.host.fire("Initialized"))

    rig = make(Slow())
    rig.tell(A, RequestControl(100))
    rig.tell(A, Reset())
    rig.tell(B, STOP)
    rig.run(10.0)
    assert rig.host.status is ReportStatus.Status.EMERGENCY
    rig.tell(B, CLEAR)
    assert rig.host.status is ReportStatus.Status.INITIALIZE
    rig.run(2.0)
    assert rig.host.status is ReportStatus.Status.STANDBY


def test_emergency_code_is_ignored(make) -> None:
    """Components of other stacks send code 0, which the value set does not have."""
    rig = make(Management())
    assert rig.tell(A, bytes.fromhex("06000000")) == []
    assert rig.host.state == FREE_EMERGENCY
    assert rig.host.counters["deviating_SetEmergency"] == 1
    rig.tell(A, bytes.fromhex("07000000"))
    assert rig.host.state == FREE_STANDBY


def test_truncated_emergency_is_malformed(make) -> None:
    rig = make(Management())
    rig.tell(A, bytes.fromhex("060001"))
    assert rig.host.state == FREE_STANDBY
    assert rig.host.counters["malformed_SetEmergency"] == 1


A, B = "42.1.1", "42.2.1"
NOW = ReportTime(TimeStamp(535, 26, 9, 15, 14), DateStamp(14, 3, 26))


def test_heartbeat(robot) -> None:
    assert robot.ask(A, QueryHeartbeatPulse()) == ReportHeartbeatPulse()


def test_time_by_presence_vector(robot) -> None:
    assert robot.ask(A, QueryTime(0xFF)) == NOW
    assert robot.ask(A, QueryTime(1)) == ReportTime(time_stamp=NOW.time_stamp)
    assert robot.ask(A, QueryTime(2)) == ReportTime(date_stamp=NOW.date_stamp)
    assert robot.ask(A, QueryTime(0)) == ReportTime()


def test_setting_the_time_requires_control(robot) -> None:
    wanted = SetTime(TimeStamp(0, 1, 2, 3, 31), DateStamp(31, 12, 30))
    robot.tell(A, wanted)
    assert robot.ask(A, QueryTime(3)) == NOW
    robot.tell(A, RequestControl(100))
    robot.tell(B, wanted)
    assert robot.ask(A, QueryTime(3)) == NOW
    robot.tell(A, wanted)
    assert robot.ask(A, QueryTime(3)) == ReportTime(wanted.time_stamp, wanted.date_stamp)
    robot.run(2.5)
    assert robot.ask(A, QueryTime(1)).time_stamp == TimeStamp(500, 3, 2, 3, 31)


@pytest.mark.parametrize(
    ("wanted", "after"),
    [
        (SetTime(time_stamp=TimeStamp(1, 2, 3, 4, 5)), ReportTime(TimeStamp(1, 2, 3, 4, 5), DateStamp(5, 3, 26))),
        (SetTime(date_stamp=DateStamp(1, 2, 30)), ReportTime(TimeStamp(535, 26, 9, 15, 1), DateStamp(1, 2, 30))),
        (SetTime(), NOW),
        (SetTime(date_stamp=DateStamp(31, 2, 26)), NOW),
    ],
    ids=["time", "date", "nothing", "30 February"],
)
def test_parts_of_the_time(robot, wanted, after) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, wanted)
    assert robot.ask(A, QueryTime(3)) == after
    assert robot.host.counters["impossible_time"] == (wanted == SetTime(date_stamp=DateStamp(31, 2, 26)))


def test_time_stamps_use_the_set_time(robot) -> None:
    wanted = TimeStamp(0, 1, 2, 3, 31)
    robot.tell(A, RequestControl(100))
    robot.tell(A, SetTime(wanted, DateStamp(31, 12, 30)))
    for query in (QueryLocalPose(0xFFFF), QueryVelocityState(0xFFFF)):
        assert robot.ask(A, query).time_stamp == wanted
    since_1970 = int(datetime(2030, 12, 31, 3, 2, 1, tzinfo=UTC).timestamp())
    assert robot.ask(A, QueryLocalPoseExt(0xFFFF)).time_seconds == since_1970
    velocity = robot.ask(A, QueryVelocityStateExt(0xFF, 0xFFFF))
    assert velocity.report_velocity_state_ext_rec.time_seconds == since_1970


def test_wall_clock_is_used_without_the_service(make) -> None:
    rig = make(Liveness())
    assert rig.host.utc_time == rig.host.utc_now()


def test_year_beyond_32_bits_keeps_the_report(robot) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, SetTime(TimeStamp(0, 1, 2, 3, 31), DateStamp(31, 12, 107)))
    report = robot.ask(A, QueryLocalPoseExt(0xFFFF))
    assert (report.time_seconds, report.time_nano_seconds) == (None, None)
    assert report.x is not None
