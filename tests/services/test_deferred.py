"""Answers that come later: to queries and in events, on time, too late and too many."""

from __future__ import annotations

import pytest

from jauspy.messages.core import (
    CancelEvent,
    CreateEvent,
    Event,
    QueryTime,
    ReportHeartbeatPulse,
    ReportTime,
    TimeStamp,
    UpdateEvent,
)
from jauspy.services.core import Time
from jauspy.services.deferred import MAX_DEFERRED_REPLIES, REPLY_TIMEOUT

A, B = "42.1.1", "42.2.1"
NOON, ONE = TimeStamp(0, 0, 0, 12, 1), TimeStamp(0, 0, 0, 13, 1)
STAYED_OUT = ReportTime()
PERIODIC, EVERY_CHANGE = CreateEvent.EventType.PERIODIC, CreateEvent.EventType.EVERY_CHANGE


class SlowTime(Time):
    """Tells the time some time later."""

    def __init__(self):
        super().__init__()
        self.open = []

    def report_time(self):
        self.open.append(self.host.defer(lambda: STAYED_OUT))
        return self.open[-1]

    def strike(self, stamp=NOON):
        """All answers that are under way come now."""
        open, self.open = self.open, []
        for each in open:
            each.set_result(ReportTime(time_stamp=stamp))


@pytest.fixture
def clock():
    return SlowTime()


@pytest.fixture
def rig(make, clock):
    return make(clock)


def only(sent):
    ((to, message),) = sent
    return to, message


def contents(sent):
    """What the events carry."""
    return [m.report_message if isinstance(m, Event) else m for *_, m in sent]


def test_deferred_answer_is_sent_when_set(rig, clock):
    prompted = []
    rig.host.on_timer_change = lambda: prompted.append(rig.host.next_timeout())
    assert rig.tell(A, QueryTime(3)) == []
    rig.now = 2.0
    clock.strike()
    assert prompted == [0.0]
    assert rig.sent() == []
    assert rig.run(0.0) == [(2.0, A, ReportTime(time_stamp=NOON))]
    assert rig.host.next_timeout() is None


def test_deferred_answer_is_masked_by_the_query(rig, clock):
    rig.tell(A, QueryTime(2))
    clock.strike()
    assert contents(rig.run(0.0)) == [ReportTime()]


def test_result_set_at_once_is_sent(rig, clock):
    rig.tell(A, QueryTime(1))
    (later,) = clock.open
    clock.strike()
    rig.run(0.0)
    reported = []
    later.add_done_callback(reported.append)
    assert reported == [ReportTime(time_stamp=NOON)]


def test_repeated_query_is_answered_once(rig, clock):
    for client in (A, A, B, A):
        rig.tell(client, QueryTime(1))
    rig.tell(A, QueryTime(0))
    clock.strike()
    assert [(to, message) for _, to, message in rig.run(0.0)] == [
        (A, ReportTime(time_stamp=NOON)),
        (B, ReportTime(time_stamp=NOON)),
        (A, ReportTime()),
    ]
    assert rig.host.counters["repeated_query"] == 2
    rig.tell(A, QueryTime(1))
    clock.strike(ONE)
    assert contents(rig.run(0.0)) == [ReportTime(time_stamp=ONE)]


def test_fallback_is_sent_after_the_timeout_and_late_results_are_ignored(rig, clock):
    rig.tell(A, QueryTime(1))
    assert rig.run(REPLY_TIMEOUT - 0.1) == []
    assert [(to, message) for _, to, message in rig.run(0.2)] == [(A, STAYED_OUT)]
    assert rig.host.counters["deferred_overdue"] == 1
    clock.strike()
    assert rig.run(1.0) == []


def test_result_none_sends_nothing(rig, clock):
    rig.tell(A, QueryTime(1))
    clock.open[0].set_result(None)
    assert rig.run(1.0) == []


def test_pending_replies_are_bounded(rig, clock):
    for number in range(MAX_DEFERRED_REPLIES):
        assert rig.tell(f"42.3.{number + 1}", QueryTime(1)) == []
    assert rig.run(0.0) == []
    rig.tell(A, QueryTime(1))
    assert rig.run(0.0) == [(0.0, A, STAYED_OUT)]
    assert rig.host.counters["deferred_refused"] == 1
    clock.strike()
    assert len(rig.run(0.0)) == MAX_DEFERRED_REPLIES


