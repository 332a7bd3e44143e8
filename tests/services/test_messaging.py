"""Reports of events are made without the machine that sends where nothing depends on it: nobody can tell."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings, strategies as st
from tests.helpers.robot import FakeDrive
from tests.services.conftest import Rig

from jauspy.errors import EncodeError
from jauspy.geometry.poses import Pose, Twist
from jauspy.messages.core import (
    CancelEvent,
    ClearEmergency,
    CreateEvent,
    Event,
    QueryAuthority,
    QueryControl,
    QueryEventTimeout,
    QueryHeartbeatPulse,
    QueryStatus,
    QueryTime,
    QueryTimeout,
    ReleaseControl,
    ReportHeartbeatPulse,
    ReportTimeout,
    RequestControl,
    Reset,
    Resume,
    SetEmergency,
    SetTime,
    Shutdown,
    Standby,
    TimeStamp,
    UpdateEvent,
)
from jauspy.messages.mobility import QueryLocalPose, QueryVelocityState, QueryWrenchEffort, SetWrenchEffort
from jauspy.services.core import AccessControl, Events, Liveness, Management, Time
from jauspy.services.mobility import LocalPoseSensor, PrimitiveDriver, Vehicle, VelocityStateSensor
from jauspy.services.state_machine import MachineInstance

CLIENTS = ("42.1.1", "42.2.1")
STRANGER = "7.1.1"


class Endless(ReportHeartbeatPulse):
    """A report that cannot be encoded."""

    def encode(self, **_: Any) -> bytes:
        raise EncodeError("too long")


class Moody(Liveness):
    """A heartbeat that does what report methods may do, good and bad."""

    mood = "well"

    def report_heartbeat_pulse(self, source: Any) -> Any:
        match self.mood:
            case "bug":
                raise RuntimeError(self.mood)
            case "silent":
                return None
            case "no message":
                return 1
            case "unencodable":
                return Endless()
            case "chatty":
                self.host.send(source, ReportTimeout(timeout=1))
            case "chatty with a bug":
                self.host.send(source, ReportTimeout(timeout=2))
                raise RuntimeError(self.mood)
            case "tells somebody else":
                self.host.send(self.host.id.parse(STRANGER), ReportTimeout(timeout=3))
            case "asks":
                _, inner = self.host.ask(QueryStatus(), source)
                assert inner is not None
        return ReportHeartbeatPulse()


MOODS = (
    *("well", "bug", "silent", "no message", "unencodable"),
    *("chatty", "chatty with a bug", "tells somebody else", "asks"),
)

queries = st.sampled_from(
    [
        *(QueryTime(vector) for vector in range(4)),
        *(QueryLocalPose(vector) for vector in (0, 0b11, 0xFFFF)),
        *(QueryVelocityState(vector) for vector in (1, 0b100_0011)),
        *(
            QueryStatus(),
            QueryControl(),
            QueryAuthority(),
            QueryTimeout(),
            QueryEventTimeout(),
            QueryWrenchEffort(0xFFFF),
        ),
        *(QueryHeartbeatPulse(),) * 4,
    ]
)
rates = st.sampled_from([0.0, 0.5, 5.0])
kinds, numbers = st.integers(0, 3), st.integers(0, 6)
commands = st.one_of(
    st.builds(CreateEvent, st.just(1), kinds, rates, queries),
    st.builds(CreateEvent, st.just(1), kinds, rates, queries),
    st.builds(UpdateEvent, st.just(2), kinds, rates, numbers, queries),
    st.builds(CancelEvent, st.just(3), numbers),
    st.builds(RequestControl, st.integers(0, 255)),
    st.builds(SetWrenchEffort, propulsive_linear_effort_x=st.sampled_from([-50.0, 0.0, 80.0])),
    st.sampled_from([ReleaseControl(), Resume(), Standby(), Reset(), Shutdown(), SetEmergency(1), ClearEmergency(1)]),
    st.just(SetTime(TimeStamp(1, 2, 3, 4, 5), None)),
    queries,
)
reported = st.tuples(st.just("tell"), st.sampled_from(CLIENTS), commands)
steps = st.one_of(
    *(reported,) * 3,
    st.tuples(st.just("run"), st.sampled_from([0.01, 0.3, 1.1]), st.none()),
    st.tuples(st.just("mood"), st.sampled_from(MOODS), st.none()),
    st.tuples(st.just("move"), st.floats(-5, 5), st.none()),
    st.tuples(st.just("lose"), st.sampled_from(CLIENTS), st.none()),
)


class Life:
    """One component, and all that it said so far."""

    def __init__(self, failing: str) -> None:
        self.drive, self.moody = FakeDrive(), Moody()
        vehicle = Vehicle(self.drive)
        services = (PrimitiveDriver(vehicle), LocalPoseSensor(vehicle), VelocityStateSensor(vehicle), self.moody)
        core = (Management(), AccessControl(timeout=2), Time(), Events(more_kinds=True))
        self.rig = Rig(*services, *core, on_action_error=failing)
        self.said: list[Any] = []

    def do(self, what: str, value: Any, message: Any) -> None:
        rig = self.rig
        if what == "tell":
            self.said += rig.tell(value, message.encode(strict=False))  # other kinds of event have no names
        elif what == "run":
            self.said += rig.run(value)
        elif what == "mood":
            self.moody.mood = value
            self.said += rig.run(0.3)
        elif what == "move":
            self.drive.present_pose, self.drive.present_twist = Pose(x=value), Twist(vx=value)
        else:
            rig.host.unreachable(rig.ID.parse(value), rig.now)
            self.said += rig.sent()
        self.said.append((what, rig.host.state, rig.host.next_timeout(), dict(rig.host.counters)))


@pytest.mark.slow
@settings(deadline=None, max_examples=100)
@given(st.lists(steps, min_size=5, max_size=30), st.sampled_from(["stay", "failure"]))
def test_events_are_equal_with_and_without_the_fast_path(script, failing) -> None:
    short, plain = Life(failing), Life(failing)
    beats = [("tell", CLIENTS[0], CreateEvent(1, kind, 5.0, QueryHeartbeatPulse())) for kind in (0, 1)]
    for step in (*beats, *script):
        short.do(*step)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(MachineInstance, "sole_action", lambda *_: None)
            plain.do(*step)
        assert short.said == plain.said


def test_most_queries_use_the_fast_path(monkeypatch) -> None:
    life = Life("stay")
    monkeypatch.setattr(MachineInstance, "ask", lambda *_: pytest.fail("the whole way"))
    for query in (QueryStatus(), QueryLocalPose(0b11), QueryVelocityState(1), QueryTime(3)):
        life.do("tell", CLIENTS[0], CreateEvent(1, 0, 1.0, query))
    life.do("run", 0.01, None)
    assert sum(isinstance(message, Event) for *_, message in life.said) == 4
