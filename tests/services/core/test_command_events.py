"""A command event carries out its command and tells, once, how that ended."""

from __future__ import annotations

import pytest

from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    ClearEmergency,
    CommandEvent,
    ConfirmControl,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    QueryEvents,
    QueryStatus,
    RejectEventRequest,
    ReportStatus,
    RequestControl,
    Resume,
    SetTime,
    Standby,
    TimeStamp,
    UpdateEvent,
)
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.services.core import AccessControl, Events, Management, Time

A, B = "42.1.1", "42.2.1"
SUCCESSFUL, UNSUCCESSFUL = 0, 1


def command(message, *, within: int = 10, request: int = 7) -> CreateCommandEvent:
    return CreateCommandEvent(request, within, message)


class Slow(Time):
    """A clock that takes its time to be set; `ended` is told from outside."""

    begun = 0

    def set_time(self, msg) -> None:
        self.begun += 1
        self.ended = self.host.begin_command()


SET_TIME = SetTime(time_stamp=TimeStamp(milliseconds=0, seconds=1, minutes=2, hour=3, day=4))


@pytest.fixture
def rig(make):
    rig = make(Slow(), Management(), AccessControl(timeout=0), Events(timeout=0, limit=3, limit_per_client=2))
    rig.tell(A, RequestControl(100))
    return rig


