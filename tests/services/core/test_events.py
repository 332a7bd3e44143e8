from __future__ import annotations

from dataclasses import replace

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    ConfirmEventRequest,
    CreateEvent,
    Event,
    EventTypeRec,
    QueryControl,
    QueryEvents,
    QueryEventTimeout,
    QueryHeartbeatPulse,
    QueryStatus,
    RejectEventRequest,
    ReportControl,
    ReportEvents,
    ReportEventTimeout,
    ReportHeartbeatPulse,
    ReportStatus,
    RequestControl,
    Resume,
    UpdateEvent,
)
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.services.core import AccessControl, Events, Liveness, Management

A, B = "42.1.1", "42.2.1"
PERIODIC, ON_CHANGE = 0, 1
STEP = 1092 / 65535
ALL = QueryEvents(AllEventsRec(0))
X_AND_Y = 0b11


def create(query=None, rate: float = 1.0, kind: int = PERIODIC, request: int = 7) -> CreateEvent:
    return CreateEvent(request, kind, rate, query or QueryStatus())


def update(id: int, query=None, rate: float = 1.0, kind: int = PERIODIC) -> UpdateEvent:
    return UpdateEvent(8, kind, rate, id, query or QueryStatus())


def refusal(answer) -> int:
    assert isinstance(answer, RejectEventRequest)
    return answer.response_code


@pytest.fixture
def rig(make):
    return make(Management(), AccessControl(timeout=0), Liveness(), Events(timeout=0))


def test_the_raw_rate_60_is_one_hertz_not_sixty(rig) -> None:
    rig.host.receive(bytes.fromhex("f001 01 00 3c00 02000000 0222"), rig.ID.parse(A), 0.0)
    ((to, confirmed),) = rig.sent()
    assert (to, confirmed.encode()[2:]) == (A, bytes([1, confirmed.event_id, 0x3C, 0]))
    events = rig.run(100.0)
    assert len(events) == 100
    assert [when for when, *_ in events] == pytest.approx([n / (60 * STEP) for n in range(100)])
    assert [event.sequence_number for *_, event in events] == list(range(100))
    assert {to for _, to, _ in events} == {A}
    assert events[0][2].report_message == ReportHeartbeatPulse()


def test_sequence_numbers_wrap_after_255(rig) -> None:
    rig.ask(A, create(rate=100 * STEP))
    assert [event.sequence_number for *_, event in rig.run(200.0)][254:258] == [254, 255, 0, 1]


def test_confirmed_rates_are_kept(make) -> None:
    rig = make(Management(), Events(max_rate=50.0, timeout=0))
    confirmed = rig.ask(A, create(rate=1000.0))
    assert confirmed.confirmed_periodic_rate == pytest.approx(50.0, abs=STEP)
    assert len(rig.run(9.999)) == pytest.approx(500, abs=1)


def test_periodic_events_do_not_drift_and_do_not_burst_after_a_stall(rig) -> None:
    rig.ask(A, create(rate=10.0))
    rate = rig.host.service(Events).subscriptions.find(1, rig.ID.parse(A)).confirmed
    rig.host.handle_timeout(0.0)
    rig.sent()
    for late in (0.03, 0.07):
        rig.now = rig.host.next_timeout() + late
        rig.host.handle_timeout(rig.now)
        assert len(rig.sent()) == 1
    assert rig.host.next_timeout() == pytest.approx(3 / rate)
    rig.now = 60.0
    rig.host.handle_timeout(rig.now)
    assert len(rig.sent()) == 1
    rig.host.handle_timeout(rig.now)
    assert rig.sent() == []
    assert 60.0 < rig.host.next_timeout() <= 60.0 + 1 / rate
    assert (rig.host.next_timeout() * rate) % 1 == pytest.approx(0.0, abs=1e-6)


def test_update_changes_the_rate_and_cancel_ends_the_event(rig) -> None:
    id = rig.ask(A, create(rate=60 * STEP)).event_id
    rig.run(5.5)
    assert rig.ask(A, update(id, rate=30 * STEP)) == ConfirmEventRequest(8, id, pytest.approx(30 * STEP))
    assert [when for when, *_ in rig.run(5.0)] == pytest.approx([5.5 + 1 / (30 * STEP), 5.5 + 2 / (30 * STEP)])
    answer = rig.ask(A, CancelEvent(9, id))
    assert (answer.request_id, answer.event_id) == (9, id)
    assert rig.run(100.0) == []
    assert rig.host.next_timeout() is None
    assert rig.ask(A, ALL) == ReportEvents([])


