from __future__ import annotations

import logging
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ConfirmControl,
    CreateEvent,
    QueriedComponentRec,
    QueriedNodeRec,
    QueryHeartbeatPulse,
    QueryServices,
    QueryStatus,
    RejectControl,
    ReportHeartbeatPulse,
    ReportStatus,
    RequestControl,
    Resume,
    SetEmergency,
)
from jauspy.messages.mobility import QueryWrenchEffort, ReportWrenchEffort, SetWrenchEffort
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Broadcast, Priority
from jauspy.schema import Schema, load_builtin, load_files, loader
from jauspy.services.core import AccessControl, Liveness, Management
from jauspy.services.messaging import Outgoing, OutputQueue
from jauspy.services.mobility import PrimitiveDriver, Vehicle
from jauspy.services.service import Service

A, B = "42.1.1", "42.2.1"
SOURCE = JausID.parse(A)
CONTROL_RELEASED = RejectControl.ResponseCode.CONTROL_RELEASED
INPUTS = sorted({m.code for s in load_builtin().services for m in s.inputs})


# --- what comes from the network


@pytest.mark.parametrize(
    ("payload", "reason"),
    [
        (b"", "too_short"),
        (b"\x02", "too_short"),
        (b"\xff\xff\x00", "unknown_message"),
        (b"\x02\x40\x01\x00\x00\x00\x00", "unknown_message"),
        (b"\x0d\x00", "malformed_RequestControl"),
        (b"\x0d\x00\x01\x01", "malformed_RequestControl"),
        (b"\x06\x00\x99", "malformed_SetEmergency"),
    ],
)
def test_malformed_messages_are_counted_by_reason_and_logged_once(robot, caplog, payload, reason) -> None:
    with caplog.at_level(logging.DEBUG, "jauspy.services"):
        for _ in range(3):
            assert robot.tell(A, payload) == []
    assert robot.host.counters == {reason: 3}
    assert len(caplog.records) == 1
    assert caplog.records[0].levelno == logging.DEBUG
    assert isinstance(robot.ask(A, QueryStatus()), ReportStatus)


def test_wildcards_send_nothing(robot) -> None:
    assert robot.tell("42.1.255", RequestControl(200)) == []
    assert robot.host.counters == {"bad_source": 1}
    assert robot.host.controller is None


# The robot goes through all examples: what one leaves behind is the next one's start.
@pytest.mark.slow
@settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(messages=st.lists(st.tuples(st.sampled_from(INPUTS), st.binary(max_size=40)), min_size=1, max_size=20))
def test_garbage_never_raises(robot, messages: list[tuple[int, bytes]]) -> None:
    for code, body in messages:
        robot.host.receive(code.to_bytes(2, "little") + body, SOURCE, robot.now)
        robot.run(0.01)
    assert robot.host.counters["action_failed"] == 0
    assert robot.host.counters["unencodable"] == 0
    assert len(robot.host.counters) < 50


def test_ignored_messages_are_counted(robot) -> None:
    robot.tell(A, Resume())
    assert robot.host.counters["ignored"] == 1


# --- what goes out


def outgoing(number: int, priority: Priority = Priority.STANDARD) -> Outgoing:
    return Outgoing(JausID(1, 1, number), b"", priority)


def test_the_output_queue_drops_the_oldest_of_the_lowest_priority() -> None:
    counters = Counters(logging.getLogger("test"))
    box = OutputQueue(3, counters)
    for each in (
        outgoing(1),
        outgoing(2, Priority.LOW),
        outgoing(3, Priority.LOW),
        outgoing(4),
        outgoing(5, Priority.HIGH),
    ):
        box.put(each)
    assert [each.destination.component for each in box.drain()] == [1, 4, 5]
    assert counters == {"output_dropped": 2}
    assert box.drain() == []


def test_undrained_output_is_bounded(make) -> None:
    rig = make(Liveness(), max_output=10)
    for _ in range(50):
        rig.host.receive(QueryHeartbeatPulse().encode(), SOURCE, 0.0)
    assert len(rig.sent()) == 10
    assert rig.host.counters["output_dropped"] == 40


def test_services_choose_priority_and_broadcast(make) -> None:
    rig = make(Liveness())
    for broadcast in (Broadcast.NONE, Broadcast.LOCAL, Broadcast.GLOBAL):
        rig.host.send(SOURCE, ReportHeartbeatPulse(), priority=Priority.HIGH, broadcast=broadcast)
    sent = rig.host.poll_output(0.0)
    assert [(each.broadcast, each.priority) for each in sent] == [
        (b, Priority.HIGH) for b in (Broadcast.NONE, Broadcast.LOCAL, Broadcast.GLOBAL)
    ]
    assert sent[0].payload == ReportHeartbeatPulse().encode()