def test_immediate_command_succeeds_at_once(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    confirmed, ended = robot.tell(A, command(Resume(), within=0))
    assert confirmed == (A, ConfirmEventRequest(7, 1, 0.0))
    assert ended == (A, CommandEvent(1, SUCCESSFUL))
    assert robot.host.status is ReportStatus.Status.READY
    robot.tell(A, command(SetWrenchEffort(propulsive_linear_effort_x=50.0)))
    assert drive.effort[0] == pytest.approx(0.5, abs=1e-3)
    assert robot.run(4.0) == []


def test_answers_of_the_command_are_sent_as_well(make) -> None:
    rig = make(AccessControl(), Events())
    kinds = [type(message) for _, message in rig.tell(A, command(RequestControl(100)))]
    assert kinds == [ConfirmEventRequest, ConfirmControl, CommandEvent]
    assert str(rig.host.controller) == A


@pytest.mark.parametrize("client", [A, B])
def test_ignored_command_is_unsuccessful(robot, drive, client) -> None:
    robot.tell(A, RequestControl(100))
    message = SetWrenchEffort(propulsive_linear_effort_x=50.0) if client == A else Resume()
    answers = [message for _, message in robot.tell(client, command(message))]
    assert answers == [ConfirmEventRequest(7, 1, 0.0), CommandEvent(1, UNSUCCESSFUL)]
    assert drive.effort == (0.0, 0.0)
    assert robot.host.status is ReportStatus.Status.STANDBY


def test_failed_command_is_unsuccessful(make, caplog) -> None:
    class Broken(Time):
        def set_time(self, msg) -> None:
            raise RuntimeError("cuckoo")

    rig = make(Broken(), Events())
    rig.tell(A, RequestControl(100))
    assert rig.tell(A, command(SET_TIME))[-1] == (A, CommandEvent(1, UNSUCCESSFUL))
    assert "cuckoo" in caplog.text


@pytest.mark.parametrize("success", [True, False])
def test_lasting_command_ends_when_its_service_reports_it(rig, success) -> None:
    assert rig.ask(A, command(SET_TIME)) == ConfirmEventRequest(7, 1, 0.0)
    assert rig.run(5.0) == []
    rig.host.service(Slow).ended(success)
    assert rig.sent() == [(A, CommandEvent(1, SUCCESSFUL if success else UNSUCCESSFUL))]
    rig.host.service(Slow).ended(not success)
    assert rig.run(60.0) == []


def test_command_above_its_duration_is_unsuccessful_and_continues(rig) -> None:
    rig.ask(A, command(SET_TIME, within=3))
    assert rig.run(60.0) == [(3.0, A, CommandEvent(1, UNSUCCESSFUL))]
    rig.host.service(Slow).ended(True)
    assert rig.sent() == []


def test_repeated_command_is_executed_again_with_its_full_duration(rig) -> None:
    rig.ask(A, command(SET_TIME, within=10))
    first = rig.host.service(Slow).ended
    rig.run(5.0)
    assert rig.ask(A, command(SET_TIME, within=10, request=8)) == ConfirmEventRequest(8, 1, 0.0)
    first(False)
    assert rig.sent() == []
    assert rig.run(60.0) == [(15.0, A, CommandEvent(1, UNSUCCESSFUL))]


def test_repeated_request_does_not_restart_its_command(rig) -> None:
    for _ in range(3):
        assert rig.ask(A, command(SET_TIME)) == ConfirmEventRequest(7, 1, 0.0)
        rig.run(1.0)
    assert rig.host.service(Slow).begun == 1
    rig.host.service(Slow).ended(True)
    assert rig.sent() == [(A, CommandEvent(1, SUCCESSFUL))]


def test_repeated_request_does_not_restart_an_ended_command(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, Resume())
    before = len(drive.efforts)
    request = command(SetWrenchEffort(propulsive_linear_effort_x=50.0))
    for _ in range(3):
        answers = robot.tell(A, request)
        assert answers == [(A, ConfirmEventRequest(7, 1, 0.0)), (A, CommandEvent(1, SUCCESSFUL))]
        robot.run(0.9)
    assert len(drive.efforts) == before + 1
    robot.tell(A, RequestControl(100))
    robot.run(3.0)
    robot.tell(A, request)
    assert len(drive.efforts) == before + 2, "so late it is another one"


def test_equal_request_after_the_confirmation_is_a_new_one(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, Resume())
    before = len(drive.efforts)
    for count in (1, 2):
        robot.host.receive(command(SetWrenchEffort(propulsive_linear_effort_x=50.0)).encode(), robot.ID.parse(A), 0.0)
        sent = robot.host.poll_output(0.0)
        assert [each.on_acknowledged is not None for each in sent] == [True, True], "both are to be acknowledged"
        for each in sent:
            each.on_acknowledged(True)
        assert len(drive.efforts) == before + count


def test_remembered_completed_commands_are_bounded(robot, drive) -> None:
    robot.tell(A, RequestControl(100))
    robot.tell(A, Resume())
    for number in range(100):
        effort = SetWrenchEffort(propulsive_linear_effort_x=number / 2)
        assert len(robot.tell(A, command(effort, request=number))) == 2
    assert len(robot.host.service(Events).completed) == 64


def test_cancelling_ends_the_event_and_not_the_command(rig) -> None:
    rig.ask(A, command(SET_TIME))
    assert rig.tell(B, CancelEvent(9, 1)) == [(B, RejectEventRequest(9, 6))]
    assert rig.ask(A, UpdateEvent(9, 0, 1.0, 1, QueryStatus())) == RejectEventRequest(9, 6)
    assert rig.ask(A, CancelEvent(9, 1)) == ConfirmEventRequest(9, 1, 0.0)
    rig.host.service(Slow).ended(True)
    assert rig.run(60.0) == []


def test_command_events_count_as_events_without_reports(rig) -> None:
    rig.ask(A, command(SET_TIME))
    assert rig.ask(A, QueryEvents(AllEventsRec(0))).event_list == []
    rig.ask(A, CreateEvent(1, 1, 0.0, QueryStatus()))
    assert rig.ask(A, command(Standby())) == RejectEventRequest(7, 3)
    rig.ask(B, CreateEvent(1, 1, 0.0, QueryStatus()))
    assert rig.ask(B, command(Standby())) == RejectEventRequest(7, 3)


@pytest.mark.parametrize(
    "message",
    [
        QueryStatus(),
        SetWrenchEffort(propulsive_linear_effort_x=50.0),
        CreateEvent(1, 0, 1.0, QueryStatus()),
        command(ClearEmergency(1)),
        b"\xff\xff",
        b"\x05\x00\x00",
    ],
    ids=["query", "of no service here", "event", "command event", "unknown", "undecodable"],
)
def test_unknown_command_is_rejected(rig, message) -> None:
    assert rig.ask(A, command(message)) == RejectEventRequest(7, 5)


def test_unreachable_client_is_not_notified(rig) -> None:
    rig.ask(A, command(SET_TIME))
    rig.host.unreachable(rig.ID.parse(A), rig.now)
    rig.sent()
    rig.host.service(Slow).ended(True)
    assert rig.run(60.0) == []