def test_creating_the_same_event_again_updates_it(rig) -> None:
    first = rig.ask(A, create(rate=1.0))
    again = rig.ask(A, create(rate=2.0, request=9))
    assert (again.event_id, again.request_id) == (first.event_id, 9)
    other = rig.ask(A, create(rate=2.0, kind=ON_CHANGE))
    assert other.event_id != first.event_id
    assert rig.ask(B, create(rate=2.0)).event_id not in (first.event_id, other.event_id)


def test_repeated_request_makes_no_second_event(robot) -> None:
    for kind, query in ((PERIODIC, QueryStatus()), (ON_CHANGE, QueryLocalPose(X_AND_Y))):
        times = []
        for _ in range(3):
            assert isinstance(robot.ask(A, create(query, kind=kind, rate=2.0)), ConfirmEventRequest)
            times += [when for when, _, message in robot.run(0.3) if isinstance(message, Event)]
        assert len(times) <= 3, (
            "one report for each request, for the confirmation before it may be lost, and its report"
        )
    assert len(robot.ask(A, ALL).event_list) == 2


def test_every_change_event_reports_at_once_and_then_changes(robot, drive) -> None:
    robot.ask(A, create(QueryLocalPose(X_AND_Y), kind=ON_CHANGE, rate=0.0))
    ((when, to, first),) = robot.run(1.0)
    assert (when, to) == (0.0, A)
    assert (first.report_message.x, first.report_message.y) == pytest.approx((0.0, 0.0), abs=1e-4)
    drive.present_pose = Pose(x=1.0)
    ((when, _, second),) = robot.run(1.0)
    assert 1.0 <= when <= 1.0 + 1 / 25
    assert second.report_message.x == pytest.approx(1.0, abs=1e-4)
    drive.present_pose = replace(drive.present_pose, yaw=1.0)
    assert robot.run(1.0) == [], "yaw was not asked for"


def test_every_change_is_limited_to_the_requested_rate(robot, drive) -> None:
    def moving(seconds: float) -> int:
        count = 0
        for _ in range(int(seconds * 1000)):
            drive.present_pose = replace(drive.present_pose, x=drive.present_pose.x + 0.01)
            count += len(robot.run(0.001))
        return count

    assert robot.ask(A, create(QueryLocalPose(1), kind=ON_CHANGE, rate=0.0)).confirmed_periodic_rate == 0
    assert moving(2.0) == pytest.approx(50, abs=1)
    answer = robot.ask(A, update(1, QueryLocalPose(1), kind=ON_CHANGE, rate=5.0))
    assert answer.confirmed_periodic_rate == pytest.approx(5.0, abs=STEP)
    assert moving(2.0) == pytest.approx(10, abs=1)
    answer = robot.ask(A, update(1, QueryLocalPose(1), kind=ON_CHANGE, rate=500.0))
    assert answer.confirmed_periodic_rate == pytest.approx(25.0, abs=STEP)


def test_events_report_the_answer_to_the_query(robot) -> None:
    robot.ask(A, create(QueryControl(), kind=ON_CHANGE))
    robot.ask(A, create(QueryStatus(), kind=ON_CHANGE))
    assert {type(event.report_message) for *_, event in robot.run(0.5)} == {ReportControl, ReportStatus}
    robot.tell(B, RequestControl(100))
    robot.tell(B, Resume())
    reports = [event.report_message for *_, event in robot.run(1.5)]
    assert sorted(map(str, reports)) == sorted(
        map(str, [ReportControl(42, 2, 1, 100), ReportStatus(status=ReportStatus.Status.READY, reserved=0)])
    )


def test_events_carry_masked_reports(robot) -> None:
    robot.ask(A, create(QueryLocalPose(X_AND_Y)))
    ((_, _, event),) = robot.run(0.5)
    assert isinstance(event, Event)
    assert isinstance(event.report_message, ReportLocalPose)
    assert event.report_message.z is None
    assert len(event.report_message.encode()) == 2 + 2 + 4 + 4


@pytest.mark.parametrize(
    ("query", "rate", "code"),
    [
        (ReportStatus(status=ReportStatus.Status.READY, reserved=0), 1.0, 5),
        (RequestControl(200), 1.0, 5),
        (QueryLocalPose(1), 1.0, 5),
        (b"\xff\xff\x01", 1.0, 5),
        (b"\x02\x20\x00", 1.0, 5),
        (QueryStatus(), 0.0, 4),
    ],
    ids=["report", "command", "of no service here", "unknown", "undecodable", "rate 0"],
)
def test_invalid_requests_are_rejected(rig, query, rate, code) -> None:
    assert refusal(rig.ask(A, create(query, rate))) == code
    id = rig.ask(A, create()).event_id
    assert refusal(rig.ask(A, update(id, query, rate))) == code
    assert rig.host.controller is None
    assert len(rig.ask(A, ALL).event_list) == 1