def test_encode_error_is_logged_and_nothing_is_sent(make, caplog) -> None:
    rig = make(Liveness())
    rig.host.send(SOURCE, ReportWrenchEffort(propulsive_linear_effort_x=1000.0))
    assert rig.sent() == []
    assert (rig.host.counters["unencodable"], rig.host.counters["action_failed"]) == (1, 1)
    assert "encoding ReportWrenchEffort failed" in caplog.text
    assert "1000.0 is outside -100.0..100.0" in caplog.text


def test_unknown_internal_event_is_an_error(make) -> None:
    rig = make(Management())
    with pytest.raises(ConfigError, match=r"101\.1\.1 has an internal event Initialised; there are .*Init"):
        rig.host.fire("Initialised")


# --- late callers


def test_overdue_control_timeout_precedes_a_late_message(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, Resume())
    robot.now = 100.0  # nobody called `handle_timeout` meanwhile
    assert robot.tell(A, SetWrenchEffort(propulsive_linear_effort_x=50.0)) == [(A, RejectControl(CONTROL_RELEASED))]
    assert robot.host.controller is None
    assert drive.effort == (0.0, 0.0)


def test_message_precedes_a_timer_of_the_same_time(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, Resume())
    robot.now = 5.0
    robot.tell(A, RequestControl(100))
    assert robot.run(4.9) == []
    assert robot.host.controller == SOURCE


# --- bugs of actions


def test_exception_is_logged_with_its_message_and_counted(make, drive, caplog) -> None:
    class Buggy(PrimitiveDriver):
        def set_wrench_effort(self, msg: SetWrenchEffort) -> None:
            raise ZeroDivisionError("of mine")

    rig = make(Buggy(Vehicle(drive)), Liveness())
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    before = rig.host.state
    assert rig.tell(A, SetWrenchEffort(propulsive_linear_effort_x=12.5)) == []
    (record,) = caplog.records
    assert record.levelno == logging.ERROR
    for expected in ("PrimitiveDriver", "Controlled.Available.Ready", "setWrenchEffort", "12.49", A, "of mine"):
        assert expected in record.getMessage()
    assert rig.host.state == before
    assert rig.host.counters["action_failed"] == 1
    assert rig.ask(A, QueryHeartbeatPulse()) == ReportHeartbeatPulse()
    assert isinstance(rig.ask(A, QueryWrenchEffort(0)), ReportWrenchEffort)


def test_exception_in_a_timer_does_not_stop_others(make) -> None:
    rig, called = make(Liveness()), []
    rig.host.set_timer("broken", 1.0, lambda: 1 / 0)
    rig.host.set_timer("fine", 1.0, lambda: called.append("fine"))
    rig.run(1.0)
    assert called == ["fine"]
    assert rig.host.counters["action_failed"] == 1


def test_cascading_internal_events_are_bounded(make) -> None:
    class Endless(Management):
        def initialize(self) -> None:
            for _ in range(3):
                self.host.fire("Initialized")
                self.host.fire("Timedout")

    rig = make(Endless())
    rig.tell(A, RequestControl(100))
    rig.tell(A, bytes.fromhex("0500"))
    assert rig.host.status is ReportStatus.Status.STANDBY
    for _ in range(1000):
        rig.host._triggers._busy = True
        rig.host.fire("Timedout")
    assert rig.host.counters["event_dropped"] > 0


# --- putting a component together


def test_inherited_core_services_are_added(make, drive) -> None:
    rig = make(PrimitiveDriver(Vehicle(drive)))
    assert [type(s).__name__ for s in rig.host.services] == [
        "PrimitiveDriver",
        "Management",
        "AccessControl",
        "Events",
        "Transport",
    ]
    given = AccessControl(timeout=9)
    assert make(PrimitiveDriver(Vehicle(drive)), given).host.service(AccessControl) is given


