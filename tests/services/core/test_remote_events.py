"""A service as the client of another component's events, and the answers that a host passes on to it."""

from __future__ import annotations

import pytest

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateEvent,
    Event,
    QueryHeartbeatPulse,
    QueryStatus,
    RejectEventRequest,
    ReportHeartbeatPulse,
    UpdateEvent,
)
from jauspy.services.core import AccessControl, Liveness, Management
from jauspy.services.core.remote_events import RENEWAL_INTERVAL, RETRY_INTERVAL, SILENCE, RemoteEvent
from jauspy.services.service import Service

PEER, OTHER = JausID(101, 1, 102), JausID(66, 1, 1)
PULSE = ReportHeartbeatPulse()
STEP = 0.1


class Listener:
    """A host with a remote event at 10 Hz; what it sends is taken and answered by the test."""

    def __init__(self, make) -> None:
        self.rig = make(AccessControl(), Management(), Liveness())
        self.host = self.rig.host
        self.taken: list[Message | bytes] = []
        self.event = RemoteEvent(self.host, QueryHeartbeatPulse(), 10.0, self.taken.append)
        self.number = 0

    def sent(self) -> list[Message]:
        found = [registry.decode(out.payload) for out in self.host.poll_output(self.host.now)]
        assert all(isinstance(each, CreateEvent | UpdateEvent | CancelEvent) for each in found)
        return found

    def pass_time(self, seconds: float, *, reports: bool = False) -> list[Message]:
        found = []
        for _ in range(round(seconds / STEP)):
            now = self.host.now + STEP
            if reports:
                self.host.now = now
                self.report()
            self.host.handle_timeout(now)
            found += self.sent()
        return found

    def receive(self, message: Message, source: JausID = PEER) -> None:
        self.host.receive(message.encode(), source, self.host.now)

    def confirm(self, request: CreateEvent | UpdateEvent, event: int = 7) -> None:
        self.receive(ConfirmEventRequest(request.request_id, event, 10.0))

    def report(self, event: int = 7, source: JausID = PEER) -> None:
        self.receive(Event(event, self.number, PULSE), source)
        self.number = self.number + 1 & 0xFF


@pytest.fixture
def listener(make) -> Listener:
    return Listener(make)


def test_it_is_requested_until_it_is_confirmed(listener: Listener) -> None:
    listener.event.begin(PEER)
    requests = [*listener.sent(), *listener.pass_time(2.2 * RETRY_INTERVAL)]
    assert [type(each) for each in requests] == [CreateEvent] * 3
    assert requests[-1].requested_periodic_rate == pytest.approx(10.0, abs=0.02)
    listener.report()
    assert listener.taken == [], "no event is confirmed"
    listener.confirm(requests[-1])
    listener.report()
    assert [type(each) for each in listener.taken] == [ReportHeartbeatPulse]


def test_it_is_renewed_while_reports_come(listener: Listener) -> None:
    listener.event.begin(PEER)
    listener.confirm(listener.sent()[-1])
    requests = listener.pass_time(RENEWAL_INTERVAL + 2 * RETRY_INTERVAL, reports=True)
    (renewal,) = requests
    assert isinstance(renewal, UpdateEvent)
    assert renewal.event_id == 7


def test_it_is_requested_again_after_a_silence(listener: Listener) -> None:
    listener.event.begin(PEER)
    listener.confirm(listener.sent()[-1])
    requests = listener.pass_time(SILENCE + 2 * RETRY_INTERVAL)
    assert isinstance(requests[0], CreateEvent)
    listener.confirm(requests[-1], event=9)
    listener.report(event=9)
    listener.report(event=7)
    assert len(listener.taken) == 1
    assert listener.host.counters["unrequested_event"] == 1


def test_a_rejection_is_counted_and_it_is_tried_again(listener: Listener) -> None:
    listener.event.begin(PEER)
    request = listener.sent()[-1]
    listener.receive(RejectEventRequest(request.request_id, response_code=3))
    listener.receive(RejectEventRequest(request.request_id, response_code=3), OTHER)
    assert listener.host.counters["remote_event_rejected"] == 1
    assert isinstance(listener.pass_time(2 * RETRY_INTERVAL)[0], CreateEvent)


def test_the_end_cancels_it(listener: Listener) -> None:
    listener.event.begin(PEER)
    listener.confirm(listener.sent()[-1])
    listener.event.end()
    listener.event.end()
    (cancel,) = listener.sent()
    assert isinstance(cancel, CancelEvent)
    assert cancel.event_id == 7
    assert listener.pass_time(5.0) == []
    listener.report()
    assert listener.taken == []


def test_another_component_replaces_it(listener: Listener) -> None:
    listener.event.begin(PEER)
    listener.confirm(listener.sent()[-1])
    listener.event.begin(OTHER)
    assert [type(each) for each in listener.sent()] == [CancelEvent, CreateEvent]
    listener.report()
    assert listener.taken == []


def test_numbers_wrap_and_late_reports_are_dropped(listener: Listener) -> None:
    listener.event.begin(PEER)
    listener.confirm(listener.sent()[-1])
    listener.number = 254
    for _ in range(4):
        listener.report()
    listener.number = 255
    listener.report()
    assert len(listener.taken) == 4
    assert listener.host.counters["late_event"] == 1


# --- answers that a host passes on


def test_malformed_answers_are_counted(listener: Listener) -> None:
    listener.event.begin(PEER)
    listener.host.receive(Event.CODE.to_bytes(2, "little"), PEER, listener.host.now)
    listener.host.receive(Event(7, 0, PULSE).encode(), JausID(101, 1, 255), listener.host.now)
    assert listener.host.counters["malformed_Event"] == 1
    assert listener.host.counters["bad_source"] == 1


def test_an_exception_of_one_taker_does_not_keep_it_from_the_others(listener: Listener) -> None:
    def fail(_: Event, __: JausID) -> None:
        raise ValueError("a bug")

    taken: list[Event] = []
    listener.host.expect(Event, fail)
    listener.host.expect(Event, lambda event, _: taken.append(event))
    listener.report()
    assert len(taken) == 1
    assert listener.host.first_error is not None
    assert "a bug" in str(listener.host.first_error[1])


def test_inputs_are_no_answers(listener: Listener) -> None:
    with pytest.raises(ConfigError, match="QueryStatus is an input"):
        listener.host.expect(QueryStatus, lambda *_: None)
    assert isinstance(listener.host.service(Management), Service)