def test_exception_in_a_result_is_contained(rig, clock):
    rig.tell(A, QueryTime(1))
    clock.open[0].set_result(ReportTime(time_stamp="noon"))
    assert rig.run(0.0) == []
    assert rig.host.counters["unencodable"] == 1


@pytest.mark.parametrize(
    ("wrong", "what"), [(ReportHeartbeatPulse(), "ReportHeartbeatPulse"), ("noon", "'noon'")], ids=["message", "text"]
)
def test_a_result_that_is_not_the_report_is_recorded_and_not_sent(rig, clock, caplog, wrong, what):
    for client in (A, B):
        rig.tell(client, QueryTime(1))
        clock.open[-1].set_result(wrong)
    assert rig.run(0.0) == []
    assert f"the result must be a ReportTime or None; it was {what}" in caplog.text
    assert "SlowTime.report_time failed on QueryTime" in caplog.text
    clock.open.clear()
    rig.tell(A, QueryTime(1))
    clock.strike()
    assert len(rig.run(0.0)) == 1, "it is answered again"


def test_exception_in_a_callback_does_not_affect_others(rig, clock):
    rig.tell(A, QueryTime(1))
    (later,) = clock.open
    rig.tell(B, QueryTime(1))
    clock.open[1].add_done_callback(lambda _: 1 / 0)
    reported = []
    clock.open[1].add_done_callback(reported.append)
    clock.strike()
    assert [to for _, to, _ in rig.run(0.0)] == [A, B]
    assert reported == [later.report]
    assert rig.host.counters["action_failed"] == 1


def test_exception_in_the_fallback_leaves_nothing_pending(make, caplog):
    class Poor(Time):
        def report_time(self):
            return self.host.defer(lambda: 1 / 0)

    rig = make(Poor())
    for _ in range(2 * MAX_DEFERRED_REPLIES):
        rig.tell(A, QueryTime(1))
        assert rig.run(REPLY_TIMEOUT) == []
    assert rig.host.counters["deferred_overdue"] == 2 * MAX_DEFERRED_REPLIES
    assert rig.host.counters["deferred_refused"] == rig.host.counters["repeated_query"] == 0
    assert "Poor.report_time failed on QueryTime" in caplog.text
    assert len(caplog.records) == 7


# --- events


def test_periodic_events_wait_for_deferred_replies(rig, clock):
    rig.tell(A, CreateEvent(1, PERIODIC, 10.0, QueryTime(1)))
    assert rig.run(0.55) == []
    assert len(clock.open) == 1
    assert rig.host.counters["event_skipped"] == 5
    clock.strike()
    assert contents(rig.run(0.01)) == [ReportTime(time_stamp=NOON)]
    rig.run(0.1)
    clock.strike(ONE)
    ((_, to, event),) = rig.run(0.01)
    assert (to, event.sequence_number) == (A, 1)
    assert contents([(event,)]) == [ReportTime(time_stamp=ONE)]


def test_events_on_change_report_deferred_changes_only(rig, clock):
    rig.tell(A, CreateEvent(1, EVERY_CHANGE, 0.0, QueryTime(1)))
    reported = []
    for stamp in (NOON, NOON, ONE, ONE, NOON):
        rig.run(0.1)
        clock.strike(stamp)
        reported += rig.run(0.001)
    assert contents(reported) == [ReportTime(time_stamp=stamp) for stamp in (NOON, ONE, NOON)]


def test_overdue_event_reports_the_fallback(rig):
    rig.tell(A, CreateEvent(1, PERIODIC, 1.0, QueryTime(1)))
    assert contents(rig.run(REPLY_TIMEOUT + 0.5)) == [STAYED_OUT]


def test_cancelled_or_changed_event_gets_no_deferred_report(rig, clock):
    _, confirmed = only(rig.tell(A, CreateEvent(1, PERIODIC, 1.0, QueryTime(1))))
    rig.run(0.1)
    only(rig.tell(A, UpdateEvent(2, UpdateEvent.EventType.PERIODIC, 1.0, confirmed.event_id, QueryTime(3))))
    clock.strike()
    assert rig.run(0.1) == []
    rig.run(1.0)
    assert len(clock.open) == 1
    only(rig.tell(A, CancelEvent(3, confirmed.event_id)))
    clock.strike()
    assert rig.run(0.1) == []