def test_unknown_and_foreign_events_are_rejected_with_6(rig) -> None:
    id = rig.ask(A, create()).event_id
    for client, wanted in ((B, id), (A, id + 1)):
        assert refusal(rig.ask(client, update(wanted))) == 6
        assert refusal(rig.ask(client, CancelEvent(9, wanted))) == 6
    assert len(rig.run(1.5)) == 2


def test_query_events_selects_own_events(rig) -> None:
    status = rig.ask(A, create(QueryStatus())).event_id
    pulse = rig.ask(A, create(QueryHeartbeatPulse(), kind=ON_CHANGE)).event_id
    rig.ask(B, create(QueryStatus()))
    rig.run(0.1)

    def ids(var) -> list[int]:
        return [each.event_id for each in rig.ask(A, QueryEvents(var)).event_list]

    assert ids(AllEventsRec(0)) == [status, pulse]
    assert ids(QueryEvents.EventIDRec(pulse)) == [pulse]
    assert ids(QueryEvents.EventIDRec(99)) == []
    assert ids(EventTypeRec(ON_CHANGE)) == [pulse]
    assert ids(QueryEvents.MessageIDRec(QueryStatus.CODE)) == [status]
    assert rig.ask(A, ALL).event_list[0].query_message == QueryStatus()


def test_events_expire_unless_they_are_renewed(make) -> None:
    rig = make(Management(), Events(timeout=2))
    assert rig.ask(A, QueryEventTimeout()) == ReportEventTimeout(2)
    renewed = rig.ask(A, create(QueryStatus(), rate=0.1)).event_id
    ended = rig.ask(A, create(QueryControl(), rate=0.1, request=9)).event_id
    rig.run(60.0)
    rig.ask(A, update(renewed, rate=0.1))
    assert [m for *_, m in rig.run(60.5) if isinstance(m, ConfirmEventRequest)] == [
        ConfirmEventRequest(9, ended, pytest.approx(0.1, abs=STEP))
    ]
    assert [each.event_id for each in rig.ask(A, ALL).event_list] == [renewed]
    rig.run(60.0)
    assert rig.ask(A, ALL) == ReportEvents([])
    assert rig.host.next_timeout() is None


def test_cancelled_event_does_not_expire(make) -> None:
    rig = make(Management(), Events(timeout=1))
    id = rig.ask(A, create()).event_id
    rig.ask(A, CancelEvent(9, id))
    assert rig.host.next_timeout() is None


def test_the_default_time_out_is_a_minute(make) -> None:
    assert make(Events()).ask(A, QueryEventTimeout()) == ReportEventTimeout(1)


def test_the_number_of_events_is_bounded_per_client_and_per_component(make) -> None:
    rig = make(Management(), Events(limit=3, limit_per_client=2))
    assert isinstance(rig.ask(A, create(QueryStatus())), ConfirmEventRequest)
    assert isinstance(rig.ask(A, create(QueryControl())), ConfirmEventRequest)
    assert refusal(rig.ask(A, create(QueryEventTimeout()))) == 3
    assert isinstance(rig.ask(A, create(QueryStatus(), rate=2.0)), ConfirmEventRequest), "an update is no new event"
    assert isinstance(rig.ask(B, create(QueryStatus())), ConfirmEventRequest)
    assert refusal(rig.ask(B, create(QueryControl()))) == 3


def test_ids_are_reused_last(rig) -> None:
    for _ in range(300):
        id = rig.ask(A, create()).event_id
        rig.ask(A, CancelEvent(1, id))
    assert id == 300 % 256


def test_oversized_query_is_rejected(make) -> None:
    from jauspy.messages.core import QueriedComponentRec, QueriedNodeRec, QueryServices
    from jauspy.services.core import Discovery

    rig = make(Discovery())
    node = QueryServices.NodeSeq(QueriedNodeRec(1), [QueriedComponentRec(1)] * 255)
    assert refusal(rig.ask(A, create(QueryServices([node] * 100)))) == 3


@pytest.mark.parametrize(
    "options", [{"timeout": 256}, {"min_rate": 0.0}, {"max_rate": 2000.0}, {"max_change_rate": -1.0}]
)
def test_invalid_settings_are_rejected(options) -> None:
    with pytest.raises(ConfigError):
        Events(**options)


