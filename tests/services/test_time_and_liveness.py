from __future__ import annotations

from datetime import UTC, datetime

import pytest

from jauspy.messages.core import (
    DateStamp,
    QueryHeartbeatPulse,
    QueryTime,
    ReportHeartbeatPulse,
    ReportTime,
    RequestControl,
    SetTime,
    TimeStamp,
)
from jauspy.messages.mobility import QueryLocalPose, QueryLocalPoseExt, QueryVelocityState, QueryVelocityStateExt
from jauspy.services.core import Liveness

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