def test_missing_actions_are_named(make) -> None:
    class Half(Service, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
        pass

    with pytest.raises(ConfigError) as caught:
        make(Half())
    text = str(caught.value)
    ready = "PrimitiveDriver, state Receiving.Ready.Controlled.Available.Ready"
    effort = "def set_wrench_effort(self, msg: SetWrenchEffort) -> None"
    assert f"{ready}: action setWrenchEffort needs a method of Half: {effort}" in text
    assert f"{ready}: action resetTravelSpeed needs a method of Half: def reset_travel_speed(self" in text
    report = "def report_wrench_effort(self, query: QueryWrenchEffort) -> ReportWrenchEffort"
    assert f"Send of ReportWrenchEffort needs a method of Half: {report}" in text
    assert text.count("report_wrench_effort") == 2


def test_service_without_definition_or_given_twice_is_rejected(make) -> None:
    class Nameless(Service):
        pass

    class Unknown(Service, urn="urn:x:Unknown"):
        pass

    class OtherVersion(Liveness, version="7.7"):
        pass

    for services, text in (
        ((Nameless(),), "names no definition"),
        ((Liveness(), Liveness()), "given twice"),
        ((Unknown(),), "no definition of urn:x:Unknown"),
        ((OtherVersion(),), r"Liveness 7\.7 is loaded \(versions there: 1\.0, 1\.1\)"),
    ):
        with pytest.raises(ConfigError, match=text):
            make(*services)


def test_read_decodes_inputs_of_the_component_only(robot) -> None:
    assert robot.host.read(QueryStatus()) == QueryStatus()
    assert robot.host.read(QueryStatus().encode()) == QueryStatus()
    for other in (
        ReportStatus(status=ReportStatus.Status.READY, reserved=0),
        registry.by_name("QueryElementList")(),
        b"",
        b"\x02",
        b"\x02\x20\x00",
    ):
        assert robot.host.read(other) is None


def test_only_needed_definitions_are_read(monkeypatch, request) -> None:
    read: list[Path] = []

    def count(paths: list[Path], *, base: Schema) -> Schema:
        read.extend(paths)
        return load_files(paths, base=base)

    loader.load_needed.cache_clear()
    loader._shipped_services.cache_clear()
    monkeypatch.setattr(loader, "load_files", count)
    robot = request.getfixturevalue("robot")
    types = 2
    assert len(read) == len(robot.host.services) + types


def test_without_management_there_is_no_status(make) -> None:
    rig = make(Liveness())
    assert (rig.host.status, rig.host.controller, rig.host.state) == (None, None, "Receiving.Ready")


class Fragile(Management):
    """Breaks down when it is asked, and again while it fails."""

    def report_status(self):
        raise RuntimeError("no idea")

    def control_lost(self) -> None:
        raise RuntimeError("no end")


def test_exception_enters_failure_if_configured(make, caplog) -> None:
    rig = make(Fragile(), AccessControl(timeout=0), Liveness(), on_action_error="failure")
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    assert rig.tell(B, QueryStatus()) == [(A, RejectControl(RejectControl.ResponseCode.CONTROL_RELEASED))]
    assert rig.host.status is ReportStatus.Status.FAILURE
    assert "QueryStatus" in caplog.text
    assert "no idea" in caplog.text
    assert "no end" in caplog.text
    assert rig.ask(A, RequestControl(100)).response_code == ConfirmControl.ResponseCode.NOT_AVAILABLE
    assert rig.ask(A, QueryHeartbeatPulse()).NAME == "ReportHeartbeatPulse"
    rig.tell(B, QueryStatus())
    assert rig.host.status is ReportStatus.Status.FAILURE


def test_component_continues_after_an_exception_by_default(make) -> None:
    rig = make(Fragile(), AccessControl(timeout=0))
    rig.tell(A, RequestControl(100))
    rig.tell(A, Resume())
    assert rig.tell(B, QueryStatus()) == []
    assert rig.host.status is ReportStatus.Status.READY


def test_repeated_exceptions_do_not_fill_the_log(make, caplog) -> None:
    rig = make(Fragile(), AccessControl(timeout=0))
    for _ in range(1000):
        rig.tell(B, QueryStatus())
    assert rig.host.counters["action_failed"] == 1000
    assert len(caplog.records) == 10
    assert "(512 times)" in caplog.text


# --- its end


def test_closed_component_notifies_clients_and_restarts_fresh(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, Resume())
    robot.tell(A, SetWrenchEffort(propulsive_linear_effort_x=50.0))
    confirmed = robot.ask(B, CreateEvent(1, 0, 1.0, QueryStatus()))
    robot.host.close(robot.now)
    assert robot.sent() == [(A, RejectControl(CONTROL_RELEASED)), (B, confirmed)]
    assert drive.effort == (0.0, 0.0)
    assert (robot.host.controller, robot.host.status) == (None, ReportStatus.Status.STANDBY)
    assert robot.host.next_timeout() is None
    robot.host.close(robot.now)
    assert robot.sent() == []
    services = robot.ask(B, QueryServices([QueryServices.NodeSeq(QueriedNodeRec(1), [QueriedComponentRec(1)])]))
    assert len(services.node_list[0].component_list[0].service_list) == len(robot.host.services)


def test_close_stops_motion_in_an_emergency(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(B, SetEmergency(1))
    stops = drive.stops
    robot.host.close(robot.now)
    assert drive.stops > stops
    assert robot.host.status is ReportStatus.Status.EMERGENCY


@pytest.mark.parametrize("id", ["101.255.1", "65535.1.1", "101.1.0"])
def test_request_for_an_invalid_id_is_an_error(robot, id) -> None:
    with pytest.raises(ConfigError, match=f"{id} cannot be a component's id"):
        robot.host.ask_for_id(JausID.parse(id))
    assert robot.host.requested_id is None