def test_unknown_kind_of_event_is_an_invalid_setup(rig) -> None:
    request = create().encode()
    ((_, answer),) = rig.tell(A, request[:3] + b"\x07" + request[4:])
    assert refusal(answer) == 4


def test_disabled_kind_of_event_is_rejected_with_its_code(make) -> None:
    rig = make(Management(), Events(max_rate=0.0))
    assert refusal(rig.ask(A, create(QueryStatus()))) == 1
    assert isinstance(rig.ask(A, create(QueryStatus(), kind=ON_CHANGE)), ConfirmEventRequest)
    rig = make(Management(), Events(max_change_rate=0.0))
    assert refusal(rig.ask(A, create(QueryStatus(), kind=ON_CHANGE))) == 2
    assert isinstance(rig.ask(A, create(QueryStatus())), ConfirmEventRequest)


@pytest.mark.parametrize("asked", [STEP, 0.1, 1.0, 7.0, 33.3, 49.99, 50.0, 51.0, 1092.0])
def test_delivered_rate_equals_the_confirmed_one(make, asked) -> None:
    rig = make(Management(), Events(min_rate=0.5, max_rate=50.0, timeout=0))
    confirmed = rig.ask(A, create(rate=asked)).confirmed_periodic_rate
    assert 0.5 - STEP / 2 <= confirmed <= 50.0
    assert rig.host.service(Events).subscriptions.find(1, rig.ID.parse(A)).confirmed == pytest.approx(confirmed)
    if 0.5 <= asked <= 50.0:
        assert confirmed == pytest.approx(asked, abs=STEP)
    times = [when for when, *_ in rig.run(20.0)]
    assert (len(times) - 1) / (times[-1] - times[0]) == pytest.approx(confirmed, rel=1e-6)


def test_first_change_and_one_time_events_report_once(make) -> None:
    rig = make(Management(), AccessControl(timeout=0), Events(more_kinds=True))
    rig.ask(A, create(QueryControl(), kind=2, rate=0.0).encode(strict=False))
    rig.ask(A, create(QueryStatus(), kind=3).encode(strict=False))
    assert [type(event.report_message) for *_, event in rig.run(1.0)] == [ReportStatus]
    assert len(rig.ask(A, ALL).event_list) == 1
    rig.tell(B, RequestControl(100))
    ((_, to, event),) = rig.run(1.0)
    assert (to, event.report_message) == (A, ReportControl(42, 2, 1, 100))
    rig.tell(B, RequestControl(200))
    assert rig.run(1.0) == []
    assert rig.ask(A, ALL) == ReportEvents([])
    assert rig.host.next_timeout() is None


def test_periodic_reports_are_dropped_before_single_notifications(make) -> None:
    rig = make(Management(), Liveness(), AccessControl(), Events(timeout=0), max_output=4)
    rig.ask(A, create(QueryHeartbeatPulse(), rate=50.0))
    rig.host.handle_timeout(0.0)
    rig.host.receive(create(QueryStatus(), kind=ON_CHANGE, rate=0.0, request=9).encode(), rig.ID.parse(A), 0.0)
    for tick in range(100):
        rig.host.handle_timeout(tick * 0.02)
    sent = [message for _, message in rig.sent()]
    assert len(sent) == 4
    assert ConfirmEventRequest(9, 2, 0.0) in sent
    assert ReportStatus(status=ReportStatus.Status.STANDBY, reserved=0) in [
        each.report_message for each in sent if isinstance(each, Event)
    ]


def test_events_of_an_unreachable_client_end(rig) -> None:
    rig.ask(A, create(QueryStatus()))
    rig.ask(A, create(QueryControl(), kind=ON_CHANGE))
    kept = rig.ask(B, create(QueryStatus())).event_id
    rig.host.unreachable(rig.ID.parse(A), rig.now)
    assert {to for _, to, _ in rig.run(5.0)} == {B}
    assert rig.ask(A, ALL) == ReportEvents([])
    assert [each.event_id for each in rig.ask(B, ALL).event_list] == [kept]


def test_event_with_failing_report_ends_with_a_rejection(make, caplog) -> None:
    class Ill(Liveness):
        def report_heartbeat_pulse(self):
            raise RuntimeError("flat line")

    rig = make(Ill(), Events(timeout=0))
    rig.ask(A, create(QueryHeartbeatPulse(), request=9))
    ((_, to, answer),) = rig.run(10.0)
    assert (to, answer) == (A, RejectEventRequest(9, 5))
    assert rig.ask(A, ALL) == ReportEvents([])
    assert "flat line" in caplog.text
